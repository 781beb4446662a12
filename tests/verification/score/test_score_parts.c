/* What scores are made of: values between the points of a reference, and agreement.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/score/score.h"

#include <math.h>
#include <string.h>

/* x^3 - 2 x^2 y + 3 y^3 + 1, which cubic polynomials along each axis reproduce. */
static double cubic(const double place[2])
{
    const double x = place[0], y = place[1];
    return x * x * x - 2 * x * x * y + 3 * y * y * y + 1;
}

START_TEST(what_is_between_points_is_cubic_or_linear)
{
    struct lattice lattice = {.from = {-1, 2}, .to = {3, 5}, .count = {9, 7}};
    double values[63];
    for (size_t p = 0; p < G_N_ELEMENTS(values); p++) {
        double place[2];
        lattice_point(&lattice, p, place);
        values[p] = cubic(place);
    }
    for (int i = 0; i <= 40; i++) {
        const double place[2] = {-1 + 0.1 * i, 2 + 0.075 * (40 - i)};
        struct lattice_weights weights;
        ck_assert(lattice_locate(&lattice, place, &weights));
        /* 63 values of up to 400, weights of up to 1 */
        ck_assert_double_eq_tol(lattice_value(&lattice, &weights, values), cubic(place), 1e-11);
    }
    lattice.linear = true;
    struct lattice_weights weights;
    ck_assert(lattice_locate(&lattice, (const double[]){-0.75, 2}, &weights));
    ck_assert_double_eq_tol(lattice_value(&lattice, &weights, values),
                            0.5 * (values[0] + values[1]), 1e-12);
    ck_assert(!lattice_locate(&lattice, (const double[]){3.01, 2}, &weights));
    ck_assert(!lattice_locate(&lattice, (const double[]){0, (double)NAN}, &weights));
}
END_TEST

START_TEST(a_ring_is_told_by_radius_and_angle)
{
    const struct lattice ring = {
        .from = {1, 0}, .to = {2, 6.283185307179586}, .count = {5, 97}, .polar = true};
    double values[5 * 97];
    for (size_t p = 0; p < G_N_ELEMENTS(values); p++) {
        double place[2];
        lattice_point(&ring, p, place);
        values[p] = place[0] * place[1]; /* R^2 sin(2 theta)/2 */
    }
    for (int i = 0; i < 16; i++) {
        const double angle = -3.1 + 0.39 * i, place[2] = {1.6 * cos(angle), 1.6 * sin(angle)};
        struct lattice_weights weights;
        ck_assert(lattice_locate(&ring, place, &weights));
        /* (3/128) h^4 f'''' with h = 2 pi/96 and f'''' = 8 R^2: 9e-6 */
        ck_assert_double_eq_tol(lattice_value(&ring, &weights, values), place[0] * place[1], 1e-5);
    }
    struct lattice_weights weights;
    ck_assert(!lattice_locate(&ring, (const double[]){0.5, 0.5}, &weights));
}
END_TEST

START_TEST(agreement_is_100_percent_less_the_relative_error)
{
    static const double multiple[2] = {1, 2};
    static const double exact[2][2] = {{3, 0}, {0, 2}}, computed[2][2] = {{3, 1}, {0.5, 2}};
    static const double expected[AGREEMENT_NORMS] = {
        /* errors sqrt 2 and 1/2, sizes 3 and sqrt 8 */
        [AGREEMENT_L1] = 100 * (1 - (1.4142135623730951 + 0.5) / (3 + 2.8284271247461903)),
        [AGREEMENT_L2] = 100 * (1 - 1.5 / 4.123105625617661),
        [AGREEMENT_LINF] = 100 * (1 - 1.4142135623730951 / 3),
        [AGREEMENT_MEAN] = 100 * 6.5 / 5,
    };
    struct agreement agreement = {.error = 0}, other = {.error = 0};
    agreement_add(&agreement, 2, multiple, computed[0], exact[0]);
    agreement_add(&other, 2, multiple, computed[1], exact[1]);
    agreement_join(&agreement, &other);
    for (int norm = 0; norm < AGREEMENT_NORMS; norm++) {
        ck_assert_double_eq_tol(agreement_percent(&agreement, (enum agreement_norm)norm),
                                expected[norm], 1e-12);
        ck_assert_uint_gt(strlen(agreement_norm_words((enum agreement_norm)norm)), 0);
    }
    agreement_add(&agreement, 1, multiple, (const double[]){(double)NAN}, exact[0]);
    for (int norm = 0; norm < AGREEMENT_NORMS; norm++)
        ck_assert(isnan(agreement_percent(&agreement, (enum agreement_norm)norm)));
    const struct agreement nothing = {.error = 0};
    ck_assert(isnan(agreement_percent(&nothing, AGREEMENT_L2)));
}
END_TEST

Suite *suite_score_parts(void)
{
    Suite *suite = suite_create("score_parts");
    TCase *parts = tcase_create("parts");
    tcase_add_test(parts, what_is_between_points_is_cubic_or_linear);
    tcase_add_test(parts, a_ring_is_told_by_radius_and_angle);
    tcase_add_test(parts, agreement_is_100_percent_less_the_relative_error);
    suite_add_tcase(suite, parts);
    return suite;
}
