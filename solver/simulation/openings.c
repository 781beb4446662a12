/* Surfaces of cracks and their cohesive laws: settled when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_opening.h"
#include "simulation/crack_points.h"
#include "simulation/simulation.h"

#include <math.h>

size_t mpm_openings_points(const struct mpm_state *state)
{
    for (size_t k = 0; k < state->scene->crack_count; k++)
        if (mpm_crack_is_followed(&state->scene->cracks[k]))
            return state->cracks.point_count;
    return 0;
}

void mpm_openings_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_crack_openings *const openings = &state->cracks.openings;
    const size_t points = mpm_openings_points(state);
    if (points == 0)
        return;
    for (int axis = 0; axis < 2; axis++)
        openings->vector[axis] = MPM_TAKE(arena, double, points);
    openings->cuts = mpm_arena_take(arena, state->scene->crack_count, sizeof *openings->cuts);
    openings->mouths = mpm_arena_take(arena, state->scene->crack_count, sizeof *openings->mouths);
    openings->surfaces = mpm_arena_take(arena, points, sizeof *openings->surfaces);
    if (!mpm_scene_is_cohesive(state->scene))
        return;
    openings->largest = MPM_TAKE(arena, double, points);
    openings->area = MPM_TAKE(arena, double, points);
}

/* -------------------------------------------------------------------- areas */

/* A segment gives its length to its two ends; in axisymmetry the integral of r with the linear
 * function of each end. */
static void add_area(const struct mpm_state *state, const struct mpm_crack_chain *chain, size_t k,
                     double *area)
{
    const bool axisymmetric = state->scene->geometry == MPM_AXISYMMETRIC;
    const double x[2] = {chain->x[k], chain->x[k + 1]};
    const double length = hypot(x[1] - x[0], chain->y[k + 1] - chain->y[k]);
    for (int end = 0; end < 2; end++)
        area[k + (size_t)end] += axisymmetric ? length * (2.0 * x[end] + x[1 - end]) / 6.0
                                              : 0.5 * length * state->scene->thickness;
}

/* What is outside of bodies has nothing to hold together. Looked at along the segment, whose ends
 * may lie on an edge. */
enum { LOOKS = 5 };
static enum mpm_status add_segment(const struct mpm_state *state, size_t crack, size_t k,
                                   double *area, struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    const double from[2] = {chain->x[k], chain->y[k]}, to[2] = {chain->x[k + 1], chain->y[k + 1]};
    int inside = 0, between = 0;
    for (int i = 0; i < LOOKS; i++) {
        const double part = (double)i / (LOOKS - 1);
        const double place[2] = {from[0] + part * (to[0] - from[0]),
                                 from[1] + part * (to[1] - from[1])};
        const bool is_inside = mpm_crack_point_is_in_a_body(scene, place);
        inside += is_inside;
        between += is_inside && i > 0 && i < LOOKS - 1;
    }
    if (between == 0)
        return MPM_OK;
    if (inside < LOOKS)
        return mpm_scene_error(error, scene, scene->cracks[crack].line, "cracks.points",
                               "a cohesive crack passes the edge of a body between (%g, %g) and "
                               "(%g, %g); allowed: one that has a point on that edge",
                               from[0], from[1], to[0], to[1]);
    add_area(state, chain, k, area);
    return MPM_OK;
}

void mpm_openings_grow(struct mpm_state *state, size_t crack, size_t added,
                       const double undeformed[2][2])
{
    struct mpm_crack_openings *const openings = &state->cracks.openings;
    const double *const from = undeformed[0], *const to = undeformed[1];
    for (int axis = 0; axis < 2 && mpm_crack_is_followed(&state->scene->cracks[crack]); axis++)
        openings->vector[axis][added] = 0.0; /* a checkpoint may have something else there */
    const double width = state->scene->geometry == MPM_AXISYMMETRIC ? 0.5 * (from[0] + to[0])
                                                                    : state->scene->thickness;
    if (state->scene->cracks[crack].cohesive.law != NULL) {
        openings->largest[added] = 0.0;
        openings->area[added] = hypot(to[0] - from[0], to[1] - from[1]) * width;
    }
}

