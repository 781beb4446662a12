/* Input of the caller that a scene cannot state: a user force, a start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/user_force.h"
#include "method/transfer/law_state.h"
#include "simulation/simulation.h"

#include <math.h>

static enum mpm_status check_time(const struct mpm_simulation *simulation, const char *what,
                                  struct mpm_error *error)
{
    if (simulation->step == 0 && simulation->failure.status == MPM_OK)
        return MPM_OK;
    return mpm_error_set(error, MPM_BAD_INPUT, "%s: set after step %llu; allowed: before the first",
                         what, (unsigned long long)simulation->step);
}

enum mpm_status mpm_simulation_set_body_force(struct mpm_simulation *simulation,
                                              const struct mpm_body_force *force,
                                              struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    MPM_TRY(check_time(simulation, "body force", error));
    if (force != NULL && force->evaluate == NULL)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "body force: evaluate is NULL; allowed: a function");
    state->user_force = (struct mpm_user_force){0};
    mpm_particles_layout_field(&state->particles, MPM_PARTICLE_USER_FORCE, 0,
                               &simulation->user_force);
    mpm_arena_free(&simulation->user_force);
    if (force == NULL)
        return MPM_OK;
    mpm_user_force_layout(state, &simulation->user_force);
    MPM_TRY(mpm_arena_allocate(&simulation->user_force, error));
    mpm_user_force_layout(state, &simulation->user_force);
    state->user_force.caller = *force;
    return MPM_OK;
}

enum { AXES = 2 };

/* NaN if a value is not finite */
static double smallest_stretch(const double f[MPM_GRADIENT_SIZE])
{
    const double plane = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    return isfinite(plane * f[MPM_ZZ]) ? fmin(plane, f[MPM_ZZ]) : (double)NAN;
}

static bool is_undeformed(const double f[MPM_GRADIENT_SIZE])
{
    return f[MPM_XX] == 1.0 && f[MPM_YY] == 1.0 && f[MPM_ZZ] == 1.0 && f[MPM_XY] == 0.0 &&
           f[MPM_YX] == 0.0;
}

/* Without `has_energy`, the work that took the particle to F is not known. */
static enum mpm_status check_particle(const struct mpm_simulation *simulation, uint32_t id,
                                      bool has_energy, const double *v, const double *f,
                                      struct mpm_error *error)
{
    for (int axis = 0; v != NULL && axis < AXES; axis++)
        if (!isfinite(v[axis]))
            return mpm_error_set(error, MPM_BAD_INPUT,
                                 "start: velocity %d of particle %u is %g; allowed: finite", axis,
                                 id, v[axis]);
    if (f == NULL)
        return MPM_OK;
    const bool unknown = !has_energy && !is_undeformed(f);
    if (unknown || !(smallest_stretch(f) > 0.0))
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "start: deformation gradient of particle %u is %g %g %g %g %g; %s", id,
                             f[MPM_XX], f[MPM_XY], f[MPM_YX], f[MPM_YY], f[MPM_ZZ],
                             unknown ? "allowed for a law without a strain energy: 1 0 0 1 1"
                                     : "allowed: finite, F_xx F_yy - F_xy F_yx > 0 and F_zz > 0");
    if (simulation->scene->geometry == MPM_PLANE_STRAIN && f[MPM_ZZ] != 1.0)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "start: F_zz of particle %u is %.17g; allowed: 1 in plane strain", id,
                             f[MPM_ZZ]);
    return MPM_OK;
}

static void set_deformation(const struct mpm_simulation *simulation, size_t p, const double *given)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    double f[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = given[k];
    if (simulation->scene->geometry == MPM_PLANE_STRESS)
        f[MPM_ZZ] = mpm_particle_thickness(&simulation->state, p, f);
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        particles->deformation[k][p] = f[k];
}

enum mpm_status mpm_simulation_set_start(struct mpm_simulation *simulation, const double *velocity,
                                         const double *deformation_gradient,
                                         struct mpm_error *error)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    MPM_TRY(check_time(simulation, "start", error));
    for (size_t p = 0; p < particles->count; p++) {
        const size_t id = particles->id[p];
        const double *const v = velocity == NULL ? NULL : velocity + AXES * id;
        const double *const f =
            deformation_gradient == NULL ? NULL : deformation_gradient + MPM_GRADIENT_SIZE * id;
        const bool has_energy =
            simulation->state.bodies[particles->body[p]].material.law->energy != NULL;
        MPM_TRY(check_particle(simulation, particles->id[p], has_energy, v, f, error));
    }
    for (size_t p = 0; p < particles->count; p++) {
        const size_t id = particles->id[p];
        for (int axis = 0; velocity != NULL && axis < AXES; axis++)
            particles->velocity[axis][p] = velocity[AXES * id + (size_t)axis];
        if (deformation_gradient != NULL)
            set_deformation(simulation, p, deformation_gradient + MPM_GRADIENT_SIZE * id);
    }
    mpm_law_states_begin(&simulation->state);
    (void)mpm_law_scalars_begin(&simulation->state); /* temperatures are those of before */
    mpm_step_recompute(&simulation->state);
    struct mpm_error why = {0};
    const enum mpm_status status =
        mpm_simulation_open(simulation, mpm_fastest_wave(&simulation->state), &why);
    if (status == MPM_OK)
        return MPM_OK;
    simulation->failure = why;
    if (error != NULL)
        *error = why;
    return status;
}
