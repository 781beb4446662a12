/* Sums over the nodes of a step, for rest, damping and the energy balance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_REST_STATE_H
#define MPM_METHOD_REST_STATE_H

#include <stdint.h>

/* The forces of a step, |f_x| + |f_y| over nodes, for scenes with `time.rest`. */
struct mpm_balance {
    double internal;   /* of all nodes */
    double unbalanced; /* of the components that nothing holds */
    double flow;       /* of scalars, 0 to 1: transport/transport_rest.h */
};

/* What passes over rows leave for a sum in the rows' order; where a scene damps nodes, requires
 * rest or measures its energy balance. */
struct mpm_row_sums {
    double dissipated;
    struct mpm_balance balance;
    double kinetic[2]; /* energy of the nodes at both ends of the step */
    int64_t refused;   /* the first node with a rate that is not allowed, or -1 */
    double rate;       /* there */
};

#endif
