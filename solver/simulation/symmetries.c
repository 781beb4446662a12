/* Planes of symmetry: settled when the simulation is created.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_detection.h"
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

double mpm_symmetry_place(const struct mpm_state *state, const struct mpm_symmetry *plane)
{
    return state->grid.origin[plane->axis] +
           state->grid.cell[plane->axis] * (double)(plane->line - MPM_GHOST_ROWS);
}

/* All bodies must be on one side, which is then the inside. */
static enum mpm_status find_inside(const struct mpm_simulation *simulation,
                                   struct mpm_symmetry *plane, struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    const double place = mpm_symmetry_place(state, plane);
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

/* How far from a plane nodes of particles on the other side are, with a cell for bodies that are
 * stretched. */
static double reach_across(const struct mpm_state *state, const struct mpm_symmetry *plane)
{
    return state->widest[plane->axis] + 2.0 * state->grid.cell[plane->axis];
}

/* A crack that passes the plane: at one of its ends, straight across within reach of particles'
 * functions on both sides, so that the part beyond is an image of the part inside. */
static bool passes_straight(const struct mpm_state *state, const struct mpm_symmetry *plane,
                            double place, size_t crack)
{
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    const double *const along = plane->axis == 0 ? chain->x : chain->y;
    const double *const across = plane->axis == 0 ? chain->y : chain->x;
    const double reach = reach_across(state, plane);
    const double inward = (double)plane->inside;
    size_t crossings = 0;
    for (size_t k = 0; k + 1 < chain->count; k++) {
        const double from = (along[k] - place) * inward, to = (along[k + 1] - place) * inward;
        crossings += (from > 0.0) != (to > 0.0);
        if (fmin(from, to) < reach &&
            fabs(across[k + 1] - across[k]) > 1e-9 * state->grid.cell[1 - plane->axis])
            return false;
    }
    const double first = (along[0] - place) * inward;
    const double last = (along[chain->count - 1] - place) * inward;
    return crossings == 1 && fmin(first, last) <= -reach && fmax(first, last) >= reach;
}

/* The points beyond become images of those inside, from the plane outwards as far as functions
 * reach; farther ones are spread evenly. The crack is straight there: its shape stays. */
static void list_images(struct mpm_state *state, const struct mpm_symmetry *plane, double place,
                        size_t crack)
{
    struct mpm_cracks *const cracks = &state->cracks;
    const size_t first = mpm_crack_first_point(state, crack), count = cracks->chains[crack].count;
    double *const along = cracks->position[plane->axis] + first;
    const double reach = reach_across(state, plane);
    const bool at_start = (along[0] - place) * (double)plane->inside < 0.0;
    const size_t end = at_start ? 0 : count - 1, step = at_start ? 1 : SIZE_MAX; /* inwards */
    const double slack = 1e-6 * state->grid.cell[plane->axis];
    size_t beyond = end, left = 0;
    for (; (along[beyond + step] - place) * (double)plane->inside < -slack; beyond += step)
        left++;
    size_t inside = beyond + step;
    while (fabs(along[inside] - place) <= slack)
        inside += step;
    for (; (along[inside] - place) * (double)plane->inside < reach;
         inside += step, beyond -= step) {
        cracks->images[cracks->image_count++] =
            (struct mpm_crack_image){first + beyond, first + inside, plane->axis, place};
        if (left-- == 0)
            break;
    }
    mpm_cracks_reflect(state);
    if (left + 1 == 0)
        return;
    const double from = along[beyond + step], way = along[end] - from;
    for (size_t k = 1; k <= left; k++, beyond -= step)
        along[beyond] = from + way * (double)k / (double)(left + 1);
}

/* Points on a plane stay there. */
static enum mpm_status hold_points(struct mpm_simulation *simulation,
                                   const struct mpm_symmetry *plane, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    const double place = mpm_symmetry_place(state, plane);
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
        if (held == count || inside == count)
            continue;
        if (!passes_straight(state, plane, place, crack))
            return mpm_scene_error(error, scene, scene->cracks[crack].line, "cracks.points",
                                   "a crack that meets the plane of symmetry at %g; allowed: on it "
                                   "as a whole, inside, or past it in a straight line across it, "
                                   "%g or more to both sides",
                                   place, reach_across(state, plane));
        list_images(state, plane, place, crack);
        state->cracks.passes[crack] |= (uint8_t)(1u << plane->axis);
        state->symmetries.passed = true;
    }
    return MPM_OK;
}

/* Sums of contact between bodies are those of the whole model near a plane; fields of a crack there
 * are not. */
static enum mpm_status check_bodies(const struct mpm_state *state, const struct mpm_symmetry *plane,
                                    struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    const double place = mpm_symmetry_place(state, plane), least = reach_across(state, plane);
    for (size_t crack = 0; crack < scene->crack_count && scene->contact.field_count > 0; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        const double *const along = plane->axis == 0 ? chain->x : chain->y;
        for (size_t k = 0; k < chain->count; k++)
            if (!((along[k] - place) * (double)plane->inside >= least))
                return mpm_scene_error(error, scene, scene->cracks[crack].line, "cracks.points",
                                       "beside contact between bodies, a crack on the plane of "
                                       "symmetry at %g or near it; allowed: %g or more inside",
                                       place, least);
    }
    return MPM_OK;
}

/* Between a body and its image beyond the one plane, contact is not folded across the other. */
static enum mpm_status check_contact(const struct mpm_state *state, struct mpm_error *error)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t k = 0; k < scene->crack_count; k++)
        if (state->cracks.passes[k] != 0 && mpm_crack_has_contact(scene, k) &&
            state->cracks.held[mpm_crack_first_point(state, k)] != 0)
            return mpm_scene_error(error, scene, scene->cracks[k].line, "cracks.contact",
                                   "contact of a crack that lies on a plane of symmetry and passes "
                                   "another one; allowed: none");
    return MPM_OK;
}

enum mpm_status mpm_symmetries_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        MPM_TRY(find_inside(simulation, &state->symmetries.planes[k], error));
        MPM_TRY(check_bodies(state, &state->symmetries.planes[k], error));
        MPM_TRY(hold_points(simulation, &state->symmetries.planes[k], error));
    }
    return check_contact(state, error);
}
