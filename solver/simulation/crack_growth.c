/* Cracks that grow: a tip goes on by an increment when J_1 reaches the toughness.
 *
 * Straight on, or in the direction across which the hoop stress of the field of K_I and K_II is
 * largest (F. Erdogan, G. C. Sih, J. Basic Eng. 85 (1963) 519-525),
 *     tan(theta/2) = (K_I - sqrt(K_I^2 + 8 K_II^2))/(4 K_II) = -2 K_II/(K_I + sqrt(...)).
 * A chain has room for its points on both sides from the start. Steps are repeated by growing
 * again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/segment.h"
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_fields.h"
#include "simulation/simulation.h"

#include <math.h>

static double increment_of(const struct mpm_scene *scene, const struct mpm_growth_spec *growth)
{
    return growth->increment * fmin(scene->cell[0], scene->cell[1]);
}

static size_t increments_of(const struct mpm_scene *scene, const struct mpm_growth_spec *growth)
{
    return (size_t)floor(growth->longest / increment_of(scene, growth) * (1.0 + 1e-9));
}

size_t mpm_crack_room(const struct mpm_scene *scene, size_t crack, bool at_start)
{
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        const struct mpm_j_integral_spec *const spec = &scene->j_integrals[k];
        if (spec->crack == crack && spec->at_start == at_start && spec->growth.toughness > 0.0)
            return increments_of(scene, &spec->growth);
    }
    return 0;
}

/* ------------------------------------------------------------------ growing */

/* Turns a unit vector by the angle whose half has this tangent. */
static void turn(double tangent, double direction[2])
{
    const double square = tangent * tangent, scale = 1.0 / (1.0 + square);
    const double c = (1.0 - square) * scale, s = 2.0 * tangent * scale;
    const double x = c * direction[0] - s * direction[1], y = s * direction[0] + c * direction[1];
    const double length = sqrt(x * x + y * y); /* 1, but for round-off that would add up */
    direction[0] = x / length;
    direction[1] = y / length;
}

static double half_angle(const struct mpm_growth_spec *growth, const double intensity[2])
{
    const double opening = fmax(intensity[0], 0.0); /* faces pressed together have no K_I */
    const double size = sqrt(opening * opening + 8.0 * intensity[1] * intensity[1]) + opening;
    if (growth->direction == MPM_GROWS_STRAIGHT || !(size > 0.0))
        return 0.0;
    return -2.0 * intensity[1] / size;
}

/* That of the last segment, now. */
static void tip_direction(const struct mpm_crack_chain *chain, bool at_start, double direction[2])
{
    const size_t tip = at_start ? 0 : chain->count - 1, before = at_start ? 1 : chain->count - 2;
    const double x = chain->x[tip] - chain->x[before], y = chain->y[tip] - chain->y[before];
    const double length = sqrt(x * x + y * y);
    direction[0] = x / length;
    direction[1] = y / length;
}

static void add_point(struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                      const double place[2])
{
    struct mpm_cracks *const cracks = &state->cracks;
    struct mpm_crack_chain *const chain = &cracks->chains[spec->crack];
    const size_t first = mpm_crack_first_point(state, spec->crack) - (spec->at_start ? 1 : 0);
    const size_t added = spec->at_start ? first : first + chain->count;
    for (int axis = 0; axis < 2; axis++)
        cracks->position[axis][added] = place[axis];
    cracks->held[added] = 0;
    chain->x = cracks->position[0] + first;
    chain->y = cracks->position[1] + first;
    chain->count++;
}

/* All J integrals around this tip go with it. */
static void move_tips(struct mpm_simulation *simulation, size_t index, double tangent)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_j_integral_spec *const grows = &scene->j_integrals[index];
    const double increment = increment_of(scene, &grows->growth);
    struct mpm_crack_tip *const own = &simulation->tips[index];
    struct mpm_j_tip moved = own->undeformed;
    turn(tangent, moved.direction);
    for (int axis = 0; axis < 2; axis++)
        moved.place[axis] += increment * moved.direction[axis];
    const double width = scene->geometry == MPM_AXISYMMETRIC
                             ? 0.5 * (own->undeformed.place[0] + moved.place[0])
                             : scene->thickness;
    own->dissipated += grows->growth.toughness * increment * width;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        if (scene->j_integrals[k].crack == grows->crack &&
            scene->j_integrals[k].at_start == grows->at_start) {
            simulation->tips[k].undeformed = moved;
            simulation->tips[k].grown += increment;
        }
}

