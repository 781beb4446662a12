/* The tables of a study as texts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/study/study_write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *reference_words(const struct study_entry *entry)
{
    if (take_is_norm(entry->take) || entry->against == AGAINST_EVALUATED)
        return entry->reference;
    return entry->against == AGAINST_NUMBER   ? entry->reference
           : entry->against == AGAINST_FINEST ? "the finest level (no exact number is known)"
                                              : "Richardson's limit of the last three levels (no "
                                                "exact number is known)";
}

/* -------------------------------------------------------------- tables with columns */

/* Cells of a Markdown table, padded so that it reads well on a terminal. */
struct table {
    GPtrArray *cells;
    unsigned columns;
};

static void add_cell(struct table *table, const char *text)
{
    char **parts = g_strsplit(text, "|", -1);
    g_ptr_array_add(table->cells, g_strjoinv("\\|", parts));
    g_strfreev(parts);
}

static void add_number(struct table *table, int digits, double value)
{
    char text[64] = "-";
    if (isfinite(value))
        g_snprintf(text, sizeof text, "%.*g", digits, value);
    add_cell(table, text);
}

static void print_table(const struct table *table, GString *out)
{
    const unsigned rows = table->cells->len / table->columns;
    for (unsigned r = 0; r < rows; r++) {
        for (unsigned c = 0; c < table->columns; c++) {
            glong width = 3;
            for (unsigned i = 0; i < rows; i++)
                width = MAX(width, g_utf8_strlen(table->cells->pdata[i * table->columns + c], -1));
            const char *text = table->cells->pdata[r * table->columns + c];
            const int padding = (int)(width - g_utf8_strlen(text, -1));
            g_string_append_printf(out, "%s %s%*s ", c == 0 ? "|" : "", text, padding, "");
            g_string_append_c(out, '|');
        }
        g_string_append_c(out, '\n');
        for (unsigned c = 0; r == 0 && c < table->columns; c++)
            g_string_append(out, c == 0 ? "|---|" : "---|");
        if (r == 0)
            g_string_append_c(out, '\n');
    }
    g_ptr_array_unref(table->cells);
}

static struct table table_begin(unsigned columns, const char *const *names)
{
    struct table table = {g_ptr_array_new_with_free_func(g_free), columns};
    for (unsigned c = 0; c < columns; c++)
        add_cell(&table, names[c]);
    return table;
}

/* ------------------------------------------------------------------------ Markdown */

static void add_rows(const struct study_results *results, unsigned k, GString *out)
{
    const struct study *study = results->study;
    char *cell = g_strdup_printf(
        "cell / %s",
        study->length_unit == NULL || *study->length_unit == '\0' ? "length" : study->length_unit);
    const char *const names[] = {"variant",       "refine",        cell, "value", "error", "order",
                                 "processor / s", "particle-steps"};
    struct table table = table_begin(G_N_ELEMENTS(names), names);
    for (unsigned i = 0; i < results->runs->len; i++) {
        const struct study_row *row = &results->rows[i];
        const struct study_value *value = &row->values[k];
        char level[32];
        g_snprintf(level, sizeof level, "%" PRId64, row->run->level);
        add_cell(&table, *row->run->variant == '\0' ? "the scene" : row->run->variant);
        add_cell(&table, level);
        add_number(&table, 6, row->run->cell);
        if (row->state == STUDY_DONE)
            add_number(&table, 9, value->value);
        else
            add_cell(&table, study_state_name(row->state));
        add_number(&table, 4, value->error);
        add_number(&table, 3, value->order);
        add_number(&table, 3, row->cpu_seconds);
        add_number(&table, 6, row->particle_steps);
    }
    print_table(&table, out);
    g_free(cell);
}

