/* Exponential softening: from the strength at onset on,
 *     T = strength exp(-(lambda - onset)/length),  length = toughness/strength - onset/2.
 * It never ends: of the toughness, exp(-(lambda - onset)/length) of what softening takes is left.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"
#include "model/laws/cohesive.h"

static double length(const struct mpm_cohesive *cohesive)
{
    return cohesive->toughness / cohesive->strength - 0.5 * cohesive->onset;
}

static double traction(const struct mpm_cohesive *cohesive, double opening)
{
    return cohesive->strength * mpm_exponential(-(opening - cohesive->onset) / cohesive->length);
}

static double work(const struct mpm_cohesive *cohesive, double opening)
{
    return cohesive->length * (cohesive->strength - traction(cohesive, opening));
}

const struct mpm_cohesive_law mpm_cohesive_exponential = {
    .name = "exponential",
    .length = length,
    .traction = traction,
    .work = work,
};
