/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/damped_flight.h"

#include <math.h>

const struct damped_flight_state damped_flight_start = {.velocity = 1.0};

double damped_flight_velocity(const struct damped_flight *flight, double time)
{
    const double rate = flight->grid + flight->particle;
    const bool damped = rate != 0.0 || flight->growth != 0.0;
    if (flight->feedback == 0.0)
        return exp(-rate * time - 0.5 * flight->growth * time * time);
    if (flight->target != 0.0 || damped)
        return (double)NAN;
    return 1.0 / cosh(sqrt(flight->feedback) * time);
}

void damped_flight_advance(const struct damped_flight *flight, double time, double step,
                           struct damped_flight_state *state)
{
    const double grid = flight->grid + flight->growth * time + state->rate;
    const double before = state->velocity;
    const double after = (1.0 - step * (grid + flight->particle)) * before;
    state->way +=
        flight->midpoint ? 0.5 * step * (before + after) : step * (1.0 - step * grid) * before;
    state->velocity = after;
    state->rate =
        fmax(0.0, state->rate + step * flight->feedback * (after * after - flight->target));
}
