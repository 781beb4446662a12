/* Observed orders of convergence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/orders.h"

#include <math.h>
#include <stdbool.h>

static bool levels_are_positive(size_t count, const double *h, const double *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(h[i] > 0) || !(error[i] > 0))
            return false;
    return count >= 2;
}

double order_fitted(size_t count, const double *h, const double *error)
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

double order_last(size_t count, const double *h, const double *error)
{
    if (count < 2)
        return (double)NAN;
    return order_fitted(2, h + count - 2, error + count - 2);
}
