/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"

#include "method/contact/body_contact.h"
#include "method/cracks/crack_detection.h"
#include "method/cracks/crack_fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------ contact */

static bool has_mass(const struct mpm_state *state, const struct mpm_crack_node *node,
                     enum mpm_crack_side side)
{
    return node->field[side] >= 0 && state->grid.mass[node->field[side]] != 0.0;
}

/* Do particles beyond different cracks share a field that has mass? */
static bool is_shared(const struct mpm_state *state, const struct mpm_crack_node *node,
                      enum mpm_crack_side side)
{
    return has_mass(state, node, side) && node->face[side]->crack != node->face[side]->last;
}

/* Is it unknown which surfaces the fields have? Also where three have mass of which two lie
 * beyond one crack, as a crack may have that bends within a node's reach. */
static bool is_crowded(const struct mpm_state *state, const struct mpm_crack_node *node)
{
    return is_shared(state, node, MPM_CRACK_ABOVE) || is_shared(state, node, MPM_CRACK_BELOW) ||
           (has_mass(state, node, MPM_CRACK_SAME_SIDE) && has_mass(state, node, MPM_CRACK_ABOVE) &&
            has_mass(state, node, MPM_CRACK_BELOW) &&
            node->face[MPM_CRACK_ABOVE]->crack == node->face[MPM_CRACK_BELOW]->crack);
}

static bool is_beside(const struct mpm_crack_node *node, size_t crack)
{
    for (int side = MPM_CRACK_ABOVE; side <= MPM_CRACK_BELOW; side++)
        if (node->field[side] >= 0 &&
            (node->face[side]->crack == crack || node->face[side]->last == crack))
            return true;
    return false;
}

size_t mpm_crack_contact_crowded(const struct mpm_state *state, size_t crack)
{
    size_t count = 0;
    for (size_t k = 0; k < state->fields.nodes_inside; k++) {
        const struct mpm_crack_node node = mpm_crack_node_of(state, k);
        count += is_beside(&node, crack) && is_crowded(state, &node);
    }
    return count;
}

/* The pairs of fields of a node that may touch: none, one, or two, with cracks on both sides. */
enum { PAIRS = 2 };
static int find_pairs(const struct mpm_state *state, const struct mpm_crack_node *node,
                      struct mpm_crack_pair pairs[PAIRS])
{
    static const enum mpm_crack_side order[3] = {MPM_CRACK_ABOVE, MPM_CRACK_SAME_SIDE,
                                                 MPM_CRACK_BELOW};
    enum mpm_crack_side massive[3];
    int fields = 0, count = 0;
    if (is_crowded(state, node))
        return 0;
    for (int k = 0; k < 3; k++)
        if (has_mass(state, node, order[k]))
            massive[fields++] = order[k];
    for (int k = 0; k + 1 < fields; k++)
        if (mpm_crack_pair_find(node, massive[k], massive[k + 1], &pairs[count]))
            count++;
    return count;
}

/* Of a limit: closer to it round-off must not decide, as at corners, which see a quarter of a cell.
 */
static const double EVEN = 1e-9;

/* The law by which a pair of fields exchanges momentum; false if they do not touch. */
static bool find_law(const struct mpm_state *state, const struct mpm_crack_node *node,
                     const struct mpm_crack_pair *pair, struct mpm_contact_law *law)
{
    const struct mpm_crack_spec *const spec = &state->scene->cracks[pair->crack];
    if (spec->contact == MPM_CONTACT_NONE)
        return false;
    const struct mpm_crack_volume volume = mpm_crack_volume_at(state, node, pair);
    if (volume.found < (1.0 - EVEN) * spec->separated * volume.closed)
        return false;
    *law = (struct mpm_contact_law){
        .kind = spec->contact,
        .friction = spec->friction,
        .if_approaching = volume.found <= (1.0 + EVEN) * spec->touching * volume.closed};
    return true;
}

void mpm_crack_contact_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    if (!mpm_cracks_have_contact(state->scene))
        return;
    state->cracks.touches =
        MPM_TAKE(arena, struct mpm_exchange_touch, PAIRS * state->fields.node_capacity);
    if (mpm_body_contact_is_used(state))
        state->cracks.touch_of = MPM_TAKE(arena, uint32_t, state->fields.node_capacity);
}

/* Masses, places and conditions stay as they are in the step. */
static void find_touches(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    cracks->touch_count = 0;
    for (size_t k = 0; k < state->fields.nodes_inside; k++) {
        const struct mpm_crack_node node = mpm_crack_node_of(state, k);
        struct mpm_exchange_touch *const touches = &cracks->touches[cracks->touch_count];
        struct mpm_crack_pair pairs[PAIRS];
        const int count = find_pairs(state, &node, pairs);
        int found = 0;
        for (int i = 0; i < count; i++) {
            struct mpm_exchange_touch *const touch = &touches[found];
            if (!find_law(state, &node, &pairs[i], &touch->law))
                continue;
            for (int side = 0; side < 2; side++)
                touch->fields[side] = (struct mpm_exchange_field){node.field[pairs[i].side[side]],
                                                                  node.held[pairs[i].side[side]]};
            memcpy(touch->normal, pairs[i].normal, sizeof touch->normal);
            found++;
        }
        for (int i = 0; i < found; i++)
            touches[i].count = (size_t)found;
        if (cracks->touch_of != NULL)
            cracks->touch_of[k] = found > 0 ? (uint32_t)cracks->touch_count + 1 : 0;
        cracks->touch_count += (size_t)found;
    }
}

