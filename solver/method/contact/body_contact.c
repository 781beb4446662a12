/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/body_contact.h"

#include "method/contact/contact_detection.h"
#include "method/contact/contact_edges.h"
#include "method/contact/contact_normal.h"
#include "method/contact/contact_particles.h"
#include "method/contact/contact_solve.h"
#include "method/contact/contact_sums.h"
#include "method/contact/interface_law.h"
#include "method/grid/conditions.h"
#include "method/grid/grid_update.h"

#include <math.h>
#include <string.h>

void mpm_body_contact_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_body_contact *const contact = &state->contact;
    const struct mpm_contact_spec *const spec = mpm_contact_spec(state);
    if (spec->field_count == 0)
        return;
    mpm_shared_nodes_layout(state, arena);
    mpm_contact_particles_layout(state, arena);
    contact->field_of = MPM_TAKE(arena, uint8_t, state->scene->body_count);
    if (spec->field_count > spec->deformable_fields)
        contact->touched = MPM_TAKE(arena, uint8_t, state->scene->body_count);
    contact->totals = MPM_TAKE(arena, struct mpm_contact_totals, spec->pair_count);
    contact->samples = MPM_TAKE(arena, struct mpm_contact_sample, spec->pair_count);
}

enum mpm_status mpm_body_contact_begin(struct mpm_state *state, int workers,
                                       struct mpm_error *error)
{
    if (!mpm_body_contact_is_used(state))
        return MPM_OK;
    MPM_TRY(mpm_shared_nodes_find(state, error));
    if (state->contact.node_count > 0)
        mpm_contact_particles_find(state, workers);
    mpm_contact_sums_find(state, workers);
    MPM_TRY(mpm_contact_normals_find(state, workers, error));
    if (mpm_contact_needs_edges(mpm_contact_spec(state)))
        mpm_contact_edges_find(state, workers);
    mpm_contact_detect(state);
    memset(state->contact.samples, 0,
           mpm_contact_spec(state)->pair_count * sizeof *state->contact.samples);
    return MPM_OK;
}

/* ------------------------------------------------------------------ holding */

/* Marks what conditions hold of the fields of listed nodes. */
static void mark_held(struct mpm_state *state)
{
    for (size_t k = 0; k < state->conditions.active_count; k++) {
        const struct mpm_active_condition *const active = &state->conditions.active[k];
        const struct mpm_contact_node *const node =
            mpm_contact_node_at(state, mpm_field_parent(state, active->node));
        if (node == NULL)
            continue;
        for (uint32_t i = node->first_field; i < node->first_field + node->fields; i++)
            if (state->contact.fields[i].node == active->node)
                state->contact.fields[i].held |= (uint8_t)(1u << active->component);
    }
}

/* Nodes on planes of symmetry do not move across them. */
static void hold_on_planes(struct mpm_state *state, const struct mpm_contact_node *node)
{
    for (int axis = 0; axis < 2; axis++)
        if (mpm_contact_is_on_plane(state, node->node, axis))
            for (uint32_t i = node->first_field; i < node->first_field + node->fields; i++)
                state->contact.fields[i].held |= (uint8_t)(1u << axis);
}

static enum mpm_status find_rigid_velocity(struct mpm_state *state,
                                           const struct mpm_contact_node *node,
                                           struct mpm_contact_field *field, struct mpm_error *error)
{
    const struct mpm_contact_spec *const spec = mpm_contact_spec(state);
    double place[2];
    field->held = 3;
    mpm_grid_position(&state->grid, node->node, place);
    for (size_t k = 0; k < spec->group_count; k++)
        for (int axis = 0; axis < 2 && spec->field_of[k] == field->field; axis++)
            MPM_TRY(mpm_rigid_velocity(state, (uint32_t)spec->groups[k].body, axis, place,
                                       &field->rigid_start[axis], &field->rigid_end[axis], error));
    return MPM_OK;
}

enum mpm_status mpm_body_contact_hold(struct mpm_state *state, struct mpm_error *error)
{
    if (state->contact.node_count == 0)
        return MPM_OK;
    mark_held(state);
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[k];
        hold_on_planes(state, node);
        for (uint32_t i = node->first_field; i < node->first_field + node->fields; i++)
            if (state->contact.fields[i].node < 0)
                MPM_TRY(find_rigid_velocity(state, node, &state->contact.fields[i], error));
    }
    return MPM_OK;
}

/* ---------------------------------------------------------------- exchanging */

enum { PAIRS = MPM_CONTACT_SIDES * (MPM_CONTACT_SIDES - 1) / 2 };

/* A node's fields and pairs in one exchange; those across a crack come last. */
struct exchange {
    struct mpm_state *state;
    enum mpm_exchange_when when;
    const struct mpm_contact_node *node;
    struct mpm_contact_side sides[MPM_CONTACT_SIDES], before[MPM_CONTACT_SIDES];
    struct mpm_solve_pair pairs[PAIRS];
    const struct mpm_contact_pair *of[PAIRS]; /* of bodies */
    bool stiff[PAIRS];
    int of_bodies, count;
};

