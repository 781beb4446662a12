/* Scalars that are conducted, on the nodes; see transport.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_STATE_H
#define MPM_METHOD_TRANSPORT_STATE_H

#include "base/expression.h"
#include "model/scalar_conditions.h"
#include "model/transport.h"

/* Content that has come in since t = 0. */
struct mpm_scalar_totals {
    double held;   /* at nodes with a prescribed value */
    double source; /* by the source */
    double edges;  /* through edges of particles */
};

/* One of a body's particles: content c m v, flux - J k m grad v / V. */
struct mpm_scalar_body {
    double k[3];        /* conductivity over initial density, xx yy xy of the undeformed body */
    double diffusivity; /* the largest, k / (c rho_0) */
    bool turns;         /* k is not a number times the unit tensor */
};

struct mpm_nodal_scalar {
    enum mpm_scalar which;
    const struct mpm_scalar_row *row;
    enum mpm_scalar_transfer transfer;
    double *weight; /* per body: c, capacity per mass */
    bool uniform;   /* c is the same for all */
    struct mpm_scalar_body *bodies;
    struct mpm_expression *source;      /* NULL: none */
    struct mpm_expression **conditions; /* per condition of the scene */
    struct mpm_scalar_hold *holds;      /* nodes with a prescribed value */
    size_t hold_count;
    double *settling; /* per hold: what its node is moved by besides; see transport.h */
    bool settles;     /* in this step */

    /* One number per node. Valid within one step, in scenes at rest content and capacity until
     * particles are sorted; where nothing is, zero. */
    double *content;    /* sum c m v S */
    double *capacity;   /* sum c m S */
    double *value;      /* v_i at the start of the step, conditions included */
    double *inflow;     /* content per time */
    double *result;     /* what particles read: dv_i/dt, or with PIC v_i^{n+1} */
    double *row_inflow; /* per node row: its sum; finite if all are */
    bool at_hand;       /* content and capacity are those of the particles as they are */
    struct mpm_scalar_totals totals;
};

/* Those of the scene, `count` of them; none: nothing is done. */
struct mpm_transport {
    struct mpm_nodal_scalar *list;
    size_t count;
    const struct mpm_nodal_scalar *conducted; /* by the pass that runs */
    bool undeformed;                          /* nothing moves, and F = 1 */
    double diffusivity; /* largest J k / (c rho_0) of all particles and scalars in the step */
    double film;        /* largest derivative of a flux on edges by its scalar, over c rho_0 */
};

#endif
