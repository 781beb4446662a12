/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_opening.h"

#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"

#include <math.h>

/* Fields of less than this part of the largest mass of their side count for less. */
static const double FULL_MASS = 0.1;
/* How far a surface lies from the crack where the search for bodies on its side is made, in cells:
 * enough for it to be off the crack whatever the round-off. */
static const double ASIDE = 1e-6;
/* And how far back from its end, where a crack cuts the edge of a body: the line from a surface
 * there to any node of the other side crosses the crack, which from a tip it need not. */
static const double BACK = 1e-3;

static const enum mpm_crack_side sides[2] = {MPM_CRACK_ABOVE, MPM_CRACK_BELOW};

/* ----------------------------------------------------------------- geometry */

void mpm_crack_point_normal(const struct mpm_crack_chain *chain, size_t k, double normal[2])
{
    double along[2] = {0.0, 0.0};
    for (size_t end = k > 0 ? k : 1; end <= k + 1 && end < chain->count; end++) {
        const double x = chain->x[end] - chain->x[end - 1], y = chain->y[end] - chain->y[end - 1];
        const double length = sqrt(x * x + y * y);
        along[0] += x / length;
        along[1] += y / length;
    }
    const double length = sqrt(along[0] * along[0] + along[1] * along[1]);
    normal[0] = -along[1] / length;
    normal[1] = along[0] / length;
}

struct mpm_crack_gap mpm_crack_gap_at(const struct mpm_state *state,
                                      const struct mpm_crack_chain *chain, size_t first,
                                      size_t point)
{
    double n[2];
    const double x = state->cracks.openings.vector[0][first + point];
    const double y = state->cracks.openings.vector[1][first + point];
    mpm_crack_point_normal(chain, point, n);
    return (struct mpm_crack_gap){.opening = x * n[0] + y * n[1], .sliding = x * n[1] - y * n[0]};
}

/* ------------------------------------------------------------------ finding */

/* A box around there and the nodes around `place`. */
static struct mpm_crack_box box_around(const struct mpm_state *state, const double from[2],
                                       const double place[2])
{
    struct mpm_crack_box box;
    for (int axis = 0; axis < 2; axis++) {
        box.low[axis] = fmin(from[axis], place[axis] - state->grid.cell[axis]);
        box.high[axis] = fmax(from[axis], place[axis] + state->grid.cell[axis]);
    }
    return box;
}

/* What a particle at `from` has at the nodes of a stencil: past any crack. */
static void find_sides(const struct mpm_state *state, const double from[2],
                       const struct mpm_crack_box *box, const struct mpm_stencil *stencil,
                       enum mpm_crack_side side[MPM_STENCIL_MAX])
{
    for (int k = 0; k < stencil->count; k++)
        side[k] = MPM_CRACK_SAME_SIDE;
    for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        struct mpm_crack_site made;
        const struct mpm_crack_part *const part =
            mpm_crack_map_part(state, box, (uint32_t)crack, &made);
        for (int k = 0; k < stencil->count && part != NULL; k++) {
            double place[2];
            mpm_grid_position(&state->grid, state->node_zero + stencil->node[k].node, place);
            if (side[k] == MPM_CRACK_SAME_SIDE)
                side[k] = mpm_crack_part_side(chain, part, from, place, NULL);
        }
    }
}

/* The field of a node for particles of that side, or -1 if it has no mass to speak of. */
static int64_t field_of(const struct mpm_state *state, int64_t parent, enum mpm_crack_side side)
{
    int64_t field = parent;
    if (!mpm_node_is_reached(state, parent))
        return -1;
    if (side != MPM_CRACK_SAME_SIDE) {
        const struct mpm_field_node *const node = mpm_field_node_at(state, parent);
        field = node == NULL ? -1 : mpm_field_of(state, node, (int)side);
    }
    return field >= 0 && mpm_symmetry_whole_mass(state, field) >= state->cracks.least_mass ? field
                                                                                           : -1;
}

static void add_node(struct mpm_crack_surface *surface, int64_t node, double weight)
{
    surface->node[surface->count] = node;
    surface->weight[surface->count++] = weight;
}

static void weigh(const struct mpm_state *state, struct mpm_crack_surface *surface)
{
    double largest = 0.0, sum = 0.0;
    for (int k = 0; k < surface->count; k++)
        largest = fmax(largest, mpm_symmetry_whole_mass(state, surface->node[k]));
    for (int k = 0; k < surface->count; k++) {
        const double mass = mpm_symmetry_whole_mass(state, surface->node[k]);
        surface->weight[k] *= fmin(1.0, mass / (FULL_MASS * largest));
        sum += surface->weight[k];
    }
    for (int k = 0; k < surface->count; k++)
        surface->weight[k] /= sum;
}

/* `from` lies beside the crack on the surface's side, `place` is where the surface is. */
static void find_surface(const struct mpm_state *state, const double from[2], const double place[2],
                         struct mpm_crack_surface *surface)
{
    struct mpm_stencil stencil;
    enum mpm_crack_side side[MPM_STENCIL_MAX];
    const struct mpm_shape_domain domain = {.position = {place[0], place[1]}};
    const struct mpm_crack_box box = box_around(state, from, place);
    mpm_shape_classic.evaluate(&state->shape_grid, &domain, &stencil);
    find_sides(state, from, &box, &stencil, side);
    surface->count = 0;
    for (int k = 0; k < stencil.count; k++) {
        const int64_t field = field_of(state, state->node_zero + stencil.node[k].node, side[k]);
        if (field >= 0 && stencil.node[k].s > 0.0)
            add_node(surface, field, stencil.node[k].s);
    }
    weigh(state, surface);
}

