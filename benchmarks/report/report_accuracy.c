/* Section: error against run time, a picture and a table of costs for each problem.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/accuracy.h"
#include "benchmarks/report/report_sections.h"

#include "verification/common/record.h"
#include "verification/measures/comparison/pareto.h"

#include <math.h>
#include <string.h>

/* Errors whose cost is stated. */
static const struct {
    double error;
    const char *column;
} levels[] = {{0.1, ">CPU s to 10 %"}, {0.01, ">CPU s to 1 %"}, {0.001, ">CPU s to 0.1 %"}};

enum bound { MEDIAN, LOW, HIGH, BOUNDS };
static const char *const bound_keys[BOUNDS] = {"median", "low", "high"};

/* The runs of one problem: value lines of the headline error, in the order of the file, which
 * goes from coarse to fine within a variant. */
struct ladder {
    const struct report *report;
    const struct accuracy_problem *problem; /* NULL: one that this version does not know */
    const char *name;
    GPtrArray *lines;
};

static const struct accuracy_problem *find_problem(const char *name)
{
    size_t count;
    const struct accuracy_problem *const *problems = accuracy_problems(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(problems[i]->name, name) == 0)
            return problems[i];
    return NULL;
}

static bool is_variant(const json_t *line, const struct bench_variant *variant)
{
    return strcmp(report_setting(line, "shape"), variant->shape) == 0 &&
           strcmp(report_setting(line, "stress_update"), variant->stress_update) == 0 &&
           strcmp(report_setting(line, "change"), variant->change) == 0;
}

static struct pareto_point point_of(const struct ladder *ladder, const json_t *line,
                                    enum bound bound)
{
    const json_t *seconds = bench_records_find(ladder->report->records, "result", "accuracy",
                                               record_text(line, "point"), "cpu_seconds");
    return (struct pareto_point){.cost = record_number(seconds, bound_keys[bound]),
                                 .error = record_number(line, "value")};
}

/* The points of a variant (NULL: of all) by rising cells; returns how many. */
static size_t points_of(const struct ladder *ladder, const struct bench_variant *variant,
                        enum bound bound, struct pareto_point *points)
{
    size_t count = 0;
    for (unsigned i = 0; i < ladder->lines->len; i++) {
        const json_t *line = ladder->lines->pdata[i];
        if (variant == NULL || is_variant(line, variant))
            points[count++] = point_of(ladder, line, bound);
    }
    return count;
}

/* --------------------------------------------------------------------- figure */

static void data_point(GString *data, const struct pareto_point *point)
{
    char cost[G_ASCII_DTOSTR_BUF_SIZE], error[G_ASCII_DTOSTR_BUF_SIZE];
    if (!isfinite(point->cost) || !(point->error > 0))
        g_string_append_c(data, '\n'); /* a failed run breaks the line of its ladder */
    else
        g_string_append_printf(data, "%s %s\n",
                               g_ascii_formatd(cost, sizeof cost, "%.6g", point->cost),
                               g_ascii_formatd(error, sizeof error, "%.6g", 100 * point->error));
}

/* A block for each variant, then the front; a block without points would be a warning. */
static char *figure_data(const struct ladder *ladder, GString *settings)
{
    struct pareto_point *points = g_new0(struct pareto_point, ladder->lines->len);
    size_t *front = g_new0(size_t, ladder->lines->len);
    GString *data = g_string_new("# CPU seconds, error in per cent\n");
    g_string_append(settings, "blocks='");
    for (size_t v = 0; v < bench_variants_count(); v++) {
        const struct bench_variant variant = bench_variant(v);
        const size_t count = points_of(ladder, &variant, MEDIAN, points);
        if (pareto_front(points, count, front) == 0)
            continue;
        g_string_append_printf(settings, "%zu%zu ", variant.colour + 1, variant.marker + 1);
        for (size_t i = 0; i < count; i++)
            data_point(data, &points[i]);
        g_string_append(data, "\n\n");
    }
    const size_t count = points_of(ladder, NULL, MEDIAN, points);
    const size_t on_front = pareto_front(points, count, front);
    for (size_t i = 0; i < on_front; i++)
        data_point(data, &points[front[i]]);
    g_string_append(settings, "'");
    g_free(points);
    g_free(front);
    if (on_front == 0)
        g_string_truncate(data, 0);
    return g_string_free(data, FALSE);
}

static void add_picture(struct report *report, const struct ladder *ladder, size_t place)
{
    GString *settings = g_string_new(NULL);
    char *data = figure_data(ladder, settings);
    char *name = g_strdup_printf("accuracy_%zu", place + 1);
    char *title = g_strdup_printf("%s: error against processor time",
                                  ladder->problem == NULL ? ladder->name : ladder->problem->title);
    const char *words = ladder->problem == NULL ? "error" : ladder->problem->headline_words;
    char *caption = g_strdup_printf(
        "Vertical: %s. Colour and dashes show the shape functions, markers the stress-update "
        "order (other transfers and the momentum form: uGIMP with MUSL); each line is one variant "
        "from its coarsest grid to its finest (other transfers and the momentum form to the one "
        "before), the thick line the Pareto front over all of them. Errors above 200 %% are not "
        "drawn.",
        words);
    g_string_append_printf(settings, "; label='%s (%%)'", words);
    if (*data != '\0')
        report_add_figure(
            report, &(struct report_figure){name, "accuracy", settings->str, data, title, caption});
    g_free(caption);
    g_free(title);
    g_free(name);
    g_free(data);
    g_string_free(settings, TRUE);
}

