/* A free body of one velocity v, which nothing but damping slows down: case E5.
 *
 * Rates alpha_g(t) = g + s t at the nodes and alpha_p at the particles add up, Notes (40):
 *
 *     dv/dt = -(alpha_g + alpha_p) v,   v = v_0 exp(-(g + alpha_p) t - s t^2/2).
 *
 * The thermostat d alpha/dt = c (K - K_t), K the kinetic energy, c its gain over its scale, has for
 * K_t = 0, from dK/dt = -2 alpha K, the invariant alpha^2 + c K. So alone, from alpha = 0,
 *
 *     alpha = w tanh w t,   v = v_0 / cosh w t,   w^2 = c K_0.
 *
 * The solver's step is, Notes (38), (40), (56), with a = alpha_g(t) + alpha + alpha_p:
 *
 *     v' = (1 - a dt) v,   x' = x + dt (1 - (a - alpha_p) dt) v,   or by the midpoint dt (v +
 * v')/2, alpha' = max(0, alpha + dt c (K' - K_t)),
 *
 * whose velocity is that above times 1 - dt/2 int a^2 dt, to first order.
 *
 * Own derivation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_DAMPED_FLIGHT_H
#define VERIFICATION_EXACT_DAMPED_FLIGHT_H

#include <stdbool.h>

/* Rates in 1/time, not negative. */
struct damped_flight {
    double grid, growth; /* g, s */
    double particle;     /* alpha_p */
    double feedback;     /* c K_0, 1/time^2; 0: no thermostat */
    double target;       /* K_t / K_0 */
    bool midpoint;
};

/* v/v_0 at a time; NaN with a thermostat that has a target or other rates beside it. */
double damped_flight_velocity(const struct damped_flight *flight, double time);

/* The solver's steps so far. */
struct damped_flight_state {
    double velocity; /* over v_0 */
    double way;      /* over v_0, unit of time */
    double rate;     /* alpha of the thermostat */
};

/* At the start: velocity 1, no way. */
extern const struct damped_flight_state damped_flight_start;

/* One step of `step` from `time` on. */
void damped_flight_advance(const struct damped_flight *flight, double time, double step,
                           struct damped_flight_state *state);

#endif