/* The place that sides are seen from: the point, or a little back from the edge of a body. */
static void view_point(const struct mpm_state *state, size_t crack, size_t point,
                       const double normal[2], double view[2])
{
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    const bool *const cuts = state->cracks.openings.cuts[crack];
    const double back = point == 0 && cuts[0]                  ? BACK
                        : point + 1 == chain->count && cuts[1] ? -BACK
                                                               : 0.0;
    const double along[2] = {normal[1], -normal[0]};
    view[0] = chain->x[point] + back * along[0] * state->grid.cell[0];
    view[1] = chain->y[point] + back * along[1] * state->grid.cell[1];
}

static void find_point(const struct mpm_state *state, size_t crack, size_t first, size_t point)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    const size_t k = first + point;
    double normal[2], view[2];
    mpm_crack_point_normal(chain, point, normal);
    view_point(state, crack, point, normal, view);
    for (int side = 0; side < 2; side++) {
        const double sign = sides[side] == MPM_CRACK_ABOVE ? 1.0 : -1.0;
        double from[2], place[2];
        for (int axis = 0; axis < 2; axis++) {
            from[axis] = view[axis] + sign * ASIDE * state->grid.cell[axis] * normal[axis];
            place[axis] = state->cracks.position[axis][k] + sign * 0.5 * openings->vector[axis][k];
        }
        find_surface(state, from, place, &openings->surfaces[k][side]);
    }
}

static void find_surfaces(struct mpm_state *state)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t crack = 0; crack < scene->crack_count; crack++) {
        const size_t first = mpm_crack_first_point(state, crack);
        if (!mpm_crack_is_followed(&scene->cracks[crack]))
            continue;
        for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
            find_point(state, crack, first, k);
    }
}

/* ------------------------------------------------------------------- motion */

static void surface_velocity(const struct mpm_state *state, const struct mpm_crack_surface *surface,
                             double v[2])
{
    v[0] = v[1] = 0.0;
    for (int k = 0; k < surface->count; k++)
        for (int axis = 0; axis < 2; axis++)
            v[axis] += surface->weight[k] * state->grid.gradient[surface->node[k]][axis][0];
}

/* Nodes of a surface are among the grid's and its ghosts up to a cell past the edge; points, which
 * their own motion checks, lie inside. */
static enum mpm_status check_place(const struct mpm_state *state, size_t crack, size_t k,
                                   struct mpm_error *error)
{
    for (int axis = 0; axis < 2; axis++) {
        const double cell = state->grid.cell[axis];
        const double low = state->grid.origin[axis] - cell;
        const double high = low + (double)(state->grid.cells[axis] + 2) * cell;
        const double middle = state->cracks.position[axis][k];
        const double away = 0.5 * fabs(state->cracks.openings.vector[axis][k]);
        if (!(middle - away >= low && middle + away <= high))
            return mpm_error_fail(error, MPM_CAUSE_LEFT_GRID,
                                  "a surface of cracks.%zu left the grid by more than a cell: %s "
                                  "coordinate %g +- %g; allowed: %g to %g",
                                  crack, axis == 0 ? "first" : "second", middle, away, low, high);
    }
    return MPM_OK;
}

static enum mpm_status advance_point(const struct mpm_state *state, size_t crack, size_t k,
                                     double time, struct mpm_error *error)
{
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const struct mpm_crack_surface *const surfaces = openings->surfaces[k];
    double above[2], below[2];
    if (surfaces[0].count == 0 || surfaces[1].count == 0)
        return MPM_OK;
    surface_velocity(state, &surfaces[0], above);
    surface_velocity(state, &surfaces[1], below);
    for (int axis = 0; axis < 2; axis++)
        openings->vector[axis][k] += time * (above[axis] - below[axis]);
    return check_place(state, crack, k, error);
}

static enum mpm_status advance(struct mpm_state *state, double part, struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t crack = 0; crack < scene->crack_count && part > 0.0; crack++) {
        const size_t first = mpm_crack_first_point(state, crack);
        if (!mpm_crack_is_followed(&scene->cracks[crack]))
            continue;
        for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
            MPM_TRY(advance_point(state, crack, first + k, part * state->time_step, error));
    }
    return MPM_OK;
}

enum mpm_status mpm_crack_openings_check(const struct mpm_state *state, struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t crack = 0; crack < scene->crack_count; crack++) {
        const size_t first = mpm_crack_first_point(state, crack);
        if (!mpm_crack_is_followed(&scene->cracks[crack]))
            continue;
        for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
            MPM_TRY(check_place(state, crack, first + k, error));
    }
    return MPM_OK;
}

enum mpm_status mpm_crack_openings_begin(struct mpm_state *state, struct mpm_error *error)
{
    if (state->cracks.openings.surfaces == NULL)
        return MPM_OK;
    find_surfaces(state);
    return advance(state, state->order->before, error);
}

enum mpm_status mpm_crack_openings_finish(struct mpm_state *state, struct mpm_error *error)
{
    return state->cracks.openings.surfaces == NULL ? MPM_OK
                                                   : advance(state, state->order->after, error);
}
