/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/damping.h"

#include "base/strips.h"
#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "method/loads/damping_rate.h"
#include "method/loads/grid_drag.h"
#include "method/loads/nodal_force.h"
#include "method/transfer/transfer.h"

#include <float.h>
#include <stdio.h>

/* ----------------------------------------------------------------- uniform */

/* The rate of all places, or 0. */
static enum mpm_status uniform_rate(const struct mpm_state *state, const char *what,
                                    const struct mpm_expression *expression, double *rate,
                                    struct mpm_error *error)
{
    static const double anywhere[2] = {0.0, 0.0};
    *rate = expression == NULL || mpm_rate_is_varying(expression)
                ? 0.0
                : mpm_rate_value(expression, state, anywhere, 0);
    return mpm_rate_is_allowed(*rate, state->time_step)
               ? MPM_OK
               : mpm_rate_refuse(state, what, *rate, error);
}

static enum mpm_status find_pic_rate(struct mpm_state *state, struct mpm_error *error)
{
    static const double anywhere[2] = {0.0, 0.0};
    if (state->damping.pic == NULL)
        return MPM_OK;
    const double beta = mpm_rate_value(state->damping.pic, state, anywhere, 0);
    if (!(beta >= 0.0 && beta <= 1.0))
        return mpm_error_fail(error, MPM_CAUSE_DAMPING, "damping.pic is %g; allowed: from 0 to 1",
                              beta);
    state->damping.pic_rate = (1.0 - beta) / state->time_step; /* Notes (44) */
    return MPM_OK;
}

enum mpm_status mpm_damping_begin(struct mpm_state *state, struct mpm_error *error)
{
    struct mpm_damping *const damping = &state->damping;
    if (!damping->nodes && !damping->particles)
        return MPM_OK;
    MPM_TRY(uniform_rate(state, "damping.grid", damping->grid, &damping->grid_rate, error));
    MPM_TRY(
        uniform_rate(state, "damping.particle", damping->particle, &damping->particle_rate, error));
    MPM_TRY(find_pic_rate(state, error));
    damping->grid_rate += damping->totals.rate;
    return mpm_rate_is_allowed(damping->grid_rate, state->time_step)
               ? MPM_OK
               : mpm_rate_refuse(state, "damping.grid with the thermostat's rate",
                                 damping->grid_rate, error);
}

/* ------------------------------------------------------------------- nodes */

/* What alpha takes out of a node's motion along one axis in the step. */
static inline double taken(const struct mpm_state *state, int64_t node, int axis, double rate)
{
    const double start = state->grid.start[node][axis], end = state->grid.motion[node].end[axis];
    return rate * state->grid.mass[node] * start * (0.5 * state->time_step * (start + end));
}

static void row_damp(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const bool extrapolate = state->order->extrapolate,
               varying = mpm_rate_is_varying(state->damping.grid);
    const struct mpm_row_span inside = mpm_row_span_inside(state, row);
    struct mpm_row_sums *const sums = &state->row_sums[row];
    double dissipated = 0.0;
    sums->refused = -1;
    for (int64_t node = span.first; node < span.end; node++) {
        const double place_rate =
            varying && grid->mass[node] != 0.0 ? mpm_rate_of_node(state, node, worker) : 0.0;
        const double rate = state->damping.grid_rate + place_rate;
        struct mpm_node_motion *const motion = &grid->motion[node];
        if (varying && !(place_rate >= 0.0 && mpm_rate_is_allowed(rate, state->time_step))) {
            sums->refused = node;
            sums->rate = rate;
            return;
        }
        for (int axis = 0; axis < 2; axis++) {
            const double change = rate * grid->start[node][axis]; /* Notes (30), (105) */
            motion->acceleration[axis] -= change;
            motion->end[axis] -= state->time_step * change;
            if (node >= inside.first && node < inside.end)
                dissipated += taken(state, node, axis, rate);
        }
        if (!extrapolate)
            mpm_node_set_gradient(grid, node, motion->end);
    }
    sums->dissipated = dissipated;
}

static enum mpm_status collect_rows(struct mpm_state *state, struct mpm_error *error)
{
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row)) {
        const struct mpm_row_sums *const sums = &state->row_sums[row];
        if (sums->refused >= 0) {
            double place[2];
            char what[96];
            mpm_grid_edge_position(&state->grid, mpm_field_parent(state, sums->refused), place);
            (void)snprintf(what, sizeof what, "damping.grid at the node (%g, %g)", place[0],
                           place[1]);
            return mpm_rate_refuse(state, what, sums->rate, error);
        }
        state->damping.totals.dissipated += sums->dissipated;
    }
    return MPM_OK;
}

