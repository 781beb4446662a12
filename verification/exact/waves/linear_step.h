/* Linear stability of the step in one dimension: what Courant numbers a small motion of a
 * uniform row of particles stays bounded for.
 *
 * A row of `particles` particles to a cell, equally spaced, of one material (density 1, modulus 1
 * and cell size 1, so that waves have speed 1 and the time step is the Courant number C), is
 * displaced by `offset` cells against the grid. Small motions leave the shape functions where
 * they are, and a wave exp(i theta x) couples the particles of one cell only:
 *
 *     S_p = sum_i S(x_p - i) exp(i theta i),   G_p likewise,
 *     v = sum_p conj(S_p) v_p / n              velocity of node 0 (its mass is 1),
 *     a = -sum_p conj(G_p) e_p / n             its acceleration (stress = strain e_p),
 *     v_p += C S_p a,                          FLIP, CRAMP (30)
 *     e_p += k C G_p w                         w: v before, v + C a, or v extrapolated again,
 *
 * with k and w as the order of the stress update has them, CRAMP (29), (31), (35). One step is
 * a complex matrix of size 2n, its eigenvalues are found by GSL; the step is stable if none lies
 * outside the unit circle for any theta. The method's own code has no part in it. For one
 * particle in the middle of each cell and MUSL the limit is 2: cos(theta/2) weakens the wave that
 * sin(theta/2) drives (the same family of results as in Ni and Zhang 2020, Comput. Mech. 66).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_LINEAR_STEP_H
#define VERIFICATION_EXACT_LINEAR_STEP_H

#include <stdbool.h>
#include <stddef.h>

enum linear_shape { LINEAR_CLASSIC, LINEAR_UGIMP, LINEAR_BSPLINE2, LINEAR_BSPLINE3 };
enum linear_order { LINEAR_USL, LINEAR_MUSL, LINEAR_USF, LINEAR_USAVG };

enum { LINEAR_PARTICLES_MAX = 4 };

struct linear_row {
    enum linear_shape shape; /* CPDI is uGIMP as long as the strain is small */
    enum linear_order order;
    size_t particles; /* to a cell, 1 to LINEAR_PARTICLES_MAX */
    double offset;    /* in cells, of the lattice (k + 1/2)/n */
};

/* Largest modulus of an eigenvalue of the step for wave number theta, 0 < theta <= pi, and
 * Courant number C > 0; NaN if GSL fails. */
double linear_step_growth(const struct linear_row *row, double courant, double theta);

/* The largest C, to 1e-4 of it, up to which growth <= 1 for the waves theta = pi k / cells,
 * k = 1 to cells - 1, that a bar of that many cells held at both ends has (cells >= 2; many
 * represent an infinite row); 0 if there is none above 0.01, infinite if there is none below 10.
 * Eigenvalues that meet on the unit circle are known to half the digits only, so that growth
 * counts from 1e-6 on. Cost: about 0.1 ms times cells. */
double linear_step_limit(const struct linear_row *row, int cells);

#endif
