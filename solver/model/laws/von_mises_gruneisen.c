/* Von Mises' strength and Mie and Grueneisen's pressure; see gruneisen_solid.h and von_mises.c. All
 * plastic work is heat.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/gruneisen_solid.h"
#include "model/laws/von_mises.h"

#include <math.h>

static const double HEATING = 1.0;

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const struct mpm_plastic_model model = mpm_von_mises_model(m);
    return mpm_gruneisen_solid_update(m, &model, step, (double)NAN, HEATING, state, tau, wave);
}

static bool reheat(const struct mpm_material *m, const struct mpm_law_step *step,
                   const double *old_state, double *state, double tau[MPM_SYMMETRIC_SIZE],
                   double *wave)
{
    return mpm_gruneisen_solid_reheat(m, step, HEATING, old_state, state, tau, wave);
}

static enum mpm_law_fault fault_of(const struct mpm_material *m, const struct mpm_law_step *step,
                                   const double *state)
{
    const struct mpm_plastic_model model = mpm_von_mises_model(m);
    return mpm_gruneisen_solid_fault(m, &model, step, (double)NAN, state);
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    return mpm_gruneisen_solid_energy(m, mpm_von_mises_model(m).kinematic, HEATING, f, state);
}

static const char *fault(const double *parameter)
{
    const char *const strength = mpm_von_mises_fault(parameter);
    return strength != NULL ? strength : mpm_gruneisen_fault(parameter);
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_SHEAR},
    MPM_VON_MISES_PARAMETERS,
    MPM_GRUNEISEN_PARAMETERS,
    MPM_GRUNEISEN_TEMPERATURE_PARAMETERS,
};
static const struct mpm_law_variable variables[] = {MPM_SOLID_VARIABLE_ROWS};

const struct mpm_material_law mpm_von_mises_gruneisen = {
    .name = "von_mises_gruneisen",
    .description = "the strength of von_mises and the pressure of mie_gruneisen; all plastic work "
                   "is heat",
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
    .hardening_table = true,
    .temperature = mpm_gruneisen_solid_temperature,
};
