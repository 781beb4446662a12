/* The table of a comparison page.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/comparison_view.h"

#include "verification/common/names.h"

#include <math.h>
#include <string.h>

const json_t *comparison_declared(const json_t *entry)
{
    const json_t *declared = json_object_get(entry, "comparison");
    const bool any = json_array_size(json_object_get(declared, "columns")) > 0;
    return any ? declared : NULL; /* without a column there is nothing to compare */
}

/* ------------------------------------------------------------------- rows, columns */

static bool is_row(const json_t *declared, const char *variant)
{
    const json_t *globs = json_object_get(declared, "variants");
    bool found = json_array_size(globs) == 0;
    for (size_t i = 0; i < json_array_size(globs); i++) {
        const char *glob = json_string_value(json_array_get(globs, i));
        found = found || (glob != NULL && glob_matches(glob, variant));
    }
    return found;
}

static int compare_variants(const void *a, const void *b)
{
    return strcmp(record_text(*(json_t *const *)a, "variant"),
                  record_text(*(json_t *const *)b, "variant"));
}

static enum comparison_better better_find(const char *name)
{
    for (int better = COMPARISON_LOW; better < COMPARISON_ZERO; better++)
        if (strcmp(better_name((enum comparison_better)better), name) == 0)
            return (enum comparison_better)better;
    return COMPARISON_ZERO;
}

/* A number that an old or changed file lacks counts as none. */
static double number_or_zero(const json_t *object, const char *key)
{
    const double number = record_number(object, key);
    return number >= 0 ? number : 0.0;
}

static struct comparison_column column_of(const json_t *declared)
{
    return (struct comparison_column){
        .title = record_text(declared, "title"),
        .unit = record_text(declared, "unit"),
        .better = better_find(record_text(declared, "better")),
        .tolerance = number_or_zero(declared, "tolerance"),
        .floor = number_or_zero(declared, "floor"),
        .limited = isfinite(record_number(declared, "limit")),
        .limit = record_number(declared, "limit"),
        .beyond = record_text(declared, "beyond"),
        .missing = record_text(declared, "missing"),
    };
}

/* --------------------------------------------------------------------- cells */

static const json_t *find_by(const json_t *array, const char *key, const char *name)
{
    for (size_t i = 0; i < json_array_size(array); i++)
        if (strcmp(record_text(json_array_get(array, i), key), name) == 0)
            return json_array_get(array, i);
    return NULL;
}

/* Whether any variant of a case has a line of the quantity. */
static bool is_measured(const struct records *records, const char *name, const char *quantity)
{
    for (size_t i = 0; i < json_array_size(records->measurements); i++) {
        const json_t *line = json_array_get(records->measurements, i);
        if (strcmp(record_text(line, "case"), name) == 0 &&
            strcmp(record_text(line, "quantity"), quantity) == 0)
            return true;
    }
    return false;
}

/* "timed out", "failed: the last line of its log" */
static char *failure_of(const json_t *variant)
{
    char *log = g_strdup(record_text(variant, "log_tail"));
    const char *last = strrchr(g_strchomp(log), '\n');
    last = last == NULL ? log : last + 1;
    char *text = g_strconcat("the run ", record_text(variant, "outcome"), *last == '\0' ? "" : ": ",
                             last, NULL);
    g_free(log);
    return text;
}

/* Why there is no line of the quantity, and whether that counts as a failure. */
static char *absence(const struct records *records, const char *name, const json_t *variant,
                     const char *quantity, enum comparison_state *state)
{
    *state = COMPARISON_ABSENT;
    if (records->measurements == NULL)
        return g_strdup("this folder holds no measurements.jsonl");
    if (find_by(json_object_get(records->run, "cases"), "case", name) == NULL)
        return g_strdup_printf("case %s was not part of this run", name);
    if (variant == NULL)
        return g_strdup_printf("case %s did not run it", name);
    const bool returned = strcmp(record_text(variant, "outcome"), "returned") == 0;
    if (returned && !is_measured(records, name, quantity))
        return g_strdup_printf("case %s measures no %s", name, quantity);
    *state = COMPARISON_FAILED;
    return returned ? g_strdup_printf("%s was not reported", quantity) : failure_of(variant);
}

static struct comparison_cell cell_of(struct comparison_view *view, const struct records *records,
                                      const char *name, const char *variant, const char *quantity)
{
    char *key = g_strjoin("/", name, quantity, variant, NULL); /* as record_key has it */
    const json_t *line = g_hash_table_lookup(view->lines, key);
    g_free(key);
    const double value = record_number(line, "value");
    if (isfinite(value))
        return (struct comparison_cell){COMPARISON_NUMBER, value, ""};
    const json_t *entry = find_by(json_object_get(records->run, "cases"), "case", name);
    const json_t *own = find_by(json_object_get(entry, "variants"), "variant", variant);
    enum comparison_state state = COMPARISON_FAILED;
    char *reason = line != NULL ? g_strdup(record_text(line, "reason"))
                                : absence(records, name, own, quantity, &state);
    g_ptr_array_add(view->reasons, reason);
    return (struct comparison_cell){state, (double)NAN, reason};
}

