/* Observed orders of convergence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/orders.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdbool.h>

static bool levels_are_positive(size_t count, const double *h, const double *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(h[i] > 0) || !(error[i] > 0) || !isfinite(h[i]) || !isfinite(error[i]))
            return false;
    return count >= 2;
}

struct order_fit order_fit(size_t count, const double *h, const double *error)
{
    static const double BELOW = 0.975; /* both ends of 95 % */
    double x[ORDER_LEVELS_MAX] = {0}, y[ORDER_LEVELS_MAX] = {0}, constant, variance[3], left;
    struct order_fit fit = {(double)NAN, (double)NAN};
    if (count > ORDER_LEVELS_MAX || !levels_are_positive(count, h, error))
        return fit;
    for (size_t i = 0; i < count; i++) {
        x[i] = log(h[i]);
        y[i] = log(error[i]);
    }
    gsl_fit_linear(x, 1, y, 1, count, &constant, &fit.order, &variance[0], &variance[1],
                   &variance[2], &left);
    if (count > 2)
        fit.half_width = gsl_cdf_tdist_Pinv(BELOW, (double)(count - 2)) * sqrt(variance[2]);
    return fit;
}

double order_fitted(size_t count, const double *h, const double *error)
{
    return order_fit(count, h, error).order;
}

double order_pair(size_t k, const double *h, const double *error)
{
    return k < 1 ? (double)NAN : order_fitted(2, h + k - 1, error + k - 1);
}

double order_last(size_t count, const double *h, const double *error)
{
    return count < 2 ? (double)NAN : order_pair(count - 1, h, error);
}

double order_constant(double order, double h, double error)
{
    return error / pow(h, order);
}

/* ----------------------------------------------------------------- classes */

static const double TURN = 0.25;    /* a pair of less than this order, either way, is level */
static const double AGREE = 0.2;    /* how near two pairs of one order are */
static const double SMALLEST = 0.4; /* below this there is no order: shocks have a half */

const char *order_class_name(enum order_class kind)
{
    static const char *const names[] = {
        [ORDER_UNDEFINED] = "undefined",     [ORDER_ASYMPTOTIC] = "asymptotic",
        [ORDER_APPROACHING] = "approaching", [ORDER_PLATEAU] = "plateau",
        [ORDER_OSCILLATORY] = "oscillatory", [ORDER_DIVERGING] = "diverging",
    };
    return names[kind];
}

static bool turns(double before, double after)
{
    return (before > TURN && after < -TURN) || (before < -TURN && after > TURN);
}

enum order_class order_classify(size_t count, const double *h, const double *error)
{
    if (count < 3 || !levels_are_positive(count, h, error))
        return ORDER_UNDEFINED;
    double largest = order_pair(1, h, error), before = largest, last = largest;
    bool turned = false;
    for (size_t k = 2; k < count; k++) {
        before = last;
        last = order_pair(k, h, error);
        largest = fmax(largest, last);
        turned = turned || turns(before, last);
    }
    if (turned)
        return ORDER_OSCILLATORY;
    if (last < -TURN)
        return ORDER_DIVERGING;
    if (fabs(last - before) <= AGREE && last >= SMALLEST)
        return ORDER_ASYMPTOTIC;
    return last < SMALLEST || last < 0.5 * largest ? ORDER_PLATEAU : ORDER_APPROACHING;
}
