/* What flows between the fields of nodes: bodies in contact, sides of a crack. Owners of fields
 * list the passages of a step (transport_contact.h, cracks/crack_passages.h), and those of a node
 * exchange by scalar_exchange.h:
 *
 *   - fields that are one have one value where gradients are made. As with a single field,
 * particles keep their own with FLIP;
 *   - rates of the nodes, which particles follow, are those after the exchange.
 *
 * With perfect passages at all nodes that fields share, all is as with a single field, to
 * round-off: so it is across cracks and between bonded bodies. Of bodies that come together with
 * different values a single field would not do: nodes have the mean of both at once, but particles
 * follow rates alone, those of both sides of the contact the same ones, and their difference would
 * stay. They settle as those beside held nodes do (transport.h), in the first step after each sort:
 * each field a of the node is moved by D_a - sum_b M_b D_b/sum_b M_b as well, with
 *
 *   D_a = sum_p c m S_ap (sum_j S_jp v_j - v_p) / sum_p c m S_ap sum_(joined j) S_jp
 *
 * of its own particles, which conserves. D is of second order in the cell where fields are smooth.
 *
 * Held nodes hold all their fields, which exchange nothing there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_EXCHANGE_H
#define MPM_METHOD_TRANSPORT_EXCHANGE_H

#include "method/state.h"

/* Values of the start of the step: those that are one. */
void mpm_scalar_exchange_values(const struct mpm_state *state,
                                const struct mpm_nodal_scalar *scalar);
/* What nodes have at the places of fields' particles less what those have, as sums in `result`:
 * keeps those of fields that settle, puts 1 into their inflow, and adds up those of fields that are
 * one, for held nodes. */
void mpm_scalar_exchange_lags(const struct mpm_state *state, struct mpm_nodal_scalar *scalar);
/* The same with the shares of nodes with that 1 in those sums: what fields settle by. */
void mpm_scalar_exchange_settle(const struct mpm_state *state, struct mpm_nodal_scalar *scalar);
/* Results, from contents and inflow. */
void mpm_scalar_exchange_results(const struct mpm_state *state,
                                 const struct mpm_nodal_scalar *scalar);
/* `smoothed` of fields that are one; what they take of each other passes where it `counts`. */
void mpm_scalar_exchange_smoothed(const struct mpm_state *state,
                                  const struct mpm_nodal_scalar *scalar, bool counts);

#endif
