/* What velocity conditions keep: of the scene, and of a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONDITIONS_STATE_H
#define MPM_METHOD_CONDITIONS_STATE_H

#include "method/vector_field.h"
#include "model/boundary.h"

/* A condition on a node that carries mass in this step. */
struct mpm_active_condition {
    int64_t node;
    int32_t component;
    uint32_t source; /* body index of a rigid body, or MPM_FROM_... */
    double start, end;
};
#define MPM_FROM_BOUNDARY UINT32_MAX
#define MPM_FROM_MIRROR   (UINT32_MAX - 1)

/* Velocity conditions; see conditions.h. */
struct mpm_conditions {
    struct mpm_condition *list; /* of the boundaries, and of nodes on the axis */
    size_t count;
    struct mpm_vector_field *boundary_velocity; /* per boundary */
    struct mpm_vector_field *body_velocity;     /* per body: rigid ones */
    /* Of the step */
    struct mpm_active_condition *active;
    size_t active_count, active_capacity;
    size_t first_mirror;   /* of those: from here on v_r is minus that of the node at -r */
    int64_t mirror_column; /* of nodes, ghosts counted: where r = 0; 0 without mirrors */
    uint32_t
        *rigid_owner; /* per node: body + 1 that drives it in this step; only with rigid bodies */
    uint8_t *fixed;   /* per node: components held by boundaries; only with rigid bodies */
};

#endif
