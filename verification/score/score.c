/* Scores: results against the reference of a bundle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/score.h"

#include "verification/common/failure.h"
#include "verification/common/rows.h"
#include "verification/score/time_level.h"

#include <math.h>

/* An instant is met to this part of the end. */
static const double TIME_TOLERANCE = 1e-6;

enum { PARTS = 4 }; /* of each axis, that must hold a point each */

/* --------------------------------------------------------------------- what is required */

/* Whether the reference depends on that axis, so that points must state where they started. */
static bool depends_on(const struct bundle *bundle, size_t axis)
{
    return bundle->lattice.polar || bundle->lattice.count[axis] > 1;
}

static enum mpm_status ask_column(const struct bundle *bundle, const struct score_table *results,
                                  enum score_column column, struct mpm_error *error)
{
    if (score_table_has(results, column))
        return MPM_OK;
    char *unit = score_column_unit(column, &bundle->format.units);
    failure_set(error, MPM_BAD_INPUT, "the results have no column %s, in %s",
                score_column_name(column, bundle->format.geometry), unit);
    g_free(unit);
    return MPM_BAD_INPUT;
}

static enum mpm_status ask_columns(const struct bundle *bundle, const struct score_table *results,
                                   struct mpm_error *error)
{
    if (!bundle->rest)
        TRY(ask_column(bundle, results, SCORE_TIME, error));
    for (size_t a = 0; a < 2; a++)
        if (depends_on(bundle, a))
            TRY(ask_column(bundle, results, (enum score_column)(SCORE_INITIAL_X + a), error));
    for (size_t i = 0; i < bundle->criterion_count; i++)
        for (size_t c = 0; c < bundle->criteria[i].column_count; c++)
            TRY(ask_column(bundle, results, bundle->criteria[i].columns[c], error));
    return MPM_OK;
}

/* ----------------------------------------------------------------------- one instant */

struct instant {
    size_t number;
    double time;
    GArray *rows; /* of size_t */
};

/* The rows at the instant; at rest those of the last one. */
static enum mpm_status find_rows(const struct bundle *bundle, const struct score_table *results,
                                 struct instant *instant, struct mpm_error *error)
{
    const bool timed = score_table_has(results, SCORE_TIME);
    double nearest = (double)NAN;
    instant->time = bundle_time(bundle, instant->number);
    for (size_t p = 0; timed && bundle->rest && p < results->rows; p++)
        instant->time = p == 0 ? score_table_value(results, SCORE_TIME, p)
                               : fmax(instant->time, score_table_value(results, SCORE_TIME, p));
    g_array_set_size(instant->rows, 0);
    for (size_t p = 0; p < results->rows; p++) {
        const double time = timed ? score_table_value(results, SCORE_TIME, p) : instant->time;
        if (fabs(time - instant->time) <= TIME_TOLERANCE * bundle->end)
            g_array_append_val(instant->rows, p);
        if (!(fabs(time - instant->time) >= fabs(nearest - instant->time)))
            nearest = time;
    }
    if (instant->rows->len > 0)
        return MPM_OK;
    return failure_set(
        error, MPM_BAD_INPUT,
        "the results have nothing at time %.9g %s: the nearest is at %.9g, allowed is "
        "%g %s either side",
        instant->time, bundle->format.units.time, nearest, TIME_TOLERANCE * bundle->end,
        bundle->format.units.time);
}

static void place_of(const struct bundle *bundle, const struct score_table *results, size_t row,
                     double place[2])
{
    for (size_t a = 0; a < 2; a++)
        place[a] = depends_on(bundle, a)
                       ? score_table_value(results, (enum score_column)(SCORE_INITIAL_X + a), row)
                       : 0.5 * (bundle->lattice.from[a] + bundle->lattice.to[a]);
}

/* Which of the parts of the lattice holds the points that the weights are for. */
static size_t part_along(const struct lattice *lattice, size_t axis,
                         const struct lattice_weights *weights)
{
    double at = 0.0;
    if (lattice->count[axis] == 1)
        return 0;
    for (size_t i = 0; i < weights->number[axis]; i++)
        at += weights->weight[axis][i] * (double)(weights->first[axis] + i);
    return (size_t)fmin(at / (double)(lattice->count[axis] - 1) * PARTS, PARTS - 1);
}

static enum mpm_status check_cover(const struct bundle *bundle, const struct instant *instant,
                                   const bool held[PARTS][PARTS], struct mpm_error *error)
{
    const size_t parts[2] = {bundle->lattice.count[0] > 1 ? PARTS : 1,
                             bundle->lattice.count[1] > 1 ? PARTS : 1};
    for (size_t j = 0; j < parts[1]; j++)
        for (size_t i = 0; i < parts[0]; i++)
            if (!held[j][i])
                return failure_set(error, MPM_BAD_INPUT,
                                   "the results at time %.9g have too few points: none in part "
                                   "%zu, %zu of %zu x %zu equal ones of the body",
                                   instant->time, i + 1, j + 1, parts[0], parts[1]);
    return MPM_OK;
}

