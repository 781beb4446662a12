/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fields/fields.h"
#include "simulation/simulation.h"

#include <math.h>

double mpm_kinetic_energy(const struct mpm_state *state)
{
    double sum = 0.0;
    for (int64_t s = 0; s < state->strip_count; s++)
        sum += state->strips[s].kinetic_energy;
    return sum;
}

void mpm_simulation_count_step(struct mpm_simulation *simulation)
{
    simulation->largest_work =
        fmax(simulation->largest_work, fabs(simulation->state.external_work) +
                                           fabs(simulation->state.transport.expansion.work));
    simulation->step++;
}

/* Keeps the message for good and goes back to the last good state: that after `step`, unless the
 * energy of one of the steps before, which nothing has judged, is unsound already. */
static enum mpm_status fail(struct mpm_simulation *simulation, uint64_t step,
                            struct mpm_error *error)
{
    const uint64_t judged = simulation->judged_step, saved = simulation->backup.step;
    simulation->failure = *error;
    mpm_backup_restore(simulation, judged > saved ? judged : saved);
    while (simulation->step < step) {
        (void)mpm_backup_repeat(simulation); /* it has succeeded before */
        if (mpm_energy_judge(simulation, &simulation->failure) == MPM_OK)
            continue;
        *error = simulation->failure;
        mpm_backup_restore(simulation, simulation->step - 1);
        break;
    }
    return MPM_RUN_FAILED;
}

enum mpm_status mpm_simulation_take_step(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    enum mpm_status status = mpm_step_advance(state, simulation->seconds, error);
    if (status == MPM_OK || state->failure.kind != MPM_NO_FAILURE)
        status = mpm_health_check(simulation, error);
    if (status == MPM_OK)
        status = mpm_cracks_grow(simulation, error);
    if (status != MPM_OK)
        mpm_error_locate(error, simulation->step + 1, state->time + state->time_step);
    return status;
}

/* Results follow: at a time of them, or after the last step of the scene. */
static bool ends_at_results(const struct mpm_simulation *simulation, bool lands)
{
    const int64_t steps = simulation->scene->steps;
    return lands || (steps > 0 && simulation->step + 1 >= (uint64_t)steps);
}

enum mpm_status mpm_simulation_advance(struct mpm_simulation *simulation, double time_limit,
                                       struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    struct mpm_error unheard = {0};
    error = error == NULL ? &unheard : error;
    if (simulation->failure.status != MPM_OK) {
        *error = simulation->failure;
        return error->status;
    }
    if (!(time_limit > state->time))
        return mpm_error_set(error, MPM_BAD_INPUT, "time limit %g; allowed: after the time %g",
                             time_limit, state->time);
    if (mpm_step_wants_sort(state)) {
        MPM_TRY(mpm_simulation_judge(simulation, error));
        mpm_step_sort(state, simulation->backup.particles, simulation->seconds);
        mpm_backup_save(simulation);
    }
    bool lands;
    state->time_step = mpm_time_step_next(simulation, time_limit, &lands);
    state->transport.flush = ends_at_results(simulation, lands);
    if (mpm_simulation_take_step(simulation, error) != MPM_OK)
        return fail(simulation, simulation->step, error);
    const uint64_t since = simulation->step - simulation->backup.step;
    state->time = lands ? time_limit : state->time + state->time_step;
    simulation->backup.time_steps[since] = state->time_step;
    simulation->backup.times[since] = state->time;
    simulation->backup.flushed[since] = state->transport.flush;
    mpm_speeds_update(simulation);
    mpm_simulation_count_step(simulation);
    if (simulation->scene->rest.asked)
        mpm_rest_judge(simulation);
    if (mpm_energy_is_in_doubt(simulation))
        MPM_TRY(mpm_simulation_judge(simulation, error));
    mpm_simulation_look(simulation, MPM_AFTER_STEP);
    return MPM_OK;
}

void mpm_simulation_look(const struct mpm_simulation *simulation, enum mpm_moment moment)
{
    const struct mpm_monitor *const monitor = simulation->monitor;
    if (monitor != NULL)
        monitor->look(monitor->context, moment, simulation);
}

const struct mpm_scene *mpm_simulation_scene(const struct mpm_simulation *simulation)
{
    return simulation->scene;
}

enum mpm_status mpm_simulation_judge(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_error why = {0};
    if (simulation->failure.status != MPM_OK)
        why = simulation->failure;
    else if (mpm_energy_judge(simulation, &why) != MPM_OK)
        (void)fail(simulation, simulation->step - 1, &why);
    if (error != NULL && why.status != MPM_OK)
        *error = why;
    return why.status;
}

double mpm_simulation_time(const struct mpm_simulation *simulation)
{
    return simulation->state.time;
}

uint64_t mpm_simulation_step(const struct mpm_simulation *simulation)
{
    return simulation->step;
}

double mpm_simulation_time_step(const struct mpm_simulation *simulation)
{
    return simulation->state.time_step;
}

size_t mpm_simulation_particle_count(const struct mpm_simulation *simulation)
{
    return simulation->state.particles.count + simulation->state.rigid.count;
}

size_t mpm_simulation_bytes(const struct mpm_simulation *simulation)
{
    return simulation->arena.capacity + simulation->user_force.capacity + sizeof *simulation +
           simulation->state.conditions.count * sizeof *simulation->state.conditions.list;
}

const char *mpm_simulation_kernels(const struct mpm_simulation *simulation)
{
    return simulation->state.kernels.name;
}

size_t mpm_simulation_field_particles(const struct mpm_simulation *simulation)
{
    return simulation->state.fields.use_count;
}

const char *mpm_simulation_simd(const struct mpm_simulation *simulation)
{
    return simulation->state.kernels.simd;
}

void mpm_simulation_phases(const struct mpm_simulation *simulation, struct mpm_phases *phases)
{
    phases->count = MPM_PHASE_COUNT;
    for (size_t k = 0; k < MPM_PHASE_COUNT; k++) {
        phases->name[k] = mpm_phase_names[k];
        phases->seconds[k] = simulation->seconds[k];
    }
}
