/* Headroom of values in their bands.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/headroom.h"

#include <math.h>

double headroom_of(const struct verdict_band *band, double value)
{
    if (!isfinite(value))
        return (double)NAN;
    const double low = band->weakness ? band->fails_low : band->low;
    const double high = band->weakness ? band->fails_high : band->high;
    const double centre = band->weakness ? 0.5 * (low + high) : band->expected;
    const double deviation = value - centre;
    if (deviation == 0)
        return (double)INFINITY;
    return (deviation > 0 ? high - centre : centre - low) / fabs(deviation);
}

enum headroom headroom_judge(double headroom)
{
    if (isnan(headroom))
        return HEADROOM_UNKNOWN;
    if (isinf(headroom))
        return HEADROOM_EXACT;
    return headroom < HEADROOM_LEAST  ? HEADROOM_FLAKY
           : headroom > HEADROOM_MOST ? HEADROOM_SLACK
                                      : HEADROOM_FINE;
}

double headroom_spread(const struct verdict_band *band, double least, double largest)
{
    const double low = band->weakness ? band->fails_low : band->low;
    const double high = band->weakness ? band->fails_high : band->high;
    return (largest - least) / (0.5 * (high - low));
}
