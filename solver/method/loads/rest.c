/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/rest.h"

#include "method/grid/grid_update.h"

#include <math.h>

static void row_internal(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    double sum = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        sum += fabs(state->grid.sum[node][0].force) + fabs(state->grid.sum[node][1].force);
    state->row_sums[row].balance.internal = sum;
}

/* Of the momentum update and of contact. */
static double force_at(const struct mpm_state *state, int64_t node, int axis)
{
    const double force = state->grid.sum[node][axis].force;
    return state->grid.contact_force == NULL ? force
                                             : force + state->grid.contact_force[node][axis];
}

static void row_unbalanced(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double sum = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        sum += fabs(force_at(state, node, 0)) + fabs(force_at(state, node, 1));
    state->row_sums[row].balance.unbalanced = sum;
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
    for (size_t k = 0; k < state->conditions.active_count; k++) {
        const struct mpm_active_condition *const active = &state->conditions.active[k];
        if (mpm_node_is_inside(state, active->node))
            held += fabs(force_at(state, active->node, active->component));
    }
    state->balance.unbalanced = fmax(all - held, 0.0); /* round-off may be all that is left */
}
