/* Tables of properties: values, integrals, and the change of temperature that content leads to.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/property.h"
#include "suites.h"
#include "support/near.h"

#include <math.h>

/* Up, down, flat. */
static double points[][2] = {{-10.0, 2.0}, {20.0, 2.0}, {50.0, 5.0}, {60.0, 1.0}, {100.0, 3.0}};
enum { POINTS = sizeof points / sizeof points[0] };

static struct mpm_property make(double integral[POINTS])
{
    const struct mpm_property made = {POINTS, points, integral};
    mpm_property_prepare(&made);
    return made;
}

/* Of numbers up to 300 after a few sums. */
static const double TOLERANCE = 1e-13;

START_TEST(values_are_linear_between_points_and_those_of_the_points)
{
    double integral[POINTS];
    const struct mpm_property table = make(integral);
    for (int k = 0; k < POINTS; k++)
        ck_assert_double_eq(mpm_property_value(&table, points[k][0]), points[k][1]);
    for (int k = 1; k < POINTS; k++)
        ck_assert_near(mpm_property_value(&table, 0.75 * points[k - 1][0] + 0.25 * points[k][0]),
                       0.75 * points[k - 1][1] + 0.25 * points[k][1], TOLERANCE);
    ck_assert_double_eq(mpm_property_value(&table, -50.0), 2.0);
    ck_assert_double_eq(mpm_property_value(&table, 1000.0), 3.0);
    ck_assert_near(mpm_property_slope(&table, 55.0), -0.4, TOLERANCE);
    ck_assert_near(mpm_property_slope(&table, 50.0), -0.4, TOLERANCE); /* that above it */
    ck_assert_double_eq(mpm_property_slope(&table, 100.0), 0.0);
    ck_assert_double_eq(mpm_property_slope(&table, -11.0), 0.0);
    ck_assert_double_eq(mpm_property_least(&table), 1.0);
    ck_assert_double_eq(mpm_property_largest(&table), 5.0);
}
END_TEST

START_TEST(integrals_are_those_of_many_trapezia_from_zero)
{
    enum { PARTS = 12000 }; /* every point is the end of one: exact but for the sum */
    double integral[POINTS], sum = 0.0;
    const struct mpm_property table = make(integral);
    const double width = 110.0 / PARTS;
    for (int k = 0; k < PARTS; k++) {
        const double from = -10.0 + k * width, to = -10.0 + (k + 1) * width;
        sum += 0.5 * width * (mpm_property_value(&table, from) + mpm_property_value(&table, to));
    }
    ck_assert_near(mpm_property_integral(&table, 100.0) - mpm_property_integral(&table, -10.0), sum,
                   1e-5); /* points within a part: width^2 times a change of slope */
    ck_assert_double_eq(mpm_property_integral(&table, 0.0), 0.0);
    ck_assert_near(mpm_property_integral(&table, 20.0), 40.0, TOLERANCE);
    ck_assert_near(mpm_property_integral(&table, 35.0), 40.0 + 15.0 * 2.75, TOLERANCE);
    ck_assert_near(mpm_property_integral(&table, 50.0), 145.0, TOLERANCE);
    ck_assert_near(mpm_property_integral(&table, 100.0), 145.0 + 30.0 + 80.0, TOLERANCE);
}
END_TEST

/* From every temperature to every other one, over any number of points, and beyond the ends. */
START_TEST(the_rise_by_some_content_leads_to_the_integral_with_it)
{
    double integral[POINTS];
    const struct mpm_property table = make(integral);
    for (int from = -30; from <= 120; from += 5)
        for (int to = -30; to <= 120; to += 1) {
            const double content =
                mpm_property_integral(&table, to) - mpm_property_integral(&table, from);
            ck_assert_near(from + mpm_property_rise(&table, from, content), to, 1e-12);
        }
    for (int from = -30; from <= 120; from += 5)
        ck_assert_double_eq(mpm_property_rise(&table, from, 0.0), 0.0);
    ck_assert_near(mpm_property_rise(&table, 20.0, 1e-12), 0.5e-12, 1e-25); /* no cancellation */
}
END_TEST

START_TEST(a_table_covers_its_ends_and_nothing_beyond)
{
    double integral[POINTS];
    const struct mpm_property table = make(integral), none = {.count = 0};
    ck_assert(mpm_property_covers(&table, -10.0) && mpm_property_covers(&table, 100.0));
    ck_assert(!mpm_property_covers(&table, nextafter(-10.0, -20.0)));
    ck_assert(!mpm_property_covers(&table, nextafter(100.0, 200.0)));
    ck_assert(!mpm_property_covers(&table, (double)NAN));
    ck_assert(mpm_property_covers(&none, 1e30));
}
END_TEST

START_TEST(the_largest_ratio_is_that_of_all_temperatures_in_common)
{
    static double others[][2] = {{0.0, 4.0}, {30.0, 1.0}, {55.0, 2.0}, {200.0, 2.0}};
    static double beyond[][2] = {{100.5, 4.0}, {130.0, 1.0}};
    double integral[POINTS], largest = 0.0;
    const struct mpm_property table = make(integral), other = {4, others, NULL};
    const struct mpm_property apart = {2, beyond, NULL};
    for (int k = 0; k <= 100000; k++) {
        const double at = 0.001 * k;
        largest = fmax(largest, mpm_property_value(&table, at) / mpm_property_value(&other, at));
    }
    ck_assert_near(mpm_property_largest_ratio(&table, &other), largest, 1e-9);
    ck_assert_double_lt(mpm_property_largest_ratio(&table, &apart), 0.0);
}
END_TEST

Suite *suite_property(void)
{
    Suite *suite = suite_create("property");
    TCase *table = tcase_create("table");
    tcase_add_test(table, values_are_linear_between_points_and_those_of_the_points);
    tcase_add_test(table, integrals_are_those_of_many_trapezia_from_zero);
    tcase_add_test(table, the_rise_by_some_content_leads_to_the_integral_with_it);
    tcase_add_test(table, a_table_covers_its_ends_and_nothing_beyond);
    tcase_add_test(table, the_largest_ratio_is_that_of_all_temperatures_in_common);
    suite_add_tcase(suite, table);
    return suite;
}
