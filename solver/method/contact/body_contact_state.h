/* What contact between bodies keeps; see body_contact.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_BODY_CONTACT_STATE_H
#define MPM_METHOD_BODY_CONTACT_STATE_H

#include "method/contact/logistic_plane.h"
#include "method/fields/fields_state.h"
#include "model/contact.h"

/* Of the fit of displacement; see displacement_fit.h. */
struct mpm_displacement_sums {
    double weight;
    double x[2], xx[3]; /* of places; xx, xy, yy */
    double u[2], ux[4]; /* u_x, u_y; u_x x, u_x y, u_y x, u_y y */
    double v[2], vx[4]; /* the same of the particles' velocities */
    double h[4];
};

/* Sums over the particles of a field at a node; places are counted from the node. */
struct mpm_contact_sums {
    double area;           /* sum A_p S_ip */
    double area_normal[2]; /* sum A_p G_ip */
    double surface[2];     /* integral of N_i n over the field's surface: contact_detection.h */
    /* where sums_volume: sum V_p S_ip, sum V_p G_ip, and the area with means of N_i in axisymmetry:
     * contact_detection.h */
    double volume, volume_normal[2], seen;
    double moments[6]; /* for regressions: sum w {1, x, y, xx, xy, yy}, in cells */
    struct mpm_displacement_sums displacement; /* of an interface */
};

/* A velocity field at a node where several meet. */
struct mpm_contact_field {
    int64_t node; /* of the grid, of a layer, or packed; -1: of a rigid body */
    uint8_t field;
    uint8_t key;                         /* of a packed field: side of a crack; else 0 */
    uint8_t held;                        /* bits of the components that conditions hold */
    double rigid_start[2], rigid_end[2]; /* velocity of a rigid one at both ends of the step */
    struct mpm_contact_sums sums;
    double low[2], high[2]; /* where a crack cuts a field of the node: what its particles fill */
};

/* Two fields of a node between which there is contact. */
struct mpm_contact_pair {
    uint32_t fields[2];     /* places in the list of fields */
    uint32_t spec;          /* place in the scene's pairs */
    uint8_t of[2], keys[2]; /* the fields, and their keys */
    bool has_normal, touches;
    double normal[2]; /* unit vector from the first to the second */
    double edge[2];   /* how far the first goes along the normal, and where the second begins */
    double beside[2]; /* least distance of either from the line through the node along the normal */
    double gap;       /* of surfaces: positive if they are apart */
    double area;      /* of contact at the node */
    double jump[2];   /* of the displacement, normal and tangential: second less first */
    double rate[2];   /* of the particles' velocity */
};

/* A node of the grid that several fields reach. */
struct mpm_contact_node {
    int64_t node;
    uint32_t first_field, first_pair;
    uint8_t fields, pairs;
    bool cut; /* a crack gives one of the bodies several fields here */
};

/* Of a pair of fields of the scene. */
struct mpm_contact_totals {
    double dissipated;               /* since t = 0 */
    double work;                     /* that an interface has taken from the nodes since t = 0 */
    double passed[MPM_SCALAR_COUNT]; /* content of scalars, from the first field to the second */
};
struct mpm_contact_sample {
    double force[2]; /* on the first field in the last step */
    double area;     /* of contact in the last step */
    double stored;   /* by an interface */
    size_t nodes;    /* in contact */
    size_t stiff;    /* of an interface: nodes where it is stiffer than an explicit step allows */
};

/* A particle with nodes in the list: they are in a block from a column and a row of nodes on. */
struct mpm_contact_near {
    uint32_t particle;
    int32_t column, row;
    uint16_t columns, rows;
};

struct mpm_state;
struct mpm_contact_side;
struct mpm_exchange_touch;

struct mpm_body_contact {
    /* Of scenes with bonded pairs, for XPIC and FMPM: keeps their fields one; or NULL. */
    void (*exchange_smoothed)(struct mpm_state *state);
    /* Of scenes with cracks: the pairs of fields of a node that touch across a crack; or NULL. */
    const struct mpm_exchange_touch *(*crack_touches)(const struct mpm_state *state, int64_t node);
    /* Called for each impulse at the end of a step on a node that was `side` before: what counts
     * energy by velocities of the nodes follows it. */
    void (*follow_impulse)(struct mpm_state *state, int64_t node,
                           const struct mpm_contact_side *side, const double impulse[2]);
    /* Does a pair's normal, its detection or its law need them? */
    bool sums_moments, sums_displacement, sums_volume;
    size_t node_capacity, field_capacity, pair_capacity;
    int64_t shift[MPM_CONTACT_FIELDS]; /* of a deformable field: from a node to its copy */
    uint8_t *field_of;                 /* per body: its field; MPM_CONTACT_FIELDS: none */
    uint8_t *touched; /* per body, of rigid ones: bits of the layers with contact; or NULL */
    /* Of the step */
    struct mpm_contact_node *nodes;
    size_t node_count;
    struct mpm_contact_field *fields;
    size_t field_count;
    struct mpm_contact_pair *pairs;
    size_t pair_count;
    struct mpm_logistic_plane *planes; /* per pair, of scenes with logistic regression; or NULL */
    uint32_t *node_of;         /* per node of the grid: one more than its place in `nodes`, or 0 */
    uint8_t *rigid_at;         /* per node of the grid: bits of the rigid fields; or NULL */
    struct mpm_bands rigid_in; /* nodes in rigid_at */
    struct mpm_bands beside;   /* cells with a corner in `nodes` */
    struct mpm_contact_near *near; /* see mpm_contact_near_of */
    size_t *near_count;            /* per strip */
    /* per pair of the scene */
    struct mpm_contact_totals *totals;
    struct mpm_contact_sample *samples;
};

#endif