static enum mpm_status locate(const struct bundle *bundle, const struct score_table *results,
                              const struct instant *instant, struct lattice_weights *weights,
                              struct mpm_error *error)
{
    bool held[PARTS][PARTS] = {{false}};
    for (guint i = 0; i < instant->rows->len; i++) {
        const size_t row = g_array_index(instant->rows, size_t, i);
        double place[2];
        TRY(time_level_check(bundle, results, row, instant->number, error));
        place_of(bundle, results, row, place);
        if (!lattice_locate(&bundle->lattice, place, &weights[i]))
            return failure_set(
                error, MPM_BAD_INPUT,
                "a point of the results starts at (%.9g, %.9g), outside of the body: allowed are "
                "%s %g to %g and %s %g to %g",
                place[0], place[1], bundle->lattice.polar ? "radii" : "the first",
                bundle->lattice.from[0], bundle->lattice.to[0],
                bundle->lattice.polar ? "angles" : "the second", bundle->lattice.from[1],
                bundle->lattice.to[1]);
        held[part_along(&bundle->lattice, 1, &weights[i])]
            [part_along(&bundle->lattice, 0, &weights[i])] = true;
    }
    return check_cover(bundle, instant, (const bool(*)[PARTS])held, error);
}

static void add_points(const struct bundle *bundle, const struct bundle_criterion *criterion,
                       const struct score_table *results, const struct instant *instant,
                       const struct lattice_weights *weights, struct agreement *agreement)
{
    double multiple[CRITERION_COLUMNS], computed[CRITERION_COLUMNS], exact[CRITERION_COLUMNS];
    for (size_t c = 0; c < criterion->column_count; c++)
        multiple[c] = criterion->columns[c] == SCORE_STRESS_XY ? 2.0 : 1.0;
    for (guint i = 0; i < instant->rows->len; i++) {
        const size_t row = g_array_index(instant->rows, size_t, i);
        for (size_t c = 0; c < criterion->column_count; c++) {
            computed[c] = score_table_value(results, criterion->columns[c], row);
            exact[c] = time_level_reference(bundle, &weights[i], criterion->columns[c], results,
                                            row, instant->number);
        }
        agreement_add(agreement, criterion->column_count, multiple, computed, exact);
    }
}

/* ----------------------------------------------------------------------- all of them */

/* What has been added up for a criterion. */
struct sum {
    struct agreement all;
    double worst_error, worst_time; /* root of the sum of squares at an instant */
};

static enum mpm_status add_instants(const struct bundle *bundle, const struct score_table *results,
                                    struct instant *instant, struct sum *sums,
                                    struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    for (size_t k = 1; status == MPM_OK && k <= bundle->instants; k++) {
        instant->number = k;
        TRY(find_rows(bundle, results, instant, error));
        struct lattice_weights *weights = g_new(struct lattice_weights, instant->rows->len);
        status = locate(bundle, results, instant, weights, error);
        for (size_t i = 0; status == MPM_OK && i < bundle->criterion_count; i++) {
            struct agreement own = {.error = 0};
            add_points(bundle, &bundle->criteria[i], results, instant, weights, &own);
            agreement_join(&sums[i].all, &own);
            if (own.error_square > sums[i].worst_error) {
                sums[i].worst_error = own.error_square;
                sums[i].worst_time = instant->time;
            }
        }
        g_free(weights);
    }
    return status;
}

static void add_row(GString *rows, char *row)
{
    g_string_append(rows, row);
    g_free(row);
}

static void write_rows(const struct bundle *bundle, const struct score_table *results,
                       const struct sum *sums, GString *rows)
{
    for (size_t i = 0; i < bundle->criterion_count; i++) {
        const struct bundle_criterion *criterion = &bundle->criteria[i];
        add_row(rows, row_line_value(criterion->check.quantity,
                                     agreement_percent(&sums[i].all, criterion->norm)));
        char *note = g_strdup_printf("%s: furthest off at time %.6g %s", criterion->check.name,
                                     sums[i].worst_time, bundle->format.units.time);
        if (!bundle->rest)
            add_row(rows, row_line(ROW_NOTE, "", note));
        g_free(note);
    }
    for (guint i = 0; i < results->unread->len; i++) {
        char *note = g_strdup_printf("not read: %s", (char *)results->unread->pdata[i]);
        add_row(rows, row_line(ROW_NOTE, "", note));
        g_free(note);
    }
    add_row(rows, row_line(ROW_END, "", ""));
}

enum mpm_status score_rows(const struct bundle *bundle, const struct score_table *results,
                           GString *rows, struct mpm_error *error)
{
    TRY(ask_columns(bundle, results, error));
    struct sum *sums = g_new0(struct sum, bundle->criterion_count);
    struct instant instant = {.rows = g_array_new(FALSE, FALSE, sizeof(size_t))};
    const enum mpm_status status = add_instants(bundle, results, &instant, sums, error);
    if (status == MPM_OK)
        write_rows(bundle, results, sums, rows);
    g_array_unref(instant.rows);
    g_free(sums);
    return status;
}
