/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_solve.h"

#include <math.h>

/* A direction along which less than this part of the mobility is left counts as held. */
static const double HELD_ALONG = 1e-12;
/* Changes below this part of the largest impulse are round-off. */
static const double SETTLED = 1e-15;
enum { SWEEPS = 2000 };
/* Stick: a pressure below this part of the drag is the round-off of none. */
static const double FAINT = 1e-9;

/* What a pair has so far, along the normal and along the surface. */
struct parts {
    double pressed, dragged;
};

/* The impulse along a direction that brings the difference to `allowed` there. */
static double stopping(const double mobility[2], const double difference[2], const double along[2],
                       double allowed)
{
    const double m = mobility[0] * along[0] * along[0] + mobility[1] * along[1] * along[1];
    if (!(m > HELD_ALONG * fmax(mobility[0], mobility[1])))
        return 0.0;
    return (allowed - difference[0] * along[0] - difference[1] * along[1]) / m;
}

static double limited_press(const struct mpm_solve_pair *pair, double pressed)
{
    if (pair->law == MPM_PAIR_BONDED || pressed <= 0.0)
        return pressed;
    return pressed <= pair->pull ? pressed : 0.0;
}

static double limited_drag(const struct mpm_solve_pair *pair, double pressed, double dragged)
{
    const double pressure = pressed < 0.0 ? -pressed : 0.0;
    switch (pair->law) {
    case MPM_PAIR_BONDED:
        return dragged;
    case MPM_PAIR_STICK:
        return fabs(pressed) > FAINT * fabs(dragged) ? dragged : 0.0;
    case MPM_PAIR_FRICTION:
        if (fabs(dragged) <= pair->static_friction * pressure)
            return dragged;
        return copysign(pair->friction * pressure, dragged);
    case MPM_PAIR_FRICTIONLESS:
    case MPM_PAIR_INTERFACE:
    case MPM_PAIR_NONE:
        break;
    }
    return 0.0;
}

/* By what the pair's parts change, `share` of what would do for it alone. */
static struct parts change_of(const struct mpm_solve_pair *pair,
                              const struct mpm_contact_side *sides, const struct parts *parts,
                              double share)
{
    const struct mpm_contact_side *const one = &sides[pair->of[0]], *const other =
                                                                        &sides[pair->of[1]];
    const double *const n = pair->normal, along[2] = {-n[1], n[0]};
    double mobility[2], difference[2];
    for (int axis = 0; axis < 2; axis++) {
        mobility[axis] = one->mobility[axis] + other->mobility[axis];
        difference[axis] = mobility[axis] > 0.0 ? one->velocity[axis] - other->velocity[axis] : 0.0;
    }
    const double pressed = limited_press(
        pair, parts->pressed + share * stopping(mobility, difference, n, pair->approach));
    for (int axis = 0; axis < 2; axis++)
        difference[axis] += mobility[axis] * (pressed - parts->pressed) * n[axis];
    const double dragged = limited_drag(
        pair, pressed, parts->dragged + share * stopping(mobility, difference, along, 0.0));
    return (struct parts){pressed - parts->pressed, dragged - parts->dragged};
}

static void apply(const struct mpm_solve_pair *pair, const struct parts *change,
                  struct mpm_contact_side *sides)
{
    const double *const n = pair->normal;
    const double impulse[2] = {change->pressed * n[0] - change->dragged * n[1],
                               change->pressed * n[1] + change->dragged * n[0]};
    for (int axis = 0; axis < 2; axis++) {
        struct mpm_contact_side *const one = &sides[pair->of[0]], *const other =
                                                                      &sides[pair->of[1]];
        one->velocity[axis] += one->mobility[axis] * impulse[axis];
        other->velocity[axis] -= other->mobility[axis] * impulse[axis];
    }
}

enum { PAIRS = MPM_CONTACT_FIELDS * (MPM_CONTACT_FIELDS - 1) / 2 };

/* All pairs at once. Returns whether anything has changed. */
static bool sweep(struct mpm_contact_side *sides, const struct mpm_solve_pair *pairs, int count,
                  double share, struct parts parts[PAIRS])
{
    struct parts changes[PAIRS];
    double largest = 0.0, changed = 0.0;
    for (int k = 0; k < count; k++)
        changes[k] = change_of(&pairs[k], sides, &parts[k], share);
    for (int k = 0; k < count; k++) {
        apply(&pairs[k], &changes[k], sides);
        parts[k].pressed += changes[k].pressed;
        parts[k].dragged += changes[k].dragged;
        largest = fmax(largest, fmax(fabs(parts[k].pressed), fabs(parts[k].dragged)));
        changed = fmax(changed, fmax(fabs(changes[k].pressed), fabs(changes[k].dragged)));
    }
    return changed > SETTLED * largest;
}

void mpm_contact_solve(struct mpm_contact_side *sides, int side_count, struct mpm_solve_pair *pairs,
                       int pair_count)
{
    struct parts parts[PAIRS] = {{0.0, 0.0}};
    const double share = side_count > 2 ? 1.0 / (side_count - 1) : 1.0;
    const int sweeps = pair_count > 1 ? SWEEPS : 1;
    for (int k = 0; k < sweeps && sweep(sides, pairs, pair_count, share, parts); k++)
        continue;
    for (int k = 0; k < pair_count; k++) {
        const double *const n = pairs[k].normal;
        pairs[k].impulse[0] = parts[k].pressed * n[0] - parts[k].dragged * n[1];
        pairs[k].impulse[1] = parts[k].pressed * n[1] + parts[k].dragged * n[0];
    }
}
