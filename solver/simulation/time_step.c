/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

/* The rest of the way is taken in one step if it is longer than a step by no more than
 * this part, and in two equal ones if it is shorter than two steps: no sliver is left. */
static const double LANDING_SLACK = 1e-9;

static double crossing_time(const struct mpm_simulation *simulation)
{
    return fmin(simulation->state.grid.cell[0], simulation->state.grid.cell[1]) /
           simulation->wave_speed;
}

double mpm_time_step_next(const struct mpm_simulation *simulation, double limit, bool *lands)
{
    const struct mpm_scene *const scene = simulation->scene;
    const double step =
        scene->step > 0.0 ? scene->step : scene->courant * crossing_time(simulation);
    const double rest = limit - simulation->state.time;
    *lands = rest <= step * (1.0 + LANDING_SLACK);
    if (*lands)
        return rest;
    return rest < step * (2.0 - LANDING_SLACK) ? 0.5 * rest : step;
}

enum mpm_status mpm_time_step_check(const struct mpm_simulation *simulation,
                                    struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const double limit = crossing_time(simulation);
    if (scene->step <= limit || scene->allow_unstable)
        return MPM_OK;
    return mpm_scene_error(error, scene, scene->line_time, "time.step",
                           "%g is beyond the stability limit; allowed: up to %g (cell size over "
                           "wave speed %g), or more with time.allow_unstable: true",
                           scene->step, limit, simulation->wave_speed);
}
