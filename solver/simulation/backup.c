/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_opening.h"
#include "simulation/simulation.h"

#include <assert.h>
#include <string.h>

/* What steps change of the points of cracks; NULL where a scene has none of it. */
static void copy_points(struct mpm_simulation *simulation, bool back)
{
    const struct mpm_cracks *const cracks = &simulation->state.cracks;
    double *const now[MPM_CRACK_ARRAYS] = {cracks->position[0], cracks->position[1],
                                           cracks->openings.vector[0], cracks->openings.vector[1],
                                           cracks->openings.largest};
    double *const *const saved = simulation->backup.crack_points;
    for (int k = 0; k < MPM_CRACK_ARRAYS; k++)
        if (now[k] != NULL)
            memcpy(back ? now[k] : saved[k], back ? saved[k] : now[k],
                   cracks->point_count * sizeof(double));
}

/* What contact between bodies has added up. */
static void copy_contact(struct mpm_simulation *simulation, bool back)
{
    const struct mpm_body_contact *const contact = &simulation->state.contact;
    struct mpm_backup *const backup = &simulation->backup;
    const size_t pairs = simulation->scene->contact.pair_count;
    if (pairs == 0)
        return;
    memcpy(back ? contact->totals : backup->contact_totals,
           back ? backup->contact_totals : contact->totals, pairs * sizeof *contact->totals);
    memcpy(back ? contact->samples : backup->contact_samples,
           back ? backup->contact_samples : contact->samples, pairs * sizeof *contact->samples);
}

size_t mpm_backup_crack_points(const struct mpm_simulation *simulation, int array)
{
    const size_t followed = mpm_openings_points(&simulation->state);
    const size_t cohesive = mpm_scene_is_cohesive(simulation->scene) ? followed : 0;
    const size_t all = simulation->state.cracks.point_count;
    const size_t counts[MPM_CRACK_ARRAYS] = {all, all, followed, followed, cohesive};
    return counts[array];
}

void mpm_backup_layout(struct mpm_simulation *simulation, struct mpm_arena *arena)
{
    struct mpm_backup *const backup = &simulation->backup;
    const struct mpm_particles rigid = mpm_rigid_particles_set(&simulation->state.rigid);
    backup->particles =
        MPM_TAKE(arena, unsigned char, mpm_particles_kept_bytes(&simulation->state.particles));
    backup->rigid = MPM_TAKE(arena, unsigned char, mpm_particles_kept_bytes(&rigid));
    mpm_growth_layout(simulation, arena);
    const size_t pairs = simulation->scene->contact.pair_count;
    backup->contact_totals = MPM_TAKE(arena, struct mpm_contact_totals, pairs);
    backup->contact_samples = MPM_TAKE(arena, struct mpm_contact_sample, pairs);
    for (int k = 0; k < MPM_CRACK_ARRAYS; k++)
        backup->crack_points[k] = MPM_TAKE(arena, double, mpm_backup_crack_points(simulation, k));
}

void mpm_backup_save(struct mpm_simulation *simulation)
{
    const struct mpm_state *const state = &simulation->state;
    struct mpm_backup *const backup = &simulation->backup;
    const struct mpm_particles rigid = mpm_rigid_particles_set(&state->rigid);
    mpm_particles_keep(&rigid, backup->rigid);
    copy_points(simulation, false);
    copy_contact(simulation, false);
    mpm_growth_save(simulation);
    backup->time = state->time;
    backup->external_work = state->external_work;
    backup->largest_work = simulation->largest_work;
    backup->sudden_energy = state->sudden_energy;
    backup->damping = state->damping.totals;
    backup->expansion = state->transport.expansion;
    backup->transport_waited = state->transport.waited;
    backup->transport_steps_waited = state->transport.steps_waited;
    backup->energy = state->energy;
    backup->wave_speed = simulation->wave_speed;
    backup->diffusivity = simulation->diffusivity;
    backup->film = simulation->film;
    for (size_t k = 0; k < state->transport.count; k++)
        backup->scalars[k] = state->transport.list[k].totals;
    backup->step = simulation->step;
}

static void copy_back(struct mpm_simulation *simulation)
{
    struct mpm_state *const state = &simulation->state;
    const struct mpm_backup *const backup = &simulation->backup;
    const struct mpm_particles rigid = mpm_rigid_particles_set(&state->rigid);
    mpm_particles_put_back(&state->particles, backup->particles);
    mpm_particles_put_back(&rigid, backup->rigid);
    copy_points(simulation, true);
    copy_contact(simulation, true);
    mpm_growth_restore(simulation);
    state->time = backup->time;
    state->external_work = backup->external_work;
    simulation->largest_work = backup->largest_work;
    state->sudden_energy = backup->sudden_energy;
    state->damping.totals = backup->damping;
    state->transport.expansion = backup->expansion;
    state->transport.waited = backup->transport_waited;
    state->transport.steps_waited = backup->transport_steps_waited;
    state->energy = backup->energy;
    simulation->wave_speed = backup->wave_speed;
    simulation->diffusivity = state->transport.diffusivity = backup->diffusivity;
    simulation->film = state->transport.film = backup->film;
    for (size_t k = 0; k < state->transport.count; k++)
        state->transport.list[k].totals = backup->scalars[k];
    simulation->step = backup->step;
}

enum mpm_status mpm_backup_repeat(struct mpm_simulation *simulation)
{
    struct mpm_state *const state = &simulation->state;
    const uint64_t k = simulation->step - simulation->backup.step;
    state->time_step = simulation->backup.time_steps[k];
    state->transport.flush = simulation->backup.flushed[k];
    MPM_TRY(mpm_simulation_take_step(simulation, NULL));
    state->time = simulation->backup.times[k];
    mpm_simulation_count_step(simulation);
    return MPM_OK;
}

void mpm_backup_restore(struct mpm_simulation *simulation, uint64_t step)
{
    struct mpm_state *const state = &simulation->state;
    const struct mpm_backup *const backup = &simulation->backup;
    assert(step >= backup->step && step - backup->step <= MPM_STEPS_BETWEEN_SORTS);
    copy_back(simulation);
    state->failure = (struct mpm_failure){0};
    for (int64_t s = 0; s < state->strip_count; s++)
        state->strips[s].failure = (struct mpm_failure){0};
    mpm_step_recompute(state);
    /* stress, where it is saved: not from F by the one kernel */
    mpm_particles_put_back(&state->particles, backup->particles);
    while (simulation->step < step && mpm_backup_repeat(simulation) == MPM_OK)
        continue;
}

enum mpm_status mpm_backup_resume(struct mpm_simulation *simulation, uint64_t step,
                                  struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    double unused[MPM_PHASE_COUNT] = {0.0};
    copy_back(simulation);
    MPM_TRY(mpm_cracks_check(state, error));
    MPM_TRY(mpm_crack_openings_check(state, error));
    mpm_step_recompute(state); /* domains, by which the sort finds what strips reach */
    mpm_particles_put_back(&state->particles, simulation->backup.particles);
    MPM_TRY(mpm_step_collect(state));
    mpm_step_sort(state, simulation->backup.particles, unused);
    MPM_TRY(mpm_step_collect(state));
    mpm_backup_restore(simulation, step);
    return simulation->step == step ? mpm_step_collect(state) : MPM_RUN_FAILED;
}
