/* Conduction of scalars, N&G (56)-(62), Notes 8: with c the capacity per mass,
 *
 *   M_i = sum c_p m_p S_ip,     v_i = (1/M_i) sum c_p m_p v_p S_ip,                     (59)
 *   grad v_p = sum v_i G_ip,    q_p = - k_p grad v_p,                                   (61)
 *   M_i dv_i/dt = sum V_p q_p . G_ip + sum V_p s_p S_ip,                                (58), (60)
 *   v_p += dt sum S_ip dv_i/dt.                                                         (62)
 *
 * S and G are those of the geometry; a scalar has no part with T_ip. m_p and V_p = J m_p / rho_0
 * are for the thickness or per radian. k turns with the material, by the rotation R of F = R U.
 * Errata: in N&G (57) q and rho C_p dT/dt have the wrong sign; Notes (138) lacks C_p in M_i.
 *
 * Edges of bodies without a flux (transport_edges.h) and planes of symmetry insulate: since sum_i
 * G_ip = 0 and sum_i S_ip = 1,
 *
 *   sum_p c_p m_p v_p (n+1) - sum_p c_p m_p v_p (n) = what sources, edges and held nodes give in
 * the step
 *
 * to round-off. Sources are those of the particles' places at the start of the step.
 *
 * A held node b has the prescribed value where gradients are made, and changes as that does,
 * dv_b/dt = (v(t + dt) - v(t))/dt; what that takes beyond the inflow from the particles comes from
 * outside. Particles beside it then follow, but one that was elsewhere before, or began with
 * another value, does not know of it. So in the first step after each sort held nodes also move
 * their particles by S_bp D with
 *
 *   D = sum_p c m S_bp (sum_j S_jp v_j - v_p) / sum_p c m S_bp sum_(held j) S_jp,
 *
 * after which particles have, in the mean that S_bp takes, what the nodes have at their places. D
 * is of second order in the cell where fields are smooth. To move the node from what particles
 * give, dv_b/dt = (v(t + dt) - v_b)/dt, would instead give them the boundary's value in that mean,
 * some 0.3 cells away from it: an error of first order (NAFEMS T3 on 40 cells: up to 1.7 % of the
 * amplitude instead of 0.46 %).
 *
 * Heat of deformation changes particles and not nodes. Beside a held node it would stay for ever in
 * the part that S_bp has of it, so that with it held nodes move their particles in each step.
 * What a start that does not fit leaves of D in the next step, C_hf M_f^-1 C_fh L^-1 - C_hh L^-1 +
 * 1 times it, has no dt in it (docs/heat.md).
 *
 * With PIC, v_p = sum S_ip (v_i + dt dv_i/dt), Notes (142): conserves too, and conducts of itself.
 * XPIC and FMPM are between both: transport_smoothing.h.
 *
 * Stable steps: on nodes, v' = v - dt (M^-1 C) M^-1 K v with K_ij = sum V k G_ip . G_jp and C_ij =
 * sum c m S_ip S_jp. The eigenvalues of M^-1 C are 1 at most, those of M^-1 K are 4 kappa / h^2 in
 * a long bar: dt = h^2 / (2 kappa) is below the limit of every family, at every end of a body
 * (case H13 has them). With two axes the eigenvalues add, and a flux that depends on v, with the
 * derivative -a, adds 2 a / (c rho h) at the node of a row of half a cell:
 * mpm_transport_stable_step.
 *
 * Nothing is done, and no memory taken, in scenes without scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_H
#define MPM_METHOD_TRANSPORT_H

#include "method/state.h"

/* The nodes' arrays. */
void mpm_nodal_scalar_layout(const struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                             struct mpm_arena *arena);

/* One step of all scalars, in the places and with the F of its start. MPM_RUN_FAILED: a prescribed
 * value or the result is not finite; a source that is not is a failure of its strip. Cost: three
 * passes over the particles; in scenes at rest two, since the second one spreads for the next step.
 */
enum mpm_status mpm_transport_advance(struct mpm_state *state, int workers,
                                      struct mpm_error *error);

/* The same beside mechanics, with one result, where the passes of mechanics take the scalar along
 * (with_scalar of struct mpm_passes): they find each stencil once for both. `begin` comes before
 * anything is spread; `prepare` between that and the first stress update; `conclude` before the
 * last pass. The new values are those of that pass. */
void mpm_transport_begin(struct mpm_state *state);
enum mpm_status mpm_transport_prepare(struct mpm_state *state, int workers,
                                      struct mpm_error *error);
enum mpm_status mpm_transport_conclude(struct mpm_state *state, int workers,
                                       struct mpm_error *error);

/* Particles are in another order, or have other values: contents at hand are not theirs. */
void mpm_transport_forget(struct mpm_state *state);

/* FMPM counts with more than its diffusivity and film, see transport_smoothing.h:
 * 1 / (2 kappa (1/h_x^2 + 1/h_y^2) + film (1/h_x + 1/h_y)); HUGE_VAL where nothing flows. */
double mpm_transport_stable_step(const struct mpm_grid *grid, double diffusivity, double film);

/* Content of a scalar: sum c_p m_p v_p; extremes of v_p, where not NULL. */
double mpm_transport_content(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                             double extremes[2]);

#endif
