/* Headroom: how many times the deviation of a value fits into its band. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_HEADROOM_H
#define VERIFICATION_MEASURES_HEADROOM_H

#include "verification/measures/verdict.h"

/* Below the first a check may turn red for reasons that are none (another compiler, another
 * machine); above the second it would not notice a fault that makes its error a hundred times as
 * large. */
#define HEADROOM_LEAST 1.5
#define HEADROOM_MOST  100.0

/* Room from the expected value to the end of the band on the value's side, over the value's
 * distance from the expected one: 1 on the end, below 1 outside, infinite where the value is the
 * expected one. In a band of a decade or more (an error, above zero): its far end over the value,
 * by which the error may grow; or the value over the near end, where that is below HEADROOM_LEAST.
 * Of a known weakness, whose expected value is another band's: 1 / (1 - margin), half
 * the width of its band over the distance from its middle, in logarithms where the margin is (see
 * verdict_margin). NaN for a value that is not finite. */
double headroom_of(const struct verdict_band *band, double value);

enum headroom { HEADROOM_FINE, HEADROOM_FLAKY, HEADROOM_SLACK, HEADROOM_EXACT, HEADROOM_UNKNOWN };

/* What a headroom means; EXACT: infinite, every value is the expected one. */
enum headroom headroom_judge(double headroom);

/* Spread of values between builds over half the width of the band. */
double headroom_spread(const struct verdict_band *band, double least, double largest);

#endif
