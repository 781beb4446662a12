/* The exponential function, the same bits on every machine: sums, products and powers of two, where
 * a library's differs from processor to processor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_EXPONENTIAL_H
#define MPM_BASE_EXPONENTIAL_H

/* exp(x) for x from -700 to 700, to 4 units in the last place; 0 below. */
double mpm_exponential(double x);

#endif
