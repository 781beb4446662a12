/* What a study measures of a run: names of quantities, and how a number is taken from them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_QUANTITIES_H
#define VERIFICATION_MEASURES_QUANTITIES_H

#include "mpm.h"

/* A component of a field of the particles. */
struct field_quantity {
    const char *name; /* "stress_xx" */
    enum mpm_field field;
    unsigned component;
    bool displacement; /* the field less its value at t = 0 */
};

/* NULL: no field has the name, so that it is a column of history.csv. */
const struct field_quantity *field_quantity_find(const char *name);
/* All names, "displacement_x, ..."; a text of the library. */
const char *field_quantity_names(void);

/* The last three are norms of the error: they need a reference, and are errors already. */
enum take { TAKE_LAST, TAKE_MAX, TAKE_MIN, TAKE_MEAN, TAKE_AT, TAKE_L1, TAKE_L2, TAKE_LINF };
enum { TAKE_COUNT = TAKE_LINF + 1 };
const char *take_name(enum take take);
bool take_find(const char *name, enum take *take);
const char *take_names(void);
bool take_is_norm(enum take take);

/* A curve over time, piecewise linear: count >= 1 times that do not fall, and values. NaN where a
 * value is, or outside of the times. */
double curve_at(size_t count, const double *time, const double *values, double at);

/* max, min, mean, l1, l2 and linf of a curve; the mean is that of the piecewise linear curve; l1
 * and l2 are mean and root mean square over time by the trapezoidal rule of the values, which are
 * errors. One row: its value. */
double curve_take(enum take take, size_t count, const double *time, const double *values);

/* The value of a field at a place: a plane through the six nearest particles by least squares,
 * second order in their distance. `places`: 2 a particle. Particles of weight 0 are passed over.
 * NaN: fewer than six, all six on a line, or the place is further from all six than they are apart,
 * so outside. */
double plane_at(size_t count, const double *places, const double *weight, const double *values,
                const double at[2]);

#endif
