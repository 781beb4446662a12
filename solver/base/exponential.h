/* Exponential function and logarithm, the same bits on every machine: sums, products and powers of
 * two, where a library's differ from processor to processor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_EXPONENTIAL_H
#define MPM_BASE_EXPONENTIAL_H

/* exp(x) for x from -700 to 700, to 4 units in the last place; 0 below, infinite above. */
double mpm_exponential(double x);

/* ln x for normal x > 0, to 4 units in the last place; not a number for any other x. */
double mpm_logarithm(double x);

#endif
