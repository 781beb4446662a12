/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/interface_law.h"

#include "method/contact/shared_nodes.h"

/* A pair at a node: its fields, and directions along the normal and along the surface. */
struct joint {
    const struct mpm_state *state;
    const struct mpm_pair_spec *spec;
    const struct mpm_contact_pair *pair;
    int64_t nodes[2];
    double along[2][2];
};

static struct joint joint_of(const struct mpm_state *state, const struct mpm_contact_pair *pair)
{
    const double *const n = pair->normal;
    return (struct joint){
        .state = state,
        .spec = &mpm_contact_spec(state)->pairs[pair->spec],
        .pair = pair,
        .nodes = {state->contact.fields[pair->fields[0]].node,
                  state->contact.fields[pair->fields[1]].node},
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

/* How fast the jump grows along a direction, by the velocities of both fields. */
static double opening(const double first[2], const double second[2], const double along[2])
{
    return (second[0] - first[0]) * along[0] + (second[1] - first[1]) * along[1];
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
    const double start = opening(state->grid.start[joint->nodes[0]],
                                 state->grid.start[joint->nodes[1]], joint->along[direction]);
    return joint->pair->jump[direction] -
           state->time_step * ((part - lag) * joint->pair->rate[direction] - part * start);
}

bool mpm_interface_lines(const struct mpm_state *state, const struct mpm_contact_pair *pair,
                         const struct mpm_contact_side *const sides[2],
                         struct mpm_solve_line lines[2])
{
    const struct joint joint = joint_of(state, pair);
    const double dt = state->time_step;
    bool stiff = false;
    for (int direction = 0; direction < 2; direction++) {
        const double *const along = joint.along[direction];
        const double jump = strained_jump(&joint, direction);
        /* the sign of where the step leads: that of a jump of round-off would choose at random */
        const double leads = jump + dt * opening(sides[0]->velocity, sides[1]->velocity, along);
        const double k = stiffness(&joint, direction, leads);
        double mobility = 0.0;
        for (int axis = 0; axis < 2; axis++)
            mobility +=
                (sides[0]->mobility[axis] + sides[1]->mobility[axis]) * along[axis] * along[axis];
        const double kappa = k * mobility * dt * dt;
        const double alpha = kappa * kappa / (1.0 + kappa * kappa);
        lines[direction] = (struct mpm_solve_line){dt * k * jump, alpha * dt * dt * k};
        stiff = stiff || kappa > 1.0;
    }
    return stiff;
}

double mpm_interface_stored(const struct mpm_state *state, const struct mpm_contact_pair *pair)
{
    const struct joint joint = joint_of(state, pair);
    double stored = 0.0;
    for (int direction = 0; direction < 2; direction++) {
        const double jump = pair->jump[direction] +
                            state->time_step * opening(state->grid.motion[joint.nodes[0]].end,
                                                       state->grid.motion[joint.nodes[1]].end,
                                                       joint.along[direction]);
        stored += 0.5 * stiffness(&joint, direction, jump) * jump * jump;
    }
    return stored;
}
