/* mpm run: a scene to its results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/signals.h"

#include "base/status.h"

#include <glib.h>
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

static enum mpm_status run_scene(struct command *command, const struct mpm_scene *scene,
                                 struct mpm_error *error)
{
    const struct cli_arguments *const given = &command->arguments;
    struct cli_progress progress;
    cli_signals_await();
    cli_progress_start(&progress, given->quiet);
    const struct mpm_run_options options = {
        .output = given->output,
        .simulation = command->simulation,
        .overwrite = given->overwrite,
        .resume = given->resume,
        .scene_path = command->scene,
        .progress = cli_progress_step,
        .warn = cli_progress_warn,
        .progress_context = &progress,
        .interrupted = cli_signals_received,
    };
    const enum mpm_status status = mpm_scene_run(scene, &options, error);
    cli_progress_end(&progress);
    command->signal_number = cli_signals_received();
    if (status == MPM_OK && !given->quiet)
        print_summary(&progress, given->output);
    return status;
}

enum mpm_status cli_run(struct command *command, struct mpm_error *error)
{
    struct cli_arguments *const given = &command->arguments;
    struct mpm_scene *scene = NULL;
    MPM_TRY(cli_take_simulation(command, "run", error));
    if (given->resume && given->overwrite)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "run: --resume and --overwrite: allowed: one of them; see "
                             "'mpm run --help'");
    if (given->output == NULL && strcmp(command->scene, "-") == 0)
        return mpm_error_set(
            error, MPM_BAD_INPUT,
            "run: --output DIR is missing: standard input has no name that results "
            "could have; see 'mpm run --help'");
    if (given->output == NULL)
        given->output = default_output(command->scene);
    MPM_TRY(cli_scene_read(command, &scene, error));
    const enum mpm_status status = run_scene(command, scene, error);
    mpm_scene_free(scene);
    return status;
}
