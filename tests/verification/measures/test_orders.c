/* Tests of what convergence is measured by: norms of errors, orders, their interval, classes of
 * series, the grid-convergence index.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/error_norms.h"
#include "verification/measures/grid_convergence.h"
#include "verification/measures/orders.h"

#include "tests/suites.h"
#include "tests/support/near.h"

#include <math.h>

enum { LEVELS = 5 };

/* Logarithms of a handful of numbers near one, divided by a spread near one. */
static const double ROUND = 1e-12;

/* h halves; the errors are those given by pairwise orders. */
static void series_of(size_t pairs, const double *orders, double *h, double *error)
{
    h[0] = 1;
    error[0] = 0.3;
    for (size_t k = 0; k < pairs; k++) {
        h[k + 1] = 0.5 * h[k];
        error[k + 1] = error[k] * pow(0.5, orders[k]);
    }
}

/* ------------------------------------------------------------------- norms */

START_TEST(norms_weigh_particles_by_volume_and_components_by_their_multiple)
{
    static const double volume[] = {1, 3}, multiple[] = {1, 2};
    static const double exact[] = {2, 0, 0, 2}, computed[] = {5, 0, 0, 0};
    /* errors 3 and 2 sqrt 2, shares 1/4 and 3/4 */
    const struct error_norms n = error_norms(2, 2, multiple, volume, computed, exact);
    ck_assert_double_eq_tol(n.l1, 0.25 * 3 + 0.75 * sqrt(8), ROUND);
    ck_assert_double_eq_tol(n.l2, sqrt(0.25 * 9 + 0.75 * 8), ROUND);
    ck_assert_double_eq_tol(n.linf, 3, ROUND);
    ck_assert_double_eq_tol(n.exact_l2, sqrt(0.25 * 4 + 0.75 * 8), ROUND);
    ck_assert_double_eq_tol(n.exact_linf, sqrt(8), ROUND);
    ck_assert_double_eq_tol(error_norms_relative(&n), sqrt(8.25 / 7), ROUND);
    /* without multiples, errors 3 and 2 */
    ck_assert_double_eq_tol(error_norms(2, 2, NULL, volume, computed, exact).l1, 2.25, ROUND);
}
END_TEST

START_TEST(norms_do_not_depend_on_the_unit_of_volume_and_are_ordered)
{
    double volume[50], large[50], exact[50], computed[50];
    for (int p = 0; p < 50; p++) {
        volume[p] = 1 + 0.5 * sin(p);
        large[p] = 1e7 * volume[p];
        exact[p] = cos(3.0 * p);
        computed[p] = exact[p] + 1e-3 * sin(7.0 * p);
    }
    const struct error_norms a = error_norms(50, 1, NULL, volume, computed, exact);
    const struct error_norms b = error_norms(50, 1, NULL, large, computed, exact);
    ck_assert_double_eq_tol(a.l1, b.l1, ROUND);
    ck_assert_double_eq_tol(a.l2, b.l2, ROUND);
    ck_assert_double_lt(a.l1, a.l2);
    ck_assert_double_lt(a.l2, a.linf);
}
END_TEST

START_TEST(a_particle_of_no_weight_is_left_out_whatever_it_holds)
{
    const double weight[] = {1, 0, 3}, computed[] = {1, (double)NAN, 3};
    static const double zero[3] = {0}, kept_weight[] = {1, 3}, kept[] = {1, 3};
    const struct error_norms with = error_norms(3, 1, NULL, weight, computed, zero);
    const struct error_norms without = error_norms(2, 1, NULL, kept_weight, kept, zero);
    ck_assert_mem_eq(&with, &without, sizeof with);
    ck_assert_double_nan(error_norms(3, 1, NULL, zero, computed, zero).linf);
    ck_assert_double_eq_tol(error_norms(2, 1, NULL, NULL, kept, zero).l1, 2, ROUND);
}
END_TEST

START_TEST(norms_over_time_are_means_roots_of_mean_squares_and_maxima)
{
    static const struct error_norms at[] = {{1, 3, 5, 7, 9}, {2, 4, 1, 1, 2}};
    const struct error_norms n = error_norms_over_time(2, at);
    ck_assert_double_eq_tol(n.l1, 1.5, ROUND);
    ck_assert_double_eq_tol(n.l2, sqrt(12.5), ROUND);
    ck_assert_double_eq_tol(n.linf, 5, ROUND);
    ck_assert_double_eq_tol(n.exact_l2, 5, ROUND);
    ck_assert_double_eq_tol(n.exact_linf, 9, ROUND);
    ck_assert_double_nan(error_norms_over_time(0, at).l2);
}
END_TEST

