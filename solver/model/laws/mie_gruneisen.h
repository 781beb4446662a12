/* Mie and Grueneisen's equation of state along a linear Hugoniot: what laws of fluids and of solids
 * share. With eta = 1 - J, e the internal energy per mass, 0 at the start, and Grueneisen's gamma
 * times the density constant, gamma rho = gamma_0 rho_0,
 *
 *   p = rho_0 A(eta) + rho_0 gamma_0 e,
 *   A = c_0^2 eta (1 - gamma_0 eta/2) / (1 - s eta)^2   in compression, eta >= 0
 *   A = c_0^2 eta                                       in tension.
 *
 * In compression every state that a shock U_s = c_0 + s u reaches from rest has its exact pressure:
 * there p_H = rho_0 c_0^2 eta/(1 - s eta)^2 and e_H = p_H eta/(2 rho_0), so that A is p_H/rho_0
 * less gamma_0 e_H; the factor (1 - gamma_0 eta/2) is that. A and its slope are continuous at
 * eta = 0. At eta = 1/s there is a pole.
 *
 * Energy: de = -p dJ/rho_0 + dq, dq the work of viscosity and plastic strain. Over a step the
 * trapezoidal rule and the pressure at its end, linear in e, are solved together, so that both hold
 * to round-off:
 *
 *   e' = (e - (p/rho_0 + A(eta')) dJ/2 + dq) / (1 + gamma_0 dJ/2).
 *
 * A step that passes the cut-off (below) has two parts. One step from rest is then the jump of a
 * shock, e' = (p + p')(1 - J')/(2 rho_0).
 * Sound: c^2 = dp/drho at constant entropy, where de = p deta/rho_0, so that
 *
 *   c^2 = J^2 (A' + gamma_0 p/rho_0),   A' = c_0^2 (1 + (s - gamma_0) eta)/(1 - s eta)^3 or c_0^2.
 *
 * Temperature, with a constant heat capacity c_v at constant volume: on the isentrope through the
 * start T_s = T_0 exp(gamma_0 eta), and de_s = (A + gamma_0 e_s) deta, so that
 *
 *   T = T_s + (e - e_s)/c_v,   e_s = exp(gamma_0 eta) int_0^eta exp(-gamma_0 x) A(x) dx.
 *
 * Cut-off: a pressure below -p_c, p_c = pressure_cutoff, is -p_c. Such a state is material at -p_c
 * with voids between it. The material has the volume J_c, at which A + gamma_0 e is the cut-off;
 * the voids, J - J_c, have taken p_c (J - J_c)/rho_0 of e and give it back when they close:
 *
 *   J_c = (c_0^2 + p_c/rho_0 + gamma_0 (e - p_c J/rho_0)) / (c_0^2 - gamma_0 p_c/rho_0).
 *
 * The work of the cut pressure leaves J_c as it is, heat lets it grow. So pressure comes back where
 * it was lost, and
 *
 * - T is that of the material, of J_c and e - p_c (J - J_c)/rho_0: voids that open do not cool it.
 *   The isentrope to J would: it has tension that the material does not bear.
 * - c^2 = J_c^2 (c_0^2 - gamma_0 p_c/rho_0), that of the material. The slope dp/drho of a cut state
 *   is 0, but the next step may close its voids, which the time step and viscosity have to bear. It
 *   has no jump where the cut-off begins, and does not change with J.
 *
 * The isentrope through the start has tensions below rho_0 c_0^2/gamma_0 only: from there on a
 * cut-off has no meaning.
 *
 * Sources: references.md P of the project's notes; Wilkins, Computer Simulation of Dynamic
 * Phenomena, Springer 1999; the rest is derived here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_MIE_GRUNEISEN_H
#define MPM_MODEL_MIE_GRUNEISEN_H

#include "model/material.h"

/* p/rho_0 at J and e, and the square of the speed of sound there. J above
 * mpm_gruneisen_least_volume. */
double mpm_gruneisen_pressure(const struct mpm_material *material, double j, double energy,
                              double *sound_squared);

/* e' at the end of a step from old_j to j in which viscosity and plastic strain gave `heat` per
 * mass; p/rho_0 and c^2 there. False: beyond the pole, or no such energy (1 + gamma_0 dJ/2 or c^2
 * not above 0). */
bool mpm_gruneisen_advance(const struct mpm_material *material, double old_j, double j, double heat,
                           double *energy, double *pressure, double *sound_squared);

/* 1 - 1/s: J at the pole; 0 for s <= 1. */
double mpm_gruneisen_least_volume(const struct mpm_material *material);

/* T at J and e; by a series or quadrature, to 1e-11 of e and that of the isentrope. */
double mpm_gruneisen_temperature(const struct mpm_material *material, double j, double energy);

/* The energy of the isentrope by series, in eta = 1 - J: in compression up to s eta = SERIES, where
 * the last of so many terms is round-off, below LEAST of the sum; in tension up to gamma_0 eta =
 * -1.
 */
enum { MPM_GRUNEISEN_TERMS = 36, MPM_GRUNEISEN_STRETCHED_TERMS = 16 };
static const double MPM_GRUNEISEN_SERIES = 0.3, MPM_GRUNEISEN_LEAST = 1e-17;
/* 1/k */
#define MPM_GRUNEISEN_TEN(tens)                                                                    \
    1.0 / ((tens) + 0), 1.0 / ((tens) + 1), 1.0 / ((tens) + 2), 1.0 / ((tens) + 3),                \
        1.0 / ((tens) + 4), 1.0 / ((tens) + 5), 1.0 / ((tens) + 6), 1.0 / ((tens) + 7),            \
        1.0 / ((tens) + 8), 1.0 / ((tens) + 9)
static const double mpm_gruneisen_inverse[] = {
    0.0,
    1.0,
    1.0 / 2,
    1.0 / 3,
    1.0 / 4,
    1.0 / 5,
    1.0 / 6,
    1.0 / 7,
    1.0 / 8,
    1.0 / 9,
    MPM_GRUNEISEN_TEN(10),
    MPM_GRUNEISEN_TEN(20),
    MPM_GRUNEISEN_TEN(30),
};

/* Rows of struct mpm_law_parameter: of the equation, of the temperature. */
#define MPM_GRUNEISEN_PARAMETERS                                                                   \
    {.which = MPM_PARAMETER_SOUND_SPEED}, {.which = MPM_PARAMETER_HUGONIOT_SLOPE},                 \
        {.which = MPM_PARAMETER_GRUNEISEN},                                                        \
    {                                                                                              \
        .which = MPM_PARAMETER_PRESSURE_CUTOFF, .optional = true, .fallback = HUGE_VAL             \
    }
#define MPM_GRUNEISEN_TEMPERATURE_PARAMETERS                                                       \
    {.which = MPM_PARAMETER_SPECIFIC_HEAT, .optional = true},                                      \
    {                                                                                              \
        .which = MPM_PARAMETER_START_TEMPERATURE, .optional = true                                 \
    }

/* What is wrong with the parameters of temperature, or NULL. */
const char *mpm_gruneisen_fault(const double *parameter);

#endif
