/* A score as a run of the suite with one case and one variant: the solver.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/common/names.h"
#include "verification/report/report.h"
#include "verification/score/numbers.h"
#include "verification/score/results.h"
#include "verification/score/score.h"
#include "verification/suite/output_folder.h"
#include "verification/suite/records_make.h"

#include <string.h>

/* The plan that the suite would have made, and what it points to. */
struct scored {
    struct case_file file;
    struct catalogue_case entry;
    struct case_variant variant;
    struct planned_job job;
    struct plan plan;
};

static void scored_open(const struct bundle *bundle, char *name, struct scored *scored)
{
    const json_t *json = bundle->json;
    *scored = (struct scored){
        .file = {.family = (char *)record_text(json, "family"),
                 .name = (char *)record_text(json, "case"),
                 .title = (char *)record_text(json, "title"),
                 .summary = (char *)record_text(json, "summary"),
                 .program_name = (char *)"score"},
        .entry = {.folder = bundle->folder, .readme = bundle->words},
        .variant = {.name = name, .tier = TIER_CI},
    };
    scored->entry.file = &scored->file;
    scored->job = (struct planned_job){.entry = &scored->entry, .variant = &scored->variant};
    scored->plan =
        (struct plan){&scored->job, 1, g_new0(struct planned_check, bundle->criterion_count),
                      bundle->criterion_count};
    for (size_t i = 0; i < bundle->criterion_count; i++)
        scored->plan.checks[i].check = &bundle->criteria[i].check;
}

static enum mpm_status conclude(const struct score_options *options,
                                const struct output_folder *output, const struct scored *scored,
                                const struct job_result *result, struct console *console,
                                struct record_counts *counts, struct mpm_error *error)
{
    const struct plan_selection selection = {.tier = TIER_CI};
    GDateTime *now = g_date_time_new_now_utc();
    char *started = g_date_time_format(now, "%Y-%m-%dT%H:%M:%SZ");
    const struct record_context context = {.output = output->stage,
                                           .command = options->command,
                                           .selection = &selection,
                                           .kernels = MPM_KERNELS_AUTO,
                                           .jobs = 1,
                                           .started = started};
    struct records records = records_make(&scored->plan, result, &context);
    json_object_set_new(records.run, "score", json_true()); /* its command is the one to repeat */
    *counts = records_count(&records, NULL, NULL);
    enum mpm_status status = records_write(output->stage, &records, error);
    if (status == MPM_OK)
        status =
            output_report(output, &(struct report_sources){.reports = options->reports}, error);
    console_begin(console, &scored->plan);
    console_finished(console, 0, result);
    console_end(console, &records, status == MPM_OK ? options->output : NULL);
    records_clear(&records);
    g_free(started);
    g_date_time_unref(now);
    return status;
}

/* A name for the solver: given, or the results' without its suffix, with '_' for what no name may
 * have. g_free. */
static char *solver_name(const struct score_options *options)
{
    if (options->name != NULL)
        return g_strdup(options->name);
    char *name = g_path_get_basename(options->results);
    char *dot = strrchr(name, '.');
    if (dot != NULL && dot != name)
        *dot = '\0';
    for (char *c = name; *c != '\0'; c++)
        if (!g_ascii_isalnum(*c) && *c != '-')
            *c = '_';
    name[MIN(strlen(name), 64)] = '\0';
    return name;
}

static enum mpm_status report(const struct score_options *options, const struct bundle *bundle,
                              char *name, char *rows, struct console *console,
                              struct record_counts *counts, struct mpm_error *error)
{
    struct scored scored;
    struct output_folder output;
    const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows};
    TRY(output_open(options->output, &output, error));
    scored_open(bundle, name, &scored);
    enum mpm_status status = output_stage(&output, &scored.plan, error);
    if (status == MPM_OK)
        status = conclude(options, &output, &scored, &result, console, counts, error);
    output_close(&output);
    g_free(scored.plan.checks);
    return status;
}

static enum mpm_status field_rows(const struct bundle *bundle, const char *path, GString *rows,
                                  struct mpm_error *error)
{
    struct score_table results;
    TRY(results_read(path, &bundle->format, &results, error));
    const enum mpm_status status = score_rows(bundle, &results, rows, error);
    score_table_close(&results);
    return status;
}

enum mpm_status score_run(const struct score_options *options, struct console *console,
                          struct record_counts *counts, struct mpm_error *error)
{
    struct bundle bundle;
    *counts = (struct record_counts){.total = 0};
    if (options->name != NULL && !name_is_sound(options->name))
        return failure_set(error, MPM_BAD_INPUT, "--name \"%s\": %s", options->name, name_rule);
    TRY(bundle_read(options->bundle, &bundle, error));
    GString *rows = g_string_new(NULL);
    char *name = solver_name(options);
    enum mpm_status status = bundle.numbers ? numbers_rows(&bundle, options->results, rows, error)
                                            : field_rows(&bundle, options->results, rows, error);
    if (status == MPM_OK)
        status = report(options, &bundle, name, rows->str, console, counts, error);
    g_free(name);
    g_string_free(rows, TRUE);
    bundle_close(&bundle);
    return status;
}
