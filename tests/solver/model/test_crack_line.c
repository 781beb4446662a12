/* Does the line from a particle to a node cross a chain, and from which side? Against exact
 * integers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/crack.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <string.h>

enum { LONGEST = 201 };

struct chain {
    double x[LONGEST], y[LONGEST];
    struct mpm_crack_chain chain;
};

static void bound(struct chain *made, size_t count)
{
    made->chain = (struct mpm_crack_chain){.x = made->x, .y = made->y, .count = count};
}

static void place(struct chain *made, size_t count, const double (*points)[2])
{
    for (size_t k = 0; k < count; k++) {
        made->x[k] = points[k][0];
        made->y[k] = points[k][1];
    }
    bound(made, count);
}

static const double SLACK = 1e-12;

/* By both ways, which must agree: with a slack without end nothing by the line alone. */
static enum mpm_crack_side side_of(const struct chain *made, const double particle[2],
                                   const double node[2])
{
    size_t one_by_one = SIZE_MAX, by_line = SIZE_MAX;
    const size_t end = made->chain.count - 1;
    const struct mpm_crack_part all = mpm_crack_part_of(&made->chain, 0, end, HUGE_VAL),
                                line = mpm_crack_part_of(&made->chain, 0, end, SLACK);
    const enum mpm_crack_side side =
        mpm_crack_part_side(&made->chain, &all, particle, node, &one_by_one);
    ck_assert_int_eq(mpm_crack_part_side(&made->chain, &line, particle, node, &by_line), side);
    if (side != MPM_CRACK_SAME_SIDE)
        ck_assert_uint_eq(by_line, one_by_one);
    return side;
}

static enum mpm_crack_side other_side(enum mpm_crack_side side)
{
    static const enum mpm_crack_side other[] = {
        [MPM_CRACK_SAME_SIDE] = MPM_CRACK_SAME_SIDE,
        [MPM_CRACK_ABOVE] = MPM_CRACK_BELOW,
        [MPM_CRACK_BELOW] = MPM_CRACK_ABOVE,
    };
    return other[side];
}

static void reverse(const struct chain *made, struct chain *reversed)
{
    const size_t count = made->chain.count;
    for (size_t k = 0; k < count; k++) {
        reversed->x[k] = made->x[count - 1 - k];
        reversed->y[k] = made->y[count - 1 - k];
    }
    bound(reversed, count);
}

/* ---------------------------------------------------------------- known lines */

#define SAME  MPM_CRACK_SAME_SIDE
#define ABOVE MPM_CRACK_ABOVE
#define BELOW MPM_CRACK_BELOW

