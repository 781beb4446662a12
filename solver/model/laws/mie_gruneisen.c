/* A fluid with Mie and Grueneisen's equation of state; see mie_gruneisen.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/mie_gruneisen.h"

#include "base/exponential.h"

#include <math.h>

/* -------------------------------------------------------------------- the equation */

/* A and dA/deta */
static double cold_pressure(const struct mpm_material *m, double eta, double *slope)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double square = speed * speed, way = 1.0 - s * eta;
    *slope = square;
    if (eta < 0.0)
        return square * eta;
    *slope = square * (1.0 + (s - gamma) * eta) / (way * way * way);
    return square * eta * (1.0 - 0.5 * gamma * eta) / (way * way);
}

double mpm_gruneisen_least_volume(const struct mpm_material *m)
{
    return fmax(0.0, 1.0 - 1.0 / m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE]);
}

/* A + gamma_0 e: p/rho_0 without the cut-off */
static double whole_pressure(const struct mpm_material *m, double j, double energy)
{
    double unused;
    return cold_pressure(m, 1.0 - j, &unused) + m->parameter[MPM_PARAMETER_GRUNEISEN] * energy;
}

/* ------------------------------------------------------------------------ cut-off */

/* p_c/rho_0; infinite without a cut-off: nothing is below -p_c then. */
static double most_tension(const struct mpm_material *m)
{
    return m->parameter[MPM_PARAMETER_PRESSURE_CUTOFF] / m->density;
}

static bool is_cut(const struct mpm_material *m, double whole)
{
    return whole < -most_tension(m);
}

/* c_0^2 - gamma_0 p_c/rho_0, what A' + gamma_0 p/rho_0 is at the cut-off */
static double stiffness_at_cut(const struct mpm_material *m)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    return speed * speed - m->parameter[MPM_PARAMETER_GRUNEISEN] * most_tension(m);
}

/* J at which A + gamma_0 e is the cut-off, on the way from j with this mean tension over rho_0. It
 * is in tension, where A is linear. */
static double volume_at_cut(const struct mpm_material *m, double j, double energy, double mean)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double square = speed * speed;
    return (square + most_tension(m) + gamma * (energy - mean * j)) / (square - gamma * mean);
}

/* J_c of a cut state */
static double material_volume(const struct mpm_material *m, double j, double energy)
{
    return volume_at_cut(m, j, energy, most_tension(m));
}

/* c^2 of a cut state; 0: it has none. */
static double cut_sound_squared(const struct mpm_material *m, double j, double energy)
{
    const double volume = material_volume(m, j, energy), stiffness = stiffness_at_cut(m);
    return volume > 0.0 && stiffness > 0.0 ? volume * volume * stiffness : 0.0;
}

/* ----------------------------------------------------------------------- pressure */

double mpm_gruneisen_pressure(const struct mpm_material *m, double j, double energy,
                              double *sound_squared)
{
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    double slope;
    const double pressure = cold_pressure(m, 1.0 - j, &slope) + gamma * energy;
    if (is_cut(m, pressure)) {
        *sound_squared = cut_sound_squared(m, j, energy);
        return -most_tension(m);
    }
    *sound_squared = j * j * (slope + gamma * pressure);
    return pressure;
}

/* The part of a step to j in which voids open or close and the material stays as it is. */
static void change_voids(const struct mpm_material *m, double j, double *old_j, double *energy)
{
    if (!is_cut(m, whole_pressure(m, *old_j, *energy)))
        return;
    const double volume = fmax(j, material_volume(m, *old_j, *energy));
    *energy -= most_tension(m) * (*old_j - volume);
    *old_j = volume;
}

bool mpm_gruneisen_advance(const struct mpm_material *m, double old_j, double j, double heat,
                           double *energy, double *pressure, double *sound_squared)
{
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    double unused;
    if (!(j > mpm_gruneisen_least_volume(m)))
        return false;
    change_voids(m, j, &old_j, energy);
    const double old = mpm_gruneisen_pressure(m, old_j, *energy, &unused);
    const double cold = cold_pressure(m, 1.0 - j, &unused);
    const double change = j - old_j, part = 1.0 + 0.5 * gamma * change;
    const double mean = 0.5 * (most_tension(m) - old);
    if (is_cut(m, cold + gamma * (*energy + mean * change + heat))) {
        const double volume = volume_at_cut(m, old_j, *energy, mean);
        *energy += mean * (volume - old_j) + most_tension(m) * (j - volume) + heat;
    } else if (part > 0.0) {
        *energy = (*energy - 0.5 * (old + cold) * change + heat) / part;
    } else {
        return false;
    }
    *pressure = mpm_gruneisen_pressure(m, j, *energy, sound_squared);
    return *sound_squared > 0.0;
}

/* --------------------------------------------------------------------- temperature */

/* Gauss and Legendre's points and weights on (-1, 1), those above 0. */
enum { HALF = 4 };
static const double gauss[HALF][2] = {{0.18343464249564980494, 0.36268378337836198297},
                                      {0.52553240991632898582, 0.31370664587788728734},
                                      {0.79666647741362673959, 0.22238103445337447054},
                                      {0.96028985649753623168, 0.10122853629037625915}};

/* exp(gamma (eta - x)) A(x) dx/dy for y = -ln(1 - s x)/s: an entire function of y, without the pole
 * of x. */
static double integrand(const struct mpm_material *m, double eta, double y)
{
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double way = mpm_exponential(-s * y), x = (1.0 - way) / s;
    double unused;
    return mpm_exponential(m->parameter[MPM_PARAMETER_GRUNEISEN] * (eta - x)) * way *
           cold_pressure(m, x, &unused);
}

/* Up to this, in y times the largest of 1, s and gamma_0, eight points are exact to round-off. */
static const double PANEL = 1.0;

