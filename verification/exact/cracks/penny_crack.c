/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/penny_crack.h"

#include <math.h>

double penny_crack_infinite(const struct penny_crack *crack)
{
    return 2.0 * crack->stress * sqrt(crack->radius / acos(-1.0));
}

double penny_crack_cylinder(const struct penny_crack *crack)
{
    const double x = crack->radius / crack->outer;
    const double shape = 1.0 + x * (0.5 + x * (-0.625 + x * 0.421));
    return penny_crack_infinite(crack) * shape * sqrt(1.0 - x) / (1.0 - x * x);
}
