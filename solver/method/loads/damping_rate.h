/* Rates of damping: expressions in place and time; see damping.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_DAMPING_RATE_H
#define MPM_METHOD_DAMPING_RATE_H

#include "method/state.h"

/* Is a rate finite, at least 0 and below 1/dt? */
static inline bool mpm_rate_is_allowed(double rate, double time_step)
{
    return rate >= 0.0 && rate * time_step < 1.0;
}

/* Does it depend on the place? False for NULL, no rate. */
bool mpm_rate_is_varying(const struct mpm_expression *rate);

/* Its value at a place and the start of the step, unit 1/time; `worker` is the one that asks. */
double mpm_rate_value(const struct mpm_expression *rate, const struct mpm_state *state,
                      const double place[2], int worker);

/* alpha_g(t, x_i) of damping.grid, which is not NULL, without the uniform part. A ghost node has
 * the rate of the edge node that it continues, an image that of its original. */
double mpm_rate_of_node(const struct mpm_state *state, int64_t node, int worker);

/* MPM_RUN_FAILED: `what` has a rate that is not allowed. */
enum mpm_status mpm_rate_refuse(const struct mpm_state *state, const char *what, double rate,
                                struct mpm_error *error);

#endif
