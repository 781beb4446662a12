/* mpm check: is the scene right, and what will it cost?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "io/units.h"

#include <stdio.h>

/* 0 where the least number tried was too large. */
static void print_limit(double limit, const char *what)
{
    if (limit > 0.0)
        (void)printf("%s %.3g", what, limit);
    else
        (void)printf("%s below 0.1", what);
}

static void print_stability(const struct mpm_scene *scene, const struct mpm_plan *plan)
{
    const struct mpm_stability stability = mpm_scene_stability(scene);
    (void)printf("stability  Courant number %.3g; case G1 has limits of", plan->courant);
    print_limit(stability.small, "");
    print_limit(stability.large, " in small motions,");
    (void)printf(" in large ones%s\n",
                 stability.measured ? "" : " (of methods with one of its choices each)");
    if (plan->stability_advice[0] != '\0')
        (void)printf("warning    %s\n", plan->stability_advice);
}

static void print_plan(const struct mpm_scene *scene, const struct mpm_plan *plan)
{
    char unit[MPM_UNIT_SIZE];
    mpm_unit_text(scene, (struct mpm_dimension)MPM_DIMENSION_TIME, unit);
    (void)printf("particles  %zu\n", plan->particles);
    (void)printf("cells      %zu (%zu nodes with ghost rows)\n", plan->cells, plan->nodes);
    (void)printf("memory     %.4g MB", 1e-6 * (double)plan->bytes);
    if (plan->particles > 0)
        (void)printf(" (%.0f bytes a particle)", (double)plan->bytes / (double)plan->particles);
    (void)printf("\ntime step  %.6g %s\n", plan->time_step, unit);
    (void)printf("steps      about %.0f\n", plan->expected_steps);
    print_stability(scene, plan);
    (void)printf("kernels    %s (%s)\n", plan->kernels, plan->kernels_reason);
    (void)printf("simd       %s\n", plan->simd);
    (void)printf("threads    %d (%s)\n", plan->threads, plan->threads_reason);
}

static int print_check(const struct mpm_scene *scene,
                       const struct mpm_simulation_options *simulation)
{
    struct mpm_plan plan = {.particles = 0};
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status status = mpm_scene_plan(scene, simulation, &plan, &error);
    if (status != MPM_OK)
        return cli_fail(status, "%s", error.message);
    print_plan(scene, &plan);
    return MPM_OK;
}

int cli_check(const struct cli_command *command, int argc, char **argv)
{
    char **settings = NULL;
    char *path = NULL;
    const GOptionEntry options[] = {
        {"set", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &settings,
         "Set a value of the scene; the last one wins", "PATH=VALUE"},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    struct mpm_simulation_options simulation = {.kernels = MPM_KERNELS_AUTO};
    const struct cli_arguments arguments = {
        .command = command, .options = options, .simulation = &simulation};
    const enum cli_outcome outcome = cli_arguments_read(&arguments, argc, argv, &path);
    int status = outcome == CLI_BAD_USAGE ? MPM_BAD_INPUT : MPM_OK;
    struct mpm_scene *scene = NULL;
    if (outcome == CLI_GO_ON)
        status = cli_scene_read(path, settings, &scene);
    if (scene != NULL)
        status = print_check(scene, &simulation);
    mpm_scene_free(scene);
    g_strfreev(settings);
    g_free(path);
    return status;
}
