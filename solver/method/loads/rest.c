/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/rest.h"

#include "method/grid/grid_update.h"

#include <math.h>

static double row_force(const struct mpm_state *state, struct mpm_row_span span)
{
    double sum = 0.0;
    for (int64_t node = span.first; node < span.end; node++)
        sum += fabs(state->grid.sum[node][0].force) + fabs(state->grid.sum[node][1].force);
    return sum;
}

static void row_internal(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    state->row_sums[row].balance.internal = row_force(state, mpm_row_span(state, row));
}

static void row_unbalanced(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    state->row_sums[row].balance.unbalanced = row_force(state, mpm_row_span_inside(state, row));
}

void mpm_rest_measure_internal(struct mpm_state *state)
{
    if (!state->scene->rest.asked)
        return;
    mpm_grid_rows_run(state, row_internal);
    state->balance.internal = 0.0;
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        state->balance.internal += state->row_sums[row].balance.internal;
}

void mpm_rest_measure_unbalanced(struct mpm_state *state)
{
    double held = 0.0, all = 0.0;
    if (!state->scene->rest.asked)
        return;
    mpm_grid_rows_run(state, row_unbalanced);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        all += state->row_sums[row].balance.unbalanced;
    for (size_t k = 0; k < state->conditions.active_count; k++)
        if (mpm_node_is_inside(state, state->conditions.active[k].node))
            held += fabs(
                state->grid
                    .sum[state->conditions.active[k].node][state->conditions.active[k].component]
                    .force);
    state->balance.unbalanced = fmax(all - held, 0.0); /* round-off may be all that is left */
}
