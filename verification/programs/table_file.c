/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/table_file.h"

#include "verification/common/input.h"
#include "verification/common/resources.h"
#include "verification/common/rows.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Of the fields of one line; false: not as many finite numbers as there are columns. */
static bool read_row(const char *line, size_t columns, double *row)
{
    char **const fields = g_strsplit(line, ",", -1);
    bool good = g_strv_length(fields) == columns;
    for (size_t k = 0; good && k < columns; k++)
        good = row_number(fields[k], &row[k]) && isfinite(row[k]);
    g_strfreev(fields);
    return good;
}

static enum mpm_status read_lines(char **lines, struct table_file *table, struct mpm_error *error)
{
    for (size_t k = 0; lines[k] != NULL; k++) {
        const char *const line = g_strchomp(lines[k]);
        if (*line == '#' || *line == '\0')
            continue;
        if (table->names == NULL) {
            table->names = g_strsplit(line, ",", -1);
            table->columns = g_strv_length(table->names);
            table->values = g_new(double, table->columns *g_strv_length(lines));
        } else if (!read_row(line, table->columns, &table->values[table->columns * table->rows++]))
            return failure_set(error, MPM_BAD_INPUT,
                               "%s:%zu: \"%s\": allowed are %zu finite numbers", table->path, k + 1,
                               line, table->columns);
    }
    if (table->rows == 0)
        return failure_set(error, MPM_BAD_INPUT, "%s: no rows of numbers", table->path);
    return MPM_OK;
}

enum mpm_status table_file_read(const char *file, struct table_file *table, struct mpm_error *error)
{
    char *text = NULL;
    char *const folder = resources_reference_data("mpm-verify");
    *table = (struct table_file){
        .path = g_build_filename(folder == NULL ? "reference_data" : folder, file, NULL)};
    g_free(folder);
    TRY(input_text(table->path, NULL, &text, NULL, error));
    char **const lines = g_strsplit(text, "\n", -1);
    const enum mpm_status status = read_lines(lines, table, error);
    g_strfreev(lines);
    g_free(text);
    return status;
}

void table_file_free(struct table_file *table)
{
    g_free(table->path);
    g_strfreev(table->names);
    g_free(table->values);
}

enum mpm_status table_file_column(const struct table_file *table, const char *name, size_t *column,
                                  struct mpm_error *error)
{
    for (*column = 0; *column < table->columns; (*column)++)
        if (strcmp(table->names[*column], name) == 0)
            return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "%s: no column \"%s\"", table->path, name);
}
