/* From named arrays of results, as VTK and HDF5 files have them, to columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

enum { NONE = SCORE_COLUMNS, COMPONENTS_MAX = 9 };

/* Which component of an array goes to which column. A deformation gradient goes to the relative
 * volume alone. */
static const struct layout {
    const char *name;
    size_t components;
    int column[COMPONENTS_MAX];
} layouts[] = {
    {"position", 2, {SCORE_X, SCORE_Y}},
    {"position", 3, {SCORE_X, SCORE_Y, NONE}},
    {"initial_position", 2, {SCORE_INITIAL_X, SCORE_INITIAL_Y}},
    {"initial_position", 3, {SCORE_INITIAL_X, SCORE_INITIAL_Y, NONE}},
    {"displacement", 2, {SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y}},
    {"displacement", 3, {SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y, NONE}},
    {"velocity", 2, {SCORE_VELOCITY_X, SCORE_VELOCITY_Y}},
    {"velocity", 3, {SCORE_VELOCITY_X, SCORE_VELOCITY_Y, NONE}},
    {"stress", 4, {SCORE_STRESS_XX, SCORE_STRESS_YY, SCORE_STRESS_ZZ, SCORE_STRESS_XY}},
    {"stress", 6, {SCORE_STRESS_XX, SCORE_STRESS_YY, SCORE_STRESS_ZZ, SCORE_STRESS_XY, NONE, NONE}},
    {"stress",
     9,
     {SCORE_STRESS_XX, SCORE_STRESS_XY, NONE, NONE, SCORE_STRESS_YY, NONE, NONE, NONE,
      SCORE_STRESS_ZZ}},
    {"deformation_gradient", 5, {SCORE_RELATIVE_VOLUME}},
    {"deformation_gradient", 9, {SCORE_RELATIVE_VOLUME}},
};

static double determinant(const double *f, size_t components)
{
    if (components == 5) /* xx xy yx yy zz */
        return (f[0] * f[3] - f[1] * f[2]) * f[4];
    return f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
           f[2] * (f[3] * f[7] - f[4] * f[6]);
}

static void fill(const struct layout *layout, const double *values, struct score_table *table)
{
    const size_t components = layout->components;
    if (strcmp(layout->name, "deformation_gradient") == 0) {
        double *volume = score_table_add(table, SCORE_RELATIVE_VOLUME);
        for (size_t p = 0; p < table->rows; p++)
            volume[p] = determinant(&values[p * components], components);
        return;
    }
    for (size_t c = 0; c < components; c++) {
        if (layout->column[c] == NONE)
            continue;
        double *column = score_table_add(table, (enum score_column)layout->column[c]);
        for (size_t p = 0; p < table->rows; p++)
            column[p] = values[p * components + c];
    }
}

/* The layout of an array; *named if there is one of that name with any number of components. */
static bool find_layout(const char *name, size_t components, enum mpm_geometry geometry,
                        struct layout *layout, GString *allowed)
{
    const enum score_column own = score_column_find(name, geometry);
    for (size_t i = 0; i < G_N_ELEMENTS(layouts); i++) {
        if (strcmp(layouts[i].name, name) != 0)
            continue;
        *layout = layouts[i];
        if (layouts[i].components == components)
            return true;
        g_string_append_printf(allowed, "%s%zu", allowed->len > 0 ? ", " : "",
                               layouts[i].components);
    }
    *layout = (struct layout){name, 1, {(int)own}};
    if (own != SCORE_COLUMNS && components != 1)
        g_string_append_c(allowed, '1');
    return own != SCORE_COLUMNS && components == 1;
}

static enum mpm_status check_values(const char *path, const char *name, size_t components,
                                    const GArray *values, const struct score_table *table,
                                    struct mpm_error *error)
{
    if (values->len != table->rows * components)
        return failure_set(error, MPM_BAD_INPUT, "%s: %s has %u values, not %zu points of %zu",
                           path, name, values->len, table->rows, components);
    for (guint i = 0; i < values->len; i++)
        if (!isfinite(g_array_index(values, double, i)))
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: %s: component %zu of point %zu is %g: allowed are finite "
                               "numbers",
                               path, name, i % components, i / components,
                               g_array_index(values, double, i));
    return MPM_OK;
}

enum mpm_status score_take_array(const char *path, const struct score_format *format,
                                 const char *name, size_t components, const GArray *values,
                                 struct score_table *table, struct mpm_error *error)
{
    struct layout layout;
    GString *allowed = g_string_new(NULL);
    const bool known = find_layout(name, components, format->geometry, &layout, allowed);
    enum mpm_status status = MPM_OK;
    if (!known && allowed->len > 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: %s has %zu components: allowed are %s",
                             path, name, components, allowed->str);
    else if (!known)
        score_table_unread(table, name);
    else
        status = check_values(path, name, components, values, table, error);
    g_string_free(allowed, TRUE);
    if (known && status == MPM_OK)
        fill(&layout, (const double *)(const void *)values->data, table);
    return status;
}

enum mpm_status score_take_time(const char *path, double time, struct score_table *table,
                                struct mpm_error *error)
{
    if (!isfinite(time))
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: has no time: field data TimeValue or TIME, or a .pvd file that "
                           "names it",
                           path);
    double *times = score_table_add(table, SCORE_TIME);
    for (size_t p = 0; p < table->rows; p++)
        times[p] = time;
    return MPM_OK;
}
