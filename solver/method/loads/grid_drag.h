/* Grid damping that acts in the update of the particles, damping.grid_form: particles and
 * particle_rate; Notes (46)-(57), (106), (107).
 *
 * The nodes are not damped: p_i^{n+1} = p_i^n + dt (f_i + f_iT), (24). The particles' deceleration
 * q_p (damping.h) has one more part,
 *     particles       q_gp = sum_i S_ip alpha_g(t, x_i) v_i^n,                      (106)
 *     particle_rate   q_gp = alpha_g(t, x_p) v_gp^n,  v_gp^n = sum_i S_ip v_i^n,    (107)
 * which are the same for a rate of time alone, (47). It is in velocity and way:
 *     v_p^{n+1} = v_p^n + dt (a_gp - q_p),                                          (52)
 *     midpoint        x_p += dt v_gp^{n+1} - dt^2/2 (a_gp + q_p),                   (51)
 *     grid_velocity   x_p += dt v_* = dt v_gp^{n+1} - dt^2 q_gp,                    (56)
 * so that `particles` gives the particles what grid_form: nodes does. The forms differ where nodal
 * velocities at the end of the step are used as they are: strains without re-extrapolation,
 * contact, motion of cracks, and nodes that conditions hold, whose particles are damped. (107) is
 * to (106) what alpha_g(x_p) is to its mean over the nodes weighted with S_ip v_i: second order in
 * the cell where alpha_g is smooth, first order in the share of the particles next to a jump.
 *
 * The momentum form has weights S_ip m_i/M in the place of S_ip, (85)-(96).
 *
 * Not with transfers whose velocities are functions of the nodes' velocities at the end of the
 * step (FMPM, APIC), nor with radius_update: hoop, which moves r with their hoop rate.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_GRID_DRAG_H
#define MPM_METHOD_GRID_DRAG_H

#include "base/arena.h"
#include "method/state.h"

/* Takes the arrays of the form from the arena; none for grid_form: nodes. */
void mpm_grid_drag_layout(struct mpm_state *state, struct mpm_arena *arena);

/* damping.node_drag of a row's nodes: alpha_g v_i^n, units length/time^2. A rate that is not
 * allowed is recorded in row_sums. After the conditions at the start of the step. */
void mpm_row_grid_drag(void *state, int64_t row, int worker);

/* Adds q_gp to the drag of the particles, and its power at the start of the step to what the strip
 * dissipates; does nothing for grid_form: nodes. Cost: an evaluation of the shape functions for
 * each particle, and with particle_rate of the rate. */
void mpm_grid_drag_find(struct mpm_state *state);

#endif