const struct mpm_exchange_touch *mpm_crack_contact_touches(const struct mpm_state *state,
                                                           int64_t node)
{
    const struct mpm_field_node *const entry = mpm_field_node_at(state, node);
    const size_t place = entry == NULL ? 0 : (size_t)(entry - state->fields.nodes);
    if (entry == NULL || place >= state->fields.nodes_inside || state->cracks.touch_of[place] == 0)
        return NULL;
    return &state->cracks.touches[state->cracks.touch_of[place] - 1];
}

/* Do bodies meet at the node too? */
static bool is_left(const struct mpm_state *state, const struct mpm_exchange_touch *touch)
{
    return mpm_body_contact_is_used(state) &&
           state->contact.node_of[mpm_field_parent(state, touch->fields[0].node)] != 0;
}

/* A field between two cracks takes part in two exchanges: each undoes a part of the other, and what
 * is left becomes less by a factor m_1 m_3 / ((m_1 + m_2)(m_2 + m_3)) or so each time. */
enum { EXCHANGES = 24 };

void mpm_crack_contact_resolve(struct mpm_state *state, enum mpm_exchange_when when)
{
    const struct mpm_cracks *const cracks = &state->cracks;
    if (!mpm_cracks_have_contact(state->scene))
        return;
    if (when == MPM_EXCHANGE_START)
        find_touches(state);
    for (size_t k = 0; k < cracks->touch_count; k += cracks->touches[k].count) {
        const size_t count = cracks->touches[k].count;
        if (is_left(state, &cracks->touches[k]))
            continue;
        for (size_t i = 0; i < (count == 1 ? 1 : count * EXCHANGES); i++) {
            const struct mpm_exchange_touch *const touch = &cracks->touches[k + i % count];
            mpm_exchange(state, when, touch->fields, touch->normal, &touch->law);
        }
    }
}

/* ------------------------------------------------------------------- motion */

/* Velocities at the end of a step have no bound at nodes of little mass, which a force divides by;
 * those at the start are means of the particles' velocities. The part of the end grows with the
 * mass, from 0 at the first of these to 1 at the second, in least masses (1/8 and 3/8 of the
 * lightest particle). A jump would let round-off decide: a row of particles gives its nodes simple
 * fractions of a particle's mass. */
static const double LIGHT[2] = {125.0, 375.0};

static double part_of_end(const struct mpm_state *state, int64_t field)
{
    const double mass = mpm_symmetry_whole_mass(state, field);
    const double part = (mass / state->cracks.least_mass - LIGHT[0]) / (LIGHT[1] - LIGHT[0]);
    return part > 1.0 ? 1.0 : part > 0.0 ? part : 0.0;
}

/* Momentum and mass of all fields of a node. */
static double node_momentum(const struct mpm_state *state, int64_t parent, double momentum[2])
{
    const struct mpm_field_node *const node = mpm_field_node_at(state, parent);
    const int64_t others = node == NULL ? 0 : mpm_fields_first(state) + node->first;
    double mass = 0.0;
    momentum[0] = momentum[1] = 0.0;
    for (int k = 0; k <= (node == NULL ? 0 : node->count); k++) {
        const int64_t field = k == 0 ? parent : others + k - 1;
        const double m = state->grid.mass[field];
        const double *const start = state->grid.start[field];
        const double part = part_of_end(state, field);
        const double *const end = part > 0.0 ? state->grid.motion[field].end : start;
        mass += m;
        for (int axis = 0; axis < 2; axis++)
            momentum[axis] += m * ((1.0 - part) * start[axis] + part * end[axis]);
    }
    return mass;
}

/* False, and zero, where no node in reach has mass to speak of. */
static bool point_velocity(const struct mpm_state *state, size_t point, double v[2])
{
    const double place[2] = {state->cracks.position[0][point], state->cracks.position[1][point]};
    struct mpm_stencil stencil;
    const struct mpm_shape_domain domain = {.position = {place[0], place[1]}};
    double weight = 0.0;
    v[0] = v[1] = 0.0;
    mpm_shape_classic.evaluate(&state->shape_grid, &domain, &stencil);
    for (int k = 0; k < stencil.count; k++) {
        const int64_t node = state->node_zero + stencil.node[k].node;
        double momentum[2] = {0.0, 0.0};
        const double mass =
            mpm_node_is_reached(state, node) ? node_momentum(state, node, momentum) : 0.0;
        if (!(mass >= state->cracks.least_mass))
            continue;
        weight += stencil.node[k].s;
        for (int axis = 0; axis < 2; axis++)
            v[axis] += stencil.node[k].s * momentum[axis] / mass;
    }
    for (int axis = 0; axis < 2 && weight > 0.0; axis++)
        v[axis] /= weight;
    return weight > 0.0;
}

