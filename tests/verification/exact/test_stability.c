/* Tests of what finds and predicts the largest stable Courant number: bisection, and the
 * eigenvalues of the linear step against limits done by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/exact/stretched_column.h"
#include "verification/exact/waves/linear_step.h"
#include "verification/measures/bisection.h"

#include <math.h>

/* ---------------------------------------------------------------- bisection */

static const double LADDER[] = {0.25, 0.5, 1.0, 2.0};
enum { RUNGS = sizeof LADDER / sizeof *LADDER };

struct border {
    double limit;      /* passes up to here, */
    double stray_from; /* and from here on */
    int fails_after;   /* the test itself fails after so many calls; 0: never */
    int calls;
};

static enum mpm_status passes_below(void *context, double value, bool *passes,
                                    struct mpm_error *error)
{
    struct border *const border = context;
    *passes = value <= border->limit || value >= border->stray_from;
    if (++border->calls != border->fails_after)
        return MPM_OK;
    *error = (struct mpm_error){.status = MPM_ENVIRONMENT_FAILED, .message = "no more"};
    return MPM_ENVIRONMENT_FAILED;
}

static struct bisection_border find(struct border border, double tolerance)
{
    struct bisection_border found;
    struct mpm_error error;
    ck_assert_int_eq(
        bisection_find(LADDER, RUNGS, tolerance, passes_below, &border, &found, &error), MPM_OK);
    return found;
}

START_TEST(bisection_encloses_the_border_to_its_tolerance)
{
    const double tolerance = 0.01;
    for (double limit = 0.26; limit < 2.0; limit *= 1.1) {
        const struct bisection_border found =
            find((struct border){.limit = limit, .stray_from = HUGE_VAL}, tolerance);
        ck_assert(found.passes <= limit && limit < found.fails);
        ck_assert(found.fails <= found.passes * (1.0 + tolerance));
        ck_assert_uint_eq(found.stray, 0);
    }
}
END_TEST

START_TEST(bisection_says_when_all_or_none_passes)
{
    const struct bisection_border none = find((struct border){0.1, HUGE_VAL, 0, 0}, 0.01);
    ck_assert_double_eq(none.passes, 0.0);
    ck_assert_double_eq(none.fails, LADDER[0]);
    ck_assert_uint_eq(none.passed, 0);
    const struct bisection_border all = find((struct border){5.0, HUGE_VAL, 0, 0}, 0.01);
    ck_assert_double_eq(all.passes, LADDER[RUNGS - 1]);
    ck_assert(isinf(all.fails));
    ck_assert_uint_eq(all.passed, RUNGS);
}
END_TEST

START_TEST(bisection_counts_what_passes_above_a_failure_and_stays_below_it)
{
    const struct bisection_border found = find((struct border){0.3, 1.5, 0, 0}, 0.01);
    ck_assert(found.passes <= 0.3 && 0.3 < found.fails && found.fails < 0.5);
    ck_assert_uint_eq(found.passed, 2);
    ck_assert_uint_eq(found.stray, 1);
}
END_TEST

START_TEST(bisection_passes_a_failed_test_on)
{
    /* in the ladder, and after it */
    for (int calls = 2; calls <= RUNGS + 1; calls += RUNGS - 1) {
        struct border border = {0.3, HUGE_VAL, calls, 0};
        struct bisection_border found;
        struct mpm_error error;
        ck_assert_int_eq(bisection_find(LADDER, RUNGS, 0.01, passes_below, &border, &found, &error),
                         MPM_ENVIRONMENT_FAILED);
        ck_assert_int_eq(border.calls, calls);
    }
}
END_TEST

/* ------------------------------------------------------------ linear theory */

/* An infinite row, to the precision of the limit: the critical wave is missed by (pi/CELLS)^2. */
enum { CELLS = 400 };
static const double PRECISION = 3e-4;

