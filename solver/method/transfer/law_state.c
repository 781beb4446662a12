/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"

#include <math.h>

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

void mpm_law_states_begin(struct mpm_state *state)
{
    const struct mpm_particles *const particles = &state->particles;
    const size_t carried = particles->components[MPM_PARTICLE_LAW_STATE];
    for (size_t p = 0; carried > 0 && p < particles->count; p++) {
        const struct mpm_material_law *const law = state->bodies[particles->body[p]].material.law;
        for (size_t k = 0; k < carried; k++)
            *mpm_particle_law_state(particles, p, k) =
                k < law->variable_count ? law->variables[k].start : 0.0;
    }
}

/* tau : (dF F^-1) */
static double work_rate(const double tau[MPM_SYMMETRIC_SIZE], const double df[MPM_GRADIENT_SIZE],
                        const double f[MPM_GRADIENT_SIZE])
{
    const double area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const double xx = df[MPM_XX] * f[MPM_YY] - df[MPM_XY] * f[MPM_YX];
    const double xy = df[MPM_XY] * f[MPM_XX] - df[MPM_XX] * f[MPM_XY];
    const double yx = df[MPM_YX] * f[MPM_YY] - df[MPM_YY] * f[MPM_YX];
    const double yy = df[MPM_YY] * f[MPM_XX] - df[MPM_YX] * f[MPM_XY];
    return (tau[MPM_SYM_XX] * xx + tau[MPM_SYM_YY] * yy + tau[MPM_SYM_XY] * (xy + yx)) / area +
           tau[MPM_SYM_ZZ] * df[MPM_ZZ] / f[MPM_ZZ];
}

/* Integral of P : dF from the old F to the new one by the trapezoidal rule; P = tau F^-T is the
 * first Piola-Kirchhoff stress over rho_0. Error of third order in dF. */
static double stress_work(const double old_stress[MPM_SYMMETRIC_SIZE],
                          const double stress[MPM_SYMMETRIC_SIZE], const struct mpm_law_step *step)
{
    double df[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        df[k] = step->f[k] - step->old_f[k];
    return 0.5 * (work_rate(old_stress, df, step->old_f) + work_rate(stress, df, step->f));
}

static void load_variables(const struct mpm_particles *particles, size_t p,
                           const struct mpm_material_law *law, double variables[MPM_LAW_STATES])
{
    for (size_t k = 0; k < law->variable_count; k++)
        variables[k] = *mpm_particle_law_state(particles, p, k);
}

void mpm_particle_update_law(const struct mpm_state *state, size_t p,
                             const double f[MPM_GRADIENT_SIZE], double duration,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
    const struct mpm_material_law *const law = material->law;
    double old_f[MPM_GRADIENT_SIZE], old_stress[MPM_SYMMETRIC_SIZE], variables[MPM_LAW_STATES];
    mpm_particle_deformation(particles, p, old_f);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        old_stress[k] = particles->stress[k][p];
    load_variables(particles, p, law, variables);
    const struct mpm_law_step step = {old_f, f, duration, (double)NAN};
    if (law->update != NULL)
        law->update(material, &step, variables, stress, wave_speed_squared);
    else
        law->stress(material, f, stress, wave_speed_squared);
    for (size_t k = 0; k < law->variable_count; k++)
        *mpm_particle_law_state(particles, p, k) = variables[k];
    if (law->energy == NULL)
        *mpm_particle_law_state(particles, p, law->variable_count) +=
            stress_work(old_stress, stress, &step);
}

void mpm_particle_find_stress(const struct mpm_state *state, size_t p,
                              double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
    double f[MPM_GRADIENT_SIZE];
    mpm_particle_deformation(particles, p, f);
    if (particles->law_state == NULL)
        material->law->stress(material, f, stress, wave_speed_squared);
    else
        mpm_particle_update_law(state, p, f, 0.0, stress, wave_speed_squared);
}

double mpm_particle_strain_energy(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
    const struct mpm_material_law *const law = material->law;
    double f[MPM_GRADIENT_SIZE], variables[MPM_LAW_STATES];
    if (law->energy == NULL)
        return *mpm_particle_law_state(particles, p, law->variable_count);
    mpm_particle_deformation(particles, p, f);
    load_variables(particles, p, law, variables);
    return law->energy(material, f, variables);
}
