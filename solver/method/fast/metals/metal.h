/* Metals in fast kernels: constants of a body's law, and its yield stress for four particles. The
 * vector twins of model/laws/johnson_cook.c and von_mises.c, to the same bits; equations stand
 * there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_METAL_H
#define MPM_METHOD_FAST_METAL_H

#include "base/exponential_vector.h"
#include "method/fast/fast_constants.h"
#include "model/laws/plastic_flow.h"

/* Which law; a constant of an instance. */
struct metal_law {
    bool johnson_cook; /* else von Mises */
    bool gruneisen;    /* else the pressure K ln J */
};

/* The laws, with the members of struct metal_law. */
#define MPM_VECTOR_METALS(LAW)                                                                     \
    LAW(von_mises, false, false)                                                                   \
    LAW(johnson_cook, true, false)                                                                 \
    LAW(von_mises_gruneisen, false, true)                                                          \
    LAW(johnson_cook_gruneisen, true, true)

/* Of a body and a part of a time step. Stresses are over rho_0. */
struct metal {
    const struct mpm_material *material;
    double shear, duration;
    double yield, hardening; /* Y; B of Johnson and Cook, or H */
    double exponent;         /* n */
    double strain;           /* p_0 of von Mises; 0: no hardening by a power */
    double rate;             /* C; 0: no strength of rates */
    double rate_slip;        /* plastic strain of the step at the rate r_0 */
    bool softens;            /* by a temperature of its own */
    double reference, melting, softening_exponent;
    double heating; /* part of plastic work that becomes heat */
};

/* A parameter, 0 where the scene does not give it. */
MPM_INLINE double metal_parameter(const struct mpm_material *m, enum mpm_parameter which)
{
    return m->parameter[which] > 0.0 ? m->parameter[which] : 0.0;
}

MPM_INLINE struct metal metal_of(struct metal_law law, const struct mpm_material *m,
                                 double duration)
{
    struct metal metal = {
        .material = m,
        .shear = m->shear,
        .duration = duration,
        .yield = m->parameter[MPM_PARAMETER_YIELD_STRESS] / m->density,
        .exponent = metal_parameter(m, MPM_PARAMETER_HARDENING_EXPONENT),
        .heating = 1.0,
    };
    if (!law.johnson_cook) {
        metal.hardening = metal_parameter(m, MPM_PARAMETER_HARDENING_MODULUS) / m->density;
        metal.strain = metal_parameter(m, MPM_PARAMETER_HARDENING_STRAIN);
        return metal;
    }
    metal.hardening = metal_parameter(m, MPM_PARAMETER_HARDENING_COEFFICIENT) / m->density;
    metal.rate = metal_parameter(m, MPM_PARAMETER_RATE_COEFFICIENT);
    metal.rate_slip = duration * metal_parameter(m, MPM_PARAMETER_REFERENCE_RATE);
    metal.softens = m->parameter[MPM_PARAMETER_MELTING_TEMPERATURE] > 0.0;
    metal.reference = metal_parameter(m, MPM_PARAMETER_REFERENCE_TEMPERATURE);
    metal.melting = metal_parameter(m, MPM_PARAMETER_MELTING_TEMPERATURE);
    metal.softening_exponent = metal_parameter(m, MPM_PARAMETER_SOFTENING_EXPONENT);
    if (metal.softens)
        metal.heating = metal_parameter(m, MPM_PARAMETER_TAYLOR_QUINNEY);
    return metal;
}

/* x^exponent for x > 0, else 0 */
MPM_INLINE mpm_vector power_vector(mpm_vector x, double exponent)
{
    const mpm_mask positive = mpm_less(mpm_splat(0.0), x);
    if (!mpm_any(positive)) /* particles at rest */
        return mpm_splat(0.0);
    const mpm_vector power = mpm_exponential_vector(exponent * mpm_logarithm_vector(x));
    return mpm_select(positive, power, mpm_splat(0.0));
}

/* ------------------------------------------------------------- Johnson and Cook */

MPM_INLINE mpm_vector hardened_vector(const struct metal *metal, mpm_vector plastic,
                                      mpm_vector *slope)
{
    const double n = metal->exponent, b = metal->hardening;
    *slope = mpm_splat(0.0);
    if (b == 0.0)
        return mpm_splat(metal->yield);
    const mpm_vector hardening = b * power_vector(plastic, n);
    *slope = mpm_select(mpm_less(mpm_splat(0.0), plastic), n * hardening / plastic,
                        mpm_splat(n < 1.0 ? HUGE_VAL : b));
    return metal->yield + hardening;
}

