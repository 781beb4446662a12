/* mpm plot: pictures of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "base/status.h"
#include "io/plot/plot.h"
#include "mpm_file.h"

#include <stdio.h>

enum mpm_status cli_plot(struct command *command, struct mpm_error *error)
{
    const struct cli_arguments *const given = &command->arguments;
    const char *const folder = given->operands != NULL ? given->operands[0] : NULL;
    char *pictures[MPM_PLOT_COUNT] = {NULL};
    struct mpm_error cause = {.status = MPM_OK};
    const struct mpm_plot_options options = {
        .folder = folder,
        .output = given->output != NULL ? given->output : folder,
        .field = given->field != NULL ? given->field : "von_mises",
        .snapshot = given->snapshot,
        .format = given->format != NULL ? given->format : "svg",
    };
    if (given->list && given->names)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "plot: allowed: one of --list and --names; see 'mpm plot --help'");
    if (given->output != NULL && mpm_path_is_file(given->output))
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "plot: %s: is a file; allowed: a folder for the pictures",
                             given->output);
    if (given->list) {
        char *const fields = mpm_plot_fields();
        (void)fputs(fields, stdout);
        g_free(fields);
        return MPM_OK;
    }
    if (given->names) {
        char *names = NULL;
        const enum mpm_status found = mpm_plot_names(&options, &names, &cause);
        (void)fputs(found == MPM_OK ? names : "", stdout);
        g_free(names);
        return found == MPM_OK ? MPM_OK : mpm_error_set(error, found, "plot: %s", cause.message);
    }
    if (folder == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "plot: a folder of results is missing; see 'mpm plot --help'");
    const enum mpm_status status = mpm_plot(&options, pictures, &cause);
    for (size_t k = 0; k < MPM_PLOT_COUNT; k++) {
        if (pictures[k] != NULL && !given->quiet)
            (void)printf("%s\n", pictures[k]);
        g_free(pictures[k]);
    }
    return status == MPM_OK ? MPM_OK : mpm_error_set(error, status, "plot: %s", cause.message);
}
