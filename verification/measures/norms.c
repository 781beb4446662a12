/* Norms and statistics of measured fields; see norms.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/norms.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

double norm_mean(const double *values, size_t stride, size_t count)
{
    return count == 0 ? (double)NAN : gsl_stats_mean(values, stride, count);
}

double norm_standard_deviation(const double *values, size_t stride, size_t count)
{
    if (count == 0) {
        return (double)NAN;
    }
    return gsl_stats_sd_with_fixed_mean(values, stride, count, norm_mean(values, stride, count));
}

double norm_relative_deviation(const double *values, size_t stride, size_t count)
{
    return norm_standard_deviation(values, stride, count) / fabs(norm_mean(values, stride, count));
}

double norm_relative_maximum(const double *values, size_t stride, size_t count, double expected)
{
    double largest = count == 0 ? (double)NAN : 0;
    for (size_t i = 0; i < count; i++) {
        largest = norm_larger(largest, fabs(values[i * stride] - expected) / fabs(expected));
    }
    return largest;
}

double norm_maximum(const double *values, size_t stride, size_t count)
{
    double largest = count == 0 ? (double)NAN : 0;
    for (size_t i = 0; i < count; i++) {
        largest = norm_larger(largest, fabs(values[i * stride]));
    }
    return largest;
}

double norm_larger(double a, double b)
{
    if (isnan(a)) {
        return a;
    }
    return b <= a ? a : b; /* a NaN in b compares false and is taken */
}
