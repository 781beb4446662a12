/* Results as CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/readers.h"
#include "verification/suite/failure.h"
#include "verification/suite/rows.h"

#include <math.h>
#include <string.h>

/* Some programs begin UTF-8 texts with it. */
#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

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

static enum mpm_status read_header(const char *place, const struct score_format *format,
                                   const char *line, struct header *header,
                                   struct score_table *table, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char **cells = g_strsplit(line, ",", -1);
    for (char **cell = cells; *cell != NULL && status == MPM_OK; cell++)
        status = read_name(place, format, *cell, header, table, error);
    g_strfreev(cells);
    return status;
}

static enum mpm_status read_row(const char *place, const struct score_format *format,
                                const char *line, const struct header *header,
                                struct score_table *table, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char **cells = g_strsplit(line, ",", -1);
    const size_t count = g_strv_length(cells);
    if (count != header->count)
        status = failure_set(error, MPM_BAD_INPUT, "%s: has %zu cells, the line of names %zu",
                             place, count, header->count);
    for (size_t i = 0; status == MPM_OK && i < count; i++) {
        double value;
        if (header->column[i] == SCORE_COLUMNS)
            continue;
        if (!row_number(g_strstrip(cells[i]), &value) || !isfinite(value))
            status =
                failure_set(error, MPM_BAD_INPUT, "%s: %s: \"%s\" is not a finite number", place,
                            score_column_name(header->column[i], format->geometry), cells[i]);
        else
            g_array_append_val(table->column[header->column[i]], value);
    }
    table->rows += status == MPM_OK;
    g_strfreev(cells);
    return status;
}

enum mpm_status score_read_csv(const char *path, const struct score_format *format,
                               struct score_table *table, struct mpm_error *error)
{
    char *text;
    size_t length;
    if (!g_file_get_contents(path, &text, &length, NULL))
        return failure_set(error, MPM_BAD_INPUT, "%s: cannot be read", path);
    struct header header = {.count = 0};
    enum mpm_status status = MPM_OK;
    size_t number = 0;
    char *next;
    /* line by line in place: functions of strings would look through all the rest each time */
    for (char *line =
             text + (g_str_has_prefix(text, BYTE_ORDER_MARK) ? strlen(BYTE_ORDER_MARK) : 0);
         status == MPM_OK && line < text + length; line = next) {
        char *end = memchr(line, '\n', (size_t)(text + length - line));
        next = end == NULL ? text + length : end + 1;
        if (end != NULL)
            *end = '\0';
        number++;
        line = g_strstrip(line);
        if (*line == '\0' || *line == '#')
            continue;
        char *place = g_strdup_printf("%s:%zu", path, number);
        status = header.count == 0 ? read_header(place, format, line, &header, table, error)
                                   : read_row(place, format, line, &header, table, error);
        g_free(place);
    }
    g_free(text);
    if (status == MPM_OK && table->rows == 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: holds no row of numbers", path);
    return status;
}
