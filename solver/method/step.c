/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/step.h"

#include "base/strips.h"
#include "method/contact/body_contact.h"
#include "method/cracks/cohesive_traction.h"
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_detection.h"
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_opening.h"
#include "method/cracks/crack_passages.h"
#include "method/energy_balance.h"
#include "method/fields/fields.h"
#include "method/grid/active_nodes.h"
#include "method/grid/conditions.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/loads/damping.h"
#include "method/loads/edge_loads.h"
#include "method/loads/nodal_force.h"
#include "method/loads/rest.h"
#include "method/loads/user_force.h"
#include "method/transfer/nearby.h"
#include "method/transfer/transfer.h"
#include "method/transport/transport.h"
#include "method/transport/transport_contact.h"
#include "method/transport/transport_coupling.h"
#include "method/transport/transport_rest.h"
#include "method/transport/transport_steps.h"

#include <math.h>
#include <time.h>

const char *const mpm_phase_names[MPM_PHASE_COUNT] = {
    [MPM_PHASE_TO_GRID] = "particles_to_grid",
    [MPM_PHASE_GRID] = "grid",
    [MPM_PHASE_TO_PARTICLES] = "grid_to_particles",
    [MPM_PHASE_STRESS] = "stress_and_position",
    [MPM_PHASE_SORT] = "sort",
    [MPM_PHASE_TRANSPORT] = "transport",
};

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
        if (strip->box.low[1] <= reached[s % 2])
            return true;
        reached[s % 2] = strip->box.high[1];
    }
    return false;
}

static void run_particles(struct mpm_state *state, int workers, mpm_pass *pass)
{
    if (pass != NULL)
        mpm_strips_run(state->strip_count, workers, pass, state);
}

/* ------------------------------------------------------------------ sorting */

void mpm_step_sort(struct mpm_state *state, unsigned char *saved, double seconds[MPM_PHASE_COUNT])
{
    double mark = seconds_now();
    struct mpm_particles *const particles = &state->particles;
    mpm_particles_sort(particles, &state->grid, state->sort_size, state->sort_counts, saved);
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
    mpm_edge_loads_place(state);
    mpm_nearby_forget(state);
    mpm_transport_forget(state);
    run_particles(state, state->workers, mpm_pass_measure);
    state->strips_touch_when_sorted = strips_touch(state);
    state->steps_since_sort = 0;
    charge(seconds, MPM_PHASE_SORT, &mark);
}

void mpm_step_recompute(struct mpm_state *state)
{
    mpm_nearby_forget(state);
    mpm_transport_forget(state);
    if (!state->scene->at_rest)
        run_particles(state, state->workers, state->kernels.passes->recompute);
    run_particles(state, state->workers, mpm_pass_measure);
}

bool mpm_step_wants_sort(const struct mpm_state *state)
{
    return state->steps_since_sort >= MPM_STEPS_BETWEEN_SORTS ||
           (!state->strips_touch_when_sorted && strips_touch(state));
}

/* ----------------------------------------------------------------- the step */

enum mpm_status mpm_step_collect(struct mpm_state *state)
{
    for (int64_t s = 0; s < state->strip_count; s++)
        mpm_failure_merge(&state->failure, &state->strips[s].failure);
    return state->failure.kind == MPM_NO_FAILURE ? MPM_OK : MPM_RUN_FAILED;
}

/* A body force that does not vary in space: its value at the start of the step. */
static enum mpm_status evaluate_uniform_force(struct mpm_state *state)
{
    static const double anywhere[2] = {0.0, 0.0};
    for (int axis = 0; axis < 2; axis++) {
        const struct mpm_expression *const force = state->body_force.component[axis];
        const double b =
            force == NULL ? 0.0 : mpm_expression_value(force, 0, anywhere, state->time);
        state->uniform_force[axis] = b;
        if (!isfinite(b)) {
            state->failure =
                (struct mpm_failure){MPM_UNIFORM_LOAD_NOT_FINITE, .axis = axis, .value = b};
            return MPM_RUN_FAILED;
        }
    }
    return MPM_OK;
}

/* Work of the body force over the step; sums in an order that does not depend on workers. */
static double uniform_work(struct mpm_state *state)
{
    double momentum[2] = {0.0, 0.0};
    mpm_grid_rows_run(state, mpm_row_momentum);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        for (int axis = 0; axis < 2; axis++)
            momentum[axis] += state->row_momentum[row][axis];
    return 0.5 * state->time_step *
           (state->uniform_force[0] * momentum[0] + state->uniform_force[1] * momentum[1]);
}

static double varying_work(struct mpm_state *state, int workers)
{
    double work = 0.0;
    run_particles(state, workers, mpm_pass_body_work);
    for (int64_t s = 0; s < state->strip_count; s++)
        work += state->strips[s].external_work;
    return work;
}

