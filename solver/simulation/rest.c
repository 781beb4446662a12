/* Is a simulation at rest?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <math.h>

static double residual(const struct mpm_simulation *simulation)
{
    const struct mpm_balance *const balance = &simulation->state.balance;
    const double scale = fmax(balance->internal, balance->unbalanced);
    if (simulation->step == 0)
        return 1.0;
    return scale > 0.0 ? balance->unbalanced / scale : 0.0;
}

static double kinetic_energy(const struct mpm_simulation *simulation)
{
    const struct mpm_state *const state = &simulation->state;
    if (simulation->step == 0)
        return 1.0;
    const double kinetic = mpm_kinetic_energy(state);
    const double put_in = simulation->energy_start + fabs(state->external_work);
    return kinetic > 0.0 ? kinetic / put_in : 0.0;
}

void mpm_rest_judge(struct mpm_simulation *simulation)
{
    const struct mpm_rest_spec *const rest = &simulation->scene->rest;
    const bool rests = simulation->state.time >= rest->after &&
                       residual(simulation) < rest->residual &&
                       kinetic_energy(simulation) < rest->kinetic_energy;
    simulation->steps_at_rest = rests ? simulation->steps_at_rest + 1 : 0;
}

bool mpm_simulation_at_rest(const struct mpm_simulation *simulation, struct mpm_rest *rest)
{
    const bool asked = simulation->scene->rest.asked;
    if (rest != NULL)
        *rest = (struct mpm_rest){
            .asked = asked,
            .residual = asked ? residual(simulation) : 0.0,
            .kinetic_energy = asked ? kinetic_energy(simulation) : 0.0,
        };
    return asked && simulation->steps_at_rest >= simulation->scene->rest.steps;
}
