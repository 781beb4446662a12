/* CSV files, line by line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/csv.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"

#include <string.h>

/* Some programs begin UTF-8 texts with it. */
#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

struct reading {
    csv_use *names, *row;
    void *context;
    const char *path;
    size_t line, columns; /* 0 before the line of names */
};

static enum mpm_status use_cells(struct reading *reading, const struct csv_line *line,
                                 struct mpm_error *error)
{
    if (reading->columns == 0) {
        reading->columns = line->count;
        return reading->names(reading->context, line, error);
    }
    if (line->count != reading->columns)
        return failure_set(error, MPM_BAD_INPUT, "%s: has %zu cells, the line of names %zu",
                           line->place, line->count, reading->columns);
    return reading->row(reading->context, line, error);
}

static enum mpm_status use_line(struct reading *reading, char *text, struct mpm_error *error)
{
    if (*text == '\0' || *text == '#')
        return MPM_OK;
    char *place = g_strdup_printf("%s:%zu", reading->path, reading->line);
    char **cells = g_strsplit(text, ",", -1);
    const struct csv_line line = {place, cells, g_strv_length(cells)};
    for (size_t i = 0; i < line.count; i++)
        g_strstrip(cells[i]);
    const enum mpm_status status = use_cells(reading, &line, error);
    g_strfreev(cells);
    g_free(place);
    return status;
}

/* In place: functions of strings would look through all the rest for each line. */
static enum mpm_status use_text(struct reading *reading, char *text, size_t length,
                                struct mpm_error *error)
{
    char *next;
    for (char *line =
             text + (g_str_has_prefix(text, BYTE_ORDER_MARK) ? strlen(BYTE_ORDER_MARK) : 0);
         line < text + length; line = next) {
        char *const end = memchr(line, '\n', (size_t)(text + length - line));
        next = end == NULL ? text + length : end + 1;
        reading->line++;
        if (memchr(line, '\0', (size_t)(next - line)) != NULL)
            return failure_set(error, MPM_BAD_INPUT, "%s:%zu: holds a NUL byte: allowed is text",
                               reading->path, reading->line);
        if (end != NULL)
            *end = '\0';
        TRY(use_line(reading, g_strstrip(line), error));
    }
    return MPM_OK;
}

enum mpm_status csv_read(const char *path, csv_use *names, csv_use *row, void *context,
                         struct mpm_error *error)
{
    struct reading reading = {.names = names, .row = row, .context = context, .path = path};
    char *text;
    size_t length;
    TRY(input_text(path, "a CSV file", &text, &length, error));
    enum mpm_status status = use_text(&reading, text, length, error);
    if (status == MPM_OK && reading.columns == 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: holds no line of names", path);
    g_free(text);
    return status;
}
