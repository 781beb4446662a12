/* All that one step works on: particles, grid, strips, conditions and the choices of
 * the scene, made once when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_STATE_H
#define MPM_METHOD_STATE_H

#include "base/expression.h"
#include "method/kernels.h"
#include "method/shape/edge.h"
#include "method/shape/shape.h"
#include "method/transfer/exchange.h"
#include "model/boundary.h"
#include "model/crack.h"
#include "model/grid.h"
#include "model/material.h"
#include "model/particles.h"
#include "model/scene.h"

/* Where the stress update stands in the step, as parts of the time step: the rows of
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
    MPM_RATE_REFUSED,            /* value: the particle's damping rate */
    MPM_TRACTION_NOT_FINITE,     /* value: a component of the load `load`'s value */
    MPM_TWO_CRACKS,              /* value: nothing */
    MPM_GIVEN_FORCE_NOT_FINITE,  /* value: the caller's body force along the axis */
};

struct mpm_failure {
    enum mpm_failure_kind kind;
    uint32_t particle;
    int axis;
    double value;
    size_t load; /* index in the scene's edge_loads */
};

struct mpm_strip {
    size_t begin, end;               /* its particles */
    size_t span_count;               /* of those near cracks */
    int64_t column_low, column_high; /* box of the nodes that they reach; empty if low > high */
    int64_t row_low, row_high;
    double kinetic_energy;
    double strain_energy;      /* when it was last asked for */
    double wave_speed_squared; /* largest */
    double external_work;      /* of body forces, or of loads on edges, in the step */
    double dissipated;         /* by damping at the particles, in a part of the step */
    double internal_work;      /* what stresses take from the nodes in the step */
    struct mpm_failure failure;
};

struct mpm_body {
    double half_size[2];
    struct mpm_material material;
};

/* A condition on a node that carries mass in this step. */
struct mpm_active_condition {
    int64_t node;
    int32_t component;
    uint32_t source; /* body index of a rigid body, or MPM_FROM_... */
    double start, end;
};
#define MPM_FROM_BOUNDARY UINT32_MAX
#define MPM_FROM_MIRROR   (UINT32_MAX - 1)

struct mpm_vector_field {
    struct mpm_expression *component[2]; /* NULL: free, or no such field */
};

/* What has to be done for the body force. */
enum mpm_body_force_kind {
    MPM_NO_BODY_FORCE,
    MPM_UNIFORM_BODY_FORCE, /* a constant, or of time alone: all of it at the nodes */
    MPM_VARYING_BODY_FORCE, /* in space: at the particles */
};

/* An edge of a particle that a load acts on; by ascending id. */
struct mpm_edge_site {
    uint32_t id; /* of the particle */
    uint32_t load;
    enum mpm_edge edge;
    double area; /* undeformed */
};

/* The same, in the order of the particles, with what it gives to the nodes in this step. */
struct mpm_loaded_edge {
    size_t particle;
    const struct mpm_edge_site *site;
    double traction[2];
    struct mpm_edge_weights weights;
};

/* Tractions and particle forces; all empty where a scene has none. See edge_loads.h. */
struct mpm_edge_loads {
    struct mpm_vector_field *value; /* per load of the scene */
    size_t count;
    struct mpm_edge_site *sites;
    struct mpm_loaded_edge *edges;
    size_t *first; /* per strip: its first edge; one more entry, `count` */
};

/* A body force that the caller gives; see given_force.h. All NULL where none is given. */
struct mpm_given_force {
    struct mpm_body_force caller;
    double (*force)[MPM_NODE_VALUES]; /* per node: sum m_p S_ip b_p, as in mpm_exchange.to */
    double *row_work;                 /* per node row */
};

/* What damping remembers from step to step. */
struct mpm_damping_books {
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
    double *drag[2];      /* per particle: the deceleration of this step */
    struct mpm_damping_books books;
};

/* A plane of symmetry: a line of nodes; see symmetry.h. */
struct mpm_symmetry {
    int axis;       /* of its normal */
    int64_t line;   /* column or row of its nodes, ghosts counted */
    int64_t inside; /* towards the bodies: 1 or -1 */
};

/* Particles begin..end - 1, near a crack. */
struct mpm_crack_span {
    size_t begin, end;
};

/* The fields that one surface of a crack moves with at one of its points: nodes of the corners of a
 * cell, weights of sum 1. None where no such field has mass. */
struct mpm_crack_surface {
    int count;
    int64_t node[4];
    double weight[4];
};

/* The surfaces of cracks that ask for it; all NULL where none does. See crack_opening.h. */
struct mpm_crack_openings {
    double *vector[2]; /* per point: place of the surface above minus that of the one below */
    double *largest;   /* per point, cohesive: the largest effective opening so far */
    double *area;      /* per point, cohesive: undeformed area, for the thickness or per radian */
    bool (*cuts)[2];   /* per crack: does it cut its body's edge at its first point, at its last? */
    /* per crack: its points, among those of all, where it enters a body from outside, seen from its
     * first point and from its last; SIZE_MAX: that point is no mouth, or in a body itself */
    size_t (*mouths)[2];
    /* Of the step, per point: the surface above, and that below */
    struct mpm_crack_surface (*surfaces)[2];
};

