/* Johnson and Cook's strength and Mie and Grueneisen's pressure; see gruneisen_solid.h and
 * johnson_cook.c. The temperature of the strength is that of the equation of state at the start of
 * the step, heat of compression included. Without softening all plastic work is heat.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/gruneisen_solid.h"
#include "model/laws/johnson_cook.h"

#include <math.h>

static double heating_of(const struct mpm_material *m)
{
    return mpm_johnson_cook_softens(m) ? m->parameter[MPM_PARAMETER_TAYLOR_QUINNEY] : 1.0;
}

/* At the start of the step; NaN where it does not soften. */
static double start_temperature(const struct mpm_material *m, const struct mpm_law_step *step,
                                const double *state)
{
    return mpm_johnson_cook_softens(m) ? mpm_gruneisen_solid_temperature(m, step->old_f, state)
                                       : (double)NAN;
}

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const double temperature = start_temperature(m, step, state);
    if (temperature < 0.0)
        return false;
    return mpm_gruneisen_solid_update(m, &mpm_johnson_cook_model, step, temperature, heating_of(m),
                                      state, tau, wave);
}

static bool reheat(const struct mpm_material *m, const struct mpm_law_step *step,
                   const double *old_state, double *state, double tau[MPM_SYMMETRIC_SIZE],
                   double *wave)
{
    return mpm_gruneisen_solid_reheat(m, step, heating_of(m), old_state, state, tau, wave);
}

static enum mpm_law_fault fault_of(const struct mpm_material *m, const struct mpm_law_step *step,
                                   const double *state)
{
    const double temperature = start_temperature(m, step, state);
    return temperature < 0.0
               ? MPM_LAW_COLD
               : mpm_gruneisen_solid_fault(m, &mpm_johnson_cook_model, step, temperature, state);
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    return mpm_gruneisen_solid_energy(m, 0.0, heating_of(m), f, state);
}

/* The temperature is always its own. */
static const char *fault(const double *parameter)
{
    const char *const strength = mpm_johnson_cook_fault(parameter);
    return strength != NULL ? strength : mpm_johnson_cook_fault_without_heat(parameter);
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_SHEAR},
    MPM_JOHNSON_COOK_PARAMETERS,
    MPM_GRUNEISEN_PARAMETERS,
};
static const struct mpm_law_variable variables[] = {MPM_SOLID_VARIABLE_ROWS};

const struct mpm_material_law mpm_johnson_cook_gruneisen = {
    .name = "johnson_cook_gruneisen",
    .description = "the strength of johnson_cook and the pressure of mie_gruneisen, whose "
                   "temperature softens",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = fault,
    .variables = variables,
    .variable_count = MPM_SOLID_VARIABLES,
    .update = update,
    .reheat = reheat,
    .fault_of = fault_of,
    .energy = energy,
    .keeps_heat = true,
    .least_volume = mpm_gruneisen_least_volume,
    .dissipation = mpm_gruneisen_solid_dissipation,
    .plastic_strain = MPM_PLASTIC_STRAIN,
    .temperature = mpm_gruneisen_solid_temperature,
};
