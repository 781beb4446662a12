/* mpm-verify run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"
#include "verification/common/command_line.h"
#include "verification/common/failure.h"
#include "verification/common/machine.h"
#include "verification/common/resources.h"
#include "verification/suite/run.h"

#include <string.h>

enum { JOBS_MAX = 1024 };

static enum mpm_status read_tier(const char *text, enum tier *tier, struct mpm_error *error)
{
    *tier = TIER_CI;
    if (strcmp(text, tier_name(TIER_CI)) == 0)
        return MPM_OK;
    *tier = TIER_FULL;
    if (strcmp(text, tier_name(TIER_FULL)) == 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--tier \"%s\": allowed are ci and full", text);
}

static enum mpm_status read_kernels(const char *text, enum mpm_kernels *kernels,
                                    struct mpm_error *error)
{
    struct mpm_error cause;
    if (mpm_kernels_find(text, kernels, &cause) == MPM_OK)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--kernels: %s", cause.message);
}

static enum mpm_status read_jobs(int given, unsigned *jobs, struct mpm_error *error)
{
    *jobs = given == JOBS_DEFAULT ? machine_processor_count() : (unsigned)given;
    if (given == JOBS_DEFAULT || (given >= 1 && given <= JOBS_MAX))
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--jobs %d: allowed are 1 to %d", given, JOBS_MAX);
}

/* What the texts of the command line, or of the run that goes on, mean. */
static enum mpm_status read_options(struct run_options *run, const struct command_options *given,
                                    struct mpm_error *error)
{
    const struct run_texts *texts = &run->texts;
    TRY(read_tier(texts->tier, &run->selection.tier, error));
    TRY(read_kernels(texts->kernels, &run->kernels, error));
    run->selection.case_glob = texts->case_glob;
    run->selection.variant_glob = texts->variant_glob;
    run->selection.only_file = texts->only;
    if (texts->only != NULL)
        TRY(plan_read_only(texts->only, &run->selection.only, error));
    TRY(read_jobs(given->jobs, &run->jobs, error));
    if (texts->catalogue == NULL)
        return failure_set(error, MPM_BAD_INPUT, NO_CATALOGUE);
    if (run->reports == NULL)
        return failure_set(
            error, MPM_ENVIRONMENT_FAILED,
            "the report's style is found neither in reports/ nor beside the program");
    return MPM_OK;
}

static struct run_texts texts_of(const struct command_options *given)
{
    return (struct run_texts){
        .tier = g_strdup(given->tier),
        .case_glob = g_strdup(given->case_glob),
        .variant_glob = g_strdup(given->variant_glob),
        .only = g_strdup(given->only),
        .kernels = g_strdup(given->kernels),
        .baseline = g_strdup(given->baseline),
        .catalogue = g_strdup(given->catalogue),
    };
}

static enum mpm_status run_with(struct run_options *run, struct command *command,
                                struct mpm_error *error)
{
    struct console console = {.out = command->world->out, .terminal = command->world->terminal};
    struct record_counts counts;
    TRY(read_options(run, &command->options, error));
    const enum mpm_status status =
        suite_run(run, command->world->programs, &console, &counts, &command->signal_number, error);
    command->checks_failed = counts.failed > 0;
    return status;
}

enum mpm_status command_run(struct command *command, struct mpm_error *error)
{
    const struct command_options *given = &command->options;
    char *reports = resources_reports(command->argv[0]);
    char *typed = command_line_typed(PROGRAM, command->argc, command->argv);
    char *output = given->output != NULL ? g_strdup(given->output) : resources_output();
    json_t *resumed = NULL;
    struct run_options run = {
        .reports = reports, .output = output, .texts = texts_of(given), .command = typed};
    enum mpm_status status = MPM_OK;
    if (given->resume) {
        status = run_state_adopt(output, &run.texts, &resumed, error);
    } else {
        if (run.texts.catalogue == NULL)
            run.texts.catalogue = resources_catalogue(command->argv[0]);
        run_texts_complete(&run.texts);
    }
    run.resumed = resumed;
    if (status == MPM_OK)
        status = run_with(&run, command, error);
    if (run.selection.only != NULL)
        g_hash_table_unref(run.selection.only);
    run_texts_clear(&run.texts);
    json_decref(resumed);
    g_free(reports);
    g_free(output);
    g_free(typed);
    return status;
}
