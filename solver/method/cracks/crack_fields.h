/* The velocity fields of nodes near cracks: CRAMP, section 2.1 and Task 1.
 *
 * A node that a crack hides from some of its particles has up to three velocity fields: its own,
 * for particles that see it past no crack, one for particles above a crack and one for those below.
 * Particles keep to their field in all that they exchange with the node. The two others are
 * additional fields (method/fields/fields.h) whose keys are the sides.
 *
 *        p       q           o  nodes          p - n2  passes no crack: n2's own field
 *     ---o-------o---                          p - n1  crosses the crack downwards: p is above,
 *         n3      n2                                   n1's field `above`
 *     =================      crack: to the     r - n3  crosses it upwards: r is below,
 *         n1      n4         right is along            n3's field `below`
 *     ---o-------o---                          Far from the crack nodes have their own field alone.
 *        r       s
 *
 *     n1: own field: r, s;   above: p, q          n3: own field: p, q;   below: r, s
 *
 * Which nodes need which fields is found in each step, before anything is spread; scenes without
 * cracks run none of this.
 *
 * With method.cracks: visibility a node that is hidden from a particle is no node of it: CRAMP,
 * section 3.1, in place of fields. It fails the crack patch test (case D1), and is there to show
 * it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_FIELDS_H
#define MPM_METHOD_CRACK_FIELDS_H

#include "method/fields/fields.h"

/* May the surfaces of this crack come into contact? */
static inline bool mpm_crack_has_contact(const struct mpm_scene *scene, size_t crack)
{
    return scene->crack_method == MPM_CRACKS_FIELDS &&
           scene->cracks[crack].contact != MPM_CONTACT_NONE;
}

/* Do cracks cut the particle's body? Beside contact between bodies they cut those whose field is
 * the grid's own. */
static inline bool mpm_cracks_cut(const struct mpm_state *state, size_t p)
{
    return state->bodies[state->particles.body[p]].layer == 0;
}

/* Or of any? */
bool mpm_cracks_have_contact(const struct mpm_scene *scene);

/* Has any crack a conductance for a scalar? */
bool mpm_cracks_have_conductance(const struct mpm_scene *scene);

/* Task 1, first part: v(p, i) of all particles near cracks; the nodes' additional fields, and their
 * rows. A line that crosses two cracks is recorded with its particle, and fails the step at its
 * end. MPM_RUN_FAILED: cracks have grown so that there is no room for what is near them. */
enum mpm_status mpm_cracks_find_fields(struct mpm_state *state, int workers,
                                       struct mpm_error *error);

/* Takes what cracks keep for particles and fields. */
void mpm_crack_fields_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Sums over the particles of one field, for contact; see crack_detection.h. */
struct mpm_crack_sums {
    double area; /* A_p S_ip: CRAMP (27) */
    double seen; /* the same with the mean of N_i over the domain for S_ip, in axisymmetry too */
    double gradient[2]; /* A_p G_ip: what the area gains if they all move */
};

/* The crack between an additional field of a node and the node's own field. */
#define MPM_NO_CRACK UINT32_MAX
struct mpm_crack_face {
    uint32_t crack;   /* the first one that lines from particles of the field cross */
    uint32_t last;    /* the last one: the same, unless particles beyond several share the field */
    double normal[2]; /* sum of the normals of the segments that they cross */
    /* A_p S_ip times the place of this crack's surface, from the parent node, as each particle of
     * the additional field has it, and each of the node's own */
    double beyond[2], own[2];
};

/* What cracks keep for an additional field. */
struct mpm_crack_field {
    struct mpm_crack_sums sums;
    struct mpm_crack_face face;
};

/* A node with several velocity fields, each by its mpm_crack_side. */
struct mpm_crack_node {
    int64_t field[3];                     /* index of it, the first the node itself; -1: none */
    uint8_t held[3];                      /* bits of the components that conditions hold */
    const struct mpm_crack_sums *sums[3]; /* of its particles */
    const struct mpm_crack_face *face[3]; /* the first has none */
};

/* The node at that place in the step's list of nodes with several fields. */
struct mpm_crack_node mpm_crack_node_of(const struct mpm_state *state, size_t place);

/* The place of a crack's first point among the points of all cracks. */
static inline size_t mpm_crack_first_point(const struct mpm_state *state, size_t crack)
{
    return (size_t)(state->cracks.chains[crack].x - state->cracks.position[0]);
}

#endif