/* One particle in the middle of a cell: S = cos(theta/2), G = 2i sin(theta/2) but for a phase, so
 * that the step is [[1, -C S G], [C G S, 1]] in some order, trace 2 - (C sin theta)^2 and
 * determinant 1: C = 2. USL: trace 2 - w, determinant 1 - (1 - S^2) w with w = (C G)^2, stable up
 * to w (2 - S^2) = 4, C = 1/sqrt(2) at theta = pi. On a node: S = 1 and, by the code's rule there,
 * a one-sided gradient, G = 2 sin(theta/2): the limit of finite elements, C = 1. */
static const struct {
    struct linear_row row;
    double limit;
} LIMITS[] = {
    {{LINEAR_CLASSIC, LINEAR_MUSL, 1, 0.0}, 2.0},
    {{LINEAR_CLASSIC, LINEAR_USF, 1, 0.0}, 2.0},
    {{LINEAR_CLASSIC, LINEAR_USAVG, 1, 0.0}, 2.0},
    {{LINEAR_CLASSIC, LINEAR_USL, 1, 0.0}, 0.70710678},
    {{LINEAR_UGIMP, LINEAR_MUSL, 1, 0.0}, 2.0},
    {{LINEAR_UGIMP, LINEAR_USL, 1, 0.0}, 0.70710678},
    {{LINEAR_CLASSIC, LINEAR_MUSL, 1, 0.4999999}, 1.0},
    {{LINEAR_CLASSIC, LINEAR_MUSL, 2, 0.0}, 1.73205081},
    {{LINEAR_UGIMP, LINEAR_USAVG, 2, 0.0}, 1.73205081},
    {{LINEAR_CLASSIC, LINEAR_MUSL, 2, 0.2499999}, 1.41421356},
};
enum { LIMIT_COUNT = sizeof LIMITS / sizeof *LIMITS };

START_TEST(the_linear_step_has_the_limits_done_by_hand)
{
    const double found = linear_step_limit(&LIMITS[_i].row, CELLS);
    ck_assert_double_eq_tol(found / LIMITS[_i].limit, 1.0, PRECISION);
}
END_TEST

START_TEST(below_its_limit_the_linear_step_does_not_grow_and_above_it_does)
{
    static const enum linear_shape shapes[] = {LINEAR_CLASSIC, LINEAR_UGIMP, LINEAR_BSPLINE2,
                                               LINEAR_BSPLINE3};
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        const struct linear_row row = {shapes[s], LINEAR_MUSL, 2, 0.1};
        const double limit = linear_step_limit(&row, 32), pi = acos(-1.0);
        double below = 0.0, above = 0.0;
        for (int k = 1; k < 32; k++) {
            below = fmax(below, linear_step_growth(&row, 0.9 * limit, pi * k / 32));
            above = fmax(above, linear_step_growth(&row, 1.01 * limit, pi * k / 32));
        }
        ck_assert_double_eq_tol(below, 1.0, 1e-6);
        ck_assert_double_gt(above, 1.05);
    }
}
END_TEST

/* -------------------------------------------------------- a stretched column */

/* A column of 24 particles, two to a cell unstretched, of a material whose stress is its stretch
 * less one. */
static struct stretched_column column_at(double stretch, enum stretched_order order)
{
    return (struct stretched_column){.order = order,
                                     .position = STRETCHED_GRID_VELOCITY,
                                     .fraction = 1.0,
                                     .particles = 24,
                                     .length = 0.5 * stretch,
                                     .stress = stretch - 1.0,
                                     .tangent = stretch,
                                     .density = 1.0 / stretch};
}

static const double STRETCHES[] = {0.83, 1.05, 1.15, 1.27, 1.35, 1.45};
enum { STRETCH_COUNT = sizeof STRETCHES / sizeof *STRETCHES };

/* Eigenvalues on the unit circle are known to half the digits: 1e-7 a step of 0.28. */
static const double NO_RATE = 4e-7;

