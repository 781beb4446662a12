/* XPIC(m) and FMPM(k) of scalars: values of the nodes with more of what the particles have than the
 * one average over neighbours that lumped capacities give. They are Hammerquist and Nairn's (2017)
 * and Nairn and Hammerquist's (2021) transfers of velocity, with capacities c m in the place of
 * masses. With the weights S of particles (rows) by nodes, S+ = M_i^-1 S^T c m and v = S+ v_p,
 *
 *   w_n = sum_{r<n} (1 - S+ S)^r v,    by    w_1 = v,  w_{r+1} = v + w_r - S+ S w_r,
 *
 * and with a_i = dv_i/dt
 *
 *   XPIC(m):  v_p = S (w_m + dt a),    w_m of v at the start of the step;
 *   FMPM(k):  v_p = S w_k,             w_k of v + dt a.
 *
 * Order 1 of both is PIC. m to infinity is FLIP without what no node sees of the particles; k to
 * infinity has the nodes' values of the full matrix S^T c m S.
 *
 * Held nodes keep their value in each w_r, fields that are one have one w_r. Since sum_i S_ip = 1,
 * sum_i M_i w_{r+1} is sum_i M_i v_i plus what it takes to put held nodes from v + w_r - S+ S w_r
 * to their value: that of the last order is counted as taken in there, and what fields that are
 * one take of each other as passed. Contents balance to round-off.
 *
 * Stable steps: on nodes, with C, M and K as in transport.h, B = M^-1 C and A = M^-1 K,
 *
 *   XPIC  v' = (1 - (1 - B)^m - dt B A) v,       FMPM  v' = (1 - (1 - B)^k)(1 - dt A) v.
 *
 * XPIC's limit is between PIC's and FLIP's. FMPM's comes near that of A as k grows, where nodes of
 * little capacity beyond a body's end count: 1 - (1 - s)^k <= k s for 0 <= s <= 1 bounds what they
 * do by k times FLIP's B A. Eigenvalues of bars of 8 cells with 1 to 4 particles in a cell and 21
 * places of the end, in h^2/(2 kappa), the least of classic functions, and of the other families:
 *
 *   k                 2      3      4      6      10     20
 *   classic           1.04   0.89   0.80   0.69   0.51   0.29
 *   the others        1.44   1.24   1.13   0.93   0.72   0.57
 *   4/(k + 2)         1      0.80   0.67   0.50   0.33   0.18
 *
 * so a step of FMPM is h^2/(2 kappa) times 4/(k + 2): mpm_scalar_stiffness is its inverse.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_SMOOTHING_H
#define MPM_METHOD_TRANSPORT_SMOOTHING_H

#include "method/state.h"

/* XPIC: `smoothed` is w_m, of `value`, before the results are found. FMPM: `result` becomes w_k, of
 * `result`, once all else is. Other transfers: nothing. Cost: (order - 1) passes. */
void mpm_scalar_smooth_start(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar);
void mpm_scalar_smooth_end(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar);

/* What diffusivities are multiplied with where they bound the step: 1, with FMPM (k + 2)/4. */
static inline double mpm_scalar_stiffness(const struct mpm_nodal_scalar *scalar)
{
    return scalar->transfer == MPM_SCALAR_FMPM ? (scalar->order + 2) / 4.0 : 1.0;
}

#endif
