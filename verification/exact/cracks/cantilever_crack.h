/* Energy release rate of a double cantilever beam: two arms of height h, pulled apart by forces P
 * per thickness on their ends, a crack of length a between them, the uncracked part long.
 *
 * Beam theory with the rotation of the arms at the crack tip, as an effective length a + chi h
 * (J. G. Williams, Int. J. Fract. 36 (1988) 101-119; End corrections for orthotropic DCB specimens,
 * Compos. Sci. Technol. 35 (1989) 367-376):
 *     J = 12 P^2 (a + chi h)^2 / (E h^3),
 *     chi^2 = E/(11 G) [ 3 - 2 (Gamma/(1 + Gamma))^2 ],   Gamma = 1.18 E/G (isotropic),
 * E and G/E of plane stress, E/G = 2 (1 + nu); in plane strain with E/(1 - nu^2) and nu/(1 - nu).
 *
 * Plane elasticity (R. M. L. Foote, V. T. Buchwald, Int. J. Fract. 29 (1985) 125-134; a fit that
 * they give 1.1 % for, for every a/h):
 *     K_I = P/sqrt(h) { sqrt(12) (a/h + 0.673) + sqrt(2 h/(pi a))
 *                       - 1/[0.815 (a/h)^0.619 + 0.429] }.
 * From a/h = 5 on both agree within 1 % in K_I.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_CANTILEVER_CRACK_H
#define VERIFICATION_EXACT_CANTILEVER_CRACK_H

struct cantilever_crack {
    double length, height;   /* a, h */
    double force;            /* P */
    double modulus, poisson; /* in the plane */
};

/* chi */
double cantilever_crack_rotation(double poisson);
/* J by beam theory. */
double cantilever_crack_release(const struct cantilever_crack *crack);
/* K_I by plane elasticity. */
double cantilever_crack_intensity(const struct cantilever_crack *crack);

#endif
