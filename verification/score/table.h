/* A table of material points at instants: what a bundle's reference and a solver's results are read
 * into.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_TABLE_H
#define VERIFICATION_SCORE_TABLE_H

#include "verification/score/columns.h"

#include <glib.h>
#include <stdbool.h>

struct score_table {
    GArray *column[SCORE_COLUMNS]; /* of double; NULL: the results do not have it */
    size_t rows;
    GPtrArray *unread; /* names that are none of the columns; reported, never judged */
};

/* Input and output of the readers of files. */
struct score_format {
    enum mpm_geometry geometry;
    struct score_units units;
    int body; /* whose rows are used where the results have a column of bodies */
};

void score_table_open(struct score_table *table);
void score_table_close(struct score_table *table);

/* Whether the table has the column. */
bool score_table_has(const struct score_table *table, enum score_column column);
double score_table_value(const struct score_table *table, enum score_column column, size_t row);

/* Adds the column if it is not there yet; its values, `rows` of them, zeros where there were none.
 */
double *score_table_add(struct score_table *table, enum score_column column);

/* Adds the name of a column that is not read, once. */
void score_table_unread(struct score_table *table, const char *name);

/* Appends the rows of `more`, which must have the same columns: MPM_BAD_INPUT with `path` and the
 * column that is in one alone. The first table that is appended sets the columns. */
enum mpm_status score_table_append(struct score_table *table, const struct score_table *more,
                                   enum mpm_geometry geometry, const char *path,
                                   struct mpm_error *error);

/* The unit that a file gives for a column must be the problem's: MPM_BAD_INPUT else, beginning with
 * `place`. */
enum mpm_status score_check_unit(const struct score_format *format, enum score_column column,
                                 const char *unit, const char *place, struct mpm_error *error);

#endif
