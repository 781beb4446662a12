/* Statistics of one component of a measured field.
 *
 * Every function reads `count` values at values[0], values[stride], ..., so that one
 * component of a particle-major field needs no copy. Nothing is filtered: a NaN among
 * the values gives a NaN, and so does an empty set, because a check must turn red when
 * what it measures is missing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_FIELDS_H
#define VERIFICATION_MEASURES_FIELDS_H

#include <stddef.h>

/* Arithmetic mean, in the unit of the values. Cost: one pass. */
double field_mean(const double *values, size_t stride, size_t count);

/* Standard deviation of the whole set: sqrt(sum (v - mean)^2 / count), in the unit of
 * the values; 0 for one value. Cost: two passes. */
double field_standard_deviation(const double *values, size_t stride, size_t count);

/* Standard deviation over |mean|, without unit; infinite or NaN if the mean is zero. */
double field_relative_deviation(const double *values, size_t stride, size_t count);

/* max |v - expected| / |expected|, without unit; infinite or NaN if `expected` is zero. */
double field_relative_maximum(const double *values, size_t stride, size_t count, double expected);

/* max |v|, in the unit of the values. */
double field_maximum(const double *values, size_t stride, size_t count);

/* The larger of two, or NaN if either is: a running maximum that keeps a NaN. */
double field_larger(double a, double b);

#endif
