/* What flows between the fields of a node that share its place: between bodies in contact, or the
 * sides of a crack. With M the capacities, v = C / M the values that particles give the fields, and
 * I what flows in otherwise:
 *
 *     perfect       fields are one: v = sum C / sum M, dv/dt = sum I / sum M
 *     conductance   M_a dv_a/dt = I_a - sum_b g_ab (v_a - v_b),  g = H A
 *
 * The second one is integrated exactly over the step with constant I: with the fields that are one
 * taken together, M^(-1/2) L M^(-1/2) = Q z Q^T / dt of the links' Laplacian L has the modes of the
 * node, each of which decays by exp(-z). So it is stable for any H, and a steady state is one:
 *
 *     gained = - M^(1/2) Q [(1 - exp(-z)) Q^T M^(1/2) v + dt (1 - phi(z)) Q^T M^(-1/2) I],
 *
 * phi = (1 - exp(-z))/z. Fields that hang together are counted from their mean, so that the sum
 * gained is 0 to round-off of what is exchanged, whatever H. The order of fields and links changes
 * round-off alone.
 *
 * Which pair passes what is unique but for perfect links in a ring: there what passes has the
 * smallest sum of squares.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SCALAR_EXCHANGE_H
#define MPM_METHOD_SCALAR_EXCHANGE_H

#include "model/contact.h"

enum { MPM_SCALAR_LINKS = MPM_CONTACT_SIDES * (MPM_CONTACT_SIDES - 1) / 2 };

struct mpm_scalar_side {
    double capacity, content, inflow; /* M > 0, C = M v, and I */
    double settling;                  /* what v changes by besides, with FLIP */
    double value;                     /* v of all fields that are one with this */
    double rate;                      /* its mean dv/dt over the step, with what it gained */
};

struct mpm_scalar_link {
    int of[2]; /* sides */
    bool perfect;
    double conductance; /* H A >= 0, content per time and value; of perfect ones 0 */
    double passed;      /* from the first to the second over the step */
};

/* A node. */
struct mpm_scalar_meeting {
    int side_count, link_count;
    struct mpm_scalar_side sides[MPM_CONTACT_SIDES];
    struct mpm_scalar_link links[MPM_SCALAR_LINKS];
    int group[MPM_CONTACT_SIDES]; /* per side: the first one that it is one with */
};

/* Sets `group` and values. */
void mpm_scalar_meeting_join(struct mpm_scalar_meeting *meeting);

/* Sets rates and what links pass; joined before. The sum of M times what the fields of a group
 * settle by is 0. With `values`, fields that are one take on its value too (PIC), and that is
 * counted as passed. Cost: n^3 of the n fields. */
void mpm_scalar_meeting_exchange(struct mpm_scalar_meeting *meeting, double time_step, bool values);

#endif
