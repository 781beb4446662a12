/* Statistics of measured fields; see fields.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

double field_mean(const double *values, size_t stride, size_t count)
{
    return count == 0 ? (double)NAN : gsl_stats_mean(values, stride, count);
}

double field_standard_deviation(const double *values, size_t stride, size_t count)
{
    if (count == 0) {
        return (double)NAN;
    }
    return gsl_stats_sd_with_fixed_mean(values, stride, count, field_mean(values, stride, count));
}

double field_relative_deviation(const double *values, size_t stride, size_t count)
{
    return field_standard_deviation(values, stride, count) /
           fabs(field_mean(values, stride, count));
}

double field_relative_maximum(const double *values, size_t stride, size_t count, double expected)
{
    double largest = count == 0 ? (double)NAN : 0;
    for (size_t i = 0; i < count; i++) {
        largest = field_larger(largest, fabs(values[i * stride] - expected) / fabs(expected));
    }
    return largest;
}

double field_maximum(const double *values, size_t stride, size_t count)
{
    double largest = count == 0 ? (double)NAN : 0;
    for (size_t i = 0; i < count; i++) {
        largest = field_larger(largest, fabs(values[i * stride]));
    }
    return largest;
}

double field_larger(double a, double b)
{
    if (isnan(a)) {
        return a;
    }
    return b <= a ? a : b; /* a NaN in b compares false and is taken */
}
