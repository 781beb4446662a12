/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/console_cases.h"

#include "verification/records/records.h"

#include <string.h>

struct console_cases *console_cases_make(const struct plan *plan)
{
    struct console_cases *const cases = g_new0(struct console_cases, 1);
    cases->rows = g_new0(struct console_case, plan->job_count + 1);
    cases->row_of = g_new0(size_t, plan->job_count + 1);
    cases->weight_of = g_new0(double, plan->job_count + 1);
    for (size_t i = 0; i < plan->job_count; i++) {
        const char *const name = plan->jobs[i].entry->file->name;
        size_t row = 0;
        while (row < cases->count && strcmp(cases->rows[row].name, name) != 0)
            row++;
        cases->count = MAX(cases->count, row + 1);
        cases->rows[row].name = name;
        cases->rows[row].jobs++;
        cases->row_of[i] = row;
        cases->weight_of[i] = 1;
    }
    cases->weight = (double)plan->job_count;
    console_cases_start(cases);
    return cases;
}

void console_cases_free(struct console_cases *cases)
{
    if (cases == NULL)
        return;
    g_free(cases->rows);
    g_free(cases->row_of);
    g_free(cases->weight_of);
    g_free(cases);
}

void console_cases_expect(struct console_cases *cases, const struct plan *plan,
                          const json_t *measurements)
{
    GHashTable *const index = record_index(measurements, "quantity");
    double sum = 0;
    size_t known = 0;
    for (size_t i = 0; i < plan->job_count; i++) {
        json_t *const line =
            json_pack("{ss ss ss}", "case", plan->jobs[i].entry->file->name, "variant",
                      plan->jobs[i].variant->name, "quantity", "cpu_seconds");
        const double seconds = record_number(record_find(index, line, "quantity"), "value");
        json_decref(line);
        cases->weight_of[i] = seconds > 0 ? seconds : 0;
        sum += cases->weight_of[i];
        known += seconds > 0;
    }
    g_hash_table_unref(index);
    cases->weight = 0;
    for (size_t i = 0; i < plan->job_count; i++) {
        if (!(cases->weight_of[i] > 0))
            cases->weight_of[i] = known > 0 ? sum / (double)known : 1;
        cases->weight += cases->weight_of[i];
    }
}

void console_cases_start(struct console_cases *cases)
{
    cases->start = g_get_monotonic_time();
    cases->weight_kept = cases->weight_done;
}

struct console_case *console_cases_finish(struct console_cases *cases, size_t job, double seconds)
{
    struct console_case *const row = &cases->rows[cases->row_of[job]];
    row->jobs--;
    row->seconds += seconds;
    cases->weight_done += cases->weight_of[job];
    if (row->jobs > 0)
        return NULL;
    cases->done++;
    return row;
}

char *console_cases_text(const struct console_cases *cases)
{
    const double taken = 1e-6 * (double)(g_get_monotonic_time() - cases->start);
    const double done = cases->weight_done - cases->weight_kept;
    const double left = MAX(0.0, cases->weight - cases->weight_done);
    if (!(done > 0) || cases->done == cases->count)
        return g_strdup_printf("%zu of %zu cases", cases->done, cases->count);
    const int seconds = (int)MIN(1e6, taken * left / done + 0.5);
    return g_strdup_printf("%zu of %zu cases, %d:%02d to go", cases->done, cases->count,
                           seconds / 60, seconds % 60);
}
