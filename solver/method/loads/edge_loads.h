/* Forces on the edges of particles: tractions, N&G section 3.1, and the particle forces that they
 * are compared with there.
 *
 *     traction         f_i += T w_i, w_i the integral of N_i over the deformed edge (edge.h)
 *     particle force   f_i += T A_0 S_ip, A_0 the area of the undeformed edge
 *
 * Where edges are and what T is, is taken at the start of the step: T of the middle of the edge
 * (particle force: of the particle), constant over edge and step. In the frame of the edge T has
 * components along its outward normal and, counter clockwise, along the edge, of the edge that F
 * carries; for uGIMP too, whose areas are those of undeformed edges: with N&G's undeformed d1, d2 a
 * pressure would not turn with the body. In plane stress areas follow the thickness, F_zz, but for
 * uGIMP's.
 *
 * What flows into a body through edges is found and prepared here too, with the value of its first
 * component; transport_edges.h has what becomes of it.
 *
 * Which edges bear a load is settled at t = 0 (simulation/edge_loads.c). Scenes without loads on
 * edges run none of this.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EDGE_LOADS_H
#define MPM_METHOD_EDGE_LOADS_H

#include "method/state.h"

/* After a sort: finds the edges' particles. */
void mpm_edge_loads_place(struct mpm_state *state);

/* Before F or positions change in the step: weights and tractions of all edges. One that is not
 * finite is recorded, and 0 for the rest of the step. */
void mpm_edge_loads_prepare(struct mpm_state *state);

/* Adds the forces to those of the nodes. A node of the edge that has no mass (a point particle on
 * a knot reaches it with weight zero) takes none: its share goes to the particle's nodes by S. */
void mpm_edge_loads_spread(struct mpm_state *state, int workers);

/* After the momentum update and its conditions: work over the step, f_i (v^n + v^{n+1})/2 dt. */
double mpm_edge_loads_work(struct mpm_state *state, int workers);

/* Where T is taken. */
void mpm_edge_load_place(const struct mpm_state *state, const struct mpm_edge_site *site, size_t p,
                         double place[2]);

#endif
