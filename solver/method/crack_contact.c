/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/crack_contact.h"

#include "method/crack_detection.h"
#include "method/crack_fields.h"
#include "method/grid_update.h"
#include "method/transfer.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------ contact */

/* The fields that have mass, the one above first, and how many they are: one, two, or three, as a
 * bent crack may ask for. Only a pair may be in contact. */
static int find_massive(const struct mpm_state *state, const struct mpm_crack_node *node,
                        enum mpm_crack_side massive[3])
{
    static const enum mpm_crack_side order[3] = {MPM_CRACK_ABOVE, MPM_CRACK_SAME_SIDE,
                                                 MPM_CRACK_BELOW};
    int count = 0;
    for (int k = 0; k < 3; k++) {
        const int64_t field = node->field[order[k]];
        if (field >= 0 && state->grid.mass[field] != 0.0)
            massive[count++] = order[k];
    }
    return count;
}

size_t mpm_crack_contact_crowded(const struct mpm_state *state, size_t crack)
{
    size_t count = 0;
    for (size_t k = 0; k < state->cracks.node_count; k++) {
        const struct mpm_crack_node *const node = &state->cracks.nodes[k];
        enum mpm_crack_side massive[3];
        count += node->crack == crack && find_massive(state, node, massive) > 2;
    }
    return count;
}

static bool unit_normal(const struct mpm_crack_node *node, double normal[2])
{
    const double length =
        sqrt(node->normal[0] * node->normal[0] + node->normal[1] * node->normal[1]);
    if (!(length > 0.0))
        return false;
    normal[0] = node->normal[0] / length;
    normal[1] = node->normal[1] / length;
    return true;
}

/* What the field above gets, below with the opposite sign: momentum, (13), (17)-(19). `to_common`
 * is what would make both velocities one, along the normal and along the crack. */
static void limit_exchange(const struct mpm_crack_spec *spec, double to_common[2])
{
    const double pressed = fabs(to_common[0]), dragged = fabs(to_common[1]);
    if (spec->contact == MPM_CONTACT_STICK ||
        (spec->contact == MPM_CONTACT_FRICTION && dragged <= spec->friction * pressed))
        return;
    to_common[1] = spec->contact == MPM_CONTACT_FRICTION
                       ? copysign(spec->friction * pressed, to_common[1])
                       : 0.0;
}

/* The exchange of momentum that contact asks for, given the velocities above and below; false if
 * they do not touch. */
static bool find_exchange(const struct mpm_state *state, const struct mpm_crack_node *node,
                          const enum mpm_crack_side pair[2], const double above[2],
                          const double below[2], double exchange[2])
{
    const struct mpm_crack_spec *const spec = &state->scene->cracks[node->crack];
    double n[2];
    if (spec->contact == MPM_CONTACT_NONE || !unit_normal(node, n))
        return false;
    const struct mpm_crack_volume volume = mpm_crack_volume_at(state, node, pair, n);
    if (volume.found < spec->separated * volume.closed)
        return false;
    const double difference[2] = {above[0] - below[0], above[1] - below[1]};
    const double approach = difference[0] * n[0] + difference[1] * n[1];
    if (volume.found <= spec->touching * volume.closed && approach <= 0.0)
        return false;
    const double ma = state->grid.mass[node->field[pair[0]]],
                 mb = state->grid.mass[node->field[pair[1]]];
    const double reduced = ma * mb / (ma + mb);
    const double sliding = difference[1] * n[0] - difference[0] * n[1];
    double to_common[2] = {-reduced * approach, -reduced * sliding};
    limit_exchange(spec, to_common);
    exchange[0] = to_common[0] * n[0] - to_common[1] * n[1];
    exchange[1] = to_common[0] * n[1] + to_common[1] * n[0];
    return true;
}

