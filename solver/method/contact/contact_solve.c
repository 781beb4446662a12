/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_solve.h"

#include <math.h>
#include <string.h>

/* A direction along which less than this part of the mobility is left counts as held. */
static const double HELD_ALONG = 1e-12;
/* Changes below this part of the largest impulse are round-off. */
static const double SETTLED = 1e-15;
/* Sweeps can go round in circles where a small pressure holds a large drag. After LIMIT_AFTER they
 * begin again, with a drag of stick of at most STEEP times the pressure; after LEAVE_AFTER once
 * more with at most the pressure, of friction too, and from PART_AFTER on a pair whose pressure has
 * ended has no drag any more. Each begins from nothing: what a circle has come to depends on
 * round-off. */
enum { SWEEPS = 2000, LIMIT_AFTER = 200, LEAVE_AFTER = 400, PART_AFTER = 440 };
static const double STEEP = 10.0;
/* Stick: a pressure below this part of the drag is the round-off of none. */
static const double FAINT = 1e-9;

/* What a pair has so far, along the normal and along the surface. */
struct parts {
    double pressed, dragged;
};

/* The velocities of a pair's first field less those of the second, and both mobilities. */
struct approach {
    double mobility[2], difference[2];
};

static double mobility_along(const struct approach *approach, const double along[2])
{
    return approach->mobility[0] * along[0] * along[0] +
           approach->mobility[1] * along[1] * along[1];
}

static double difference_along(const struct approach *approach, const double along[2])
{
    return approach->difference[0] * along[0] + approach->difference[1] * along[1];
}

/* The impulse along a direction that brings the difference to `allowed` there. */
static double stopping(const struct approach *approach, const double along[2], double allowed)
{
    const double m = mobility_along(approach, along);
    const double x = approach->mobility[0], y = approach->mobility[1];
    if (!(m > HELD_ALONG * (x > y ? x : y)))
        return 0.0;
    return (allowed - difference_along(approach, along)) / m;
}

/* What the impulse `so_far` of an interface lacks along a direction. */
static double lacking(const struct approach *approach, const double along[2],
                      const struct mpm_solve_line *line, double so_far)
{
    return (line->free - line->damped * difference_along(approach, along) - so_far) /
           (1.0 + line->damped * mobility_along(approach, along));
}

static double limited_press(const struct mpm_solve_pair *pair, double pressed)
{
    if (pair->law == MPM_PAIR_BONDED || pair->law == MPM_PAIR_INTERFACE || pressed <= 0.0)
        return pressed;
    return pressed <= pair->pull ? pressed : 0.0;
}

static double limited_drag(const struct mpm_solve_pair *pair, double pressed, double dragged)
{
    const double pressure = pressed < 0.0 ? -pressed : 0.0;
    switch (pair->law) {
    case MPM_PAIR_BONDED:
    case MPM_PAIR_INTERFACE:
        return dragged;
    case MPM_PAIR_STICK:
        return fabs(pressed) > FAINT * fabs(dragged) ? dragged : 0.0;
    case MPM_PAIR_FRICTION:
        return mpm_contact_drag(dragged, pressure, pair->static_friction, pair->friction);
    case MPM_PAIR_FRICTIONLESS:
    case MPM_PAIR_NONE:
        break;
    }
    return 0.0;
}

static struct approach approach_of(const struct mpm_solve_pair *pair,
                                   const struct mpm_contact_side *sides)
{
    const struct mpm_contact_side *const one = &sides[pair->of[0]], *const other =
                                                                        &sides[pair->of[1]];
    struct approach approach;
    for (int axis = 0; axis < 2; axis++) {
        approach.mobility[axis] = one->mobility[axis] + other->mobility[axis];
        approach.difference[axis] =
            approach.mobility[axis] > 0.0 ? one->velocity[axis] - other->velocity[axis] : 0.0;
    }
    return approach;
}

