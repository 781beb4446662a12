/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_sample.h"

static double radius_weight(const struct manufactured_problem *problem, const double place[2])
{
    return problem->geometry == MPM_AXISYMMETRIC ? place[0] : 1.0;
}

double manufactured_place(const struct manufactured_problem *problem, const double part[2],
                          double place[2])
{
    const struct manufactured_domain *const d = &problem->domain;
    if (d->region == MANUFACTURED_ANNULUS) {
        const double radius = d->inner + part[0] * (d->outer - d->inner);
        const double angle = 2.0 * MANUFACTURED_PI * part[1];
        place[0] = radius * cos(angle);
        place[1] = radius * sin(angle);
        return 2.0 * MANUFACTURED_PI * radius * (d->outer - d->inner);
    }
    for (int axis = 0; axis < 2; axis++)
        place[axis] = d->low[axis] + part[axis] * (d->high[axis] - d->low[axis]);
    return (d->high[0] - d->low[0]) * (d->high[1] - d->low[1]) * radius_weight(problem, place);
}

double manufactured_edge_place(const struct manufactured_problem *problem,
                               enum manufactured_edge edge, double part, double place[2],
                               double normal[2])
{
    const struct manufactured_domain *const d = &problem->domain;
    const bool upright = edge == MANUFACTURED_LEFT || edge == MANUFACTURED_RIGHT;
    const bool far = edge == MANUFACTURED_RIGHT || edge == MANUFACTURED_TOP;
    const double sign = far ? 1.0 : -1.0;
    const double parts[2] = {upright ? far : part, upright ? part : far};
    (void)manufactured_place(problem, parts, place);
    if (d->region == MANUFACTURED_ANNULUS) {
        const double radius = far ? d->outer : d->inner;
        for (int axis = 0; axis < 2; axis++)
            normal[axis] = sign * place[axis] / radius;
        return upright ? 2.0 * MANUFACTURED_PI * radius : 0.0;
    }
    normal[0] = upright ? sign : 0.0;
    normal[1] = upright ? 0.0 : sign;
    return (upright ? d->high[1] - d->low[1] : d->high[0] - d->low[0]) *
           radius_weight(problem, place);
}
