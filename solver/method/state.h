/* All that one step works on: particles, grid, strips, the choices of the scene, made once when
 * the simulation is created, and what each feature keeps, which its own header declares
 * (<feature>_state.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_STATE_H
#define MPM_METHOD_STATE_H

#include "method/contact/body_contact_state.h"
#include "method/cracks/cracks_state.h"
#include "method/energy_balance_state.h"
#include "method/fields/fields_state.h"
#include "method/grid/conditions_state.h"
#include "method/grid/symmetry_state.h"
#include "method/loads/damping_state.h"
#include "method/loads/edge_loads_state.h"
#include "method/loads/nodal_force_state.h"
#include "method/loads/rest_state.h"
#include "method/loads/user_force_state.h"
#include "method/passes.h"
#include "method/shape/shape.h"
#include "method/transfer/projection_state.h"
#include "method/transport/transport_state.h"
#include "model/grid.h"
#include "model/material.h"
#include "model/particles.h"
#include "model/scene.h"

/* Where the stress update is in the step, as parts of the time step: the rows of
 * CRAMP's Appendix, Tasks 2 and 6. */
struct mpm_stress_order {
    const char *name;
    double before;    /* part done with the velocities at the start of the step */
    double after;     /* part done with velocities at its end */
    bool extrapolate; /* those come from the updated particles (31), not from the grid (29) */
};
const struct mpm_stress_order *mpm_stress_order(enum mpm_stress_update update);

/* Why a run cannot go on; the smallest particle id wins, so that the message does not
 * depend on the number of workers. */
enum mpm_failure_kind {
    MPM_NO_FAILURE,
    MPM_INVERTED,                /* value: det F */
    MPM_NOT_FINITE,              /* value: the offending one */
    MPM_LEFT_GRID,               /* value: the coordinate */
    MPM_PAST_AXIS,               /* value: r */
    MPM_OUTRAN_CELL,             /* value: cells travelled in the step */
    MPM_DOMAIN_TOO_BIG,          /* value: its reach in cells */
    MPM_LOAD_NOT_FINITE,         /* value: the body force along the axis */
    MPM_UNIFORM_LOAD_NOT_FINITE, /* the same; of no particle */
    MPM_RATE_REFUSED,            /* value: damping.particle there; axis 1: damping.grid */
    MPM_TRACTION_NOT_FINITE,     /* value: a component of the load `load`'s value */
    MPM_TWO_CRACKS,              /* value: nothing */
    MPM_USER_FORCE_NOT_FINITE,   /* value: the caller's body force along the axis */
    MPM_SOURCE_NOT_FINITE,       /* value: a scalar's source there */
    MPM_BELOW_ZERO,              /* value: temperature of an edge that radiates */
    MPM_CAPACITY_NEGATIVE,       /* value: temperature at which c_v is not above 0 */
    MPM_TEMPERATURE_NEGATIVE,    /* value: temperature, which should be absolute */
    MPM_NO_TEMPERATURE,          /* value: temperature before heat of deformation without end */
    MPM_OUTSIDE_TABLE,           /* axis: of which scalar and table, mpm_table_place; value: its */
    MPM_NO_RETURN,               /* value: equivalent trial stress without a way back to yield */
    MPM_NO_THICKNESS,            /* value: tau_zz that no F_zz makes vanish, in plane stress */
    MPM_NO_STATE,                /* value: J, at which an equation of state has no next state */
    MPM_STRAIN_TOO_LARGE,        /* value: largest component of F, beside which b_e is no number */
    MPM_COLD,                    /* value: temperature, below zero, that strength depends on */
};

struct mpm_failure {
    enum mpm_failure_kind kind;
    uint32_t particle;
    int axis;
    double value;
    size_t load; /* index in the scene's edge_loads */
};

/* A box of nodes: columns and rows, ghosts not counted; empty if low > high. */
struct mpm_node_box {
    int64_t low[2], high[2];
};
#define MPM_NO_BOX ((struct mpm_node_box){{0, 0}, {-1, -1}})

static inline bool mpm_box_is_empty(const struct mpm_node_box *box)
{
    return box->low[0] > box->high[0];
}

