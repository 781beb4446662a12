/* A long strip whose edges are held at displacements of -+delta, with a crack along its middle:
 * case D10.
 *
 * Ahead of the tip the strain across the strip is delta/h, h half of its height, and sideways none,
 * since the edges are held there too; behind it nothing is stretched. A crack that grows by da
 * takes the energy of as much strip, both halves (J. R. Rice, J. Appl. Mech. 35 (1968) 379-386):
 *
 *     J = M delta^2 / h,   M = lambda + 2 G,
 *
 * whatever its length. Where delta falls along the strip, delta = rate t (1 - g (x - x_0)), x_0 the
 * place of the first tip, a crack of the toughness J_c has grown by
 *
 *     a = (1 - d/(rate t)) / g,   d = sqrt(J_c h/M),
 *
 * as long as inertia has no part, but for a constant length: in J there is a term g h delta^2/h
 * besides, with a factor that depends on the field of the tip, which shifts the crack as a whole,
 * and one in (g h)^2, which changes da/d(1/t) by as much.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_CLAMPED_STRIP_H
#define VERIFICATION_EXACT_CLAMPED_STRIP_H

struct clamped_strip {
    double modulus, height; /* M, h */
    double toughness;       /* J_c, energy per area */
    double rate, gradient;  /* of delta at the first tip; g, 1/length; 0: the same everywhere */
    double tip;             /* x_0 */
};

/* M delta^2/h at a place and time. */
double clamped_strip_release(const struct clamped_strip *strip, double place, double time);

/* a; 0 before the first growth, infinite without a gradient after it. */
double clamped_strip_growth(const struct clamped_strip *strip, double time);

#endif
