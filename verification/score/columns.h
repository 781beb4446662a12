/* The columns by which bundles and results are written: one name, one meaning, one unit.
 *
 * Rows are material points at instants. `initial_*` is where a point is in the undeformed
 * state, stress is Cauchy stress, relative_volume is det F. Axisymmetric problems have r, z, t
 * (hoop) in place of x, y, z.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_COLUMNS_H
#define VERIFICATION_SCORE_COLUMNS_H

#include "mpm.h"

enum score_column {
    SCORE_TIME,
    SCORE_BODY, /* from 0, in the order of the problem */
    SCORE_ID,   /* the same material point at all instants */
    SCORE_INITIAL_X,
    SCORE_INITIAL_Y,
    SCORE_X,
    SCORE_Y,
    SCORE_DISPLACEMENT_X,
    SCORE_DISPLACEMENT_Y,
    SCORE_VELOCITY_X,
    SCORE_VELOCITY_Y,
    SCORE_STRESS_XX,
    SCORE_STRESS_YY,
    SCORE_STRESS_ZZ,
    SCORE_STRESS_XY,
    SCORE_RELATIVE_VOLUME,
    SCORE_TEMPERATURE,
    SCORE_POSITION_TIME, /* of what results have at a row's time, if it is another, time_level.h */
    SCORE_VELOCITY_TIME,
    SCORE_STRESS_TIME,
    SCORE_FORCE_X, /* body force per unit mass; of bundles alone */
    SCORE_FORCE_Y,
    SCORE_COLUMNS
};

/* "stress_xx", or "stress_rr" where the problem is axisymmetric. */
const char *score_column_name(enum score_column column, enum mpm_geometry geometry);

/* SCORE_COLUMNS if no column has that name. */
enum score_column score_column_find(const char *name, enum mpm_geometry geometry);

/* Names of the units of a problem; as in its scene. */
struct score_units {
    const char *length, *mass, *time, *temperature;
};

/* The unit as text, mass first: "g mm^-1 ms^-2"; "1" for none. g_free. */
char *score_column_unit(enum score_column column, const struct score_units *units);

#endif
