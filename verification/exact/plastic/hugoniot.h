/* The state behind a plane shock that runs into a body at rest whose shocks obey U_s = c_0 + s u,
 * u the velocity behind it. Balance of mass, momentum and energy (Rankine and Hugoniot) give, for
 * any equation of state through that Hugoniot, with rho_0 and no pressure ahead,
 *
 *   J = 1 - u/U_s,   P = rho_0 U_s u,   e = u^2/2.
 *
 * Temperature needs more of the equation of state: with gamma rho = gamma_0 rho_0 and a constant
 * c_v, T dS = de + P dv and T dS = c_v dT + c_v T gamma_0 dJ give along the Hugoniot, eta = 1 - J,
 *
 *   dT/deta - gamma_0 T = (de/deta - P/rho_0)/c_v
 *
 * (J. M. Walsh, R. H. Christian, Phys. Rev. 97 (1955) 1544-1556), here with u as the variable and
 * Simpson's rule for the integrating factor exp(-gamma_0 eta).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HUGONIOT_H
#define VERIFICATION_EXACT_HUGONIOT_H

struct hugoniot {
    double density, sound_speed, slope, gruneisen;
    double specific_heat, start_temperature;
};

struct hugoniot_state {
    double shock_speed; /* relative to the body ahead */
    double pressure, relative_volume, energy, temperature;
};

/* Behind a shock that moves the body by `velocity` >= 0. */
struct hugoniot_state hugoniot_behind(const struct hugoniot *hugoniot, double velocity);

/* Two bodies meet, evenly, at the speed `speed`: the velocity of their contact as the second one,
 * at rest before, sees it. Both have there the pressure of their Hugoniots. NaN if there is none.
 */
double hugoniot_contact(const struct hugoniot *first, const struct hugoniot *second, double speed);

#endif
