/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/checkpoint.h"

#include <math.h>
#include <stdio.h>

enum mpm_status mpm_scene_plan(const struct mpm_scene *scene,
                               const struct mpm_simulation_options *options, struct mpm_plan *plan,
                               struct mpm_error *error)
{
    struct mpm_simulation_options unseen = *options;
    struct mpm_simulation *simulation = NULL;
    unseen.monitor = NULL;
    MPM_TRY(mpm_simulation_create(scene, &unseen, &simulation, error));
    const struct mpm_grid *const grid = &simulation->state.grid;
    bool lands;
    *plan = (struct mpm_plan){
        .particles = mpm_simulation_particle_count(simulation),
        .cells = (size_t)(grid->cells[0] * grid->cells[1]),
        .nodes = (size_t)(grid->columns * grid->rows),
        .bytes = mpm_simulation_bytes(simulation),
        .time_step = mpm_time_step_next(simulation, HUGE_VAL, &lands),
        .kernels = mpm_simulation_kernels(simulation),
        .kernels_reason = simulation->state.kernels.reason,
        .simd = mpm_simulation_simd(simulation),
        .courant = mpm_time_step_courant(simulation),
        .checkpoint_bytes = mpm_checkpoint_bytes(simulation),
    };
    (void)snprintf(plan->stability_advice, sizeof plan->stability_advice, "%s",
                   mpm_simulation_advice(simulation));
    plan->threads = mpm_threads_choose(&simulation->state, options->threads, plan->threads_reason);
    plan->expected_steps = ceil(scene->end / plan->time_step * (1.0 - 1e-9));
    if (scene->steps > 0)
        plan->expected_steps = fmin(plan->expected_steps, (double)scene->steps);
    mpm_simulation_free(simulation);
    return MPM_OK;
}
