/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_sums.h"

#include "base/strips.h"
#include "method/contact/contact_particles.h"
#include "method/contact/displacement_fit.h"
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

static void add_moments_and_displacement(const struct mpm_state *state,
                                         const struct mpm_contact_particle *particle, double weight,
                                         int64_t node, struct mpm_contact_sums *sums)
{
    double from[2];
    place_from(state, node, particle->place, from);
    if (state->contact.sums_moments)
        add_moments(state, particle, from, sums->moments);
    if (state->contact.sums_displacement)
        mpm_displacement_add(&sums->displacement, &(struct mpm_displacement_sample){
                                                      weight, from, particle->displacement,
                                                      particle->slope, particle->velocity});
}

static void add_volume(const struct mpm_contact_particle *particle, double seen,
                       const struct mpm_stencil_node *entry, struct mpm_contact_sums *sums)
{
    sums->volume += particle->volume * entry->s;
    sums->seen += seen;
    for (int axis = 0; axis < 2; axis++)
        sums->volume_normal[axis] += particle->volume * entry->g[axis];
}

/* `per_hoop`: the area over sum T in axisymmetry, else 0. */
static void add_sums(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                     double per_hoop, const struct mpm_stencil_node *entry,
                     const struct mpm_contact_node *node)
{
    struct mpm_contact_field *const field = mpm_contact_field_at(
        state, node, particle->field, mpm_contact_key_at(state, particle, node->node));
    if (field == NULL || entry->s == 0.0)
        return;
    struct mpm_contact_sums *const sums = &field->sums;
    const double weight = particle->area * entry->s;
    sums->area += weight;
    for (int axis = 0; axis < 2; axis++) {
        sums->area_normal[axis] += particle->area * entry->g[axis];
        sums->surface[axis] += particle->volume * (entry->g[axis] + (axis == 0 ? entry->t : 0.0));
    }
    if (state->contact.sums_volume)
        add_volume(particle, per_hoop > 0.0 ? per_hoop * entry->t : weight, entry, sums);
    if (state->contact.sums_moments || state->contact.sums_displacement)
        add_moments_and_displacement(state, particle, weight, node->node, sums);
}

static void add_particle(const struct mpm_state *state, const struct mpm_contact_particle *particle,
                         const struct mpm_stencil *stencil)
{
    double hoop = 0.0;
    for (int k = 0; k < stencil->count && state->shape_grid.axisymmetric; k++)
        hoop += stencil->node[k].t;
    const double per_hoop = hoop > 0.0 ? particle->area / hoop : 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        const struct mpm_contact_node *const listed = mpm_contact_node_at(state, node);
        if (listed != NULL)
            add_sums(state, particle, per_hoop, &stencil->node[k], listed);
    }
}

static void sum_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_contact_near *const near = mpm_contact_near_of(state, index);
    (void)worker;
    for (size_t k = 0; k < state->contact.near_count[index]; k++) {
        const size_t p = near[k].particle;
        struct mpm_contact_particle particle;
        struct mpm_stencil stencil;
        mpm_contact_particle_begin(state, p, &particle);
        mpm_contact_particle_weigh(state, p, &particle);
        mpm_particle_grid_stencil(state, p, &stencil);
        add_particle(state, &particle, &stencil);
    }
}

static void sum_rigid(struct mpm_state *state, const struct mpm_contact_particle *particle,
                      const struct mpm_stencil *stencil)
{
    add_particle(state, particle, stencil);
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

bool mpm_contact_is_image(const struct mpm_state *state, const struct mpm_contact_pair *one,
                          const struct mpm_contact_pair *other)
{
    const struct mpm_contact_field *const list = state->contact.fields;
    return one->spec == other->spec && list[one->fields[0]].key == list[other->fields[0]].key &&
           list[one->fields[1]].key == list[other->fields[1]].key;
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
    mpm_contact_rigid_run(state, sum_rigid);
    fold_all(state);
}
