/* A cylinder (plane strain) or a sphere of radius R in a matrix, with an imperfect interface
 * between them, the matrix's outer surface r = b being moved by u_b: exact solution of case C7.
 *
 * With d = 2 or 3 dimensions and symmetry about the middle, u = A r + B/r^(d-1) in each body.
 * Volume changes by d A; sigma_rr = d k A - 2 (d - 1) G B/r^d, where k is the modulus of equal
 * extension in d dimensions: K + G/3 in plane strain, K for a sphere. B = 0 in the inclusion, whose
 * stress is uniform, s = d k_i A_i. The interface bears it at a jump [u] = s/D, so that for the
 * matrix the inclusion is one without an interface whose modulus k_eq has s = d k_eq u(R)/R:
 *
 *     1/k_eq = 1/k_i + d/(D R).
 *
 * A R + B/R^(d-1) = u(R) and d k_m A - 2 (d - 1) G B/R^d = s give B = A R^d d (k_m - k_eq)/
 * (d k_eq + 2 (d - 1) G), and u_b gives A. Along the interface sigma_tt = d k_m A + 2 (d - 1) G
 * B/((d - 1) r^d). Lame's solutions (S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, sec. 28
 * and 136), own derivation of the interface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_INCLUSION_H
#define VERIFICATION_EXACT_INCLUSION_H

struct inclusion {
    int dimensions;           /* 2: cylinder, 3: sphere */
    double radius, outer;     /* 0 < R < b */
    double bulk[2], shear[2]; /* of the inclusion and of the matrix */
    double interface;         /* D > 0, stress over length; infinite: bonded */
    double displacement;      /* u_b */
};

struct inclusion_state {
    double u;      /* radial displacement */
    double rr, tt; /* stress */
};

/* Of equal extension: of the inclusion (0) or the matrix (1). */
double inclusion_modulus(const struct inclusion *inclusion, int body);

/* k_eq */
double inclusion_effective_modulus(const struct inclusion *inclusion);

/* At r >= 0; r = R is in the inclusion. */
struct inclusion_state inclusion_state(const struct inclusion *inclusion, double r);

#endif
