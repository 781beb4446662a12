/* Bodies of the law N&G (64) that loads on their faces strain homogeneously.
 *
 * F = diag(l_r, l_z, l_r) (rr, zz, tt) is the same everywhere, with the Cauchy stresses
 *
 *     sigma_i = K/2 (J - 1/J) + G J^(-5/3) (l_i^2 - (2 l_r^2 + l_z^2)/3),   J = l_r^2 l_z,
 *
 * which are (l_i/J) dW/dl_i. Two loads fix both stretches:
 *
 *   end load     sides free, sigma_rr = 0, and sigma_zz l_r^k = T: a traction T on the deformed
 *                end (k = 0), on an end whose elements keep their width, dA = r dr_0 (k = 1: the
 *                edges of uGIMP, N&G (45), (47)), a force T A_0 (k = 2)
 *   rim load     l_z = 1 is held, and sigma_rr = T
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HOMOGENEOUS_LOAD_H
#define VERIFICATION_EXACT_HOMOGENEOUS_LOAD_H

#include "verification/exact/plastic/compression.h"

#include <stdbool.h>

struct homogeneous_state {
    double radial, axial;             /* stretches l_r, l_z */
    struct compression_stress stress; /* Cauchy */
};

/* Solved by Brent's method to 1e-13 in stretches between 0.2 and 5; false if there is no solution
 * in that range. `power` is k. Cost: some 0.1 ms. */
bool homogeneous_end_load(const struct compression_material *material, double traction,
                          double power, struct homogeneous_state *state);
bool homogeneous_rim_load(const struct compression_material *material, double traction,
                          struct homogeneous_state *state);

#endif
