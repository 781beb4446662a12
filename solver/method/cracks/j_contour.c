/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/j_contour.h"

#include "base/orientation.h"

#include <math.h>

void mpm_j_tip_place(const struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                     double place[2])
{
    const struct mpm_crack_chain *const chain = &state->cracks.chains[spec->crack];
    const size_t point = spec->at_start ? 0 : chain->count - 1;
    place[0] = chain->x[point];
    place[1] = chain->y[point];
}

enum mpm_crack_side mpm_j_side(const struct mpm_j_contour *contour, const double from[2],
                               const double to[2], size_t *crack)
{
    for (size_t k = 0; k < contour->state->scene->crack_count; k++) {
        const struct mpm_crack_part *const part = &contour->parts[k];
        if (part->first == part->end)
            continue;
        const enum mpm_crack_side side =
            mpm_crack_part_side(&contour->state->cracks.chains[k], part, from, to, NULL);
        if (side == MPM_CRACK_SAME_SIDE)
            continue;
        if (crack != NULL)
            *crack = k;
        return side;
    }
    return MPM_CRACK_SAME_SIDE;
}

/* ----------------------------------------------------------------- one point */

/* What a field has at a point of the contour. */
struct sample {
    double x; /* the first coordinate: a radius */
    double stress[3], gradient[MPM_GRADIENT_SIZE], energy;
};

static struct sample mean_of(const struct mpm_j_sums *sums, double x)
{
    struct sample mean = {.x = x, .energy = sums->energy / sums->area};
    for (int k = 0; k < 3; k++)
        mean.stress[k] = sums->stress[k] / sums->area;
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        mean.gradient[k] = sums->gradient[k] / sums->area;
    return mean;
}

static double between(double a, double b, double part)
{
    return a + part * (b - a);
}

static struct sample sample_between(const struct sample *a, const struct sample *b, double part)
{
    struct sample made = {.x = between(a->x, b->x, part),
                          .energy = between(a->energy, b->energy, part)};
    for (int k = 0; k < 3; k++)
        made.stress[k] = between(a->stress[k], b->stress[k], part);
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        made.gradient[k] = between(a->gradient[k], b->gradient[k], part);
    return made;
}

/* Bergkvist and Huong: R/a; else 1. */
static double weight_of(const struct mpm_j_contour *contour, const struct sample *at)
{
    if (contour->spec->form != MPM_J_BERGKVIST_HUONG)
        return 1.0;
    return at->x / (1.0 + at->gradient[MPM_ZZ]) / contour->tip->place[0];
}

/* Adds length * weight [ e F_mk n_m - s_im n_m (F - C)_ik ]; the normal is `sign` along an axis. */
static void add_point(const struct mpm_j_contour *contour, const struct sample *at, int axis,
                      double sign, double length, double j[2])
{
    const double *const g = at->gradient, *const common = contour->common;
    const double traction[2] = {axis == 0 ? at->stress[0] : at->stress[2],
                                axis == 0 ? at->stress[2] : at->stress[1]};
    const double across[2] = {g[2 * axis] + (axis == 0 ? 1.0 : 0.0),
                              g[2 * axis + 1] + (axis == 1 ? 1.0 : 0.0)}; /* F_mk n_m */
    const double factor = sign * length * weight_of(contour, at);
    for (int k = 0; k < 2; k++)
        j[k] += factor * (at->energy * across[k] - (traction[0] * (g[k] - common[k]) +
                                                    traction[1] * (g[2 + k] - common[2 + k])));
}

/* ------------------------------------------------------------------ segments */

/* From one node of the contour to the next. */
struct segment {
    int64_t from[2], to[2];
    int axis; /* of the outward normal */
    double sign, length;
};

static enum mpm_status find_sample(const struct mpm_j_contour *contour, const int64_t at[2],
                                   enum mpm_crack_side side, struct sample *made,
                                   struct mpm_error *error)
{
    const struct mpm_j_sums *const sums = &mpm_j_node_at(contour, at)->side[side];
    double place[2];
    mpm_j_place(contour, at, place);
    if (!(sums->area > 0.0))
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "%s: the contour's node at (%g, %g) has no particles on one side of "
                             "the crack; allowed: a contour inside the bodies",
                             contour->spec->key, place[0], place[1]);
    *made = mean_of(sums, place[0]);
    return MPM_OK;
}