static void add_order(const struct study_results *results, size_t group, unsigned k, GString *out)
{
    const struct study_order *order = &results->orders[group * results->study->measures_count + k];
    const struct study_entry *entry = &results->study->measures[k];
    const struct study_run *run = results->rows[group * results->study->refine_count].run;
    g_string_append_printf(out, "- %s: ", *run->variant == '\0' ? "the scene" : run->variant);
    if (isfinite(order->order))
        g_string_append_printf(out, "observed order %.3g", order->order);
    else
        g_string_append_printf(out, "no observed order: %s", order->reason);
    if (isfinite(order->half_width))
        g_string_append_printf(out, " ± %.2g", order->half_width);
    if (isfinite(order->order) && *order->kind != '\0')
        g_string_append_printf(out, " (fit over %zu levels%s, %s)", order->levels,
                               isfinite(order->half_width) ? ", 95 % confidence" : "", order->kind);
    else if (isfinite(order->order))
        g_string_append_printf(
            out, " (differences of the last three levels%s)",
            isfinite(order->half_width) ? "; ± is the change from the three levels before" : "");
    if (isfinite(order->limit))
        g_string_append_printf(out, "; limit %.9g", order->limit);
    if (isfinite(order->index))
        g_string_append_printf(out, ", grid-convergence index of the finest level %.2g %%",
                               100.0 * order->index);
    if (order->judged)
        g_string_append_printf(out, "; %s %g .. %g%s", order->holds ? "within" : "NOT within",
                               entry->order[0], entry->order[1], order->holds ? "" : ": FAILS");
    g_string_append_c(out, '\n');
}

static void add_measure(const struct study_results *results, unsigned k, bool pictures,
                        GString *out)
{
    const struct study_entry *entry = &results->study->measures[k];
    g_string_append_printf(out, "\n## %s\n\n%s, %s", entry->name, entry->quantity,
                           entry->take_text);
    if (entry->instant_text != NULL)
        g_string_append_printf(out, " t = %s", entry->instant_text);
    if (entry->at_text[0] != NULL)
        g_string_append_printf(out, " (%s, %s)", entry->at_text[0], entry->at_text[1]);
    g_string_append_printf(out, ", in %s. Error against %s.\n\n", entry->unit,
                           reference_words(entry));
    add_rows(results, k, out);
    g_string_append_c(out, '\n');
    for (size_t g = 0; g < results->groups; g++)
        add_order(results, g, k, out);
    if (pictures && study_has_picture(results, k))
        g_string_append_printf(out,
                               "\n![error over the size of a cell](error-%s-cell.svg)\n\n"
                               "![error over processor time](error-%s-time.svg)\n",
                               entry->name, entry->name);
}

static void add_state(const struct study_results *results, GString *out)
{
    const size_t bad = results->failed + results->missing;
    if (bad > 0)
        g_string_append_printf(out,
                               "\nThis study is incomplete: of %u runs, %zu failed and %zu are "
                               "missing.\n",
                               results->runs->len, results->failed, results->missing);
    bool begun = false;
    for (unsigned i = 0; i < results->runs->len; i++) {
        const struct study_row *row = &results->rows[i];
        if (row->reason == NULL)
            continue;
        g_string_append_printf(out, "%s- %s %s: %s\n", begun ? "" : "\n", row->run->name,
                               study_state_name(row->state), row->reason);
        begun = true;
    }
}

char *study_markdown(const struct study_results *results, bool pictures)
{
    GString *out = g_string_new(NULL);
    g_string_append_printf(out, "# %s\n", results->study->title);
    add_state(results, out);
    for (unsigned k = 0; k < results->study->measures_count; k++)
        add_measure(results, k, pictures, out);
    return g_string_free(out, FALSE);
}

/* ----------------------------------------------------------------------------- CSV */

static void add_quoted(GString *csv, const char *text)
{
    char **parts = g_strsplit(text == NULL ? "" : text, "\"", -1),
         *doubled = g_strjoinv("\"\"", parts);
    g_string_append_printf(csv, "\"%s\"", doubled);
    g_free(doubled);
    g_strfreev(parts);
}

static void add_field(GString *csv, double value)
{
    g_string_append_c(csv, ',');
    if (isfinite(value))
        g_string_append_printf(csv, "%.17g", value);
}

