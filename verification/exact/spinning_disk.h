/* What a time step makes of a rigid rotation: why a free spinning disk grows in case E4.
 *
 * A vector of the plane is a complex number, a rotation with dilation of the plane a complex
 * factor. Let a body spin by the angle theta each step, stress-free, and let its nodes' velocity at
 * the places x of the start of a step be v dt = alpha x: alpha_1 at the start, and, as
 * velocities turn with the body, alpha_2 = exp(i theta) alpha_1 at the end of the step. Then
 *
 *     F    is multiplied by  e_n(alpha_2)                       USL, MUSL
 *                            e_n(alpha_1)                       USF
 *                            e_n(alpha_1/2) e_n(alpha_2/2)      USAVG,   e_n(a) = sum_{k<=n} a^k/k!
 *     x    is multiplied by  1 + alpha_2                        position_update: grid_velocity
 *                            1 + (alpha_1 + alpha_2)/2          position_update: midpoint
 *
 * The body is free: it changes its size until F holds no strain, |F factor| = 1, while its
 * positions turn by theta. Both fix alpha_1, and with it the growth |x factor| that no stress
 * resists, since F does not know of it. To leading order it is c theta^2/2 a step, pi c theta a
 * turn:
 *
 *                 n = 1                        n >= 2
 *     USL, MUSL   0   (midpoint  1)            1   (midpoint 2)
 *     USF        -2   (midpoint -1)           -1   (midpoint 0)
 *     USAVG      -1/2 (midpoint  1/2)          0   (midpoint 1)
 *
 * One term with USL or MUSL and x += dt sum S v is exact: both factors are 1 + alpha_2. Own
 * derivation; the series is N&G (9).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_SPINNING_DISK_H
#define VERIFICATION_EXACT_SPINNING_DISK_H

#include <stdbool.h>

enum spinning_disk_order { SPINNING_DISK_USL, SPINNING_DISK_USF, SPINNING_DISK_USAVG };

struct spinning_disk {
    enum spinning_disk_order order; /* MUSL is as USL */
    bool midpoint;                  /* position_update */
    unsigned terms;                 /* n >= 1 */
};

/* Logarithm of the growth of the radius in a step that turns by theta, 0 < theta <= 0.2, by
 * Newton's method on alpha_1. */
double spinning_disk_growth(const struct spinning_disk *disk, double theta);

#endif
