/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_edges.h"

#include "base/strips.h"
#include "method/contact/contact_sums.h"

#include <assert.h>
#include <math.h>

/* The first field is below its edge, the second one above: n points from the first to the second.
 */
MPM_INLINE void add_edge(const struct mpm_contact_particle *particle, const double from[2],
                         int side, struct mpm_contact_pair *pair)
{
    const double sign = side == 0 ? -1.0 : 1.0;
    const double n[2] = {sign * pair->normal[0], sign * pair->normal[1]};
    double beside;
    const double edge = sign * mpm_domain_nearest(particle->edge, from, n, &beside);
    pair->beside[side] = beside < pair->beside[side] ? beside : pair->beside[side];
    if (side == 0 ? edge > pair->edge[0] : edge < pair->edge[1])
        pair->edge[side] = edge;
}

static void widen(const struct mpm_contact_particle *particle, const double from[2],
                  struct mpm_contact_field *field)
{
    for (int axis = 0; axis < 2 && field != NULL; axis++) {
        const double half = fabs(particle->edge[axis]) + fabs(particle->edge[2 + axis]);
        field->low[axis] = fmin(field->low[axis], from[axis] - half);
        field->high[axis] = fmax(field->high[axis], from[axis] + half);
    }
}

MPM_INLINE void add_edges(struct mpm_state *state, const struct mpm_contact_particle *particle,
                          const double from[2], struct mpm_contact_node *node)
{
    const int key = mpm_contact_key_at(state, particle, node->node);
    if (node->cut)
        widen(particle, from, mpm_contact_field_at(state, node, particle->field, key));
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++) {
        struct mpm_contact_pair *const pair = &state->contact.pairs[k];
        if (!pair->has_normal)
            continue;
        if (pair->of[0] == particle->field && pair->keys[0] == key)
            add_edge(particle, from, 0, pair);
        else if (pair->of[1] == particle->field && pair->keys[1] == key)
            add_edge(particle, from, 1, pair);
    }
}

static void edges_of_strip(void *context, int64_t index, int worker)
{
    (void)worker;
    mpm_contact_strip_visit(context, index, false, add_edges);
}

static void edges_of_rigid(struct mpm_state *state, const struct mpm_contact_particle *particle,
                           const struct mpm_stencil *stencil)
{
    mpm_contact_stencil_visit(state, particle, stencil, add_edges);
}

/* The pair of a node that is of the same fields as another one's, or NULL. */
static struct mpm_contact_pair *same_pair(const struct mpm_state *state,
                                          const struct mpm_contact_node *node,
                                          const struct mpm_contact_pair *other)
{
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++)
        if (mpm_contact_is_image(state, &state->contact.pairs[k], other))
            return &state->contact.pairs[k];
    return NULL;
}

/* Normals from inside to beyond a plane of symmetry. */
static void mirror_normals(struct mpm_state *state, int axis, struct mpm_contact_node *inside,
                           const struct mpm_contact_node *beyond)
{
    for (uint32_t k = beyond->first_pair; k < beyond->first_pair + beyond->pairs; k++) {
        struct mpm_contact_pair *const other = &state->contact.pairs[k];
        const struct mpm_contact_pair *const one = same_pair(state, inside, other);
        other->has_normal = one != NULL && one->has_normal;
        for (int i = 0; i < 2 && other->has_normal; i++)
            other->normal[i] = i == axis ? -one->normal[i] : one->normal[i];
    }
}

/* Edges from beyond to inside. */
static void fold_edges(struct mpm_state *state, int axis, struct mpm_contact_node *inside,
                       const struct mpm_contact_node *beyond)
{
    (void)axis;
    assert(state->contact.pairs != NULL);
    for (uint32_t k = beyond->first_pair; k < beyond->first_pair + beyond->pairs; k++) {
        const struct mpm_contact_pair *const other = &state->contact.pairs[k];
        struct mpm_contact_pair *const one = same_pair(state, inside, other);
        if (one == NULL)
            continue;
        one->edge[0] = fmax(one->edge[0], other->edge[0]);
        one->edge[1] = fmin(one->edge[1], other->edge[1]);
        for (int side = 0; side < 2; side++)
            one->beside[side] = fmin(one->beside[side], other->beside[side]);
    }
}

/* Where a field has nothing at the node, what is nearest beside it counts in full. */
static void count_from_nearest(struct mpm_contact_pair *pair)
{
    if (!pair->has_normal || isinf(pair->edge[0]) || isinf(pair->edge[1]))
        return;
    pair->edge[0] += MPM_EDGE_SLOPE * pair->beside[0];
    pair->edge[1] -= MPM_EDGE_SLOPE * pair->beside[1];
}

void mpm_contact_edges_find(struct mpm_state *state, int workers)
{
    for (size_t k = 0; k < state->contact.pair_count; k++) {
        state->contact.pairs[k].edge[0] = -HUGE_VAL;
        state->contact.pairs[k].edge[1] = HUGE_VAL;
        state->contact.pairs[k].beside[0] = state->contact.pairs[k].beside[1] = HUGE_VAL;
    }
    for (size_t k = 0; k < state->contact.field_count; k++)
        for (int axis = 0; axis < 2; axis++) {
            state->contact.fields[k].low[axis] = HUGE_VAL;
            state->contact.fields[k].high[axis] = -HUGE_VAL;
        }
    mpm_contact_images_visit(state, mirror_normals);
    if (state->contact.node_count > 0) {
        mpm_strips_run(state->strip_count, workers, edges_of_strip, state);
        mpm_contact_rigid_run(state, edges_of_rigid);
    }
    mpm_contact_images_visit(state, fold_edges);
    for (size_t k = 0; k < state->contact.pair_count; k++)
        count_from_nearest(&state->contact.pairs[k]);
}
