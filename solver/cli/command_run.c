/* mpm run: a scene to its results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/progress.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

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

static void print_summary(const struct cli_progress *progress, const char *output)
{
    const double particle_steps = (double)progress->step * (double)progress->particles;
    (void)printf("done: %" PRIu64 " steps, %zu particles", progress->step, progress->particles);
    if (progress->seconds > 0.0)
        (void)printf(", %.3g particle-steps/s", particle_steps / progress->seconds);
    (void)printf(", results in %s\n", output);
}

int cli_run(struct cli_arguments *arguments)
{
    struct mpm_scene *scene = NULL;
    if (arguments->output == NULL)
        arguments->output = default_output(arguments->scene);
    if (arguments->resume)
        return cli_fail(MPM_BAD_INPUT,
                        "--resume: there is no checkpoint in '%s'; this version writes none, run "
                        "the scene from its start",
                        arguments->output);
    const int status = cli_scene_read(arguments, &scene);
    if (status != MPM_OK)
        return status;
    if (mpm_scene_wants_checkpoints(scene) && !arguments->quiet)
        (void)fprintf(stderr, "mpm: output.checkpoint: this version writes no checkpoints\n");
    struct cli_progress progress;
    cli_progress_start(&progress, arguments->quiet);
    const struct mpm_run_options options = {
        .output = arguments->output,
        .simulation = arguments->simulation,
        .overwrite = arguments->overwrite,
        .scene_path = arguments->scene,
        .progress = cli_progress_step,
        .warn = cli_progress_warn,
        .progress_context = &progress,
    };
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status ran = mpm_scene_run(scene, &options, &error);
    cli_progress_end(&progress);
    mpm_scene_free(scene);
    if (ran != MPM_OK)
        return cli_fail(ran, "%s", error.message);
    if (!arguments->quiet)
        print_summary(&progress, arguments->output);
    return MPM_OK;
}
