/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/smoothing.h"

#include "method/grid/conditions.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/projection.h"

/* ---------------------------------------------------------------- iteration */

/* w_1 = v; no sum yet */
static inline void begin_row(const struct mpm_state *state, int64_t row, bool after_update)
{
    static const double nothing_yet[2] = {0.0, 0.0};
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    for (int64_t node = span.first; node < span.end; node++) {
        const double *const v = after_update ? grid->motion[node].end : grid->start[node];
        for (int axis = 0; axis < 2; axis++)
            grid->smoothed[node].acceleration[axis] = grid->smoothed[node].end[axis] = v[axis];
        mpm_node_set_gradient(grid, node, nothing_yet);
    }
}

static MPM_PASS(begin_with_start, begin_row, false) static MPM_PASS(begin_with_end, begin_row, true)

    /* w_{r+1} = v + w_r - S+ S w_r */
    static void next_order(void *context, int64_t row, int worker)
{
    static const double nothing_yet[2] = {0.0, 0.0};
    const struct mpm_state *const state = context;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        struct mpm_node_motion *const smoothed = &grid->smoothed[node];
        const double inverse = mpm_inverse_mass(grid->mass[node]);
        for (int axis = 0; axis < 2; axis++) {
            const double filtered = grid->gradient[node][axis][0] * inverse;
            smoothed->acceleration[axis] += smoothed->end[axis] - filtered;
        }
        mpm_node_set_gradient(grid, node, nothing_yet);
    }
}

static void smooth(struct mpm_state *state, int workers, mpm_pass *begin)
{
    const struct mpm_projection filter = {
        .from = (const double *)state->grid.smoothed, /* w at its acceleration */
        .to = (double *)state->grid.gradient,
        .components = 2,
    };
    mpm_grid_rows_run(state, begin);
    for (int order = 1; order < state->scene->transfer_order; order++) {
        mpm_projection_run(state, workers, &filter);
        mpm_symmetries_reflect_extrapolated(state);
        mpm_grid_rows_run(state, next_order);
        mpm_conditions_apply_smoothed(state);
        if (state->contact.exchange_smoothed != NULL)
            state->contact.exchange_smoothed(state);
    }
}

void mpm_smooth_start(struct mpm_state *state, int workers)
{
    smooth(state, workers, begin_with_start);
}

void mpm_smooth_end(struct mpm_state *state, int workers)
{
    smooth(state, workers, begin_with_end);
}

/* ---------------------------------------------------------------- to the motion */

/* What particles read back becomes: velocity over dt for the acceleration, since they have
 * none, and for the end that from which the position update gets `moves`: the velocity at the end
 * of the step, as position and strain see it. */
static inline void set_motion(const struct mpm_state *state, int64_t node, bool moves_smoothed)
{
    const double midpoint =
        state->scene->position_update == MPM_MIDPOINT ? 0.5 * state->time_step : 0.0;
    const double *const w = state->grid.smoothed[node].acceleration;
    struct mpm_node_motion *const motion = &state->grid.motion[node];
    double moves[2];
    for (int axis = 0; axis < 2; axis++) {
        const double before = motion->acceleration[axis];
        const double velocity = moves_smoothed ? w[axis] : w[axis] + state->time_step * before;
        const double acceleration = velocity / state->time_step;
        moves[axis] = moves_smoothed ? w[axis] : motion->end[axis];
        motion->acceleration[axis] = acceleration;
        motion->end[axis] = moves[axis] + midpoint * (acceleration - before);
    }
    if (!state->order->extrapolate)
        mpm_node_set_gradient(&state->grid, node, moves);
}

static inline void set_row(const struct mpm_state *state, int64_t row, bool moves_smoothed)
{
    const struct mpm_row_span span = mpm_row_span(state, row);
    for (int64_t node = span.first; node < span.end; node++)
        set_motion(state, node, moves_smoothed);
}

MPM_PASS(mpm_row_xpic, set_row, false)
MPM_PASS(mpm_row_fmpm, set_row, true)
