/* Passes over the particles of a strip: reference kernels, one particle at a time over
 * its stencil of (node, S, G, T), meant to be read beside the papers. Signature and
 * use: mpm_strips_run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSFER_H
#define MPM_METHOD_TRANSFER_H

#include "method/transfer/extent.h"

/* S, G and T of the nodes that a particle reaches, in `room`, or where a step keeps them: of
 * particles with additional velocity fields they are those of the place at its start. */
const struct mpm_stencil *mpm_particle_stencil(const struct mpm_state *state, size_t p,
                                               struct mpm_stencil *room);

/* The same without packed fields: of the nodes of the grid, or of its body's layer. */
void mpm_particle_plain_stencil(const struct mpm_state *state, size_t p,
                                struct mpm_stencil *stencil);

/* Of the nodes of the grid, whatever layer its body moves in. */
void mpm_particle_grid_stencil(const struct mpm_state *state, size_t p,
                               struct mpm_stencil *stencil);

/* The particle's domain with the edges that its F carries, whatever the family. */
struct mpm_shape_domain mpm_particle_carried_domain(const struct mpm_state *state, size_t p);
/* Puts the domain of a particle's F into its place, where domains are stored. */
void mpm_particle_set_domain(const struct mpm_state *state, size_t p);

/* A body force that varies in space, where the particle is; false, with a record, if it is not
 * finite. */
bool mpm_particle_body_force(const struct mpm_state *state, size_t p, int worker,
                             struct mpm_strip *strip, double b[2]);
/* sum S w_i at the particle, of a vector of the nodes; in the momentum form with its weights */
void mpm_particle_gather(const struct mpm_state *state, size_t p, double (*nodes)[2],
                         double value[2]);
/* Gives the particle `f` and what law_state.h makes of it, `part` of the time step later; in plane
 * stress `f` gets its F_zz. Failures and the wave speed go to `strip`. */
void mpm_particle_take_deformation(const struct mpm_state *state, size_t p, double part,
                                   double f[MPM_GRADIENT_SIZE], struct mpm_strip *strip);
/* Its place with the reach of its domain; no way gone. */
struct mpm_placement mpm_particle_placement(const struct mpm_state *state, size_t p);

/* m_i, p_i: CRAMP (26), Notes (23), (25) */
void mpm_pass_momentum(void *state, int64_t strip, int worker);
/* the same and the internal force f_i of the stress at the start of the step: CRAMP
 * (28), N&G (3), Notes (20), (120) */
void mpm_pass_momentum_and_force(void *state, int64_t strip, int worker);
/* stress update of the part `before` of the step, then f_i of the new stress */
void mpm_pass_stress_and_force(void *state, int64_t strip, int worker);
/* f_i += m_p b(x_p, t) S_ip: N&G (4), for a force that varies in space; for others see
 * mpm_row_update_with_body_force */
void mpm_pass_body_force(void *state, int64_t strip, int worker);
/* work of the body force over the step, m_p b . (v^n + v^{n+1})/2 dt at the particle */
void mpm_pass_body_work(void *state, int64_t strip, int worker);
/* v_p -= (1 - beta)(v_p - sum S v_i^n): Notes (45) without its last term */
void mpm_pass_flip_fraction(void *state, int64_t strip, int worker);
/* v_p *= beta: what mpm_row_flip_fraction leaves to do */
void mpm_pass_keep_fraction(void *state, int64_t strip, int worker);
/* v_p += dt sum S a_i: CRAMP (30), Notes (40) */
void mpm_pass_velocity(void *state, int64_t strip, int worker);
/* the same and the re-extrapolated momentum: CRAMP (31) */
void mpm_pass_velocity_and_momentum(void *state, int64_t strip, int worker);
/* x_p += dt sum S v_i^{n+1}, or Notes (38); the domain of the next step */
void mpm_pass_position(void *state, int64_t strip, int worker);
/* stress update of the part `after` of the step, then the same */
void mpm_pass_stress_and_position(void *state, int64_t strip, int worker);
/* stress and domain from F: they are functions of it */
void mpm_pass_recompute(void *state, int64_t strip, int worker);
/* the box of nodes that the strip's particles reach */
void mpm_pass_measure(void *state, int64_t strip, int worker);

#endif
