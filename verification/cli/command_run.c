/* mpm-verify run, tasks, task and collect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"
#include "verification/common/command_line.h"
#include "verification/common/failure.h"
#include "verification/common/machine.h"
#include "verification/common/resources.h"
#include "verification/suite/campaign.h"
#include "verification/suite/launch_slurm.h"

#include <string.h>

enum { JOBS_MAX = 1024 };

struct made_options {
    struct run_options run;
    char *reports, *typed, *output;
    json_t *resumed;
};

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
    run->selection.case_globs = texts->case_globs;
    run->selection.variant_globs = texts->variant_globs;
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
        .case_globs = g_strdup(given->case_globs),
        .variant_globs = g_strdup(given->variant_globs),
        .only = g_strdup(given->only),
        .kernels = g_strdup(given->kernels),
        .baseline = g_strdup(given->baseline),
        .api = g_strdup(given->api),
        .catalogue = g_strdup(given->catalogue),
    };
}

static void run_options_clear(struct made_options *made)
{
    if (made->run.selection.only != NULL)
        g_hash_table_unref(made->run.selection.only);
    run_texts_clear(&made->run.texts);
    json_decref(made->resumed);
    g_free(made->reports);
    g_free(made->output);
    g_free(made->typed);
}

/* What a command of a run works on, in `folder` (NULL: where reports go). */
static enum mpm_status run_options_make(const struct command *command,
                                        const struct command_options *given, const char *folder,
                                        bool resume, struct made_options *made,
                                        struct mpm_error *error)
{
    *made = (struct made_options){
        .reports = resources_reports(command->argv[0]),
        .typed = command_line_typed(PROGRAM, command->argc, command->argv),
        .output = folder != NULL ? g_strdup(folder) : resources_output(),
    };
    struct run_options *run = &made->run;
    *run = (struct run_options){.reports = made->reports,
                                .output = made->output,
                                .texts = texts_of(given),
                                .command = made->typed};
    enum mpm_status status = MPM_OK;
    if (resume) {
        status = run_state_adopt(made->output, &run->texts, &made->resumed, error);
    } else {
        if (run->texts.catalogue == NULL)
            run->texts.catalogue = resources_catalogue(command->argv[0]);
        run_texts_complete(&run->texts);
    }
    run->resumed = made->resumed;
    if (status == MPM_OK)
        status = read_options(run, given, error);
    if (status != MPM_OK)
        run_options_clear(made);
    return status;
}

/* ------------------------------------------------------------------------- run */

enum launcher { LAUNCHER_LOCAL, LAUNCHER_SLURM };

static enum mpm_status read_launcher(const char *text, enum launcher *launcher,
                                     struct mpm_error *error)
{
    *launcher = text != NULL && strcmp(text, "slurm") == 0 ? LAUNCHER_SLURM : LAUNCHER_LOCAL;
    if (text == NULL || *launcher == LAUNCHER_SLURM || strcmp(text, "local") == 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--launcher \"%s\": allowed are local and slurm",
                       text);
}

static enum mpm_status run_with(const struct run_options *run, enum launcher launcher,
                                const char *costs, struct command *command, struct mpm_error *error)
{
    const struct suite_world *world = command->world;
    struct console console = {
        .out = world->out, .terminal = world->terminal, .verbose = command->options.verbose};
    struct record_counts counts = {.total = 0};
    enum mpm_status status;
    if (launcher == LAUNCHER_SLURM) {
        char *program = resources_program(command->argv[0], PROGRAM);
        status = launch_slurm(run, world->programs, program, costs, &console, &counts,
                              &command->signal_number, error);
        g_free(program);
    } else {
        status = suite_run(run, world->programs, &console, &counts, &command->signal_number, error);
    }
    console_clear(&console);
    command->checks_failed = counts.failed > 0;
    return status;
}

/* What the run left is worth its tables, whatever it came to. */
static enum mpm_status run_and_tables(const struct run_options *run, enum launcher launcher,
                                      const char *costs, struct command *command,
                                      struct mpm_error *error)
{
    struct mpm_error later;
    const enum mpm_status status = run_with(run, launcher, costs, command, error);
    if (status != MPM_OK && status != MPM_INTERRUPTED)
        return status;
    const enum mpm_status written =
        command_study_tables(command, run->output, run->texts.catalogue, &later);
    if (written == MPM_OK || status != MPM_OK)
        return status;
    *error = later;
    return written;
}

enum mpm_status command_run(struct command *command, struct mpm_error *error)
{
    return command_run_given(command, &command->options, error);
}

enum mpm_status command_run_given(struct command *command, const struct command_options *given,
                                  struct mpm_error *error)
{
    struct made_options made;
    enum launcher launcher;
    TRY(read_launcher(given->launcher, &launcher, error));
    if (given->costs != NULL && launcher != LAUNCHER_SLURM)
        return failure_set(error, MPM_BAD_INPUT,
                           "--costs: allowed with --launcher slurm: nothing else is asked for time "
                           "and memory");
    TRY(run_options_make(command, given, given->output, given->resume || given->status, &made,
                         error));
    const enum mpm_status status =
        given->status
            ? campaign_status(&made.run, command->world->programs, command->world->out, error)
            : run_and_tables(&made.run, launcher, given->costs, command, error);
    run_options_clear(&made);
    return status;
}

/* ------------------------------------------------------------------------ tasks */

enum mpm_status command_tasks(struct command *command, struct mpm_error *error)
{
    return command_tasks_given(command, &command->options, error);
}

enum mpm_status command_tasks_given(struct command *command, const struct command_options *given,
                                    struct mpm_error *error)
{
    struct made_options made;
    TRY(run_options_make(command, given, given->output, given->resume, &made, error));
    char *program = resources_program(command->argv[0], PROGRAM);
    const enum mpm_status status =
        campaign_tasks(&made.run, command->world->programs, program, command->world->out, error);
    g_free(program);
    run_options_clear(&made);
    return status;
}

enum mpm_status command_task(struct command *command, struct mpm_error *error)
{
    char **const rest = command->options.rest;
    struct made_options made;
    TRY(run_options_make(command, &command->options, rest[0], true, &made, error));
    const enum mpm_status status =
        campaign_task(&made.run, command->world->programs, rest[1], &command->signal_number, error);
    run_options_clear(&made);
    return status;
}

enum mpm_status command_collect(struct command *command, struct mpm_error *error)
{
    const struct suite_world *world = command->world;
    struct console console = {
        .out = world->out, .terminal = world->terminal, .verbose = command->options.verbose};
    struct record_counts counts;
    struct made_options made;
    TRY(run_options_make(command, &command->options, command->options.rest[0], true, &made, error));
    enum mpm_status status = campaign_collect(&made.run, world->programs, &console, &counts, error);
    console_clear(&console);
    command->checks_failed = counts.failed > 0;
    if (status == MPM_OK)
        status = command_study_tables(command, made.run.output, made.run.texts.catalogue, error);
    run_options_clear(&made);
    return status;
}