static void fill_cells(struct comparison_view *view, const struct records *records,
                       const char *own_case)
{
    const json_t *columns = json_object_get(view->declared, "columns");
    for (size_t row = 0; row < view->table.row_count; row++)
        for (size_t column = 0; column < view->table.column_count; column++) {
            const json_t *declared = json_array_get(columns, column);
            const char *other = record_text(declared, "case");
            view->cells[row * view->table.column_count + column] =
                cell_of(view, records, *other == '\0' ? own_case : other, view->names[row],
                        record_text(declared, "quantity"));
        }
}

/* A run that ended early is not cheap: takes out the numbers of a column where another one is
 * behind its best. */
static void take_out(struct comparison_view *view, size_t column, size_t condition)
{
    const struct comparison_table *table = &view->table;
    const size_t best = comparison_best(table, condition);
    for (size_t row = 0; best != COMPARISON_NONE && row < table->row_count; row++) {
        struct comparison_cell *cell = &view->cells[row * table->column_count + column];
        if (cell->state != COMPARISON_NUMBER ||
            comparison_order(&view->columns[condition], comparison_cell(table, best, condition),
                             comparison_cell(table, row, condition)) >= 0)
            continue;
        char *reason = g_strdup_printf("it fell behind in %s", view->columns[condition].title);
        g_ptr_array_add(view->reasons, reason);
        *cell = (struct comparison_cell){COMPARISON_FAILED, (double)NAN, reason};
    }
}

static void take_out_all(struct comparison_view *view)
{
    const json_t *columns = json_object_get(view->declared, "columns");
    for (size_t column = 0; column < view->table.column_count; column++) {
        const json_t *declared = json_array_get(columns, column);
        const size_t condition = comparison_view_column(view, record_text(declared, "where"));
        if (condition != COMPARISON_NONE)
            take_out(view, column, condition);
    }
}

struct comparison_view comparison_view_make(const struct records *records, const json_t *entry)
{
    const json_t *variants = json_object_get(entry, "variants");
    struct comparison_view view = {.declared = comparison_declared(entry), .records = records};
    const json_t *columns = json_object_get(view.declared, "columns");
    const size_t most = json_array_size(variants), column_count = json_array_size(columns);
    size_t rows = 0;
    view.variants = g_new0(const json_t *, most + 1);
    view.names = g_new0(const char *, most + 1);
    view.columns = g_new0(struct comparison_column, column_count + 1);
    view.cells = g_new0(struct comparison_cell, most * column_count + 1);
    view.reasons = g_ptr_array_new_with_free_func(g_free);
    view.lines = record_index(records->measurements, "quantity");
    for (size_t i = 0; i < most; i++) {
        const json_t *variant = json_array_get(variants, i);
        if (is_row(view.declared, record_text(variant, "variant")))
            view.variants[rows++] = variant;
    }
    qsort(view.variants, rows, sizeof(void *), compare_variants);
    for (size_t row = 0; row < rows; row++)
        view.names[row] = record_text(view.variants[row], "variant");
    for (size_t column = 0; column < column_count; column++)
        view.columns[column] = column_of(json_array_get(columns, column));
    view.table =
        (struct comparison_table){rows, column_count, view.names, view.columns, view.cells};
    fill_cells(&view, records, record_text(entry, "case"));
    take_out_all(&view);
    return view;
}

void comparison_view_clear(struct comparison_view *view)
{
    g_free(view->variants);
    g_free(view->names);
    g_free(view->columns);
    g_free(view->cells);
    g_ptr_array_unref(view->reasons);
    g_hash_table_unref(view->lines);
    *view = (struct comparison_view){.declared = NULL};
}

size_t comparison_view_column(const struct comparison_view *view, const char *quantity)
{
    const json_t *columns = json_object_get(view->declared, "columns");
    for (size_t column = 0; column < view->table.column_count; column++)
        if (strcmp(record_text(json_array_get(columns, column), "quantity"), quantity) == 0)
            return column;
    return COMPARISON_NONE;
}

size_t comparison_view_main(const struct comparison_view *view)
{
    const size_t column = comparison_view_column(view, record_text(view->declared, "main"));
    return column == COMPARISON_NONE && view->table.column_count > 0 ? 0 : column;
}

size_t comparison_view_cost(const struct comparison_view *view)
{
    const char *declared = record_text(view->declared, "cost");
    const size_t column = comparison_view_column(
        view, *declared == '\0' ? record_text(view->declared, "pareto_x") : declared);
    return column == comparison_view_main(view) ? COMPARISON_NONE : column;
}

bool comparison_view_has_part(const char *variant, const json_t *part)
{
    char **names = g_strsplit(variant, "_", -1);
    bool found = false;
    for (char **name = names; !found && *name != NULL; name++)
        found = glob_matches(record_text(part, "part"), *name);
    g_strfreev(names);
    return found;
}

const json_t *comparison_view_part(const struct comparison_view *view, const char *variant,
                                   const char *kind)
{
    const json_t *parts = json_object_get(view->declared, "parts");
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        if (strcmp(record_text(part, "kind"), kind) == 0 && comparison_view_has_part(variant, part))
            return part;
    }
    return NULL;
}
