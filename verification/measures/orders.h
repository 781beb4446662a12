/* Observed orders of convergence and what a series of errors does. Pure functions; a NaN in the
 * input is a NaN in the result. Levels go from coarse to fine: h falls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_ORDERS_H
#define VERIFICATION_MEASURES_ORDERS_H

#include <stddef.h>

enum { ORDER_LEVELS_MAX = 64 };

/* error = constant h^order, by least squares in logarithms. */
struct order_fit {
    double order;
    double half_width; /* the order's interval of confidence is order -/+ half_width */
};

/* Over `count` levels, 2 to ORDER_LEVELS_MAX, h and error positive and finite, not all h the same;
 * NaN otherwise. The interval holds the slope with a probability of 95 % if logarithms scatter
 * normally: Student's t with count - 2 degrees of freedom. Two levels have no scatter: half_width
 * is NaN. Errors of a smooth series do not scatter but bend; then the interval states how far from
 * a straight line they are, and is wide with few levels (t = 4.3 with four). */
struct order_fit order_fit(size_t count, const double *h, const double *error);

/* The order of order_fit. */
double order_fitted(size_t count, const double *h, const double *error);

/* Observed order of level k and the one before, k = 1 .. count - 1. */
double order_pair(size_t k, const double *h, const double *error);

/* Observed order of the last two levels. */
double order_last(size_t count, const double *h, const double *error);

/* The constant C of error = C h^order for an order that theory gives: pins an error apart from
 * the order, in the unit of the error over that of h^order. */
double order_constant(double order, double h, double error);

/* What a series of errors does. Numbers are those that a measuring program reports. */
enum order_class {
    ORDER_UNDEFINED = 0,   /* fewer than three levels, or an error that is not positive */
    ORDER_ASYMPTOTIC = 1,  /* the last two pairs agree */
    ORDER_APPROACHING = 2, /* falls well, but the pairs do not agree yet */
    ORDER_PLATEAU = 3,     /* has lost its order: a floor that refinement does not lower */
    ORDER_OSCILLATORY = 4, /* falls and rises, or rises and falls */
    ORDER_DIVERGING = 5,   /* grows */
};
const char *order_class_name(enum order_class kind);

/* The rule, with the orders p of the pairs from coarse to fine; the first that holds:
 *   oscillatory  two pairs in a row have orders of opposite sign, both beyond 0.25
 *   diverging    the last p < -0.25 (the error grows by 19 % or more when h is halved)
 *   asymptotic   the last two p differ by at most 0.2, and the last is at least 0.4
 *   plateau      the last p is below 0.4 or below half of the largest
 *   approaching  what is left
 * An error whose sign changes between two levels passes near zero and shows as oscillatory. */
enum order_class order_classify(size_t count, const double *h, const double *error);

#endif
