/* Cracks and planes of symmetry: settled when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "simulation/crack_points.h"
#include "simulation/simulation.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------- cracks */

/* With what it may grow to. */
static size_t count_with_room(const struct mpm_scene *scene, size_t crack)
{
    return mpm_crack_points_count(scene, &scene->cracks[crack]) +
           mpm_crack_room(scene, crack, true) + mpm_crack_room(scene, crack, false);
}

/* Nodes around each segment, twice of it for what cracks grow, and no more than there are of them
 * for each of so many `layers`. */
static size_t nodes_around(const struct mpm_state *state, size_t layers)
{
    const size_t all = layers * (size_t)(state->grid.columns * state->grid.rows);
    const size_t around = 2 * (2 + (size_t)state->family->nodes_past_end);
    const size_t estimate =
        2 * (state->cracks.point_count + state->scene->crack_count * around) * around;
    return estimate < all ? estimate : all;
}

/* Particles that reach such nodes: twice as many as the nodes have in their cells, since bodies may
 * be compressed there, and no more than there are. */
static size_t particles_kept(const struct mpm_state *state)
{
    int most = 0;
    for (size_t k = 0; k < state->scene->body_count; k++) {
        const int *const in_cell = state->scene->bodies[k].particles_per_cell;
        most = in_cell[0] * in_cell[1] > most ? in_cell[0] * in_cell[1] : most;
    }
    const size_t estimate = 2 * state->fields.node_capacity * (size_t)most;
    return estimate < state->particles.count ? estimate : state->particles.count;
}

static void place_cracks(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    size_t first = 0;
    for (size_t k = 0; k < state->scene->body_count; k++) {
        double reach[2];
        mpm_shape_reach(state->family, &state->shape_grid, state->bodies[k].half_size, reach);
        for (int axis = 0; axis < 2; axis++)
            cracks->widest[axis] = fmax(cracks->widest[axis], reach[axis]);
    }
    mpm_crack_map_fill(state);
    for (size_t k = 0; k < state->scene->crack_count; k++) {
        const struct mpm_crack_spec *const spec = &state->scene->cracks[k];
        const size_t before = mpm_crack_room(state->scene, k, true);
        double *const x = cracks->position[0] + first + before;
        double *const y = cracks->position[1] + first + before;
        mpm_crack_points_place(state->scene, spec, x, y);
        cracks->chains[k].x = x;
        cracks->chains[k].y = y;
        cracks->chains[k].count = mpm_crack_points_count(state->scene, spec);
        first += count_with_room(state->scene, k);
    }
}

size_t mpm_simulation_crack_point_count(const struct mpm_simulation *simulation)
{
    size_t count = 0;
    for (size_t k = 0; k < simulation->scene->crack_count; k++)
        count += simulation->state.cracks.chains[k].count;
    return count;
}

struct mpm_crack_point mpm_simulation_crack_point(const struct mpm_simulation *simulation,
                                                  size_t point)
{
    const struct mpm_crack_chain *const chains = simulation->state.cracks.chains;
    size_t k = 0;
    for (; point >= chains[k].count; k++)
        point -= chains[k].count;
    return (struct mpm_crack_point){.crack = k,
                                    .position = {chains[k].x[point], chains[k].y[point]}};
}

static void keep_origins(struct mpm_state *state)
{
    struct mpm_particles *const particles = &state->particles;
    for (int axis = 0; axis < 2 && particles->origin[0] != NULL; axis++)
        memcpy(particles->origin[axis], particles->position[axis],
               particles->count * sizeof(double));
}

/* ----------------------------------------------------------------- symmetry */

static void describe_plane(struct mpm_state *state, const struct mpm_boundary_spec *spec)
{
    const int axis = spec->normal;
    state->symmetries.planes[state->symmetries.count++] = (struct mpm_symmetry){
        .axis = axis,
        .line = llround((spec->region.a[axis] - state->grid.origin[axis]) *
                        state->grid.inverse_cell[axis]) +
                MPM_GHOST_ROWS,
    };
}

static enum mpm_status create_planes(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    state->symmetries.planes = calloc(scene->boundary_count + 1, sizeof *state->symmetries.planes);
    if (state->symmetries.planes == NULL)
        return mpm_error_memory(error, sizeof *state->symmetries.planes, "the planes of symmetry");
    for (size_t k = 0; k < scene->boundary_count; k++) {
        const struct mpm_boundary_spec *const spec = &scene->boundaries[k];
        if (!spec->symmetry)
            continue;
        if (scene->body_force.text[spec->normal] != NULL)
            return mpm_scene_error(error, scene, scene->line_body_force, "loads.body_force",
                                   "acts across a plane of symmetry, got '%s'; allowed: 0 there",
                                   scene->body_force.text[spec->normal]);
        describe_plane(state, spec);
    }
    return MPM_OK;
}