START_TEST(a_nan_or_no_particle_is_a_nan_in_every_norm)
{
    static const double volume[] = {1, 1, 1}, exact[] = {0, 1, 2};
    const double computed[] = {0, (double)NAN, 2};
    const struct error_norms n = error_norms(3, 1, NULL, volume, computed, exact);
    const struct error_norms none = error_norms(0, 1, NULL, volume, computed, exact);
    ck_assert(isnan(n.l1) && isnan(n.l2) && isnan(n.linf));
    ck_assert(isnan(none.l1) && isnan(none.l2) && isnan(none.linf) && isnan(none.exact_l2));
}
END_TEST

/* ------------------------------------------------------------------ orders */

START_TEST(a_power_law_is_fitted_with_no_width)
{
    static const double p[] = {1.75, 1.75, 1.75, 1.75};
    double h[LEVELS], error[LEVELS];
    series_of(4, p, h, error);
    const struct order_fit fit = order_fit(LEVELS, h, error);
    ck_assert_double_eq_tol(fit.order, 1.75, ROUND);
    ck_assert_double_lt(fit.half_width, 1e-6); /* root of a difference of equals */
    ck_assert_double_eq_tol(order_constant(1.75, h[4], error[4]), 0.3, ROUND);
    for (size_t k = 1; k < LEVELS; k++)
        ck_assert_double_eq_tol(order_pair(k, h, error), 1.75, ROUND);
    ck_assert_double_nan(order_pair(0, h, error));
    ck_assert_double_nan(order_fit(2, h, error).half_width);
}
END_TEST

/* Four levels, ln h = 0, -1, -2, -3 and ln error = 2 ln h + (1, -1, -1, 1) d, which is orthogonal
 * to constant and slope: s^2 = 4 d^2 / 2, variance of the slope s^2 / 5. */
START_TEST(the_interval_is_that_of_students_t)
{
    static const double T_95 = 4.302652729911275; /* 2 degrees */
    static const double d = 0.05, sign[] = {1, -1, -1, 1};
    double h[4], error[4];
    for (int k = 0; k < 4; k++) {
        h[k] = exp(-k);
        error[k] = exp(-2 * k + d * sign[k]);
    }
    ck_assert_double_eq_tol(order_fit(4, h, error).order, 2, ROUND);
    ck_assert_double_eq_tol(order_fit(4, h, error).half_width, T_95 * d * sqrt(0.4), 1e-10);
}
END_TEST

START_TEST(levels_without_an_order_are_nan_and_undefined)
{
    double h[] = {1, 0.5, 0.25, 0.125}, error[] = {1, 0.25, 0.0625, 0.015625};
    const double spoiled[] = {(double)NAN, 0, -1, (double)INFINITY};
    for (int k = 0; k < 4; k++) {
        error[2] = spoiled[k];
        ck_assert_double_nan(order_fit(4, h, error).order);
        ck_assert_double_nan(order_last(4, h, error));
        ck_assert_uint_eq(order_classify(4, h, error), ORDER_UNDEFINED);
    }
    error[2] = 0.0625;
    ck_assert_uint_eq(order_classify(2, h, error), ORDER_UNDEFINED);
    h[1] = h[0];
    ck_assert_double_nan(order_fit(2, h, error).order);
}
END_TEST

static const struct {
    double orders[LEVELS - 1];
    enum order_class expected;
} SERIES[] = {
    {{2, 2, 2, 2}, ORDER_ASYMPTOTIC},         {{0.4, 1.1, 0.95, 1.0}, ORDER_ASYMPTOTIC},
    {{4.5, 2.1, 2, 2}, ORDER_ASYMPTOTIC}, /* a first pair above the order is no plateau later */
    {{0.5, 0.5, 0.5, 0.5}, ORDER_ASYMPTOTIC}, {{1, 1.2, 1.5, 1.9}, ORDER_APPROACHING},
    {{2, 2, 1.9, 1.4}, ORDER_APPROACHING},    {{2, 2, 1.5, 0.8}, ORDER_PLATEAU},
    {{2, 1, 0.2, 0.01}, ORDER_PLATEAU},       {{0.1, 0.05, 0, -0.05}, ORDER_PLATEAU},
    {{2, 1, 0.2, -0.2}, ORDER_PLATEAU},       {{2, -0.5, 1, 1}, ORDER_OSCILLATORY},
    {{5, -2, 2, 2}, ORDER_OSCILLATORY}, /* the error changed its sign on the second level */
    {{2, 1, 0, -0.3}, ORDER_DIVERGING},       {{-1, -1, -1, -1}, ORDER_DIVERGING},
};
enum { SERIES_COUNT = sizeof SERIES / sizeof SERIES[0] };

START_TEST(a_series_of_errors_has_the_class_that_the_rule_says)
{
    double h[LEVELS], error[LEVELS];
    series_of(LEVELS - 1, SERIES[_i].orders, h, error);
    const enum order_class found = order_classify(LEVELS, h, error);
    ck_assert_msg(found == SERIES[_i].expected, "series %d is %s, not %s", _i,
                  order_class_name(found), order_class_name(SERIES[_i].expected));
}
END_TEST

