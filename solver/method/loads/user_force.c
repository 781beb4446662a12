/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/user_force.h"

#include "base/strips.h"
#include "method/grid/grid_update.h"
#include "method/transfer/extent.h"
#include "method/transfer/projection.h"

#include <math.h>
#include <string.h>

void mpm_user_force_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_user_force *const user = &state->user_force;
    const size_t nodes = (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
    mpm_particles_layout_field(&state->particles, MPM_PARTICLE_USER_FORCE, 2, arena);
    user->force = mpm_arena_take(arena, nodes, sizeof *user->force);
    user->row_work = MPM_TAKE(arena, double, (size_t)(state->grid.rows + state->grid.field_rows));
}

static void pass_evaluate(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_body_force *const caller = &state->user_force.caller;
    double *const *const value = state->particles.user_force;
    const uint32_t *const id = state->particles.id;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p += MPM_BODY_FORCE_BLOCK) {
        const size_t left = strip->end - p;
        const size_t count = left < MPM_BODY_FORCE_BLOCK ? left : MPM_BODY_FORCE_BLOCK;
        double *const block[2] = {value[0] + p, value[1] + p};
        caller->evaluate(caller->context, state->time, count, id + p, block);
    }
    for (int axis = 0; axis < 2; axis++)
        for (size_t p = strip->begin; p < strip->end; p++)
            if (!isfinite(value[axis][p])) {
                mpm_strip_record(strip, MPM_USER_FORCE_NOT_FINITE, id[p], axis, value[axis][p]);
                value[axis][p] = 0.0; /* the step goes on to its end before it fails */
            }
}

static void row_clear(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    (void)worker;
    memset(state->user_force.force + span.first, 0,
           (size_t)(span.end - span.first) * sizeof *state->user_force.force);
}

void mpm_user_force_spread(struct mpm_state *state, int workers)
{
    const struct mpm_projection spread = {
        .components = 2,
        .field = MPM_PARTICLE_USER_FORCE,
        .to = (double *)state->user_force.force,
    };
    if (state->user_force.caller.evaluate == NULL)
        return;
    mpm_strips_run(state->strip_count, workers, pass_evaluate, state);
    mpm_grid_rows_run(state, row_clear);
    mpm_projection_run(state, workers, &spread);
}

static void row_add(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++)
            state->grid.sum[node][axis].force += state->user_force.force[node][2 * axis];
}

void mpm_user_force_add(struct mpm_state *state)
{
    if (state->user_force.caller.evaluate != NULL)
        mpm_grid_rows_run(state, row_add);
}

static void row_work(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    double power = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++)
            power += state->user_force.force[node][2 * axis] *
                     (state->grid.start[node][axis] + state->grid.motion[node].end[axis]);
    state->user_force.row_work[row] = 0.5 * state->time_step * power;
}

double mpm_user_force_work(struct mpm_state *state)
{
    double work = 0.0;
    if (state->user_force.caller.evaluate == NULL)
        return work;
    mpm_grid_rows_run(state, row_work);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        work += state->user_force.row_work[row];
    return work;
}
