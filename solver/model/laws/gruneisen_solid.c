/* Solids with Mie and Grueneisen's pressure; see gruneisen_solid.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/gruneisen_solid.h"

#include <math.h>
#include <string.h>

enum { ENERGY = MPM_SOLID_ENERGY, WORK = MPM_SOLID_WORK };

/* p/rho_0 and c^2 at the end of the step. */
static bool find_pressure(const struct mpm_material *m, const struct mpm_law_step *step,
                          double heat, double *energy, double *pressure, double *sound_squared)
{
    const double j = mpm_determinant(step->f);
    if (step->duration > 0.0)
        return mpm_gruneisen_advance(m, mpm_determinant(step->old_f), j, heat, energy, pressure,
                                     sound_squared);
    *pressure = mpm_gruneisen_pressure(m, j, *energy, sound_squared);
    return true;
}

/* Adds the pressure of the step with this heat to the deviator `tau`; `state` has the energy of its
 * start. */
static bool add_pressure(const struct mpm_material *m, const struct mpm_law_step *step, double heat,
                         double *state, double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    double pressure, sound_squared;
    if (!find_pressure(m, step, heat, &state[ENERGY], &pressure, &sound_squared))
        return false;
    const double mean = -mpm_determinant(step->f) * pressure;
    mpm_plastic_add_volumetric(mean, tau);
    /* mean = -J p/rho_0 has the slope J^2 (-dp/dJ)/rho_0 + mean in ln J */
    *wave = mpm_plastic_wave_squared(m, sound_squared + mean, step->f, state, tau);
    return true;
}

bool mpm_gruneisen_solid_update(const struct mpm_material *m, const struct mpm_plastic_model *model,
                                const struct mpm_law_step *step, double temperature, double heating,
                                double *state, double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const double before = state[MPM_PLASTIC_STRAIN];
    if (!mpm_plastic_return(m, model, step, temperature, state, tau))
        return false;
    const double work =
        mpm_plastic_work(m, model, step, temperature, before, state[MPM_PLASTIC_STRAIN]);
    state[WORK] += work;
    return add_pressure(m, step, step->heat + heating * work, state, tau, wave);
}

enum mpm_law_fault mpm_gruneisen_solid_fault(const struct mpm_material *m,
                                             const struct mpm_plastic_model *model,
                                             const struct mpm_law_step *step, double temperature,
                                             const double *state)
{
    double end[MPM_SOLID_VARIABLES], tau[MPM_SYMMETRIC_SIZE];
    memcpy(end, state, sizeof end);
    return mpm_plastic_return(m, model, step, temperature, end, tau) ? MPM_LAW_NO_STATE
                                                                     : MPM_LAW_NO_RETURN;
}

bool mpm_gruneisen_solid_reheat(const struct mpm_material *m, const struct mpm_law_step *step,
                                double heating, const double *old_state, double *state,
                                double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const double work = state[WORK] - old_state[WORK];
    const double mean = (tau[MPM_SYM_XX] + tau[MPM_SYM_YY] + tau[MPM_SYM_ZZ]) / 3.0;
    mpm_plastic_add_volumetric(-mean, tau);
    state[ENERGY] = old_state[ENERGY];
    return add_pressure(m, step, step->heat + heating * work, state, tau, wave);
}

double mpm_gruneisen_solid_energy(const struct mpm_material *m, double kinematic, double heating,
                                  const double f[MPM_GRADIENT_SIZE], const double *state)
{
    return state[ENERGY] + mpm_plastic_shear_energy(m, kinematic, f, state) +
           (1.0 - heating) * state[WORK];
}

double mpm_gruneisen_solid_dissipation(const struct mpm_material *m, const double *state)
{
    (void)m;
    return state[WORK];
}

double mpm_gruneisen_solid_temperature(const struct mpm_material *m,
                                       const double f[MPM_GRADIENT_SIZE], const double *state)
{
    return mpm_gruneisen_temperature(m, mpm_determinant(f), state[ENERGY]);
}
