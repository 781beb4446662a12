/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_sums.h"

#include "base/strips.h"
#include "method/contact/displacement_fit.h"
#include "method/grid/conditions.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"

#include <math.h>

/* ------------------------------------------------------------------ summing */

/* From the node to the particle. */
static void place_from(const struct mpm_state *state, int64_t node, const double place[2],
                       double from[2])
{
    double at[2];
    mpm_grid_position(&state->grid, node, at);
    for (int axis = 0; axis < 2; axis++)
        from[axis] = place[axis] - at[axis];
}

static void add_moments(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                        const double from[2], double moments[6])
{
    const double *const scale = state->grid.inverse_cell;
    const double weight = particle->area * scale[0] * scale[1];
    const double x = from[0] * scale[0], y = from[1] * scale[1];
    const double terms[6] = {1.0, x, y, x * x, x * y, y * y};
    for (int k = 0; k < 6; k++)
        moments[k] += weight * terms[k];
}

/* `per_hoop`: the area over sum T in axisymmetry, else 0. */
static void add_sums(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                     double per_hoop, const struct mpm_stencil_node *entry,
                     const struct mpm_contact_node *node)
{
    struct mpm_contact_field *const field = mpm_contact_field_at(
        state, node, particle->field, mpm_contact_key_at(state, particle, node->node));
    double from[2];
    if (field == NULL || entry->s == 0.0)
        return;
    struct mpm_contact_sums *const sums = &field->sums;
    const double weight = particle->area * entry->s;
    place_from(state, node->node, particle->place, from);
    sums->area += weight;
    sums->volume += particle->volume * entry->s;
    sums->seen += per_hoop > 0.0 ? per_hoop * entry->t : weight;
    for (int axis = 0; axis < 2; axis++) {
        sums->area_normal[axis] += particle->area * entry->g[axis];
        sums->volume_normal[axis] += particle->volume * entry->g[axis];
        sums->surface[axis] += particle->volume * (entry->g[axis] + (axis == 0 ? entry->t : 0.0));
    }
    if (state->contact.sums_moments)
        add_moments(state, particle, from, sums->moments);
    if (state->contact.sums_displacement)
        mpm_displacement_add(&sums->displacement, &(struct mpm_displacement_sample){
                                                      weight, from, particle->displacement,
                                                      particle->slope, particle->velocity});
}

static void add_particle(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                         const struct mpm_stencil *stencil, int64_t shift)
{
    double hoop = 0.0;
    for (int k = 0; k < stencil->count; k++)
        hoop += stencil->node[k].t;
    const double per_hoop = hoop > 0.0 ? particle->area / hoop : 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node - shift;
        const struct mpm_contact_node *const listed = mpm_contact_node_at(state, node);
        if (listed != NULL)
            add_sums(state, particle, per_hoop, &stencil->node[k], listed);
    }
}

static void sum_particle(void *context, size_t p, const struct mpm_cell_block *block)
{
    const struct mpm_state *const state = context;
    const size_t field = state->contact.field_of[state->particles.body[p]];
    struct mpm_stencil stencil;
    if (field == MPM_CONTACT_FIELDS || !mpm_contact_reaches(state, block))
        return;
    const struct mpm_contact_particle particle = mpm_contact_particle_of(state, p);
    mpm_particle_plain_stencil(state, p, &stencil);
    add_particle(state, &particle, &stencil, state->contact.shift[field]);
}

static void sum_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    mpm_nearby_visit(state, index, &state->contact.beside, sum_particle, context);
}

static void sum_rigid(struct mpm_state *state)
{
    for (size_t p = 0; state->contact.rigid_at != NULL && p < state->rigid.count; p++) {
        struct mpm_stencil stencil;
        if (state->contact.field_of[state->rigid.body[p]] == MPM_CONTACT_FIELDS)
            continue;
        mpm_rigid_particle_stencil(state, p, &stencil);
        const struct mpm_contact_particle particle = mpm_contact_rigid_particle(state, p);
        add_particle(state, &particle, &stencil, 0);
    }
}

/* ------------------------------------------------------- planes of symmetry */