/* How far along the way from one node to the next the crack crosses it. */
static double crossing_part(const struct mpm_j_contour *contour, const double from[2],
                            const double to[2])
{
    const struct mpm_crack_chain *const chain =
        &contour->state->cracks.chains[contour->spec->crack];
    const struct mpm_crack_part *const part = &contour->parts[contour->spec->crack];
    for (size_t k = part->first; k < part->end; k++) {
        const double first[2] = {chain->x[k], chain->y[k]};
        const double last[2] = {chain->x[k + 1], chain->y[k + 1]};
        const double a = mpm_orientation(first, last, from), b = mpm_orientation(first, last, to);
        const double c = mpm_orientation(from, to, first), d = mpm_orientation(from, to, last);
        if ((a > 0.0) != (b > 0.0) && (c >= 0.0) != (d >= 0.0))
            return a / (a - b);
    }
    return 0.5;
}

/* Beside the crack, at that part of the way from a node to the next one, which is behind it. Where
 * the crack runs close by the near node, no particle of its side may reach the far one: then as at
 * the near node. */
static struct sample sample_beside(const struct mpm_j_contour *contour, const struct sample *near,
                                   const int64_t far[2], enum mpm_crack_side side, double part)
{
    const struct mpm_j_sums *const sums = &mpm_j_node_at(contour, far)->side[side];
    double place[2];
    if (!(sums->area > 0.0))
        return *near;
    mpm_j_place(contour, far, place);
    const struct sample behind = mean_of(sums, place[0]);
    return sample_between(near, &behind, part);
}

/* The crack passes between both nodes: each side is integrated up to it. */
static enum mpm_status add_cut(const struct mpm_j_contour *contour, const struct segment *segment,
                               enum mpm_crack_side of_to, enum mpm_crack_side of_from, double j[2],
                               struct mpm_error *error)
{
    struct sample from = {.x = 0.0}, to = {.x = 0.0};
    double a[2], b[2];
    mpm_j_place(contour, segment->from, a);
    mpm_j_place(contour, segment->to, b);
    MPM_TRY(find_sample(contour, segment->from, MPM_CRACK_SAME_SIDE, &from, error));
    MPM_TRY(find_sample(contour, segment->to, MPM_CRACK_SAME_SIDE, &to, error));
    const double part = crossing_part(contour, a, b);
    const struct sample before = sample_beside(contour, &from, segment->to, of_to, part);
    const struct sample after = sample_beside(contour, &to, segment->from, of_from, 1.0 - part);
    const double first = 0.5 * segment->length * part, second = 0.5 * segment->length - first;
    add_point(contour, &from, segment->axis, segment->sign, first, j);
    add_point(contour, &before, segment->axis, segment->sign, first, j);
    add_point(contour, &after, segment->axis, segment->sign, second, j);
    add_point(contour, &to, segment->axis, segment->sign, second, j);
    return MPM_OK;
}

/* No crack between both; each has the field of the other one's side, where it lies on a crack. */
static enum mpm_status add_plain(const struct mpm_j_contour *contour, const struct segment *segment,
                                 enum mpm_crack_side of_to, enum mpm_crack_side of_from,
                                 double j[2], struct mpm_error *error)
{
    struct sample from = {.x = 0.0}, to = {.x = 0.0};
    MPM_TRY(find_sample(contour, segment->from, of_from, &from, error));
    MPM_TRY(find_sample(contour, segment->to, of_to, &to, error));
    add_point(contour, &from, segment->axis, segment->sign, 0.5 * segment->length, j);
    add_point(contour, &to, segment->axis, segment->sign, 0.5 * segment->length, j);
    return MPM_OK;
}

static enum mpm_status check_crack(const struct mpm_j_contour *contour, size_t crack,
                                   const int64_t at[2], size_t *met, struct mpm_error *error)
{
    double place[2];
    if (crack == contour->spec->crack)
        return MPM_OK;
    *met = crack;
    mpm_j_place(contour, at, place);
    return mpm_error_set(error, MPM_RUN_FAILED,
                         "%s: the contour meets cracks.%zu near (%g, %g); allowed: its own crack "
                         "alone",
                         contour->spec->key, crack, place[0], place[1]);
}

/* `halves`: by half for each of the two segments that meet on a crack. */
static enum mpm_status add_segment(const struct mpm_j_contour *contour,
                                   const struct segment *segment, int *halves, double j[2],
                                   size_t *met, struct mpm_error *error)
{
    double a[2], b[2];
    size_t crack = contour->spec->crack;
    mpm_j_place(contour, segment->from, a);
    mpm_j_place(contour, segment->to, b);
    const enum mpm_crack_side of_to = mpm_j_side(contour, a, b, &crack);
    const enum mpm_crack_side of_from = mpm_j_side(contour, b, a, &crack);
    MPM_TRY(check_crack(contour, crack, segment->to, met, error));
    *halves += (of_to != MPM_CRACK_SAME_SIDE) + (of_from != MPM_CRACK_SAME_SIDE);
    if (of_to != MPM_CRACK_SAME_SIDE && of_from != MPM_CRACK_SAME_SIDE)
        return add_cut(contour, segment, of_to, of_from, j, error);
    return add_plain(contour, segment, of_to, of_from, j, error);
}

