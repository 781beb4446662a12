/* Stress and strain energy of particles by the laws of their bodies: of those with state variables,
 * that expand with a scalar (temperature, concentration), or whose stress depends on the
 * temperature.
 *
 * Free expansion is isotropic: F = F_e exp(e) with e = sum_k alpha_k (v_k - v_k0), so that a stress
 * free body has the stretch exp(e). The law is one of F_e. Its energy is per mass, and so is tau /
 * rho_0, that of the law at F_e: moduli are those over rho_0, at any temperature.
 *
 * Heat of deformation (transport.temperature.heating): with X = tr(tau) / rho_0 and alpha constant,
 * the free energy W(F_e) + w(T) per mass has the entropy alpha X + s(T), and with c = T ds/dT, the
 * heat capacity at constant tau,
 *
 *   c dT = q - alpha T dX,         de = q + (tau / rho_0) : dF F^-1,   e = W + c T + alpha T X.
 *
 * Without inflow q a step goes from T and X to T' = T exp(-alpha (X(F', T') - X) / c), solved by
 * iteration: it contracts by N = 9 alpha^2 (K/rho_0) T / c, and 1 - N = c_v / c > 0 in a material
 * that is stable. With T of the step before instead, the stress would follow the strain with an
 * adiabatic part that is a step late, which makes energy: waves would grow.
 *
 * Plastic work w per mass gives chi dw besides: T' has chi (w' - w) / c more, with the w' of the
 * stress that T' leads to. What is dissipated otherwise is (1 - chi) w.
 *
 * T of the laws is sum S_ip T_i of the end of the step, not T_p, in which FLIP leaves what nodes do
 * not see; X is that of the last stress update, so that what T_i changes is heated by as well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_LAW_STATE_H
#define MPM_METHOD_LAW_STATE_H

#include "method/state.h"

/* State variables that a particle of the scene carries: those of the law that has most. */
size_t mpm_law_states_of(const struct mpm_scene *scene);
/* Fields of particles, MPM_USE_..., that laws with state variables and viscosity need. */
unsigned mpm_law_uses(const struct mpm_scene *scene);

/* Sets the state variables of all particles to their values at t = 0. */
void mpm_law_states_begin(struct mpm_state *state);

/* The same for free strains and the temperatures of laws, of the values that particles have, and
 * the stress with them. MPM_RUN_FAILED, with the failure in `state`: a temperature below zero where
 * it has to be absolute, or at which c_v is not above zero. */
enum mpm_status mpm_law_scalars_begin(struct mpm_state *state);

/* sum_k alpha_k (v_k - v_k0) for the values v_k of all scalars. */
double mpm_free_strain(const struct mpm_material_spec *material,
                       const double value[MPM_SCALAR_COUNT]);

/* tau / rho_0 of particle p and the square of its wave speed when F changes to `f` in this part of
 * a time step; in plane stress `f` gets its F_zz. The particle still has the old F and the old
 * stress; its state variables, free strain and temperatures become those at the end. Sums go to
 * `strip`. False, with the failure in `strip`: heat of deformation or the law has no solution. */
bool mpm_particle_update_law(const struct mpm_state *state, size_t p, double part,
                             double f[MPM_GRADIENT_SIZE], struct mpm_strip *strip,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

/* The same of the state at hand: of any particle, without a step. */
void mpm_particle_find_stress(const struct mpm_state *state, size_t p,
                              double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

/* What is wrong with the temperature that the law reads now, which goes to `temperature`. */
enum mpm_failure_kind mpm_particle_judge_temperature(const struct mpm_state *state, size_t p,
                                                     double *temperature);

/* Notes a failure if a table, by enum mpm_table, does not have the particle's temperature. */
void mpm_strip_judge_tables(struct mpm_strip *strip, enum mpm_scalar which,
                            const struct mpm_property *tables, uint32_t id, double temperature);

/* F_zz of particle p in plane stress, for the plane part of `f`. */
double mpm_particle_thickness(const struct mpm_state *state, size_t p,
                              const double f[MPM_GRADIENT_SIZE]);

/* Per unit mass: of the law, or the work of the stress since t = 0 if the law has no energy; with
 * an equation of state its internal energy less the work of artificial viscosity. */
double mpm_particle_strain_energy(const struct mpm_state *state, size_t p);

/* Of its equation of state, 0 if it has none: internal energy per unit mass; temperature, 0 also
 * without specific_heat. */
double mpm_particle_internal_energy(const struct mpm_state *state, size_t p);
double mpm_particle_state_temperature(const struct mpm_state *state, size_t p);

/* Is its own temperature its melting temperature or above, where it has no strength? */
bool mpm_particle_is_melted(const struct mpm_state *state, size_t p);

/* Per unit mass, since t = 0: work of artificial viscosity. */
double mpm_particle_viscous_work(const struct mpm_state *state, size_t p);

/* Per unit mass, since t = 0, of plastic strain: what is dissipated and is no heat of the conducted
 * temperature, and what is; 0 of other laws. */
double mpm_particle_dissipation(const struct mpm_state *state, size_t p);
double mpm_particle_plastic_heat(const struct mpm_state *state, size_t p);

/* alpha T tr(tau) / rho_0 per unit mass, with the T of the law; 0 without heat of deformation. */
double mpm_particle_thermoelastic_energy(const struct mpm_state *state, size_t p);

#endif
