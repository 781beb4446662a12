/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_solve.h"

#include <math.h>
#include <string.h>

/* A direction along which less than this part of the mobility is left counts as held. */
static const double HELD_ALONG = 1e-12;
/* Changes below this part of the largest impulse are round-off. Those below ALMOST, of the largest
 * velocity too, are if they have not become less in STALLED sweeps. */
static const double SETTLED = 1e-15, ALMOST = 1e-10;
enum { SWEEPS = 2000, ENOUGH = 200, ROUNDS = 10, SWEEPS_OF_ROUND = 150, STALLED = 30 };
/* Drag over pressure, at most: of stick that has not settled without a limit; within bounds. */
static const double STEEP = 10.0, EVEN = 1.0;
/* A pull that has come this near to its limit has reached it. */
static const double REACHED = 0.999;
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
    double shares[PAIRS], mobility[PAIRS];
    double fastest, moved; /* velocity of a field; its change in the last sweep, at most */
    double least;          /* of these changes */
    int since;             /* sweeps */
    bool almost;           /* settled */
    bool limited;          /* stick is, to STEEP */
    bool bounded;          /* bounds for the drag are known, and for the pull */
    double bounds[PAIRS], pulls[PAIRS];
    double momentum;            /* of sweeps with bounds, */
    struct parts before[PAIRS]; /* and what they are ahead of */
};

