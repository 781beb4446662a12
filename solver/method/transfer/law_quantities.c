/* What particles have of energy and temperature, by their laws; see law_state.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"

#include "mpm.h"

#include <math.h>

bool mpm_scene_is_viscous(const struct mpm_scene *scene)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || scene->materials[k].viscosity.given;
    return any;
}

static const struct mpm_material *material_of(const struct mpm_state *state, size_t p)
{
    return &state->bodies[state->particles.body[p]].material;
}

static void load_variables(const struct mpm_particles *particles, size_t p,
                           const struct mpm_material_law *law, double variables[MPM_LAW_STATES])
{
    for (size_t k = 0; k < law->variable_count; k++)
        variables[k] = *mpm_particle_law_state(particles, p, k);
}

/* F without free expansion */
static void elastic_part(const struct mpm_particles *particles, size_t p,
                         double f[MPM_GRADIENT_SIZE])
{
    mpm_particle_deformation(particles, p, f);
    if (particles->free_strain == NULL || particles->free_strain[p] == 0.0)
        return;
    const double scale = exp(-particles->free_strain[p]);
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] *= scale;
}

double mpm_particle_viscous_work(const struct mpm_state *state, size_t p)
{
    return state->particles.viscous[1] == NULL ? 0.0 : state->particles.viscous[1][p];
}

double mpm_particle_strain_energy(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = material_of(state, p);
    const struct mpm_material_law *const law = material->law;
    double f[MPM_GRADIENT_SIZE], variables[MPM_LAW_STATES];
    if (law->energy == NULL)
        return *mpm_particle_law_state(particles, p, law->variable_count);
    elastic_part(particles, p, f);
    load_variables(particles, p, law, variables);
    const double energy = law->energy(material, f, variables);
    if (!law->keeps_heat)
        return energy;
    return energy - mpm_particle_viscous_work(state, p) - mpm_particle_dissipation(state, p);
}

double mpm_particle_internal_energy(const struct mpm_state *state, size_t p)
{
    const struct mpm_material *const material = material_of(state, p);
    double f[MPM_GRADIENT_SIZE], variables[MPM_LAW_STATES];
    if (!material->law->keeps_heat)
        return 0.0;
    elastic_part(&state->particles, p, f);
    load_variables(&state->particles, p, material->law, variables);
    return material->law->energy(material, f, variables);
}

double mpm_particle_state_temperature(const struct mpm_state *state, size_t p)
{
    const struct mpm_material *const material = material_of(state, p);
    double f[MPM_GRADIENT_SIZE], variables[MPM_LAW_STATES];
    if (!mpm_material_has_temperature(material->law, material->parameter))
        return 0.0;
    elastic_part(&state->particles, p, f);
    load_variables(&state->particles, p, material->law, variables);
    return material->law->temperature(material, f, variables);
}

bool mpm_particle_is_melted(const struct mpm_state *state, size_t p)
{
    const struct mpm_material *const material = material_of(state, p);
    const double melting = material->parameter[MPM_PARAMETER_MELTING_TEMPERATURE];
    const bool conducted = mpm_material_softens(material->law, material->parameter);
    return melting > 0.0 && (conducted ? state->particles.law_temperature[p]
                                       : mpm_particle_state_temperature(state, p)) >= melting;
}

/* Per unit mass, since t = 0. */
static double plastic_work(const struct mpm_state *state, size_t p)
{
    const struct mpm_material *const material = material_of(state, p);
    double variables[MPM_LAW_STATES];
    if (material->law->dissipation == NULL)
        return 0.0;
    load_variables(&state->particles, p, material->law, variables);
    return material->law->dissipation(material, variables);
}

/* The part of it that heats the conducted temperature. */
static double heating(const struct mpm_state *state, size_t p)
{
    const struct mpm_material *const material = material_of(state, p);
    return mpm_material_plastic_heating(material->law, material->parameter);
}

double mpm_particle_dissipation(const struct mpm_state *state, size_t p)
{
    return (1.0 - heating(state, p)) * plastic_work(state, p);
}

double mpm_particle_plastic_heat(const struct mpm_state *state, size_t p)
{
    const double part = heating(state, p);
    return part > 0.0 ? part * plastic_work(state, p) : 0.0;
}

double mpm_particle_thermoelastic_energy(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const double alpha =
        state->bodies[particles->body[p]].given->expansion[MPM_TEMPERATURE].coefficient;
    if (!state->scene->scalars[MPM_TEMPERATURE].heats || alpha == 0.0)
        return 0.0;
    return alpha * particles->law_temperature[p] *
           (particles->stress[MPM_SYM_XX][p] + particles->stress[MPM_SYM_YY][p] +
            particles->stress[MPM_SYM_ZZ][p]);
}