static struct mpm_exchange_field as_exchanged(const struct mpm_contact_field *field)
{
    return (struct mpm_exchange_field){field->node, field->held};
}

static struct mpm_contact_side side_of(const struct exchange *exchange,
                                       const struct mpm_contact_field *field)
{
    const struct mpm_exchange_field exchanged = as_exchanged(field);
    if (field->node >= 0)
        return mpm_exchange_side(exchange->state, exchange->when, &exchanged);
    const bool begins = exchange->when == MPM_EXCHANGE_START ||
                        (exchange->when == MPM_EXCHANGE_SMOOTHED &&
                         exchange->state->scene->transfer == MPM_TRANSFER_XPIC);
    const double *const v = begins ? field->rigid_start : field->rigid_end;
    return (struct mpm_contact_side){.velocity = {v[0], v[1]}};
}

/* All but the lines of an interface. */
static void prepare(const struct exchange *exchange, const struct mpm_contact_pair *pair,
                    struct mpm_solve_pair *solved)
{
    const struct mpm_state *const state = exchange->state;
    const struct mpm_pair_spec *const spec = &mpm_contact_spec(state)->pairs[pair->spec];
    solved->of[0] = (int)(pair->fields[0] - exchange->node->first_field);
    solved->of[1] = (int)(pair->fields[1] - exchange->node->first_field);
    solved->normal[0] = pair->has_normal ? pair->normal[0] : 1.0;
    solved->normal[1] = pair->has_normal ? pair->normal[1] : 0.0;
    solved->law = spec->law;
    solved->friction = spec->friction;
    solved->static_friction = spec->static_friction;
    solved->pull = spec->adhesion * pair->area * state->time_step;
    solved->approach = pair->gap > 0.0 ? pair->gap / state->time_step : 0.0;
}

static bool takes_part(const struct mpm_contact_pair *pair, enum mpm_pair_law law,
                       enum mpm_exchange_when when)
{
    switch (when) {
    case MPM_EXCHANGE_END:
        return pair->touches;
    case MPM_EXCHANGE_SMOOTHED:
        return pair->touches && law == MPM_PAIR_BONDED;
    case MPM_EXCHANGE_START:
    case MPM_EXCHANGE_EXTRAPOLATED:
        break;
    }
    return pair->touches && law != MPM_PAIR_INTERFACE;
}

static void add_pair(struct exchange *exchange, const struct mpm_contact_pair *pair)
{
    const int k = exchange->count++;
    struct mpm_solve_pair *const solved = &exchange->pairs[k];
    exchange->of[k] = pair;
    exchange->stiff[k] = false;
    prepare(exchange, pair, solved);
    if (solved->law != MPM_PAIR_INTERFACE)
        return;
    const struct mpm_contact_side *const sides[2] = {&exchange->before[solved->of[0]],
                                                     &exchange->before[solved->of[1]]};
    exchange->stiff[k] = mpm_interface_lines(exchange->state, pair, sides, solved->lines);
}

static int side_at(const struct exchange *exchange, int64_t node)
{
    const struct mpm_contact_node *const at = exchange->node;
    for (int k = 0; k < at->fields; k++)
        if (exchange->state->contact.fields[at->first_field + (uint32_t)k].node == node)
            return k;
    return -1;
}

/* Surfaces of a crack that touch; those found to be closed do not part either. */
static void add_touch(struct exchange *exchange, const struct mpm_exchange_touch *touch)
{
    static const enum mpm_pair_law laws[] = {
        [MPM_CONTACT_NONE] = MPM_PAIR_NONE,
        [MPM_CONTACT_STICK] = MPM_PAIR_STICK,
        [MPM_CONTACT_FRICTIONLESS] = MPM_PAIR_FRICTIONLESS,
        [MPM_CONTACT_FRICTION] = MPM_PAIR_FRICTION,
    };
    const struct mpm_solve_pair made = {
        .of = {side_at(exchange, touch->fields[0].node), side_at(exchange, touch->fields[1].node)},
        .normal = {touch->normal[0], touch->normal[1]},
        .law = laws[touch->law.kind],
        .friction = touch->law.friction,
        .static_friction = touch->law.friction,
        .pull = touch->law.if_approaching ? 0.0 : HUGE_VAL,
    };
    if (made.of[0] >= 0 && made.of[1] >= 0)
        exchange->pairs[exchange->count++] = made;
}

static void add_touches(struct exchange *exchange)
{
    const struct mpm_state *const state = exchange->state;
    const struct mpm_exchange_touch *const touches =
        state->contact.crack_touches == NULL || exchange->when == MPM_EXCHANGE_SMOOTHED
            ? NULL
            : state->contact.crack_touches(state, exchange->node->node);
    for (size_t k = 0; touches != NULL && k < touches->count; k++)
        add_touch(exchange, &touches[k]);
}

