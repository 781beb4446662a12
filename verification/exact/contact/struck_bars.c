/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/struck_bars.h"

#include <math.h>

static double celerity(const struct struck_bars *bars, int bar)
{
    return sqrt(bars->modulus[bar] / bars->density[bar]);
}

static double impedance(const struct struck_bars *bars, int bar)
{
    return sqrt(bars->modulus[bar] * bars->density[bar]);
}

bool struck_bars_are_solved(const struct struck_bars *bars)
{
    return impedance(bars, 0) <= impedance(bars, 1) &&
           bars->length[0] / celerity(bars, 0) <= bars->length[1] / celerity(bars, 1);
}

double struck_bars_velocity(const struct struck_bars *bars)
{
    const double z1 = impedance(bars, 0), z2 = impedance(bars, 1);
    return z1 * bars->speed / (z1 + z2);
}

double struck_bars_pressure(const struct struck_bars *bars)
{
    return impedance(bars, 1) * struck_bars_velocity(bars);
}

double struck_bars_duration(const struct struck_bars *bars)
{
    return 2.0 * bars->length[0] / celerity(bars, 0);
}

double struck_bars_restitution(const struct struck_bars *bars)
{
    const double struck = struck_bars_pressure(bars) * struck_bars_duration(bars) /
                          (bars->density[1] * bars->length[1]);
    const double striker = bars->speed - 2.0 * struck_bars_pressure(bars) / impedance(bars, 0);
    return (struck - striker) / bars->speed;
}

/* Adds what a wave does that set out `since` ago: while it lasts, a pressure and, along the bar's
 * direction, a velocity. */
static void add_wave(struct struck_state *state, double since, double lasts, double pressure,
                     double velocity)
{
    if (since < 0.0 || since >= lasts)
        return;
    state->stress -= pressure;
    state->velocity += velocity;
}

struct struck_state struck_bars_state(const struct struck_bars *bars, int bar, double distance,
                                      double time)
{
    const double since = time - bars->gap / bars->speed, p = struck_bars_pressure(bars);
    const double lasts = bar == 0 ? (double)INFINITY : struck_bars_duration(bars);
    const double velocity = (bar == 0 ? -p : p) / impedance(bars, bar);
    const double c = celerity(bars, bar), crossing = bars->length[bar] / c;
    struct struck_state state = {.velocity = bar == 0 ? bars->speed : 0.0};
    /* to the far end and back, again and again; in the first bar once */
    for (int turn = 0; since > 2.0 * turn * crossing && (bar == 1 || turn == 0); turn++) {
        const double left = since - 2.0 * turn * crossing;
        add_wave(&state, left - distance / c, lasts, p, velocity);
        add_wave(&state, left - (2.0 * crossing - distance / c), lasts, -p, velocity);
    }
    return state;
}