START_TEST(a_stretched_column_with_strains_from_the_grid_velocity_does_not_grow)
{
    const double stretch = STRETCHES[_i];
    const struct stretched_column usl = column_at(stretch, STRETCHED_USL);
    ck_assert_double_lt(fabs(stretched_column_rate(&usl, 0.4 / stretch)), NO_RATE);
}
END_TEST

/* What re-extrapolation does with tension, and positions that strains follow do not. (USF and USAVG
 * have strains ahead of such positions when forces are taken, which grows under compression.) */
START_TEST(a_stretched_column_grows_only_where_positions_and_strains_part_and_under_tension)
{
    static const enum stretched_order ORDERS[] = {STRETCHED_MUSL, STRETCHED_USF, STRETCHED_USAVG};
    const double stretch = STRETCHES[_i], step = 0.4 / stretch;
    for (size_t k = 0; k < sizeof ORDERS / sizeof *ORDERS; k++) {
        struct stretched_column column = column_at(stretch, ORDERS[k]);
        const double rate = stretched_column_rate(&column, step);
        if (stretch > 1.0)
            ck_assert_double_gt(rate, 0.3 * (stretch - 1.0) * step / 0.4);
        else
            ck_assert_double_lt(rate, NO_RATE);
        column.position = STRETCHED_STRAIN_VELOCITY;
        if (stretch > 1.0 || ORDERS[k] == STRETCHED_MUSL)
            ck_assert_double_lt(fabs(stretched_column_rate(&column, step)), NO_RATE);
    }
}
END_TEST

START_TEST(the_rate_of_a_stretched_column_is_proportional_to_the_step)
{
    const struct stretched_column column = column_at(STRETCHES[_i], STRETCHED_USAVG);
    const double step = 0.1 / STRETCHES[_i];
    const double ratio =
        stretched_column_rate(&column, step) / stretched_column_rate(&column, 0.5 * step);
    ck_assert_double_eq_tol(ratio, 2.0, 0.02);
}
END_TEST

START_TEST(a_column_outside_of_the_range_has_no_rate)
{
    struct stretched_column column = column_at(1.45, STRETCHED_MUSL);
    ck_assert_double_nan(stretched_column_rate(&column, 0.0));
    column.particles = 1;
    ck_assert_double_nan(stretched_column_rate(&column, 0.1));
    column.particles = STRETCHED_PARTICLES_MAX + 1;
    ck_assert_double_nan(stretched_column_rate(&column, 0.1));
}
END_TEST

Suite *suite_stability(void)
{
    Suite *suite = suite_create("stability");
    TCase *border = tcase_create("bisection");
    tcase_add_test(border, bisection_encloses_the_border_to_its_tolerance);
    tcase_add_test(border, bisection_says_when_all_or_none_passes);
    tcase_add_test(border, bisection_counts_what_passes_above_a_failure_and_stays_below_it);
    tcase_add_test(border, bisection_passes_a_failed_test_on);
    suite_add_tcase(suite, border);
    TCase *theory = tcase_create("linear theory");
    tcase_add_loop_test(theory, the_linear_step_has_the_limits_done_by_hand, 0, LIMIT_COUNT);
    tcase_add_test(theory, below_its_limit_the_linear_step_does_not_grow_and_above_it_does);
    suite_add_tcase(suite, theory);
    TCase *column = tcase_create("stretched column");
    tcase_add_loop_test(column,
                        a_stretched_column_with_strains_from_the_grid_velocity_does_not_grow, 0,
                        STRETCH_COUNT);
    tcase_add_loop_test(
        column, a_stretched_column_grows_only_where_positions_and_strains_part_and_under_tension, 0,
        STRETCH_COUNT);
    tcase_add_loop_test(column, the_rate_of_a_stretched_column_is_proportional_to_the_step, 1,
                        STRETCH_COUNT);
    tcase_add_test(column, a_column_outside_of_the_range_has_no_rate);
    suite_add_tcase(suite, column);
    return suite;
}
