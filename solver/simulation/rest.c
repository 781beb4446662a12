/* Is a simulation at rest?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <math.h>

/* Strain energy changes slowly where motion dies away, and costs a logarithm a particle. */
enum { STEPS_BETWEEN_ENERGIES = 32 };

/* A residual that falls and swings is lower again only if it is lower by this much. */
static const double LOWER = 0.9;

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
    if (watch->lowest_step != 0 && now >= LOWER * watch->lowest_residual)
        return;
    watch->lowest_residual = now;
    watch->lowest_time = simulation->state.time;
    watch->lowest_step = simulation->step;
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
            .lowest_residual = watch->lowest_step != 0 ? watch->lowest_residual : 1.0,
            .lowest_time = watch->lowest_time,
        };
    return asked && watch->steps_at_rest >= simulation->scene->rest.steps;
}

bool mpm_simulation_stagnates(const struct mpm_simulation *simulation)
{
    const int64_t patience = simulation->scene->rest.patience;
    const uint64_t lowest = simulation->rest.lowest_step;
    return patience > 0 && lowest != 0 && simulation->step - lowest >= (uint64_t)patience;
}
