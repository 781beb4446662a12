/* Observed orders of convergence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/orders.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdbool.h>

static bool levels_are_positive(size_t count, const double *h, const double *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(h[i] > 0) || !(error[i] > 0) || !isfinite(h[i]) || !isfinite(error[i]))
            return false;
    return count >= 2;
}

/* Sums about the means of x = ln h and y = ln error. */
struct sums {
    double mean_x, mean_y, xx, xy, yy;
};

static struct sums sum_logarithms(size_t count, const double *h, const double *error)
{
    struct sums s = {0};
    for (size_t i = 0; i < count; i++) {
        s.mean_x += log(h[i]) / (double)count;
        s.mean_y += log(error[i]) / (double)count;
    }
    for (size_t i = 0; i < count; i++) {
        const double x = log(h[i]) - s.mean_x, y = log(error[i]) - s.mean_y;
        s.xx += x * x;
        s.xy += x * y;
        s.yy += y * y;
    }
    return s;
}

struct order_fit order_fit(size_t count, const double *h, const double *error, double confidence)
{
    struct order_fit fit = {(double)NAN, (double)NAN, (double)NAN};
    if (!levels_are_positive(count, h, error))
        return fit;
    const struct sums s = sum_logarithms(count, h, error);
    if (!(s.xx > 0))
        return fit;
    fit.order = s.xy / s.xx;
    fit.constant = exp(s.mean_y - fit.order * s.mean_x);
    if (count > 2 && confidence > 0 && confidence < 1) {
        const double freedom = (double)(count - 2);
        const double left = fmax(0, s.yy - fit.order * s.xy);
        fit.half_width =
            gsl_cdf_tdist_Pinv(0.5 * (1 + confidence), freedom) * sqrt(left / (freedom * s.xx));
    }
    return fit;
}

double order_fitted(size_t count, const double *h, const double *error)
{
    return order_fit(count, h, error, 0.95).order;
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
