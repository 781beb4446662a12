/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_detection.h"

#include "base/segment.h"
#include "base/strips.h"
#include "method/contact/contact_detection.h"
#include "method/cracks/crack_map.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"

#include <math.h>

/* ---------------------------------------------------------------- measuring */

bool mpm_crack_detection_needs_surfaces(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (mpm_crack_has_contact(scene, k) && scene->cracks[k].detection != MPM_DETECT_CELL)
            return true;
    return false;
}

/* What a particle adds to the sums of its nodes. */
struct contribution {
    size_t particle;
    double place[2];
    double area;      /* A_p = 4 l_1 l_2 (F_xx F_yy - F_xy F_yx): CRAMP (9) at finite strain */
    double per_hoop;  /* A_p / sum_i T_ip in axisymmetry, since sum_i N_i is 1; else 0 */
    uint32_t segment; /* of a crack, to which `normal` belongs, or UINT32_MAX */
    uint32_t split;   /* that crack */
    double normal[2];
    uint32_t crack;    /* that `surface` is along, or MPM_NO_CRACK */
    double surface[2]; /* x_p + F_p w_p */
};

static struct contribution contribution_of(const struct mpm_state *state, size_t p,
                                           const struct mpm_stencil *stencil)
{
    const struct mpm_particles *const particles = &state->particles;
    const double *const half = state->bodies[particles->body[p]].half_size;
    double *const *const f = particles->deformation;
    struct contribution made = {
        .particle = p,
        .place = {particles->position[0][p], particles->position[1][p]},
        .area =
            4.0 * half[0] * half[1] * (f[MPM_XX][p] * f[MPM_YY][p] - f[MPM_XY][p] * f[MPM_YX][p]),
        .segment = UINT32_MAX,
        .crack = MPM_NO_CRACK,
    };
    double hoop = 0.0;
    for (int k = 0; state->shape_grid.axisymmetric && k < stencil->count; k++)
        hoop += stencil->node[k].t;
    made.per_hoop = hoop > 0.0 ? made.area / hoop : 0.0;
    return made;
}

/* From a place at t = 0 to the nearest point of a crack in the undeformed body. */
static void find_way(const struct mpm_crack_chain *chain, const double place[2], double way[2])
{
    double least = HUGE_VAL;
    for (size_t i = 0; i + 1 < chain->count; i++) {
        const struct mpm_segment segment = {{chain->x[i], chain->y[i]},
                                            {chain->x[i + 1], chain->y[i + 1]}};
        double other[2];
        mpm_segment_find_way(&segment, place, other);
        const double square = other[0] * other[0] + other[1] * other[1];
        if (square >= least)
            continue;
        least = square;
        way[0] = other[0];
        way[1] = other[1];
    }
}

/* The particle's surface along a crack: at the next node it is mostly along the same one. */
static void find_surface(const struct mpm_state *state, uint32_t crack, struct contribution *made)
{
    const struct mpm_particles *const particles = &state->particles;
    double *const *const f = particles->deformation;
    const size_t p = made->particle;
    double way[2] = {0.0, 0.0};
    if (made->crack == crack)
        return;
    find_way(&state->cracks.undeformed[crack],
             (const double[2]){particles->origin[0][p], particles->origin[1][p]}, way);
    made->crack = crack;
    made->surface[0] = made->place[0] + f[MPM_XX][p] * way[0] + f[MPM_XY][p] * way[1];
    made->surface[1] = made->place[1] + f[MPM_YX][p] * way[0] + f[MPM_YY][p] * way[1];
}

static void add_surface(const struct mpm_state *state, uint32_t crack, double weight,
                        const double place[2], struct contribution *made, double sum[2])
{
    if (crack == MPM_NO_CRACK || state->cracks.undeformed == NULL)
        return;
    find_surface(state, crack, made);
    for (int axis = 0; axis < 2; axis++)
        sum[axis] += weight * (made->surface[axis] - place[axis]);
}

/* To the sums of one field. */
static void add_sums(const struct mpm_stencil_node *entry, const struct contribution *made,
                     struct mpm_crack_sums *sums)
{
    const double weight = made->area * entry->s;
    sums->area += weight;
    sums->seen += made->per_hoop > 0.0 ? made->per_hoop * entry->t : weight;
    for (int axis = 0; axis < 2; axis++)
        sums->gradient[axis] += made->area * entry->g[axis];
}

