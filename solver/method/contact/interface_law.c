/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/interface_law.h"

#include "method/contact/shared_nodes.h"
#include "method/grid/grid_update.h"

#include <math.h>

/* A pair at a node: its fields, and directions along the normal and along the surface. */
struct joint {
    struct mpm_state *state;
    const struct mpm_pair_spec *spec;
    struct mpm_contact_pair *pair;
    const struct mpm_contact_field *fields[2];
    double along[2][2];
};

static struct joint joint_of(struct mpm_state *state, struct mpm_contact_pair *pair)
{
    const double *const n = pair->normal;
    return (struct joint){
        .state = state,
        .spec = &mpm_contact_spec(state)->pairs[pair->spec],
        .pair = pair,
        .fields = {&state->contact.fields[pair->fields[0]],
                   &state->contact.fields[pair->fields[1]]},
        .along = {{n[0], n[1]}, {-n[1], n[0]}},
    };
}

/* D along the normal or the surface, times the area. */
static double stiffness(const struct joint *joint, int direction, double jump)
{
    const struct mpm_pair_spec *const spec = joint->spec;
    const double d = direction == 1 ? spec->shear : jump > 0.0 ? spec->tension : spec->compression;
    return d * joint->pair->area;
}

/* The jump that the strains know of. Orders of update that strain by velocities other than those
 * that move the particles, v^{n+1}, have strains of the nodes' velocity v before it; places are
 * ahead of them by dt (W - v), with W the field that particles read their velocities from. Without
 * this, surfaces pull by a jump that is ahead of the strains beside it, which feeds energy. */
static double strained_jump(const struct joint *joint, int direction)
{
    const struct mpm_state *const state = joint->state;
    const struct mpm_stress_order *const order = state->order;
    const double part = order->extrapolate ? 1.0 : order->before;
    const double lag = state->scene->position_update == MPM_MIDPOINT ? 0.5 : 0.0;
    double opening = 0.0;
    for (int k = 0; k < 2; k++) {
        const struct mpm_contact_field *const field = joint->fields[k];
        for (int axis = 0; axis < 2 && field->node >= 0; axis++)
            opening += (k == 0 ? -1.0 : 1.0) * state->grid.start[field->node][axis] *
                       joint->along[direction][axis];
    }
    return joint->pair->jump[direction] -
           state->time_step * ((part - lag) * joint->pair->rate[direction] - part * opening);
}

/* All interfaces of a node, with the velocities of its fields after the impulses so far. */
enum { PAIRS = MPM_CONTACT_FIELDS * (MPM_CONTACT_FIELDS - 1) / 2 };
struct pulling {
    const struct mpm_contact_node *node;
    struct mpm_contact_side sides[MPM_CONTACT_FIELDS], before[MPM_CONTACT_FIELDS];
    struct joint joints[PAIRS];
    double impulse[PAIRS][2]; /* on the first field, along the normal and the surface */
    int count;
};

/* Between several interfaces changes below this part of the largest impulse are round-off. */
static const double SETTLED = 1e-15;
enum { SWEEPS = 2000 };

static struct mpm_contact_side *side_at(struct pulling *pulling, int joint, int k)
{
    return &pulling->sides[pulling->joints[joint].pair->fields[k] - pulling->node->first_field];
}

/* How fast the jump along a direction grows by itself. */
static double free_opening(const struct pulling *pulling, int index, int direction)
{
    const struct joint *const joint = &pulling->joints[index];
    double opening = 0.0;
    for (int k = 0; k < 2; k++) {
        const uint32_t side = joint->pair->fields[k] - pulling->node->first_field;
        for (int axis = 0; axis < 2; axis++)
            opening += (k == 0 ? -1.0 : 1.0) * pulling->before[side].velocity[axis] *
                       joint->along[direction][axis];
    }
    return opening;
}

/* What the impulse along one direction lacks, as if it alone changed. */
static double lacking(struct pulling *pulling, int index, int direction, bool *stiff)
{
    const struct joint *const joint = &pulling->joints[index];
    const struct mpm_contact_side *const one = side_at(pulling, index, 0), *const other = side_at(
                                                                               pulling, index, 1);
    const double *const along = joint->along[direction];
    const double dt = joint->state->time_step, jump = strained_jump(joint, direction);
    /* the sign of where the step leads: that of a jump of round-off would choose at random */
    const double k =
        stiffness(joint, direction, jump + dt * free_opening(pulling, index, direction));
    double mobility = 0.0, opening = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        mobility += (one->mobility[axis] + other->mobility[axis]) * along[axis] * along[axis];
        opening += (other->velocity[axis] - one->velocity[axis]) * along[axis];
    }
    const double kappa = k * mobility * dt * dt;
    const double alpha = kappa * kappa / (1.0 + kappa * kappa);
    *stiff = *stiff || kappa > 1.0;
    return (dt * k * (jump + alpha * dt * opening) - pulling->impulse[index][direction]) /
           (1.0 + alpha * kappa);
}

static void change(struct pulling *pulling, int index, const double by[2])
{
    const struct joint *const joint = &pulling->joints[index];
    struct mpm_contact_side *const one = side_at(pulling, index, 0), *const other =
                                                                         side_at(pulling, index, 1);
    for (int axis = 0; axis < 2; axis++) {
        const double impulse = by[0] * joint->along[0][axis] + by[1] * joint->along[1][axis];
        one->velocity[axis] += one->mobility[axis] * impulse;
        other->velocity[axis] -= other->mobility[axis] * impulse;
    }
}

/* All interfaces at once, each by `share` of what it lacks. Returns whether anything has changed.
 */
