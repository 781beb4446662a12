/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_rest.h"

#include "method/grid/grid_update.h"

#include <math.h>

/* sum |inflow| of a row, inside planes of symmetry */
static double row_flow(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                       int64_t row)
{
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double sum = 0.0;
    for (int64_t node = span.first; node < span.end; node++)
        sum += fabs(scalar->inflow[node]);
    return sum;
}

static double held_flow(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    double sum = 0.0;
    for (size_t k = 0; k < scalar->hold_count; k++) {
        const int64_t node = scalar->holds[k].node;
        if (mpm_node_is_active(state, node) && mpm_node_is_inside(state, node))
            sum += fabs(scalar->inflow[node]);
    }
    return sum;
}

/* Of one scalar: 0 to 1. */
static double unsteady_part(const struct mpm_state *state, struct mpm_nodal_scalar *scalar)
{
    double all = 0.0;
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        all += row_flow(state, scalar, row);
    const double changing = fmax(all - held_flow(state, scalar), 0.0);
    scalar->totals.largest_flow = fmax(scalar->totals.largest_flow, all);
    return changing > 0.0 ? changing / scalar->totals.largest_flow : 0.0;
}

void mpm_transport_measure_rest(struct mpm_state *state)
{
    if (!state->scene->rest.asked)
        return;
    state->balance.flow = 0.0;
    for (size_t k = 0; k < state->transport.count; k++)
        state->balance.flow =
            fmax(state->balance.flow, unsteady_part(state, &state->transport.list[k]));
}
