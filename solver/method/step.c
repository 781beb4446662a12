/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/step.h"

#include "base/strips.h"
#include "method/conditions.h"
#include "method/grid_update.h"
#include "method/transfer.h"

#include <time.h>

static const struct mpm_stress_order orders[] = {
    [MPM_USL] = {.name = "usl", .before = 0.0, .after = 1.0, .extrapolate = false},
    [MPM_MUSL] = {.name = "musl", .before = 0.0, .after = 1.0, .extrapolate = true},
    [MPM_USF] = {.name = "usf", .before = 1.0, .after = 0.0, .extrapolate = false},
    [MPM_USAVG] = {.name = "usavg", .before = 0.5, .after = 0.5, .extrapolate = true},
};

const struct mpm_stress_order *mpm_stress_order(enum mpm_stress_update update)
{
    return &orders[update];
}

const char *const mpm_phase_names[MPM_PHASE_COUNT] = {
    [MPM_PHASE_TO_GRID] = "particles_to_grid",
    [MPM_PHASE_GRID] = "grid",
    [MPM_PHASE_TO_PARTICLES] = "grid_to_particles",
    [MPM_PHASE_STRESS] = "stress_and_position",
    [MPM_PHASE_SORT] = "sort",
};

void mpm_failure_merge(struct mpm_failure *into, const struct mpm_failure *failure)
{
    if (failure->kind == MPM_NO_FAILURE)
        return;
    if (into->kind == MPM_NO_FAILURE || failure->particle < into->particle)
        *into = *failure;
}

/* ------------------------------------------------------------------ running */

static double seconds_now(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Charges the time since *mark to a phase. */
static void charge(double seconds[MPM_PHASE_COUNT], enum mpm_phase phase, double *mark)
{
    const double now = seconds_now();
    seconds[phase] += now - *mark;
    *mark = now;
}

/* Strips of one colour may run together only while their boxes keep apart. CPDI
 * domains may grow beyond any fixed margin: then one worker runs the same order. */
static bool strips_touch(const struct mpm_state *state)
{
    int64_t reached[2] = {INT64_MIN, INT64_MIN}; /* highest row so far, per colour */
    for (int64_t s = 0; s < state->strip_count; s++) {
        const struct mpm_strip *const strip = &state->strips[s];
        if (strip->begin == strip->end)
            continue;
        if (strip->row_low <= reached[s % 2])
            return true;
        reached[s % 2] = strip->row_high;
    }
    return false;
}

static void run_particles(struct mpm_state *state, int workers, mpm_pass *pass)
{
    if (pass != NULL)
        mpm_strips_run(state->strip_count, workers, pass, state);
}

static void run_rows(struct mpm_state *state, void (*pass)(void *, int64_t, int))
{
    mpm_rows_run(state->first_row, state->last_row, state->workers, pass, state);
}

/* ------------------------------------------------------------------ sorting */

void mpm_step_sort(struct mpm_state *state, double *const kept[MPM_KEPT_ARRAYS],
                   double seconds[MPM_PHASE_COUNT])
{
    double mark = seconds_now();
    struct mpm_particles *const particles = &state->particles;
    mpm_particles_sort(particles, &state->grid, state->sort_size, state->sort_counts, kept);
    size_t p = 0;
    for (int64_t s = 0; s < state->strip_count; s++) {
        struct mpm_strip *const strip = &state->strips[s];
        strip->begin = p;
        while (p < particles->count &&
               mpm_particle_cell(&state->grid, 1, particles->position[1][p], state->sort_size) <
                   (s + 1) * MPM_STRIP_ROWS)
            p++;
        strip->end = p;
    }
    run_particles(state, state->workers, mpm_pass_measure);
    state->strips_touch_when_sorted = strips_touch(state);
    state->steps_since_sort = 0;
    charge(seconds, MPM_PHASE_SORT, &mark);
}

void mpm_step_recompute(struct mpm_state *state)
{
    run_particles(state, state->workers, state->kernels.passes->recompute);
    run_particles(state, state->workers, mpm_pass_measure);
}

bool mpm_step_wants_sort(const struct mpm_state *state)
{
    return state->steps_since_sort >= MPM_STEPS_BETWEEN_SORTS ||
           (!state->strips_touch_when_sorted && strips_touch(state));
}

/* ----------------------------------------------------------------- the step */

static enum mpm_status collect(struct mpm_state *state)
{
    for (int64_t s = 0; s < state->strip_count; s++)
        mpm_failure_merge(&state->failure, &state->strips[s].failure);
    return state->failure.kind == MPM_NO_FAILURE ? MPM_OK : MPM_RUN_FAILED;
}

static double body_work(const struct mpm_state *state)
{
    double work = 0.0;
    for (int64_t s = 0; s < state->strip_count; s++)
        work += state->strips[s].external_work;
    return work;
}

enum mpm_status mpm_step_advance(struct mpm_state *state, double seconds[MPM_PHASE_COUNT],
                                 struct mpm_error *error)
{
    const struct mpm_stress_order *const order = state->order;
    const bool has_body_force =
        state->body_force.component[0] != NULL || state->body_force.component[1] != NULL;
    const struct mpm_passes *const passes = state->kernels.passes;
    const int workers = strips_touch(state) ? 1 : state->workers;
    double mark = seconds_now();

    mpm_grid_find_active(state);
    run_rows(state, mpm_row_clear);
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 1: mass and momentum of the nodes (26); with the stress at hand also Task 3 */
    run_particles(state, workers, passes->to_grid);
    charge(seconds, MPM_PHASE_TO_GRID, &mark);

    /* Task 2: velocities at the start, conditions */
    run_rows(state, mpm_row_start_velocity);
    MPM_TRY(mpm_conditions_gather(state, error));
    mpm_conditions_apply_start(state);
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 2 for USF and USAVG: stress update (35), (36); Task 3: forces (28) */
    run_particles(state, workers, passes->stress_before);
    if (has_body_force)
        run_particles(state, workers, mpm_pass_body_force);
    charge(seconds, MPM_PHASE_STRESS, &mark);

    /* Task 4: momentum update (29), conditions */
    run_rows(state, mpm_row_update);
    mpm_conditions_apply_end(state);
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 5: particle velocities (30); Task 6 for MUSL and USAVG: extrapolate them (31) */
    if (state->scene->flip_fraction < 1.0)
        run_particles(state, workers, mpm_pass_flip_fraction);
    run_particles(state, workers, passes->to_particles);
    charge(seconds, MPM_PHASE_TO_PARTICLES, &mark);
    if (order->extrapolate) {
        run_rows(state, mpm_row_extrapolated_velocity);
        mpm_conditions_apply_extrapolated(state);
    }
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 6: stress update of USL, MUSL, USAVG; Task 5: positions, last, since every
     * task uses the shape functions of the positions at the start */
    if (has_body_force)
        run_particles(state, workers, mpm_pass_body_work);
    run_particles(state, workers, passes->finish);
    charge(seconds, MPM_PHASE_STRESS, &mark);

    if (has_body_force)
        state->external_work += body_work(state);
    MPM_TRY(mpm_rigid_advance(state, error));
    state->steps_since_sort++;
    return collect(state);
}
