/* Stress intensities of a crack of length 2 a in the middle of a plate of 2 W by 2 H, under tension
 * sigma along y on its ends; the crack is at an angle to x, counter clockwise.
 *
 * In an infinite plate
 *     K_I = sigma sqrt(pi a) cos^2(angle),   K_II = sigma sqrt(pi a) sin(angle) cos(angle),
 * the same at both tips, K_II by the axes of williams_field.h: above 0 where the side on the left
 * of the way away from the crack is sheared forward ahead of the tip.
 *
 * In the plate: plane elasticity by boundary collocation. With z = x + iy in the axes of the crack,
 * N. I. Muskhelishvili (Some Basic Problems of the Mathematical Theory of Elasticity, Noordhoff
 * 1953, sec. 120) has
 *     s_xx + s_yy = 4 Re Phi(z),
 *     s_yy - i s_xy = Phi(z) + Omega(conj z) + (z - conj z) conj Phi'(z).
 * Free faces are Phi+ + Omega- = Phi- + Omega+ = 0 on the crack, so that Phi + Omega is odd across
 * it and Phi - Omega even:
 *     Phi = P/X + Q,   Omega = P/X - Q,   X = sqrt(z^2 - a^2),
 * with functions P and Q that have no singularity in the plate. The plate and its loads are the
 * same when turned by 180 degrees: P is odd and Q even in z, which also makes displacements
 * single-valued. Both are polynomials here, and their coefficients those with the least squares of
 * the tractions' errors on the edges. At the tips K_I - i K_II = 2 P(a) sqrt(pi/a). Equilibrium,
 * compatibility and free faces hold exactly, whatever the coefficients; the tractions' error that
 * is left on the edges (`residual`) bounds that of the stress intensities.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_SLANTED_CRACK_H
#define VERIFICATION_EXACT_SLANTED_CRACK_H

#include "verification/common/failure.h"

struct slanted_crack {
    double half_length;             /* a */
    double half_width, half_height; /* W along x, H along y; the crack is inside */
    double angle;                   /* from x to the crack, radians */
    double stress;                  /* sigma */
};

struct slanted_crack_intensity {
    double mode_1, mode_2; /* K_I, K_II: stress times root of length */
    double residual; /* largest error of a traction at the points of collocation, over sigma */
};

/* MPM_BAD_INPUT: the crack is not inside the plate. MPM_ENVIRONMENT_FAILED: no memory. Cost: some
 * ms. */
enum mpm_status slanted_crack_solve(const struct slanted_crack *crack,
                                    struct slanted_crack_intensity *intensity,
                                    struct mpm_error *error);

#endif
