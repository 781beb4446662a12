/* Velocity fields of the nodes near cracks: CRAMP, section 2.1 and Task 1.
 *
 * A node that a crack hides from some of its particles has up to three velocity fields: one for
 * particles on its own side, one for those above, one for those below the crack. Particles keep to
 * their field in all that they exchange with the node.
 *
 * The first field is the node itself. The others are further nodes, in rows behind those of the
 * grid: the stencil of a particle near a crack names them in the node's place, and whatever
 * works on stencils or on rows of nodes, works on them. Which nodes need which fields is found in
 * each step, before anything is spread; scenes without cracks run none of this.
 *
 * With method.cracks: visibility a node that is hidden from a particle is no node of it: CRAMP,
 * section 3.1, in place of fields. It fails the crack patch test (case D1), and is there to show
 * it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_FIELDS_H
#define MPM_METHOD_CRACK_FIELDS_H

#include "method/state.h"

/* Task 1, first part: v(p, i) of all particles near cracks; the nodes' further fields, and their
 * rows. A line that crosses two cracks is recorded with its particle, and fails the step at its
 * end. MPM_RUN_FAILED: cracks have grown so that there is no room for what is near them. */
enum mpm_status mpm_cracks_find_fields(struct mpm_state *state, int workers,
                                       struct mpm_error *error);

/* Sums over the particles of one field, for contact; see crack_detection.h. */
struct mpm_crack_sums {
    double area; /* A_p S_ip: CRAMP (27) */
    double seen; /* the same with the mean of N_i over the domain for S_ip, in axisymmetry too */
    double gradient[2]; /* A_p G_ip: what the area gains if they all move */
};

/* The crack between a further field of a node and the node's own field. */
#define MPM_NO_CRACK UINT32_MAX
struct mpm_crack_face {
    uint32_t crack;   /* the first one that lines from particles of the field cross */
    uint32_t last;    /* the last one: the same, unless particles beyond several share the field */
    double normal[2]; /* sum of the normals of the segments that they cross */
    /* A_p S_ip times the place of this crack's surface, from the node, as each particle of the
     * further field has it, and each of the node's own */
    double beyond[2], own[2];
};

/* A node with several velocity fields. */
struct mpm_crack_node {
    /* index of the field of each mpm_crack_side, the first the node itself; -1: none */
    int64_t field[3];
    uint8_t held[3]; /* per field: bits of the components that conditions hold */
    /* per field: bits of the axes across which a crack that asks for it lies on a plane of
     * symmetry: the field is on a free surface there */
    uint8_t on_plane[3];
    struct mpm_crack_sums sums[3]; /* of the particles of each field */
    struct mpm_crack_face face[3]; /* of each further field; the first has none */
};

/* Where the step's spans of a strip stand: those with particles that have further fields, and with
 * the particles between them where those are fewer than MPM_CRACK_GAP. */
enum { MPM_CRACK_GAP = 16 };
static inline struct mpm_crack_span *mpm_crack_spans(const struct mpm_state *state, int64_t strip)
{
    return state->cracks.spans + strip + state->strips[strip].begin / MPM_CRACK_GAP;
}

/* The segment that the line to a node crosses. */
struct mpm_crack_crossing {
    uint32_t crack, segment;
};

/* A particle with nodes that have further fields; from the start of a step to its end. */
struct mpm_crack_kept {
    uint32_t particle;
    uint32_t code;              /* two bits for each node of its plain stencil, an mpm_crack_side */
    struct mpm_stencil stencil; /* its nodes in its fields */
    struct mpm_crack_crossing crossing[MPM_STENCIL_MAX]; /* of nodes on another side */
};

/* The entry of a particle that has such nodes, or NULL. */
static inline const struct mpm_crack_kept *mpm_crack_kept_of(const struct mpm_state *state,
                                                             size_t p)
{
    const uint32_t place = state->cracks.kept_of[p];
    return place == 0 ? NULL : &state->cracks.kept[place - 1];
}

/* Puts the particle's fields into the nodes of one of its edges. */
void mpm_crack_divert_edge(const struct mpm_state *state, size_t p,
                           struct mpm_edge_weights *weights);

/* The place of a crack's first point among the points of all cracks. */
static inline size_t mpm_crack_first_point(const struct mpm_state *state, size_t crack)
{
    return (size_t)(state->cracks.chains[crack].x - state->cracks.position[0]);
}

/* The node of the grid that a node is, or is a field of. */
static inline int64_t mpm_crack_home(const struct mpm_state *state, int64_t node)
{
    const int64_t further = node - state->grid.columns * state->grid.rows;
    return further < 0 ? node : state->cracks.homes[further];
}

/* The entry of a node of the grid that has further fields, or NULL. */
static inline struct mpm_crack_node *mpm_crack_node_at(const struct mpm_state *state, int64_t node)
{
    if (state->cracks.node_of == NULL || state->cracks.node_of[node] == 0)
        return NULL;
    return &state->cracks.nodes[state->cracks.node_of[node] - 1];
}

#endif
