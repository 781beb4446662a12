/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/riemann.h"

#include "verification/exact/root.h"

#include <math.h>

static double sound(const struct riemann *r, const struct riemann_state *s)
{
    return sqrt(r->index * s->pressure / s->density);
}

/* f_k(p) */
static double wave(const struct riemann *r, const struct riemann_state *s, double p)
{
    const double g = r->index;
    if (p > s->pressure)
        return (p - s->pressure) *
               sqrt(2.0 / ((g + 1.0) * s->density) / (p + (g - 1.0) / (g + 1.0) * s->pressure));
    return 2.0 * sound(r, s) / (g - 1.0) * (pow(p / s->pressure, 0.5 * (g - 1.0) / g) - 1.0);
}

static double gap(double p, void *context)
{
    const struct riemann *const r = context;
    return wave(r, &r->side[0], p) + wave(r, &r->side[1], p) + r->side[1].velocity -
           r->side[0].velocity;
}

void riemann_solve(struct riemann *r)
{
    double high = fmax(r->side[0].pressure, r->side[1].pressure);
    while (gap(high, r) < 0.0)
        high *= 2.0;
    r->pressure = root_between(gap, r, 0.0, high, 1e-15);
    r->velocity = 0.5 * (r->side[0].velocity + r->side[1].velocity +
                         wave(r, &r->side[1], r->pressure) - wave(r, &r->side[0], r->pressure));
}

/* Of the wave into the right side; the left one is its mirror image. */
static double front_of(const struct riemann *r, const struct riemann_state *s)
{
    const double g = r->index, ratio = r->pressure / s->pressure;
    const double c = sound(r, s);
    return s->velocity +
           (ratio > 1.0 ? c * sqrt(0.5 * (g + 1.0) / g * ratio + 0.5 * (g - 1.0) / g) : c);
}

static struct riemann_state behind(const struct riemann *r, const struct riemann_state *s)
{
    const double g = r->index, ratio = r->pressure / s->pressure, part = (g - 1.0) / (g + 1.0);
    return (struct riemann_state){
        s->density * (ratio > 1.0 ? (ratio + part) / (part * ratio + 1.0) : pow(ratio, 1.0 / g)),
        r->velocity, r->pressure};
}

/* To the right of the contact, `s` and the velocity between the waves as seen there. */
static struct riemann_state sample_right(const struct riemann *r, const struct riemann_state *s,
                                         double speed)
{
    const struct riemann_state after = behind(r, s);
    const double g = r->index, front = front_of(r, s);
    if (speed >= front)
        return *s;
    if (r->pressure > s->pressure || speed <= after.velocity + sound(r, &after))
        return after;
    const double c = 2.0 / (g + 1.0) * (sound(r, s) - 0.5 * (g - 1.0) * (s->velocity - speed));
    const double ratio = c / sound(r, s);
    return (struct riemann_state){s->density * pow(ratio, 2.0 / (g - 1.0)), speed - c,
                                  s->pressure * pow(ratio, 2.0 * g / (g - 1.0))};
}

static struct riemann_state mirrored(struct riemann_state s)
{
    s.velocity = -s.velocity;
    return s;
}

static struct riemann mirror(const struct riemann *r)
{
    return (struct riemann){
        r->index, {mirrored(r->side[1]), mirrored(r->side[0])}, r->pressure, -r->velocity};
}

struct riemann_state riemann_sample(const struct riemann *r, double speed)
{
    if (speed >= r->velocity)
        return sample_right(r, &r->side[1], speed);
    const struct riemann other = mirror(r);
    return mirrored(sample_right(&other, &other.side[1], -speed));
}

double riemann_front(const struct riemann *r, int side)
{
    const struct riemann other = mirror(r);
    return side == 1 ? front_of(r, &r->side[1]) : -front_of(&other, &other.side[1]);
}
