/* A bundle of numbers, read, and the numbers that are scored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/numbers.h"

#include "verification/common/csv.h"
#include "verification/common/failure.h"
#include "verification/common/rows.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------------ results */

enum { NUMBER, VALUE, UNIT, CELLS };

static const char *const cell_names[CELLS] = {"number", "value", "unit"};

/* Names that the bundle does not have and the report lists. */
enum { UNREAD_LISTED = 20 };

/* What the lines of the results are read into. */
struct reading {
    const struct bundle *bundle;
    const char *path;
    int place[CELLS]; /* of each cell in a line; -1: there is none */
    double *values;   /* NAN until read */
    size_t unread;
    GString *rows;
};

static enum mpm_status read_names(void *context, const struct csv_line *line,
                                  struct mpm_error *error)
{
    struct reading *const reading = context;
    for (int c = 0; c < CELLS; c++) {
        reading->place[c] = -1;
        for (size_t i = 0; i < line->count; i++) {
            if (strcmp(line->cells[i], cell_names[c]) != 0)
                continue;
            if (reading->place[c] >= 0)
                return failure_set(error, MPM_BAD_INPUT, "%s: column %s is there twice",
                                   line->place, cell_names[c]);
            reading->place[c] = (int)i;
        }
    }
    if (reading->place[NUMBER] >= 0 && reading->place[VALUE] >= 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "%s: begins with \"%s\": allowed is a line with the names number, value "
                       "and, if you like, unit",
                       line->place, line->cells[0]);
}

static void add_note(const struct reading *reading, const char *what, const char *name)
{
    char *note = g_strconcat(what, name, NULL);
    char *row = row_line(ROW_NOTE, "", note);
    g_string_append(reading->rows, row);
    g_free(row);
    g_free(note);
}

static enum mpm_status read_number(void *context, const struct csv_line *line,
                                   struct mpm_error *error)
{
    struct reading *const reading = context;
    const struct bundle *const bundle = reading->bundle;
    const char *name = line->cells[reading->place[NUMBER]];
    const char *text = line->cells[reading->place[VALUE]];
    size_t i = 0;
    double value;
    while (i < bundle->criterion_count && strcmp(bundle->criteria[i].check.name, name) != 0)
        i++;
    if (i == bundle->criterion_count) {
        if (++reading->unread <= UNREAD_LISTED)
            add_note(reading, "not read: ", name);
        return MPM_OK;
    }
    if (!isnan(reading->values[i]))
        return failure_set(error, MPM_BAD_INPUT, "%s: %s is there twice", line->place, name);
    if (!row_number(text, &value) || !isfinite(value))
        return failure_set(error, MPM_BAD_INPUT, "%s: %s: \"%s\" is not a finite number",
                           line->place, name, text);
    const char *const wanted = bundle->criteria[i].check.unit;
    const char *const unit = reading->place[UNIT] >= 0 ? line->cells[reading->place[UNIT]] : wanted;
    if (strcmp(unit, wanted) != 0)
        return failure_set(error, MPM_BAD_INPUT, "%s: %s: unit \"%s\": allowed is \"%s\"",
                           line->place, name, unit, wanted);
    reading->values[i] = value;
    return MPM_OK;
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
    if (reading->unread > UNREAD_LISTED) {
        char *more = g_strdup_printf("%zu", reading->unread - UNREAD_LISTED);
        add_note(reading, "not read, and not listed: ", more);
        g_free(more);
    }
    char *end = row_line(ROW_END, "", "");
    g_string_append(reading->rows, end);
    g_free(end);
    return MPM_OK;
}

enum mpm_status numbers_rows(const struct bundle *bundle, const char *path, GString *rows,
                             struct mpm_error *error)
{
    struct reading reading = {.bundle = bundle,
                              .path = path,
                              .values = g_new(double, bundle->criterion_count),
                              .rows = rows};
    for (size_t i = 0; i < bundle->criterion_count; i++)
        reading.values[i] = (double)NAN;
    enum mpm_status status = csv_read(path, read_names, read_number, &reading, error);
    if (status == MPM_OK)
        status = write_rows(&reading, error);
    g_free(reading.values);
    return status;
}
