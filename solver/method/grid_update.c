/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid_update.h"

#include <string.h>

void mpm_grid_find_active(struct mpm_state *state)
{
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        state->row_low[row] = state->grid.columns;
        state->row_high[row] = -1;
    }
    state->first_row = state->grid.rows;
    state->last_row = -1;
    for (int64_t s = 0; s < state->strip_count; s++) {
        const struct mpm_strip *const strip = &state->strips[s];
        if (strip->begin == strip->end)
            continue;
        const int64_t first = strip->row_low + MPM_GHOST_ROWS;
        const int64_t last = strip->row_high + MPM_GHOST_ROWS;
        const int64_t low = strip->column_low + MPM_GHOST_ROWS;
        const int64_t high = strip->column_high + MPM_GHOST_ROWS;
        for (int64_t row = first; row <= last; row++) {
            state->row_low[row] = low < state->row_low[row] ? low : state->row_low[row];
            state->row_high[row] = high > state->row_high[row] ? high : state->row_high[row];
        }
        state->first_row = first < state->first_row ? first : state->first_row;
        state->last_row = last > state->last_row ? last : state->last_row;
    }
}

static struct mpm_node *first_node(const struct mpm_state *state, int64_t row)
{
    return state->grid.nodes + row * state->grid.columns + state->row_low[row];
}

static struct mpm_node *end_node(const struct mpm_state *state, int64_t row)
{
    return state->grid.nodes + row * state->grid.columns + state->row_high[row] + 1;
}

void mpm_row_clear(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    if (state->row_low[row] > state->row_high[row])
        return;
    struct mpm_node *const first = first_node(state, row);
    memset(first, 0, (size_t)(end_node(state, row) - first) * sizeof *first);
}

void mpm_row_start_velocity(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    for (struct mpm_node *node = first_node(state, row); node < end_node(state, row); node++) {
        if (node->mass == 0.0)
            continue;
        for (int axis = 0; axis < 2; axis++) {
            node->start[axis] = node->momentum[axis] / node->mass;
            node->gradient[axis] = node->start[axis];
            node->momentum[axis] = 0.0;
        }
    }
}

void mpm_row_update(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    for (struct mpm_node *node = first_node(state, row); node < end_node(state, row); node++) {
        if (node->mass == 0.0)
            continue;
        for (int axis = 0; axis < 2; axis++) {
            node->acceleration[axis] = node->force[axis] / node->mass;
            node->end[axis] = node->start[axis] + state->time_step * node->acceleration[axis];
            node->gradient[axis] = node->end[axis];
        }
    }
}

void mpm_row_extrapolated_velocity(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    for (struct mpm_node *node = first_node(state, row); node < end_node(state, row); node++) {
        if (node->mass == 0.0)
            continue;
        node->gradient[0] = node->momentum[0] / node->mass;
        node->gradient[1] = node->momentum[1] / node->mass;
    }
}
