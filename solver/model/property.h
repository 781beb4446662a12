/* A property of a material that depends on its temperature, its concentration or, a yield stress,
 * on plastic strain: a table of points (T_i, v_i), linear between them, with T_0 < T_1 < ... and
 * all v_i > 0.
 *
 * Of temperatures: the table knows nothing of temperatures outside of it: a body that has one there
 * is refused at the start, and ends a run. The functions below continue the property there with the
 * value of the nearest point, so that the step that fails ends with finite numbers, and so that the
 * integral has a reference that all materials share: T = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_PROPERTY_H
#define MPM_MODEL_PROPERTY_H

#include <stdbool.h>
#include <stddef.h>

/* What has tables. */
enum mpm_table { MPM_TABLE_CAPACITY, MPM_TABLE_CONDUCTIVITY, MPM_TABLE_COUNT };

struct mpm_property {
    size_t count;        /* of points; 0: none, the property is a constant */
    double (*points)[2]; /* T_i and v_i */
    double *integral;    /* of the property from T = 0 to T_i */
};

/* Finds the integrals; the points and the room for the integrals are there. Cost: one look at each
 * point. */
void mpm_property_prepare(const struct mpm_property *property);

/* Is T_0 <= T <= T_(n-1)? Of a constant always; of T = NaN never, with a table. */
bool mpm_property_covers(const struct mpm_property *property, double temperature);

/* What follows is for tables. */

/* v(T). Cost: a search by halves. */
double mpm_property_value(const struct mpm_property *property, double temperature);

/* dv/dT; at a point that of what is above it. */
double mpm_property_slope(const struct mpm_property *property, double temperature);

/* Integral of v from 0 to T: of a capacity the enthalpy per mass. */
double mpm_property_integral(const struct mpm_property *property, double temperature);

/* The change d of temperature with integral(T + d) - integral(T) = content, of either sign: the
 * root of a quadratic equation between two points, v d + v' d^2 / 2 = content, from point to point.
 * 0 for 0. Exact to round-off of d. */
double mpm_property_rise(const struct mpm_property *property, double temperature, double content);

/* The smallest and the largest value. */
double mpm_property_least(const struct mpm_property *property);
double mpm_property_largest(const struct mpm_property *property);

/* The largest ratio of two tables over the temperatures that both cover: between neighbours of the
 * points of both it is a fraction of linear functions, and so has its largest value at one of
 * them. -1 if there is no temperature that both cover. */
double mpm_property_largest_ratio(const struct mpm_property *over,
                                  const struct mpm_property *under);

#endif
