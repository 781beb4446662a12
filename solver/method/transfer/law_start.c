/* What laws have of particles at t = 0; see law_state.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"

size_t mpm_law_states_of(const struct mpm_scene *scene)
{
    size_t most = 0;
    for (size_t k = 0; k < scene->body_count; k++) {
        if (scene->bodies[k].rigid)
            continue;
        const size_t count = mpm_law_state_count(scene->materials[scene->bodies[k].material].law);
        most = count > most ? count : most;
    }
    return most;
}

unsigned mpm_law_uses(const struct mpm_scene *scene)
{
    return (mpm_law_states_of(scene) > 0 ? MPM_USE_LAW_STATE : 0U) |
           (mpm_scene_is_viscous(scene) ? MPM_USE_VISCOSITY : 0U);
}

/* Of F at hand, which gets its F_zz. */
static void begin_stress(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    double f[MPM_GRADIENT_SIZE], stress[MPM_SYMMETRIC_SIZE], square;
    mpm_particle_deformation(particles, p, f);
    if (state->scene->geometry == MPM_PLANE_STRESS)
        particles->deformation[MPM_ZZ][p] = mpm_particle_thickness(state, p, f);
    mpm_particle_find_stress(state, p, stress, &square);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        particles->stress[k][p] = stress[k];
}

void mpm_law_states_begin(struct mpm_state *state)
{
    const struct mpm_particles *const particles = &state->particles;
    const size_t carried = particles->components[MPM_PARTICLE_LAW_STATE];
    for (size_t p = 0; carried > 0 && p < particles->count; p++) {
        const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
        double start[MPM_LAW_STATES] = {0.0};
        mpm_material_start(material, start);
        for (size_t k = 0; k < carried; k++)
            *mpm_particle_law_state(particles, p, k) = start[k];
        if (material->law->start != NULL)
            begin_stress(state, p);
    }
}

static void begin_scalars(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    double value[MPM_SCALAR_COUNT] = {0.0};
    for (size_t k = 0; k < state->transport.count; k++)
        value[state->transport.list[k].which] = ((const double *)mpm_particle_array(
            particles, state->transport.list[k].row->field, 0))[p];
    if (particles->free_strain != NULL)
        particles->free_strain[p] = mpm_free_strain(state->bodies[particles->body[p]].given, value);
    if (particles->law_temperature != NULL)
        particles->law_temperature[p] = value[MPM_TEMPERATURE];
}

enum mpm_status mpm_law_scalars_begin(struct mpm_state *state)
{
    for (size_t p = 0; mpm_scene_couples(state->scene) && p < state->particles.count; p++) {
        begin_scalars(state, p);
        double temperature;
        const enum mpm_failure_kind fault = mpm_particle_judge_temperature(state, p, &temperature);
        if (fault != MPM_NO_FAILURE) {
            state->failure = (struct mpm_failure){fault, .particle = state->particles.id[p],
                                                  .value = temperature};
            return MPM_RUN_FAILED;
        }
        begin_stress(state, p);
    }
    return MPM_OK;
}
