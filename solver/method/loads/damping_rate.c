/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/damping_rate.h"

#include "method/fields/fields.h"
#include "method/grid/symmetry.h"

bool mpm_rate_is_varying(const struct mpm_expression *rate)
{
    return rate != NULL && !mpm_expression_is_uniform(rate);
}

double mpm_rate_value(const struct mpm_expression *rate, const struct mpm_state *state,
                      const double place[2], int worker)
{
    return mpm_expression_value(rate, worker, place, state->time);
}

double mpm_rate_of_node(const struct mpm_state *state, int64_t node, int worker)
{
    double place[2], sign[2];
    const int64_t parent = mpm_field_parent(state, node);
    mpm_grid_edge_position(&state->grid, mpm_symmetry_original(state, parent, sign), place);
    return mpm_rate_value(state->damping.grid, state, place, worker);
}

enum mpm_status mpm_rate_refuse(const struct mpm_state *state, const char *what, double rate,
                                struct mpm_error *error)
{
    return mpm_error_fail(error, MPM_CAUSE_DAMPING,
                          "%s is %g; allowed: at least 0 and below %g, 1 over the time step", what,
                          rate, 1.0 / state->time_step);
}
