/* A bundle of numbers, read, and the numbers that are scored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/numbers.h"

#include "verification/suite/failure.h"
#include "verification/suite/records.h"
#include "verification/suite/rows.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------------ results */

enum { NUMBER, VALUE, UNIT, CELLS };

static const char *const cell_names[CELLS] = {"number", "value", "unit"};

/* Where results are read. */
struct reading {
    const struct bundle *bundle;
    const char *path;
    size_t line;
    int place[CELLS]; /* of each cell in a line; -1: there is none */
    guint count;      /* cells of a line; 0 before the line of names */
    double *values;   /* NAN until read */
    GString *rows;
};

static enum mpm_status read_names(struct reading *reading, char **cells, struct mpm_error *error)
{
    reading->count = g_strv_length(cells);
    for (int c = 0; c < CELLS; c++) {
        reading->place[c] = -1;
        for (guint i = 0; i < reading->count; i++)
            if (strcmp(cells[i], cell_names[c]) == 0)
                reading->place[c] = (int)i;
    }
    if (reading->place[NUMBER] >= 0 && reading->place[VALUE] >= 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "%s:%zu: the first line names the columns number, value and, if you like, "
                       "unit",
                       reading->path, reading->line);
}

static void note_unread(const struct reading *reading, const char *name)
{
    char *note = g_strdup_printf("not read: %s", name);
    char *row = row_line(ROW_NOTE, "", note);
    g_string_append(reading->rows, row);
    g_free(row);
    g_free(note);
}

static enum mpm_status read_number(struct reading *reading, char **cells, struct mpm_error *error)
{
    const struct bundle *bundle = reading->bundle;
    const char *name = cells[reading->place[NUMBER]], *text = cells[reading->place[VALUE]];
    size_t i = 0;
    double value;
    while (i < bundle->criterion_count && strcmp(bundle->criteria[i].check.name, name) != 0)
        i++;
    if (i == bundle->criterion_count) {
        note_unread(reading, name);
        return MPM_OK;
    }
    if (!isnan(reading->values[i]))
        return failure_set(error, MPM_BAD_INPUT, "%s:%zu: %s is there twice", reading->path,
                           reading->line, name);
    if (!row_number(text, &value) || !isfinite(value))
        return failure_set(error, MPM_BAD_INPUT, "%s:%zu: %s: \"%s\" is not a finite number",
                           reading->path, reading->line, name, text);
    const char *unit = bundle->criteria[i].check.unit;
    if (reading->place[UNIT] >= 0 && strcmp(cells[reading->place[UNIT]], unit) != 0)
        return failure_set(error, MPM_BAD_INPUT, "%s:%zu: %s: unit \"%s\": allowed is \"%s\"",
                           reading->path, reading->line, name, cells[reading->place[UNIT]], unit);
    reading->values[i] = value;
    return MPM_OK;
}

static enum mpm_status read_line(struct reading *reading, const char *line, struct mpm_error *error)
{
    char **cells = g_strsplit(line, ",", -1);
    const guint count = g_strv_length(cells);
    enum mpm_status status = MPM_OK;
    for (guint i = 0; i < count; i++)
        g_strstrip(cells[i]);
    if (reading->count == 0)
        status = read_names(reading, cells, error);
    else if (count != reading->count)
        status = failure_set(error, MPM_BAD_INPUT, "%s:%zu: has %u cells, the line of names %u",
                             reading->path, reading->line, count, reading->count);
    else
        status = read_number(reading, cells, error);
    g_strfreev(cells);
    return status;
}

static enum mpm_status read_lines(struct reading *reading, const char *text,
                                  struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char **lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL && status == MPM_OK; line++) {
        reading->line++;
        g_strstrip(*line);
        if (**line != '\0' && **line != '#')
            status = read_line(reading, *line, error);
    }
    g_strfreev(lines);
    return status;
}

static enum mpm_status write_rows(const struct reading *reading, struct mpm_error *error)
{
    const struct bundle *bundle = reading->bundle;
    for (size_t i = 0; i < bundle->criterion_count; i++) {
        const struct case_check *check = &bundle->criteria[i].check;
        if (isnan(reading->values[i]))
            return failure_set(error, MPM_BAD_INPUT, "%s: has no number %s, in %s", reading->path,
                               check->name, check->unit);
        char *row = row_line_value(check->quantity, reading->values[i]);
        g_string_append(reading->rows, row);
        g_free(row);
    }
    char *end = row_line(ROW_END, "", "");
    g_string_append(reading->rows, end);
    g_free(end);
    return MPM_OK;
}

enum mpm_status numbers_rows(const struct bundle *bundle, const char *path, GString *rows,
                             struct mpm_error *error)
{
    char *text;
    if (!g_file_get_contents(path, &text, NULL, NULL))
        return failure_set(error, MPM_BAD_INPUT, "%s: cannot be read: allowed is a CSV file", path);
    struct reading reading = {.bundle = bundle,
                              .path = path,
                              .values = g_new(double, bundle->criterion_count),
                              .rows = rows};
    for (size_t i = 0; i < bundle->criterion_count; i++)
        reading.values[i] = (double)NAN;
    enum mpm_status status = read_lines(&reading, text, error);
    if (status == MPM_OK)
        status = write_rows(&reading, error);
    g_free(reading.values);
    g_free(text);
    return status;
}