/* The points of a crack before and after the one in hand that nodes move. */
struct carriers {
    bool any;             /* is there one before? */
    size_t before, after; /* `after` is up to date if it is behind `before` */
    double velocity[2], ahead[2];
};

/* Points that no node moves lie in the gap of an open crack, if points on both sides do move: they
 * go with them. Else they are outside of all bodies, and stay where they are. */
static void carried_velocity(const struct mpm_state *state, size_t point, size_t end,
                             struct carriers *carriers, double v[2])
{
    v[0] = v[1] = 0.0;
    if (!carriers->any)
        return;
    if (carriers->after <= carriers->before)
        for (carriers->after = point + 1; carriers->after < end; carriers->after++)
            if (point_velocity(state, carriers->after, carriers->ahead))
                break;
    const double part =
        (double)(point - carriers->before) / (double)(carriers->after - carriers->before);
    for (int axis = 0; axis < 2 && carriers->after < end; axis++)
        v[axis] = (1.0 - part) * carriers->velocity[axis] + part * carriers->ahead[axis];
}

static enum mpm_status advance_point(const struct mpm_state *state, size_t crack, size_t k,
                                     const double v[2], struct mpm_error *error)
{
    const struct mpm_cracks *const cracks = &state->cracks;
    const double place[2] = {cracks->position[0][k], cracks->position[1][k]};
    for (int axis = 0; axis < 2; axis++) {
        const double low = state->grid.origin[axis], high = mpm_grid_end(&state->grid, axis);
        const bool held = (cracks->held[k] >> axis & 1) != 0;
        const double moved = place[axis] + (held ? 0.0 : state->time_step * v[axis]);
        const double slack = MPM_CRACK_EDGE_SLACK * state->grid.cell[axis];
        if (!(moved >= low - slack && moved <= high + slack))
            return mpm_error_fail(
                error, MPM_CAUSE_LEFT_GRID,
                "a point of cracks.%zu left the grid from (%g, %g): %s coordinate "
                "%g; allowed: %g to %g",
                crack, place[0], place[1], axis == 0 ? "first" : "second", moved, low, high);
        cracks->position[axis][k] = moved;
    }
    return MPM_OK;
}

static enum mpm_status check_lengths(const struct mpm_state *state, size_t crack,
                                     struct mpm_error *error)
{
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    const double side = fmin(state->grid.cell[0], state->grid.cell[1]);
    const double longest = MPM_CRACK_LONGEST * side;
    for (size_t k = 0; k + 1 < chain->count; k++) {
        const double along[2] = {chain->x[k + 1] - chain->x[k], chain->y[k + 1] - chain->y[k]};
        const double square = along[0] * along[0] + along[1] * along[1];
        if (!(square <= longest * longest))
            return mpm_error_fail(
                error, MPM_CAUSE_CRACK,
                "a segment of cracks.%zu was stretched, from (%g, %g) to (%g, %g): "
                "length %g shorter cell sides; allowed: up to %d",
                crack, chain->x[k], chain->y[k], chain->x[k + 1], chain->y[k + 1],
                sqrt(square) / side, MPM_CRACK_LONGEST);
    }
    return MPM_OK;
}

enum mpm_status mpm_cracks_check(const struct mpm_state *state, struct mpm_error *error)
{
    static const double still[2] = {0.0, 0.0};
    for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
        const size_t first = mpm_crack_first_point(state, crack);
        for (size_t k = 0; k < state->cracks.chains[crack].count; k++)
            MPM_TRY(advance_point(state, crack, first + k, still, error));
        MPM_TRY(check_lengths(state, crack, error));
    }
    return MPM_OK;
}

void mpm_cracks_reflect(struct mpm_state *state)
{
    double *const *const position = state->cracks.position;
    for (size_t k = 0; k < state->cracks.image_count; k++) {
        const struct mpm_crack_image *const image = &state->cracks.images[k];
        const int other = 1 - image->axis;
        position[image->axis][image->point] = 2.0 * image->plane - position[image->axis][image->of];
        position[other][image->point] = position[other][image->of];
    }
}

enum mpm_status mpm_cracks_advance(struct mpm_state *state, struct mpm_error *error)
{
    for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
        size_t k = mpm_crack_first_point(state, crack);
        const size_t end = k + chain->count;
        struct carriers carriers = {.any = false};
        for (; k < end; k++) {
            double v[2];
            if (point_velocity(state, k, v)) {
                carriers.any = true;
                carriers.before = k;
                memcpy(carriers.velocity, v, sizeof v);
            } else {
                carried_velocity(state, k, end, &carriers, v);
            }
            MPM_TRY(advance_point(state, crack, k, v, error));
        }
    }
    mpm_cracks_reflect(state);
    for (size_t crack = 0; crack < state->scene->crack_count; crack++)
        MPM_TRY(check_lengths(state, crack, error));
    return MPM_OK;
}