/* Cracks; all empty where a scene has none. */
struct mpm_cracks {
    struct mpm_crack_chain *chains; /* per crack of the scene */
    size_t point_count;
    double *position[2]; /* of all chains' points, one after the other */
    uint8_t *held;       /* per point: bits of the axes along which a symmetry plane holds it */
    double least_mass;   /* of a node that moves cracks; see mpm_cracks_advance */
    struct mpm_crack_openings openings;
    double widest[2]; /* reach of the largest undeformed domain */
    /* Of the step */
    struct mpm_crack_map *map;   /* cells near cracks; see crack_map.h */
    struct mpm_crack_kept *kept; /* particles with further fields; see crack_fields.h */
    _Atomic size_t kept_count;
    size_t kept_capacity;
    uint32_t *kept_of;            /* per particle: one more than its place in `kept`, or 0 */
    struct mpm_crack_span *spans; /* see mpm_crack_spans */
    uint8_t *wanted;   /* per node: bits of the sides that some particle asks for, and more of
                        * mpm_crack_node's on_plane */
    uint32_t *node_of; /* per node: one more than its place in `nodes`, or 0 */
    struct mpm_crack_node *nodes; /* in the order of the grid; see crack_fields.h */
    size_t node_count, node_capacity;
    int64_t *homes; /* per further field: the node that it belongs to */
    int64_t field_count;
    int64_t rows; /* that further fields fill, after those of the grid */
};

/* The forces of a step, |f_x| + |f_y| over nodes, for scenes that ask for rest. */
struct mpm_balance {
    double internal;   /* of all nodes */
    double unbalanced; /* of the components that nothing holds */
};

/* What passes over rows leave for a sum in the rows' order; where a scene damps nodes, asks for
 * rest or measures its energy balance. */
struct mpm_row_sums {
    double dissipated;
    struct mpm_balance balance;
    double kinetic[2]; /* energy of the nodes at both ends of the step */
    int64_t refused;   /* the first node with a rate that is not allowed, or -1 */
    double rate;       /* there */
};

/* Energy between particles and nodes since t = 0, where a scene measures it; see
 * energy_balance.h. */
struct mpm_energy_balance {
    bool measured;
    double particles;     /* their kinetic energy */
    double lost;          /* kinetic energy, between particles and nodes */
    double internal_work; /* what internal and cohesive forces have taken from the nodes */
    double contact;       /* what contact of cracks has taken in momentum updates */
    double dissipated;    /* by damping, before that of the particles in this step */
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
    struct mpm_particles rigid;
    struct mpm_body *bodies;

    struct mpm_strip *strips;
    int64_t strip_count;
    int workers;
    size_t deformable_bodies;
    int64_t *row_low, *row_high; /* active columns of each node row, as node indices in the row */
    int64_t first_row, last_row; /* active rows */
    uint32_t *sort_counts;
    double sort_size[2]; /* reach of the smallest domain */

    struct mpm_condition *conditions;
    size_t condition_count;
    struct mpm_active_condition *active;
    size_t active_count, active_capacity;
    size_t first_mirror;   /* of those: from here on v_r is minus that of the node at -r */
    int64_t mirror_column; /* of nodes, ghosts counted: where r = 0; 0 without mirrors */
    uint32_t
        *rigid_owner; /* per node: body + 1 that drives it in this step; only with rigid bodies */
    uint8_t *fixed;   /* per node: components held by boundaries; only with rigid bodies */
    struct mpm_vector_field *boundary_velocity; /* per boundary */
    struct mpm_vector_field *body_velocity;     /* per body: rigid ones */
    struct mpm_vector_field body_force;
    enum mpm_body_force_kind body_force_kind;
    double uniform_force[2];   /* its value in this step */
    double (*row_momentum)[2]; /* per node row: sum m_i (v_i^n + v_i^{n+1}); for a uniform one */

    struct mpm_edge_loads edge_loads;
    struct mpm_cracks cracks;
    struct mpm_symmetry *symmetries;
    size_t symmetry_count;

    const struct mpm_exchange *exchange; /* of the pass that runs */
    struct mpm_given_force given_force;
    struct mpm_damping damping;
    struct mpm_energy_balance energy;
    struct mpm_balance balance;    /* of the last step, if the scene asks for rest */
    struct mpm_row_sums *row_sums; /* per node row */

    double time;      /* at the start of the step */
    double time_step; /* of this step */
    double external_work;
    double driven_energy; /* kinetic, of the nodes that conditions move: the largest so far */
    int steps_since_sort;
    bool strips_touch_when_sorted; /* domains too long for the strips: sorting does not help */
    struct mpm_failure failure;
};

/* Keeps the failure with the smaller id. */
void mpm_failure_merge(struct mpm_failure *into, const struct mpm_failure *failure);

#endif
