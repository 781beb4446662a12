/* A body force that is taken at the nodes, loads.body_force_at: nodes, Notes (22):
 *
 *     f_i += m_i b(x_i, t),   in the place of   f_i += sum_p m_p S_ip b(x_p, t),  (20).
 *
 * Both give the same where b does not depend on the place, and where it is linear the same sum of
 * forces. Where b varies, (22) has the interpolant of b in the place of b: it adds the stress whose
 * mean is that of m_p (sum_i S_ip x_i b(x_i) - x_p b(x_p)), second order in the cell. It evaluates
 * b once for each node and not for each particle.
 *
 * It is added once all other forces are there and have been reflected, as a uniform one is. An
 * image has the force of its original. Its work is that of the nodes,
 *
 *     sum_i m_i b(x_i) . (v_i^n + v_i^{n+1}) dt/2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_NODAL_FORCE_H
#define MPM_METHOD_NODAL_FORCE_H

#include "base/arena.h"
#include "method/state.h"

/* Takes the arrays from the arena, if the scene's force is taken at the nodes. */
void mpm_nodal_force_layout(struct mpm_state *state, struct mpm_arena *arena);

/* Evaluates b at nodes with mass and adds m_i b to their forces; the next two do nothing either in
 * scenes without. MPM_RUN_FAILED: a value that is not finite. */
enum mpm_status mpm_nodal_force_add(struct mpm_state *state, struct mpm_error *error);

/* Its work in the step, once the velocities at its end are known. */
double mpm_nodal_force_work(struct mpm_state *state);

#endif
