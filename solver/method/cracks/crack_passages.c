/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_passages.h"

#include "method/grid/symmetry.h"

#include <math.h>
#include <string.h>

/* Of an additional field: see the header. */
struct mpm_crack_surface_sums {
    double surface[2], normal[2]; /* the latter weighted with S, from above to below */
};

void mpm_crack_passages_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    const struct mpm_fields *const fields = &state->fields;
    if (mpm_cracks_have_conductance(state->scene))
        state->cracks.surface_sums = MPM_TAKE(arena, struct mpm_crack_surface_sums,
                                              (size_t)fields->keys * fields->node_capacity);
}

/* ------------------------------------------------------------------------ areas */

static void add_particle(struct mpm_state *state, const struct mpm_field_use *use)
{
    const struct mpm_particles *const particles = &state->particles;
    const size_t p = use->particle, place = (size_t)(use - state->fields.uses);
    const int64_t first = mpm_fields_first(state) - state->node_zero;
    uint64_t keys = use->keys;
    double f[MPM_GRADIENT_SIZE];
    mpm_particle_deformation(particles, p, f);
    const double volume = particles->mass[p] * mpm_determinant(f) /
                          state->bodies[particles->body[p]].material.density;
    for (int k = 0; keys != 0; k++, keys >>= 4) {
        const struct mpm_stencil_node *const entry = &use->stencil.node[k];
        const struct mpm_crack_crossing *const crossing = &state->cracks.crossings[place][k];
        double normal[2];
        if ((keys & 15u) == 0)
            continue;
        struct mpm_crack_surface_sums *const sums =
            &state->cracks.surface_sums[entry->node - first];
        mpm_crack_segment_normal(&state->cracks.chains[crossing->crack], crossing->segment, normal);
        sums->surface[0] += volume * (entry->g[0] + entry->t);
        sums->surface[1] += volume * entry->g[1];
        for (int axis = 0; axis < 2; axis++)
            sums->normal[axis] += volume * entry->s * normal[axis];
    }
}

/* In the order of the particles: sums must not depend on threads. */
static void add_strip(struct mpm_state *state, int64_t index)
{
    const struct mpm_span *const spans = mpm_field_spans(state, index);
    for (size_t k = 0; k < state->strips[index].span_count; k++)
        for (size_t p = spans[k].begin; p < spans[k].end; p++) {
            const struct mpm_field_use *const use = mpm_field_use_of(state, p);
            if (use != NULL)
                add_particle(state, use);
        }
}

/* Fields that pass a plane of symmetry have what mirrored particles would add; on the plane what is
 * odd is zero. */
static void fold(struct mpm_state *state, int axis, const struct mpm_field_node *inside,
                 const struct mpm_field_node *beyond, const void *context)
{
    const struct mpm_additional_field *const list = state->fields.list + inside->first;
    struct mpm_crack_surface_sums *const sums = state->cracks.surface_sums;
    (void)context;
    for (uint32_t i = 0; i < inside->count; i++) {
        struct mpm_crack_surface_sums *const own = &sums[inside->first + i];
        const int64_t image = beyond == NULL ? -1 : mpm_field_of(state, beyond, list[i].key);
        if ((list[i].passes >> axis & 1) == 0)
            continue;
        if (beyond == NULL)
            own->surface[axis] = own->normal[axis] = 0.0;
        for (int k = 0; k < 2 && image >= 0; k++) {
            const double sign = k == axis ? -1.0 : 1.0;
            own->surface[k] += sign * sums[image - mpm_fields_first(state)].surface[k];
            own->normal[k] += sign * sums[image - mpm_fields_first(state)].normal[k];
        }
    }
}

static void find_surfaces(struct mpm_state *state)
{
    if (state->cracks.surface_sums == NULL)
        return;
    memset(state->cracks.surface_sums, 0,
           (size_t)state->fields.count * sizeof *state->cracks.surface_sums);
    for (int64_t s = 0; s < state->strip_count; s++)
        add_strip(state, s);
    mpm_symmetries_visit(state, fold, NULL);
}

static double area_of(const struct mpm_state *state, const struct mpm_crack_node *node,
                      enum mpm_crack_side side)
{
    const struct mpm_crack_surface_sums *const sums =
        &state->cracks.surface_sums[node->field[side] - mpm_fields_first(state)];
    const double length = hypot(sums->normal[0], sums->normal[1]);
    const double along = sums->surface[0] * sums->normal[0] + sums->surface[1] * sums->normal[1];
    return length == 0.0 ? 0.0 : fabs(along) / length;
}

/* ---------------------------------------------------------------------- passages */

/* Which of both lets through less? */
static const struct mpm_surface_spec *weaker(const struct mpm_surface_spec *one,
                                             const struct mpm_surface_spec *other)
{
    if (one->law == MPM_SURFACE_INSULATES || other->law == MPM_SURFACE_PERFECT)
        return one;
    if (other->law == MPM_SURFACE_INSULATES || one->law == MPM_SURFACE_PERFECT)
        return other;
    return one->conductance <= other->conductance ? one : other;
}

/* What is between two fields of a node, of which at most one is its own. */
static void list_passage(struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                         const struct mpm_crack_node *node, const enum mpm_crack_side sides[2])
{
    const struct mpm_surface_spec *law = NULL;
    double area = HUGE_VAL;
    for (int k = 0; k < 2; k++) {
        const struct mpm_crack_face *const face = node->face[sides[k]];
        if (face == NULL || face->crack == MPM_NO_CRACK)
            continue;
        const struct mpm_crack_spec *const cracks = state->scene->cracks;
        const struct mpm_surface_spec *const own =
            weaker(&cracks[face->crack].surfaces[scalar->which],
                   &cracks[face->last].surfaces[scalar->which]);
        law = law == NULL ? own : weaker(law, own);
        if (own->law == MPM_SURFACE_CONDUCTANCE)
            area = fmin(area, area_of(state, node, sides[k]));
    }
    if (law == NULL || law->law == MPM_SURFACE_INSULATES)
        return;
    const bool perfect = law->law == MPM_SURFACE_PERFECT;
    mpm_scalar_passage_add(scalar, &(struct mpm_scalar_passage){
                                       .node = node->field[MPM_CRACK_SAME_SIDE],
                                       .fields = {node->field[sides[0]], node->field[sides[1]]},
                                       .perfect = perfect,
                                       .conductance = perfect ? 0.0 : law->conductance * area,
                                   });
}

static void list_node(struct mpm_state *state, struct mpm_nodal_scalar *scalar, size_t place)
{
    static const enum mpm_crack_side order[3] = {MPM_CRACK_ABOVE, MPM_CRACK_SAME_SIDE,
                                                 MPM_CRACK_BELOW};
    const struct mpm_crack_node node = mpm_crack_node_of(state, place);
    enum mpm_crack_side sides[3];
    int count = 0;
    for (int k = 0; k < 3; k++)
        if (node.field[order[k]] >= 0 && state->grid.mass[node.field[order[k]]] != 0.0)
            sides[count++] = order[k];
    for (int k = 0; k + 1 < count; k++)
        list_passage(state, scalar, &node, &sides[k]);
}

void mpm_crack_passages_list(struct mpm_state *state)
{
    if (state->cracks.point_count == 0 || state->transport.count == 0)
        return;
    find_surfaces(state);
    for (size_t s = 0; s < state->transport.count; s++) {
        struct mpm_nodal_scalar *const scalar = &state->transport.list[s];
        scalar->passage_count = 0;
        for (size_t k = 0; k < state->fields.nodes_inside; k++)
            list_node(state, scalar, k);
    }
}
