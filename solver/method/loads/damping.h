/* Artificial damping: Notes 5.1.2, (29)-(65), and 5.3, (104)-(106).
 *
 * At the nodes, the rate alpha_g(t, x_i) changes the momentum update, Notes (30) and (105):
 *     a_i* = f_i / m_i - alpha_g v_i^n,    v_i^{n+1} = v_i^n + dt a_i*
 * (the erratum to (104): momentum changes by m_i a_i* dt). The rate is taken at the node, (105),
 * where the velocity that it slows down lives; so it holds for all that use nodal velocities,
 * and needs no approximation (107). A ghost node has the rate of the edge node that it
 * continues. Components that a condition holds follow the condition, and are not damped.
 * damping.grid_form has two other forms, in which alpha_g acts at the particles: grid_drag.h.
 *
 * At the particles, alpha_p(t, x_p) and PIC damping of the share beta(t), Notes (43), (44):
 *     q_p = alpha_p v_p^n + alpha_PIC (v_p^n - v_gp^n),    alpha_PIC = (1 - beta)/dt,
 *     v_p^{n+1} = v_p^n + dt (a_gp - q_p),    v_gp^n = sum S_ip v_i^n.
 * PIC damping stays out of the nodes, as (58)-(65) have it, so that no force, reaction or
 * strain sees a rate that grows as the time step shrinks. To velocities it does what a FLIP
 * fraction of beta does. Positions differ with position_update midpoint, which is
 * Notes (42): - dt^2/2 q_p is added to the particle's way, on top of what the damped nodes
 * give, (38). With grid_velocity particles move with x_p += dt sum S_ip v_i*^{n+1}: grid
 * damping acts on the way, damping at the particles does so from the next step on, through
 * the velocities.
 *
 * All this is the papers' explicit form: in one step a free body keeps (1 - alpha dt) of its
 * velocity, not exp(-alpha dt). Every rate must be finite, not negative and below 1/dt.
 *
 * The thermostat adds a rate alpha(t) to that of all nodes, with the feedback of Nose and
 * Hoover (Hoover 1985, Phys. Rev. A 31, 1695) on the kinetic energy K of the particles:
 *     d alpha/dt = gain (K - target)/scale,    alpha >= 0,
 * by a forward Euler step after each step. Since grid damping takes 2 alpha K a unit of time,
 * a target of 0 leads to alpha^2 = gain D/scale once the energy D has been taken out: the rate
 * stays finite, and with a scale near the energy to be lost and a gain of (2 omega)^2 it comes
 * to critical damping of the frequency omega. That, and that it needs no global extremes
 * or sudden changes of velocity, is why it is here rather than a release at energy peaks.
 *
 * What damping takes out is booked as force times mean velocity times dt,
 *     sum m_i alpha_g v_i^n . (v_i^n + v_i^{n+1})/2 dt + sum m_p q_p . (v_p^n + v_p^{n+1})/2 dt,
 * as the work of external forces is. The mean velocity of a body force has its part of the drag,
 * - dt/2 q_p.
 *
 * Nothing is done in a scene without damping.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_DAMPING_H
#define MPM_METHOD_DAMPING_H

#include "method/contact/contact_impulse.h"
#include "method/state.h"

/* Evaluates what is the same for all nodes or particles in this step. MPM_RUN_FAILED: a rate
 * or beta is out of range. */
enum mpm_status mpm_damping_begin(struct mpm_state *state, struct mpm_error *error);

/* Damps the nodes: after the momentum update, before the conditions at its end.
 * MPM_RUN_FAILED: a node's rate is out of range. Cost: a pass over the active nodes, with an
 * expression each if the rate varies in space. */
enum mpm_status mpm_damping_apply_nodes(struct mpm_state *state, struct mpm_error *error);
/* Contact between bodies gives a node, inside of the grid, an impulse at the end of the step: what
 * damping took was counted with the mean velocity before. `side`: the node before the impulse. */
void mpm_damping_follow_contact(struct mpm_state *state, int64_t node,
                                const struct mpm_contact_side *side, const double impulse[2]);

/* Damping at the particles, three times in a step. Finds the drag q_p of the velocities at the
 * start of the step, before any transfer changes them; with PIC damping that evaluates shape
 * functions. */
void mpm_damping_find_drag(struct mpm_state *state);
/* v_p -= dt q_p: just before the velocities are updated */
void mpm_damping_take_drag(struct mpm_state *state);
/* After the last task: the midpoint's x_p -= dt^2/2 q_p, the energy that the step took out, and the
 * thermostat's rate for the next step. */
void mpm_damping_finish(struct mpm_state *state);

#endif
