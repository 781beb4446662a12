/* Pareto fronts and costs to reach, against sets made by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/measures/comparison/pareto.h"

#include <math.h>

enum { MOST = 8 };

#define FAILED (double)NAN

static const struct front_case {
    const char *what;
    size_t count;
    struct pareto_point points[MOST];
    size_t front_count, front[MOST];
} FRONTS[] = {
    {"nothing", 0, {{0, 0}}, 0, {0}},
    {"one", 1, {{1, 1}}, 1, {0}},
    {"a staircase out of order", 4, {{4, 1}, {1, 4}, {3, 2}, {2, 3}}, 4, {1, 3, 2, 0}},
    {"one that costs more and errs more", 3, {{1, 2}, {2, 3}, {3, 1}}, 2, {0, 2}},
    {"one beats all", 4, {{3, 3}, {1, 1}, {2, 2}, {1, 2}}, 1, {1}},
    {"same cost, smaller error", 2, {{1, 2}, {1, 1}}, 1, {1}},
    {"same error, smaller cost", 2, {{2, 1}, {1, 1}}, 1, {1}},
    {"equal ones: the first", 3, {{2, 1}, {2, 1}, {1, 3}}, 2, {2, 0}},
    {"failed runs", 5, {{FAILED, 1}, {1, FAILED}, {1, 5}, {0, 1}, {1, -1}}, 1, {2}},
    {"an exact one", 2, {{1, 1}, {2, 0}}, 2, {0, 1}},
};

START_TEST(the_front_holds_exactly_what_nothing_dominates_by_rising_cost)
{
    const struct front_case *c = &FRONTS[_i];
    size_t front[MOST];
    const size_t count = pareto_front(c->points, c->count, front);
    ck_assert_msg(count == c->front_count, "%s: %zu", c->what, count);
    for (size_t i = 0; i < count; i++)
        ck_assert_msg(front[i] == c->front[i], "%s: place %zu is %zu", c->what, i, front[i]);
}
END_TEST

/* Ladders whose error is 1 / cost, or as stated; the interpolation is exact on powers. */
static const struct cost_case {
    const char *what;
    size_t count;
    struct pareto_point ladder[MOST];
    double error;
    enum pareto_reach reach;
    double cost;
} COSTS[] = {
    {"between two runs", 3, {{1, 1}, {4, 0.25}, {16, 1. / 16}}, 0.125, PARETO_REACHED, 8},
    {"on a run", 3, {{1, 1}, {4, 0.25}, {16, 1. / 16}}, 0.25, PARETO_REACHED, 4},
    {"second order", 2, {{1, 1}, {10, 1e-2}}, 1e-1, PARETO_REACHED, 3.16227766016837933},
    {"by the coarsest", 2, {{3, 0.01}, {6, 0.001}}, 0.1, PARETO_AT_MOST, 3},
    {"beyond the finest", 2, {{1, 1}, {2, 0.5}}, 0.4999, PARETO_NOT_REACHED, 0},
    {"nothing ran", 0, {{0, 0}}, 0.1, PARETO_NOT_REACHED, 0},
    {"all failed", 2, {{FAILED, FAILED}, {FAILED, FAILED}}, 1, PARETO_NOT_REACHED, 0},
    {"a failure between", 3, {{1, 1}, {FAILED, FAILED}, {9, 0.1}}, 0.5, PARETO_AT_MOST, 9},
    {"up, then down", 4, {{1, 1}, {2, 2}, {4, 0.5}, {8, 1}}, 1, PARETO_AT_MOST, 1},
    {"the first time down",
     4,
     {{1, 4}, {2, 1}, {4, 4}, {8, 1}},
     2,
     PARETO_REACHED,
     1.41421356237309505},
    {"an exact run", 2, {{1, 1}, {5, 0}}, 1e-9, PARETO_REACHED, 5},
};

START_TEST(costs_are_interpolated_between_runs_and_never_beyond_them)
{
    const struct cost_case *c = &COSTS[_i];
    const struct pareto_cost found = pareto_cost_to_reach(c->ladder, c->count, c->error);
    ck_assert_msg(found.reach == c->reach, "%s: %d", c->what, (int)found.reach);
    if (c->reach == PARETO_NOT_REACHED)
        ck_assert(isnan(found.cost));
    else /* a logarithm, a power: a few roundings */
        ck_assert_msg(fabs(found.cost / c->cost - 1) < 4e-15, "%s: %.17g", c->what, found.cost);
}
END_TEST

Suite *suite_pareto(void)
{
    Suite *suite = suite_create("pareto");
    TCase *tests = tcase_create("pareto");
    tcase_add_loop_test(tests, the_front_holds_exactly_what_nothing_dominates_by_rising_cost, 0,
                        sizeof FRONTS / sizeof *FRONTS);
    tcase_add_loop_test(tests, costs_are_interpolated_between_runs_and_never_beyond_them, 0,
                        sizeof COSTS / sizeof *COSTS);
    suite_add_tcase(suite, tests);
    return suite;
}