char *study_csv(const struct study_results *results)
{
    const struct study *study = results->study;
    GString *csv = g_string_new("run,variant,refine,cell,state,measure,unit,value,reference,error,"
                                "order,cpu_seconds,particle_steps,reason\n");
    for (unsigned i = 0; i < results->runs->len; i++)
        for (unsigned k = 0; k < study->measures_count; k++) {
            const struct study_row *row = &results->rows[i];
            const struct study_value *value = &row->values[k];
            g_string_append_printf(csv, "%s,", row->run->name);
            add_quoted(csv, row->run->variant);
            g_string_append_printf(csv, ",%" PRId64 ",%.17g,%s,%s,", row->run->level,
                                   row->run->cell, study_state_name(row->state),
                                   study->measures[k].name);
            add_quoted(csv, study->measures[k].unit);
            const double numbers[] = {value->value, value->reference, value->error,
                                      value->order, row->cpu_seconds, row->particle_steps};
            for (size_t j = 0; j < G_N_ELEMENTS(numbers); j++)
                add_field(csv, numbers[j]);
            g_string_append_c(csv, ',');
            add_quoted(csv, row->reason);
            g_string_append_c(csv, '\n');
        }
    return g_string_free(csv, FALSE);
}

/* ---------------------------------------------------------------------------- JSON */

static void add_line(GString *lines, json_t *object)
{
    char *text = json_dumps(object, JSON_COMPACT | JSON_PRESERVE_ORDER);
    g_string_append_printf(lines, "%s\n", text);
    free(text);
    json_decref(object);
}

static json_t *number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *value_json(const struct study_results *results, unsigned i, unsigned k)
{
    const struct study_row *row = &results->rows[i];
    const struct study_value *value = &row->values[k];
    return json_pack(
        "{s:s,s:s,s:s,s:I,s:o,s:s,s:s,s:s,s:o,s:o,s:o,s:o,s:o,s:o,s:s}", "kind", "value", "run",
        row->run->name, "variant", row->run->variant, "refine", (json_int_t)row->run->level, "cell",
        number(row->run->cell), "state", study_state_name(row->state), "measure",
        results->study->measures[k].name, "unit", results->study->measures[k].unit, "value",
        number(value->value), "reference", number(value->reference), "error", number(value->error),
        "order", number(value->order), "cpu_seconds", number(row->cpu_seconds), "particle_steps",
        number(row->particle_steps), "reason", row->reason == NULL ? "" : row->reason);
}

static json_t *order_json(const struct study_results *results, size_t group, unsigned k)
{
    const struct study_order *order = &results->orders[group * results->study->measures_count + k];
    const struct study_run *run = results->rows[group * results->study->refine_count].run;
    return json_pack("{s:s,s:s,s:s,s:o,s:o,s:I,s:s,s:o,s:o,s:s,s:s}", "kind", "order", "variant",
                     run->variant, "measure", results->study->measures[k].name, "order",
                     number(order->order), "half_width", number(order->half_width), "levels",
                     (json_int_t)order->levels, "class", order->kind, "limit", number(order->limit),
                     "grid_convergence_index", number(order->index), "verdict",
                     !order->judged ? "none"
                     : order->holds ? "pass"
                                    : "fail",
                     "reason", order->reason);
}

char *study_jsonl(const struct study_results *results, const json_t *run)
{
    const struct study *study = results->study;
    GString *lines = g_string_new(NULL);
    add_line(lines, json_pack("{s:s,s:i,s:s,s:s,s:s,s:b,s:I,s:I,s:I}", "kind", "study", "format", 1,
                              "title", study->title, "version", record_text(run, "version"),
                              "revision", record_text(run, "revision"), "complete",
                              results->failed + results->missing == 0, "runs",
                              (json_int_t)results->runs->len, "failed", (json_int_t)results->failed,
                              "missing", (json_int_t)results->missing));
    for (unsigned i = 0; i < results->runs->len; i++)
        for (unsigned k = 0; k < study->measures_count; k++)
            add_line(lines, value_json(results, i, k));
    for (size_t g = 0; g < results->groups; g++)
        for (unsigned k = 0; k < study->measures_count; k++)
            add_line(lines, order_json(results, g, k));
    return g_string_free(lines, FALSE);
}
