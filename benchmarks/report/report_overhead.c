/* Section: the overhead of each feature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/report_sections.h"
#include "verification/common/record.h"

#include <math.h>

static const char rate[] = "particle_steps_per_second";

static const json_t *count_of(const struct report *report, const json_t *line, const char *quantity)
{
    return bench_records_find(report->records, "value", record_text(line, "group"),
                              record_text(line, "point"), quantity);
}

static void cell_count(struct report *report, const json_t *line, const char *quantity)
{
    const json_t *value = count_of(report, line, quantity);
    document_cell(report->document,
                  value == NULL ? g_strdup("") : report_digits(record_number(value, "value"), 1),
                  NULL);
}

void report_overhead(struct report *report)
{
    static const char *const columns[] = {"Feature",
                                          ">Time ratio",
                                          "Against",
                                          ">Instruction ratio",
                                          ">Instructions/particle-step",
                                          ">Branches/particle-step",
                                          NULL};
    document_heading(report->document, 2, "Overhead of features");
    if (!report_has(report, "overhead", "Overhead of features"))
        return;
    GPtrArray *lines = report_lines(report, "result", "overhead", rate);
    document_table(report->document,
                   "Each feature on, against the same scene without it: time a particle-step, and "
                   "counted instructions beside it, which are the same on every run.",
                   columns);
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i], *comparison = report_comparison(report, line);
        const char *expectation = report_setting(line, "expectation");
        document_cell(report->document, g_strdup(record_text(line, "point")),
                      *expectation == '\0' ? NULL : g_strdup(expectation));
        report_cell_ratio(report, comparison, true);
        report_cell(report, record_text(comparison, "against"));
        cell_count(report, line, "instructions_ratio");
        cell_count(report, line, "instructions_per_particle_step");
        cell_count(report, line, "branches_per_particle_step");
    }
    g_ptr_array_unref(lines);
}
