/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/alekseevskii_tate.h"

#include <math.h>

/* (rho_t - rho_p) u^2 + 2 rho_p v u - rho_p v^2 + 2 (R - Y) = 0, in the form without a difference
 * of like numbers. */
double penetration_velocity(const struct penetration *p, double speed)
{
    const double half = p->rod_density * speed;
    const double constant = 2.0 * (p->resistance - p->strength) - half * speed;
    const double root = half * half - (p->target_density - p->rod_density) * constant;
    if (!(constant < 0.0) || !(root > 0.0))
        return 0.0;
    return -constant / (half + sqrt(root));
}

enum { NOSE, TAIL, SPEED, VARIABLES };

static void slopes(const struct penetration *p, const double y[VARIABLES], double out[VARIABLES])
{
    out[NOSE] = penetration_velocity(p, y[SPEED]);
    out[TAIL] = y[SPEED];
    out[SPEED] = -p->strength / (p->rod_density * (y[NOSE] - y[TAIL]));
}

static void advance(const struct penetration *p, double h, double y[VARIABLES])
{
    static const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
    double k[VARIABLES] = {0.0}, sum[VARIABLES] = {0.0};
    for (int stage = 0; stage < 4; stage++) {
        double at[VARIABLES];
        for (int i = 0; i < VARIABLES; i++)
            at[i] = y[i] + part[stage] * h * k[i];
        slopes(p, at, k);
        for (int i = 0; i < VARIABLES; i++)
            sum[i] += weight[stage] / 6.0 * k[i];
    }
    for (int i = 0; i < VARIABLES; i++)
        y[i] += h * sum[i];
}

struct penetration_state penetration_at(const struct penetration *p, double time)
{
    enum { STEPS = 20000 };
    double y[VARIABLES] = {0.0, -p->length, p->speed};
    bool ended = false;
    for (int k = 0; k < STEPS && !ended; k++) {
        ended = !(penetration_velocity(p, y[SPEED]) > 0.0) ||
                !(y[NOSE] - y[TAIL] > y[SPEED] * time / STEPS);
        if (!ended)
            advance(p, time / STEPS, y);
    }
    return (struct penetration_state){
        .nose = y[NOSE],
        .tail = y[TAIL],
        .velocity = ended ? 0.0 : penetration_velocity(p, y[SPEED]),
        .ended = ended,
    };
}
