/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid/symmetry.h"

#include "method/fields/fields.h"
#include "method/grid/grid_update.h"

/* First what nodes beyond a plane have is added to those that they are images of, then they take
 * these nodes' values. */
enum stage { ADD_UP, COPY };

static inline void fold(enum stage stage, double *inside, double *beyond, double sign)
{
    if (stage == ADD_UP)
        *inside += sign * *beyond;
    else
        *beyond = sign * *inside;
}

int64_t mpm_symmetry_original(const struct mpm_state *state, int64_t node, double sign[2])
{
    const int64_t columns = state->grid.columns;
    sign[0] = sign[1] = 1.0;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        const int64_t place[2] = {node % columns, node / columns};
        const int64_t depth = (plane->line - place[plane->axis]) * plane->inside;
        if (depth <= 0)
            continue;
        node += 2 * depth * plane->inside * (plane->axis == 0 ? 1 : columns);
        sign[plane->axis] = -1.0;
    }
    return node;
}

/* A scalar of the nodes and a vector, whose component k is number 2 k of a node's values; NULL:
 * none. */
struct spread {
    enum stage stage;
    double *scalar, *vector;
};

static void fold_nodes(const struct spread *spread, int axis, int64_t inside, int64_t beyond)
{
    double *const vector = spread->vector;
    if (spread->scalar != NULL)
        fold(spread->stage, &spread->scalar[inside], &spread->scalar[beyond], 1.0);
    for (int k = 0; vector != NULL && k < 2; k++)
        fold(spread->stage, &vector[MPM_NODE_VALUES * inside + 2 * k],
             &vector[MPM_NODE_VALUES * beyond + 2 * k], k == axis ? -1.0 : 1.0);
}

/* All nodes of a layer beyond the plane that are active; images inside are reached
 * by the same particles. Nodes on the plane have nothing along its normal. */
static void reflect_across(const struct mpm_state *state, const struct mpm_symmetry *plane,
                           const struct spread *spread, int64_t layer)
{
    const int64_t columns = state->grid.columns, shift = layer * state->grid.rows;
    const int64_t *const low = state->row_low + shift, *const high = state->row_high + shift;
    for (int64_t row = state->first_row; row <= state->last_row; row++)
        for (int64_t column = low[row]; column <= high[row]; column++) {
            const int64_t place[2] = {column, row};
            const int64_t depth = (plane->line - place[plane->axis]) * plane->inside;
            const int64_t node = (shift + row) * columns + column;
            const int64_t stride = plane->axis == 0 ? 1 : columns;
            if (depth == 0 && spread->vector != NULL)
                spread->vector[MPM_NODE_VALUES * node + 2 * plane->axis] = 0.0;
            else if (depth > 0)
                fold_nodes(spread, plane->axis, node + 2 * depth * plane->inside * stride, node);
        }
}

/* Packed fields of cracks that pass the plane. */
static void reflect_packed(struct mpm_state *state, int axis, const struct mpm_field_node *inside,
                           const struct mpm_field_node *beyond, const void *context)
{
    const struct spread *const spread = context;
    const struct mpm_additional_field *const list = state->fields.list + inside->first;
    const int64_t first = mpm_fields_first(state) + inside->first;
    for (int i = 0; i < inside->count; i++) {
        const int64_t image = beyond == NULL ? -1 : mpm_field_of(state, beyond, list[i].key);
        if ((list[i].passes >> axis & 1) == 0)
            continue;
        if (beyond == NULL && spread->vector != NULL)
            spread->vector[MPM_NODE_VALUES * (first + i) + 2 * axis] = 0.0;
        else if (beyond != NULL && image >= 0)
            fold_nodes(spread, axis, first + i, image);
    }
}

static void visit_across(struct mpm_state *state, const struct mpm_symmetry *plane,
                         mpm_symmetry_visit *visit, const void *context)
{
    const int64_t columns = state->grid.columns;
    const struct mpm_fields *const fields = &state->fields;
    for (size_t k = 0; k < fields->node_count; k++) {
        const struct mpm_field_node *const node = &fields->nodes[k];
        const int64_t place[2] = {node->node % columns, node->node / columns};
        const int64_t depth = (plane->line - place[plane->axis]) * plane->inside;
        const int64_t stride = plane->axis == 0 ? 1 : columns;
        const struct mpm_field_node *const inside =
            mpm_field_node_at(state, node->node + 2 * depth * plane->inside * stride);
        if (depth >= 0 && inside != NULL)
            visit(state, plane->axis, inside, depth == 0 ? NULL : node, context);
    }
}

