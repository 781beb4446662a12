/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/conservation.h"

#include "verification/measures/fields.h"

#include <math.h>

static double momentum_scale(const struct conservation *conservation)
{
    return sqrt(2.0 * conservation->start.mass * conservation->start.total_energy);
}

void conservation_open(struct conservation *conservation, const struct mpm_ledger *ledger)
{
    *conservation = (struct conservation){
        .start = *ledger, .last = *ledger, .smallest_kinetic = HUGE_VAL, .samples = 0};
    conservation_add(conservation, ledger);
}

void conservation_add(struct conservation *conservation, const struct mpm_ledger *ledger)
{
    const struct mpm_ledger *const start = &conservation->start;
    const double x = ledger->momentum[0] - start->momentum[0];
    const double y = ledger->momentum[1] - start->momentum[1];
    conservation->last = *ledger;
    conservation->samples++;
    const double drift = conservation_energy_now(conservation);
    conservation->energy_high = field_larger(conservation->energy_high, drift);
    conservation->energy_low = -field_larger(-conservation->energy_low, -drift);
    conservation->momentum = field_larger(conservation->momentum, sqrt(x * x + y * y));
    conservation->angular_momentum = field_larger(
        conservation->angular_momentum, fabs(ledger->angular_momentum - start->angular_momentum));
    conservation->smallest_kinetic = -field_larger(-conservation->smallest_kinetic,
                                                   -ledger->kinetic_energy / start->total_energy);
}

double conservation_energy_now(const struct conservation *conservation)
{
    const double start = conservation->start.total_energy - conservation->start.external_work;
    return (conservation->last.total_energy - conservation->last.external_work) / start - 1.0;
}

double conservation_energy_drift(const struct conservation *conservation)
{
    return field_larger(conservation->energy_high, -conservation->energy_low);
}

double conservation_momentum_drift(const struct conservation *conservation)
{
    return conservation->momentum / momentum_scale(conservation);
}

double conservation_angular_momentum_drift(const struct conservation *conservation, double arm)
{
    return conservation->angular_momentum / (momentum_scale(conservation) * arm);
}
