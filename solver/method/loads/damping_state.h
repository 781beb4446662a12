/* The state of damping; see damping.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_DAMPING_STATE_H
#define MPM_METHOD_DAMPING_STATE_H

#include "base/status.h"
#include "model/scene.h"
#include "mpm_expression.h"

/* Values that a step adds to; part of the last good state. */
struct mpm_damping_totals {
    double dissipated;      /* energy taken out since t = 0 */
    double rate;            /* alpha of the thermostat */
    double largest_kinetic; /* energy so far */
};

/* What a scene damps; see damping.h. NULL, false and 0 where it does not. */
struct mpm_damping {
    bool nodes;     /* by alpha_g or a thermostat */
    bool particles; /* by alpha_p, PIC damping, or alpha_g where it acts at the particles */
    enum mpm_grid_damping grid_form;
    struct mpm_expression *grid, *particle, *pic;
    double grid_rate;       /* of all nodes in this step: a grid(t), and the thermostat's */
    double particle_rate;   /* of all particles: a particle(t) */
    double pic_rate;        /* (1 - beta)/dt */
    double *grid_drag[2];   /* the part of it that is of alpha_g, see grid_drag.h */
    double (*node_drag)[2]; /* per node: alpha_g v_i^n, where particles take it from the nodes */
    struct mpm_damping_totals totals;
};

#endif
