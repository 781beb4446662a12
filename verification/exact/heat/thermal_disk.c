/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/thermal_disk.h"

#include <math.h>

static double rise_at(const struct thermal_disk *d, double r)
{
    const double part = r / d->outer;
    return d->inner == 0.0 ? d->rise * (1.0 - part * part)
                           : -d->rise * log(part) / log(d->outer / d->inner);
}

/* Of r ln(b/r): r^2 ln(b/r)/2 + r^2/4. */
static double logarithm_integral(double r, double outer)
{
    return 0.5 * r * r * log(outer / r) + 0.25 * r * r;
}

/* I(r) */
static double rise_integral(const struct thermal_disk *d, double r)
{
    const double square = r * r;
    if (d->inner == 0.0)
        return d->rise * square * (0.5 - 0.25 * square / (d->outer * d->outer));
    return d->rise * (logarithm_integral(r, d->outer) - logarithm_integral(d->inner, d->outer)) /
           log(d->outer / d->inner);
}

struct thermal_disk_state thermal_disk_state(const struct thermal_disk *d, double r)
{
    const double nu = d->poisson;
    const double young = d->plane_stress ? d->young : d->young / (1.0 - nu * nu);
    const double poisson = d->plane_stress ? nu : nu / (1.0 - nu);
    const double alpha = d->plane_stress ? d->expansion : d->expansion * (1.0 + nu);
    const double aa = d->inner * d->inner, rise = rise_at(d, r);
    const double here = rise_integral(d, r) / (r * r);
    const double mean = rise_integral(d, d->outer) / (d->outer * d->outer - aa);
    const double hole = aa / (r * r);
    const double rr = alpha * young * ((1.0 - hole) * mean - here);
    const double tt = alpha * young * ((1.0 + hole) * mean + here - rise);
    return (struct thermal_disk_state){
        .rise = rise,
        .rr = rr,
        .tt = tt,
        .zz = d->plane_stress ? 0.0 : nu * (rr + tt) - d->expansion * d->young * rise,
        .u = alpha * r * ((1.0 + poisson) * here + (1.0 - poisson + (1.0 + poisson) * hole) * mean),
        .strain = (rr - poisson * tt) / young + alpha * rise,
    };
}