/* Loads that depend on time alone, fields of the nodes, tractions of the state at the start */
static enum mpm_status begin(struct mpm_state *state, int workers, bool uniform_force,
                             struct mpm_error *error)
{
    if (uniform_force)
        MPM_TRY(evaluate_uniform_force(state));
    MPM_TRY(mpm_damping_begin(state, error));
    mpm_grid_find_active(state);
    mpm_fields_begin(state);
    MPM_TRY(mpm_cracks_find_fields(state, workers, error));
    mpm_edge_loads_prepare(state);
    mpm_grid_rows_run(state, mpm_row_clear);
    if (state->kernels.passes->with_scalar)
        mpm_transport_begin(state);
    return MPM_OK;
}

/* Task 1: mass and momentum of the nodes (26); with the stress at hand also Task 3 */
static enum mpm_status spread(struct mpm_state *state, int workers, struct mpm_error *error)
{
    run_particles(state, workers, state->kernels.passes->to_grid);
    mpm_user_force_spread(state, workers);
    if (state->kernels.gather_rows != NULL)
        mpm_grid_rows_run(state, state->kernels.gather_rows);
    mpm_crack_detection_measure(state, workers);
    mpm_symmetries_reflect_momentum(state);
    return mpm_body_contact_begin(state, workers, error);
}

/* Task 6 for MUSL and USAVG: velocities of the momentum extrapolated again (31), conditions */
static void finish_extrapolation(struct mpm_state *state)
{
    mpm_symmetries_reflect_extrapolated(state);
    mpm_grid_rows_run(state, mpm_row_extrapolated_velocity);
    mpm_conditions_apply_extrapolated(state);
    mpm_crack_contact_resolve(state, MPM_EXCHANGE_EXTRAPOLATED);
    mpm_body_contact_resolve(state, MPM_EXCHANGE_EXTRAPOLATED);
    mpm_mirrors_apply_extrapolated(state);
}

/* Task 4: momentum update (29), damping of the nodes, conditions */
static enum mpm_status update_momentum(struct mpm_state *state, bool uniform_force,
                                       struct mpm_error *error)
{
    MPM_TRY(mpm_nodal_force_add(state, error));
    mpm_grid_rows_run(state, uniform_force ? mpm_row_update_with_body_force : mpm_row_update);
    MPM_TRY(mpm_damping_apply_nodes(state, error));
    mpm_conditions_apply_end(state);
    mpm_energy_before_contact(state);
    mpm_crack_contact_resolve(state, MPM_EXCHANGE_END);
    mpm_body_contact_resolve(state, MPM_EXCHANGE_END);
    mpm_energy_after_contact(state);
    mpm_rest_measure_unbalanced(state);
    mpm_mirrors_apply_end(state);
    if (uniform_force)
        state->external_work += uniform_work(state);
    state->external_work += mpm_nodal_force_work(state);
    state->external_work += mpm_user_force_work(state);
    return MPM_OK;
}

/* Task 5: particle velocities (30), with the drag of v_p^n, Notes (43); Task 6 for MUSL and
 * USAVG: extrapolate them (31). Task 7 comes first: a transfer may put other values into the place
 * of the nodes' velocities, and nothing after this needs to know where cracks were. */
static enum mpm_status update_velocities(struct mpm_state *state, int workers,
                                         struct mpm_error *error)
{
    const struct mpm_kernel_choice *const kernels = &state->kernels;
    MPM_TRY(mpm_cracks_advance(state, error));
    mpm_damping_find_drag(state); /* before a transfer changes v_p^n */
    if (kernels->smooth != NULL)
        kernels->smooth(state, workers);
    if (kernels->flip_rows != NULL)
        mpm_grid_rows_run(state, kernels->flip_rows);
    run_particles(state, workers, kernels->flip_particles);
    mpm_damping_take_drag(state);
    run_particles(state, workers, kernels->passes->to_particles);
    return MPM_OK;
}

/* Task 2: velocities of the nodes at the start, conditions, contact; the surfaces of cracks */
static enum mpm_status start_velocities(struct mpm_state *state, struct mpm_error *error)
{
    mpm_grid_rows_run(state, state->kernels.start_rows);
    MPM_TRY(mpm_conditions_gather(state, error));
    MPM_TRY(mpm_body_contact_hold(state, error));
    mpm_conditions_apply_start(state);
    mpm_crack_contact_resolve(state, MPM_EXCHANGE_START);
    mpm_body_contact_resolve(state, MPM_EXCHANGE_START);
    mpm_mirrors_apply_start(state);
    return mpm_crack_openings_begin(state, error);
}

