/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/cohesive.h"

#include <stddef.h>

const struct mpm_cohesive_law *mpm_cohesive_law(enum mpm_cohesive_kind kind)
{
#define LIST_COHESIVE(kind, name) [kind] = &mpm_cohesive_##name,
    static const struct mpm_cohesive_law *const laws[] = {MPM_COHESIVE_LAWS(LIST_COHESIVE)};
#undef LIST_COHESIVE
    return laws[kind];
}

static double work_to_onset(const struct mpm_cohesive *cohesive)
{
    return 0.5 * cohesive->strength * cohesive->onset;
}

bool mpm_cohesive_settle(struct mpm_cohesive *cohesive, double *least)
{
    cohesive->onset = cohesive->strength / cohesive->stiffness;
    *least = work_to_onset(cohesive);
    if (cohesive->law->work_to_knee != NULL)
        *least += cohesive->law->work_to_knee(cohesive);
    cohesive->length = cohesive->law->length(cohesive);
    return cohesive->toughness > *least;
}

double mpm_cohesive_envelope(const struct mpm_cohesive *cohesive, double opening)
{
    return opening <= cohesive->onset ? cohesive->stiffness * opening
                                      : cohesive->law->traction(cohesive, opening);
}

double mpm_cohesive_work(const struct mpm_cohesive *cohesive, double opening)
{
    if (opening <= cohesive->onset)
        return 0.5 * cohesive->stiffness * opening * opening;
    return work_to_onset(cohesive) + cohesive->law->work(cohesive, opening);
}

double mpm_cohesive_secant(const struct mpm_cohesive *cohesive, double largest)
{
    return largest <= cohesive->onset ? cohesive->stiffness
                                      : cohesive->law->traction(cohesive, largest) / largest;
}
