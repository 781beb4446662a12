/* Cracks that grow: a tip goes on by an increment when J_1 reaches the toughness.
 *
 * Straight on, or in the direction across which the hoop stress of the field of K_I and K_II is
 * largest (F. Erdogan, G. C. Sih, J. Basic Eng. 85 (1963) 519-525),
 *     tan(theta/2) = (K_I - sqrt(K_I^2 + 8 K_II^2))/(4 K_II) = -2 K_II/(K_I + sqrt(...)).
 * A chain has room for its points on both sides from the start. Steps are repeated by growing
 * again. In the undeformed body a tip goes on by the same length, in a direction that turns by the
 * same angle: right but for the strain there.
 *
 * A tip ends, and the run goes on, where the new segment would meet a crack, or another crack would
 * lie in the contour around the new tip, where J has no value.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/segment.h"
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "simulation/simulation.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

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

/* Gives a chain of `all` one more point; its place among all. */
static size_t extend(struct mpm_crack_chain *chain, double *const all[2], bool at_start,
                     const double place[2])
{
    const size_t first = (size_t)(chain->x - all[0]) - (at_start ? 1 : 0);
    const size_t added = at_start ? first : first + chain->count;
    for (int axis = 0; axis < 2; axis++)
        all[axis][added] = place[axis];
    chain->x = all[0] + first;
    chain->y = all[1] + first;
    chain->count++;
    return added;
}

/* `undeformed`: where the last point and the new one are in the undeformed body. */
static void add_point(struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                      const double place[2], const double undeformed[2][2])
{
    struct mpm_cracks *const cracks = &state->cracks;
    const size_t added =
        extend(&cracks->chains[spec->crack], cracks->position, spec->at_start, place);
    cracks->held[added] = 0;
    if (cracks->undeformed != NULL)
        (void)extend(&cracks->undeformed[spec->crack], cracks->origin, spec->at_start,
                     undeformed[1]);
    mpm_openings_grow(state, spec->crack, added, undeformed);
}

/* All J integrals around this tip go with it. `way`: from where it was to where it is, in the
 * undeformed body. */
static void move_tips(struct mpm_simulation *simulation, size_t index, double tangent,
                      double way[2][2])
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_j_integral_spec *const grows = &scene->j_integrals[index];
    const double increment = increment_of(scene, &grows->growth);
    struct mpm_crack_tip *const own = &simulation->tips[index];
    struct mpm_j_tip moved = own->undeformed;
    turn(tangent, moved.direction);
    for (int axis = 0; axis < 2; axis++) {
        way[0][axis] = moved.place[axis];
        way[1][axis] = moved.place[axis] += increment * moved.direction[axis];
    }
    const double width =
        scene->geometry == MPM_AXISYMMETRIC ? 0.5 * (way[0][0] + way[1][0]) : scene->thickness;
    own->dissipated += grows->growth.toughness * increment * width;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        if (scene->j_integrals[k].crack == grows->crack &&
            scene->j_integrals[k].at_start == grows->at_start) {
            simulation->tips[k].undeformed = moved;
            simulation->tips[k].grown += increment;
        }
}

/* ------------------------------------------------------------------- ending */

/* A crack that the new segment crosses or comes near, or SIZE_MAX. The segment that the tip has now
 * shares a point with the new one, and neither direction turns by a right angle. */
static size_t find_crack_met(const struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                             const struct mpm_segment *added)
{
    const double near = MPM_CRACK_NEAR * fmin(state->grid.cell[0], state->grid.cell[1]);
    for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        const size_t own = spec->at_start ? 0 : chain->count - 2;
        for (size_t k = 0; k + 1 < chain->count; k++) {
            const struct mpm_segment there = {{chain->x[k], chain->y[k]},
                                              {chain->x[k + 1], chain->y[k + 1]}};
            if ((crack != spec->crack || k != own) && mpm_segments_meet(added, &there, near))
                return crack;
        }
    }
    return SIZE_MAX;
}

/* Another crack within the contour around the new tip, or so near to it that a particle could reach
 * a node past both; or SIZE_MAX. */
static size_t find_crack_inside(const struct mpm_state *state,
                                const struct mpm_j_integral_spec *spec, const double tip[2])
{
    struct mpm_crack_box box;
    struct mpm_crack_part part;
    mpm_j_contour_box(state, spec, tip, &box);
    for (int axis = 0; axis < 2; axis++) {
        const double reach = state->widest[axis] + state->grid.cell[axis];
        box.low[axis] = fmin(box.low[axis], tip[axis] - reach);
        box.high[axis] = fmax(box.high[axis], tip[axis] + reach);
    }
    for (size_t crack = 0; crack < state->scene->crack_count; crack++)
        if (crack != spec->crack && mpm_crack_part_near(&state->cracks.chains[crack], &box,
                                                        state->cracks.map->slack, &part))
            return crack;
    return SIZE_MAX;
}

static void end_tip(struct mpm_simulation *simulation, size_t index, enum mpm_tip_end_reason reason,
                    size_t met)
{
    const struct mpm_state *const state = &simulation->state;
    struct mpm_tip_end *const end = &simulation->tips[index].end;
    *end = (struct mpm_tip_end){
        .reason = reason,
        .met = met,
        .step = simulation->step + 1,
        .time = state->time + state->time_step,
    };
    mpm_j_tip_place(state, &simulation->scene->j_integrals[index], end->place);
}

