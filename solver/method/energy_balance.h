/* Where the energy of a step goes between particles and nodes, for scenes with
 * output.energy_balance.
 *
 * With K_p the kinetic energy of the particles, K_i that of the nodes, sum m_i v_i^2 / 2, and
 * v = (v_i^n + v_i^{n+1})/2, a step consists of
 *
 *     particles to nodes    K_p^n  ->  K_i^n, conditions and contact of the start included
 *     momentum update       K_i^{n+1} - K_i^n = W_ext - W_int - W_coh - D_i - C, exact for any
 *                           forces: dt f_i . v is the change of m_i v_i^2 / 2
 *     nodes to particles    K_i^{n+1}  ->  K_p^{n+1}, drag D_p included
 *     stress update         W_int  ->  change of the strain energy E
 *     cohesive laws         W_coh  ->  change of their stored and dissipated energy E_c
 *
 * W_ext: work of loads and conditions; W_int = dt sum_p m_p (tau_p / rho_0) : grad v and W_coh:
 * what internal and cohesive forces take from the nodes; D_i: damping of nodes; C: what contact of
 * cracks takes in the momentum update. What does not arrive is the transfer loss of the step,
 *
 *     (K_p^n - K_i^n) + (K_i^{n+1} - K_p^{n+1} - D_p) + (W_int - dE) + (W_coh - dE_c),
 *
 * of either sign, and d(K_p + E + E_c) + D_i + D_p + C + transfer loss = W_ext holds to round-off.
 * K_p, K_i, W_ext, W_int, W_coh, D_i, D_p and C are measured where they arise: the sum is a check
 * of each of them, and of every change of a nodal velocity that has no term. E and E_c cancel in
 * it; a wrong one shows in the loss, which goes to zero with the step where nothing else takes
 * energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_ENERGY_BALANCE_H
#define MPM_METHOD_ENERGY_BALANCE_H

#include "method/state.h"

/* K_i of the end of the step, before contact of cracks changes velocities; then C. */
void mpm_energy_before_contact(struct mpm_state *state);
void mpm_energy_after_contact(struct mpm_state *state);

/* After the momentum update, before particles change: K_i of both ends, W_int, W_coh. Cost: two
 * passes over the active nodes, one over the particles with their stencils. */
void mpm_energy_measure_nodes(struct mpm_state *state, int workers);

/* After the damping of particles: K_p and D_p. */
void mpm_energy_measure_particles(struct mpm_state *state);

#endif