/* --------------------------------------------------- grid-convergence index */

START_TEST(the_index_is_the_safety_factor_times_the_error_of_a_power_law)
{
    /* f = 2 + 0.1 h^p on h = 4, 2, 1 and, with a ratio of 3, on 9, 3, 1 */
    for (int ratio = 2; ratio <= 3; ratio++) {
        const double p = 1.5, r = ratio;
        const double fine = 2 + 0.1, medium = 2 + 0.1 * pow(r, p), coarse = 2 + 0.1 * pow(r, 2 * p);
        const struct grid_convergence g = grid_convergence(coarse, medium, fine, r, 1.25);
        ck_assert_double_eq_tol(g.order, p, ROUND);
        ck_assert_double_eq_tol(g.extrapolated, 2, ROUND);
        ck_assert_double_eq_tol(g.index, 1.25 * 0.1 / fine, ROUND);
    }
}
END_TEST

START_TEST(a_series_that_turns_or_does_not_settle_has_no_index)
{
    ck_assert_double_nan(grid_convergence(1, 2, 1.5, 2, 1.25).index);
    ck_assert_double_nan(grid_convergence(1, 2, 3, 2, 1.25).index);
    ck_assert_double_nan(grid_convergence(1, 2, 4, 2, 1.25).index);
    ck_assert_double_nan(grid_convergence(1, 1, 1, 2, 1.25).index);
    ck_assert_double_nan(grid_convergence(2, 1, 1, 2, 1.25).index);
    ck_assert_double_nan(grid_convergence((double)NAN, 2, 3, 2, 1.25).order);
}
END_TEST

/* Values 5 + e h^q on grids with h = 4, 2, 1, of which the rule sees three; the formal order is 2.
 */
START_TEST(the_uncertainty_of_grids_is_larger_where_the_order_is_not_the_formal_one)
{
    static const struct {
        double order, used, safety;
    } list[] = {
        {2.0, 2.0, 1.25}, {1.9, 2.0, 1.25}, {1.0, 1.0, 3.0}, {3.0, 2.0, 3.0}, {0.2, 0.5, 3.0}};
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) {
        double values[4];
        for (int i = 0; i < 4; i++)
            values[i] = 5.0 - 0.1 * pow(2.0, -list[k].order * i);
        const double wanted = list[k].safety * fabs(values[3] - values[2]) / values[3] /
                              (pow(2.0, list[k].used) - 1.0);
        ck_assert_near(grid_uncertainty(4, values, 2.0, 2.0), wanted, 1e-13);
    }
}
END_TEST

START_TEST(two_grids_and_grids_that_do_not_converge_have_the_largest_uncertainty)
{
    static const double back[] = {1.0, 2.0, 1.5}, away[] = {1.0, 2.0, 4.0};
    const double least = pow(2.0, 0.5) - 1.0;
    ck_assert_near(grid_uncertainty(2, back, 2.0, 2.0), 3.0 * 0.5, 1e-15);
    ck_assert_near(grid_uncertainty(3, back, 2.0, 2.0), 3.0 * 0.5 / 1.5 / least, 1e-14);
    ck_assert_near(grid_uncertainty(3, away, 2.0, 2.0), 3.0 * 0.5 / least, 1e-14);
    ck_assert_double_nan(grid_uncertainty(1, back, 2.0, 2.0));
}
END_TEST

Suite *suite_orders(void)
{
    Suite *suite = suite_create("orders");
    TCase *norms = tcase_create("norms"), *orders = tcase_create("orders");
    tcase_add_test(norms, norms_weigh_particles_by_volume_and_components_by_their_multiple);
    tcase_add_test(norms, norms_do_not_depend_on_the_unit_of_volume_and_are_ordered);
    tcase_add_test(norms, a_particle_of_no_weight_is_left_out_whatever_it_holds);
    tcase_add_test(norms, norms_over_time_are_means_roots_of_mean_squares_and_maxima);
    tcase_add_test(norms, a_nan_or_no_particle_is_a_nan_in_every_norm);
    tcase_add_test(orders, a_power_law_is_fitted_with_no_width);
    tcase_add_test(orders, the_interval_is_that_of_students_t);
    tcase_add_test(orders, levels_without_an_order_are_nan_and_undefined);
    tcase_add_loop_test(orders, a_series_of_errors_has_the_class_that_the_rule_says, 0,
                        SERIES_COUNT);
    tcase_add_test(orders, the_index_is_the_safety_factor_times_the_error_of_a_power_law);
    tcase_add_test(orders, a_series_that_turns_or_does_not_settle_has_no_index);
    tcase_add_test(orders,
                   the_uncertainty_of_grids_is_larger_where_the_order_is_not_the_formal_one);
    tcase_add_test(orders, two_grids_and_grids_that_do_not_converge_have_the_largest_uncertainty);
    suite_add_tcase(suite, norms);
    suite_add_tcase(suite, orders);
    return suite;
}