static double place_of_plane(const struct mpm_state *state, const struct mpm_symmetry *plane)
{
    return state->grid.origin[plane->axis] +
           state->grid.cell[plane->axis] * (double)(plane->line - MPM_GHOST_ROWS);
}

/* All bodies must be on one side, which is then the inside. */
static enum mpm_status find_inside(const struct mpm_simulation *simulation,
                                   struct mpm_symmetry *plane, struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    const double place = place_of_plane(state, plane);
    const double *const position = state->particles.position[plane->axis];
    for (size_t p = 0; p < state->particles.count; p++) {
        const int64_t side = position[p] > place ? 1 : -1;
        if (plane->inside == 0)
            plane->inside = side;
        if (side != plane->inside)
            return mpm_error_set(error, MPM_BAD_INPUT,
                                 "%s: boundary: symmetry: bodies on both sides of the plane at %g; "
                                 "allowed: on one",
                                 simulation->scene->path, place);
    }
    return MPM_OK;
}

/* Points on a plane stay there. A crack lies on it as a whole or not at all: fields of nodes
 * beyond, of one that meets it at an angle, would have to be images of each other. */
static enum mpm_status hold_points(const struct mpm_simulation *simulation,
                                   const struct mpm_symmetry *plane, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_state *const state = &simulation->state;
    const double place = place_of_plane(state, plane);
    const double slack = 1e-6 * state->grid.cell[plane->axis];
    for (size_t crack = 0; crack < scene->crack_count; crack++) {
        const size_t count = state->cracks.chains[crack].count;
        size_t k = mpm_crack_first_point(state, crack);
        size_t held = 0, inside = 0;
        for (size_t i = 0; i < count; i++, k++) {
            const double depth =
                (state->cracks.position[plane->axis][k] - place) * (double)plane->inside;
            inside += depth > slack;
            if (fabs(depth) > slack)
                continue;
            held++;
            state->cracks.held[k] |= (uint8_t)(1u << plane->axis);
        }
        if (held != count && inside != count)
            return mpm_scene_error(error, scene, scene->cracks[crack].line, "cracks.points",
                                   "a crack that meets the plane of symmetry at %g, or passes it; "
                                   "allowed: on it as a whole, or inside",
                                   place);
    }
    return MPM_OK;
}

/* ----------------------------------------------------------------- creating */

enum mpm_status mpm_cracks_create(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    struct mpm_cracks *const cracks = &state->cracks;
    for (size_t k = 0; k < simulation->scene->crack_count; k++)
        cracks->point_count += count_with_room(simulation->scene, k);
    if (cracks->point_count > 0) {
        const int first = mpm_fields_claim(state, 2, nodes_around(state, 1));
        assert(first == MPM_CRACK_ABOVE); /* keys are sides */
        (void)first;
    }
    return create_planes(simulation, error);
}

void mpm_cracks_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_cracks *const cracks = &state->cracks;
    if (cracks->point_count == 0)
        return;
    cracks->chains = MPM_TAKE(arena, struct mpm_crack_chain, state->scene->crack_count);
    for (int axis = 0; axis < 2; axis++)
        cracks->position[axis] = MPM_TAKE(arena, double, cracks->point_count);
    cracks->held = MPM_TAKE(arena, uint8_t, cracks->point_count);
    mpm_crack_map_layout(state, nodes_around(state, state->scene->crack_count), arena);
    state->fields.use_capacity = particles_kept(state);
    mpm_crack_fields_layout(state, arena);
}

static double lightest(const struct mpm_particles *particles)
{
    double least = HUGE_VAL;
    for (size_t p = 0; p < particles->count; p++)
        least = fmin(least, particles->mass[p]);
    return least;
}

enum mpm_status mpm_cracks_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    if (state->cracks.point_count > 0) {
        place_cracks(state);
        state->cracks.least_mass = 1e-3 * lightest(&state->particles);
    }
    keep_origins(state);
    for (size_t k = 0; k < state->symmetries.count; k++) {
        MPM_TRY(find_inside(simulation, &state->symmetries.planes[k], error));
        MPM_TRY(hold_points(simulation, &state->symmetries.planes[k], error));
    }
    return MPM_OK;
}
