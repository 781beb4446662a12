/* mpm run: a scene to its results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/progress.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static const char description[] =
    "The results go to the folder DIR, or to NAME-results in the current folder for\n"
    "a scene NAME.yaml: run.json, history.csv, particles-NNNNNN.hdf and\n"
    "particles.hdf.series, which ParaView opens. A folder that holds results is\n"
    "refused unless --overwrite is given, which removes them first.\n"
    "Results are the same for any number of threads, and for any LEVEL of SIMD. 'mpm\n"
    "check' states which kernels and how many threads a scene gets, and why. PATH is a\n"
    "place in the scene, such as grid.refine, materials.polymer.bulk or\n"
    "bodies.0.velocity.1; VALUE is YAML.";

struct run_arguments {
    char *scene, *output;
    char **settings;
    struct mpm_simulation_options simulation;
    gboolean resume, overwrite, quiet;
};

static enum cli_outcome read_arguments(const struct cli_command *command, int argc, char **argv,
                                       struct run_arguments *read)
{
    const GOptionEntry options[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &read->output, "Folder for the results", "DIR"},
        {"overwrite", 0, 0, G_OPTION_ARG_NONE, &read->overwrite,
         "Replace the results that DIR holds", NULL},
        {"resume", 0, 0, G_OPTION_ARG_NONE, &read->resume, "Go on from the checkpoint in DIR",
         NULL},
        {"set", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &read->settings,
         "Set a value of the scene; the last one wins", "PATH=VALUE"},
        {"quiet", 'q', 0, G_OPTION_ARG_NONE, &read->quiet, "Print nothing but errors", NULL},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    const struct cli_arguments arguments = {
        .command = command,
        .options = options,
        .description = description,
        .simulation = &read->simulation,
    };
    return cli_arguments_read(&arguments, argc, argv, &read->scene);
}

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

static int refuse_resume(const struct run_arguments *arguments)
{
    return cli_fail(MPM_BAD_INPUT,
                    "--resume: there is no checkpoint in '%s'; this version writes "
                    "none, run the scene from its start",
                    arguments->output);
}

static void print_summary(const struct cli_progress *progress, const char *output)
{
    const double particle_steps = (double)progress->step * (double)progress->particles;
    (void)printf("done: %" PRIu64 " steps, %zu particles", progress->step, progress->particles);
    if (progress->seconds > 0.0)
        (void)printf(", %.3g particle-steps/s", particle_steps / progress->seconds);
    (void)printf(", results in %s\n", output);
}

static int run_scene(struct run_arguments *arguments)
{
    struct mpm_scene *scene = NULL;
    int status = arguments->resume ? refuse_resume(arguments) : MPM_OK;
    if (status == MPM_OK)
        status = cli_scene_read(arguments->scene, arguments->settings, &scene);
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

int cli_run(const struct cli_command *command, int argc, char **argv)
{
    struct run_arguments arguments = {.scene = NULL};
    const enum cli_outcome outcome = read_arguments(command, argc, argv, &arguments);
    int status = outcome == CLI_BAD_USAGE ? MPM_BAD_INPUT : MPM_OK;
    if (outcome == CLI_GO_ON) {
        if (arguments.output == NULL)
            arguments.output = default_output(arguments.scene);
        status = run_scene(&arguments);
    }
    g_free(arguments.scene);
    g_free(arguments.output);
    g_strfreev(arguments.settings);
    return status;
}
