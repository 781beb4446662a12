/* Results as CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/csv.h"
#include "verification/common/failure.h"
#include "verification/common/rows.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

struct header {
    enum score_column column[SCORE_COLUMNS * 4]; /* SCORE_COLUMNS: not read */
    size_t count;
};

/* "velocity_x [mm/ms]" in its parts; `unit` is NULL without brackets. */
static char *split_unit(char *cell, char **unit)
{
    char *open = strchr(cell, '['), *close = strrchr(cell, ']');
    *unit = NULL;
    if (open != NULL && close > open) {
        *close = '\0';
        *open = '\0';
        *unit = g_strstrip(open + 1);
    }
    return g_strstrip(cell);
}

static enum mpm_status read_name(const char *place, const struct score_format *format, char *cell,
                                 struct header *header, struct score_table *table,
                                 struct mpm_error *error)
{
    char *unit;
    const char *name = split_unit(cell, &unit);
    const enum score_column column = score_column_find(name, format->geometry);
    if (header->count == G_N_ELEMENTS(header->column))
        return failure_set(error, MPM_BAD_INPUT, "%s: more than %zu columns", place,
                           G_N_ELEMENTS(header->column));
    header->column[header->count++] = column;
    if (column == SCORE_COLUMNS) {
        score_table_unread(table, name);
        return MPM_OK;
    }
    if (score_table_has(table, column))
        return failure_set(error, MPM_BAD_INPUT, "%s: column %s is there twice", place, name);
    score_table_add(table, column);
    return unit == NULL ? MPM_OK : score_check_unit(format, column, unit, place, error);
}

/* What the lines of a file are read into. */
struct reading {
    const struct score_format *format;
    struct header header;
    struct score_table *table;
};

static enum mpm_status read_header(void *context, const struct csv_line *line,
                                   struct mpm_error *error)
{
    struct reading *const reading = context;
    for (size_t i = 0; i < line->count; i++)
        TRY(read_name(line->place, reading->format, line->cells[i], &reading->header,
                      reading->table, error));
    return MPM_OK;
}

static enum mpm_status read_row(void *context, const struct csv_line *line, struct mpm_error *error)
{
    struct reading *const reading = context;
    for (size_t i = 0; i < line->count; i++) {
        const enum score_column column = reading->header.column[i];
        double value;
        if (column == SCORE_COLUMNS)
            continue;
        if (!row_number(line->cells[i], &value) || !isfinite(value))
            return failure_set(error, MPM_BAD_INPUT, "%s: %s: \"%s\" is not a finite number",
                               line->place, score_column_name(column, reading->format->geometry),
                               line->cells[i]);
        g_array_append_val(reading->table->column[column], value);
    }
    reading->table->rows++;
    return MPM_OK;
}

enum mpm_status score_read_csv(const char *path, const struct score_format *format,
                               struct score_table *table, struct mpm_error *error)
{
    struct reading reading = {.format = format, .table = table};
    TRY(csv_read(path, read_header, read_row, &reading, error));
    return table->rows > 0 ? MPM_OK
                           : failure_set(error, MPM_BAD_INPUT, "%s: holds no row of numbers", path);
}