/* To the sums of the node's own field, by a particle that is in it. */
static void add_to_own(const struct mpm_state *state, const struct mpm_stencil_node *entry,
                       const struct mpm_field_node *node, struct contribution *made)
{
    struct mpm_crack_field *const others = state->cracks.fields + node->first;
    add_sums(entry, made, &state->cracks.sums[node - state->fields.nodes]);
    for (int i = 0; i < node->count; i++)
        add_surface(state, others[i].face.crack, made->area * entry->s, node->position, made,
                    others[i].face.own);
}

/* A particle's lines mostly cross one segment. */
static const double *normal_of(const struct mpm_state *state,
                               const struct mpm_crack_crossing *crossing, struct contribution *made)
{
    if (made->segment != crossing->segment || made->split != crossing->crack)
        mpm_crack_segment_normal(&state->cracks.chains[crossing->crack], crossing->segment,
                                 made->normal);
    made->segment = crossing->segment;
    made->split = crossing->crack;
    return made->normal;
}

/* To those of an additional field. */
static void add_to_additional(const struct mpm_state *state, const struct mpm_stencil_node *entry,
                              int64_t field, const struct mpm_crack_crossing *crossing,
                              struct contribution *made)
{
    struct mpm_crack_field *const additional = &state->cracks.fields[field];
    const double *const place = state->fields.nodes[state->fields.list[field].node].position;
    const double *const normal = normal_of(state, crossing, made);
    add_sums(entry, made, &additional->sums);
    add_surface(state, additional->face.crack, made->area * entry->s, place, made,
                additional->face.beyond);
    for (int axis = 0; axis < 2; axis++)
        additional->face.normal[axis] += normal[axis];
}

/* Has one of the particle's nodes additional fields? */
static bool reaches_fields(const struct mpm_state *state, const struct mpm_cell_block *block)
{
    for (int64_t row = block->low[1]; row <= block->high[1] + 1; row++)
        for (int64_t column = block->low[0]; column <= block->high[0] + 1; column++)
            if (state->fields.node_of[row * state->grid.columns + column] != 0)
                return true;
    return false;
}

static void measure(void *context, size_t p, const struct mpm_cell_block *block)
{
    const struct mpm_state *const state = context;
    const struct mpm_field_use *const use = mpm_field_use_of(state, p);
    const int64_t first = mpm_fields_first(state);
    struct mpm_stencil room;
    if (!mpm_cracks_cut(state, p) || (use == NULL && !reaches_fields(state, block)))
        return;
    const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
    const struct mpm_crack_crossing *const crossing =
        use == NULL ? NULL : state->cracks.crossings[use - state->fields.uses];
    struct contribution made = contribution_of(state, p, stencil);
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        const int64_t node = state->node_zero + entry->node;
        if (crossing != NULL && node >= first)
            add_to_additional(state, entry, node - first, &crossing[k], &made);
        else if (state->fields.node_of[node] != 0)
            add_to_own(state, entry, mpm_field_node_at(state, node), &made);
    }
}

/* Strips of one colour have no node in common. */
static void measure_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    (void)worker;
    mpm_nearby_visit(state, index, &state->fields.beside, measure, context);
}

/* What mirrored particles would add at a node inside; nothing along the normal on the plane. */
static void fold_vector(double inside[2], const double beyond[2], int axis)
{
    for (int k = 0; k < 2; k++)
        inside[k] += k == axis ? -beyond[k] : beyond[k];
}

static void fold_sums(struct mpm_crack_sums *inside, const struct mpm_crack_sums *beyond, int axis)
{
    inside->area += beyond->area;
    inside->seen += beyond->seen;
    fold_vector(inside->gradient, beyond->gradient, axis);
}

static void fold_face(struct mpm_crack_face *inside, const struct mpm_crack_face *beyond, int axis)
{
    fold_vector(inside->normal, beyond->normal, axis);
    fold_vector(inside->beyond, beyond->beyond, axis);
    fold_vector(inside->own, beyond->own, axis);
}

static void fold_field(struct mpm_state *state, int axis, size_t field, int64_t image)
{
    struct mpm_crack_field *const fields = state->cracks.fields;
    struct mpm_crack_face *const face = &fields[field].face;
    if (image >= 0) {
        fold_sums(&fields[field].sums, &fields[image].sums, axis);
        fold_face(face, &fields[image].face, axis);
    } else {
        fields[field].sums.gradient[axis] = 0.0;
        face->normal[axis] = face->beyond[axis] = face->own[axis] = 0.0;
    }
}

