/* Velocity conditions on grid nodes: which nodes, which components, which expression.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_BOUNDARY_H
#define MPM_MODEL_BOUNDARY_H

#include "model/grid.h"

enum { MPM_AXIS_CONDITION = -1 };

struct mpm_condition {
    int64_t node;      /* index in the grid */
    int32_t component; /* 0 or 1 */
    int32_t boundary;  /* index in the scene, or MPM_AXIS_CONDITION: v_r = 0 on r <= 0 */
};

/* The box of nodes that lie on a region, a line or rectangle along the axes or all, ghosts not
 * counted. MPM_BAD_INPUT, at the scene's line and key: there is none. */
enum mpm_status mpm_boundary_box(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                 const struct mpm_region *region, int line, const char *key,
                                 int64_t low[2], int64_t high[2], struct mpm_error *error);

/* Lists the conditions of a scene, ghost rows included: a condition on the grid's edge
 * row holds for the ghost rows beyond, but that of a plane of symmetry not for those behind it. In
 * axisymmetry the nodes on the axis get v_r = 0 (N&G check list, 2), and so do those beyond, unless
 * axis_nodes says otherwise. *conditions is malloc'ed and sorted by node. MPM_BAD_INPUT: a region
 * that touches no node; two different values for one component of one node. `value` gives the
 * velocity that a boundary prescribes at a place and time. */
enum mpm_status mpm_conditions_list(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                    double (*value)(const void *context, int32_t boundary,
                                                    int32_t component, const double position[2],
                                                    double time),
                                    const void *context, struct mpm_condition **conditions,
                                    size_t *count, struct mpm_error *error);

#endif
