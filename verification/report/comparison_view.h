/* The table of a comparison page, from the records of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_COMPARISON_VIEW_H
#define VERIFICATION_REPORT_COMPARISON_VIEW_H

#include "verification/measures/comparison/comparison.h"
#include "verification/records/records.h"

#include <glib.h>

struct comparison_view {
    struct comparison_table table; /* rows in alphabetical order */
    const json_t **variants;       /* records of the rows */
    const json_t *declared;        /* of the comparison */
    const struct records *records; /* of the run */
    /* memory of the table */
    const char **names;
    struct comparison_column *columns;
    struct comparison_cell *cells;
    GPtrArray *reasons;
    GHashTable *lines; /* measurements by record_key */
};

/* `entry` is an object of the run's cases with a comparison. */
struct comparison_view comparison_view_make(const struct records *records, const json_t *entry);
void comparison_view_clear(struct comparison_view *view);

/* The comparison that a case declares; NULL if there is none. */
const json_t *comparison_declared(const json_t *entry);

/* Place of the column of a quantity; COMPARISON_NONE if there is none. */
size_t comparison_view_column(const struct comparison_view *view, const char *quantity);

/* The column that decides which variant to use, and that of costs; COMPARISON_NONE if there is
 * none. */
size_t comparison_view_main(const struct comparison_view *view);
size_t comparison_view_cost(const struct comparison_view *view);

/* Whether a part of the variant's name is that one, an object of the comparison's parts. */
bool comparison_view_has_part(const char *variant, const json_t *part);

/* What a part of the variant's name of that kind means, as methods.yaml had it; NULL if its name
 * has none. */
const json_t *comparison_view_part(const struct comparison_view *view, const char *variant,
                                   const char *kind);

/* Appends the cell of a number, with what it sorts by and `words` below it (freed), marked as bad
 * or not. */
void comparison_cell_html(GString *html, const struct comparison_table *table, size_t row,
                          size_t column, bool bad, char *words);

/* Appends the table, the CSV's link, what the columns and the parts of names mean. */
void comparison_table_html(GString *html, const struct comparison_view *view);

#endif