void mpm_symmetries_visit(struct mpm_state *state, mpm_symmetry_visit *visit, const void *context)
{
    for (size_t k = 0; state->symmetries.passed && k < state->symmetries.count; k++)
        visit_across(state, &state->symmetries.planes[k], visit, context);
}

static void reflect_one(struct mpm_state *state, const struct mpm_symmetry *plane,
                        const struct spread *spread)
{
    for (int64_t layer = 0; layer <= state->fields.layers; layer++)
        reflect_across(state, plane, spread, layer);
    if (state->symmetries.passed)
        visit_across(state, plane, reflect_packed, spread);
}

/* Where planes cross, a node is the image of an image. All is added up before any value is copied,
 * and copied in the opposite order: a node beyond one plane takes what came from beyond the other,
 * too, even if no particle reaches the node beyond both. */
static void reflect(struct mpm_state *state, struct spread spread)
{
    const size_t count = state->symmetries.count;
    spread.stage = ADD_UP;
    for (size_t k = 0; k < count; k++)
        reflect_one(state, &state->symmetries.planes[k], &spread);
    spread.stage = COPY;
    for (size_t k = count; k-- > 0;)
        reflect_one(state, &state->symmetries.planes[k], &spread);
}

void mpm_symmetries_reflect_momentum(struct mpm_state *state)
{
    reflect(state,
            (struct spread){.scalar = state->grid.mass, .vector = &state->grid.sum[0][0].momentum});
}

void mpm_symmetries_reflect_force(struct mpm_state *state)
{
    reflect(state, (struct spread){.vector = &state->grid.sum[0][0].force});
}

void mpm_symmetries_reflect_extrapolated(struct mpm_state *state)
{
    reflect(state, (struct spread){.vector = state->grid.gradient[0][0]});
}

void mpm_symmetries_reflect_scalar(struct mpm_state *state, double *nodes)
{
    reflect(state, (struct spread){.scalar = nodes});
}

/* ------------------------------------------------------------------- images */

/* The image of an image across one plane; false if it is the node itself, or not active. */
static bool find_image(const struct mpm_state *state, const struct mpm_symmetry *plane,
                       const struct mpm_symmetry_image *of, struct mpm_symmetry_image *image)
{
    const int64_t columns = state->grid.columns;
    const int64_t shift = of->node - mpm_field_parent(state, of->node);
    int64_t place[2] = {of->node % columns, (of->node - shift) / columns};
    if (place[plane->axis] == plane->line)
        return false;
    place[plane->axis] = 2 * plane->line - place[plane->axis];
    if (place[0] < 0 || place[0] >= columns || place[1] < 0 || place[1] >= state->grid.rows)
        return false;
    *image = *of;
    image->node = shift + place[1] * columns + place[0];
    image->sign[plane->axis] = -of->sign[plane->axis];
    return mpm_node_is_reached(state, image->node - shift);
}

int mpm_symmetry_images(const struct mpm_state *state, int64_t node,
                        struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES])
{
    const struct mpm_symmetry_image itself = {node, {1.0, 1.0}};
    int count = 0;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const int before = count;
        for (int of = -1; of < before && count < MPM_SYMMETRY_IMAGES; of++)
            if (find_image(state, &state->symmetries.planes[k], of < 0 ? &itself : &images[of],
                           &images[count]))
                count++;
    }
    return count;
}

int64_t mpm_symmetry_packed_image(const struct mpm_state *state, int64_t field,
                                  const struct mpm_symmetry_image *image)
{
    const struct mpm_additional_field *const packed =
        &state->fields.list[field - mpm_fields_first(state)];
    const struct mpm_field_node *const node = mpm_field_node_at(state, image->node);
    for (int axis = 0; axis < 2; axis++)
        if (image->sign[axis] < 0.0 && (packed->passes >> axis & 1) == 0)
            return -1;
    return node == NULL ? -1 : mpm_field_of(state, node, packed->key);
}

double mpm_symmetry_whole_mass(const struct mpm_state *state, int64_t node)
{
    if (state->symmetries.count == 0)
        return state->grid.mass[node];
    const int64_t columns = state->grid.columns, parent = mpm_field_parent(state, node);
    const int64_t first = mpm_fields_first(state);
    const unsigned free = node < first ? 0u : state->fields.list[node - first].free;
    double mass = state->grid.mass[node];
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        if ((free >> plane->axis & 1u) == 0 &&
            (plane->axis == 0 ? parent % columns : parent / columns) == plane->line)
            mass *= 2.0;
    }
    return mass;
}
