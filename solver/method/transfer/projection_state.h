/* Which values a projection takes, and where to; see projection.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_PROJECTION_STATE_H
#define MPM_METHOD_PROJECTION_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    MPM_PROJECTION_COMPONENTS = 2, /* at most: a scalar, or a vector */
    MPM_NODE_VALUES = 4,           /* numbers of a node in an array: a vector of the fast kernels */
};

struct mpm_projection {
    size_t components;
    size_t field; /* enum mpm_particle_field, of doubles; read without `from`, set without `to` */
    const double *from; /* nodes; component k is number k. Or NULL */
    /* Nodes; component k is added to number 2 k, and perhaps to the next one: as grid.gradient has
     * them. Others are of no use afterwards. NULL: to particles */
    double *to;
};

#endif