/* ------------------------------------------------------------------- contour */

/* Nodes that see less than three quarters of a cell lie at an edge of the bodies or outside. Those
 * on a crack have it all in several fields, and less where it gapes. */
static enum mpm_status check_inside(const struct mpm_j_contour *contour, const int64_t at[2],
                                    struct mpm_error *error)
{
    const struct mpm_j_node *const node = mpm_j_node_at(contour, at);
    const double cell = contour->state->grid.cell[0] * contour->state->grid.cell[1];
    double place[2];
    if (node->side[MPM_CRACK_SAME_SIDE].area >= 0.75 * cell ||
        node->side[MPM_CRACK_ABOVE].area > 0.0 || node->side[MPM_CRACK_BELOW].area > 0.0)
        return MPM_OK;
    mpm_j_place(contour, at, place);
    return mpm_error_set(error, MPM_RUN_FAILED,
                         "%s: the contour's node at (%g, %g) sees particles of %g of a cell: it is "
                         "at an edge of the bodies, or outside; allowed: inside",
                         contour->spec->key, place[0], place[1],
                         node->side[MPM_CRACK_SAME_SIDE].area / cell);
}

/* Mean over the nodes on the contour, of their own fields. */
void mpm_j_contour_find_common(struct mpm_j_contour *contour)
{
    const bool curved = contour->state->scene->geometry == MPM_AXISYMMETRIC;
    double count = 0.0, sum[4] = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < 4; k++)
        contour->common[k] = 0.0;
    if (curved && contour->spec->form == MPM_J_CONTOUR)
        return;
    int64_t at[2];
    for (at[1] = contour->low[1]; at[1] <= contour->high[1]; at[1]++)
        for (at[0] = contour->low[0]; at[0] <= contour->high[0]; at[0]++) {
            const struct mpm_j_sums *const own = &mpm_j_node_at(contour, at)->side[0];
            const bool inside = at[0] > contour->low[0] && at[0] < contour->high[0] &&
                                at[1] > contour->low[1] && at[1] < contour->high[1];
            if (inside || !(own->area > 0.0))
                continue;
            count += 1.0;
            for (int k = 0; k < 4; k++)
                sum[k] += own->gradient[k] / own->area;
        }
    for (int k = 0; k < 4 && count > 0.0; k++)
        contour->common[k] = sum[k] / count;
}

/* Counter clockwise: right side upwards, top leftwards, and so on. */
static const struct {
    int axis, sign; /* of the outward normal */
    int way;        /* along the other axis */
    int start[2];   /* corner: 1 high, 0 low */
} sides[] = {{0, 1, 1, {1, 0}}, {1, 1, -1, {1, 1}}, {0, -1, -1, {0, 1}}, {1, -1, 1, {0, 0}}};

enum mpm_status mpm_j_contour_integrate(const struct mpm_j_contour *contour, double j[2],
                                        size_t *met, struct mpm_error *error)
{
    int halves = 0;
    j[0] = j[1] = 0.0;
    *met = SIZE_MAX;
    for (size_t side = 0; side < sizeof sides / sizeof *sides; side++) {
        const int axis = sides[side].axis, along = 1 - axis;
        struct segment segment = {
            .axis = axis,
            .sign = sides[side].sign,
            .length = contour->state->grid.cell[along],
        };
        for (int i = 0; i < 2; i++)
            segment.to[i] = sides[side].start[i] != 0 ? contour->high[i] : contour->low[i];
        for (int64_t k = 0; k < contour->high[along] - contour->low[along]; k++) {
            segment.from[0] = segment.to[0];
            segment.from[1] = segment.to[1];
            segment.to[along] += sides[side].way;
            MPM_TRY(check_inside(contour, segment.to, error));
            MPM_TRY(add_segment(contour, &segment, &halves, j, met, error));
        }
    }
    if (halves > 2)
        *met = contour->spec->crack;
    if (halves != 2)
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "%s: the contour meets its crack %d times; allowed: once, with the "
                             "tip inside",
                             contour->spec->key, halves / 2);
    return MPM_OK;
}
