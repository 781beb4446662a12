/* Jets: a function of X, Y and t together with the derivatives that a manufactured solution
 * needs, carried through sums, products and functions by the rules of calculus (automatic
 * differentiation). Of LANES places at a time.
 *
 * A displacement is written on jets that begin as jet_place and jet_time; out come u, Grad u,
 * Grad Grad u, v and a. A slope is the same with the gradient alone: what a stress needs for its
 * divergence once F and Grad F are known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_JET_H
#define VERIFICATION_EXACT_JET_H

#include "verification/exact/manufactured/lanes.h"

struct jet {
    lanes f;
    lanes x, y, t;        /* first derivatives */
    lanes xx, xy, yy, tt; /* second ones; those of place and time together are not needed */
};

struct slope {
    lanes f, x, y;
};

/* --------------------------------------------------------------------- jets */

LANES_INLINE struct jet jet_constant(double value)
{
    return (struct jet){.f = lanes_splat(value)};
}

/* X for axis 0, Y for axis 1 */
LANES_INLINE struct jet jet_place(int axis, lanes value)
{
    const double one = 1.0;
    return (struct jet){.f = value,
                        .x = lanes_splat(axis == 0 ? one : 0.0),
                        .y = lanes_splat(axis == 1 ? one : 0.0)};
}

LANES_INLINE struct jet jet_time(double value)
{
    return (struct jet){.f = lanes_splat(value), .t = lanes_splat(1.0)};
}

LANES_INLINE struct jet jet_add(struct jet a, struct jet b)
{
    return (struct jet){a.f + b.f,   a.x + b.x,   a.y + b.y,   a.t + b.t,
                        a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, a.tt + b.tt};
}

LANES_INLINE struct jet jet_subtract(struct jet a, struct jet b)
{
    return (struct jet){a.f - b.f,   a.x - b.x,   a.y - b.y,   a.t - b.t,
                        a.xx - b.xx, a.xy - b.xy, a.yy - b.yy, a.tt - b.tt};
}

LANES_INLINE struct jet jet_scale(double s, struct jet a)
{
    return (struct jet){s * a.f, s * a.x, s * a.y, s * a.t, s * a.xx, s * a.xy, s * a.yy, s * a.tt};
}

/* a + s */
LANES_INLINE struct jet jet_shift(struct jet a, double s)
{
    a.f += s;
    return a;
}

LANES_INLINE struct jet jet_multiply(struct jet a, struct jet b)
{
    return (struct jet){
        .f = a.f * b.f,
        .x = a.x * b.f + a.f * b.x,
        .y = a.y * b.f + a.f * b.y,
        .t = a.t * b.f + a.f * b.t,
        .xx = a.xx * b.f + 2.0 * (a.x * b.x) + a.f * b.xx,
        .xy = a.xy * b.f + (a.x * b.y + a.y * b.x) + a.f * b.xy,
        .yy = a.yy * b.f + 2.0 * (a.y * b.y) + a.f * b.yy,
        .tt = a.tt * b.f + 2.0 * (a.t * b.t) + a.f * b.tt,
    };
}

/* g(a) from g, g' and g'' at a.f */
LANES_INLINE struct jet jet_compose(struct jet a, lanes g, lanes first, lanes second)
{
    return (struct jet){
        .f = g,
        .x = first * a.x,
        .y = first * a.y,
        .t = first * a.t,
        .xx = second * (a.x * a.x) + first * a.xx,
        .xy = second * (a.x * a.y) + first * a.xy,
        .yy = second * (a.y * a.y) + first * a.yy,
        .tt = second * (a.t * a.t) + first * a.tt,
    };
}

LANES_INLINE struct jet jet_square(struct jet a)
{
    return jet_compose(a, a.f * a.f, 2.0 * a.f, lanes_splat(2.0));
}

/* of a.f not 0 */
LANES_INLINE struct jet jet_inverse(struct jet a)
{
    const lanes g = 1.0 / a.f, first = -(g * g);
    return jet_compose(a, g, first, -2.0 * (first * g));
}

/* of a.f > 0 */
LANES_INLINE struct jet jet_root(struct jet a)
{
    const lanes g = lanes_root(a.f), first = 0.5 / g;
    return jet_compose(a, g, first, -0.5 * (first / a.f));
}

LANES_INLINE void jet_sin_cos(struct jet a, struct jet *sine, struct jet *cosine)
{
    lanes s, c;
    lanes_sin_cos(a.f, &s, &c);
    *sine = jet_compose(a, s, c, -s);
    *cosine = jet_compose(a, c, -s, -c);
}

LANES_INLINE struct jet jet_sin(struct jet a)
{
    struct jet sine, cosine;
    jet_sin_cos(a, &sine, &cosine);
    return sine;
}

LANES_INLINE struct jet jet_cos(struct jet a)
{
    struct jet sine, cosine;
    jet_sin_cos(a, &sine, &cosine);
    return cosine;
}

/* ------------------------------------------------------------------- slopes */

LANES_INLINE struct slope slope_add(struct slope a, struct slope b)
{
    return (struct slope){a.f + b.f, a.x + b.x, a.y + b.y};
}

LANES_INLINE struct slope slope_subtract(struct slope a, struct slope b)
{
    return (struct slope){a.f - b.f, a.x - b.x, a.y - b.y};
}

LANES_INLINE struct slope slope_scale(double s, struct slope a)
{
    return (struct slope){s * a.f, s * a.x, s * a.y};
}

LANES_INLINE struct slope slope_multiply(struct slope a, struct slope b)
{
    return (struct slope){a.f * b.f, a.x * b.f + a.f * b.x, a.y * b.f + a.f * b.y};
}

/* g(a) from g and g' at a.f */
LANES_INLINE struct slope slope_compose(struct slope a, lanes g, lanes first)
{
    return (struct slope){g, first * a.x, first * a.y};
}

LANES_INLINE struct slope slope_square(struct slope a)
{
    return slope_compose(a, a.f * a.f, 2.0 * a.f);
}

LANES_INLINE struct slope slope_inverse(struct slope a)
{
    const lanes g = 1.0 / a.f;
    return slope_compose(a, g, -(g * g));
}

LANES_INLINE struct slope slope_root(struct slope a)
{
    const lanes g = lanes_root(a.f);
    return slope_compose(a, g, 0.5 / g);
}

/* a^(-2/3), given 1 / a */
LANES_INLINE struct slope slope_power_minus_two_thirds(struct slope a, struct slope inverse)
{
    const lanes third = lanes_inverse_cube_root(a.f), g = third * third;
    return slope_compose(a, g, (-2.0 / 3) * (g * inverse.f));
}

#endif