struct mpm_strip {
    size_t begin, end;       /* its particles */
    size_t span_count;       /* of those with additional velocity fields */
    struct mpm_node_box box; /* of the nodes that they reach */
    double kinetic_energy;
    double strain_energy;      /* when it was last computed */
    double wave_speed_squared; /* largest */
    double external_work;      /* of body forces, or of loads on edges, in the step */
    double dissipated;         /* by damping at the particles, in a part of the step */
    double internal_work;      /* what stresses take from the nodes in the step */
    double expansion_work;     /* of free expansion and of gases, in the step */
    double deformation_heat;   /* given to particles in the step */
    double inflow;             /* of a scalar, by its source or through edges: content per time */
    double diffusivity;        /* largest J k / (c rho_0) */
    double film;               /* largest derivative of a flux by the scalar, over c rho_0 */
    struct mpm_failure failure;
};

struct mpm_body {
    double half_size[2];
    int64_t layer; /* that the body moves in; 0: the grid itself; see fields.h */
    struct mpm_material material;
    const struct mpm_material_spec *given; /* of the scene */
};

/* What has to be done for the body force. */
enum mpm_body_force_kind {
    MPM_NO_BODY_FORCE,
    MPM_UNIFORM_BODY_FORCE, /* a constant, or of time alone: all of it at the nodes */
    MPM_VARYING_BODY_FORCE, /* in space: at the particles */
    MPM_NODAL_BODY_FORCE,   /* in space, taken at the nodes: nodal_force.h */
};

/* Where some particles were, so many steps after the last sort, or -1: anywhere. Those that cannot
 * have come near marked cells since then are not looked at. */
struct mpm_chunk_hull {
    double low[2], high[2]; /* along y: for chunks near them; else low > high */
    int step;
};

struct mpm_state {
    const struct mpm_scene *scene;
    const struct mpm_stress_order *order;
    struct mpm_kernel_choice kernels;
    const struct mpm_shape_family *family;
    struct mpm_shape_grid shape_grid;
    struct mpm_grid grid;
    int64_t node_zero; /* index of node (0, 0): stencil offsets count from it */
    struct mpm_particles particles;
    struct mpm_rigid_particles rigid;
    struct mpm_body *bodies;

    struct mpm_strip *strips;
    int64_t strip_count;
    int workers;
    size_t deformable_bodies;
    int64_t *row_low, *row_high; /* active columns of each row of nodes, from the row's first on */
    int64_t first_row, last_row; /* active rows */
    uint32_t *sort_counts;
    double sort_size[2]; /* reach of the smallest domain */
    double widest[2];    /* reach of the largest undeformed domain */

    struct mpm_conditions conditions;
    struct mpm_vector_field body_force;
    enum mpm_body_force_kind body_force_kind;
    double uniform_force[2];   /* its value in this step */
    double (*row_momentum)[2]; /* per node row: sum m_i (v_i^n + v_i^{n+1}); for a uniform one */
    struct mpm_nodal_force nodal_force;

    struct mpm_edge_loads edge_loads;
    struct mpm_fields fields;
    struct mpm_cracks cracks;
    struct mpm_chunk_hull *nearby; /* per chunk of a strip's particles; see nearby.h; or NULL */
    struct mpm_body_contact contact;
    struct mpm_symmetries symmetries;

    struct mpm_transport transport;

    bool law_states; /* stresses depend on more than F: transfer/law_state.h */

    const struct mpm_projection *projection; /* of the pass that runs */
    struct mpm_user_force user_force;
    struct mpm_damping damping;
    struct mpm_energy_balance energy;
    struct mpm_balance balance;    /* of the last step, if the scene has time.rest */
    struct mpm_row_sums *row_sums; /* per node row */

    double time;      /* at the start of the step */
    double time_step; /* of this step */
    double external_work;
    double sudden_energy; /* kinetic, of what conditions change at once: the largest so far */
    int steps_since_sort;
    bool strips_touch_when_sorted; /* domains too long for the strips: sorting does not help */
    struct mpm_failure failure;
};

/* The boxes of a strip's particles by layers, in scenes with some: fields.h. */
static inline struct mpm_node_box *mpm_layer_boxes(const struct mpm_state *state,
                                                   const struct mpm_strip *strip)
{
    return state->fields.boxes + (strip - state->strips) * (1 + state->fields.layers);
}

/* Keeps the failure with the smaller id. */
void mpm_failure_merge(struct mpm_failure *into, const struct mpm_failure *failure);

#endif
