/* APIC: the affine particle-in-cell transfer of Jiang, Schroeder, Selle, Teran and Stomakhin
 * 2015. A particle carries, beside its velocity, the gradient of the velocities around it:
 *
 *   to the grid    m_i v_i = sum_p m_p S_ip (v_p + C_p (x_i - y_p)),     y_p = sum_i S_ip x_i
 *   from the grid  v_p = sum_i S_ip v_i^{n+1},  B_p = sum_i S_ip v_i^{n+1} (x_i - y_p)^T
 *   with           C_p = B_p D_p^{-1},          D_p = sum_i S_ip (x_i - y_p) (x_i - y_p)^T
 *
 * y_p is the particle's place in planar geometry, not in axisymmetry, where weights count r.
 * The re-extrapolated momentum of MUSL and USAVG (31) takes the affine part along.
 *
 * Angular momentum. With D_p of the nodes that the momentum goes to, the particle hands over
 * m_p (y_p cross v_p + B_yx - B_xy), its spin the latter, and takes exactly that back: in planar
 * geometry both transfers keep the sum to round-off, internal forces do, and so does the
 * position update grid_velocity, which moves x_p along v_p; midpoint does not. That is why B_p is
 * stored from step to step, and C_p made of it when the particle has moved.
 *
 * With classic functions a particle on a node reaches that one alone: there D_p is singular, and
 * C_p = sum v_i^{n+1} G_ip^T, which is B_p D_p^{-1} wherever that is defined. It is what they
 * keep, and their spin changes with D_p as they move: no promise. Nor is the pair stable at free
 * edges: C_p keeps the velocity of nodes that hardly have mass and hands it to nodes of more.
 * For the other families D_p is positive definite: at least the second moment of the domain
 * (uGIMP) or its corners (CPDI), (h/2)^2 and more for splines. Splines that bend at the grid's
 * edge lose one direction to a particle just there: then no node with a weight is at a distance
 * along it, C_p (x_i - y_p) takes nothing of it, and its column is 0.
 *
 * At the start the scene has particles' velocities and no gradients: B_p = 0. Kinetic energy
 * is that of v_p alone, as for every transfer.
 *
 * Passes of the reference kernels; signature and use: mpm_strips_run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_AFFINE_H
#define MPM_METHOD_AFFINE_H

#include "method/state.h"

/* as mpm_pass_momentum and mpm_pass_momentum_and_force */
void mpm_pass_affine_momentum(void *state, int64_t strip, int worker);
void mpm_pass_affine_momentum_and_force(void *state, int64_t strip, int worker);
/* as mpm_pass_velocity and mpm_pass_velocity_and_momentum, for particles at rest that take
 * sum S v_i^{n+1}; and B_p */
void mpm_pass_affine_velocity(void *state, int64_t strip, int worker);
void mpm_pass_affine_velocity_and_momentum(void *state, int64_t strip, int worker);

/* B_yx - B_xy of a particle, planar: its angular momentum over its mass. */
double mpm_particle_spin(const struct mpm_state *state, size_t p);

#endif
