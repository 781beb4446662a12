/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_contact.h"

#include "method/cracks/contact_impulse.h"
#include "method/cracks/crack_detection.h"
#include "method/fields/crack_fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"

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
    return has_mass(state, node, side) && node->face[side].crack != node->face[side].last;
}

/* Do the fields not tell which surfaces they have? Also where three have mass of which two lie
 * beyond one crack, as it may ask for that bends within a node's reach. */
static bool is_crowded(const struct mpm_state *state, const struct mpm_crack_node *node)
{
    const struct mpm_crack_face *const face = node->face;
    return is_shared(state, node, MPM_CRACK_ABOVE) || is_shared(state, node, MPM_CRACK_BELOW) ||
           (has_mass(state, node, MPM_CRACK_SAME_SIDE) && has_mass(state, node, MPM_CRACK_ABOVE) &&
            has_mass(state, node, MPM_CRACK_BELOW) &&
            face[MPM_CRACK_ABOVE].crack == face[MPM_CRACK_BELOW].crack);
}

static bool is_beside(const struct mpm_crack_node *node, size_t crack)
{
    for (int side = MPM_CRACK_ABOVE; side <= MPM_CRACK_BELOW; side++)
        if (node->field[side] >= 0 &&
            (node->face[side].crack == crack || node->face[side].last == crack))
            return true;
    return false;
}

size_t mpm_crack_contact_crowded(const struct mpm_state *state, size_t crack)
{
    size_t count = 0;
    for (size_t k = 0; k < state->cracks.node_count; k++) {
        const struct mpm_crack_node *const node = &state->cracks.nodes[k];
        count += is_beside(node, crack) && is_crowded(state, node);
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

/* A pair of fields, the one above first, as their exchange sees them. */
static struct mpm_contact_side side_of(const struct mpm_state *state,
                                       const struct mpm_crack_node *node, enum mpm_crack_side field,
                                       const double velocity[2])
{
    const double mobility = 1.0 / state->grid.mass[node->field[field]];
    struct mpm_contact_side side = {{velocity[0], velocity[1]}, {mobility, mobility}};
    for (int axis = 0; axis < 2; axis++)
        if ((node->held[field] >> axis & 1) != 0)
            side.mobility[axis] = 0.0;
    return side;
}

/* The impulse that contact gives to the field above, and the opposite to the one below; false if
 * they do not touch. */
static bool find_impulse(const struct mpm_state *state, const struct mpm_crack_node *node,
                         const struct mpm_crack_pair *pair, const struct mpm_contact_side sides[2],
                         double impulse[2])
{
    const struct mpm_crack_spec *const spec = &state->scene->cracks[pair->crack];
    if (spec->contact == MPM_CONTACT_NONE)
        return false;
    const struct mpm_crack_volume volume = mpm_crack_volume_at(state, node, pair);
    if (volume.found < spec->separated * volume.closed)
        return false;
    if (volume.found <= spec->touching * volume.closed &&
        mpm_contact_approach(sides, pair->normal) <= 0.0)
        return false;
    mpm_contact_impulse(spec->contact, spec->friction, sides, pair->normal, impulse);
    return true;
}

/* How one of the velocities of a node is read, and changed. */
struct velocities {
    void (*read)(const struct mpm_state *, int64_t, double[2]);
    void (*change)(const struct mpm_state *, int64_t, const double[2]);
    bool moves; /* particles: what conditions bear does work */
};

/* A node of the grid changes together with its images beyond planes of symmetry. */
static void change_field(const struct mpm_state *state, const struct velocities *velocities,
                         int64_t field, const double by[2])
{
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    velocities->change(state, field, by);
    if (state->symmetries.count == 0 || field >= state->grid.columns * state->grid.rows)
        return;
    const int count = mpm_symmetry_images(state, field, images);
    for (int k = 0; k < count; k++)
        velocities->change(state, images[k].node,
                           (const double[2]){images[k].sign[0] * by[0], images[k].sign[1] * by[1]});
}

/* A condition that holds a component gives the opposite of the impulse there, and works along its
 * velocity. */
static void add_reaction_work(struct mpm_state *state, int64_t field,
                              const struct mpm_contact_side *side, double sign,
                              const double impulse[2])
{
    if (!mpm_node_is_inside(state, field))
        return;
    for (int axis = 0; axis < 2; axis++)
        if (side->mobility[axis] == 0.0)
            state->external_work -=
                sign * impulse[axis] * 0.5 *
                (state->grid.start[field][axis] + state->grid.motion[field].end[axis]);
}

static void resolve_pair(struct mpm_state *state, const struct velocities *velocities,
                         const struct mpm_crack_node *node, const struct mpm_crack_pair *pair)
{
    struct mpm_contact_side sides[2];
    double v[2], impulse[2];
    for (int k = 0; k < 2; k++) {
        velocities->read(state, node->field[pair->side[k]], v);
        sides[k] = side_of(state, node, pair->side[k], v);
    }
    if (!find_impulse(state, node, pair, sides, impulse))
        return;
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1.0 : -1.0, *const mobility = sides[k].mobility;
        change_field(
            state, velocities, node->field[pair->side[k]],
            (const double[2]){sign * mobility[0] * impulse[0], sign * mobility[1] * impulse[1]});
        if (velocities->moves)
            add_reaction_work(state, node->field[pair->side[k]], &sides[k], sign, impulse);
    }
}

/* A field between two cracks takes part in two exchanges: each undoes a part of the other, and what
 * is left becomes less by a factor m_1 m_3 / ((m_1 + m_2)(m_2 + m_3)) or so each time. */
enum { EXCHANGES = 24 };

/* Changes the velocities of all fields in contact. */
static void resolve(struct mpm_state *state, const struct velocities *velocities)
{
    for (size_t k = 0; k < state->cracks.node_count; k++) {
        const struct mpm_crack_node *const node = &state->cracks.nodes[k];
        struct mpm_crack_pair pairs[PAIRS];
        const int count = find_pairs(state, node, pairs);
        for (int i = 0; count > 0 && i < (count == 1 ? 1 : count * EXCHANGES); i++)
            resolve_pair(state, velocities, node, &pairs[i % count]);
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
    static const struct velocities at_start = {read_start, change_start, false};
    resolve(state, &at_start);
}

void mpm_crack_contact_end(struct mpm_state *state)
{
    static const struct velocities at_end = {read_end, change_end, true};
    resolve(state, &at_end);
}

void mpm_crack_contact_extrapolated(struct mpm_state *state)
{
    static const struct velocities at_extrapolated = {read_extrapolated, change_extrapolated,
                                                      false};
    resolve(state, &at_extrapolated);
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
