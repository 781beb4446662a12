/* Norms and observed orders.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/norms.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdbool.h>

double norm_mean(size_t count, const double *values)
{
    return count == 0 ? (double)NAN : gsl_stats_mean(values, 1, count);
}

double norm_relative_spread(size_t count, const double *values)
{
    if (count == 0)
        return (double)NAN;
    const double mean = gsl_stats_mean(values, 1, count);
    return gsl_stats_sd_with_fixed_mean(values, 1, count, mean) / fabs(mean);
}

double norm_max_error(size_t count, const double *values, const double *exact)
{
    double largest = count == 0 ? (double)NAN : 0;
    for (size_t i = 0; i < count; i++) {
        const double error = fabs(values[i] - (exact == NULL ? 0 : exact[i]));
        /* fmax would drop a NaN */
        if (isnan(error))
            return (double)NAN;
        largest = fmax(largest, error);
    }
    return largest;
}

double norm_rms_error(size_t count, const double *values, const double *exact,
                      const double *weights)
{
    double sum = 0, total = 0;
    for (size_t i = 0; i < count; i++) {
        const double error = values[i] - (exact == NULL ? 0 : exact[i]);
        const double weight = weights == NULL ? 1 : weights[i];
        sum += weight * error * error;
        total += weight;
    }
    return sqrt(sum / total);
}

static bool levels_are_positive(size_t count, const double *h, const double *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(h[i] > 0) || !(error[i] > 0))
            return false;
    return count >= 2;
}

double norm_fitted_order(size_t count, const double *h, const double *error)
{
    if (!levels_are_positive(count, h, error))
        return (double)NAN;
    double mean_x = 0, mean_y = 0;
    for (size_t i = 0; i < count; i++) {
        mean_x += log(h[i]) / (double)count;
        mean_y += log(error[i]) / (double)count;
    }
    double covariance = 0, variance = 0;
    for (size_t i = 0; i < count; i++) {
        covariance += (log(h[i]) - mean_x) * (log(error[i]) - mean_y);
        variance += (log(h[i]) - mean_x) * (log(h[i]) - mean_x);
    }
    return covariance / variance;
}

double norm_last_order(size_t count, const double *h, const double *error)
{
    if (count < 2)
        return (double)NAN;
    return norm_fitted_order(2, h + count - 2, error + count - 2);
}
