/* Contact of crack surfaces, and the motion of cracks: CRAMP, section 2.2 and Task 7.
 *
 * Whenever nodal velocities change, two fields of a node that are found in contact exchange
 * momentum, CRAMP (12)-(19): no more than stops their approach along the crack's normal
 * (frictionless), with it no more than Coulomb's law allows along the crack (friction), or all of
 * what they differ by (stick). Momentum is conserved: one normal serves both sides. A component
 * that a velocity condition holds stays as it is: what the exchange would change of it, the
 * condition bears (contact_impulse.h). A node between two cracks has three fields and two
 * exchanges.
 *
 * In contact are fields whose relative volume V_rel, see crack_detection.h, is above `touching`;
 * none whose is below `separated`; between the two, those that approach each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_CONTACT_H
#define MPM_METHOD_CRACK_CONTACT_H

#include "method/contact/exchange.h"
#include "method/state.h"

/* Takes their memory. */
void mpm_crack_contact_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Tasks 2, 4 and 6c: the fields in contact exchange momentum, in one of the nodes' velocities.
 * Which ones touch is found in task 2, for the step. Nodes where bodies meet are left to the
 * contact between these, which takes the crack's pairs together with its own. */
void mpm_crack_contact_resolve(struct mpm_state *state, enum mpm_exchange_when when);

/* The first of the pairs of fields of a node of the grid that touch, or NULL. */
const struct mpm_exchange_touch *mpm_crack_contact_touches(const struct mpm_state *state,
                                                           int64_t node);

/* Nodes of the last step beside this crack whose fields contact leaves alone: a crack that bends
 * within a node's reach may have three fields with mass, and particles beyond two cracks share a
 * field if they see the node from the same side (above, or below) of both. */
size_t mpm_crack_contact_crowded(const struct mpm_state *state, size_t crack);

/* Cracks that come this near to themselves or each other meet, as a fraction of the shorter cell
 * side. */
#define MPM_CRACK_NEAR 1e-6
/* Points of a crack so little outside of the grid, as a fraction of a cell, count as on its edge.
 */
#define MPM_CRACK_EDGE_SLACK 1e-9

/* Task 7, after task 4: cracks move with the centre-of-mass velocity at the end of the step, (32),
 * whatever method.position_update is: call it before a transfer replaces that velocity. By the
 * linear functions of the nodes that have mass: at least a thousandth of the lightest particle's.
 * Nodes that a body hardly reaches have velocities without bounds, which particles take no part of,
 * and points outside of the body would; from three eighths of that particle's mass down to an
 * eighth, a node's velocity goes over from that at the end of the step to that at its start, a
 * mean of particles' velocities. Points that no such node
 * reaches are in the gap of a crack that is wide open, if the crack has others on both sides of
 * them: they go with these, by linear interpolation; else they stay where they are. MPM_RUN_FAILED:
 * a point leaves the grid, or a segment has grown longer than MPM_CRACK_LONGEST shorter cell sides:
 * it would no longer follow the material between. */
enum { MPM_CRACK_LONGEST = 4 };
/* The same of points that a checkpoint has, where they are. */
enum mpm_status mpm_cracks_check(const struct mpm_state *state, struct mpm_error *error);
/* Points beyond planes of symmetry go where the images of those inside are. */
void mpm_cracks_reflect(struct mpm_state *state);
enum mpm_status mpm_cracks_advance(struct mpm_state *state, struct mpm_error *error);

#endif
