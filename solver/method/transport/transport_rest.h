/* How far conduction is from a steady state, for scenes with time.rest: what flows to nodes that
 * nothing holds, sum |dQ_i/dt|, over the largest sum of all nodes so far.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_REST_H
#define MPM_METHOD_TRANSPORT_REST_H

#include "method/state.h"

/* After mpm_transport_advance; nothing in scenes without time.rest. Cost: a pass over the nodes. */
void mpm_transport_measure_rest(struct mpm_state *state);

#endif
