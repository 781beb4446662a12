/* A CSV file of numbers as columns with names: history.csv, and curves of references.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_TABLE_NAMED_H
#define VERIFICATION_PROGRAMS_TABLE_NAMED_H

#include "verification/common/failure.h"

#include <glib.h>

struct table_named {
    GPtrArray *names;
    GPtrArray *columns; /* GArray of double, one for each name */
    size_t rows;
};

/* MPM_BAD_INPUT: as csv_read, and cells that are no numbers. Release with table_named_clear, after
 * a failure as well. */
enum mpm_status table_named_read(const char *path, struct table_named *table,
                                 struct mpm_error *error);
void table_named_clear(struct table_named *table);

/* The values of a column, or NULL. */
const double *table_named_column(const struct table_named *table, const char *name);
/* The names, "time, step, ..."; g_free. */
char *table_named_list(const struct table_named *table);

#endif
