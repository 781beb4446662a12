/* Two elastic bars in one line, of which the first hits the second: exact solution of case C2.
 *
 * Waves of stress and velocity along a bar of density rho and modulus M (of the state of stress
 * across it) run at c = sqrt(M/rho); with Z = rho c, sigma + Z v is constant along dx = -c dt, and
 * sigma - Z v along dx = c dt. The first bar moves at V, the second is at rest. From the time V t =
 * gap on, one velocity and one pressure p at the contact satisfy p = Z1 (V - v) and p = Z2 v:
 *
 *     v* = Z1 V/(Z1 + Z2),   p = Z1 Z2 V/(Z1 + Z2).
 *
 * Behind the wave that comes back from the first bar's free end, sigma = 0 and v = V - 2 p/Z1 =
 * V (Z1 - Z2)/(Z1 + Z2). With Z1 <= Z2 this is <= 0: contact ends when it arrives, after T =
 * 2 L1/c1, if the second bar's own echo is not earlier, 2 L2/c2 >= T. The first bar has no more
 * waves in it then, the second one a pulse of length c2 T, whose sign of stress changes at each
 * end, while its velocity p/Z2 does not: its near face never comes back. The coefficient of
 * restitution is that of the mean velocities,
 *
 *     e = (p T/(rho2 L2) - V (Z1 - Z2)/(Z1 + Z2))/V,     L1/L2 for bars of one material.
 *
 * For the law `linear_elastic` at V << c; own derivation, as in K. F. Graff, Wave Motion in Elastic
 * Solids, sec. 2.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_STRUCK_BARS_H
#define VERIFICATION_EXACT_STRUCK_BARS_H

#include <stdbool.h>

enum { STRUCK_BARS = 2 };

struct struck_bars {
    double length[STRUCK_BARS], modulus[STRUCK_BARS], density[STRUCK_BARS]; /* > 0 */
    double speed;                                                           /* V > 0 */
    double gap;                                                             /* >= 0 */
};

/* Is Z1 <= Z2 and L1/c1 <= L2/c2? Only then is what follows the solution. */
bool struck_bars_are_solved(const struct struck_bars *bars);

double struck_bars_velocity(const struct struck_bars *bars);    /* v* */
double struck_bars_pressure(const struct struck_bars *bars);    /* p */
double struck_bars_duration(const struct struck_bars *bars);    /* T */
double struck_bars_restitution(const struct struck_bars *bars); /* e */

struct struck_state {
    double velocity, stress; /* along the bars; tension is positive */
};

/* In bar 0 or 1, at `distance` from its face that is hit (0 to its length), at time t >= 0 since
 * the start. */
struct struck_state struck_bars_state(const struct struck_bars *bars, int bar, double distance,
                                      double time);

#endif