/* Task 3: the forces that are not of stresses (28) */
static void add_loads(struct mpm_state *state, int workers, bool varying_force)
{
    if (varying_force)
        run_particles(state, workers, mpm_pass_body_force);
    mpm_edge_loads_spread(state, workers);
    mpm_user_force_add(state);
    mpm_cohesive_spread(state);
    mpm_symmetries_reflect_force(state);
}

/* Where scalars flow between the fields of nodes. */
static void list_passages(struct mpm_state *state)
{
    if (state->transport.fields_known)
        return;
    mpm_transport_contact_list(state);
    mpm_crack_passages_list(state);
}

/* Nothing moves: no momentum, no stress. Fields of nodes, for which masses are needed, stay as they
 * are until particles have another order. */
static enum mpm_status find_fields_at_rest(struct mpm_state *state, int workers,
                                           struct mpm_error *error)
{
    if (state->transport.fields_known)
        return MPM_OK;
    MPM_TRY(begin(state, workers, false, error));
    return state->fields.layers > 0 || state->fields.keys > 0 ? spread(state, workers, error)
                                                              : MPM_OK;
}

static enum mpm_status advance_at_rest(struct mpm_state *state, double seconds[MPM_PHASE_COUNT],
                                       struct mpm_error *error)
{
    double mark = seconds_now();
    const int workers = strips_touch(state) ? 1 : state->workers;
    MPM_TRY(find_fields_at_rest(state, workers, error));
    mpm_edge_loads_prepare(state);
    list_passages(state);
    MPM_TRY(mpm_transport_advance(state, workers, error));
    mpm_transport_measure_rest(state);
    state->transport.fields_known = true;
    charge(seconds, MPM_PHASE_TRANSPORT, &mark);
    state->steps_since_sort++;
    return mpm_step_collect(state);
}

static enum mpm_status advance_in_motion(struct mpm_state *state, double seconds[MPM_PHASE_COUNT],
                                         struct mpm_error *error)
{
    const bool uniform_force = state->body_force_kind == MPM_UNIFORM_BODY_FORCE;
    const bool varying_force = state->body_force_kind == MPM_VARYING_BODY_FORCE;
    const struct mpm_passes *const passes = state->kernels.passes;
    const int workers = strips_touch(state) ? 1 : state->workers;
    double mark = seconds_now();

    MPM_TRY(begin(state, workers, uniform_force, error));
    charge(seconds, MPM_PHASE_GRID, &mark);

    MPM_TRY(spread(state, workers, error));
    charge(seconds, MPM_PHASE_TO_GRID, &mark);

    if (state->transport.count > 0) {
        list_passages(state);
        MPM_TRY(passes->with_scalar ? mpm_transport_prepare(state, workers, error)
                                    : mpm_transport_take(state, workers, error));
        charge(seconds, MPM_PHASE_TRANSPORT, &mark);
    }

    MPM_TRY(start_velocities(state, error));
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 2 for USF and USAVG: stress update (35), (36); Task 3: forces (28) */
    run_particles(state, workers, passes->stress_before);
    mpm_rest_measure_internal(state);
    add_loads(state, workers, varying_force);
    charge(seconds, MPM_PHASE_STRESS, &mark);

    MPM_TRY(update_momentum(state, uniform_force, error));
    mpm_energy_measure_nodes(state, workers);
    charge(seconds, MPM_PHASE_GRID, &mark);

    if (varying_force)
        state->external_work += varying_work(state, workers);
    state->external_work += mpm_edge_loads_work(state, state->workers);
    MPM_TRY(update_velocities(state, workers, error));
    charge(seconds, MPM_PHASE_TO_PARTICLES, &mark);
    if (state->order->extrapolate)
        finish_extrapolation(state);
    MPM_TRY(mpm_crack_openings_finish(state, error));
    charge(seconds, MPM_PHASE_GRID, &mark);

    /* Task 6: stress update of USL, MUSL, USAVG; Task 5: positions, last, since every
     * task uses the shape functions of the positions at the start */
    if (passes->with_scalar)
        MPM_TRY(mpm_transport_conclude(state, workers, error));
    run_particles(state, workers, passes->finish);
    mpm_transport_finish(state);
    mpm_damping_finish(state);
    mpm_energy_measure_particles(state);
    charge(seconds, MPM_PHASE_STRESS, &mark);

    MPM_TRY(mpm_rigid_advance(state, error));
    state->steps_since_sort++;
    return mpm_step_collect(state);
}

enum mpm_status mpm_step_advance(struct mpm_state *state, double seconds[MPM_PHASE_COUNT],
                                 struct mpm_error *error)
{
    return state->scene->at_rest ? advance_at_rest(state, seconds, error)
                                 : advance_in_motion(state, seconds, error);
}
