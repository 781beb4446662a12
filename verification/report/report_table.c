/* Tables of the report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/report_table.h"

#include "verification/pages/html.h"
#include "verification/report/verdict_html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct cell {
    char *text; /* CSV; NULL for a number */
    double value;
    bool is_number, is_keyed; /* sorted by the value */
    char *markup;
};

struct report_table {
    const struct report_column *columns;
    size_t count;
    GArray *cells; /* row by row */
};

static void clear_cell(void *element)
{
    struct cell *cell = element;
    g_free(cell->text);
    g_free(cell->markup);
}

struct report_table *report_table_new(const struct report_column *columns, size_t count)
{
    struct report_table *table = g_new0(struct report_table, 1);
    table->columns = columns;
    table->count = count;
    table->cells = g_array_new(FALSE, TRUE, sizeof(struct cell));
    g_array_set_clear_func(table->cells, clear_cell);
    return table;
}

void report_table_free(struct report_table *table)
{
    g_array_unref(table->cells);
    g_free(table);
}

size_t report_table_rows(const struct report_table *table)
{
    return table->count == 0 ? 0 : table->cells->len / table->count;
}

/* ---------------------------------------------------------------------- cells */

void report_table_markup(struct report_table *table, const char *text, GString *markup)
{
    struct cell cell = {.text = g_strdup(text), .markup = g_string_free(markup, FALSE)};
    g_array_append_val(table->cells, cell);
}

void report_table_text(struct report_table *table, const char *text)
{
    GString *markup = g_string_new(NULL);
    html_numbers(markup, g_strdup(text));
    report_table_markup(table, text, markup);
}

void report_table_link(struct report_table *table, const char *href, const char *text)
{
    GString *markup = g_string_new(NULL);
    text_markup(markup, "<a href=\"%s\">", href);
    html_name(markup, text);
    g_string_append(markup, "</a>");
    report_table_markup(table, text, markup);
}

void report_table_name(struct report_table *table, const char *text)
{
    GString *markup = g_string_new(NULL);
    html_name(markup, text);
    report_table_markup(table, text, markup);
}

void report_table_state(struct report_table *table, const char *class, const char *mark,
                        const char *word)
{
    GString *markup = g_string_new(NULL);
    html_state(markup, class, mark, word);
    report_table_markup(table, word, markup);
}

void report_table_status(struct report_table *table, enum verdict_status status)
{
    GString *markup = g_string_new(NULL);
    html_status(markup, status);
    struct cell cell = {.text = g_strdup(verdict_status_name(status)),
                        .value = html_status_rank(status),
                        .is_keyed = true,
                        .markup = g_string_free(markup, FALSE)};
    g_array_append_val(table->cells, cell);
}

void report_table_value(struct report_table *table, double value, GString *markup)
{
    struct cell cell = {.value = value,
                        .is_number = true,
                        .is_keyed = true,
                        .markup = g_string_free(markup, FALSE)};
    g_array_append_val(table->cells, cell);
}

void report_table_number(struct report_table *table, double value, char *shown)
{
    GString *markup = g_string_new(NULL);
    html_numbers(markup, shown);
    report_table_value(table, value, markup);
}

static int compare_rows(const void *a, const void *b)
{
    const struct cell *one = *(const struct cell *const *)a;
    const struct cell *other = *(const struct cell *const *)b;
    const int names = g_strcmp0(one[0].text, other[0].text);
    const int seconds = names != 0 ? names : g_strcmp0(one[1].text, other[1].text);
    /* else as they were: rows lie in one array */
    return seconds != 0 ? seconds : (one > other) - (one < other);
}

void report_table_sort(struct report_table *table)
{
    const size_t rows = report_table_rows(table), count = table->count;
    const struct cell **order = g_new(const struct cell *, rows + 1);
    GArray *sorted = g_array_sized_new(FALSE, TRUE, sizeof(struct cell), table->cells->len);
    for (size_t row = 0; row < rows; row++)
        order[row] = &g_array_index(table->cells, struct cell, row * count);
    qsort(order, rows, sizeof(void *), compare_rows);
    for (size_t row = 0; row < rows; row++)
        g_array_append_vals(sorted, order[row], (guint)count);
    g_array_set_clear_func(table->cells, NULL); /* the texts have moved */
    g_array_unref(table->cells);
    g_array_set_clear_func(sorted, clear_cell);
    table->cells = sorted;
    g_free(order);
}

