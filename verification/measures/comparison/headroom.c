/* Headroom of values in their bands.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/headroom.h"

#include <math.h>

double headroom_of(const struct verdict_band *band, double value)
{
    if (!isfinite(value))
        return (double)NAN;
    if (band->weakness)
        return 1 / (1 - verdict_margin(band->fails_low, band->fails_high, value));
    const double far = fmax(fabs(band->low), fabs(band->high));
    const double near = fmin(fabs(band->low), fabs(band->high));
    if (verdict_spans_decades(band->low, band->high) && value * band->low > 0) {
        const double least = fabs(value) / near;
        return least < HEADROOM_LEAST ? least : far / fabs(value);
    }
    const double deviation = value - band->expected;
    if (deviation == 0)
        return (double)INFINITY;
    return (deviation > 0 ? band->high - band->expected : band->expected - band->low) /
           fabs(deviation);
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
