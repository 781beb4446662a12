/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/exchange.h"

#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"

/* One of the velocities of a node: where it is, and how it is changed. */
struct velocities {
    double *(*component)(const struct mpm_state *, int64_t, int axis);
    void (*change)(const struct mpm_state *, int64_t, const double[2]);
    bool moves; /* particles: what conditions bear does work */
};

static double *start_of(const struct mpm_state *state, int64_t node, int axis)
{
    return &state->grid.start[node][axis];
}

static double *end_of(const struct mpm_state *state, int64_t node, int axis)
{
    return &state->grid.motion[node].end[axis];
}

static double *extrapolated_of(const struct mpm_state *state, int64_t node, int axis)
{
    return state->grid.gradient[node][axis];
}

static void change_start(const struct mpm_state *state, int64_t node, const double by[2])
{
    for (int axis = 0; axis < 2; axis++)
        state->grid.start[node][axis] += by[axis];
    if (state->order->before > 0.0)
        mpm_node_set_gradient(&state->grid, node, state->grid.start[node]);
}

static void change_end(const struct mpm_state *state, int64_t node, const double by[2])
{
    struct mpm_node_motion *const motion = &state->grid.motion[node];
    for (int axis = 0; axis < 2; axis++) {
        motion->end[axis] += by[axis];
        motion->acceleration[axis] += by[axis] / state->time_step;
        if (state->grid.contact_force != NULL)
            state->grid.contact_force[node][axis] +=
                state->grid.mass[node] * by[axis] / state->time_step;
    }
    if (!state->order->extrapolate)
        mpm_node_set_gradient(&state->grid, node, motion->end);
}

static void change_extrapolated(const struct mpm_state *state, int64_t node, const double by[2])
{
    for (int axis = 0; axis < 2; axis++) {
        double *const v = state->grid.gradient[node][axis];
        v[0] = v[1] = v[0] + by[axis];
    }
}

static double *smoothed_of(const struct mpm_state *state, int64_t node, int axis)
{
    return &state->grid.smoothed[node].acceleration[axis];
}

static void change_smoothed(const struct mpm_state *state, int64_t node, const double by[2])
{
    for (int axis = 0; axis < 2; axis++)
        state->grid.smoothed[node].acceleration[axis] += by[axis];
}

static const struct velocities velocities_of[] = {
    [MPM_EXCHANGE_START] = {start_of, change_start, false},
    [MPM_EXCHANGE_END] = {end_of, change_end, true},
    [MPM_EXCHANGE_EXTRAPOLATED] = {extrapolated_of, change_extrapolated, false},
    [MPM_EXCHANGE_SMOOTHED] = {smoothed_of, change_smoothed, false},
};

/* A field changes together with its images beyond planes of symmetry. */
static void change_field(const struct mpm_state *state, const struct velocities *velocities,
                         int64_t field, const double by[2])
{
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    const bool packed = field >= mpm_fields_first(state);
    velocities->change(state, field, by);
    if (state->symmetries.count == 0 || (packed && !state->symmetries.passed))
        return;
    const int count =
        mpm_symmetry_images(state, packed ? mpm_field_parent(state, field) : field, images);
    for (int k = 0; k < count; k++) {
        const int64_t image =
            packed ? mpm_symmetry_packed_image(state, field, &images[k]) : images[k].node;
        if (image >= 0)
            velocities->change(
                state, image,
                (const double[2]){images[k].sign[0] * by[0], images[k].sign[1] * by[1]});
    }
}

/* A condition that holds a component gives the opposite of the impulse there, and works along its
 * velocity. */
static void add_reaction_work(struct mpm_state *state, int64_t field,
                              const struct mpm_contact_side *side, const double impulse[2])
{
    if (!mpm_node_is_inside(state, field))
        return;
    for (int axis = 0; axis < 2; axis++)
        if (side->mobility[axis] == 0.0)
            state->external_work -=
                impulse[axis] * 0.5 *
                (state->grid.start[field][axis] + state->grid.motion[field].end[axis]);
}

struct mpm_contact_side mpm_exchange_side(const struct mpm_state *state,
                                          enum mpm_exchange_when when,
                                          const struct mpm_exchange_field *field)
{
    const double mobility = 1.0 / state->grid.mass[field->node];
    struct mpm_contact_side side = {.mobility = {mobility, mobility}};
    for (int axis = 0; axis < 2; axis++) {
        side.velocity[axis] = *velocities_of[when].component(state, field->node, axis);
        if ((field->held >> axis & 1) != 0)
            side.mobility[axis] = 0.0;
    }
    return side;
}

void mpm_exchange_give(struct mpm_state *state, enum mpm_exchange_when when,
                       const struct mpm_exchange_field *field, const struct mpm_contact_side *side,
                       const double impulse[2])
{
    const struct velocities *const velocities = &velocities_of[when];
    change_field(state, velocities, field->node,
                 (const double[2]){side->mobility[0] * impulse[0], side->mobility[1] * impulse[1]});
    if (velocities->moves)
        add_reaction_work(state, field->node, side, impulse);
}

void mpm_exchange(struct mpm_state *state, enum mpm_exchange_when when,
                  const struct mpm_exchange_field fields[2], const double normal[2],
                  const struct mpm_contact_law *law)
{
    const struct mpm_contact_side sides[2] = {mpm_exchange_side(state, when, &fields[0]),
                                              mpm_exchange_side(state, when, &fields[1])};
    double impulse[2];
    if (law->if_approaching && mpm_contact_approach(sides, normal) <= 0.0)
        return;
    mpm_contact_impulse(law, sides, normal, impulse);
    mpm_exchange_give(state, when, &fields[0], &sides[0], impulse);
    mpm_exchange_give(state, when, &fields[1], &sides[1],
                      (const double[2]){-impulse[0], -impulse[1]});
}
