/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_smoothing.h"

#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transport/scalar_nodes.h"
#include "method/transport/transport_exchange.h"
#include "method/transport/transport_passes.h"

#include <string.h>

/* w_1 = v; no sum yet. In all these, `value` is v: see smooth. */
static void row_begin(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const size_t size = (size_t)(span.end - span.first) * sizeof *scalar->value;
    (void)worker;
    memcpy(scalar->smoothed + span.first, scalar->value + span.first, size);
    memset(scalar->filtered + span.first, 0, size);
}

/* w_{r+1} = v + w_r - S+ S w_r; the next sum begins at 0 */
static void row_next_order(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        const double seen = scalar->filtered[node] * mpm_inverse_mass(scalar->capacity[node]);
        scalar->smoothed[node] += scalar->value[node] - seen;
        scalar->filtered[node] = 0.0;
    }
}

/* Held nodes keep v. */
static void hold(const struct mpm_state *state, const double *v, struct mpm_nodal_scalar *scalar,
                 bool last)
{
    for (size_t k = 0; k < scalar->hold_count; k++)
        for (int i = 0; i < scalar->hold_fields; i++) {
            const int64_t field = mpm_scalar_field_at(state, scalar, scalar->holds[k].node, i);
            if (field < 0)
                continue;
            if (last)
                scalar->totals.held +=
                    scalar->capacity[field] * (v[field] - scalar->smoothed[field]);
            mpm_scalar_set(state, scalar->smoothed, field, v[field]);
        }
}

/* `smoothed` from v. */
static void smooth(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar, double *v)
{
    struct mpm_nodal_scalar of_v = *scalar, filter = *scalar;
    of_v.value = v;
    filter.value = scalar->smoothed;
    filter.result = scalar->filtered;
    mpm_scalar_rows_run(state, &of_v, row_begin);
    for (int order = 1; order < scalar->order; order++) {
        mpm_scalar_pass_run(state, workers, &filter, state->kernels.scalar->filter);
        mpm_symmetries_reflect_scalar(state, scalar->filtered);
        mpm_scalar_rows_run(state, &of_v, row_next_order);
        const bool last = order + 1 == scalar->order;
        hold(state, v, scalar, last);
        mpm_scalar_exchange_smoothed(state, scalar, last);
    }
}

void mpm_scalar_smooth_start(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    if (scalar->transfer == MPM_SCALAR_XPIC)
        smooth(state, workers, scalar, scalar->value);
}

static void row_keep(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    (void)worker;
    memcpy(scalar->result + span.first, scalar->smoothed + span.first,
           (size_t)(span.end - span.first) * sizeof *scalar->result);
}

void mpm_scalar_smooth_end(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    if (scalar->transfer != MPM_SCALAR_FMPM)
        return;
    smooth(state, workers, scalar, scalar->result);
    mpm_scalar_rows_run(state, scalar, row_keep);
}
