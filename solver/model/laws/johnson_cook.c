/* Johnson and Cook's strength of metals at high rates: the flow of plastic_flow.h with the yield
 * stress
 *
 *   s = (A + B p^n) (1 + C ln max(r/r_0, 1)) (1 - T*^m),   T* = (T - T_r)/(T_m - T_r)
 *
 * (Proc. 7th Int. Symp. Ballistics, 1983, 541-547). Conventions, in which codes differ:
 *
 * - r is the PLASTIC rate, dp/dt of the step, so that an elastic step has no strength of rates; it
 *   is found with p at the end of the step.
 * - below the reference rate r_0 the logarithm is cut off: a slow test has the strength A + B p^n,
 *   as the constants are fitted to it, and the strength never falls to zero at small rates.
 * - T* = 0 below T_r; from T_m on there is no strength, and the metal flows as a fluid.
 * - without the rate's or the temperature's parameters, these factors are 1.
 *
 * In a scene that conducts heat T is the conducted temperature. In others it is adiabatic and the
 * law's own: T = T_0 + chi w/c with the plastic work w per mass, the Taylor-Quinney factor chi and
 * the specific heat c. Its value in a step is that of the start of the step: softening within a
 * step would make s fall in p, for which the return has no bracket. The error is of first order in
 * the step.
 *
 * In a step r and T are constants of s, so that the plastic work of the step is the integral of
 * s in p, exactly.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/johnson_cook.h"

#include "base/exponential.h"

#include <math.h>

enum { WORK = MPM_PLASTIC_VARIABLES, VARIABLES };

/* -------------------------------------------------------------------- strength */

/* p^exponent for p >= 0, exponent > 0 */
static double power(double plastic, double exponent)
{
    return plastic > 0.0 ? mpm_exponential(exponent * mpm_logarithm(plastic)) : 0.0;
}

/* A + B p^n over rho_0, and its slope */
static double hardened(const struct mpm_material *m, double plastic, double *slope)
{
    const double b = m->parameter[MPM_PARAMETER_HARDENING_COEFFICIENT] / m->density;
    const double n = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT];
    const double yield = m->parameter[MPM_PARAMETER_YIELD_STRESS] / m->density;
    *slope = 0.0;
    if (b == 0.0)
        return yield;
    const double hardening = b * power(plastic, n);
    if (plastic > 0.0)
        *slope = n * hardening / plastic;
    else
        *slope = n < 1.0 ? HUGE_VAL : b;
    return yield + hardening;
}

/* 1 + C ln max(r/r_0, 1), and its slope in p */
static double of_rate(const struct mpm_material *m, double change, double duration, double *slope)
{
    const double c = m->parameter[MPM_PARAMETER_RATE_COEFFICIENT];
    *slope = 0.0;
    if (c == 0.0)
        return 1.0;
    const double ratio = change / (duration * m->parameter[MPM_PARAMETER_REFERENCE_RATE]);
    if (!(ratio > 1.0))
        return 1.0;
    *slope = c / change;
    return 1.0 + c * mpm_logarithm(ratio);
}

static bool is_thermal(const double *parameter)
{
    return parameter[MPM_PARAMETER_MELTING_TEMPERATURE] > 0.0;
}

/* 1 - T*^m */
static double of_temperature(const struct mpm_material *m, double temperature)
{
    const double *const given = m->parameter;
    if (!is_thermal(given))
        return 1.0;
    const double reference = given[MPM_PARAMETER_REFERENCE_TEMPERATURE];
    const double melting = given[MPM_PARAMETER_MELTING_TEMPERATURE];
    if (temperature >= melting)
        return 0.0;
    const double homologous = (temperature - reference) / (melting - reference);
    return 1.0 - power(homologous, given[MPM_PARAMETER_SOFTENING_EXPONENT]);
}

static double yield_stress(const struct mpm_material *m, const struct mpm_plastic_point *point,
                           double *slope)
{
    double hardening, rate;
    const double statics = hardened(m, point->plastic, &hardening);
    const double dynamics = of_rate(m, point->change, point->duration, &rate);
    const double softened = point->softening;
    *slope = softened > 0.0 ? softened * (hardening * dynamics + statics * rate) : 0.0;
    return softened * statics * dynamics;
}

/* ------------------------------------------------------------------------- work */

/* The integral of A + B p^n over rho_0 from 0 to p */
static double static_work(const struct mpm_material *m, double plastic)
{
    const double n = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT] + 1.0;
    const double b = m->parameter[MPM_PARAMETER_HARDENING_COEFFICIENT];
    const double hardening = b > 0.0 ? b * power(plastic, n) / n : 0.0;
    return (m->parameter[MPM_PARAMETER_YIELD_STRESS] * plastic + hardening) / m->density;
}

static double work(const struct mpm_material *m, const struct mpm_plastic_point *point)
{
    double unused;
    return point->softening * of_rate(m, point->change, point->duration, &unused) *
           (static_work(m, point->plastic) - static_work(m, point->plastic - point->change));
}

const struct mpm_plastic_model mpm_johnson_cook_model = {0.0, of_temperature, yield_stress, work};

bool mpm_johnson_cook_softens(const struct mpm_material *m)
{
    return is_thermal(m->parameter);
}

/* ---------------------------------------------------------------------- the law */

static double own_temperature(const struct mpm_material *m, const double *state)
{
    const double *const given = m->parameter;
    return given[MPM_PARAMETER_START_TEMPERATURE] +
           given[MPM_PARAMETER_TAYLOR_QUINNEY] * state[WORK] / given[MPM_PARAMETER_SPECIFIC_HEAT];
}

