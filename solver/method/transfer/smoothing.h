/* XPIC(m) and FMPM(k): velocities of the nodes with more of what the particles have than the
 * one average over neighbours that a lumped mass gives.
 *
 * With the weights S of particles (rows) by nodes and S+ = m_i^-1 S^T m_p, lumped velocities of
 * the nodes are v = S+ v_p, and S S+ is a filter that PIC puts particle velocities through in
 * each step. Both methods take the series of its inverse to some order n,
 *
 *   w_n = sum_{j<n} (1 - S+ S)^j v,    by    w_1 = v,  w_{r+1} = v + w_r - S+ S w_r:
 *
 * one gather and one scatter over the particles for each order beyond the first.
 *
 * XPIC (Hammerquist and Nairn 2017) of v^n, the velocity at the start of the step:
 *   v_p^{n+1} = S w_m + dt S a = (1 - (1 - S S+)^m) v_p^n + dt S a:
 *   m = 1 is PIC, m to infinity is FLIP without the particle velocities that no node sees.
 *
 * FMPM (Nairn and Hammerquist 2021) of v^{n+1}, after the momentum update: w_k is the velocity
 * that the full mass matrix S^T m_p S would give, to order k, and
 *   v_p^{n+1} = S w_k,  positions and the gradients of (32) with w_k as well:  k = 1 is PIC.
 *   Done once in a step, there: the gradients of USF and USAVG at the start of the step and of
 *   the re-extrapolated momentum of MUSL and USAVG are of lumped velocities (the latter those of
 *   particles that have taken S w_k).
 *
 * Conditions: nodes that are held keep that velocity in every w_r; mirrors at the axis mirror w_r,
 * and planes of symmetry reflect the sums S^T m_p S w_r.
 *
 * Positions: as for every transfer, `position_update` is of the grid's velocities. grid_velocity
 * moves particles with S v^{n+1} (XPIC) and S w_k (FMPM); midpoint with dt/2 S a less. The
 * authors' own code lets the particles' velocities in: it moves them with
 * S v^n + (v_p^{n+1} - v_p^n)/2 (XPIC) and (v_p^n + v_p^{n+1})/2 (FMPM), whose gradients are
 * not those that update F.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SMOOTHING_H
#define MPM_METHOD_SMOOTHING_H

#include "method/state.h"

/* After the momentum update and its conditions: makes w of the scene's order in grid.smoothed, of
 * the velocities at the start of the step, or at its end. Uses grid.gradient for its sums and
 * leaves zero there. Cost: (order - 1) gathers and scatters. */
void mpm_smooth_start(struct mpm_state *state, int workers);
void mpm_smooth_end(struct mpm_state *state, int workers);

/* Puts w into the motion that particles read back, so that with v_p = 0 the velocity update as
 * it is gives the equations above, and the gradients where they are not to be extrapolated. */
void mpm_row_xpic(void *state, int64_t row, int worker);
void mpm_row_fmpm(void *state, int64_t row, int worker);

#endif
