/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/cohesive_traction.h"
#include "method/transfer/affine.h"
#include "method/transfer/law_state.h"
#include "simulation/simulation.h"

#include <math.h>

bool mpm_scene_is_plastic(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || scene->materials[k].law->dissipation != NULL;
    return any;
}

bool mpm_scene_melts(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || scene->materials[k].parameter[MPM_PARAMETER_MELTING_TEMPERATURE] > 0.0;
    return any;
}

static void add_particle(const struct mpm_simulation *simulation, size_t p,
                         struct mpm_ledger *ledger)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const double mass = particles->mass[p];
    const double x = particles->position[0][p], y = particles->position[1][p];
    const double vx = particles->velocity[0][p], vy = particles->velocity[1][p];
    double f[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = particles->deformation[k][p];
    const double j = mpm_determinant(f);
    ledger->mass += mass;
    ledger->momentum[0] += mass * vx;
    ledger->momentum[1] += mass * vy;
    if (simulation->scene->geometry != MPM_AXISYMMETRIC)
        ledger->angular_momentum += mass * (x * vy - y * vx);
    if (particles->affine[0] != NULL && simulation->scene->geometry != MPM_AXISYMMETRIC)
        ledger->angular_momentum += mass * mpm_particle_spin(&simulation->state, p);
    ledger->kinetic_energy += 0.5 * mass * (vx * vx + vy * vy);
    ledger->strain_energy += mass * mpm_particle_strain_energy(&simulation->state, p);
    ledger->plastic_dissipation += mass * mpm_particle_dissipation(&simulation->state, p);
    ledger->plastic_heat += mass * mpm_particle_plastic_heat(&simulation->state, p);
    ledger->viscous_dissipation += mass * mpm_particle_viscous_work(&simulation->state, p);
    ledger->melted_particles += mpm_particle_is_melted(&simulation->state, p);
    if (simulation->scene->scalars[MPM_TEMPERATURE].heats)
        ledger->thermoelastic_energy +=
            mass * mpm_particle_thermoelastic_energy(&simulation->state, p);
    ledger->j_min = fmin(ledger->j_min, j);
    ledger->j_max = fmax(ledger->j_max, j);
}

void mpm_simulation_ledger(const struct mpm_simulation *simulation, struct mpm_ledger *ledger)
{
    const struct mpm_energy_balance *const energy = &simulation->state.energy;
    *ledger = (struct mpm_ledger){
        .time = simulation->state.time,
        .step = simulation->step,
        .external_work = simulation->state.external_work,
        .damping_dissipation = simulation->state.damping.totals.dissipated,
        .expansion_work = simulation->state.transport.expansion.work,
        .deformation_heat = simulation->state.transport.expansion.heat,
        .j_min = HUGE_VAL,
        .j_max = -HUGE_VAL,
    };
    for (size_t p = 0; p < simulation->state.particles.count; p++)
        add_particle(simulation, p, ledger);
    ledger->parted_pairs = mpm_parting_count(simulation);
    mpm_cohesive_energies(&simulation->state, &ledger->cohesive_stored,
                          &ledger->cohesive_dissipated);
    mpm_contact_energies(&simulation->state, &ledger->contact_stored, &ledger->contact_dissipated);
    ledger->total_energy = ledger->kinetic_energy + ledger->strain_energy +
                           ledger->damping_dissipation + ledger->plastic_dissipation +
                           ledger->viscous_dissipation + ledger->cohesive_stored +
                           ledger->cohesive_dissipated + ledger->contact_stored +
                           ledger->contact_dissipated - ledger->expansion_work;
    if (energy->measured) {
        ledger->contact_loss =
            energy->contact - ledger->contact_stored - ledger->contact_dissipated;
        ledger->transfer_loss = energy->lost + energy->internal_work -
                                (ledger->strain_energy - simulation->strain_start) -
                                ledger->plastic_dissipation - ledger->plastic_heat -
                                ledger->viscous_dissipation + ledger->expansion_work -
                                ledger->cohesive_stored - ledger->cohesive_dissipated;
    }
}
