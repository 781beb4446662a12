/* Exchange of momentum between two velocity fields of a node.
 *
 * Fields of any owner: sides of a crack, bodies, materials. Whether they touch, along which normal
 * and by which law is for their owner to say; the exchange is a function of (field, field, normal,
 * law), see contact_impulse.h for its equations. Momentum is conserved; components that conditions
 * hold stay as they are, and what the exchange would change of them the condition bears. Images
 * beyond planes of symmetry follow.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EXCHANGE_H
#define MPM_METHOD_EXCHANGE_H

#include "method/contact/contact_impulse.h"
#include "method/state.h"

/* The velocities of the nodes that change, in tasks 2, 4 and 6. */
enum mpm_exchange_when {
    MPM_EXCHANGE_START,        /* and the gradient's, where the stress update comes next */
    MPM_EXCHANGE_END,          /* with accelerations; conditions that bear a part of it do work */
    MPM_EXCHANGE_EXTRAPOLATED, /* of the momentum extrapolated again */
    MPM_EXCHANGE_SMOOTHED,     /* on their way through the orders of XPIC and FMPM */
};

/* One of both fields. */
struct mpm_exchange_field {
    int64_t node; /* index of the field, which has mass */
    uint8_t held; /* bits of the components that conditions hold */
};

/* Two fields of a node that touch. */
struct mpm_exchange_touch {
    struct mpm_exchange_field fields[2];
    double normal[2]; /* unit vector from the first field to the second */
    struct mpm_contact_law law;
    size_t count; /* of the node's pairs that touch; they follow each other */
};

/* Its velocity and mobility. */
struct mpm_contact_side mpm_exchange_side(const struct mpm_state *state,
                                          enum mpm_exchange_when when,
                                          const struct mpm_exchange_field *field);
/* Gives an impulse to the field, which `side` was before: changes its velocity, that of its images,
 * and, at the end of the step, its acceleration and the work of conditions. */
void mpm_exchange_give(struct mpm_state *state, enum mpm_exchange_when when,
                       const struct mpm_exchange_field *field, const struct mpm_contact_side *side,
                       const double impulse[2]);

/* The normal, of unit length, points from the first field to the second. */
void mpm_exchange(struct mpm_state *state, enum mpm_exchange_when when,
                  const struct mpm_exchange_field fields[2], const double normal[2],
                  const struct mpm_contact_law *law);

#endif
