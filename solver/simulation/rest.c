/* Is a simulation at rest?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <math.h>

/* Strain energy changes slowly where motion dies away, and costs a logarithm a particle. */
enum { STEPS_BETWEEN_ENERGIES = 32 };

/* A residual that swings has fallen only if it is lower by this much. */
static const double LOWER = 0.9;

static double residual(const struct mpm_simulation *simulation)
{
    const struct mpm_balance *const balance = &simulation->state.balance;
    const double scale = fmax(balance->internal, balance->unbalanced);
    if (simulation->step == 0)
        return 1.0;
    return fmax(scale > 0.0 ? balance->unbalanced / scale : 0.0, balance->flow);
}

static double kinetic_energy(const struct mpm_simulation *simulation)
{
    if (simulation->step == 0)
        return 1.0;
    const double kinetic = mpm_kinetic_energy(&simulation->state);
    return kinetic > 0.0 ? kinetic / fmax(kinetic, simulation->rest.largest_energy) : 0.0;
}

static void keep_largest_energy(struct mpm_simulation *simulation)
{
    double energy = mpm_kinetic_energy(&simulation->state);
    if (simulation->step % STEPS_BETWEEN_ENERGIES == 0) {
        struct mpm_ledger ledger;
        mpm_simulation_ledger(simulation, &ledger);
        energy += ledger.strain_energy;
    }
    simulation->rest.largest_energy = fmax(simulation->rest.largest_energy, energy);
}

static void keep_lowest_residual(struct mpm_simulation *simulation)
{
    struct mpm_rest_watch *const watch = &simulation->rest;
    const double now = residual(simulation);
    const bool first = watch->progress_step == 0;
    if (first || now < watch->lowest_residual) {
        watch->lowest_residual = now;
        watch->lowest_time = simulation->state.time;
    }
    if (first || now < LOWER * watch->fallen_residual) {
        watch->fallen_residual = now;
        watch->fallen_time = simulation->state.time;
        watch->progress_step = simulation->step;
    }
    /* nodes in balance wait for particles, or for rest.steps */
    if (now < simulation->scene->rest.residual)
        watch->progress_step = simulation->step;
}

void mpm_rest_judge(struct mpm_simulation *simulation)
{
    const struct mpm_rest_spec *const rest = &simulation->scene->rest;
    keep_largest_energy(simulation);
    if (simulation->state.time < rest->after)
        return;
    keep_lowest_residual(simulation);
    const bool rests =
        residual(simulation) < rest->residual && kinetic_energy(simulation) < rest->kinetic_energy;
    simulation->rest.steps_at_rest = rests ? simulation->rest.steps_at_rest + 1 : 0;
}

bool mpm_simulation_at_rest(const struct mpm_simulation *simulation, struct mpm_rest *rest)
{
    const bool asked = simulation->scene->rest.asked;
    const struct mpm_rest_watch *const watch = &simulation->rest;
    if (rest != NULL)
        *rest = (struct mpm_rest){
            .asked = asked,
            .residual = asked ? residual(simulation) : 0.0,
            .kinetic_energy = asked ? kinetic_energy(simulation) : 0.0,
            .lowest_residual = watch->progress_step != 0 ? watch->lowest_residual : 1.0,
            .lowest_time = watch->lowest_time,
            .fallen_time = watch->fallen_time,
        };
    return asked && watch->steps_at_rest >= simulation->scene->rest.steps;
}

bool mpm_simulation_stagnates(const struct mpm_simulation *simulation)
{
    const int64_t patience = simulation->scene->rest.patience;
    const uint64_t progress = simulation->rest.progress_step;
    return patience > 0 && progress != 0 && simulation->step - progress >= (uint64_t)patience;
}