/* The segment that the tip has now shares a point with the new one, and neither direction turns by
 * a right angle. */
static enum mpm_status check_way(const struct mpm_state *state,
                                 const struct mpm_j_integral_spec *spec,
                                 const struct mpm_segment *added, struct mpm_error *error)
{
    const double near = MPM_CRACK_NEAR * fmin(state->grid.cell[0], state->grid.cell[1]);
    for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        const size_t own = spec->at_start ? 0 : chain->count - 2;
        for (size_t k = 0; k + 1 < chain->count; k++) {
            const struct mpm_segment there = {{chain->x[k], chain->y[k]},
                                              {chain->x[k + 1], chain->y[k + 1]}};
            if ((crack == spec->crack && k == own) || !mpm_segments_meet(added, &there, near))
                continue;
            return mpm_error_fail(error, MPM_CAUSE_CRACK,
                                  "%s: the tip at (%g, %g) would grow to (%g, %g), and meet "
                                  "cracks.%zu there; allowed: cracks that meet neither themselves "
                                  "nor each other",
                                  spec->key, added->a[0], added->a[1], added->b[0], added->b[1],
                                  crack);
        }
    }
    return MPM_OK;
}

static enum mpm_status grow(struct mpm_simulation *simulation, size_t index,
                            const struct mpm_j_value *value, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_j_integral_spec *const spec = &scene->j_integrals[index];
    const struct mpm_crack_chain *const chain = &state->cracks.chains[spec->crack];
    const double increment = increment_of(scene, &spec->growth);
    const double tangent = half_angle(&spec->growth, value->stress_intensity);
    struct mpm_segment added = {{0.0, 0.0}, {0.0, 0.0}};
    double direction[2];
    mpm_j_tip_place(state, spec, added.a);
    if (rint(simulation->tips[index].grown / increment) + 1.0 >
        (double)increments_of(scene, &spec->growth))
        return mpm_error_fail(error, MPM_CAUSE_CRACK,
                              "%s: the tip at (%g, %g) has grown by %g and would grow further; "
                              "allowed: up to propagation.longest, %g",
                              spec->key, added.a[0], added.a[1], simulation->tips[index].grown,
                              spec->growth.longest);
    tip_direction(chain, spec->at_start, direction);
    turn(tangent, direction);
    for (int axis = 0; axis < 2; axis++)
        added.b[axis] = added.a[axis] + increment * direction[axis];
    MPM_TRY(check_way(state, spec, &added, error));
    add_point(state, spec, added.b);
    move_tips(simulation, index, tangent);
    return MPM_OK;
}

enum mpm_status mpm_cracks_grow(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        const struct mpm_j_integral_spec *const spec = &scene->j_integrals[k];
        struct mpm_j_value value;
        if (!(spec->growth.toughness > 0.0) ||
            (simulation->step + 1) % (uint64_t)spec->growth.every != 0)
            continue;
        MPM_TRY(mpm_j_integral_evaluate(simulation, k, &value, error));
        if (value.j[0] >= spec->growth.toughness)
            MPM_TRY(grow(simulation, k, &value, error));
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------- backup */

void mpm_growth_layout(struct mpm_simulation *simulation, struct mpm_arena *arena)
{
    const struct mpm_scene *const scene = simulation->scene;
    if (scene->j_integral_count == 0)
        return;
    simulation->backup.tips = MPM_TAKE(arena, struct mpm_crack_tip, scene->j_integral_count);
    simulation->backup.extents = MPM_TAKE(arena, struct mpm_chain_extent, scene->crack_count);
}

void mpm_growth_save(struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_cracks *const cracks = &simulation->state.cracks;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        simulation->backup.tips[k] = simulation->tips[k];
    for (size_t k = 0; scene->j_integral_count > 0 && k < scene->crack_count; k++)
        simulation->backup.extents[k] = (struct mpm_chain_extent){
            mpm_crack_first_point(&simulation->state, k), cracks->chains[k].count};
}

void mpm_growth_restore(struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_cracks *const cracks = &simulation->state.cracks;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        simulation->tips[k] = simulation->backup.tips[k];
    for (size_t k = 0; scene->j_integral_count > 0 && k < scene->crack_count; k++) {
        cracks->chains[k].x = cracks->position[0] + simulation->backup.extents[k].first;
        cracks->chains[k].y = cracks->position[1] + simulation->backup.extents[k].first;
        cracks->chains[k].count = simulation->backup.extents[k].count;
    }
}
