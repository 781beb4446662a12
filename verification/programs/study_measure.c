/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/study_measure.h"

#include "verification/measures/error_norms.h"

#include <math.h>
#include <string.h>

enum { OVER_TIME = 2 };

/* -------------------------------------------------------------------- references */

static enum mpm_status check_curve(const char *path, bool axisymmetric,
                                   struct study_reference *reference, struct mpm_error *error)
{
    const char *const names[] = {axisymmetric ? "r" : "x", axisymmetric ? "z" : "y", "time"};
    const GPtrArray *columns = reference->curve.names;
    reference->over = 0;
    while (columns->len == 2 && reference->over <= OVER_TIME &&
           strcmp(columns->pdata[0], names[reference->over]) != 0)
        reference->over++;
    if (columns->len != 2 || reference->over > OVER_TIME || reference->curve.rows == 0)
        return failure_set(
            error, MPM_BAD_INPUT,
            "%s: allowed are two columns, %s, %s or time and the value, and a row at "
            "least",
            path, names[0], names[1]);
    const double *over = table_named_column(&reference->curve, names[reference->over]);
    for (size_t k = 1; k < reference->curve.rows; k++)
        if (!(over[k] > over[k - 1]))
            return failure_set(error, MPM_BAD_INPUT, "%s: row %zu: %s has to rise", path, k + 1,
                               names[reference->over]);
    return MPM_OK;
}

enum mpm_status study_reference_open(const char *text, bool axisymmetric,
                                     struct study_reference *reference, struct mpm_error *error)
{
    static const char *const planar[] = {"x", "y"}, *const round[] = {"r", "z"};
    *reference = (struct study_reference){.formula = NULL};
    if (!g_str_has_suffix(text, ".csv"))
        return mpm_expression_create(text, axisymmetric ? round : planar, true, 1,
                                     &reference->formula, error);
    enum mpm_status status = table_named_read(text, &reference->curve, error);
    if (status == MPM_OK)
        status = check_curve(text, axisymmetric, reference, error);
    return status;
}

void study_reference_close(struct study_reference *reference)
{
    mpm_expression_free(reference->formula);
    if (reference->curve.names != NULL)
        table_named_clear(&reference->curve);
    *reference = (struct study_reference){.formula = NULL};
}

bool study_reference_given(const struct study_reference *reference)
{
    return reference->formula != NULL || reference->curve.names != NULL;
}

double study_reference_value(const struct study_reference *reference, const double place[2],
                             double time)
{
    if (reference->formula != NULL)
        return mpm_expression_value(reference->formula, 0, place, time);
    const GPtrArray *columns = reference->curve.names;
    if (columns == NULL)
        return (double)NAN;
    return curve_at(reference->curve.rows, table_named_column(&reference->curve, columns->pdata[0]),
                    table_named_column(&reference->curve, columns->pdata[1]),
                    reference->over == OVER_TIME ? time : place[reference->over]);
}

/* ------------------------------------------------------------------------- fields */

/* The component of all particles. */
static double *read_component(const struct field_quantity *quantity,
                              const struct study_particles *start,
                              const struct mpm_simulation *simulation)
{
    const size_t components = mpm_field_describe(quantity->field)->components;
    double *all = g_new(double, components * start->count);
    double *values = g_new(double, start->count);
    mpm_simulation_field(simulation, quantity->field, all);
    for (size_t p = 0; p < start->count; p++) {
        values[p] = all[components * p + quantity->component];
        if (quantity->displacement)
            values[p] -= start->position[2 * p + quantity->component];
    }
    g_free(all);
    return values;
}

static double field_norm(const struct study_measure *measure, const struct study_particles *start,
                         const double *values, double time)
{
    double *exact = g_new(double, start->count);
    for (size_t p = 0; p < start->count; p++)
        exact[p] = start->weight[p] > 0.0
                       ? study_reference_value(&measure->reference, &start->position[2 * p], time)
                       : 0.0;
    const struct error_norms norms =
        error_norms(start->count, 1, NULL, start->weight, values, exact);
    g_free(exact);
    return measure->take == TAKE_L1 ? norms.l1 : measure->take == TAKE_L2 ? norms.l2 : norms.linf;
}

/* max, min, and the mean by volume, of the particles that count. */
static double field_number(enum take take, const struct study_particles *start,
                           const double *values)
{
    double sum = 0.0, weight = 0.0, extreme = (double)NAN;
    for (size_t p = 0; p < start->count; p++) {
        if (!(start->weight[p] > 0.0))
            continue;
        const bool further = take == TAKE_MAX ? values[p] > extreme : values[p] < extreme;
        extreme = weight == 0.0 || further || isnan(values[p]) ? values[p] : extreme;
        sum += start->weight[p] * values[p];
        weight += start->weight[p];
    }
    return take == TAKE_MEAN || isnan(sum) ? sum / weight : extreme;
}

struct study_number study_measure_field(const struct study_measure *measure,
                                        const struct study_particles *start,
                                        const struct mpm_simulation *simulation)
{
    const double time = mpm_simulation_time(simulation);
    double *values = read_component(measure->field, start, simulation);
    struct study_number number = {.reference = (double)NAN};
    if (take_is_norm(measure->take))
        number.value = field_norm(measure, start, values, time);
    else if (measure->take == TAKE_AT)
        number.value = plane_at(start->count, start->position, start->weight, values, measure->at);
    else
        number.value = field_number(measure->take, start, values);
    if (!take_is_norm(measure->take))
        number.reference = study_reference_value(&measure->reference, measure->at, time);
    g_free(values);
    return number;
}

/* ------------------------------------------------------------------------ history */

enum mpm_status study_measure_history(const struct study_measure *measure,
                                      const struct table_named *history,
                                      struct study_number *number, struct mpm_error *error)
{
    static const double nowhere[2] = {0.0, 0.0};
    const double *time = table_named_column(history, "time");
    const double *column = table_named_column(history, measure->quantity);
    const size_t rows = history->rows;
    if (column == NULL || time == NULL || rows == 0)
        return failure_set(error, MPM_BAD_INPUT, "history.csv has no column \"%s\"",
                           measure->quantity);
    *number = (struct study_number){.reference = (double)NAN};
    if (take_is_norm(measure->take)) {
        double *errors = g_new(double, rows);
        for (size_t k = 0; k < rows; k++)
            errors[k] = column[k] - study_reference_value(&measure->reference, nowhere, time[k]);
        number->value = curve_take(measure->take, rows, time, errors);
        g_free(errors);
        return MPM_OK;
    }
    const double instant = measure->take == TAKE_AT ? measure->at[0] : time[rows - 1];
    number->value = measure->take == TAKE_AT ? curve_at(rows, time, column, instant)
                                             : curve_take(measure->take, rows, time, column);
    number->reference = study_reference_value(&measure->reference, nowhere, instant);
    return MPM_OK;
}