/* ---------------------------------------------------------------------- table */

static char *cost_text(const struct pareto_cost *cost)
{
    if (cost->reach == PARETO_NOT_REACHED)
        return g_strdup("not reached");
    char *number = report_digits(cost->cost, 1);
    char *text = g_strconcat(cost->reach == PARETO_AT_MOST ? "≤ " : "", number, NULL);
    g_free(number);
    return text;
}

static void cell_cost(struct report *report, const struct ladder *ladder,
                      const struct bench_variant *variant, double error)
{
    struct pareto_point *points = g_new0(struct pareto_point, ladder->lines->len);
    struct pareto_cost cost[BOUNDS];
    for (int b = 0; b < BOUNDS; b++) {
        const size_t count = points_of(ladder, variant, (enum bound)b, points);
        cost[b] = pareto_cost_to_reach(points, count, error);
    }
    char *about = NULL;
    if (cost[MEDIAN].reach == PARETO_REACHED) {
        char *low = report_digits(cost[LOW].cost, 1), *high = report_digits(cost[HIGH].cost, 1);
        about = g_strdup_printf("%s .. %s", low, high);
        g_free(low);
        g_free(high);
    }
    document_cell(report->document, cost_text(&cost[MEDIAN]), about);
    g_free(points);
}

/* The least error of a variant and the grid it was found on. */
static void cell_least(struct report *report, const struct ladder *ladder,
                       const struct bench_variant *variant)
{
    const json_t *least = NULL;
    size_t failed = 0;
    for (unsigned i = 0; i < ladder->lines->len; i++) {
        const json_t *line = ladder->lines->pdata[i];
        if (!is_variant(line, variant))
            continue;
        const double error = record_number(line, "value");
        failed += isfinite(error) ? 0 : 1;
        if (isfinite(error) && (least == NULL || error < record_number(least, "value")))
            least = line;
    }
    char *failures = failed == 0 ? g_strdup("") : g_strdup_printf("; %zu failed", failed);
    if (least == NULL)
        document_cell(report->document, g_strdup("none"), g_strdup_printf("%zu failed", failed));
    else
        document_cell(report->document, report_digits(record_number(least, "value"), 0.01),
                      g_strdup_printf("%.0f cells%s", report_number(least, "cells"), failures));
    g_free(failures);
}

static bool has_variant(const struct ladder *ladder, const struct bench_variant *variant)
{
    for (unsigned i = 0; i < ladder->lines->len; i++)
        if (is_variant(ladder->lines->pdata[i], variant))
            return true;
    return false;
}

static void add_table(struct report *report, const struct ladder *ladder)
{
    const char *const columns[] = {"Variant",        ">Least error, %", levels[0].column,
                                   levels[1].column, levels[2].column,  NULL};
    document_table(report->document,
                   "Cost to reach an error, interpolated between the two grids around it where it "
                   "is first reached, never extrapolated. ≤: reached by the coarsest grid "
                   "already. A failed run was ended by the solver's guard.",
                   columns);
    for (size_t v = 0; v < bench_variants_count(); v++) {
        const struct bench_variant variant = bench_variant(v);
        if (!has_variant(ladder, &variant))
            continue;
        document_cell(report->document, report_variant_words(&variant), NULL);
        cell_least(report, ladder, &variant);
        for (size_t l = 0; l < G_N_ELEMENTS(levels); l++)
            cell_cost(report, ladder, &variant, levels[l].error);
    }
}

/* -------------------------------------------------------------------- section */

/* Names of the problems in the order of the file. */
static GPtrArray *problem_names(const GPtrArray *lines)
{
    GPtrArray *names = g_ptr_array_new();
    for (unsigned i = 0; i < lines->len; i++) {
        const char *name = report_setting(lines->pdata[i], "problem");
        if (!g_ptr_array_find_with_equal_func(names, name, g_str_equal, NULL))
            g_ptr_array_add(names, (char *)(uintptr_t)name);
    }
    return names;
}

static GPtrArray *lines_of(const GPtrArray *lines, const struct ladder *ladder)
{
    GPtrArray *own = g_ptr_array_new();
    const char *quantity = ladder->problem == NULL ? NULL : ladder->problem->headline;
    for (unsigned i = 0; i < lines->len; i++) {
        json_t *line = lines->pdata[i];
        if (strcmp(report_setting(line, "problem"), ladder->name) != 0)
            continue;
        if (quantity == NULL)
            quantity = record_text(line, "quantity");
        if (strcmp(record_text(line, "quantity"), quantity) == 0)
            g_ptr_array_add(own, line);
    }
    return own;
}

void report_accuracy(struct report *report)
{
    document_heading(report->document, 2, "Error against run time");
    if (!report_has(report, "accuracy", "Error against run time"))
        return;
    GPtrArray *lines = report_lines(report, "value", "accuracy", NULL);
    GPtrArray *names = problem_names(lines);
    for (unsigned i = 0; i < names->len; i++) {
        struct ladder ladder = {report, find_problem(names->pdata[i]), names->pdata[i], NULL};
        ladder.lines = lines_of(lines, &ladder);
        document_heading(report->document, 3,
                         ladder.problem == NULL ? ladder.name : ladder.problem->title);
        if (ladder.problem != NULL)
            document_paragraph(report->document, "%s.", ladder.problem->description);
        add_picture(report, &ladder, i);
        add_table(report, &ladder);
        g_ptr_array_unref(ladder.lines);
    }
    g_ptr_array_unref(names);
    g_ptr_array_unref(lines);
}