/* Contact is resolved at nodes inside and on planes: these get the sums of the whole. */
static void fold_node(struct mpm_state *state, int axis, const struct mpm_field_node *inside,
                      const struct mpm_field_node *beyond, const void *context)
{
    struct mpm_crack_sums *const own = &state->cracks.sums[inside - state->fields.nodes];
    const struct mpm_crack_sums nothing = {0.0, 0.0, {0.0, 0.0}};
    bool passes = false;
    (void)context;
    for (size_t i = inside->first; i < (size_t)inside->first + inside->count; i++) {
        const struct mpm_additional_field *const field = &state->fields.list[i];
        if ((field->passes >> axis & 1) == 0)
            continue;
        passes = true;
        fold_field(state, axis, i,
                   beyond == NULL
                       ? -1
                       : mpm_field_of(state, beyond, field->key) - mpm_fields_first(state));
    }
    if (!passes)
        return;
    fold_sums(own, beyond == NULL ? &nothing : &state->cracks.sums[beyond - state->fields.nodes],
              axis);
    if (beyond == NULL)
        own->gradient[axis] = 0.0;
}

void mpm_crack_detection_measure(struct mpm_state *state, int workers)
{
    if (state->fields.node_count == 0 || !mpm_cracks_have_contact(state->scene))
        return;
    mpm_strips_run(state->strip_count, workers, measure_strip, state);
    mpm_symmetries_visit(state, fold_node, NULL);
}

/* ------------------------------------------------------------------ deciding */

bool mpm_crack_pair_find(const struct mpm_crack_node *node, enum mpm_crack_side above,
                         enum mpm_crack_side below, struct mpm_crack_pair *pair)
{
    const struct mpm_crack_face *const upper = node->face[above], *const lower = node->face[below];
    const bool first = above != MPM_CRACK_SAME_SIDE, second = below != MPM_CRACK_SAME_SIDE;
    double normal[2], length = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        normal[axis] = (first ? upper->normal[axis] : 0.0) + (second ? lower->normal[axis] : 0.0);
        length += normal[axis] * normal[axis];
    }
    length = sqrt(length);
    if (!(length > 0.0))
        return false;
    *pair = (struct mpm_crack_pair){
        .side = {above, below},
        .crack = first && (!second || upper->crack < lower->crack) ? upper->crack : lower->crack,
        .normal = {normal[0] / length, normal[1] / length},
        .surface = {first ? upper->beyond : lower->own, second ? lower->beyond : upper->own},
    };
    return true;
}

/* Of the surface of the field below beyond that of the field above, along the normal. */
static double gap_of(const struct mpm_crack_node *node, const struct mpm_crack_pair *pair)
{
    const double above = node->sums[pair->side[0]]->area, below = node->sums[pair->side[1]]->area;
    double gap = 0.0;
    for (int axis = 0; axis < 2; axis++)
        gap +=
            pair->normal[axis] * (pair->surface[1][axis] / below - pair->surface[0][axis] / above);
    return gap;
}

struct mpm_crack_volume mpm_crack_volume_at(const struct mpm_state *state,
                                            const struct mpm_crack_node *node,
                                            const struct mpm_crack_pair *pair)
{
    const struct mpm_crack_sums *const above = node->sums[pair->side[0]];
    const struct mpm_crack_sums *const below = node->sums[pair->side[1]];
    const double *const cell = state->grid.cell, *const normal = pair->normal;
    const double area = above->area + below->area;
    const enum mpm_crack_detection detection = state->scene->cracks[pair->crack].detection;
    if (detection == MPM_DETECT_CELL)
        return (struct mpm_crack_volume){above->seen + below->seen,
                                         cell[0] * mpm_node_seen_length(state, node->field[0], 0) *
                                             cell[1] *
                                             mpm_node_seen_length(state, node->field[0], 1)};
    const double gap = gap_of(node, pair);
    if (detection == MPM_DETECT_DISPLACEMENT) {
        const double along[2] = {cell[0] * normal[0], cell[1] * normal[1]};
        const double size = sqrt(along[0] * along[0] + along[1] * along[1]);
        return (struct mpm_crack_volume){size - gap, size};
    }
    double gain = 0.0;
    for (int axis = 0; axis < 2; axis++)
        gain += 0.5 * gap * normal[axis] * (above->gradient[axis] - below->gradient[axis]);
    /* what a node sees of a body's far side it would lose: that is no part of the gap */
    gain = gap > 0.0 ? fmax(gain, 0.0) : fmin(gain, 0.0);
    return (struct mpm_crack_volume){area, area + gain};
}