/* Chains of straight, bent (left, right), zigzag and hooked form. */
static const struct {
    size_t count;
    double points[6][2];
} CHAINS[] = {
    {3, {{0, 0}, {2, 0}, {4, 0}}},         {3, {{0, 0}, {2, 0}, {2, 2}}},
    {3, {{0, 0}, {2, 0}, {2, -2}}},        {6, {{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {5, 2}}},
    {4, {{0, 0}, {4, 0}, {4, 2}, {0, 2}}},
};

static const struct {
    const char *name;
    double particle[2], node[2];
    int chain;
    enum mpm_crack_side side;
} LINES[] = {
    {"through a segment, from above", {1, 1}, {1, -1}, 0, ABOVE},
    {"through a segment, from below", {1, -1}, {1, 1}, 0, BELOW},
    {"short of the crack", {1, 2}, {1, 1}, 0, SAME},
    {"beside an end", {-1, 1}, {-1, -1}, 0, SAME},
    {"node within a segment, from above", {1, 1}, {1, 0}, 0, ABOVE},
    {"node within a segment, from below", {0, -1}, {1, 0}, 0, BELOW},
    {"node on the point of two segments", {1, 1}, {2, 0}, 0, ABOVE},
    {"node on it, from below", {3, -1}, {2, 0}, 0, BELOW},
    {"node on the first end, from above", {-1, 1}, {0, 0}, 0, ABOVE},
    {"node on the first end, from below", {1, -1}, {0, 0}, 0, BELOW},
    {"node on the last end, from above", {5, 1}, {4, 0}, 0, ABOVE},
    {"node on the last end, from below", {4, -1}, {4, 0}, 0, BELOW},
    {"node on an end, from straight ahead", {5, 0}, {4, 0}, 0, SAME},
    {"through the point of two segments", {1, 1}, {3, -1}, 0, ABOVE},
    {"through it, from below", {3, -1}, {1, 1}, 0, BELOW},
    {"through the first end", {-1, 1}, {1, -1}, 0, ABOVE},
    {"through the last end, from below", {5, -1}, {3, 1}, 0, BELOW},
    {"along the crack", {-1, 0}, {5, 0}, 0, SAME},
    {"particle on the crack", {1, 0}, {1, -1}, 0, SAME},
    {"particle on the crack and node too", {1, 0}, {2, 0}, 0, SAME},
    {"touches a left bend from without", {1, -1}, {3, 1}, 1, SAME},
    {"goes through a left bend", {1, 1}, {3, -1}, 1, ABOVE},
    {"node on a left bend, from within", {1, 1}, {2, 0}, 1, ABOVE},
    {"node on a left bend, outside of the first leg", {1, -1}, {2, 0}, 1, BELOW},
    {"node on a left bend, outside of the second", {3, 1}, {2, 0}, 1, BELOW},
    {"node on a left bend, ahead of the first leg", {3, 0}, {2, 0}, 1, BELOW},
    {"node on a left bend, particle on the leg", {1, 0}, {2, 0}, 1, SAME},
    {"touches a right bend from without", {1, 1}, {3, -1}, 2, SAME},
    {"node on a right bend, above the first leg", {1, 1}, {2, 0}, 2, ABOVE},
    {"node on a right bend, above the second", {3, -1}, {2, 0}, 2, ABOVE},
    {"node on a right bend, from within", {1, -1}, {2, 0}, 2, BELOW},
    {"once through a zigzag", {0, 1}, {1, 1}, 3, ABOVE},
    {"twice", {0, 1}, {2, 1}, 3, SAME},
    {"three times", {0, 1}, {3, 1}, 3, ABOVE},
    {"five times, back", {5, 1}, {0, 1}, 3, BELOW},
    {"touches three points", {0.5, 0}, {4.5, 0}, 3, SAME},
    {"both jaws of a hook", {1, 3}, {1, -1}, 4, SAME},
    {"one jaw of it", {1, 1}, {1, -1}, 4, ABOVE},
    {"the other jaw", {1, 3}, {1, 1}, 4, BELOW},
};

START_TEST(a_line_crosses_as_drawn_and_a_chain_turned_round_swaps_the_sides)
{
    const int index = LINES[_i].chain;
    struct chain chain, turned;
    place(&chain, CHAINS[index].count, CHAINS[index].points);
    reverse(&chain, &turned);
    ck_assert_msg(side_of(&chain, LINES[_i].particle, LINES[_i].node) == LINES[_i].side, "%s",
                  LINES[_i].name);
    ck_assert_msg(side_of(&turned, LINES[_i].particle, LINES[_i].node) ==
                      other_side(LINES[_i].side),
                  "%s, turned round", LINES[_i].name);
}
END_TEST

/* By whole numbers, quarter turns and doubling: nothing is rounded. */
START_TEST(a_line_crosses_alike_wherever_all_of_it_is_moved)
{
    static const double shifts[][2] = {{0, 0}, {-7, 1024}, {1e6, -3}};
    for (int turns = 0; turns < 4; turns++)
        for (size_t s = 0; s < G_N_ELEMENTS(shifts); s++) {
            double at[8][2] = {{LINES[_i].particle[0], LINES[_i].particle[1]},
                               {LINES[_i].node[0], LINES[_i].node[1]}};
            const size_t count = CHAINS[LINES[_i].chain].count;
            struct chain chain;
            memcpy(at[2], CHAINS[LINES[_i].chain].points, count * sizeof at[2]);
            for (size_t k = 0; k < count + 2; k++) {
                for (int turn = 0; turn < turns; turn++) {
                    const double x = at[k][0];
                    at[k][0] = -at[k][1];
                    at[k][1] = x;
                }
                for (int axis = 0; axis < 2; axis++)
                    at[k][axis] = 2.0 * at[k][axis] + shifts[s][axis];
            }
            place(&chain, count, (const double(*)[2])at + 2);
            ck_assert_msg(side_of(&chain, at[0], at[1]) == LINES[_i].side,
                          "%s, %d quarter turns, shift %zu", LINES[_i].name, turns, s);
        }
}
END_TEST

START_TEST(the_normal_points_from_above_to_below_whatever_the_particle)
{
    static const double slanted[][2] = {{0, 0}, {4, 3}};
    static const double places[2][2] = {{1, 2}, {3, 1}};
    struct chain chain;
    double normal[2] = {0, 0};
    place(&chain, 2, slanted);
    ck_assert_int_eq(side_of(&chain, places[_i], places[1 - _i]),
                     _i == 0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW);
    mpm_crack_segment_normal(&chain.chain, 0, normal);
    ck_assert_near(normal[0], 0.6, DBL_EPSILON);
    ck_assert_near(normal[1], -0.8, DBL_EPSILON);
}
END_TEST

/* --------------------------------------------------------------- exact integers */

typedef int64_t place_t[2];

static int64_t cross(const place_t a, const place_t b, const place_t c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static int sign_of(int64_t value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/* How far along the line from a to b, times the square of its length, is c? */
static int64_t along(const place_t a, const place_t b, const place_t c)
{
    return (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
}

static bool is_on(const place_t a, const place_t b, const place_t c)
{
    return cross(a, b, c) == 0 && along(a, b, c) >= 0 && along(b, a, c) >= 0;
}

static bool is_on_chain(const place_t *chain, int count, const place_t c)
{
    for (int k = 0; k + 1 < count; k++)
        if (is_on(chain[k], chain[k + 1], c))
            return true;
    return false;
}

/* Angle from one direction to the other, counter clockwise, in (0, 2 pi]. */
static double turn(const place_t from, const place_t centre, const place_t to)
{
    const double a = atan2((double)(from[1] - centre[1]), (double)(from[0] - centre[0]));
    const double b = atan2((double)(to[1] - centre[1]), (double)(to[0] - centre[0]));
    return b > a + 1e-9 ? b - a : b - a + 2.0 * G_PI;
}

/* Where the chain meets the infinite line in one place: the points i..j of it on the line, or, for
 * i > j, between points j and i. Adds its crossing to `sum` and `count`; false: not defined. */
static bool count_meeting(const place_t *chain, int count, int i, int j, const place_t particle,
                          const place_t node, int *sum, int *crossings)
{
    const int before = i > j ? j : i - 1, after = i > j ? i : j + 1;
    const int64_t end = along(particle, node, node);
    const bool has_before = before >= 0, has_after = after < count;
    int from = has_before ? sign_of(cross(particle, node, chain[before])) : 0;
    int to = has_after ? sign_of(cross(particle, node, chain[after])) : 0;
    if (i > j) {
        const int beside = sign_of(cross(chain[before], chain[after], particle));
        if (beside * sign_of(cross(chain[before], chain[after], node)) > 0)
            return true;
    } else if (i == j) {
        const int64_t at = along(particle, node, chain[i]);
        if (at < 0 || at > end)
            return true;
        if (at == end && has_before && has_after) { /* the node is on the point */
            const bool above =
                turn(chain[after], node, particle) < turn(chain[after], node, chain[before]);
            *sum += above ? 1 : -1;
            *crossings += 1;
            return true;
        }
        from = has_before ? from : -to;
        to = has_after ? to : -from;
    } else {
        int inside = 0, behind = 0, past = 0;
        for (int k = i; k <= j; k++) {
            const int64_t at = along(particle, node, chain[k]);
            inside += at > 0 && at < end;
            behind += at < 0;
            past += at > end;
        }
        if (behind == j - i + 1 || past == j - i + 1)
            return true;
        if (inside != j - i + 1 || !has_before || !has_after)
            return false;
    }
    *crossings += from != to;
    *sum += from == to ? 0 : to;
    return true;
}

/* False where it is not defined: the particle on the crack, or segments along the line that have
 * the node or an end of the chain. */
static bool brute_force(const place_t *chain, int count, const place_t particle, const place_t node,
                        enum mpm_crack_side *side)
{
    int sum = 0, crossings = 0;
    if (is_on_chain(chain, count, particle))
        return false;
    for (int k = 0; k < count; k++) {
        int last = k;
        if (cross(particle, node, chain[k]) == 0) {
            while (last + 1 < count && cross(particle, node, chain[last + 1]) == 0)
                last++;
            if (!count_meeting(chain, count, k, last, particle, node, &sum, &crossings))
                return false;
            k = last;
        }
        if (last + 1 < count && cross(particle, node, chain[last]) != 0 &&
            sign_of(cross(particle, node, chain[last])) ==
                -sign_of(cross(particle, node, chain[last + 1])) &&
            !count_meeting(chain, count, last + 1, last, particle, node, &sum, &crossings))
            return false;
    }
    *side = crossings % 2 == 0 ? MPM_CRACK_SAME_SIDE : sum > 0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW;
    return true;
}

static void draw(GRand *random, place_t at, int size)
{
    for (int axis = 0; axis < 2; axis++)
        at[axis] = g_rand_int_range(random, 0, size);
}

static int draw_chain(GRand *random, place_t chain[6], int size)
{
    const int count = g_rand_int_range(random, 2, 7);
    for (int k = 0; k < count; k++)
        do
            draw(random, chain[k], size);
        while (k > 0 && memcmp(chain[k], chain[k - 1], sizeof chain[k]) == 0);
    for (int k = 0; k + 2 < count; k++) /* a fold has no two sides */
        if (is_on(chain[k], chain[k + 1], chain[k + 2]) ||
            is_on(chain[k + 1], chain[k + 2], chain[k]))
            return draw_chain(random, chain, size);
    return count;
}

static void place_integers(struct chain *made, int count, const place_t *points)
{
    for (int k = 0; k < count; k++) {
        made->x[k] = (double)points[k][0];
        made->y[k] = (double)points[k][1];
    }
    bound(made, (size_t)count);
}

/* On small lattices, where most lines go through points, and on a large one. */
START_TEST(lines_cross_as_exact_integers_say)
{
    enum { TIMES = 60000 };
    static const int sizes[] = {3, 5, 9, 1000};
    GRand *const random = g_rand_new_with_seed(20030614);
    int told[3] = {0, 0, 0};
    for (int time = 0; time < TIMES; time++) {
        place_t points[6], particle, node;
        enum mpm_crack_side expected;
        struct chain chain;
        const int count = draw_chain(random, points, sizes[_i]);
        draw(random, particle, sizes[_i]);
        draw(random, node, sizes[_i]);
        if (memcmp(particle, node, sizeof node) == 0 ||
            !brute_force((const place_t *)points, count, particle, node, &expected))
            continue;
        place_integers(&chain, count, (const place_t *)points);
        const double p[2] = {(double)particle[0], (double)particle[1]};
        const double n[2] = {(double)node[0], (double)node[1]};
        told[expected]++;
        if (side_of(&chain, p, n) == expected)
            continue;
        GString *const text = g_string_new(NULL);
        for (int k = 0; k < count; k++)
            g_string_append_printf(text, " (%g, %g)", chain.x[k], chain.y[k]);
        ck_abort_msg("from (%g, %g) to (%g, %g) over%s: side %d, expected %d", p[0], p[1], n[0],
                     n[1], text->str, side_of(&chain, p, n), expected);
    }
    for (int side = 0; side < 3; side++)
        ck_assert_int_gt(told[side], TIMES / 40);
    g_rand_free(random);
}
END_TEST

/* ------------------------------------------------------------------- round-off */

/* Of particles that come as near as numbers allow to a slanted chain none is found to be on the
 * other side of it, whatever the node, nor on both sides of one node. */
START_TEST(particles_near_the_crack_are_on_one_side_of_it_for_all_nodes)
{
    GRand *const random = g_rand_new_with_seed(77);
    for (int time = 0; time < 20000; time++) {
        struct chain chain;
        const double slope = g_rand_double_range(random, -2, 2);
        const double ends[2][2] = {{0.0, 0.0}, {8.0, 8.0 * slope}};
        place(&chain, 2, ends);
        const double x = g_rand_double_range(random, 3, 5);
        const double away =
            (time % 2 == 0 ? 1.0 : -1.0) * ldexp(1.0, g_rand_int_range(random, -49, -20));
        const double particle[2] = {x, x * slope + away};
        int found[3] = {0, 0, 0};
        for (int n = 0; n < 4; n++) {
            const double node[2] = {x + g_rand_double_range(random, -1, 1),
                                    x * slope + (n % 2 == 0 ? 4.0 : -4.0)};
            found[side_of(&chain, particle, node)]++;
        }
        ck_assert_int_eq(found[SAME], 2);
        ck_assert_int_eq(found[away > 0.0 ? ABOVE : BELOW], 2);
    }
    g_rand_free(random);
}
END_TEST

/* A straight crack through nodes, cut into parts whose points are rounded: a node near it has no
 * particle above that is found to be below, or on the node's side while another is not. */
START_TEST(a_straight_crack_of_rounded_points_has_two_sides)
{
    enum { PARTS = 40 };
    GRand *const random = g_rand_new_with_seed(5);
    const double cell = 0.1, slope = (double)_i / 3.0;
    struct chain chain;
    for (int k = 0; k <= PARTS; k++) {
        chain.x[k] = 0.3 + (double)k / PARTS * 2.0;
        chain.y[k] = 0.7 + (double)k / PARTS * 2.0 * slope;
    }
    bound(&chain, PARTS + 1);
    for (int time = 0; time < 20000; time++) {
        const int column = g_rand_int_range(random, 5, 21);
        const double line = 0.7 + (column * cell - 0.3) * slope;
        const double node[2] = {column * cell, rint(line / cell) * cell};
        const double x = node[0] + cell * g_rand_double_range(random, -1, 1);
        const double away = cell * g_rand_double_range(random, 0.01, 1);
        const double crack = 0.7 + (x - 0.3) * slope;
        const double above[2] = {x, crack + away}, below[2] = {x, crack - away};
        const enum mpm_crack_side up = side_of(&chain, above, node),
                                  down = side_of(&chain, below, node);
        if (fabs(node[1] - line) > 1e-12) {
            ck_assert_int_eq(up, node[1] > line ? SAME : ABOVE);
            ck_assert_int_eq(down, node[1] > line ? BELOW : SAME);
        } else
            ck_assert_msg(
                (up == ABOVE || up == SAME) && (down == BELOW || down == SAME) && up + down != SAME,
                "node (%.17g, %.17g): particle above %d, below %d", node[0], node[1], up, down);
    }
    g_rand_free(random);
}
END_TEST

/* ------------------------------------------------------------------------ parts */

/* Waves of all steepnesses: from parts that are all but straight to some that fold back. */
START_TEST(a_part_of_a_chain_tells_what_all_of_it_does_by_its_line_too)
{
    GRand *const random = g_rand_new_with_seed(200);
    const double roughness = 0.001 * pow(10.0, _i);
    int crossed = 0;
    for (int time = 0; time < 40; time++) {
        struct chain chain;
        for (int k = 0; k < LONGEST; k++) {
            chain.x[k] = 0.5 * k + roughness * g_rand_double_range(random, -1, 1);
            chain.y[k] = 20.0 * sin(0.05 * k) + roughness * g_rand_double_range(random, -1, 1);
        }
        bound(&chain, LONGEST);
        for (int line = 0; line < 500; line++) {
            const int at = g_rand_int_range(random, 4, LONGEST - 4);
            const double x = chain.x[at] + g_rand_double_range(random, -1, 1),
                         y = chain.y[at] + g_rand_double_range(random, -1, 1);
            const double particle[2] = {x, y}, node[2] = {rint(x), rint(y)};
            enum mpm_crack_side side[2]; /* with its line, and without */
            for (int k = 0; k < 2; k++) {
                const struct mpm_crack_part part = mpm_crack_part_of(
                    &chain.chain, (size_t)at - 4, (size_t)at + 4, k == 0 ? SLACK : HUGE_VAL);
                side[k] = mpm_crack_part_side(&chain.chain, &part, particle, node, NULL);
            }
            ck_assert_int_eq(side[0], side[1]);
            crossed += side[0] != MPM_CRACK_SAME_SIDE;
        }
    }
    ck_assert_int_gt(crossed, 500);
    g_rand_free(random);
}
END_TEST

START_TEST(all_points_of_a_part_lie_in_its_box_and_near_its_line)
{
    static const double points[][2] = {{0, 0}, {1, 0.5}, {2, -0.25}, {4, 0}, {5, 9}};
    struct chain chain;
    place(&chain, 5, points);
    const struct mpm_crack_part part = mpm_crack_part_of(&chain.chain, 0, 3, 0.125);
    ck_assert(part.box.low[0] == 0 && part.box.high[0] == 4 && part.box.low[1] == -0.25 &&
              part.box.high[1] == 0.5);
    ck_assert_near(part.thickness, 0.5 + 0.125, DBL_EPSILON);
    ck_assert_near(mpm_crack_part_distance(&part, points[1]), 0.5, DBL_EPSILON);
    ck_assert_near(mpm_crack_part_distance(&part, points[2]), -0.25, DBL_EPSILON);
}
END_TEST

Suite *suite_crack_line(void)
{
    Suite *suite = suite_create("crack line");
    TCase *sides = tcase_create("sides");
    const int lines = G_N_ELEMENTS(LINES);
    tcase_add_loop_test(sides, a_line_crosses_as_drawn_and_a_chain_turned_round_swaps_the_sides, 0,
                        lines);
    tcase_add_loop_test(sides, a_line_crosses_alike_wherever_all_of_it_is_moved, 0, lines);
    tcase_add_loop_test(sides, the_normal_points_from_above_to_below_whatever_the_particle, 0, 2);
    tcase_add_loop_test(sides, lines_cross_as_exact_integers_say, 0, 4);
    tcase_add_test(sides, particles_near_the_crack_are_on_one_side_of_it_for_all_nodes);
    tcase_add_loop_test(sides, a_straight_crack_of_rounded_points_has_two_sides, 0, 4);
    tcase_add_loop_test(sides, a_part_of_a_chain_tells_what_all_of_it_does_by_its_line_too, 0, 4);
    tcase_add_test(sides, all_points_of_a_part_lie_in_its_box_and_near_its_line);
    suite_add_tcase(suite, sides);
    return suite;
}
