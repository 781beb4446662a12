/* JSON and JSON lines: records of a run with what a report shows beside them, its pages; records
 * and budget of benchmarks; rows of a measuring process; bundles with the results to be scored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "benchmarks/budget/budget.h"
#include "benchmarks/common/records.h"
#include "verification/common/rows.h"
#include "verification/records/changes.h"
#include "verification/records/headroom_table.h"
#include "verification/report/report.h"
#include "verification/score/bundle.h"
#include "verification/score/results.h"
#include "verification/score/score.h"

#include <glib.h>
#include <stdlib.h>

static char *place(const char *name)
{
    return g_build_filename(fuzz_folder(), name, NULL);
}

static bool has(const char *name)
{
    char *const path = place(name);
    const bool found = g_file_test(path, G_FILE_TEST_EXISTS);
    g_free(path);
    return found;
}

static void read_records(void)
{
    struct mpm_error error = {.status = MPM_OK};
    struct records records;
    if (!fuzz_judge(records_read(fuzz_folder(), &records, &error), &error))
        return;
    struct changes changes = changes_gather(&records, &records, 0.1);
    changes_clear(&changes);
    records_clear(&records);
    const struct report_sources sources = {.reports = "reports", .catalogue = NULL};
    const enum mpm_status rendered = report_render(fuzz_folder(), fuzz_folder(), &sources, &error);
    (void)fuzz_judge(report_status(rendered), &error);
}

static void read_benchmarks(void)
{
    struct mpm_error error = {.status = MPM_OK};
    struct bench_records records;
    if (!fuzz_judge(bench_records_read(fuzz_folder(), &records, &error), &error))
        return;
    for (size_t k = 0; k < json_array_size(records.lines); k++) {
        size_t count;
        g_free(bench_record_rounds(json_array_get(records.lines, k), &count));
    }
    bench_records_clear(&records);
}

static void read_budget(void)
{
    struct mpm_error error = {.status = MPM_OK};
    struct budget budget;
    struct budget_cost cost;
    char *const path = place("budget.json");
    if (fuzz_judge(budget_read(path, &budget, &error), &error)) {
        (void)budget_find(&budget, "disk", &cost);
        budget_clear(&budget);
    }
    g_free(path);
}

static void read_rows(void)
{
    char *const path = place("rows.jsonl"), *text = NULL;
    unsigned line;
    if (g_file_get_contents(path, &text, NULL, NULL)) {
        GArray *const rows = rows_parse(text, &line);
        if (rows != NULL)
            g_array_unref(rows);
    }
    g_free(text);
    g_free(path);
}

static void read_bundle(void)
{
    struct mpm_error error = {.status = MPM_OK};
    struct bundle bundle;
    struct score_table results;
    char *const path = place("results.csv");
    if (!fuzz_judge(bundle_read(fuzz_folder(), &bundle, &error), &error)) {
        g_free(path);
        return;
    }
    if (!bundle.numbers &&
        fuzz_judge(results_read(path, &bundle.format, &results, &error), &error)) {
        GString *const rows = g_string_new(NULL);
        (void)fuzz_judge(score_rows(&bundle, &results, rows, &error), &error);
        g_string_free(rows, TRUE);
        score_table_close(&results);
    }
    bundle_close(&bundle);
    g_free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"checks.jsonl",
                                        "measurements.jsonl",
                                        "changes.json",
                                        "headroom.json",
                                        "mutants.json",
                                        "bench.jsonl",
                                        "budget.json",
                                        "rows.jsonl",
                                        "problem.json",
                                        "problem.md",
                                        "reference.csv",
                                        "results.csv",
                                        NULL};
    fuzz_write_all(data, size, names);
    if (has("checks.jsonl"))
        read_records();
    if (has(BENCH_RECORDS_FILE))
        read_benchmarks();
    if (has("budget.json"))
        read_budget();
    if (has("problem.json"))
        read_bundle();
    read_rows();
    return 0;
}

/* Figures are gnuplot's: without a path, it is not found. */
int LLVMFuzzerInitialize(int *argument_count, char ***arguments)
{
    (void)argument_count;
    (void)arguments;
    return g_setenv("PATH", "/nowhere", TRUE) ? 0 : -1;
}