bool mpm_simulation_tip_end(const struct mpm_simulation *simulation, size_t index,
                            struct mpm_tip_end *end, char message[MPM_MESSAGE_SIZE])
{
    static const char *const words[] = {
        [MPM_TIP_GOES_ON] = "",
        [MPM_TIP_MEETS_CRACK] = "the next increment would meet",
        [MPM_TIP_CONTOUR_MEETS_CRACK] = "the contour of its J integral would meet or surround",
    };
    if (index >= simulation->scene->j_integral_count)
        return false;
    *end = simulation->tips[index].end;
    if (end->reason == MPM_TIP_GOES_ON)
        return false;
    (void)snprintf(message, MPM_MESSAGE_SIZE,
                   "%s: the tip at (%g, %g) has ended at step %" PRIu64 ", time %g: %s cracks.%zu; "
                   "it grows no further, and its J integral has no value from there on",
                   simulation->scene->j_integrals[index].key, end->place[0], end->place[1],
                   end->step, end->time, words[end->reason], end->met);
    return true;
}

/* ------------------------------------------------------------------- growing */

/* The segment from the tip to where it would grow. */
static struct mpm_segment next_segment(const struct mpm_state *state,
                                       const struct mpm_j_integral_spec *spec, double tangent)
{
    const double increment = increment_of(state->scene, &spec->growth);
    struct mpm_segment next = {{0.0, 0.0}, {0.0, 0.0}};
    double direction[2];
    mpm_j_tip_place(state, spec, next.a);
    tip_direction(&state->cracks.chains[spec->crack], spec->at_start, direction);
    turn(tangent, direction);
    for (int axis = 0; axis < 2; axis++)
        next.b[axis] = next.a[axis] + increment * direction[axis];
    return next;
}

static enum mpm_status grow(struct mpm_simulation *simulation, size_t index,
                            const struct mpm_j_value *value, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_j_integral_spec *const spec = &scene->j_integrals[index];
    const double increment = increment_of(scene, &spec->growth);
    const double tangent = half_angle(&spec->growth, value->stress_intensity);
    const struct mpm_segment added = next_segment(state, spec, tangent);
    const size_t met = find_crack_met(state, spec, &added);
    const size_t inside = find_crack_inside(state, spec, added.b);
    double way[2][2];
    if (met != SIZE_MAX || inside != SIZE_MAX) {
        end_tip(simulation, index,
                met != SIZE_MAX ? MPM_TIP_MEETS_CRACK : MPM_TIP_CONTOUR_MEETS_CRACK,
                met != SIZE_MAX ? met : inside);
        return MPM_OK;
    }
    if (rint(simulation->tips[index].grown / increment) + 1.0 >
        (double)increments_of(scene, &spec->growth))
        return mpm_error_fail(error, MPM_CAUSE_CRACK,
                              "%s: the tip at (%g, %g) has grown by %g and would grow further; "
                              "allowed: up to propagation.longest, %g",
                              spec->key, added.a[0], added.a[1], simulation->tips[index].grown,
                              spec->growth.longest);
    move_tips(simulation, index, tangent, way);
    add_point(state, spec, added.b, (const double(*)[2])way);
    return MPM_OK;
}

enum mpm_status mpm_cracks_grow(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    for (size_t k = 0; k < scene->j_integral_count; k++) {
        const struct mpm_j_integral_spec *const spec = &scene->j_integrals[k];
        struct mpm_j_value value;
        if (!(spec->growth.toughness > 0.0) || simulation->tips[k].end.reason != MPM_TIP_GOES_ON ||
            (simulation->step + 1) % (uint64_t)spec->growth.every != 0)
            continue;
        const enum mpm_status status = mpm_j_integral_evaluate(simulation, k, &value, error);
        if (status == MPM_RUN_FAILED && value.met != SIZE_MAX)
            end_tip(simulation, k, MPM_TIP_CONTOUR_MEETS_CRACK, value.met);
        else if (status != MPM_OK)
            return status;
        else if (value.j[0] >= spec->growth.toughness)
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
    simulation->backup.extents = MPM_TAKE(arena, struct mpm_chain_extents, scene->crack_count);
}

void mpm_growth_save(struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_cracks *const cracks = &simulation->state.cracks;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        simulation->backup.tips[k] = simulation->tips[k];
    for (size_t k = 0; scene->j_integral_count > 0 && k < scene->crack_count; k++) {
        simulation->backup.extents[k].now = cracks->chains[k];
        if (cracks->undeformed != NULL)
            simulation->backup.extents[k].undeformed = cracks->undeformed[k];
    }
}

void mpm_growth_restore(struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_cracks *const cracks = &simulation->state.cracks;
    for (size_t k = 0; k < scene->j_integral_count; k++)
        simulation->tips[k] = simulation->backup.tips[k];
    for (size_t k = 0; scene->j_integral_count > 0 && k < scene->crack_count; k++) {
        cracks->chains[k] = simulation->backup.extents[k].now;
        if (cracks->undeformed != NULL)
            cracks->undeformed[k] = simulation->backup.extents[k].undeformed;
    }
}