bool mpm_contact_is_on_plane(const struct mpm_state *state, int64_t node, int axis)
{
    const int64_t columns = state->grid.columns;
    const int64_t place = axis == 0 ? node % columns : node / columns;
    double at[2];
    for (size_t k = 0; k < state->symmetries.count; k++)
        if (state->symmetries.planes[k].axis == axis && state->symmetries.planes[k].line == place)
            return true;
    if (axis != 0 || !state->shape_grid.axisymmetric)
        return false;
    mpm_grid_position(&state->grid, node, at);
    return fabs(at[0]) < 1e-9 * state->grid.cell[0];
}

static void clear_odd(struct mpm_contact_sums *sums, int axis)
{
    sums->area_normal[axis] = sums->volume_normal[axis] = sums->surface[axis] = 0.0;
    mpm_displacement_put_on_plane(&sums->displacement, axis);
    sums->moments[1 + axis] = sums->moments[4] = 0.0;
}

static void fold_vector(double inside[2], const double beyond[2], int axis)
{
    for (int k = 0; k < 2; k++)
        inside[k] += k == axis ? -beyond[k] : beyond[k];
}

static void fold_sums(struct mpm_contact_sums *inside, const struct mpm_contact_sums *beyond,
                      int axis)
{
    inside->area += beyond->area;
    inside->volume += beyond->volume;
    inside->seen += beyond->seen;
    fold_vector(inside->area_normal, beyond->area_normal, axis);
    fold_vector(inside->volume_normal, beyond->volume_normal, axis);
    fold_vector(inside->surface, beyond->surface, axis);
    mpm_displacement_fold(&inside->displacement, &beyond->displacement, axis);
    for (int k = 0; k < 6; k++)
        inside->moments[k] += k == 1 + axis || k == 4 ? -beyond->moments[k] : beyond->moments[k];
}

/* The entry that a node beyond a plane is an image of, or NULL. */
static struct mpm_contact_node *original_of(const struct mpm_state *state,
                                            const struct mpm_symmetry *plane, int64_t node)
{
    const int64_t columns = state->grid.columns;
    const int64_t place = plane->axis == 0 ? node % columns : node / columns;
    const int64_t depth = (plane->line - place) * plane->inside;
    const int64_t stride = plane->axis == 0 ? 1 : columns;
    return depth <= 0 ? NULL
                      : mpm_contact_node_at(state, node + 2 * depth * plane->inside * stride);
}

static void fold_node(struct mpm_state *state, int axis, struct mpm_contact_node *inside,
                      const struct mpm_contact_node *beyond)
{
    for (uint32_t k = beyond->first_field; k < beyond->first_field + beyond->fields; k++) {
        const struct mpm_contact_field *const image = &state->contact.fields[k];
        struct mpm_contact_field *const field =
            mpm_contact_field_at(state, inside, image->field, image->key);
        if (field != NULL)
            fold_sums(&field->sums, &image->sums, axis);
    }
}

void mpm_contact_images_visit(struct mpm_state *state, mpm_contact_image_visit *visit)
{
    for (size_t i = 0; i < state->symmetries.count; i++)
        for (size_t k = 0; k < state->contact.node_count; k++) {
            const struct mpm_symmetry *const plane = &state->symmetries.planes[i];
            const struct mpm_contact_node *const node = &state->contact.nodes[k];
            struct mpm_contact_node *const inside = original_of(state, plane, node->node);
            if (inside != NULL)
                visit(state, plane->axis, inside, node);
        }
}

static void fold_all(struct mpm_state *state)
{
    mpm_contact_images_visit(state, fold_node);
    for (size_t k = 0; k < state->contact.node_count; k++)
        for (int axis = 0; axis < 2; axis++) {
            const struct mpm_contact_node *const node = &state->contact.nodes[k];
            if (!mpm_contact_is_on_plane(state, node->node, axis))
                continue;
            for (uint32_t i = node->first_field; i < node->first_field + node->fields; i++)
                clear_odd(&state->contact.fields[i].sums, axis);
        }
}

static void add_to_whole(const struct mpm_contact_sums *part, struct mpm_contact_sums *whole)
{
    whole->area += part->area;
    whole->volume += part->volume;
    whole->seen += part->seen;
    for (int axis = 0; axis < 2; axis++) {
        whole->area_normal[axis] += part->area_normal[axis];
        whole->volume_normal[axis] += part->volume_normal[axis];
    }
    for (int k = 0; k < 6; k++)
        whole->moments[k] += part->moments[k];
}

