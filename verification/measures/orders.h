/* Observed orders of convergence. Pure functions; a NaN in the input is a NaN in the
 * result.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_ORDERS_H
#define VERIFICATION_MEASURES_ORDERS_H

#include <stddef.h>

/* Observed order p of error = C h^p by least squares in logarithms over `count` >= 2
 * levels, h and error positive; NaN otherwise. */
double order_fitted(size_t count, const double *h, const double *error);

/* Observed order of the last two levels. */
double order_last(size_t count, const double *h, const double *error);

#endif
