/* Planes of symmetry: settled when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_fields.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdlib.h>

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

enum mpm_status mpm_symmetries_create(struct mpm_simulation *simulation, struct mpm_error *error)
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

enum mpm_status mpm_symmetries_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        MPM_TRY(find_inside(simulation, &state->symmetries.planes[k], error));
        MPM_TRY(hold_points(simulation, &state->symmetries.planes[k], error));
    }
    return MPM_OK;
}