MPM_INLINE mpm_vector of_rate_vector(const struct metal *metal, mpm_vector change,
                                     mpm_vector *slope)
{
    const double c = metal->rate;
    const mpm_vector one = mpm_splat(1.0), zero = mpm_splat(0.0);
    *slope = zero;
    if (c == 0.0)
        return one;
    const mpm_vector ratio = change / metal->rate_slip;
    const mpm_mask fast = mpm_less(one, ratio);
    if (!mpm_any(fast))
        return one;
    *slope = mpm_select(fast, c / change, zero);
    return mpm_select(fast, 1.0 + c * mpm_logarithm_vector(ratio), one);
}

/* 1 - T*^m */
MPM_INLINE mpm_vector of_temperature_vector(const struct metal *metal, mpm_vector temperature)
{
    const mpm_vector homologous =
        (temperature - metal->reference) / (metal->melting - metal->reference);
    return mpm_select(mpm_at_most(mpm_splat(metal->melting), temperature), mpm_splat(0.0),
                      1.0 - power_vector(homologous, metal->softening_exponent));
}

MPM_INLINE mpm_vector johnson_cook_vector(const struct metal *metal, mpm_vector plastic,
                                          mpm_vector change, mpm_vector softening,
                                          mpm_vector *slope)
{
    mpm_vector hardening, rate;
    const mpm_vector statics = hardened_vector(metal, plastic, &hardening);
    const mpm_vector dynamics = of_rate_vector(metal, change, &rate);
    const mpm_vector zero = mpm_splat(0.0);
    *slope = mpm_select(mpm_less(zero, softening),
                        softening * (hardening * dynamics + statics * rate), zero);
    return softening * statics * dynamics;
}

MPM_INLINE mpm_vector static_work_vector(const struct metal *metal, mpm_vector plastic)
{
    const double *const given = metal->material->parameter;
    const double n = given[MPM_PARAMETER_HARDENING_EXPONENT] + 1.0;
    const double b = given[MPM_PARAMETER_HARDENING_COEFFICIENT];
    const mpm_vector hardening = b > 0.0 ? b * power_vector(plastic, n) / n : mpm_splat(0.0);
    return (given[MPM_PARAMETER_YIELD_STRESS] * plastic + hardening) / metal->material->density;
}

MPM_INLINE mpm_vector johnson_cook_work_vector(const struct metal *metal, mpm_vector plastic,
                                               mpm_vector change, mpm_vector softening)
{
    mpm_vector unused;
    return softening * of_rate_vector(metal, change, &unused) *
           (static_work_vector(metal, plastic) - static_work_vector(metal, plastic - change));
}

/* ------------------------------------------------------------------- von Mises */

/* (1 + p/p_0)^exponent, with hardening by a power */
MPM_INLINE mpm_vector von_mises_power(const struct metal *metal, mpm_vector plastic,
                                      double exponent)
{
    return mpm_exponential_vector(exponent * mpm_logarithm_vector(1.0 + plastic / metal->strain));
}

MPM_INLINE mpm_vector von_mises_vector(const struct metal *metal, mpm_vector plastic,
                                       mpm_vector *slope)
{
    const double n = metal->exponent, modulus = metal->hardening;
    *slope = mpm_splat(modulus);
    if (!(metal->strain > 0.0))
        return metal->yield + modulus * plastic;
    const mpm_vector stress = metal->yield * von_mises_power(metal, plastic, n);
    *slope = modulus + n * stress / (metal->strain + plastic);
    return stress + modulus * plastic;
}

MPM_INLINE mpm_vector von_mises_whole_work(const struct metal *metal, mpm_vector plastic)
{
    const double n = metal->exponent + 1.0;
    mpm_vector powers = plastic;
    if (metal->strain > 0.0)
        powers = metal->strain / n * (von_mises_power(metal, plastic, n) - 1.0);
    return metal->yield * powers + 0.5 * metal->hardening * plastic * plastic;
}

/* --------------------------------------------------------------------- of a law */

/* s after a step that changes p by `change` to `plastic`, and ds/dp */
MPM_INLINE mpm_vector metal_strength(struct metal_law law, const struct metal *metal,
                                     mpm_vector plastic, mpm_vector change, mpm_vector softening,
                                     mpm_vector *slope)
{
    return law.johnson_cook ? johnson_cook_vector(metal, plastic, change, softening, slope)
                            : von_mises_vector(metal, plastic, slope);
}

/* Plastic work per mass of that step. */
MPM_INLINE mpm_vector metal_work(struct metal_law law, const struct metal *metal,
                                 mpm_vector plastic, mpm_vector change, mpm_vector softening)
{
    return law.johnson_cook ? johnson_cook_work_vector(metal, plastic, change, softening)
                            : von_mises_whole_work(metal, plastic) -
                                  von_mises_whole_work(metal, plastic - change);
}

#endif
