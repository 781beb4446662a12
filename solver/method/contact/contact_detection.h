/* Are two fields in contact at a node, and over which area?
 *
 * The gap of a pair is where the second field begins along the normal less where the first one
 * ends (contact_sums.h: the particles' edges). Its area is what the surfaces of both share: with
 *     s = sum_p V_p (G_ip + T_ip e_r) = integral of N_i n over the surface of a field,
 * for the thickness or per radian, it is the smaller of n . s_1 and -n . s_2. These areas add up to
 * that of the surface over the nodes, since sum N_i = 1. (T is 0 in planar geometry. In
 * axisymmetry div (r N_i e_r) = r dN_i/dr + N_i gives the second term.)
 *
 *     extent   approach is allowed until the gap is closed: a = max(gap, 0)/dt; two fields that
 *              are apart do not feel each other, however many nodes they share
 *     volume   in contact are fields whose areas sum_p A_p S_ip together are at least `touching` of
 *              that which the node can see of the grid, N&G 3.3: doubled at r = 0 and on planes
 *     shared   in contact are fields that share a node, 1 to 3 cells before they touch
 *
 * Where a crack gives a body several fields at a node, those of them touch another body whose
 * surface is within half a cell of it, besides: the others are behind the crack. Of an interface
 * this is the distance without its opening.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_DETECTION_H
#define MPM_METHOD_CONTACT_DETECTION_H

#include "method/contact/shared_nodes.h"

/* Needs the scene the particles' edges? */
bool mpm_contact_needs_edges(const struct mpm_contact_spec *spec);

/* Sets touches, gap, area and jump of all pairs: sums, normals and edges are there. */
void mpm_contact_detect(struct mpm_state *state);

/* The length that a node can see along an axis, in cells: integrals of its function over the grid,
 * and up to a plane of symmetry. B-splines are adapted to edges: that of the node beyond is folded
 * onto the two inside. */
double mpm_node_seen_length(const struct mpm_state *state, int64_t node, int axis);

#endif
