/* Uniform radial compression of a neo-Hookean disk held in z: N&G (63)-(67).
 *
 * The deformation gradient diag(1 + e, 1, 1 + e) (rr, zz, tt) is the same everywhere,
 * so relative volume and stress are functions of the radial strain e = -dR/R0 alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_COMPRESSION_H
#define VERIFICATION_EXACT_COMPRESSION_H

/* Moduli of the law (64), in the unit of stress; both > 0. */
struct compression_material {
    double bulk;  /* K */
    double shear; /* G, printed G_1 in N&G (66), (67) */
};

/* The non-zero components of the Cauchy stress, in the unit of the moduli. */
struct compression_stress {
    double rr, zz, tt;
};

/* J = (1 + e)^2, N&G (63); e > -1. */
double compression_relative_volume(double radial_strain);

/* e = sqrt(J) - 1, the inverse of the above; J > 0. */
double compression_radial_strain(double relative_volume);

/* Energy per initial volume, N&G (64), (65), for principal stretches rr, zz, tt > 0; in
 * the unit of the moduli. */
double compression_energy(const struct compression_material *material, const double stretch[3]);

/* Exact stress at relative volume J > 0, N&G (66), (67). Its rr is dW/dJ along the
 * compression and every component is (stretch/J) dW/d(stretch) of compression_energy. */
struct compression_stress compression_stress(const struct compression_material *material,
                                             double relative_volume);

#endif
