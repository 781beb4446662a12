/* Frequency and decay of a sampled oscillation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_OSCILLATION_H
#define VERIFICATION_MEASURES_OSCILLATION_H

#include <stdbool.h>
#include <stddef.h>

struct oscillation {
    double frequency; /* omega, radians over the unit of time */
    double decay;     /* gamma, over the unit of time; below zero: growth */
    double amplitude; /* at t = 0 */
    double residual;  /* root mean square of what the fit leaves, over the amplitude */
    double bound;     /* of the frequency's error; see below */
};

/* Fits y(t) = exp(-gamma t) (a cos omega t + b sin omega t) to `count` samples by least squares
 * (Gauss-Newton). The samples are taken in windows that double, from one period of `guess` on,
 * each started from the last, so that the phase never slips: `guess` may be off by a tenth, over
 * any number of periods.
 *
 * `bound` is measured on the same samples: the larger of what the first and the second half
 * alone, fitted in the same way, differ from the whole. Noise, overtones and a frequency that
 * moves with the amplitude are all in it.
 *
 * Times must ascend, with four samples a period or more and at least two periods of them. False
 * if there are too few, or one is not finite, or the fit does not settle. Cost: some 30 passes. */
bool oscillation_fit(size_t count, const double *time, const double *value, double guess,
                     struct oscillation *fit);

#endif
