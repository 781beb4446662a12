/* mpm-verify export and score.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"

#include "mpm_file.h"
#include "verification/common/command_line.h"
#include "verification/common/failure.h"
#include "verification/common/names.h"
#include "verification/common/resources.h"
#include "verification/score/numbers.h"
#include "verification/score/score.h"
#include "verification/suite/plan.h"

#include <glib.h>

/* Writes the bundle of each selected case, and reports why the others have none. */
static enum mpm_status export_cases(const struct command *command,
                                    const struct catalogue *catalogue, struct mpm_error *error)
{
    const struct command_options *options = &command->options;
    FILE *out = command->world->out;
    size_t matched = 0, written = 0;
    TRY(plan_check_globs(catalogue, options->case_globs, NULL, error));
    for (size_t i = 0; i < catalogue->count; i++) {
        const struct case_file *file = catalogue->cases[i].file;
        if (!glob_list_matches(options->case_globs, file->name))
            continue;
        matched++;
        if (file->bundle == NULL && file->numbers == NULL) {
            fprintf(out, "%-8s not exportable: %s\n", file->name,
                    file->no_bundle != NULL ? file->no_bundle : "its case.yaml declares no bundle");
            continue;
        }
        TRY((file->bundle != NULL ? bundle_write : numbers_write)(&catalogue->cases[i],
                                                                  options->output, error));
        fprintf(out, "%-8s exported to %s/%s\n", file->name, options->output, file->name);
        written++;
    }
    fprintf(out, "%zu exported, %zu not exportable\n", written, matched - written);
    return MPM_OK;
}

enum mpm_status command_export(struct command *command, struct mpm_error *error)
{
    struct catalogue *catalogue;
    if (command->options.output == NULL)
        return failure_set(error, MPM_BAD_INPUT, "export: --output DIR is missing");
    if (mpm_path_is_file(command->options.output))
        return failure_set(error, MPM_BAD_INPUT, "%s: is a file; --output names a folder",
                           command->options.output);
    TRY(command_catalogue(command, &catalogue, error));
    const enum mpm_status status = export_cases(command, catalogue, error);
    catalogue_free(catalogue);
    return status;
}

enum mpm_status command_score(struct command *command, struct mpm_error *error)
{
    const struct command_options *given = &command->options;
    struct console console = {
        .out = command->world->out, .terminal = command->world->terminal, .verbose = true};
    struct record_counts counts = {.total = 0};
    char *reports = resources_reports(command->argv[0]);
    char *typed = command_line_typed("mpm-verify", command->argc, command->argv);
    char *output = given->output != NULL ? g_strdup(given->output) : resources_score_output();
    const struct score_options options = {.bundle = given->rest[0],
                                          .results = given->rest[1],
                                          .name = given->name,
                                          .output = output,
                                          .reports = reports,
                                          .command = typed};
    enum mpm_status status;
    if (reports == NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, RESOURCES_NO_REPORTS);
    else
        status = score_run(&options, &console, &counts, error);
    console_clear(&console);
    command->checks_failed = status == MPM_OK && counts.failed > 0;
    g_free(reports);
    g_free(typed);
    g_free(output);
    return status;
}
