/* Nodes at which a scalar is prescribed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_SCALAR_CONDITIONS_H
#define MPM_MODEL_SCALAR_CONDITIONS_H

#include "model/grid.h"

struct mpm_scalar_hold {
    int64_t node;      /* index in the grid */
    int32_t condition; /* index in the scene's list */
};

/* Lists them by node, ghost rows included: what holds on the grid's edge holds beyond it.
 * `value` gives what a condition prescribes at a place and time. *holds is malloc'ed.
 * MPM_BAD_INPUT: a region that touches no node; two different values at one node. */
enum mpm_status mpm_scalar_holds_list(
    const struct mpm_scene *scene, const struct mpm_grid *grid, enum mpm_scalar which,
    double (*value)(const void *context, int32_t condition, const double position[2], double time),
    const void *context, struct mpm_scalar_hold **holds, size_t *count, struct mpm_error *error);

#endif
