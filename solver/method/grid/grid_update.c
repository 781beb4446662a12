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

/* The columns of a box, in its rows. */
static void add_box(const struct mpm_node_box *box, int64_t *low, int64_t *high)
{
    const int64_t first = box->low[0] + MPM_GHOST_ROWS, last = box->high[0] + MPM_GHOST_ROWS;
    for (int64_t k = box->low[1]; k <= box->high[1]; k++) {
        const int64_t row = k + MPM_GHOST_ROWS;
        low[row] = first < low[row] ? first : low[row];
        high[row] = last > high[row] ? last : high[row];
    }
}

/* Nodes of a row that were active in the step before and are not any more lose their mass. */
static void forget_masses(const struct mpm_state *state, int64_t row)
{
    double *const mass = state->grid.mass + row * state->grid.columns;
    const int64_t first = state->fields.before.low[row], last = state->fields.before.high[row];
    const int64_t low = state->row_low[row], high = state->row_high[row];
    for (int64_t column = first; column <= last && column < low; column++)
        mass[column] = 0.0;
    for (int64_t column = last; column >= first && column > high; column--)
        mass[column] = 0.0;
}

static void find_active_of_layers(struct mpm_state *state)
{
    const int64_t layers = 1 + state->fields.layers, rows = layers * state->grid.rows;
    const struct mpm_bands *const before = &state->fields.before;
    memcpy(before->low, state->row_low, (size_t)rows * sizeof *before->low);
    memcpy(before->high, state->row_high, (size_t)rows * sizeof *before->high);
    for (int64_t row = 0; row < rows; row++) {
        state->row_low[row] = state->grid.columns;
        state->row_high[row] = -1;
    }
    for (int64_t s = 0; s < state->strip_count; s++)
        for (int64_t layer = 0; layer < layers; layer++)
            if (state->strips[s].begin < state->strips[s].end)
                add_box(&mpm_layer_boxes(state, &state->strips[s])[layer],
                        state->row_low + layer * state->grid.rows,
                        state->row_high + layer * state->grid.rows);
    for (int64_t row = 0; row < rows; row++)
        forget_masses(state, row);
}

void mpm_grid_find_active(struct mpm_state *state)
{
    const struct mpm_bands *const reached = &state->fields.reached;
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        reached->low[row] = state->grid.columns;
        reached->high[row] = -1;
    }
    state->first_row = state->grid.rows;
    state->last_row = -1;
    for (int64_t s = 0; s < state->strip_count; s++) {
        const struct mpm_strip *const strip = &state->strips[s];
        if (strip->begin == strip->end)
            continue;
        const int64_t first = strip->box.low[1] + MPM_GHOST_ROWS;
        const int64_t last = strip->box.high[1] + MPM_GHOST_ROWS;
        add_box(&strip->box, reached->low, reached->high);
        state->first_row = first < state->first_row ? first : state->first_row;
        state->last_row = last > state->last_row ? last : state->last_row;
    }
    if (state->fields.layers > 0)
        find_active_of_layers(state);
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
