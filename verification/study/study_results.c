/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study_results.h"

#include "verification/measures/grid_convergence.h"
#include "verification/measures/orders.h"

#include <math.h>
#include <string.h>

const char *study_state_name(enum study_state state)
{
    static const char *const names[] = {"done", "failed", "missing"};
    return names[state];
}

/* ---------------------------------------------------------------------- records */

/* What the run of that name has left of a quantity; NULL: nothing. */
static const json_t *line_of(const struct records *records, const char *run, const char *quantity)
{
    for (size_t i = 0; i < json_array_size(records->measurements); i++) {
        const json_t *line = json_array_get(records->measurements, i);
        if (strcmp(record_text(line, "case"), run) == 0 &&
            strcmp(record_text(line, "quantity"), quantity) == 0)
            return line;
    }
    return NULL;
}

/* NaN: none. */
static double number_of(const struct records *records, const char *run, const char *quantity)
{
    return record_number(line_of(records, run, quantity), "value");
}

/* Why a run that is done has no number for the measure. */
static char *missing_reason(const struct records *records, const char *run, unsigned k)
{
    char quantity[32];
    g_snprintf(quantity, sizeof quantity, "measure_%u", k + 1);
    return g_strdup(record_text(line_of(records, run, quantity), "reason"));
}

static double numbered(const struct records *records, const char *run, const char *name, unsigned k)
{
    char quantity[32];
    g_snprintf(quantity, sizeof quantity, "%s_%u", name, k + 1);
    return number_of(records, run, quantity);
}

/* The state is that of the run's only check. */
static void take_state(const struct records *records, struct study_row *row)
{
    row->state = STUDY_MISSING;
    row->reason = g_strdup("was not run");
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (strcmp(record_text(check, "case"), row->run->name) != 0)
            continue;
        const bool ran = row->cpu_seconds > 0.0 || row->particle_steps > 0.0 ||
                         record_number(check, "seconds") > 0.0;
        row->state = record_status(check) == VERDICT_PASS ? STUDY_DONE
                     : ran                                ? STUDY_FAILED
                                                          : STUDY_MISSING;
        g_free(row->reason);
        row->reason = row->state == STUDY_DONE ? NULL : g_strdup(record_text(check, "reason"));
        return;
    }
}

static double error_of(const struct study_entry *entry, const struct study_value *value)
{
    if (take_is_norm(entry->take))
        return value->value;
    return fabs(value->value - value->reference);
}

static void take_row(const struct study *study, const struct records *records,
                     struct study_row *row)
{
    const char *name = row->run->name;
    row->cpu_seconds = number_of(records, name, "cpu_seconds");
    row->particle_steps = number_of(records, name, "particle_steps");
    take_state(records, row);
    for (unsigned k = 0; k < study->measures_count; k++) {
        const struct study_entry *entry = &study->measures[k];
        struct study_value *value = &row->values[k];
        *value = (struct study_value){(double)NAN, (double)NAN, (double)NAN, (double)NAN};
        if (row->state != STUDY_DONE)
            continue;
        value->value = numbered(records, name, "measure", k);
        value->reference = entry->against == AGAINST_NUMBER
                               ? entry->number
                               : numbered(records, name, "reference", k);
        value->error = error_of(entry, value);
        if (isnan(value->value) && row->reason == NULL)
            row->reason = missing_reason(records, name, k);
    }
}

/* ----------------------------------------------------------------------- orders */

struct levels {
    size_t count;
    struct study_value *at[STUDY_LEVELS_MAX];
    double cell[STUDY_LEVELS_MAX], error[STUDY_LEVELS_MAX], value[STUDY_LEVELS_MAX];
};

/* Levels that have a number: a run that failed leaves a gap. */
static struct levels levels_of(const struct study_results *results, size_t group, unsigned k)
{
    struct levels levels = {.count = 0};
    for (unsigned i = 0; i < results->runs->len; i++) {
        struct study_row *row = &results->rows[i];
        if (row->run->group != group || !isfinite(row->values[k].value))
            continue;
        levels.at[levels.count] = &row->values[k];
        levels.cell[levels.count] = row->run->cell;
        levels.value[levels.count] = row->values[k].value;
        levels.error[levels.count++] = row->values[k].error;
    }
    return levels;
}

static void set_pairs(const struct levels *levels)
{
    for (size_t j = 1; j < levels->count; j++)
        levels->at[j]->order = order_pair(j, levels->cell, levels->error);
}

