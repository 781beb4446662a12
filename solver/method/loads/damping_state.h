/* The state of damping; see damping.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_DAMPING_STATE_H
#define MPM_METHOD_DAMPING_STATE_H

#include "base/expression.h"

/* Values that a step adds to; part of the last good state. */
struct mpm_damping_totals {
    double dissipated;      /* energy taken out since t = 0 */
    double rate;            /* alpha of the thermostat */
    double largest_kinetic; /* energy so far */
};

/* What a scene damps; see damping.h. NULL, false and 0 where it does not. */
struct mpm_damping {
    bool nodes, particles;
    struct mpm_expression *grid, *particle, *pic;
    double grid_rate;     /* of all nodes in this step: a grid(t), and the thermostat's */
    double particle_rate; /* of all particles: a particle(t) */
    double pic_rate;      /* (1 - beta)/dt */
    struct mpm_damping_totals totals;
};

#endif