/* At the start of the step; NaN where it does not soften. */
static double start_temperature(const struct mpm_material *m, const struct mpm_law_step *step,
                                const double *state)
{
    if (!is_thermal(m->parameter))
        return (double)NAN;
    return mpm_material_softens(m->law, m->parameter) ? step->start_temperature
                                                      : own_temperature(m, state);
}

static double dissipation(const struct mpm_material *m, const double *state)
{
    (void)m;
    return state[WORK];
}

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    const struct mpm_plastic_model *const model = &mpm_johnson_cook_model;
    const double before = state[MPM_PLASTIC_STRAIN], start = start_temperature(m, step, state);
    if (!mpm_plastic_return(m, model, step, start, state, tau))
        return false;
    state[WORK] += mpm_plastic_work(m, model, step, start, before, state[MPM_PLASTIC_STRAIN]);
    mpm_plastic_add_volumetric(m->bulk * mpm_logarithm(mpm_determinant(step->f)), tau);
    *wave = mpm_plastic_wave_squared(m, m->bulk, step->f, state, tau);
    return true;
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    return mpm_plastic_energy(m, 0.0, f, state);
}

static double temperature(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                          const double *state)
{
    (void)f;
    return own_temperature(m, state);
}

/* How many of a list are given. */
static int count_given(const double *parameter, const enum mpm_parameter *list, int count)
{
    int given = 0;
    for (int k = 0; k < count; k++)
        given += parameter[list[k]] > 0.0;
    return given;
}

/* Softening, at a temperature of the law's own or at one that is conducted. */
static const char *thermal_fault(const double *parameter)
{
    static const enum mpm_parameter softening[] = {MPM_PARAMETER_SOFTENING_EXPONENT,
                                                   MPM_PARAMETER_REFERENCE_TEMPERATURE,
                                                   MPM_PARAMETER_MELTING_TEMPERATURE};
    enum { SOFTENING = sizeof softening / sizeof softening[0] };
    const int given = count_given(parameter, softening, SOFTENING);
    if (given != 0 && given != SOFTENING)
        return "softening requires softening_exponent, reference_temperature and "
               "melting_temperature; allowed: all or none";
    if (given != 0 && !(parameter[MPM_PARAMETER_REFERENCE_TEMPERATURE] <
                        parameter[MPM_PARAMETER_MELTING_TEMPERATURE]))
        return "melting_temperature is not above reference_temperature; allowed: above";
    if (given != 0 && !(parameter[MPM_PARAMETER_START_TEMPERATURE] <
                        parameter[MPM_PARAMETER_MELTING_TEMPERATURE]))
        return "start_temperature is not below melting_temperature; allowed: below";
    return NULL;
}

const char *mpm_johnson_cook_fault_without_heat(const double *parameter)
{
    static const enum mpm_parameter thermal[] = {
        MPM_PARAMETER_SOFTENING_EXPONENT,  MPM_PARAMETER_REFERENCE_TEMPERATURE,
        MPM_PARAMETER_MELTING_TEMPERATURE, MPM_PARAMETER_START_TEMPERATURE,
        MPM_PARAMETER_SPECIFIC_HEAT,       MPM_PARAMETER_TAYLOR_QUINNEY};
    enum { THERMAL = sizeof thermal / sizeof thermal[0] };
    const int given = count_given(parameter, thermal, THERMAL);
    return given == 0 || given == THERMAL
               ? NULL
               : "softening by a temperature of its own requires softening_exponent, "
                 "reference_temperature, melting_temperature, start_temperature, specific_heat and "
                 "taylor_quinney; allowed: all or none";
}

const char *mpm_johnson_cook_fault(const double *parameter)
{
    const char *const thermal = thermal_fault(parameter);
    if (thermal != NULL)
        return thermal;
    if ((parameter[MPM_PARAMETER_HARDENING_COEFFICIENT] > 0.0) !=
        (parameter[MPM_PARAMETER_HARDENING_EXPONENT] > 0.0))
        return "hardening by a power requires hardening_coefficient and hardening_exponent; "
               "allowed: both or none";
    if ((parameter[MPM_PARAMETER_RATE_COEFFICIENT] > 0.0) !=
        (parameter[MPM_PARAMETER_REFERENCE_RATE] > 0.0))
        return "strength of rates requires rate_coefficient and reference_rate; allowed: both or "
               "none";
    return NULL;
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_BULK},
    {.which = MPM_PARAMETER_SHEAR},
    MPM_JOHNSON_COOK_PARAMETERS,
};
static const struct mpm_law_variable variables[VARIABLES] = {
    MPM_PLASTIC_VARIABLE_ROWS,
    {"plastic_work", MPM_DIMENSION_SPECIFIC_ENERGY, 0.0, "per mass"},
};

const struct mpm_material_law mpm_johnson_cook = {
    .name = "johnson_cook",
    .description = "tau = K ln J I + 2 G dev ln V_e, F = F_e F_p; yields at |dev tau| = sqrt(2/3) "
                   "s, s = (A + B p^n) (1 + C ln max(r/r_0, 1)) (1 - T*^m), "
                   "adiabatic without conduction",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = mpm_johnson_cook_fault,
    .fault_without_heat = mpm_johnson_cook_fault_without_heat,
    .variables = variables,
    .variable_count = VARIABLES,
    .update = update,
    .energy = energy,
    .dissipation = dissipation,
    .plastic_strain = MPM_PLASTIC_STRAIN,
    .plane_stress = true,
    .temperature = temperature,
};
