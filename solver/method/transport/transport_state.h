/* Scalars that are conducted, on the nodes; see transport.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_STATE_H
#define MPM_METHOD_TRANSPORT_STATE_H

#include "base/status.h"
#include "model/scalar_conditions.h"
#include "model/transport.h"
#include "mpm_expression.h"

#include <assert.h>

/* Content that has come in since t = 0. */
struct mpm_scalar_totals {
    double held;         /* at nodes with a prescribed value */
    double source;       /* by the source */
    double edges;        /* through edges of particles */
    double largest_flow; /* per time, sum |inflow| over the nodes; with time.rest */
};

/* Of bodies that expand with a scalar, or are gases, since t = 0; see transfer/law_state.h. */
struct mpm_expansion_totals {
    double work; /* of free expansion and of gases: mechanical energy that came of it */
    double heat; /* that deformation gave to particles */
};

/* One of a body's particles: content c m v, flux - J k m grad v / V. */
struct mpm_scalar_body {
    double k[3]; /* conductivity over initial density, xx yy xy of the undeformed body; with a
                    table 1/rho_0 1/rho_0 0, times its value */
    double diffusivity; /* the largest, k / (c rho_0), at any temperature of tables */
    bool turns;         /* k is not a number times the unit tensor */
    const struct mpm_property *tables; /* of the material, by enum mpm_table */
};

/* Two fields of a node between which something flows; see transport_exchange.h. */
struct mpm_scalar_passage {
    int64_t node;      /* of the grid */
    int64_t fields[2]; /* indices of nodes */
    bool perfect;
    bool settles;       /* of perfect ones: between bodies that have come together */
    double settling[2]; /* what the fields are moved by besides, in a step in which they settle */
    double conductance; /* H A; of perfect ones 0 */
    double *total;      /* what has gone from the first to the second since t = 0; or NULL */
};

struct mpm_nodal_scalar {
    const struct mpm_scalar_row *row;
    enum mpm_scalar which;
    enum mpm_scalar_transfer transfer;
    int order;      /* of XPIC and FMPM; else 1 */
    double *weight; /* per body: c, capacity per mass; with a table its smallest */
    struct mpm_scalar_body *bodies;
    struct mpm_expression *source;      /* NULL: none */
    struct mpm_expression **conditions; /* per condition of the scene */
    struct mpm_scalar_hold *holds;      /* nodes with a prescribed value */
    size_t hold_count;
    double *settling; /* per hold and field: what that is moved by besides; see transport.h */
    int hold_fields;  /* fields that a node may have; see scalar_nodes.h */
    bool uniform;     /* c is the same for all bodies */
    bool settles;     /* in this step: held nodes, and fields of bodies that have come together */
    bool joins;       /* are there such bodies? */
    bool varies;      /* c is a table's for some body */
    bool at_hand;     /* content and capacity are those of the particles as they are */

    /* One number per node. Valid within one step, in scenes at rest content and capacity until
     * particles are sorted; where nothing is, zero. */
    double *content;  /* sum c m v S */
    double *capacity; /* sum c m S */
    double *value;    /* v_i at the start of the step, conditions included */
    double *inflow;   /* content per time */
    double *result;   /* what particles read: dv_i/dt, or with PIC v_i^{n+1} */
    double *smoothed; /* of XPIC and FMPM: w_r, and the sums that it is made of; or NULL */
    double *filtered;
    double *held; /* the part of it that is of held nodes, with FLIP where c varies; or NULL */
    double *row_inflow; /* per node row: its sum; finite if all are */
    /* Of the step: those of a node follow each other. */
    struct mpm_scalar_passage *passages;
    size_t passage_count, passage_capacity;
    struct mpm_scalar_totals totals;
};

/* Those of the scene, `count` of them; none: nothing is done. */
struct mpm_transport {
    struct mpm_nodal_scalar *list;
    size_t count;
    struct mpm_expansion_totals expansion;
    bool couples;  /* in this step the stresses follow what conduction has changed */
    bool flush;    /* results follow the step: transport_steps.h */
    double waited; /* time since the last conduction, with this step */
    int64_t steps_waited;
    const struct mpm_nodal_scalar *conducted; /* by the pass that runs */
    bool undeformed;                          /* nothing moves, and F = 1 */
    bool fields_known;  /* in scenes at rest: fields and passages are those of the particles */
    double diffusivity; /* largest J k / (c rho_0) of all particles and scalars in the step */
    double film;        /* largest derivative of a flux on edges by its scalar, over c rho_0 */
};

/* Do particles take values of the nodes, and not their rates? */
static inline bool mpm_scalar_takes_values(const struct mpm_nodal_scalar *scalar)
{
    return scalar->transfer != MPM_SCALAR_FLIP;
}

/* Adds a passage of the step: those of a node one after the other. */
static inline void mpm_scalar_passage_add(struct mpm_nodal_scalar *scalar,
                                          const struct mpm_scalar_passage *passage)
{
    assert(scalar->passage_count < scalar->passage_capacity);
    scalar->passages[scalar->passage_count++] = *passage;
}

#endif