static double within(double low, double value, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* The same within bounds, to which it goes by its share of the way too. */
static struct parts bounded_change_of(const struct solution *of, int k, const struct parts *parts)
{
    const struct mpm_solve_pair *const pair = &of->pairs[k];
    const double *const n = pair->normal, along[2] = {-n[1], n[0]};
    const double share = of->shares[k], bound = of->bounds[k];
    struct approach approach = approach_of(pair, of->sides);
    const double press = share * stopping(&approach, n, pair->approach);
    const double pressed = fmin(parts->pressed + press, of->pulls[k]) - parts->pressed;
    for (int axis = 0; axis < 2; axis++)
        approach.difference[axis] += approach.mobility[axis] * pressed * n[axis];
    const double drag = share * stopping(&approach, along, 0.0);
    return (struct parts){pressed, within(-bound, parts->dragged + drag, bound) - parts->dragged};
}

static void limit_drag(const struct parts *parts, double share, struct parts *change)
{
    const double pressure = fabs(parts->pressed + change->pressed);
    const double dragged =
        mpm_contact_drag(parts->dragged + change->dragged / share, pressure, STEEP, STEEP);
    change->dragged = share * (dragged - parts->dragged);
}

static bool is_linear(const struct mpm_solve_pair *pair)
{
    return pair->law == MPM_PAIR_BONDED || pair->law == MPM_PAIR_INTERFACE;
}

/* Goes on in the direction of the last two sweeps, further from sweep to sweep (Nesterov), until
 * that is not downhill any more. `changes` are those to where the sweep leads. */
static void go_ahead(struct solution *of, const struct parts *parts, struct parts *changes)
{
    struct parts made[PAIRS], gone[PAIRS];
    double downhill = 0.0;
    for (int k = 0; k < of->count; k++) {
        made[k].pressed = parts[k].pressed + changes[k].pressed;
        made[k].dragged = parts[k].dragged + changes[k].dragged;
        gone[k].pressed = made[k].pressed - of->before[k].pressed;
        gone[k].dragged = made[k].dragged - of->before[k].dragged;
        downhill += of->mobility[k] / of->shares[k] *
                    (changes[k].pressed * gone[k].pressed + changes[k].dragged * gone[k].dragged);
    }
    if (downhill < 0.0)
        of->momentum = 1.0;
    const double next = 0.5 * (1.0 + sqrt(1.0 + 4.0 * of->momentum * of->momentum));
    const double ahead = (of->momentum - 1.0) / next;
    of->momentum = next;
    for (int k = 0; k < of->count; k++) {
        /* cppcheck-suppress uninitvar ; the loop above has set as many */
        changes[k].pressed += ahead * gone[k].pressed;
        changes[k].dragged += ahead * gone[k].dragged;
        /* cppcheck-suppress uninitvar ; the loop above has set as many */
        of->before[k] = made[k];
    }
}

/* All pairs at once. Returns whether more than round-off has changed. */
static bool sweep(struct solution *of, struct parts parts[PAIRS])
{
    struct parts changes[PAIRS];
    double largest = 0.0, changed = 0.0;
    for (int k = 0; k < of->count; k++) {
        changes[k] = of->bounded && !is_linear(&of->pairs[k])
                         ? bounded_change_of(of, k, &parts[k])
                         : change_of(&of->pairs[k], of->sides, &parts[k], of->shares[k]);
        if (of->limited && of->pairs[k].law == MPM_PAIR_STICK)
            limit_drag(&parts[k], of->shares[k], &changes[k]);
    }
    if (of->bounded)
        go_ahead(of, parts, changes);
    of->moved = 0.0;
    for (int k = 0; k < of->count; k++) {
        const double change = fmax(fabs(changes[k].pressed), fabs(changes[k].dragged));
        apply(&of->pairs[k], &changes[k], of->sides);
        parts[k].pressed += changes[k].pressed;
        parts[k].dragged += changes[k].dragged;
        largest = fmax(largest, fmax(fabs(parts[k].pressed), fabs(parts[k].dragged)));
        changed = fmax(changed, change);
        of->moved = fmax(of->moved, of->mobility[k] * change);
    }
    of->fastest = fmax(of->fastest, of->moved);
    of->since++;
    if (of->moved < 0.9 * of->least) {
        of->least = of->moved;
        of->since = 0;
    }
    of->almost = changed < ALMOST * largest && of->moved < ALMOST * of->fastest;
    return changed > SETTLED * largest && !(of->almost && of->since >= STALLED);
}

static void go_back(const struct solution *of, struct parts parts[PAIRS],
                    const struct parts from[PAIRS])
{
    for (int k = 0; k < of->count; k++) {
        const struct parts back = {from[k].pressed - parts[k].pressed,
                                   from[k].dragged - parts[k].dragged};
        apply(&of->pairs[k], &back, of->sides);
        parts[k] = from[k];
    }
}

/* Up to so many. Returns whether they have settled. */
static bool settle(struct solution *of, struct parts parts[PAIRS], int most)
{
    bool settled = false;
    of->least = HUGE_VAL;
    of->since = 0;
    of->momentum = 1.0;
    memcpy(of->before, parts, (size_t)of->count * sizeof *parts);
    for (int k = 0; k < most && !settled; k++)
        settled = !sweep(of, parts);
    if (of->bounded)
        go_back(of, parts, of->before);
    return settled;
}

/* By how much a pair's two parts together do more than each for itself, where fields are held along
 * one axis: both move them along the other one. 0 where they are as mobile along both. */
static double overlap(const struct mpm_solve_pair *pair, const struct mpm_contact_side *sides)
{
    const double *const n = pair->normal, along[2] = {-n[1], n[0]};
    const struct approach approach = approach_of(pair, sides);
    const double x = approach.mobility[0], y = approach.mobility[1], most = fmax(x, y);
    const double press = mobility_along(&approach, n), drag = mobility_along(&approach, along);
    if (!(press > HELD_ALONG * most && drag > HELD_ALONG * most))
        return 0.0;
    return fabs(n[0] * n[1] * (y - x)) / sqrt(press * drag);
}

/* How much of its own need each pair may take at once: with the pairs of both its fields, and both
 * its parts, the need of a pair is up to 1/share of what a part does, so that sweeps converge. */
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
        solution->shares[k] = 1.0 / (need * (1.0 + overlap(&pairs[k], sides)));
        solution->mobility[k] = fmax(sides[on[0]].mobility[0] + sides[on[1]].mobility[0],
                                     sides[on[0]].mobility[1] + sides[on[1]].mobility[1]);
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

/* What pressures allow of drag, and which pulls have reached their limit. */
static void find_bounds(struct solution *of, const struct parts parts[PAIRS])
{
    for (int k = 0; k < of->count; k++) {
        const struct mpm_solve_pair *const pair = &of->pairs[k];
        const double slope = pair->law == MPM_PAIR_STICK      ? EVEN
                             : pair->law == MPM_PAIR_FRICTION ? fmin(pair->friction, EVEN)
                                                              : 0.0;
        of->bounds[k] = slope * fmax(-parts[k].pressed, 0.0);
        if (pair->pull < HUGE_VAL && parts[k].pressed > REACHED * pair->pull)
            of->pulls[k] = 0.0;
    }
}

/* Rounds of sweeps, each with bounds for the drag from the pressures of the one before. */
static void settle_in_bounds(struct solution *of, struct parts parts[PAIRS])
{
    of->limited = false;
    of->bounded = true;
    for (int k = 0; k < of->count; k++) {
        of->bounds[k] = 0.0;
        of->pulls[k] = of->pairs[k].pull;
    }
    for (int round = 0; round < ROUNDS; round++) {
        settle(of, parts, SWEEPS_OF_ROUND);
        find_bounds(of, parts);
    }
}

/* All of what is known before the first sweep; returns whether a pair sticks. */
static bool begin(struct solution *of)
{
    bool sticks = false;
    of->limited = of->bounded = false;
    of->fastest = 0.0;
    find_shares(of);
    for (int k = 0; k < of->count; k++) {
        sticks = sticks || of->pairs[k].law == MPM_PAIR_STICK;
        for (int i = 0; i < 2; i++)
            for (int axis = 0; axis < 2; axis++)
                of->fastest = fmax(of->fastest, fabs(of->sides[of->pairs[k].of[i]].velocity[axis]));
    }
    return sticks;
}

/* Up to ENOUGH sweeps, or more of them if they are about to settle. */
static bool settle_well(struct solution *of, struct parts parts[PAIRS])
{
    if (settle(of, parts, ENOUGH))
        return true;
    if (!of->almost)
        return false;
    settle(of, parts, SWEEPS - ENOUGH);
    return true;
}

static void solve_several(struct mpm_contact_side *sides, const struct mpm_solve_pair *pairs,
                          int count, struct parts parts[PAIRS])
{
    static const struct parts none[PAIRS];
    struct solution solution; /* not cleared as a whole: it is large */
    solution.sides = sides;
    solution.pairs = pairs;
    solution.count = count;
    const bool sticks = begin(&solution);
    memset(parts, 0, (size_t)count * sizeof *parts);
    if (settle_well(&solution, parts))
        return;
    go_back(&solution, parts, none);
    solution.limited = sticks;
    if (sticks && settle_well(&solution, parts))
        return;
    go_back(&solution, parts, none);
    settle_in_bounds(&solution, parts);
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