enum mpm_status mpm_damping_apply_nodes(struct mpm_state *state, struct mpm_error *error)
{
    const bool varying = mpm_rate_is_varying(state->damping.grid);
    if (state->damping.node_drag != NULL) {
        mpm_grid_rows_run(state, mpm_row_grid_drag);
        return collect_rows(state, error);
    }
    if (!state->damping.nodes)
        return MPM_OK;
    mpm_grid_rows_run(state, row_damp);
    MPM_TRY(collect_rows(state, error));
    for (size_t k = 0; k < state->conditions.active_count; k++) { /* held: not damped */
        const struct mpm_active_condition *const active = &state->conditions.active[k];
        const double place_rate = varying ? mpm_rate_of_node(state, active->node, 0) : 0.0;
        if (!mpm_node_is_inside(state, active->node))
            continue;
        state->damping.totals.dissipated -=
            taken(state, active->node, active->component, state->damping.grid_rate + place_rate);
    }
    return MPM_OK;
}

void mpm_damping_follow_contact(struct mpm_state *state, int64_t node,
                                const struct mpm_contact_side *side, const double impulse[2])
{
    if (!state->damping.nodes || state->damping.node_drag != NULL)
        return;
    const bool varying = mpm_rate_is_varying(state->damping.grid);
    const double rate =
        state->damping.grid_rate + (varying ? mpm_rate_of_node(state, node, 0) : 0.0);
    for (int axis = 0; axis < 2; axis++)
        state->damping.totals.dissipated += rate * state->grid.mass[node] *
                                            state->grid.start[node][axis] * 0.5 * state->time_step *
                                            side->mobility[axis] * impulse[axis];
}

/* --------------------------------------------------------------- particles */

/* alpha_p(t, x_p); 0, with a record, if it is not allowed */
static double particle_rate(const struct mpm_state *state, size_t p, int worker,
                            struct mpm_strip *strip)
{
    const double place[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    const double rate = mpm_rate_value(state->damping.particle, state, place, worker);
    if (mpm_rate_is_allowed(rate, state->time_step))
        return rate;
    mpm_strip_record(strip, MPM_RATE_REFUSED, state->particles.id[p], 0, rate);
    return 0.0;
}

static void pass_drag(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    const struct mpm_damping *const damping = &state->damping;
    const struct mpm_particles *const particles = &state->particles;
    struct mpm_strip *const strip = &state->strips[index];
    const bool varying = mpm_rate_is_varying(damping->particle), pic = damping->pic != NULL;
    double power = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        const double rate =
            varying ? particle_rate(state, p, worker, strip) : damping->particle_rate;
        double grid[2] = {0.0, 0.0};
        if (pic)
            mpm_particle_gather(state, p, state->grid.start, grid);
        for (int axis = 0; axis < 2; axis++) {
            const double v = particles->velocity[axis][p];
            const double q = rate * v + (pic ? damping->pic_rate * (v - grid[axis]) : 0.0);
            particles->drag[axis][p] = q;
            power += particles->mass[p] * q * v;
        }
    }
    strip->dissipated = 0.5 * state->time_step * power;
}

/* What the drag spares a body force of its work, m_p b . q_p dt^2/2. */
static void pass_spare_work(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    const bool varying = state->body_force_kind == MPM_VARYING_BODY_FORCE;
    const bool nodal = state->body_force_kind == MPM_NODAL_BODY_FORCE;
    const struct mpm_particles *const particles = &state->particles;
    const double half = 0.5 * state->time_step * state->time_step;
    double *const *const user = particles->user_force;
    struct mpm_strip *const strip = &state->strips[index];
    strip->external_work = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        double b[2] = {state->uniform_force[0], state->uniform_force[1]};
        if (varying && !mpm_particle_body_force(state, p, worker, strip, b))
            continue;
        if (nodal)
            mpm_particle_gather(state, p, state->nodal_force.value, b);
        for (int axis = 0; axis < 2 && user[axis] != NULL; axis++)
            b[axis] += user[axis][p];
        strip->external_work -= half * particles->mass[p] *
                                (b[0] * particles->drag[0][p] + b[1] * particles->drag[1][p]);
    }
}

static void run_particles(struct mpm_state *state, mpm_pass *pass)
{
    mpm_strips_run(state->strip_count, state->workers, pass, state); /* strips share nothing */
}

