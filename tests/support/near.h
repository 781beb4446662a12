/* Nearness of numbers, with the name of the tolerance in the message.
 *
 * Check's ck_assert_double_eq_tol takes NaN for a failure too, but does not report
 * how far off a value is and which tolerance it missed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_NEAR_H
#define TESTS_SUPPORT_NEAR_H

#include "support/marks.h"

#include <math.h>
#include <stdbool.h>

/* True if |value - expected| <= tolerance; false if any of them is NaN. */
static inline bool test_is_near(double value, double expected, double tolerance)
{
    return value == expected || fabs(value - expected) <= tolerance;
}

/* `tolerance` is absolute: scale it in the call, and name it. */
#define ck_assert_near(value, expected, tolerance)                                                 \
    do {                                                                                           \
        const double near_value_ = (value), near_expected_ = (expected),                           \
                     near_tolerance_ = (tolerance);                                                \
        ck_assert_msg(test_is_near(near_value_, near_expected_, near_tolerance_),                  \
                      "%s is %.17g, expected %.17g, off by %.3g, allowed %s = %.3g", #value,       \
                      near_value_, near_expected_, fabs(near_value_ - near_expected_), #tolerance, \
                      near_tolerance_);                                                            \
    } while (0)

#endif
