/* mpm run: a scene to its results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/signals.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* "disk-results" for the scene "scenes/disk.yaml". */
static char *default_output(const char *scene)
{
    char *name = g_path_get_basename(scene);
    char *point = strrchr(name, '.');
    if (point != NULL && point != name)
        *point = '\0';
    char *output = g_strconcat(name, "-results", NULL);
    g_free(name);
    return output;
}

/* The results are in files: where standard output is closed or full, they are none the worse. */
static void print_summary(const struct cli_progress *progress, const char *output)
{
    const double particle_steps = (double)progress->step * (double)progress->particles;
    char speed[64] = "";
    if (progress->seconds > 0.0)
        g_snprintf(speed, sizeof speed, ", %.3g particle-steps/s",
                   particle_steps / progress->seconds);
    (void)dprintf(STDOUT_FILENO, "done: %" PRIu64 " steps, %zu particles%s, results in %s\n",
                  progress->step, progress->particles, speed, output);
}

int cli_run(struct cli_arguments *arguments)
{
    struct mpm_scene *scene = NULL;
    if (arguments->output == NULL)
        arguments->output = default_output(arguments->scene);
    if (arguments->resume && arguments->overwrite)
        return cli_fail(MPM_BAD_INPUT, "run: --resume and --overwrite: allowed: one of them; see "
                                       "'mpm run --help'");
    const int status = cli_scene_read(arguments, &scene);
    if (status != MPM_OK)
        return status;
    cli_signals_await();
    struct cli_progress progress;
    cli_progress_start(&progress, arguments->quiet);
    const struct mpm_run_options options = {
        .output = arguments->output,
        .simulation = arguments->simulation,
        .overwrite = arguments->overwrite,
        .resume = arguments->resume,
        .scene_path = arguments->scene,
        .progress = cli_progress_step,
        .warn = cli_progress_warn,
        .progress_context = &progress,
        .interrupted = cli_signals_received,
    };
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status ran = mpm_scene_run(scene, &options, &error);
    cli_progress_end(&progress);
    mpm_scene_free(scene);
    if (ran == MPM_INTERRUPTED)
        return cli_fail(ran, "%s", error.message) + cli_signals_received();
    if (ran != MPM_OK)
        return cli_fail(ran, "%s", error.message);
    if (!arguments->quiet)
        print_summary(&progress, arguments->output);
    return MPM_OK;
}
