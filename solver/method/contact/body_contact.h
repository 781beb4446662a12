/* Contact between bodies: N&G 3.3, multimaterial contact and imperfect interfaces.
 *
 * Groups of bodies have velocity fields of their own, in layers of the grid (method/fields). At the
 * nodes that several of them reach, each pair with a law exchanges momentum whenever nodal
 * velocities change: before the forces (task 2), after the momentum update (task 4) and after the
 * extrapolation (task 6), by the equations of contact_solve.h, along normals of contact_normal.h,
 * where contact_detection.h finds contact. Impulses of task 4 are forces on the particles too;
 * those of task 2 change the nodes alone: with FLIP, particles keep their velocities, as at nodes
 * that conditions hold. Two fields with the law `bonded`, or pressed ones that stick, are then one
 * field, to round-off. XPIC and FMPM filter each field alone; bonded fields stay one.
 *
 * Rigid bodies with a law are fields of infinite mass: they take part in contact and drive no
 * nodes. The history has what they bear.
 *
 * Imperfect interfaces (interface_law.h) take part in task 4 alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_BODY_CONTACT_H
#define MPM_METHOD_BODY_CONTACT_H

#include "method/contact/exchange.h"

static inline bool mpm_body_contact_is_used(const struct mpm_state *state)
{
    return state->scene->contact.field_count > 0;
}

void mpm_body_contact_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Task 1, once masses are reflected: nodes, sums, normals, contact. MPM_RUN_FAILED: no room. */
enum mpm_status mpm_body_contact_begin(struct mpm_state *state, int workers,
                                       struct mpm_error *error);
/* After conditions are gathered: which components they hold; velocities of rigid bodies.
 * MPM_RUN_FAILED: one that is not finite. */
enum mpm_status mpm_body_contact_hold(struct mpm_state *state, struct mpm_error *error);
/* While XPIC and FMPM filter velocities: bonded fields stay one. */
void mpm_body_contact_smoothed(struct mpm_state *state);
/* Tasks 2, 4 and 6. */
void mpm_body_contact_resolve(struct mpm_state *state, enum mpm_exchange_when when);

#endif