/* By what the pair's parts change: `share` of the way to what would do for it alone. */
static struct parts change_of(const struct mpm_solve_pair *pair,
                              const struct mpm_contact_side *sides, const struct parts *parts,
                              double share)
{
    const double *const n = pair->normal, along[2] = {-n[1], n[0]};
    const bool is_interface = pair->law == MPM_PAIR_INTERFACE;
    struct approach approach = approach_of(pair, sides);
    const double press = is_interface ? lacking(&approach, n, &pair->lines[0], parts->pressed)
                                      : stopping(&approach, n, pair->approach);
    const double pressed = limited_press(pair, parts->pressed + press) - parts->pressed;
    for (int axis = 0; axis < 2; axis++)
        approach.difference[axis] += approach.mobility[axis] * share * pressed * n[axis];
    const double drag = is_interface ? lacking(&approach, along, &pair->lines[1], parts->dragged)
                                     : stopping(&approach, along, 0.0);
    const double dragged =
        limited_drag(pair, parts->pressed + share * pressed, parts->dragged + drag);
    return (struct parts){share * pressed, share * (dragged - parts->dragged)};
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

enum { PAIRS = MPM_CONTACT_SIDES * (MPM_CONTACT_SIDES - 1) / 2 };

/* Several pairs of a node as they are solved. */
struct solution {
    struct mpm_contact_side *sides;
    const struct mpm_solve_pair *pairs;
    int count;
    double shares[PAIRS];
    bool parted[PAIRS]; /* pairs whose drag does not come again */
};

static bool needs_pressure(const struct mpm_solve_pair *pair)
{
    return pair->law == MPM_PAIR_STICK || pair->law == MPM_PAIR_FRICTION;
}

static void limit_drag(double slope, const struct parts *parts, double share, struct parts *change)
{
    const double pressure = fabs(parts->pressed + change->pressed);
    const double dragged =
        mpm_contact_drag(parts->dragged + change->dragged / share, pressure, slope, slope);
    change->dragged = share * (dragged - parts->dragged);
}

/* All pairs at once. Returns whether anything has changed. */
static bool sweep(struct solution *of, int number, struct parts parts[PAIRS])
{
    struct parts changes[PAIRS];
    double largest = 0.0, changed = 0.0;
    for (int k = 0; k < of->count; k++) {
        changes[k] = change_of(&of->pairs[k], of->sides, &parts[k], of->shares[k]);
        if (number >= LEAVE_AFTER && needs_pressure(&of->pairs[k]))
            limit_drag(1.0, &parts[k], of->shares[k], &changes[k]);
        else if (number >= LIMIT_AFTER && of->pairs[k].law == MPM_PAIR_STICK)
            limit_drag(STEEP, &parts[k], of->shares[k], &changes[k]);
        const double left = parts[k].pressed + changes[k].pressed / of->shares[k];
        if (number >= PART_AFTER && needs_pressure(&of->pairs[k]) &&
            left >= -FAINT * fabs(parts[k].pressed))
            of->parted[k] = true;
        if (of->parted[k])
            changes[k].dragged = -of->shares[k] * parts[k].dragged;
    }
    for (int k = 0; k < of->count; k++) {
        apply(&of->pairs[k], &changes[k], of->sides);
        parts[k].pressed += changes[k].pressed;
        parts[k].dragged += changes[k].dragged;
        largest = fmax(largest, fmax(fabs(parts[k].pressed), fabs(parts[k].dragged)));
        changed = fmax(changed, fmax(fabs(changes[k].pressed), fabs(changes[k].dragged)));
    }
    return changed > SETTLED * largest;
}

/* How much of its own need each pair may take at once: with the pairs of both its fields the need
 * of a pair is up to 1/share of what its own parts do, so that sweeps converge. */
static void find_shares(struct solution *solution)
{
    const struct mpm_contact_side *const sides = solution->sides;
    const struct mpm_solve_pair *const pairs = solution->pairs;
    int of[MPM_CONTACT_SIDES] = {0};
    for (int k = 0; k < solution->count; k++)
        for (int i = 0; i < 2; i++)
            of[pairs[k].of[i]]++;
    for (int k = 0; k < solution->count; k++) {
        const int *const on = pairs[k].of;
        double need = 1.0;
        for (int axis = 0; axis < 2; axis++) {
            const double one = sides[on[0]].mobility[axis], other = sides[on[1]].mobility[axis];
            if (one + other > 0.0)
                need = fmax(need, (of[on[0]] * one + of[on[1]] * other) / (one + other));
        }
        solution->shares[k] = 1.0 / need;
    }
}

/* One exchange does all that a pair needs that has its fields for itself. */
static void solve_one(struct mpm_contact_side *sides, const struct mpm_solve_pair *pair,
                      struct parts *parts)
{
    static const struct parts none = {0.0, 0.0};
    *parts = change_of(pair, sides, &none, 1.0);
    apply(pair, parts, sides);
}

static void begin_again(const struct solution *of, struct parts parts[PAIRS])
{
    for (int k = 0; k < of->count; k++) {
        const struct parts back = {-parts[k].pressed, -parts[k].dragged};
        apply(&of->pairs[k], &back, of->sides);
        parts[k] = (struct parts){0.0, 0.0};
    }
}

static void solve_several(struct mpm_contact_side *sides, const struct mpm_solve_pair *pairs,
                          int count, struct parts parts[PAIRS])
{
    struct solution solution; /* not cleared as a whole: it is large */
    bool sticks = false, rubs = false;
    solution.sides = sides;
    solution.pairs = pairs;
    solution.count = count;
    memset(solution.parted, 0, sizeof solution.parted);
    find_shares(&solution);
    for (int k = 0; k < count; k++) {
        sticks = sticks || pairs[k].law == MPM_PAIR_STICK;
        rubs = rubs || needs_pressure(&pairs[k]);
    }
    memset(parts, 0, (size_t)count * sizeof *parts);
    for (int k = 0; k < SWEEPS && sweep(&solution, k, parts); k++)
        if ((k + 1 == LIMIT_AFTER && sticks) || (k + 1 == LEAVE_AFTER && rubs))
            begin_again(&solution, parts);
}

void mpm_contact_solve(struct mpm_contact_side *sides, struct mpm_solve_pair *pairs, int count)
{
    struct parts parts[PAIRS];
    if (count == 1)
        solve_one(sides, pairs, parts);
    else
        solve_several(sides, pairs, count, parts);
    for (int k = 0; k < count; k++) {
        const double *const n = pairs[k].normal;
        pairs[k].impulse[0] = parts[k].pressed * n[0] - parts[k].dragged * n[1];
        pairs[k].impulse[1] = parts[k].pressed * n[1] + parts[k].dragged * n[0];
    }
}
