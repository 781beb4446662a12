/* mpm plot: pictures of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "io/plot/plot.h"

#include <stdio.h>

int cli_plot(struct cli_arguments *arguments)
{
    char *pictures[MPM_PLOT_COUNT] = {NULL};
    struct mpm_error error = {.status = MPM_OK};
    const struct mpm_plot_options options = {
        .folder = arguments->scene,
        .output = arguments->output != NULL ? arguments->output : arguments->scene,
        .field = arguments->field != NULL ? arguments->field : "von_mises",
        .snapshot = arguments->snapshot,
        .format = arguments->format != NULL ? arguments->format : "svg",
    };
    if (arguments->list) {
        char *const fields = mpm_plot_fields();
        (void)fputs(fields, stdout);
        g_free(fields);
        return MPM_OK;
    }
    if (arguments->scene == NULL)
        return cli_fail(MPM_BAD_INPUT,
                        "plot: a folder of results is missing; see 'mpm plot --help'");
    const enum mpm_status status = mpm_plot(&options, pictures, &error);
    for (size_t k = 0; k < MPM_PLOT_COUNT; k++) {
        if (pictures[k] != NULL && !arguments->quiet)
            (void)printf("%s\n", pictures[k]);
        g_free(pictures[k]);
    }
    return status == MPM_OK ? MPM_OK : cli_fail(status, "plot: %s", error.message);
}