/* ----------------------------------------------------------------------- HTML */

static void add_heading(GString *html, const struct report_column *column)
{
    g_string_append(html, column->cells == CELLS_NUMBER ? "<th scope=\"col\" class=\"n\""
                                                        : "<th scope=\"col\"");
    g_string_append(html, column->falling ? " data-first=\"descending\">" : ">");
    text_markup(html, "%s", column->title);
    if (column->unit != NULL && strcmp(column->unit, "1") != 0)
        text_markup(html, " <span class=\"unit\">%s</span>", column->unit);
    g_string_append(html, "</th>");
}

static void add_cell(GString *html, const struct cell *cell, const struct report_column *column,
                     bool first)
{
    static const char *const classes[] = {[CELLS_TEXT] = "",
                                          [CELLS_WIDE] = " class=\"wide\"",
                                          [CELLS_BAND] = " class=\"band\"",
                                          [CELLS_NUMBER] = " class=\"n\""};
    char key[G_ASCII_DTOSTR_BUF_SIZE] = "";
    if (isfinite(cell->value))
        g_ascii_formatd(key, sizeof key, "%.17g", cell->value);
    g_string_append(html, first ? "<th scope=\"row\"" : "<td");
    g_string_append(html, classes[column->cells]);
    if (cell->is_keyed)
        g_string_append_printf(html, " data-key=\"%s\"", key);
    g_string_append_printf(html, ">%s%s", cell->markup, first ? "</th>" : "</td>");
}

/* Longer tables scroll in a box, under their headings. */
enum { SHOWN_WHOLE = 40 };

void report_table_html(const struct report_table *table, const char *caption, const char *csv,
                       GString *html)
{
    text_markup(html,
                "<div class=\"scroll%s\" tabindex=\"0\" role=\"region\" aria-label=\"%s\">"
                "<table class=\"sortable data\">\n<caption>%s</caption>\n<thead><tr>",
                report_table_rows(table) > SHOWN_WHOLE ? " tall" : "", caption, caption);
    for (size_t i = 0; i < table->count; i++)
        add_heading(html, &table->columns[i]);
    g_string_append(html, "</tr></thead>\n<tbody>\n");
    for (size_t row = 0; row < report_table_rows(table); row++) {
        g_string_append(html, "<tr>");
        for (size_t i = 0; i < table->count; i++)
            add_cell(html, &g_array_index(table->cells, struct cell, row * table->count + i),
                     &table->columns[i], i == 0);
        g_string_append(html, "</tr>\n");
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
    if (csv != NULL)
        text_markup(html, "<p class=\"csv\"><a href=\"%s\">%s</a></p>\n", csv, csv);
}

/* ------------------------------------------------------------------------ CSV */

void report_csv_text(GString *csv, const char *text)
{
    g_string_append_c(csv, '"');
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"')
            g_string_append_c(csv, '"');
        g_string_append_c(csv, *c);
    }
    g_string_append_c(csv, '"');
}

static void add_csv_cell(GString *csv, const struct cell *cell)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    if (!cell->is_number)
        report_csv_text(csv, cell->text);
    else if (isfinite(cell->value)) /* else empty */
        g_string_append(csv, g_ascii_formatd(number, sizeof number, "%.17g", cell->value));
}

char *report_table_csv(const struct report_table *table)
{
    GString *csv = g_string_new(NULL);
    for (size_t i = 0; i < table->count; i++) {
        const struct report_column *column = &table->columns[i];
        char *title = column->unit == NULL
                          ? g_strdup(column->title)
                          : g_strdup_printf("%s (%s)", column->title, column->unit);
        g_string_append(csv, i == 0 ? "" : ",");
        report_csv_text(csv, title);
        g_free(title);
    }
    for (size_t row = 0; row < report_table_rows(table); row++)
        for (size_t i = 0; i < table->count; i++) {
            g_string_append(csv, i == 0 ? "\r\n" : ",");
            add_csv_cell(csv, &g_array_index(table->cells, struct cell, row * table->count + i));
        }
    g_string_append(csv, "\r\n");
    return g_string_free(csv, FALSE);
}
