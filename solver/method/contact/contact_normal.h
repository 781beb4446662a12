/* Normals between two fields at a node, from the first to the second, by seven methods.
 *
 * With g = sum_p A_p G_ip of each field, N&G (55), which points out of it, v = sum_p V_p G_ip,
 * N&G (54), and A = sum_p A_p S_ip:
 *
 *     volume     v_1 - v_2
 *     area       g_1 - g_2
 *     average    A_1 g_1 - A_2 g_2
 *     larger     g of the field with more area at the node, outwards of the first; of the other one
 *                if the node is inside of it, |g| < 0.1 A/h: g is then what strain makes of zero
 *     linear     grad phi of the plane phi = c_0 + c . x that minimises
 *                sum_p w_p (phi(x_p) - y_p)^2, y = -1 in the first, +1 in the second, w = A_p
 *     logistic   the same with sum_p w_p log(1 + exp(-y_p phi(x_p))) + LAMBDA |c|^2 / 2: the plane
 *                between both sets of particles, if there is one
 *     given      the scene's
 *
 * Sums go over the particles that reach the node. One normal serves both fields, so that momentum
 * is conserved. On planes of symmetry and on r = 0 the component across is zero, N&G 3.3. Volumes
 * grow with r: `volume` turns normals outwards in axisymmetry, as N&G say.
 *
 * Where a regression has no plane, all particles being on one line, the average is taken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_NORMAL_H
#define MPM_METHOD_CONTACT_NORMAL_H

#include "method/contact/shared_nodes.h"

/* Finds the normals of all pairs from their sums; has_normal is false where there is none, both
 * gradients being zero. `workers` for logistic regression, which visits particles, and fails where
 * it does not converge. */
enum mpm_status mpm_contact_normals_find(struct mpm_state *state, int workers,
                                         struct mpm_error *error);

#endif
