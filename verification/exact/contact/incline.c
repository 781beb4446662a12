/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/incline.h"

#include <math.h>

static double sliding(const struct incline *incline)
{
    return incline->gravity * (sin(incline->angle) - incline->friction * cos(incline->angle));
}

struct incline_motion incline_block(const struct incline *incline)
{
    const bool slips = tan(incline->angle) > incline->static_friction;
    return (struct incline_motion){.acceleration = slips ? sliding(incline) : 0.0, .slips = slips};
}

struct incline_motion incline_round(const struct incline *incline, double inertia, double radius)
{
    if (tan(incline->angle) * inertia > incline->static_friction * (1.0 + inertia))
        return (struct incline_motion){
            .acceleration = sliding(incline),
            .spin = incline->friction * incline->gravity * cos(incline->angle) / (inertia * radius),
            .slips = true,
        };
    const double acceleration = incline->gravity * sin(incline->angle) / (1.0 + inertia);
    return (struct incline_motion){.acceleration = acceleration, .spin = acceleration / radius};
}
