/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_contact.h"

#include "method/contact/body_contact.h"
#include "method/contact/shared_nodes.h"
#include "method/grid/grid_update.h"

#include <math.h>

/* Of the surfaces at the node: what they share must be more than round-off. */
static const double FACING = 1e-9;

/* Are the surfaces of both at the node, and do they face each other? Beside corners the normal may
 * be along them: then they do not, and the gap along it says nothing. Bonded fields are one
 * wherever they share a node. */
static bool touch(const struct mpm_state *state, const struct mpm_contact_pair *pair,
                  enum mpm_pair_law law, double gap)
{
    double least = HUGE_VAL;
    for (int k = 0; k < 2; k++) {
        const double *const surface = state->contact.fields[pair->fields[k]].sums.surface;
        least = fmin(least, hypot(surface[0], surface[1]));
    }
    return pair->touches &&
           (law == MPM_PAIR_BONDED || (pair->gap <= gap && pair->area > FACING * least));
}

/* Passages of a pair in the order of its node's; rigid bodies have none. */
static void list_pair(struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                      const struct mpm_contact_node *node, const struct mpm_contact_pair *pair)
{
    const struct mpm_pair_spec *const spec = &mpm_contact_spec(state)->pairs[pair->spec];
    const struct mpm_surface_spec *const surface = &spec->surfaces[scalar->which];
    const bool perfect = surface->law == MPM_SURFACE_PERFECT;
    const double conductance = perfect ? 0.0 : surface->conductance * pair->area;
    if (surface->law == MPM_SURFACE_INSULATES || !touch(state, pair, spec->law, surface->gap) ||
        (!perfect && conductance == 0.0))
        return;
    mpm_scalar_passage_add(scalar,
                           &(struct mpm_scalar_passage){
                               .node = node->node,
                               .fields = {state->contact.fields[pair->fields[0]].node,
                                          state->contact.fields[pair->fields[1]].node},
                               .perfect = perfect,
                               .settles = perfect && scalar->joins && spec->law != MPM_PAIR_BONDED,
                               .conductance = conductance,
                               .total = &state->contact.totals[pair->spec].passed[scalar->which],
                           });
}

void mpm_transport_contact_list(struct mpm_state *state)
{
    const struct mpm_body_contact *const contact = &state->contact;
    for (size_t s = 0; s < state->transport.count && mpm_body_contact_is_used(state); s++) {
        struct mpm_nodal_scalar *const scalar = &state->transport.list[s];
        scalar->passage_count = 0;
        for (size_t k = 0; k < contact->node_count; k++) {
            const struct mpm_contact_node *const node = &contact->nodes[k];
            for (uint32_t i = 0; i < node->pairs && mpm_node_is_inside(state, node->node); i++)
                list_pair(state, scalar, node, &contact->pairs[node->first_pair + i]);
        }
    }
}
