/* A user force: a body force that the caller computes for each particle and step
 * (mpm_simulation_set_body_force):
 *
 *     f_i += sum m_p S_ip b_p,   N&G (4),
 *
 * beside the scene's own: a projection of b_p (method/transfer/projection.h). Its work in the step
 * is that of the nodal forces,
 *
 *     sum_p m_p b_p . sum_i S_ip (v_i^n + v_i^{n+1})/2 dt = sum_i f_i . (v_i^n + v_i^{n+1}) dt/2.
 *
 * Nothing is done where there is none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_USER_FORCE_H
#define MPM_METHOD_USER_FORCE_H

#include "base/arena.h"
#include "method/state.h"

/* Takes the arrays of state->user_force and of b_p from the arena. */
void mpm_user_force_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Calls the caller's function and sums the forces by nodes; a value that is not finite is a failure
 * of the strip. To be called while the particles' domains are those of the start of the step. */
void mpm_user_force_spread(struct mpm_state *state, int workers);

/* Adds the sums to the nodes' forces, before the momentum update. */
void mpm_user_force_add(struct mpm_state *state);

/* Its work in the step, once the velocities at its end are known. */
double mpm_user_force_work(struct mpm_state *state);

#endif
