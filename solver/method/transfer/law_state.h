/* Stress and strain energy of particles by the laws of their bodies, with the state variables of
 * laws that have some.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_LAW_STATE_H
#define MPM_METHOD_LAW_STATE_H

#include "method/state.h"

/* State variables that a particle of the scene carries: those of the law that has most. */
size_t mpm_law_states_of(const struct mpm_scene *scene);

/* Sets the state variables of all particles to their values at t = 0. */
void mpm_law_states_begin(struct mpm_state *state);

/* tau / rho_0 of particle p and the square of its wave speed when F changes to `f` within
 * `duration`, of a particle with state variables (of its law or of another's in the scene). The
 * particle still has the old F and the old stress; its state variables become those at the end. */
void mpm_particle_update_law(const struct mpm_state *state, size_t p,
                             const double f[MPM_GRADIENT_SIZE], double duration,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

/* The same of the state at hand: of any particle, without a step. */
void mpm_particle_find_stress(const struct mpm_state *state, size_t p,
                              double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

/* Per unit mass: of the law, or the work of the stress since t = 0 if the law has no energy. */
double mpm_particle_strain_energy(const struct mpm_state *state, size_t p);

#endif
