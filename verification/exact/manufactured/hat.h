/* The grid's own function along one axis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HAT_H
#define VERIFICATION_EXACT_HAT_H

#include <math.h>

/* The hat of a node at distance `offset` cells, and its slope; N&G (18). */
static inline double hat(double offset)
{
    return fmax(0, 1 - fabs(offset));
}

static inline double hat_slope(double offset)
{
    if (fabs(offset) >= 1) {
        return 0;
    }
    return offset < 0 ? 1 : -1;
}

#endif
