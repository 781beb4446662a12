/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/hill_sphere.h"

#include "verification/exact/root.h"

#include <math.h>

/* Of an elastic sphere under the inner pressure p. */
static struct hill_sphere_state elastic(const struct hill_sphere *s, double p, double r)
{
    const double aaa = pow(s->inner, 3), bbb = pow(s->outer, 3), rrr = pow(r, 3);
    const double scale = p * aaa / (bbb - aaa);
    return (struct hill_sphere_state){
        .rr = -scale * (bbb / rrr - 1.0),
        .tt = scale * (0.5 * bbb / rrr + 1.0),
        .u = scale * r / s->young * (0.5 * (1.0 + s->poisson) * bbb / rrr + 1.0 - 2.0 * s->poisson),
    };
}

double hill_sphere_first_yield(const struct hill_sphere *s)
{
    return 2.0 / 3.0 * s->yield * (1.0 - pow(s->inner / s->outer, 3));
}

struct front {
    const struct hill_sphere *sphere;
    double pressure;
};

static double pressure_left(double c, void *context)
{
    const struct front *const front = context;
    const struct hill_sphere *const s = front->sphere;
    return 2.0 * s->yield * log(c / s->inner) +
           2.0 / 3.0 * s->yield * (1.0 - pow(c / s->outer, 3)) - front->pressure;
}

double hill_sphere_front(const struct hill_sphere *s, double pressure)
{
    struct front front = {s, pressure};
    if (pressure <= hill_sphere_first_yield(s))
        return s->inner;
    return root_between(pressure_left, &front, s->inner, s->outer, 1e-14);
}

static struct hill_sphere_state loaded(const struct hill_sphere *s, double p, double r)
{
    const double c = hill_sphere_front(s, p), ratio = pow(c / s->outer, 3);
    const double nu = s->poisson, y = s->yield;
    if (p <= hill_sphere_first_yield(s))
        return elastic(s, p, r);
    if (r >= c) { /* Lame's sphere from c on, under the pressure that is left there */
        const struct hill_sphere rest = {c, s->outer, s->young, nu, y};
        return elastic(&rest, hill_sphere_first_yield(&rest), r);
    }
    const double rr = -p + 2.0 * y * log(r / s->inner);
    return (struct hill_sphere_state){
        .rr = rr,
        .tt = rr + y,
        .u = y / s->young *
             ((1.0 - nu) * pow(c, 3) / (r * r) -
              2.0 / 3.0 * (1.0 - 2.0 * nu) * r * (1.0 + 3.0 * log(c / r) - ratio)),
    };
}

struct hill_sphere_state hill_sphere_state(const struct hill_sphere *s, double peak,
                                           double pressure, double r)
{
    const double fall = peak - pressure;
    if (!(fall >= 0.0 && fall <= 2.0 * hill_sphere_first_yield(s)))
        return (struct hill_sphere_state){(double)NAN, (double)NAN, (double)NAN};
    const struct hill_sphere_state at_peak = loaded(s, peak, r), less = elastic(s, fall, r);
    return (struct hill_sphere_state){at_peak.rr - less.rr, at_peak.tt - less.tt,
                                      at_peak.u - less.u};
}
