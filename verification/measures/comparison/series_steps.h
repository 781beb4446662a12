/* Steps in a series of numbers, one for each revision. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_SERIES_STEPS_H
#define VERIFICATION_MEASURES_SERIES_STEPS_H

#include <stddef.h>

/* A change counts as a step if it is more than SERIES_NOISES times the noise of the series, and
 * more than `least`. Changes are relative to the larger of the two numbers (run_change_relative());
 * numbers that are not finite are passed over. The noise is the median of the changes of the
 * series; with fewer than SERIES_CHANGES of them, or where none is known, it is 0, and `least`
 * decides. */
#define SERIES_NOISES  4.0
#define SERIES_CHANGES 4

/* What counts at least: of a check's value, and of a time or a rate of a machine. */
#define SERIES_LEAST_VALUE 1e-3
#define SERIES_LEAST_TIME  0.1

struct series_step {
    size_t from, to; /* places of the two numbers */
    double change;   /* relative, 0 .. 2 */
};

/* The median change of `count` numbers; `work` has room for that many. */
double series_noise(const double *values, size_t count, double *work);

/* Fills `steps`, with room for `count`, in the order of the series; how many there are. */
size_t series_steps(const double *values, size_t count, double noise, double least,
                    struct series_step *steps);

#endif
