/* The columns of bundles and results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/columns.h"

#include <glib.h>
#include <string.h>

static const struct {
    const char *planar, *axisymmetric;
    struct mpm_dimension dimension;
} columns[SCORE_COLUMNS] = {
    [SCORE_TIME] = {"time", "time", MPM_DIMENSION_TIME},
    [SCORE_BODY] = {"body", "body", MPM_DIMENSION_NONE},
    [SCORE_ID] = {"id", "id", MPM_DIMENSION_NONE},
    [SCORE_INITIAL_X] = {"initial_x", "initial_r", MPM_DIMENSION_LENGTH},
    [SCORE_INITIAL_Y] = {"initial_y", "initial_z", MPM_DIMENSION_LENGTH},
    [SCORE_X] = {"x", "r", MPM_DIMENSION_LENGTH},
    [SCORE_Y] = {"y", "z", MPM_DIMENSION_LENGTH},
    [SCORE_DISPLACEMENT_X] = {"displacement_x", "displacement_r", MPM_DIMENSION_LENGTH},
    [SCORE_DISPLACEMENT_Y] = {"displacement_y", "displacement_z", MPM_DIMENSION_LENGTH},
    [SCORE_VELOCITY_X] = {"velocity_x", "velocity_r", MPM_DIMENSION_VELOCITY},
    [SCORE_VELOCITY_Y] = {"velocity_y", "velocity_z", MPM_DIMENSION_VELOCITY},
    [SCORE_STRESS_XX] = {"stress_xx", "stress_rr", MPM_DIMENSION_STRESS},
    [SCORE_STRESS_YY] = {"stress_yy", "stress_zz", MPM_DIMENSION_STRESS},
    [SCORE_STRESS_ZZ] = {"stress_zz", "stress_tt", MPM_DIMENSION_STRESS},
    [SCORE_STRESS_XY] = {"stress_xy", "stress_rz", MPM_DIMENSION_STRESS},
    [SCORE_RELATIVE_VOLUME] = {"relative_volume", "relative_volume", MPM_DIMENSION_NONE},
    [SCORE_TEMPERATURE] = {"temperature", "temperature", MPM_DIMENSION_TEMPERATURE},
    [SCORE_POSITION_TIME] = {"time_of_positions", "time_of_positions", MPM_DIMENSION_TIME},
    [SCORE_VELOCITY_TIME] = {"time_of_velocities", "time_of_velocities", MPM_DIMENSION_TIME},
    [SCORE_STRESS_TIME] = {"time_of_stress", "time_of_stress", MPM_DIMENSION_TIME},
    [SCORE_FORCE_X] = {"body_force_x", "body_force_r", MPM_DIMENSION_ACCELERATION},
    [SCORE_FORCE_Y] = {"body_force_y", "body_force_z", MPM_DIMENSION_ACCELERATION},
};

const char *score_column_name(enum score_column column, enum mpm_geometry geometry)
{
    return geometry == MPM_AXISYMMETRIC ? columns[column].axisymmetric : columns[column].planar;
}

enum score_column score_column_find(const char *name, enum mpm_geometry geometry)
{
    int column = 0;
    while (column < SCORE_COLUMNS &&
           strcmp(score_column_name((enum score_column)column, geometry), name) != 0)
        column++;
    return (enum score_column)column;
}

static void add_factor(GString *text, const char *unit, int exponent)
{
    if (exponent == 0)
        return;
    g_string_append_printf(text, "%s%s", text->len > 0 ? " " : "", unit);
    if (exponent != 1)
        g_string_append_printf(text, "^%d", exponent);
}

char *score_column_unit(enum score_column column, const struct score_units *units)
{
    GString *text = g_string_new(NULL);
    const struct mpm_dimension dimension = columns[column].dimension;
    add_factor(text, units->mass, dimension.mass);
    add_factor(text, units->length, dimension.length);
    add_factor(text, units->time, dimension.time);
    add_factor(text, units->temperature, dimension.temperature);
    if (text->len == 0)
        g_string_append_c(text, '1');
    return g_string_free(text, FALSE);
}
