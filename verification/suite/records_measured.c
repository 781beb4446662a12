/* Records: the quantities of measurements.jsonl.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/records_make.h"

#include "verification/common/record.h"
#include "verification/common/rows.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* The unit that the case declares for a quantity; "" if it declares none. */
static const char *unit_of(const struct case_file *file, const char *quantity)
{
    for (unsigned i = 0; i < file->checks_count; i++)
        if (strcmp(file->checks[i].quantity, quantity) == 0)
            return file->checks[i].unit;
    const struct case_comparison *comparison = file->comparison;
    for (unsigned i = 0; comparison != NULL && i < comparison->columns_count; i++)
        if (comparison->columns[i].case_name == NULL &&
            strcmp(comparison->columns[i].quantity, quantity) == 0)
            return comparison->columns[i].unit;
    return "";
}

struct job_lines {
    const struct planned_job *job;
    json_t *lines;
    GHashTable *seen; /* quantities of this job */
};

/* The first of a name counts; the judge makes errors of others. */
static void add_line(struct job_lines *job, const char *quantity, const char *unit, double value,
                     const char *reason)
{
    if (!g_hash_table_add(job->seen, g_strdup(quantity)))
        return;
    json_t *object = json_object();
    json_object_set_new(object, "kind", json_string("measurement"));
    json_object_set_new(object, "family", record_text_of(job->job->entry->file->family));
    json_object_set_new(object, "case", record_text_of(job->job->entry->file->name));
    json_object_set_new(object, "variant", record_text_of(job->job->variant->name));
    json_object_set_new(object, "quantity", record_text_of(quantity));
    json_object_set_new(object, "unit", record_text_of(unit));
    json_object_set_new(object, "value", isfinite(value) ? json_real(value) : json_null());
    json_object_set_new(object, "reason", record_text_of(reason));
    json_array_append_new(job->lines, object);
}

static void add_number(struct job_lines *job, const char *quantity, const char *unit,
                       const char *text)
{
    double value;
    if (!row_number(text, &value))
        value = (double)NAN;
    char *reason =
        isfinite(value) ? g_strdup("") : g_strdup_printf("the program reported %s", text);
    add_line(job, quantity, unit, value, reason);
    g_free(reason);
}

static void add_row(struct job_lines *job, const struct row *row)
{
    const char *unit = unit_of(job->job->entry->file, row->name);
    switch (row->kind) {
    case ROW_VALUE:
        add_number(job, row->name, unit, row->text);
        break;
    case ROW_INCONCLUSIVE:
        add_line(job, row->name, unit, (double)NAN, row->text);
        break;
    case ROW_WORK:
        add_number(job, "particle_steps", "1", row->text);
        break;
    case ROW_PROCESSOR:
        add_number(job, "cpu_seconds", "s", row->text);
        break;
    case ROW_MEMORY:
        add_number(job, "peak_bytes", "byte", row->text);
        break;
    case ROW_SKIP:
    case ROW_NOTE:
    case ROW_SERIES:
    case ROW_FAILURE:
    case ROW_END:
    case ROW_KIND_COUNT:
        break;
    }
}

/* What a program that did not end well reported is no result: its outcome is in the record of the
 * run. */
static void add_job(json_t *lines, const struct planned_job *job, const struct job_result *result)
{
    unsigned bad_line;
    GArray *rows = rows_parse(result->rows, &bad_line);
    struct job_lines own = {job, lines,
                            g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL)};
    const bool good = rows != NULL && result->outcome == JOB_RETURNED && result->code == 0;
    for (unsigned i = 0; good && i < rows->len; i++)
        add_row(&own, &g_array_index(rows, struct row, i));
    if (good)
        add_line(&own, "seconds", "s", result->seconds, "");
    g_hash_table_unref(own.seen);
    if (rows != NULL)
        g_array_unref(rows);
}

json_t *measurement_records(const struct plan *plan, const struct job_result *results)
{
    json_t *lines = json_array();
    for (size_t i = 0; i < plan->job_count; i++)
        add_job(lines, &plan->jobs[i], &results[i]);
    return lines;
}
