/* What passes over the rows of the grid share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_ROWS_H
#define MPM_METHOD_ROWS_H

#include "method/state.h"

/* The active nodes of a row: indices first..end - 1. */
struct mpm_span {
    int64_t first, end;
};

static inline struct mpm_span mpm_row_span(const struct mpm_state *state, int64_t row)
{
    const int64_t start = row * state->grid.columns;
    if (state->row_low[row] > state->row_high[row])
        return (struct mpm_span){start, start};
    return (struct mpm_span){start + state->row_low[row], start + state->row_high[row] + 1};
}

/* Sets the velocity whose gradient updates the stress. */
static inline void mpm_node_set_gradient(const struct mpm_grid *grid, int64_t node,
                                         const double v[2])
{
    for (int axis = 0; axis < 2; axis++)
        grid->gradient[node][axis][0] = grid->gradient[node][axis][1] = v[axis];
}

#endif
