/* Stiffened gas: p = (gamma - 1) rho e - gamma p_inf, an ideal gas where p_inf = 0; e, per mass, is
 * a state variable. At the start e = (p_0 + gamma p_inf)/((gamma - 1) rho_0).
 *
 * Energy over a step: de = -p dJ/rho_0 + dq by the trapezoidal rule, with the pressure at its end,
 * linear in e, solved for as in mie_gruneisen.h: with b = (gamma - 1)/J',
 *
 *   e' = (e - (p - gamma p_inf) dJ/(2 rho_0) + dq) / (1 + b dJ/2).
 *
 * Sound: c^2 = gamma (p + p_inf)/rho. Temperature: T = (e - p_inf/rho)/c_v, c_v constant.
 * Isentrope: (p + p_inf) J^gamma constant. (Harlow and Amsden, Fluid Dynamics, LA-4700, 1971; Le
 * Metayer et al., Int. J. Therm. Sci. 43 (2004) 265-276.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include <math.h>

enum { ENERGY, VARIABLES };

static double stiffening(const struct mpm_material *m)
{
    return m->parameter[MPM_PARAMETER_STIFFENING_PRESSURE] / m->density;
}

static double start_energy(const struct mpm_material *m)
{
    const double gamma = m->parameter[MPM_PARAMETER_ADIABATIC_INDEX];
    const double pressure = m->parameter[MPM_PARAMETER_START_PRESSURE] / m->density;
    return (pressure + gamma * stiffening(m)) / (gamma - 1.0);
}

/* p/rho_0 and c^2; from the change of energy, so that a liquid at rest has its start_pressure to
 * the last bit */
static double pressure_of(const struct mpm_material *m, double j, double energy,
                          double *sound_squared)
{
    const double gamma = m->parameter[MPM_PARAMETER_ADIABATIC_INDEX];
    const double start = m->parameter[MPM_PARAMETER_START_PRESSURE] / m->density;
    const double pressure = (gamma - 1.0) * (energy - start_energy(m)) / j +
                            (start + gamma * stiffening(m)) / j - gamma * stiffening(m);
    *sound_squared = gamma * (pressure + stiffening(m)) * j;
    return pressure;
}

static bool advance(const struct mpm_material *m, const struct mpm_law_step *step, double *energy)
{
    const double gamma = m->parameter[MPM_PARAMETER_ADIABATIC_INDEX];
    const double old_j = mpm_determinant(step->old_f), j = mpm_determinant(step->f);
    const double change = j - old_j, part = 1.0 + 0.5 * (gamma - 1.0) * change / j;
    double unused;
    if (!(part > 0.0))
        return false;
    const double old = pressure_of(m, old_j, *energy, &unused);
    *energy = (*energy - 0.5 * (old - gamma * stiffening(m)) * change + step->heat) / part;
    return true;
}

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const double j = mpm_determinant(step->f);
    if (step->duration > 0.0 && !advance(m, step, &state[ENERGY]))
        return false;
    const double pressure = pressure_of(m, j, state[ENERGY], wave_speed_squared);
    tau[MPM_SYM_XX] = tau[MPM_SYM_YY] = tau[MPM_SYM_ZZ] = -j * pressure;
    tau[MPM_SYM_XY] = 0.0;
    return *wave_speed_squared > 0.0;
}

static void start(const struct mpm_material *m, double *state)
{
    state[ENERGY] = start_energy(m);
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    (void)m;
    (void)f;
    return state[ENERGY];
}

static double temperature(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                          const double *state)
{
    return (state[ENERGY] - stiffening(m) * mpm_determinant(f)) /
           m->parameter[MPM_PARAMETER_SPECIFIC_HEAT];
}

static double least_volume(const struct mpm_material *m)
{
    (void)m;
    return 0.0;
}

static const char *fault(const double *parameter)
{
    return parameter[MPM_PARAMETER_START_PRESSURE] + parameter[MPM_PARAMETER_STIFFENING_PRESSURE] >
                   0.0
               ? NULL
               : "without start_pressure and stiffening_pressure sound has no speed; allowed: one "
                 "of them above 0";
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_ADIABATIC_INDEX},
    {.which = MPM_PARAMETER_START_PRESSURE},
    {.which = MPM_PARAMETER_STIFFENING_PRESSURE, .optional = true},
    {.which = MPM_PARAMETER_SPECIFIC_HEAT, .optional = true},
};
static const struct mpm_law_variable variables[VARIABLES] = {
    {"internal_energy", MPM_DIMENSION_SPECIFIC_ENERGY, 0.0,
     "per mass; (p_0 + gamma p_inf)/((gamma - 1) rho_0) at the start"},
};

const struct mpm_material_law mpm_stiffened_gas = {
    .name = "stiffened_gas",
    .description = "p = (gamma - 1) rho e - gamma p_inf; without flow of heat, and no plane stress",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = fault,
    .variables = variables,
    .variable_count = VARIABLES,
    .start = start,
    .update = update,
    .energy = energy,
    .keeps_heat = true,
    .least_volume = least_volume,
    .temperature = temperature,
};
