/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/lame_cylinder.h"

struct lame_state lame_cylinder_state(const struct lame_cylinder *c, double r)
{
    const double aa = c->inner * c->inner, bb = c->outer * c->outer;
    const double mean = (c->inner_pressure * aa - c->outer_pressure * bb) / (bb - aa);
    const double swing = (c->inner_pressure - c->outer_pressure) * aa * bb / (bb - aa);
    const double compliance = (1.0 + c->poisson) / c->young;
    return (struct lame_state){
        .rr = mean - swing / (r * r),
        .tt = mean + swing / (r * r),
        .zz = 2.0 * c->poisson * mean,
        .u = compliance * ((1.0 - 2.0 * c->poisson) * mean * r + swing / r),
    };
}