/* The series of E in eta, of E' = gamma_0 E + A with A = c_0^2 sum_k (k s^(k-1) - gamma_0/2 (k-1)
 * s^(k-2)) eta^k: terms by a recursion. */
static double energy_by_series(const struct mpm_material *m, double eta)
{
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const double u = s * eta, gamma = m->parameter[MPM_PARAMETER_GRUNEISEN] * eta;
    double part = 0.0, sum = 0.0, power = 1.0, before = 0.0; /* u^(k-1), (k-1) u^(k-2) */
    for (int k = 1; k < MPM_GRUNEISEN_TERMS; k++) {
        const double now = k * power;
        part = (gamma * part + (now - 0.5 * gamma * before)) * mpm_gruneisen_inverse[k + 1];
        sum += part;
        if (now + fabs(gamma * part) <= MPM_GRUNEISEN_LEAST * sum)
            break;
        before = now;
        power *= u;
    }
    return speed * speed * eta * eta * sum;
}

static double energy_compressed(const struct mpm_material *m, double eta)
{
    const double gamma = m->parameter[MPM_PARAMETER_GRUNEISEN];
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    const double end = -mpm_logarithm(1.0 - s * eta) / s;
    const int panels = 1 + (int)(end * fmax(1.0, fmax(s, gamma)) / PANEL);
    const double half = 0.5 * end / panels;
    double sum = 0.0;
    for (int panel = 0; panel < panels; panel++)
        for (int k = 0; k < HALF; k++) {
            const double middle = (2 * panel + 1) * half, off = gauss[k][0] * half;
            sum +=
                gauss[k][1] * (integrand(m, eta, middle - off) + integrand(m, eta, middle + off));
        }
    return half * sum;
}

/* A = c_0^2 eta: c_0^2 (exp(z) - 1 - z)/gamma_0^2 with z = gamma_0 eta, by its series where z is
 * small. */
static double energy_stretched(const struct mpm_material *m, double eta)
{
    const double speed = m->parameter[MPM_PARAMETER_SOUND_SPEED];
    const double z = m->parameter[MPM_PARAMETER_GRUNEISEN] * eta;
    double part = 1.0; /* of eta^2/2 */
    for (int k = MPM_GRUNEISEN_STRETCHED_TERMS; k > 0; k--)
        part = 1.0 + z * mpm_gruneisen_inverse[k + 2] * part;
    if (z < -1.0)
        part = 2.0 * (mpm_exponential(z) - 1.0 - z) / (z * z);
    return 0.5 * speed * speed * eta * eta * part;
}

static double isentropic_energy(const struct mpm_material *m, double eta)
{
    const double s = m->parameter[MPM_PARAMETER_HUGONIOT_SLOPE];
    if (!(eta > 0.0))
        return energy_stretched(m, eta);
    return s * eta <= MPM_GRUNEISEN_SERIES ? energy_by_series(m, eta) : energy_compressed(m, eta);
}

double mpm_gruneisen_temperature(const struct mpm_material *m, double j, double energy)
{
    if (is_cut(m, whole_pressure(m, j, energy))) {
        const double volume = material_volume(m, j, energy);
        energy -= most_tension(m) * (j - volume);
        j = volume;
    }
    const double eta = 1.0 - j;
    const double isentropic = m->parameter[MPM_PARAMETER_START_TEMPERATURE] *
                              mpm_exponential(m->parameter[MPM_PARAMETER_GRUNEISEN] * eta);
    return isentropic +
           (energy - isentropic_energy(m, eta)) / m->parameter[MPM_PARAMETER_SPECIFIC_HEAT];
}

const char *mpm_gruneisen_fault(const double *parameter)
{
    return (parameter[MPM_PARAMETER_SPECIFIC_HEAT] > 0.0) ==
                   (parameter[MPM_PARAMETER_START_TEMPERATURE] > 0.0)
               ? NULL
               : "temperature requires specific_heat and start_temperature; allowed: both or none";
}

/* -------------------------------------------------------------------------- the law */

enum { ENERGY, VARIABLES };

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const double j = mpm_determinant(step->f);
    double pressure = 0.0;
    if (!(step->duration > 0.0))
        pressure = mpm_gruneisen_pressure(m, j, state[ENERGY], wave_speed_squared);
    else if (!mpm_gruneisen_advance(m, mpm_determinant(step->old_f), j, step->heat, &state[ENERGY],
                                    &pressure, wave_speed_squared))
        return false;
    tau[MPM_SYM_XX] = tau[MPM_SYM_YY] = tau[MPM_SYM_ZZ] = -j * pressure;
    tau[MPM_SYM_XY] = 0.0;
    return true;
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
    return mpm_gruneisen_temperature(m, mpm_determinant(f), state[ENERGY]);
}

static const struct mpm_law_parameter parameters[] = {
    MPM_GRUNEISEN_PARAMETERS,
    MPM_GRUNEISEN_TEMPERATURE_PARAMETERS,
};
static const struct mpm_law_variable variables[VARIABLES] = {
    {"internal_energy", MPM_DIMENSION_SPECIFIC_ENERGY, 0.0, "per mass, 0 at the start"},
};

const struct mpm_material_law mpm_mie_gruneisen = {
    .name = "mie_gruneisen",
    .description = "p = rho_0 c_0^2 eta (1 - gamma_0 eta/2)/(1 - s eta)^2 + rho_0 gamma_0 e, eta = "
                   "1 - J; no strength, and no plane stress",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = mpm_gruneisen_fault,
    .variables = variables,
    .variable_count = VARIABLES,
    .update = update,
    .energy = energy,
    .keeps_heat = true,
    .least_volume = mpm_gruneisen_least_volume,
    .temperature = temperature,
};