void mpm_damping_find_drag(struct mpm_state *state)
{
    if (!state->damping.particles)
        return;
    run_particles(state, pass_drag);
    mpm_grid_drag_find(state);
    if (state->body_force_kind == MPM_NO_BODY_FORCE && state->user_force.caller.evaluate == NULL)
        return;
    run_particles(state, pass_spare_work);
    for (int64_t s = 0; s < state->strip_count; s++) {
        state->external_work += state->strips[s].external_work;
        if (state->energy.measured)
            state->energy.lost += state->strips[s].external_work; /* that nodes do not know of */
    }
}

static void pass_take_drag(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    (void)worker;
    for (int axis = 0; axis < 2; axis++) {
        double *const velocity = state->particles.velocity[axis];
        const double *const drag = state->particles.drag[axis];
        for (size_t p = strip->begin; p < strip->end; p++)
            velocity[p] -= state->time_step * drag[p];
    }
}

void mpm_damping_take_drag(struct mpm_state *state)
{
    if (state->damping.particles)
        run_particles(state, pass_take_drag);
}

static void pass_settle(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_particles *const particles = &state->particles;
    struct mpm_strip *const strip = &state->strips[index];
    double power = 0.0;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++)
        power += particles->mass[p] * (particles->drag[0][p] * particles->velocity[0][p] +
                                       particles->drag[1][p] * particles->velocity[1][p]);
    strip->dissipated += 0.5 * state->time_step * power;
}

/* Takes `back` times a deceleration of each particle from the way on which the last task has moved
 * it; its box anew. */
static inline void settle_way(struct mpm_state *state, int64_t index, double *const taken_by[2],
                              double back)
{
    struct mpm_strip *const strip = &state->strips[index];
    struct mpm_extents extents;
    mpm_extents_begin(state, &extents);
    for (size_t p = strip->begin; p < strip->end; p++) {
        double step[2];
        for (int axis = 0; axis < 2; axis++) {
            step[axis] = -back * taken_by[axis][p];
            state->particles.position[axis][p] += step[axis];
        }
        struct mpm_placement placement = mpm_particle_placement(state, p);
        placement.step[0] = step[0];
        placement.step[1] = step[1];
        if (mpm_placement_check(state, &placement, state->particles.id[p], strip))
            mpm_extents_add(&extents, state->bodies[state->particles.body[p]].layer, &placement);
    }
    if (strip->failure.kind == MPM_NO_FAILURE)
        mpm_strip_set_boxes(state, strip, &extents);
}

/* The midpoint's way, Notes (42), (51) */
static void pass_settle_midpoint(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    pass_settle(context, index, worker);
    settle_way(state, index, state->particles.drag, 0.5 * state->time_step * state->time_step);
}

/* The way of the grid's velocity v_* = v_gp^{n+1} - dt alpha_g v_gp^n, Notes (56) */
static void pass_settle_grid_velocity(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    pass_settle(context, index, worker);
    settle_way(state, index, state->damping.grid_drag, state->time_step * state->time_step);
}

static void settle(struct mpm_state *state)
{
    const bool midpoint = state->scene->position_update == MPM_MIDPOINT;
    if (!state->damping.particles)
        return;
    run_particles(state, midpoint                              ? pass_settle_midpoint
                         : state->damping.grid_drag[0] == NULL ? pass_settle
                                                               : pass_settle_grid_velocity);
    for (int64_t s = 0; s < state->strip_count; s++)
        state->damping.totals.dissipated += state->strips[s].dissipated;
}

/* -------------------------------------------------------------- thermostat */

static void advance_thermostat(struct mpm_state *state)
{
    const struct mpm_damping_spec *const spec = &state->scene->damping;
    struct mpm_damping_totals *const totals = &state->damping.totals;
    double kinetic = 0.0;
    if (!spec->thermostat)
        return;
    for (int64_t s = 0; s < state->strip_count; s++)
        kinetic += state->strips[s].kinetic_energy;
    if (kinetic > totals->largest_kinetic)
        totals->largest_kinetic = kinetic;
    const double scale = spec->scale > 0.0 ? spec->scale : totals->largest_kinetic;
    if (scale > 0.0)
        totals->rate += state->time_step * spec->gain * (kinetic - spec->target) / scale;
    if (totals->rate < 0.0)
        totals->rate = 0.0;
}

void mpm_damping_finish(struct mpm_state *state)
{
    settle(state);
    advance_thermostat(state);
}
