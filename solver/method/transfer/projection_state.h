/* Which values a projection takes, and where to; see projection.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_PROJECTION_STATE_H
#define MPM_METHOD_PROJECTION_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Of a node in an array that takes part: a vector of the fast kernels. */
enum { MPM_NODE_VALUES = 4 };

struct mpm_projection {
    size_t components; /* up to MPM_NODE_VALUES: a scalar has one */
    size_t field; /* enum mpm_particle_field, of doubles; read without `from`, set without `to` */
    const double *from; /* per node: MPM_NODE_VALUES numbers, the first ones in use; or NULL */
    double *to;         /* the same; the others are of no use afterwards. Not NULL if `from` is */
    bool pairs;         /* in `to`, component k goes to number 2 k: as grid.gradient has them */
};

#endif