/* ------------------------------------------------------------------ filling */

/* Is there no body a little beyond the ends? */
static void find_cuts(const struct mpm_state *state, const struct mpm_crack_chain *chain,
                      bool cuts[2])
{
    static const double BEYOND = 0.01;
    const size_t last = chain->count - 1;
    const size_t end[2] = {0, last}, next[2] = {1, last - 1};
    for (int k = 0; k < 2; k++) {
        const double x = chain->x[end[k]] - chain->x[next[k]];
        const double y = chain->y[end[k]] - chain->y[next[k]];
        const double scale = BEYOND * fmin(state->grid.cell[0], state->grid.cell[1]) / hypot(x, y);
        const double place[2] = {chain->x[end[k]] + scale * x, chain->y[end[k]] + scale * y};
        cuts[k] = !mpm_crack_point_is_in_a_body(state->scene, place);
    }
}

static enum mpm_status check_planes(const struct mpm_state *state, size_t crack, size_t first,
                                    struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
        if (state->cracks.held[first + k] != 0 && state->cracks.passes[crack] == 0)
            return mpm_scene_error(error, scene, scene->cracks[crack].line, "cracks.points",
                                   "opening or cohesive of a crack on a plane of symmetry, beyond "
                                   "which its other surface has no particles; allowed: inside");
    return MPM_OK;
}

enum mpm_status mpm_openings_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    for (size_t crack = 0; crack < scene->crack_count; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        const size_t first = mpm_crack_first_point(state, crack);
        if (mpm_crack_is_followed(&scene->cracks[crack])) {
            MPM_TRY(check_planes(state, crack, first, error));
            find_cuts(state, chain, state->cracks.openings.cuts[crack]);
            mpm_crack_points_mouths(scene, &scene->cracks[crack], first,
                                    state->cracks.openings.mouths[crack]);
        }
        if (scene->cracks[crack].cohesive.law != NULL)
            for (size_t k = 0; k + 1 < chain->count; k++)
                MPM_TRY(add_segment(state, crack, k, state->cracks.openings.area + first, error));
    }
    return MPM_OK;
}

/* ---------------------------------------------------------------- time step */

/* Two masses m per area on a spring k per area are stable up to k dt^2 (2/m) = 4, and half a cell's
 * mass each side is what a crack finds: k dt^2 up to a cell's mass per area. So it was seen, stable
 * at once that and not at twice, wherever the crack lies in its cell, with four families of shape
 * functions and Courant numbers of 0.4 and 0.8. This part of it is allowed. */
static const double STIFFEST = 0.5;

static double lightest_density(const struct mpm_state *state)
{
    double least = HUGE_VAL;
    for (size_t k = 0; k < state->scene->body_count; k++)
        if (!state->scene->bodies[k].rigid)
            least = fmin(least, state->bodies[k].material.density);
    return least;
}

enum mpm_status mpm_openings_check_start(const struct mpm_simulation *simulation,
                                         struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    bool lands;
    if (!mpm_scene_is_cohesive(scene) || scene->allow_unstable)
        return MPM_OK;
    const double step = mpm_time_step_next(simulation, scene->end, &lands);
    const double mass = lightest_density(&simulation->state) * fmin(scene->cell[0], scene->cell[1]);
    const double limit = STIFFEST * mass / (step * step);
    for (size_t k = 0; k < scene->crack_count; k++)
        if (scene->cracks[k].cohesive.law != NULL &&
            !(scene->cracks[k].cohesive.stiffness <= limit))
            return mpm_scene_error(error, scene, scene->cracks[k].line, "cracks.cohesive.stiffness",
                                   "%g is more than the time step of %g can follow; allowed: up to "
                                   "%g (%g of a cell's mass per area over the step squared), or "
                                   "more with time.allow_unstable: true",
                                   scene->cracks[k].cohesive.stiffness, step, limit, STIFFEST);
    return MPM_OK;
}
