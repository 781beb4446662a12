/* What flows into bodies through edges of their particles, N&G (60) and Notes (136), with the
 * weights of tractions, w_i the integral of N_i over the edge (method/shape/edge.h):
 *
 *     inflow_i += w_i phi,   phi inwards positive:
 *
 *     given        an expression at the middle of the edge and the start of the step
 *     convection   h (v_env - v)
 *     radiation    e sigma (v_env^4 - v^4)
 *
 * v is that of the edge, sum w_i v_i / sum w_i, with the values of the nodes at the start of the
 * step. Areas are those of tractions: per radian in axisymmetry, of undeformed edges with uGIMP. A
 * node of the edge without capacity takes nothing: its share goes to the particle's nodes by S.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_EDGES_H
#define MPM_METHOD_TRANSPORT_EDGES_H

#include "method/state.h"

/* Whose temperature a failure MPM_BELOW_ZERO has, in the place of its axis. */
enum { MPM_RADIATES_ITSELF, MPM_RADIATES_TO };

/* Of state->edge_loads, which have been prepared. Cost: one look at each edge. */
void mpm_transport_edges_spread(struct mpm_state *state, int workers,
                                struct mpm_nodal_scalar *scalar);

/* - d phi / d v >= 0. */
double mpm_flux_slope(const struct mpm_edge_load_spec *flux, double value);

#endif
