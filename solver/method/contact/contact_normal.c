/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_normal.h"

#include "method/contact/contact_regression.h"
#include "method/contact/contact_sums.h"

#include <math.h>

/* A pair with the sums of both fields. */
struct two {
    const struct mpm_state *state;
    const struct mpm_pair_spec *spec;
    const struct mpm_contact_sums *sums[2];
};

/* The methods set the normal, of any length, and return a length to compare it with: a surface
 * across the node gives that, or more. */
static double steepest(const struct two *of)
{
    const double *const scale = of->state->grid.inverse_cell;
    return fmax(scale[0], scale[1]);
}

static void weigh(const double *one, double by_one, const double *other, double by_other,
                  double n[2])
{
    for (int axis = 0; axis < 2; axis++)
        n[axis] = by_one * one[axis] - by_other * other[axis];
}

static double both_areas(const struct two *of)
{
    return of->sums[0]->area + of->sums[1]->area;
}

static double by_volume(const struct two *of, struct mpm_contact_pair *pair)
{
    weigh(of->sums[0]->volume_normal, 1.0, of->sums[1]->volume_normal, 1.0, pair->normal);
    return steepest(of) * (of->sums[0]->volume + of->sums[1]->volume);
}

static double by_area(const struct two *of, struct mpm_contact_pair *pair)
{
    weigh(of->sums[0]->area_normal, 1.0, of->sums[1]->area_normal, 1.0, pair->normal);
    return steepest(of) * both_areas(of);
}

static double by_average(const struct two *of, struct mpm_contact_pair *pair)
{
    weigh(of->sums[0]->area_normal, of->sums[0]->area, of->sums[1]->area_normal, of->sums[1]->area,
          pair->normal);
    return steepest(of) * both_areas(of) * both_areas(of);
}

/* Areas that differ by round-off alone are equal: then both have a say. */
static const double EQUAL_AREAS = 1e-9;
/* Inside of a body its gradient is what strain makes of zero: below this part of area over cell,
 * it is no surface, and the other field's is taken. */
static const double INSIDE = 0.1;

static double by_larger(const struct two *of, struct mpm_contact_pair *pair)
{
    double weight[2];
    for (int k = 0; k < 2; k++) {
        const double area = of->sums[k]->area, other = of->sums[1 - k]->area;
        const double *const g = of->sums[1 - k]->area_normal;
        const bool larger = area >= other - EQUAL_AREAS * (area + other);
        weight[k] = larger || hypot(g[0], g[1]) < INSIDE * steepest(of) * other ? 1.0 : 0.0;
    }
    for (int k = 0; k < 2; k++) {
        const double *const g = of->sums[k]->area_normal;
        if (weight[1 - k] > 0.0 && hypot(g[0], g[1]) < INSIDE * steepest(of) * of->sums[k]->area)
            weight[k] = 0.0;
    }
    weigh(of->sums[0]->area_normal, weight[0], of->sums[1]->area_normal, weight[1], pair->normal);
    return steepest(of) * (weight[0] * of->sums[0]->area + weight[1] * of->sums[1]->area);
}

static double as_given(const struct two *of, struct mpm_contact_pair *pair)
{
    pair->normal[0] = of->spec->direction[0];
    pair->normal[1] = of->spec->direction[1];
    return 1.0;
}

/* A plane by linear regression; one by logistic regression starts from it. */
static double by_linear(const struct two *of, struct mpm_contact_pair *pair)
{
    double c[3];
    if (!mpm_contact_linear_plane(of->sums[0], of->sums[1], c))
        return by_average(of, pair);
    return mpm_contact_plane_normal(&of->state->grid, c, pair->normal);
}

static double (*const methods[MPM_NORMAL_COUNT])(const struct two *, struct mpm_contact_pair *) = {
    [MPM_NORMAL_VOLUME] = by_volume,   [MPM_NORMAL_AREA] = by_area,
    [MPM_NORMAL_AVERAGE] = by_average, [MPM_NORMAL_LARGER] = by_larger,
    [MPM_NORMAL_LINEAR] = by_linear,   [MPM_NORMAL_LOGISTIC] = by_linear,
    [MPM_NORMAL_GIVEN] = as_given,
};

/* Below this part of what it is the difference of, a normal is round-off. */
static const double NO_NORMAL = 1e-9;

static void scale(const struct mpm_state *state, const struct mpm_contact_node *node,
                  struct mpm_contact_pair *pair, double whole)
{
    for (int axis = 0; axis < 2; axis++)
        if (mpm_contact_is_on_plane(state, node->node, axis))
            pair->normal[axis] = 0.0;
    const double length = hypot(pair->normal[0], pair->normal[1]);
    pair->has_normal = length > NO_NORMAL * whole;
    for (int axis = 0; axis < 2 && pair->has_normal; axis++)
        pair->normal[axis] /= length;
}

static void find_normal(const struct mpm_state *state, const struct mpm_contact_node *node,
                        struct mpm_contact_pair *pair)
{
    struct mpm_contact_sums room[2];
    const struct two of = {state,
                           &mpm_contact_spec(state)->pairs[pair->spec],
                           {mpm_contact_whole_sums(state, node, pair->fields[0], &room[0]),
                            mpm_contact_whole_sums(state, node, pair->fields[1], &room[1])}};
    scale(state, node, pair, methods[of.spec->normal](&of, pair));
}

/* Of logistic regression. */
static void take_planes(struct mpm_state *state)
{
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[k];
        for (uint32_t i = node->first_pair; i < node->first_pair + node->pairs; i++) {
            const struct mpm_logistic_plane *const plane = &state->contact.planes[i];
            struct mpm_contact_pair *const pair = &state->contact.pairs[i];
            if (plane->used)
                scale(state, node, pair,
                      mpm_contact_plane_normal(&state->grid, plane->c, pair->normal));
        }
    }
}

enum mpm_status mpm_contact_normals_find(struct mpm_state *state, int workers,
                                         struct mpm_error *error)
{
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[k];
        for (uint32_t i = node->first_pair; i < node->first_pair + node->pairs; i++)
            find_normal(state, node, &state->contact.pairs[i]);
    }
    if (state->contact.planes != NULL) {
        MPM_TRY(mpm_contact_logistic_find(state, workers, error));
        take_planes(state);
    }
    return MPM_OK;
}