static struct study_order order_of_errors(const struct levels *levels)
{
    const struct order_fit fit = order_fit(levels->count, levels->cell, levels->error);
    return (struct study_order){
        .order = fit.order,
        .half_width = fit.half_width,
        .levels = levels->count,
        .limit = (double)NAN,
        .index = (double)NAN,
        .kind = order_class_name(order_classify(levels->count, levels->cell, levels->error)),
        .reason = isfinite(fit.order) ? ""
                  : levels->count < 2 ? "fewer than two levels have a number"
                                      : "an error is zero or not finite",
    };
}

/* The three levels that end with `last`: false where their cells do not fall by one ratio. */
static bool triple(const struct levels *levels, size_t last, struct grid_convergence *found)
{
    static const double same = 1e-9;
    const double *h = levels->cell, *v = levels->value;
    const double ratio = h[last - 1] / h[last];
    if (fabs(h[last - 2] / h[last - 1] - ratio) > same * ratio)
        return false;
    *found = grid_convergence(v[last - 2], v[last - 1], v[last], ratio, GRID_CONVERGENCE_SAFETY);
    return true;
}

/* Without an exact number: order and limit of the last three levels. */
static struct study_order order_of_differences(const struct levels *levels)
{
    struct study_order order = {.order = (double)NAN,
                                .half_width = (double)NAN,
                                .levels = 3,
                                .limit = (double)NAN,
                                .index = (double)NAN,
                                .kind = "",
                                .reason = "fewer than three levels have a number"};
    struct grid_convergence found, before;
    if (levels->count < 3)
        return order;
    order.reason = "the last three levels have not one ratio, as 1, 2, 4 have";
    if (!triple(levels, levels->count - 1, &found))
        return order;
    order.order = found.order;
    order.limit = found.extrapolated;
    order.index = found.index;
    order.reason = isfinite(found.order)
                       ? ""
                       : "the last two differences do not fall with one sign: no order can be seen";
    if (levels->count > 3 && triple(levels, levels->count - 2, &before))
        order.half_width = fabs(before.order - found.order);
    return order;
}

static void set_errors(const struct study_entry *entry, const struct study_order *order,
                       struct levels *levels)
{
    double reference = order->limit;
    if (entry->against == AGAINST_FINEST && levels->count > 0)
        reference = levels->value[levels->count - 1];
    for (size_t j = 0; j < levels->count; j++) {
        levels->at[j]->reference = reference;
        levels->error[j] = fabs(levels->value[j] - reference);
        if (entry->against == AGAINST_FINEST && j + 1 == levels->count)
            levels->error[j] = (double)NAN; /* it is its own reference */
        levels->at[j]->error = levels->error[j];
    }
}

static struct study_order order_make(struct study_results *results, size_t group, unsigned k)
{
    const struct study_entry *entry = &results->study->measures[k];
    struct levels levels = levels_of(results, group, k);
    struct study_order order;
    if (entry->against == AGAINST_NUMBER || entry->against == AGAINST_EVALUATED) {
        order = order_of_errors(&levels);
    } else {
        order = order_of_differences(&levels);
        set_errors(entry, &order, &levels);
    }
    set_pairs(&levels);
    order.judged = entry->order_text[0] != NULL;
    order.holds = order.order >= entry->order[0] && order.order <= entry->order[1];
    return order;
}

/* ------------------------------------------------------------------------- make */

enum mpm_status study_results_make(const struct study *study, const struct records *records,
                                   struct study_results *results, struct mpm_error *error)
{
    *results = (struct study_results){.study = study};
    TRY(study_runs(study, &results->runs, error));
    const unsigned measures = study->measures_count;
    results->rows = g_new0(struct study_row, results->runs->len);
    results->groups = results->runs->len / study->refine_count;
    for (unsigned i = 0; i < results->runs->len; i++) {
        struct study_row *row = &results->rows[i];
        row->run = &g_array_index(results->runs, struct study_run, i);
        row->values = g_new(struct study_value, measures);
        take_row(study, records, row);
        results->failed += row->state == STUDY_FAILED ? 1 : 0;
        results->missing += row->state == STUDY_MISSING ? 1 : 0;
    }
    results->orders = g_new(struct study_order, results->groups * measures);
    for (size_t g = 0; g < results->groups; g++)
        for (unsigned k = 0; k < measures; k++) {
            const struct study_order order = order_make(results, g, k);
            results->orders[g * measures + k] = order;
            results->out_of_order += order.judged && !order.holds ? 1 : 0;
        }
    return MPM_OK;
}

void study_results_clear(struct study_results *results)
{
    for (unsigned i = 0; i < results->runs->len; i++) {
        g_free(results->rows[i].reason);
        g_free(results->rows[i].values);
    }
    g_free(results->rows);
    g_free(results->orders);
    g_array_unref(results->runs);
}
