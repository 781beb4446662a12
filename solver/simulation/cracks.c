/* Cracks: settled when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_detection.h"
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "method/cracks/crack_passages.h"
#include "simulation/crack_points.h"
#include "simulation/simulation.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* With what it may grow to. */
static size_t count_with_room(const struct mpm_scene *scene, size_t crack)
{
    return mpm_crack_points_place(scene, &scene->cracks[crack], NULL, NULL) +
           mpm_crack_room(scene, crack, true) + mpm_crack_room(scene, crack, false);
}

/* Points of the scene's chain, with those. */
static size_t undeformed_count(const struct mpm_scene *scene, size_t crack)
{
    return scene->cracks[crack].point_count + mpm_crack_room(scene, crack, true) +
           mpm_crack_room(scene, crack, false);
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
static size_t particles_listed(const struct mpm_state *state)
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
    mpm_crack_map_fill(state);
    for (size_t k = 0; k < state->scene->crack_count; k++) {
        const struct mpm_crack_spec *const spec = &state->scene->cracks[k];
        const size_t before = mpm_crack_room(state->scene, k, true);
        double *const x = cracks->position[0] + first + before;
        double *const y = cracks->position[1] + first + before;
        cracks->chains[k].x = x;
        cracks->chains[k].y = y;
        cracks->chains[k].count = mpm_crack_points_place(state->scene, spec, x, y);
        first += count_with_room(state->scene, k);
    }
}

/* As the scene gives them. */
static void place_undeformed(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    size_t first = 0;
    for (size_t k = 0; cracks->undeformed != NULL && k < state->scene->crack_count; k++) {
        const struct mpm_crack_spec *const spec = &state->scene->cracks[k];
        const size_t place = first + mpm_crack_room(state->scene, k, true);
        for (size_t i = 0; i < spec->point_count; i++)
            for (int axis = 0; axis < 2; axis++)
                cracks->origin[axis][place + i] = spec->points[i][axis];
        cracks->undeformed[k] = (struct mpm_crack_chain){
            cracks->origin[0] + place, cracks->origin[1] + place, spec->point_count};
        first += undeformed_count(state->scene, k);
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

void mpm_cracks_create(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    for (size_t k = 0; k < state->scene->crack_count; k++)
        cracks->point_count += count_with_room(state->scene, k);
    if (cracks->point_count > 0) {
        const int first = mpm_fields_claim(state, 2, nodes_around(state, 1));
        assert(first == MPM_CRACK_ABOVE); /* keys are sides */
        (void)first;
    }
}

size_t mpm_cracks_undeformed_points(const struct mpm_scene *scene)
{
    size_t count = 0;
    for (size_t k = 0; k < scene->crack_count; k++)
        count += undeformed_count(scene, k);
    return count;
}

void mpm_cracks_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_cracks *const cracks = &state->cracks;
    if (cracks->point_count == 0)
        return;
    cracks->chains = MPM_TAKE(arena, struct mpm_crack_chain, state->scene->crack_count);
    for (int axis = 0; axis < 2; axis++)
        cracks->position[axis] = MPM_TAKE(arena, double, cracks->point_count);
    if (mpm_crack_detection_needs_surfaces(state->scene)) {
        const size_t count = mpm_cracks_undeformed_points(state->scene);
        cracks->undeformed = MPM_TAKE(arena, struct mpm_crack_chain, state->scene->crack_count);
        for (int axis = 0; axis < 2; axis++)
            cracks->origin[axis] = MPM_TAKE(arena, double, count);
    }
    cracks->held = MPM_TAKE(arena, uint8_t, cracks->point_count);
    cracks->passes = MPM_TAKE(arena, uint8_t, state->scene->crack_count);
    cracks->images = MPM_TAKE(arena, struct mpm_crack_image,
                              state->symmetries.count > 0 ? cracks->point_count : 0);
    mpm_crack_map_layout(state, nodes_around(state, state->scene->crack_count), arena);
    state->fields.use_capacity = particles_listed(state);
    mpm_crack_fields_layout(state, arena);
    mpm_crack_passages_layout(state, arena);
    mpm_crack_contact_layout(state, arena);
}

void mpm_cracks_fill(struct mpm_state *state)
{
    if (state->cracks.point_count > 0) {
        place_cracks(state);
        place_undeformed(state);
        state->cracks.least_mass = 1e-3 * mpm_lightest_particle(&state->particles);
    }
    keep_origins(state);
}
