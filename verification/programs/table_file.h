/* Tables of numbers from reference_data: CSV with a line of names, comments from `#` on before it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_TABLE_FILE_H
#define VERIFICATION_PROGRAMS_TABLE_FILE_H

#include "verification/common/failure.h"

#include <stddef.h>

struct table_file {
    char *path;
    char **names; /* of the columns, NULL at the end */
    size_t columns, rows;
    double *values; /* values[row * columns + column] */
};

/* Reads reference_data/`file`, where resources.h finds that folder. MPM_BAD_INPUT, with file and
 * line: no such file, a row of another length than the names, or something that is no finite
 * number. Free it in any case. */
enum mpm_status table_file_read(const char *file, struct table_file *table,
                                struct mpm_error *error);
void table_file_free(struct table_file *table);

/* The place of the column `name`. MPM_BAD_INPUT if there is none. */
enum mpm_status table_file_column(const struct table_file *table, const char *name, size_t *column,
                                  struct mpm_error *error);

#endif
