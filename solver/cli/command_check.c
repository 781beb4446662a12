/* mpm check: is the scene right, and what will it cost?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include "base/status.h"
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
    if (mpm_scene_is_at_rest(scene)) {
        (void)printf("stability  %.3g of the longest step of explicit conduction\n", plan->courant);
        return;
    }
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
    (void)printf("checkpoint %.4g MB each; a run that leaves some keeps two\n",
                 1e-6 * (double)plan->checkpoint_bytes);
}

enum mpm_status cli_check(struct command *command, struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    struct mpm_plan plan = {.particles = 0};
    MPM_TRY(cli_take_simulation(command, "check", error));
    MPM_TRY(cli_scene_read(command, &scene, error));
    const enum mpm_status status = mpm_scene_plan(scene, &command->simulation, &plan, error);
    if (status == MPM_OK)
        print_plan(scene, &plan);
    mpm_scene_free(scene);
    return status;
}
