/* The root of a function of one variable between two places.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_ROOT_H
#define VERIFICATION_EXACT_ROOT_H

/* By GSL's Brent solver, to the relative `tolerance` (1e-14 is about what there is). NaN if the
 * function has the same sign at both ends, is not a number, or the root takes more than 200
 * rounds. The function may find roots itself; GSL's own handler of errors is off meanwhile. */
double root_between(double (*function)(double, void *), void *context, double low, double high,
                    double tolerance);

#endif
