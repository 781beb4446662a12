/* Ideal gas: p = rho R T, so that tau / rho_0 = -R T I whatever its density. Its energy is all
 * thermal, c_v T: the scene's heat_capacity is that at constant volume. Compressed without flow of
 * heat, c_v dT = -R T dJ / J.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include <math.h>

/* c^2 = gamma R T, gamma = 1 + R / c_v; or R T where deformation gives no heat */
static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const double r = m->parameter[MPM_PARAMETER_GAS_CONSTANT];
    const double pressure = r * step->temperature;
    (void)state;
    tau[MPM_SYM_XX] = tau[MPM_SYM_YY] = tau[MPM_SYM_ZZ] = -pressure;
    tau[MPM_SYM_XY] = 0.0;
    *wave_speed_squared =
        isnan(step->heat_capacity) ? pressure : pressure * (1.0 + r / step->heat_capacity);
    return true;
}

static double adiabatic(const struct mpm_material *m, const struct mpm_law_step *step)
{
    const double r = m->parameter[MPM_PARAMETER_GAS_CONSTANT];
    const double ratio = mpm_determinant(step->old_f) / mpm_determinant(step->f);
    return step->temperature * pow(ratio, r / step->heat_capacity);
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    (void)m;
    (void)f;
    (void)state;
    return 0.0;
}

static const struct mpm_law_parameter parameters[] = {{.which = MPM_PARAMETER_GAS_CONSTANT}};

const struct mpm_material_law mpm_ideal_gas = {
    .name = "ideal_gas",
    .description = "p = rho R T; with transport.temperature, and no plane stress",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .reads_temperature = true,
    .update = update,
    .adiabatic = adiabatic,
    .energy = energy,
};
