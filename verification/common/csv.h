/* CSV files, line by line: a line of names, then rows.
 *
 * Lines that begin with `#`, empty ones, a byte order mark and carriage returns are passed over;
 * cells are without blanks around them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_CSV_H
#define VERIFICATION_COMMON_CSV_H

#include "mpm.h"

#include <glib.h>

struct csv_line {
    const char *place; /* "results.csv:3", for messages */
    char **cells;      /* NULL ends them; may be written to */
    size_t count;
};

/* What is done with a line. */
typedef enum mpm_status csv_use(void *context, const struct csv_line *line,
                                struct mpm_error *error);

/* MPM_BAD_INPUT: the file cannot be read, holds a NUL byte or no line of names, or a row has not as
 * many cells as there are names; or what `names` or `row` returns. */
enum mpm_status csv_read(const char *path, csv_use *names, csv_use *row, void *context,
                         struct mpm_error *error);

#endif
