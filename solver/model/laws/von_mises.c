/* Von Mises elastoplasticity at finite strain: the flow of plastic_flow.h with the yield stress
 *
 *   s(p) = Y (1 + p/p_0)^n + H p,
 *
 * or a table of s over p, linear between its points and constant beyond the last one; and linear
 * kinematic hardening.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/von_mises.h"

#include "base/exponential.h"

#include <math.h>

/* -------------------------------------------------------------------- hardening */

static double over_density(const struct mpm_material *m, enum mpm_parameter which)
{
    return m->parameter[which] / m->density;
}

/* (1 + p/p_0)^exponent; 1 without hardening by a power */
static double power_of(const struct mpm_material *m, double plastic, double exponent)
{
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    return scale > 0.0 ? mpm_exponential(exponent * mpm_logarithm(1.0 + plastic / scale)) : 1.0;
}

/* s(p) and ds/dp over rho_0 of a table; at a point the slope is that beyond it. */
static double tabulated(const struct mpm_material *m, double plastic, double *slope)
{
    *slope = mpm_property_slope(m->hardening, plastic) / m->density;
    return mpm_property_value(m->hardening, plastic) / m->density;
}

/* s(p) and ds/dp over rho_0 */
static double yield_stress(const struct mpm_material *m, const struct mpm_plastic_point *point,
                           double *slope)
{
    const double plastic = point->plastic;
    if (m->hardening != NULL)
        return tabulated(m, plastic, slope);
    const double yield = over_density(m, MPM_PARAMETER_YIELD_STRESS);
    const double modulus = over_density(m, MPM_PARAMETER_HARDENING_MODULUS);
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    const double exponent = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT];
    const double stress = yield * power_of(m, plastic, exponent);
    *slope = modulus + (scale > 0.0 ? exponent * stress / (scale + plastic) : 0.0);
    return stress + modulus * plastic;
}

/* Integral of s from 0 to p, over rho_0. */
static double whole_work(const struct mpm_material *m, double plastic)
{
    if (m->hardening != NULL)
        return mpm_property_integral(m->hardening, plastic) / m->density;
    const double yield = over_density(m, MPM_PARAMETER_YIELD_STRESS);
    const double modulus = over_density(m, MPM_PARAMETER_HARDENING_MODULUS);
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    const double exponent = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT] + 1.0;
    const double powers =
        scale > 0.0 ? scale / exponent * (power_of(m, plastic, exponent) - 1.0) : plastic;
    return yield * powers + 0.5 * modulus * plastic * plastic;
}

static double work(const struct mpm_material *m, const struct mpm_plastic_point *point)
{
    return whole_work(m, point->plastic) - whole_work(m, point->plastic - point->change);
}

/* -------------------------------------------------------------- of laws that have it */

struct mpm_plastic_model mpm_von_mises_model(const struct mpm_material *m)
{
    return (struct mpm_plastic_model){over_density(m, MPM_PARAMETER_KINEMATIC_MODULUS), NULL,
                                      yield_stress, work};
}

double mpm_von_mises_dissipation(const struct mpm_material *m, const double *state)
{
    return whole_work(m, state[MPM_PLASTIC_STRAIN]);
}

const char *mpm_von_mises_fault(const double *parameter)
{
    return (parameter[MPM_PARAMETER_HARDENING_STRAIN] > 0.0) ==
                   (parameter[MPM_PARAMETER_HARDENING_EXPONENT] > 0.0)
               ? NULL
               : "hardening by a power requires hardening_strain and hardening_exponent; allowed: "
                 "both or none";
}

/* ---------------------------------------------------------------------- the law */

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const struct mpm_plastic_model model = mpm_von_mises_model(m);
    if (!mpm_plastic_return(m, &model, step, (double)NAN, state, tau))
        return false;
    mpm_plastic_add_volumetric(m->bulk * mpm_logarithm(mpm_determinant(step->f)), tau);
    *wave = mpm_plastic_wave_squared(m, m->bulk, step->f, state, tau);
    return true;
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    return mpm_plastic_energy(m, mpm_von_mises_model(m).kinematic, f, state);
}

/* The law has no temperature of its own. */
static const char *fault_without_heat(const double *parameter)
{
    return parameter[MPM_PARAMETER_TAYLOR_QUINNEY] > 0.0
               ? "taylor_quinney in a scene without transport.temperature, where plastic work "
                 "heats "
                 "nothing; allowed: with transport.temperature and its heating: true"
               : NULL;
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_BULK},
    {.which = MPM_PARAMETER_SHEAR},
    MPM_VON_MISES_PARAMETERS,
    {.which = MPM_PARAMETER_TAYLOR_QUINNEY, .optional = true},
};
static const struct mpm_law_variable variables[] = {MPM_PLASTIC_VARIABLE_ROWS};

const struct mpm_material_law mpm_von_mises = {
    .name = "von_mises",
    .description = "tau = K ln J I + 2 G dev ln V_e, F = F_e F_p; yields at |dev tau - beta| = "
                   "sqrt(2/3) s(p), s = Y (1 + p/p_0)^n + H p",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = mpm_von_mises_fault,
    .fault_without_heat = fault_without_heat,
    .variables = variables,
    .variable_count = MPM_PLASTIC_VARIABLES,
    .update = update,
    .energy = energy,
    .dissipation = mpm_von_mises_dissipation,
    .plastic_strain = MPM_PLASTIC_STRAIN,
    .hardening_table = true,
    .plane_stress = true,
};
