/* A table of the report: one set of cells, shown as HTML that sorts and written as CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_REPORT_TABLE_H
#define VERIFICATION_REPORT_REPORT_TABLE_H

#include "verification/measures/verdict.h"

#include <glib.h>
#include <stdbool.h>

struct report_column {
    const char *title;
    const char *unit; /* in the heading; NULL where it differs by row or is none */
    enum report_cells { CELLS_TEXT, CELLS_WIDE, CELLS_NUMBER, CELLS_BAND } cells;
    bool falling; /* the first press sorts from the largest down */
};

struct report_table;

/* An empty table; `columns` must outlive it. The cells of the first column name their rows. */
struct report_table *report_table_new(const struct report_column *columns, size_t count);
void report_table_free(struct report_table *table);
size_t report_table_rows(const struct report_table *table);

/* Each adds the next cell; a row ends when it has one for each column. Texts are escaped. */
void report_table_text(struct report_table *table, const char *text);
/* A name, which may break after its underscores; the second links it. */
void report_table_name(struct report_table *table, const char *text);
void report_table_link(struct report_table *table, const char *href, const char *text);
/* A mark and a word, of the colour of a class of report.css; sorted by the word. */
void report_table_state(struct report_table *table, const char *class, const char *mark,
                        const char *word);
void report_table_status(struct report_table *table, enum verdict_status status);
/* A number, shown as the text (taken over), sorted and written by its value. */
void report_table_number(struct report_table *table, double value, char *shown);
/* Markup (taken over) for a value, or for a text that CSV and sorting take. */
void report_table_value(struct report_table *table, double value, GString *markup);
void report_table_markup(struct report_table *table, const char *text, GString *markup);

/* Puts whole rows in alphabetical order of the texts of their first cells, then of their second. */
void report_table_sort(struct report_table *table);

/* Appends the table with its caption, in a box that scrolls, and the link of the CSV file `csv`. */
void report_table_html(const struct report_table *table, const char *caption, const char *csv,
                       GString *html);

/* The same cells as CSV of RFC 4180, numbers with all digits; g_free. */
char *report_table_csv(const struct report_table *table);

/* Appends a text in quotes by RFC 4180. */
void report_csv_text(GString *csv, const char *text);

#endif