static void list_pairs(struct exchange *exchange)
{
    const struct mpm_state *const state = exchange->state;
    const struct mpm_contact_node *const node = exchange->node;
    for (int k = 0; k < node->fields; k++)
        exchange->before[k] = exchange->sides[k] =
            side_of(exchange, &state->contact.fields[node->first_field + (uint32_t)k]);
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++) {
        const struct mpm_contact_pair *const pair = &state->contact.pairs[k];
        if (takes_part(pair, mpm_contact_spec(state)->pairs[pair->spec].law, exchange->when))
            add_pair(exchange, pair);
    }
    exchange->of_bodies = exchange->count;
    add_touches(exchange);
}

/* The fields' velocities over the step, on average: of those that the particles follow. */
static void mean_velocity(const struct exchange *exchange, int side, double mean[2])
{
    const struct mpm_state *const state = exchange->state;
    const struct mpm_contact_field *const field =
        &state->contact.fields[exchange->node->first_field + (uint32_t)side];
    for (int axis = 0; axis < 2; axis++)
        mean[axis] = field->node < 0 ? 0.5 * (field->rigid_start[axis] + field->rigid_end[axis])
                                     : 0.5 * (state->grid.start[field->node][axis] +
                                              state->grid.motion[field->node].end[axis]);
}

/* Adds what a pair's impulse does to the sums of the step, velocities being those after it. */
static void count_pair(const struct exchange *exchange, int index)
{
    const struct mpm_state *const state = exchange->state;
    const struct mpm_solve_pair *const pair = &exchange->pairs[index];
    const bool is_interface = pair->law == MPM_PAIR_INTERFACE;
    struct mpm_contact_sample *const sample = &state->contact.samples[exchange->of[index]->spec];
    struct mpm_contact_totals *const totals = &state->contact.totals[exchange->of[index]->spec];
    double *const taken = is_interface ? &totals->work : &totals->dissipated;
    double one[2], other[2];
    if (pair->impulse[0] == 0.0 && pair->impulse[1] == 0.0 && !is_interface)
        return;
    mean_velocity(exchange, pair->of[0], one);
    mean_velocity(exchange, pair->of[1], other);
    for (int axis = 0; axis < 2; axis++) {
        *taken -= pair->impulse[axis] * (one[axis] - other[axis]);
        sample->force[axis] += pair->impulse[axis] / state->time_step;
    }
    if (is_interface) {
        sample->stored += mpm_interface_stored(state, exchange->of[index]);
        sample->stiff += exchange->stiff[index];
    }
    sample->area += exchange->of[index]->area;
    sample->nodes++;
}

/* What a rigid body gives, it works along its velocity. */
static void add_rigid_work(struct mpm_state *state, const struct mpm_contact_field *field,
                           const double impulse[2])
{
    for (int axis = 0; axis < 2; axis++)
        state->external_work -=
            impulse[axis] * 0.5 * (field->rigid_start[axis] + field->rigid_end[axis]);
}

static void give_impulses(const struct exchange *exchange)
{
    struct mpm_state *const state = exchange->state;
    for (int k = 0; k < exchange->node->fields; k++) {
        const struct mpm_contact_field *const field =
            &state->contact.fields[exchange->node->first_field + (uint32_t)k];
        const struct mpm_exchange_field exchanged = as_exchanged(field);
        double impulse[2] = {0.0, 0.0};
        for (int i = 0; i < exchange->count; i++) {
            const struct mpm_solve_pair *const pair = &exchange->pairs[i];
            for (int axis = 0; axis < 2 && pair->of[0] == k; axis++)
                impulse[axis] += pair->impulse[axis];
            for (int axis = 0; axis < 2 && pair->of[1] == k; axis++)
                impulse[axis] -= pair->impulse[axis];
        }
        if (field->node >= 0)
            mpm_exchange_give(state, exchange->when, &exchanged, &exchange->before[k], impulse);
        if (exchange->when != MPM_EXCHANGE_END)
            continue;
        if (field->node >= 0)
            state->contact.follow_impulse(state, field->node, &exchange->before[k], impulse);
        else
            add_rigid_work(state, field, impulse);
    }
}

static void resolve_node(struct mpm_state *state, enum mpm_exchange_when when,
                         const struct mpm_contact_node *node)
{
    struct exchange exchange; /* not cleared as a whole: it is large */
    exchange.state = state;
    exchange.when = when;
    exchange.node = node;
    exchange.of_bodies = exchange.count = 0;
    list_pairs(&exchange);
    if (exchange.count == 0)
        return;
    mpm_contact_solve(exchange.sides, exchange.pairs, exchange.count);
    give_impulses(&exchange);
    for (int k = 0; k < exchange.of_bodies && when == MPM_EXCHANGE_END; k++)
        count_pair(&exchange, k);
}

void mpm_body_contact_resolve(struct mpm_state *state, enum mpm_exchange_when when)
{
    for (size_t k = 0; k < state->contact.node_count; k++)
        if (mpm_node_is_inside(state, state->contact.nodes[k].node))
            resolve_node(state, when, &state->contact.nodes[k]);
}

void mpm_body_contact_smoothed(struct mpm_state *state)
{
    mpm_body_contact_resolve(state, MPM_EXCHANGE_SMOOTHED);
}
