/* What conduction means for stresses: free strain and temperature that the laws of particles are
 * given, transfer/law_state.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_COUPLING_H
#define MPM_METHOD_TRANSPORT_COUPLING_H

#include "method/state.h"

/* After mpm_transport_advance, with the values of nodes at the end of the step, v_i: how far sum
 * S_ip v_i is from what the stress at hand was found with. Nothing in scenes without coupling.
 * Cost: one pass over the particles. */
void mpm_transport_couple(struct mpm_state *state, int workers);

/* The same in a step without conduction. */
void mpm_transport_couple_nothing(struct mpm_state *state);

/* After the last stress update of a step: sums of what it did. */
void mpm_transport_finish(struct mpm_state *state);

#endif