const struct mpm_contact_sums *mpm_contact_whole_sums(const struct mpm_state *state,
                                                      const struct mpm_contact_node *node,
                                                      uint32_t place, struct mpm_contact_sums *room)
{
    const struct mpm_contact_field *const field = &state->contact.fields[place];
    bool parts = false;
    if (field->field != mpm_contact_spec(state)->cracked_field)
        return &field->sums;
    *room = field->sums;
    for (uint32_t k = node->first_field; k < node->first_field + node->fields; k++) {
        if (k == place || state->contact.fields[k].field != field->field)
            continue;
        add_to_whole(&state->contact.fields[k].sums, room);
        parts = true;
    }
    return parts ? room : &field->sums;
}

void mpm_contact_sums_find(struct mpm_state *state, int workers)
{
    if (state->contact.node_count == 0)
        return;
    mpm_strips_run(state->strip_count, workers, sum_strip, state);
    sum_rigid(state);
    fold_all(state);
}

/* -------------------------------------------------------------------- edges */

/* The least n . x + MPM_EDGE_SLOPE |t . x| of a particle's domain, t across n, from the node: at
 * one of its corners, or where one of its sides crosses the line through the node along n. */
static double nearest(const struct mpm_contact_particle *particle, const double from[2],
                      const double n[2], double *least_beside)
{
    static const double corners[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    const double *const e = particle->edge;
    double away[4], beside[4], least = HUGE_VAL;
    for (int k = 0; k < 4; k++) {
        const double x = from[0] + corners[k][0] * e[0] + corners[k][1] * e[2];
        const double y = from[1] + corners[k][0] * e[1] + corners[k][1] * e[3];
        away[k] = n[0] * x + n[1] * y;
        beside[k] = n[0] * y - n[1] * x;
        least = fmin(least, away[k] + MPM_EDGE_SLOPE * fabs(beside[k]));
        *least_beside = fmin(*least_beside, fabs(beside[k]));
    }
    for (int k = 0; k < 4; k++) {
        const int next = (k + 1) % 4;
        if (!(beside[k] * beside[next] < 0.0))
            continue;
        *least_beside = 0.0;
        const double part = beside[k] / (beside[k] - beside[next]);
        least = fmin(least, away[k] + part * (away[next] - away[k]));
    }
    return least;
}

static void add_edge(const struct mpm_contact_particle *particle, const double from[2], int side,
                     struct mpm_contact_pair *pair)
{
    const double *const n = pair->normal;
    if (side == 0)
        pair->edge[0] =
            fmax(pair->edge[0],
                 -nearest(particle, from, (const double[2]){-n[0], -n[1]}, &pair->beside[0]));
    else
        pair->edge[1] = fmin(pair->edge[1], nearest(particle, from, n, &pair->beside[1]));
}

static bool is_in(const struct mpm_contact_field *field,
                  const struct mpm_contact_particle *particle, int key)
{
    return field->field == particle->field && field->key == key;
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

static void add_edges(struct mpm_state *state, const struct mpm_contact_particle *particle,
                      struct mpm_contact_node *node)
{
    const int key = mpm_contact_key_at(state, particle, node->node);
    double from[2];
    place_from(state, node->node, particle->place, from);
    if (node->cut)
        widen(particle, from, mpm_contact_field_at(state, node, particle->field, key));
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++) {
        struct mpm_contact_pair *const pair = &state->contact.pairs[k];
        for (int side = 0; side < 2 && pair->has_normal; side++)
            if (is_in(&state->contact.fields[pair->fields[side]], particle, key))
                add_edge(particle, from, side, pair);
    }
}

bool mpm_contact_is_image(const struct mpm_state *state, const struct mpm_contact_pair *one,
                          const struct mpm_contact_pair *other)
{
    const struct mpm_contact_field *const list = state->contact.fields;
    return one->spec == other->spec && list[one->fields[0]].key == list[other->fields[0]].key &&
           list[one->fields[1]].key == list[other->fields[1]].key;
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
    mpm_shared_nodes_visit(state, workers, add_edges);
    mpm_contact_images_visit(state, fold_edges);
    for (size_t k = 0; k < state->contact.pair_count; k++)
        count_from_nearest(&state->contact.pairs[k]);
}