static bool sweep(struct pulling *pulling, double share, bool stiff[PAIRS])
{
    double by[PAIRS][2], largest = 0.0, changed = 0.0;
    for (int k = 0; k < pulling->count; k++)
        for (int direction = 0; direction < 2; direction++)
            by[k][direction] = share * lacking(pulling, k, direction, &stiff[k]);
    for (int k = 0; k < pulling->count; k++) {
        change(pulling, k, by[k]);
        for (int direction = 0; direction < 2; direction++) {
            pulling->impulse[k][direction] += by[k][direction];
            largest = fmax(largest, fabs(pulling->impulse[k][direction]));
            changed = fmax(changed, fabs(by[k][direction]));
        }
    }
    return changed > SETTLED * largest;
}

static void give(struct mpm_state *state, const struct pulling *pulling)
{
    for (int k = 0; k < pulling->node->fields; k++) {
        const uint32_t place = pulling->node->first_field + (uint32_t)k;
        const struct mpm_contact_field *const field = &state->contact.fields[place];
        const struct mpm_exchange_field exchanged = {field->node, field->held};
        double given[2] = {0.0, 0.0};
        for (int i = 0; i < pulling->count; i++)
            for (int axis = 0; axis < 2; axis++) {
                const struct mpm_contact_pair *const pair = pulling->joints[i].pair;
                given[axis] += pair->fields[0] == place   ? pair->pull[axis]
                               : pair->fields[1] == place ? -pair->pull[axis]
                                                          : 0.0;
            }
        if (field->node < 0)
            continue;
        mpm_exchange_give(state, MPM_EXCHANGE_END, &exchanged, &pulling->before[k], given);
        state->contact.follow_impulse(state, field->node, &pulling->before[k], given);
    }
}

static void note_pull(struct pulling *pulling, int index, bool stiff)
{
    const struct joint *const joint = &pulling->joints[index];
    struct mpm_contact_sample *const sample = &joint->state->contact.samples[joint->pair->spec];
    for (int axis = 0; axis < 2; axis++) {
        joint->pair->pull[axis] = pulling->impulse[index][0] * joint->along[0][axis] +
                                  pulling->impulse[index][1] * joint->along[1][axis];
        sample->force[axis] += joint->pair->pull[axis] / joint->state->time_step;
    }
    sample->area += joint->pair->area;
    sample->nodes++;
    sample->stiff += stiff;
}

/* One interface: the equation of body_contact.h. Several of them: all change at once, each by
 * 1/(fields - 1) of what it lacks alone, until nothing changes, as in contact_solve.h. */
static void pull(struct mpm_state *state, struct pulling *pulling)
{
    const int fields = pulling->node->fields;
    const double share = pulling->count > 1 && fields > 2 ? 1.0 / (fields - 1) : 1.0;
    const int sweeps = pulling->count > 1 ? SWEEPS : 1;
    bool stiff[PAIRS] = {false};
    for (int k = 0; k < fields; k++) {
        const struct mpm_contact_field *const field =
            &state->contact.fields[pulling->node->first_field + (uint32_t)k];
        const struct mpm_exchange_field exchanged = {field->node, field->held};
        if (field->node >= 0)
            pulling->before[k] = pulling->sides[k] =
                mpm_exchange_side(state, MPM_EXCHANGE_END, &exchanged);
    }
    for (int k = 0; k < sweeps && sweep(pulling, share, stiff); k++)
        continue;
    for (int k = 0; k < pulling->count; k++)
        note_pull(pulling, k, stiff[k]);
    give(state, pulling);
}

/* Work that the impulse takes from the nodes, and the energy that the jump at the end of the step
 * stores. */
static void count(const struct joint *joint)
{
    const struct mpm_state *const state = joint->state;
    double mean[2] = {0.0, 0.0}, end[2] = {0.0, 0.0};
    for (int k = 0; k < 2; k++) {
        const struct mpm_contact_field *const field = joint->fields[k];
        const double sign = k == 0 ? 1.0 : -1.0;
        for (int axis = 0; axis < 2; axis++) {
            const double after = state->grid.motion[field->node].end[axis];
            mean[axis] += sign * 0.5 * (state->grid.start[field->node][axis] + after);
            end[axis] -= sign * after;
        }
    }
    for (int axis = 0; axis < 2; axis++)
        state->contact.totals[joint->pair->spec].work -= joint->pair->pull[axis] * mean[axis];
    for (int direction = 0; direction < 2; direction++) {
        const double *const along = joint->along[direction];
        const double jump = joint->pair->jump[direction] +
                            state->time_step * (end[0] * along[0] + end[1] * along[1]);
        state->contact.samples[joint->pair->spec].stored +=
            0.5 * stiffness(joint, direction, jump) * jump * jump;
    }
}

/* The interfaces of a node; none beyond a plane. */
static struct pulling interfaces_at(struct mpm_state *state, const struct mpm_contact_node *node)
{
    struct pulling pulling = {.node = node, .count = 0};
    for (uint32_t i = node->first_pair; i < node->first_pair + node->pairs; i++) {
        const struct joint joint = joint_of(state, &state->contact.pairs[i]);
        if (joint.spec->law == MPM_PAIR_INTERFACE && joint.pair->has_normal &&
            mpm_node_is_inside(state, node->node))
            pulling.joints[pulling.count++] = joint;
    }
    return pulling;
}

void mpm_interfaces_pull(struct mpm_state *state)
{
    for (size_t k = 0; k < state->contact.node_count; k++) {
        struct pulling pulling = interfaces_at(state, &state->contact.nodes[k]);
        if (pulling.count > 0)
            pull(state, &pulling);
    }
}

void mpm_interfaces_count(struct mpm_state *state)
{
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct pulling pulling = interfaces_at(state, &state->contact.nodes[k]);
        for (int i = 0; i < pulling.count; i++)
            count(&pulling.joints[i]);
    }
}
