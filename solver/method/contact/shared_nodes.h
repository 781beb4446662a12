/* The nodes that several velocity fields of bodies reach: a field is at a node if it has mass
 * there, a rigid body if it reaches the node.
 *
 * Cost: a look at the masses of active nodes, at all fields where several may be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SHARED_NODES_H
#define MPM_METHOD_SHARED_NODES_H

#include "method/fields/fields.h"

/* The scene's contact; only where it has some: mpm_body_contact_is_used. */
static inline const struct mpm_contact_spec *mpm_contact_spec(const struct mpm_state *state)
{
    return &state->scene->contact;
}

/* Takes the memory. */
void mpm_shared_nodes_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Lists nodes, fields and pairs, after task 1 and reflection. MPM_RUN_FAILED: no room. */
enum mpm_status mpm_shared_nodes_find(struct mpm_state *state, struct mpm_error *error);

/* The node's entry of a field, with the key of a crack's side or 0; or NULL. */
static inline struct mpm_contact_field *mpm_contact_field_at(const struct mpm_state *state,
                                                             const struct mpm_contact_node *node,
                                                             int field, int key)
{
    struct mpm_contact_field *const list = state->contact.fields + node->first_field;
    for (int k = 0; k < node->fields; k++)
        if (list[k].field == field && list[k].key == key)
            return &list[k];
    return NULL;
}

static inline struct mpm_contact_node *mpm_contact_node_at(const struct mpm_state *state,
                                                           int64_t node)
{
    const uint32_t place = state->contact.node_of[node];
    return place == 0 ? NULL : &state->contact.nodes[place - 1];
}

#endif
