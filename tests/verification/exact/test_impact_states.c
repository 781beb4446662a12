/* Impact of a rod: the state at first contact and the way of nose and tail, against numbers
 * computed elsewhere and against the balances they come from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/plastic/alekseevskii_tate.h"
#include "verification/exact/plastic/hugoniot.h"

#include <math.h>

/* kg, mm, ms, GPa */
static const struct hugoniot tungsten = {17.6e-6, 3980, 1.24, 1.54, 134, 300};
static const struct hugoniot steel = {7.85e-6, 3574, 1.92, 1.69, 477, 300};

START_TEST(first_contact_has_the_pressure_of_both_hugoniots)
{
    const double u = hugoniot_contact(&tungsten, &steel, 1700.0);
    const struct hugoniot_state rod = hugoniot_behind(&tungsten, 1700.0 - u);
    const struct hugoniot_state target = hugoniot_behind(&steel, u);
    /* references.md P, to the digits given there */
    ck_assert_near(u, 1104.998, 6e-4);
    ck_assert_near(target.pressure, 49.405, 6e-4);
    ck_assert_near(target.shock_speed, 5695.6, 0.06);
    ck_assert_near(rod.shock_speed, 4717.8, 0.06);
    ck_assert_near(rod.pressure, target.pressure, 1e-12 * target.pressure);
}
END_TEST

START_TEST(a_body_that_meets_its_like_moves_at_half_the_speed)
{
    ck_assert_near(hugoniot_contact(&steel, &steel, 1200.0), 600.0, 1e-9);
}
END_TEST

/* references.md P, to the digits given there */
static const struct {
    double strength, resistance, nose[3], tail[3], depth, time;
} rods[] = {
    {1.5, 5.0, {8.45, 24.88, 40.26}, {-33.09, 0.06, 31.71}, 47.41, 61.2e-3},
    {1.5, 6.0, {7.99, 23.47, 37.77}, {-33.09, 0.04, 31.55}, 42.17, 57.6e-3},
    {2.0, 5.5, {8.43, 24.66, 39.50}, {-33.12, -0.26, 30.62}, 46.24, 61.9e-3},
};
enum { RODS = sizeof rods / sizeof rods[0] };

START_TEST(a_rod_s_nose_and_tail_are_where_they_were_computed_elsewhere)
{
    static const double times[3] = {10e-3, 30e-3, 50e-3}, DIGITS = 6e-3;
    const struct penetration p = {17.6e-6, 7.85e-6, rods[_i].strength, rods[_i].resistance,
                                  50.0,    1700.0};
    for (int k = 0; k < 3; k++) {
        const struct penetration_state s = penetration_at(&p, times[k]);
        ck_assert_near(s.nose, rods[_i].nose[k], DIGITS);
        ck_assert_near(s.tail, rods[_i].tail[k], DIGITS);
        ck_assert(!s.ended);
    }
    const struct penetration_state end = penetration_at(&p, 80e-3);
    ck_assert(end.ended);
    ck_assert_near(end.nose, rods[_i].depth, 0.02);
    ck_assert(!penetration_at(&p, 0.97 * rods[_i].time).ended);
}
END_TEST

START_TEST(pressures_on_both_sides_of_the_nose_are_the_same)
{
    const struct penetration p = {17.6e-6, 7.85e-6, 1.5, 5.0, 50.0, 1700.0};
    for (double v = 800.0; v < 3000.0; v += 100.0) {
        const double u = penetration_velocity(&p, v);
        ck_assert_near(0.5 * p.rod_density * (v - u) * (v - u) + p.strength,
                       0.5 * p.target_density * u * u + p.resistance, 1e-12 * p.resistance);
    }
    ck_assert_double_eq(penetration_velocity(&p, 600.0), 0.0);
}
END_TEST

START_TEST(like_bodies_without_strength_penetrate_at_half_the_speed)
{
    const struct penetration p = {1.0, 1.0, 0.0, 0.0, 1.0, 2.0};
    ck_assert_near(penetration_velocity(&p, 2.0), 1.0, 1e-15);
    ck_assert_near(penetration_at(&p, 0.5).tail, 0.0, 1e-12);
}
END_TEST

Suite *suite_impact_states(void)
{
    Suite *suite = suite_create("impact_states");
    TCase *tests = tcase_create("impact states");
    tcase_add_test(tests, first_contact_has_the_pressure_of_both_hugoniots);
    tcase_add_test(tests, a_body_that_meets_its_like_moves_at_half_the_speed);
    tcase_add_loop_test(tests, a_rod_s_nose_and_tail_are_where_they_were_computed_elsewhere, 0,
                        RODS);
    tcase_add_test(tests, pressures_on_both_sides_of_the_nose_are_the_same);
    tcase_add_test(tests, like_bodies_without_strength_penetrate_at_half_the_speed);
    suite_add_tcase(suite, tests);
    return suite;
}
