/* Solids whose pressure is Mie and Grueneisen's: what laws with strength share.
 *
 * The energy per mass has three parts: e, of the pressure's work and of heat, which makes the
 * pressure (mie_gruneisen.h); the shear energy of elastic strain and back stress, G |dev e|^2 +
 * H_k/3 |ln U_p|^2 over rho_0 (plastic_flow.h), from which it comes back as work; and the part of
 * plastic work that is no heat:
 *
 *   de = -p dJ/rho_0 + chi dw + dq,
 *
 * with the plastic work w, the Taylor-Quinney factor chi and the work q of viscosity. Pressure
 * depends on e alone: were it to depend on shear energy too, with a constant shear modulus, a
 * closed path of elastic strain would give energy. The temperature is that of J and e.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_GRUNEISEN_SOLID_H
#define MPM_MODEL_GRUNEISEN_SOLID_H

#include "model/laws/mie_gruneisen.h"
#include "model/laws/plastic_flow.h"

/* The first state variables: C_p^-1, p, e and w. */
enum {
    MPM_SOLID_ENERGY = MPM_PLASTIC_VARIABLES,
    MPM_SOLID_WORK,
    MPM_SOLID_VARIABLES,
};
#define MPM_SOLID_VARIABLE_ROWS                                                                    \
    MPM_PLASTIC_VARIABLE_ROWS,                                                                     \
        {"thermal_energy", MPM_DIMENSION_SPECIFIC_ENERGY, 0.0,                                     \
         "e, of pressure and heat, per mass"},                                                     \
    {                                                                                              \
        "plastic_work", MPM_DIMENSION_SPECIFIC_ENERGY, 0.0, "per mass"                             \
    }

/* The law's `update` (material.h), for the part `heating` = chi of plastic work and a yield stress
 * at `temperature`. */
bool mpm_gruneisen_solid_update(const struct mpm_material *material,
                                const struct mpm_plastic_model *model,
                                const struct mpm_law_step *step, double temperature, double heating,
                                double *state, double tau[MPM_SYMMETRIC_SIZE],
                                double *wave_speed_squared);

/* The law's `fault_of` (material.h). */
enum mpm_law_fault mpm_gruneisen_solid_fault(const struct mpm_material *material,
                                             const struct mpm_plastic_model *model,
                                             const struct mpm_law_step *step, double temperature,
                                             const double *state);

/* The law's `reheat` (material.h). */
bool mpm_gruneisen_solid_reheat(const struct mpm_material *material,
                                const struct mpm_law_step *step, double heating,
                                const double *old_state, double *state,
                                double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared);

/* All three parts of the energy. */
double mpm_gruneisen_solid_energy(const struct mpm_material *material, double kinematic,
                                  double heating, const double f[MPM_GRADIENT_SIZE],
                                  const double *state);

/* w */
double mpm_gruneisen_solid_dissipation(const struct mpm_material *material, const double *state);

/* T at J = det F and e */
double mpm_gruneisen_solid_temperature(const struct mpm_material *material,
                                       const double f[MPM_GRADIENT_SIZE], const double *state);

#endif
