/* Two lines of softening: from the strength at onset to knee_traction at knee_opening, and from
 * there to nothing at `length`, which follows from the toughness. With knee_traction = strength the
 * first one is a plateau.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/cohesive.h"

/* Of the first line. */
static double work_to_knee(const struct mpm_cohesive *cohesive)
{
    return 0.5 * (cohesive->strength + cohesive->knee_traction) *
           (cohesive->knee_opening - cohesive->onset);
}

static double length(const struct mpm_cohesive *cohesive)
{
    const double least = 0.5 * cohesive->strength * cohesive->onset + work_to_knee(cohesive);
    return cohesive->knee_opening + 2.0 * (cohesive->toughness - least) / cohesive->knee_traction;
}

static double traction(const struct mpm_cohesive *cohesive, double opening)
{
    const double knee = cohesive->knee_opening;
    if (opening >= cohesive->length)
        return 0.0;
    if (opening >= knee)
        return cohesive->knee_traction * (cohesive->length - opening) / (cohesive->length - knee);
    const double part = (opening - cohesive->onset) / (knee - cohesive->onset);
    return cohesive->strength + part * (cohesive->knee_traction - cohesive->strength);
}

static double work(const struct mpm_cohesive *cohesive, double opening)
{
    const double knee = cohesive->knee_opening;
    if (opening < knee)
        return 0.5 * (cohesive->strength + traction(cohesive, opening)) *
               (opening - cohesive->onset);
    const double end = opening < cohesive->length ? opening : cohesive->length;
    return work_to_knee(cohesive) +
           0.5 * (cohesive->knee_traction + traction(cohesive, end)) * (end - knee);
}

const struct mpm_cohesive_law mpm_cohesive_trilinear = {
    .name = "trilinear",
    .work_to_knee = work_to_knee,
    .length = length,
    .traction = traction,
    .work = work,
};
