/* The arrays of a body force that is taken at the nodes; see nodal_force.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_NODAL_FORCE_STATE_H
#define MPM_METHOD_NODAL_FORCE_STATE_H

#include <stdint.h>

struct mpm_nodal_force_row {
    double work;     /* in the step */
    int64_t refused; /* the first node whose force is not finite, or -1 */
    int axis;        /* there */
};

/* NULL where there is none. */
struct mpm_nodal_force {
    double (*value)[2]; /* per node: b(x_i, t), force per mass */
    struct mpm_nodal_force_row *row;
};

#endif
