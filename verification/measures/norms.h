/* Norms and observed orders that measuring programs share. Pure functions; none
 * allocates. A NaN in the input is a NaN in the result, never left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_NORMS_H
#define VERIFICATION_MEASURES_NORMS_H

#include <stddef.h>

/* Mean of `count` >= 1 values; NaN for none. */
double norm_mean(size_t count, const double *values);

/* Standard deviation (divisor count) over the magnitude of the mean; NaN if count is 0. */
double norm_relative_spread(size_t count, const double *values);

/* Largest |values[i] - exact[i]|; `exact` may be NULL for zeros. NaN for count 0. */
double norm_max_error(size_t count, const double *values, const double *exact);

/* Root mean square of values[i] - exact[i], weighted if `weights` is not NULL. */
double norm_rms_error(size_t count, const double *values, const double *exact,
                      const double *weights);

/* Observed order p of error = C h^p by least squares in logarithms over `count` >= 2
 * levels, h and error positive; NaN otherwise. */
double norm_fitted_order(size_t count, const double *h, const double *error);

/* Observed order of the last two levels. */
double norm_last_order(size_t count, const double *h, const double *error);

#endif