/* Changes the velocities of all fields in contact. */
static void resolve(struct mpm_state *state,
                    void (*read)(const struct mpm_state *, int64_t, double[2]),
                    void (*change)(const struct mpm_state *, int64_t, const double[2]))
{
    for (size_t k = 0; k < state->cracks.node_count; k++) {
        const struct mpm_crack_node *const node = &state->cracks.nodes[k];
        enum mpm_crack_side pair[3];
        double v[2][2], exchange[2];
        if (node->crack == SIZE_MAX || find_massive(state, node, pair) != 2)
            continue;
        const int64_t field[2] = {node->field[pair[0]], node->field[pair[1]]};
        read(state, field[0], v[0]);
        read(state, field[1], v[1]);
        if (!find_exchange(state, node, pair, v[0], v[1], exchange))
            continue;
        for (int side = 0; side < 2; side++) {
            const double scale = (side == 0 ? 1.0 : -1.0) / state->grid.mass[field[side]];
            change(state, field[side], (const double[2]){scale * exchange[0], scale * exchange[1]});
        }
    }
}

static void read_start(const struct mpm_state *state, int64_t node, double v[2])
{
    v[0] = state->grid.start[node][0];
    v[1] = state->grid.start[node][1];
}

static void change_start(const struct mpm_state *state, int64_t node, const double by[2])
{
    for (int axis = 0; axis < 2; axis++)
        state->grid.start[node][axis] += by[axis];
    if (state->order->before > 0.0)
        mpm_node_set_gradient(&state->grid, node, state->grid.start[node]);
}

static void read_end(const struct mpm_state *state, int64_t node, double v[2])
{
    v[0] = state->grid.motion[node].end[0];
    v[1] = state->grid.motion[node].end[1];
}

static void change_end(const struct mpm_state *state, int64_t node, const double by[2])
{
    struct mpm_node_motion *const motion = &state->grid.motion[node];
    for (int axis = 0; axis < 2; axis++) {
        motion->end[axis] += by[axis];
        motion->acceleration[axis] += by[axis] / state->time_step;
    }
    if (!state->order->extrapolate)
        mpm_node_set_gradient(&state->grid, node, motion->end);
}

static void read_extrapolated(const struct mpm_state *state, int64_t node, double v[2])
{
    v[0] = state->grid.gradient[node][0][0];
    v[1] = state->grid.gradient[node][1][0];
}

static void change_extrapolated(const struct mpm_state *state, int64_t node, const double by[2])
{
    double v[2];
    read_extrapolated(state, node, v);
    mpm_node_set_gradient(&state->grid, node, (const double[2]){v[0] + by[0], v[1] + by[1]});
}

void mpm_crack_contact_start(struct mpm_state *state)
{
    resolve(state, read_start, change_start);
}

void mpm_crack_contact_end(struct mpm_state *state)
{
    resolve(state, read_end, change_end);
}

void mpm_crack_contact_extrapolated(struct mpm_state *state)
{
    resolve(state, read_extrapolated, change_extrapolated);
}

/* ------------------------------------------------------------------- motion */

/* Velocities at the end of a step have no bound at nodes of little mass, which a force divides by;
 * those at the start are means of the particles' velocities. */
static const double LIGHT = 250.0; /* of the least mass */

/* Momentum and mass of all fields of a node. */
static double node_momentum(const struct mpm_state *state, int64_t home, double momentum[2])
{
    const struct mpm_crack_node *const node = mpm_crack_node_at(state, home);
    const int64_t own[1] = {home};
    const int64_t *const fields = node == NULL ? own : node->field;
    double mass = 0.0;
    momentum[0] = momentum[1] = 0.0;
    for (int k = 0; k < (node == NULL ? 1 : 3); k++) {
        if (fields[k] < 0)
            continue;
        const double m = state->grid.mass[fields[k]];
        const double *const velocity = m < LIGHT * state->cracks.least_mass
                                           ? state->grid.start[fields[k]]
                                           : state->grid.motion[fields[k]].end;
        mass += m;
        for (int axis = 0; axis < 2; axis++)
            momentum[axis] += m * velocity[axis];
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
            mpm_node_is_active(state, node) ? node_momentum(state, node, momentum) : 0.0;
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
        const double low = state->grid.origin[axis];
        const double high = low + (double)state->grid.cells[axis] * state->grid.cell[axis];
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
        MPM_TRY(check_lengths(state, crack, error));
    }
    return MPM_OK;
}
