/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid/grid_update.h"

#include "base/strips.h"

#include <string.h>

void mpm_grid_rows_run(struct mpm_state *state, mpm_pass *pass)
{
    const int64_t additional = state->grid.rows, count = state->fields.rows;
    mpm_rows_run(state->first_row, state->last_row, state->workers, pass, state);
    if (count > 0)
        mpm_rows_run(additional, additional + count - 1, state->workers, pass, state);
}

void mpm_row_clear(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const size_t count = (size_t)(span.end - span.first);
    (void)worker;
    memset(state->grid.mass + span.first, 0, count * sizeof *state->grid.mass);
    memset(state->grid.sum + span.first, 0, count * sizeof *state->grid.sum);
    if (state->grid.contact_force != NULL)
        memset(state->grid.contact_force + span.first, 0,
               count * sizeof *state->grid.contact_force);
}

void mpm_row_gather_mass(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        state->grid.mass[node] += state->grid.sum[node][0].mass;
        state->grid.sum[node][0].force = 0.0;
    }
}

static inline void start_row(const struct mpm_state *state, int64_t row, bool mass_in_sums)
{
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const bool stress_before = state->order->before > 0.0; /* else not needed yet */
    for (int64_t node = span.first; node < span.end; node++) {
        if (mass_in_sums) {
            grid->mass[node] = grid->sum[node][0].mass;
            grid->sum[node][0].force = 0.0;
        }
        const double inverse = mpm_inverse_mass(grid->mass[node]);
        for (int axis = 0; axis < 2; axis++)
            grid->start[node][axis] = grid->sum[node][axis].momentum * inverse;
        if (stress_before)
            mpm_node_set_gradient(grid, node, grid->start[node]);
    }
}

MPM_PASS(mpm_row_start_velocity, start_row, false)
MPM_PASS(mpm_row_start_from_sums, start_row, true)

static inline void update_row(const struct mpm_state *state, int64_t row, bool body_force)
{
    static const double nothing_yet[2] = {0.0, 0.0};
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const bool extrapolate = state->order->extrapolate;
    const bool stress_after = state->order->after > 0.0; /* else no longer needed */
    for (int64_t node = span.first; node < span.end; node++) {
        const double inverse = mpm_inverse_mass(grid->mass[node]);
        struct mpm_node_motion *const motion = &grid->motion[node];
        for (int axis = 0; axis < 2; axis++) {
            if (body_force) /* stays in the sum: reactions at conditions follow from it */
                grid->sum[node][axis].force += grid->mass[node] * state->uniform_force[axis];
            motion->acceleration[axis] = grid->sum[node][axis].force * inverse;
            motion->end[axis] =
                grid->start[node][axis] + state->time_step * motion->acceleration[axis];
        }
        if (stress_after)
            mpm_node_set_gradient(grid, node, extrapolate ? nothing_yet : motion->end);
    }
}

MPM_PASS(mpm_row_update, update_row, false)
MPM_PASS(mpm_row_update_with_body_force, update_row, true)

void mpm_row_flip_fraction(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const double rate = (1.0 - state->scene->flip_fraction) / state->time_step;
    const double back =
        state->scene->position_update == MPM_MIDPOINT ? 0.5 * state->time_step : 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++) {
            const double change = rate * grid->start[node][axis];
            grid->motion[node].acceleration[axis] += change;
            grid->motion[node].end[axis] += back * change;
        }
}

void mpm_row_momentum(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double sum[2] = {0.0, 0.0};
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++)
            sum[axis] +=
                grid->mass[node] * (grid->start[node][axis] + grid->motion[node].end[axis]);
    for (int axis = 0; axis < 2; axis++)
        state->row_momentum[row][axis] = sum[axis];
}

void mpm_row_extrapolated_velocity(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_row_span span = mpm_row_span(state, row);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        const double inverse = mpm_inverse_mass(grid->mass[node]);
        const double velocity[2] = {grid->gradient[node][0][0] * inverse,
                                    grid->gradient[node][1][0] * inverse};
        mpm_node_set_gradient(grid, node, velocity);
    }
}
