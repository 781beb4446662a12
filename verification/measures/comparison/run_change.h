/* What it means that a check, a value or a time changed between two runs. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_RUN_CHANGE_H
#define VERIFICATION_MEASURES_RUN_CHANGE_H

#include "verification/measures/verdict.h"

#include <stddef.h>

enum run_change { RUN_SAME, RUN_BETTER, RUN_WORSE, RUN_OTHER /* neither better nor worse */ };

/* By how good a status is: pass, expected-fail, skip, then all red ones alike. */
enum run_change run_change_status(enum verdict_status before, enum verdict_status after);

/* Relative to the larger of the two: 0 .. 2; infinite if just one is not finite. */
double run_change_relative(double before, double after);

/* A check nearer to an end of its band by more than this part of half its width is worse. */
#define RUN_CHANGE_MARGIN 0.1
enum run_change run_change_margin(double before, double after);

/* Times of the same programs in two runs, one each: the median of after / before, and the
 * factor (>= 1.5) around it that counts as noise: three times the deviation of a normal
 * distribution with the median deviation of the logarithms. `work` has room for `count`.
 * Fewer than five times do not determine noise: middle 1, factor 2. */
struct run_noise {
    double middle, factor;
};
struct run_noise run_change_noise(const double *before, const double *after, size_t count,
                                  double *work);

/* Whether a time lies outside the noise. */
enum run_change run_change_time(const struct run_noise *noise, double before, double after);

#endif
