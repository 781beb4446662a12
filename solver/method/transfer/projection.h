/* Projection of values from particles to nodes and back, with the weights S alone:
 *
 *   spread    n_i += sum_p m_p S_ip v_p                    from a field of the particles
 *   gather    v_p  = sum_i S_ip n_i                        to a field of the particles
 *   filter    n_i += sum_p m_p S_ip sum_j S_jp w_j         both, and S is found once
 *
 * by either set of kernels, and with the additional velocity fields of nodes near cracks. Sums over
 * particles go in their order. Spread is the transpose of gather times the particles' masses: what
 * one hands over, sum_i n_i u_i, is sum_p m_p v_p (S u)_p of the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_PROJECTION_H
#define MPM_METHOD_PROJECTION_H

#include "method/transfer/projection_state.h"

struct mpm_state;

/* Runs one, within a step; `to` has been cleared. Cost: a stencil for each particle, and one vector
 * for each of its nodes, read or added to. */
void mpm_projection_run(struct mpm_state *state, int workers,
                        const struct mpm_projection *projection);

/* *state->projection of a strip: the pass of the reference kernels. */
void mpm_pass_project(void *state, int64_t strip, int worker);

#endif
