/* Linear softening: from the strength at onset, T falls along a line to nothing at `length`,
 *     T = strength (length - lambda)/(length - onset),  length = 2 toughness/strength.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/cohesive.h"

static double length(const struct mpm_cohesive *cohesive)
{
    return 2.0 * cohesive->toughness / cohesive->strength;
}

static double traction(const struct mpm_cohesive *cohesive, double opening)
{
    if (opening >= cohesive->length)
        return 0.0;
    return cohesive->strength * (cohesive->length - opening) / (cohesive->length - cohesive->onset);
}

static double work(const struct mpm_cohesive *cohesive, double opening)
{
    const double end = opening < cohesive->length ? opening : cohesive->length;
    return 0.5 * (cohesive->strength + traction(cohesive, end)) * (end - cohesive->onset);
}

const struct mpm_cohesive_law mpm_cohesive_linear = {
    .name = "linear",
    .length = length,
    .traction = traction,
    .work = work,
};
