/* Mie and Grueneisen's equation of state for four particles: the vector twin of
 * model/laws/mie_gruneisen.c, to the same bits, without what is rare: states at the cut-off, and
 * isentropes too far for a series. Equations stand in mie_gruneisen.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_GRUNEISEN_VECTOR_H
#define MPM_METHOD_FAST_GRUNEISEN_VECTOR_H

#include "method/fast/metals/metal.h"
#include "model/laws/mie_gruneisen.h"

/* A and dA/deta */
MPM_INLINE mpm_vector cold_pressure_vector(const struct mpm_material *m, mpm_vector eta,
                                           mpm_vector *slope)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double square = speed * speed;
    const mpm_vector way = 1.0 - s * eta;
    const mpm_mask tension = mpm_less(eta, mpm_splat(0.0));
    *slope = mpm_select(tension, mpm_splat(square),
                        square * (1.0 + (s - gamma) * eta) / (way * way * way));
    return mpm_select(tension, square * eta,
                      square * eta * (1.0 - 0.5 * gamma * eta) / (way * way));
}

/* Which are not at the cut-off with A + gamma_0 e = whole? */
MPM_INLINE mpm_mask is_whole_vector(const struct mpm_material *m, mpm_vector whole)
{
    const double tension = m->parameter[MPM_PARAMETER_PRESSURE_CUTOFF] / m->density;
    return ~mpm_less(whole, mpm_splat(-tension));
}

/* e, p/rho_0 and c^2 at the end of the step from old_j to j; those without end leave *found. */
MPM_INLINE mpm_vector gruneisen_advance_vector(const struct mpm_material *m, mpm_vector old_j,
                                               mpm_vector j, mpm_vector heat, mpm_vector *energy,
                                               mpm_vector *sound_squared, mpm_mask *found)
{
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double tension = m->parameter[MPM_PARAMETER_PRESSURE_CUTOFF] / m->density;
    const mpm_vector zero = mpm_splat(0.0);
    mpm_vector slope;
    const mpm_vector old = cold_pressure_vector(m, 1.0 - old_j, &slope) + gamma * *energy;
    const mpm_vector cold = cold_pressure_vector(m, 1.0 - j, &slope);
    const mpm_vector change = j - old_j, part = 1.0 + 0.5 * gamma * change;
    const mpm_vector mean = 0.5 * (tension - old);
    const mpm_vector cut = cold + gamma * (*energy + mean * change + heat);
    *energy = (*energy - 0.5 * (old + cold) * change + heat) / part;
    const mpm_vector pressure = cold + gamma * *energy;
    *sound_squared = j * j * (slope + gamma * pressure);
    *found &= mpm_less(mpm_splat(mpm_gruneisen_least_volume(m)), j) & mpm_less(zero, part) &
              is_whole_vector(m, old) & is_whole_vector(m, cut) & is_whole_vector(m, pressure) &
              mpm_less(zero, *sound_squared);
    return pressure;
}

MPM_INLINE mpm_vector energy_by_series_vector(const struct mpm_material *m, mpm_vector eta)
{
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const mpm_vector u = s * eta, gamma = m->parameter[MPM_PARAMETER_GRUNEISEN] * eta;
    mpm_vector part = mpm_splat(0.0), sum = part, power = mpm_splat(1.0), before = part;
    mpm_mask going = mpm_less(mpm_splat(0.0), eta);
    for (int k = 1; k < MPM_GRUNEISEN_TERMS && mpm_any(going); k++) {
        const mpm_vector now = (double)k * power;
        part = (gamma * part + (now - 0.5 * gamma * before)) * mpm_gruneisen_inverse[k + 1];
        sum = mpm_select(going, sum + part, sum);
        going &= ~mpm_at_most(now + mpm_absolute(gamma * part), MPM_GRUNEISEN_LEAST * sum);
        before = now;
        power *= u;
    }
    return speed * speed * eta * eta * sum;
}

MPM_INLINE mpm_vector energy_stretched_vector(const struct mpm_material *m, mpm_vector eta)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const mpm_vector z = m->parameter[MPM_PARAMETER_GRUNEISEN] * eta;
    mpm_vector part = mpm_splat(1.0);
#pragma GCC unroll 16
    for (int k = MPM_GRUNEISEN_STRETCHED_TERMS; k > 0; k--)
        part = 1.0 + z * mpm_gruneisen_inverse[k + 2] * part;
    return 0.5 * speed * speed * eta * eta * part;
}

/* T at J and e; those for which it is not here leave *found. */
MPM_INLINE mpm_vector gruneisen_temperature_vector(const struct mpm_material *m, mpm_vector j,
                                                   mpm_vector energy, mpm_mask *found)
{
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const mpm_vector eta = 1.0 - j, zero = mpm_splat(0.0);
    const mpm_mask compressed = mpm_less(zero, eta);
    mpm_vector unused;
    *found &= is_whole_vector(m, cold_pressure_vector(m, eta, &unused) + gamma * energy) &
              mpm_at_most(s * eta, mpm_splat(MPM_GRUNEISEN_SERIES)) &
              mpm_at_most(mpm_splat(-1.0), gamma * eta);
    mpm_vector isentropic = zero;
    if (mpm_any(~compressed))
        isentropic = energy_stretched_vector(m, eta);
    if (mpm_any(compressed))
        isentropic = mpm_select(compressed, energy_by_series_vector(m, eta), isentropic);
    const mpm_vector start =
        m->parameter[MPM_PARAMETER_START_TEMPERATURE] * mpm_exponential_vector(gamma * eta);
    return start + (energy - isentropic) / m->parameter[MPM_PARAMETER_SPECIFIC_HEAT];
}

#endif
