/* Cohesive laws by themselves: traction, work, toughness.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"
#include "model/laws/cohesive.h"
#include "suites.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>

/* strength, toughness, stiffness, knee */
static const struct mpm_cohesive constants[] = {
    {&mpm_cohesive_linear, 2.0, 0.3, 200.0, 0.0, 0.0, 0.0, 0.0},
    {&mpm_cohesive_linear, 2.0, 0.0101, 200.0, 0.0, 0.0, 0.0, 0.0},
    {&mpm_cohesive_trilinear, 2.0, 0.3, 200.0, 0.05, 0.7, 0.0, 0.0},
    {&mpm_cohesive_trilinear, 2.0, 0.3, 200.0, 0.1, 2.0, 0.0, 0.0},
    {&mpm_cohesive_exponential, 2.0, 0.3, 200.0, 0.0, 0.0, 0.0, 0.0},
};

static struct mpm_cohesive settled(int index)
{
    struct mpm_cohesive cohesive = constants[index];
    double least;
    ck_assert(mpm_cohesive_settle(&cohesive, &least));
    ck_assert_double_gt(least, 0.0);
    return cohesive;
}

/* Where hardly a traction is left. */
static double end_of(const struct mpm_cohesive *cohesive)
{
    return cohesive->law == &mpm_cohesive_exponential ? 40.0 * cohesive->length
                                                      : 1.5 * cohesive->length;
}

/* By the trapezoidal rule with so many intervals; kinks and the exponential's curvature leave
 * (length/intervals)^2. */
static const double QUADRATURE = 2e-6;

START_TEST(work_of_a_law_is_the_integral_of_its_traction_and_in_the_end_the_toughness)
{
    enum { INTERVALS = 100000, LOOKS = 20 };
    const struct mpm_cohesive cohesive = settled(_i);
    const double step = end_of(&cohesive) / INTERVALS;
    double work = 0.0;
    for (int k = 0; k < INTERVALS; k++) {
        work += 0.5 * step *
                (mpm_cohesive_envelope(&cohesive, step * k) +
                 mpm_cohesive_envelope(&cohesive, step * (k + 1)));
        if (k % (INTERVALS / LOOKS) == 0)
            ck_assert_near(mpm_cohesive_work(&cohesive, step * (k + 1)), work,
                           QUADRATURE * cohesive.toughness);
    }
    ck_assert_near(work, cohesive.toughness, QUADRATURE * cohesive.toughness);
    ck_assert_near(mpm_cohesive_work(&cohesive, end_of(&cohesive)), cohesive.toughness,
                   1e-14 * cohesive.toughness);
}
END_TEST

START_TEST(traction_rises_to_the_strength_and_falls_from_there_on)
{
    const struct mpm_cohesive cohesive = settled(_i);
    double before = cohesive.strength;
    ck_assert_near(mpm_cohesive_envelope(&cohesive, 0.5 * cohesive.onset), 0.5 * cohesive.strength,
                   1e-15 * cohesive.strength);
    for (int k = 0; k <= 1000; k++) {
        const double opening = cohesive.onset + (end_of(&cohesive) - cohesive.onset) * k / 1000.0;
        const double traction = mpm_cohesive_envelope(&cohesive, opening);
        if (k == 0)
            ck_assert_near(traction, cohesive.strength, 1e-15 * cohesive.strength);
        ck_assert(traction <= before && traction >= 0.0);
        ck_assert_near(mpm_cohesive_secant(&cohesive, opening) * opening, traction,
                       1e-15 * cohesive.strength);
        before = traction;
    }
}
END_TEST

START_TEST(the_trilinear_law_goes_through_its_knee)
{
    const struct mpm_cohesive cohesive = settled(2);
    ck_assert_near(mpm_cohesive_envelope(&cohesive, 0.05), 0.7, 1e-15);
    ck_assert_near(mpm_cohesive_envelope(&cohesive, 0.03), 1.35, 1e-15);
    ck_assert_near(mpm_cohesive_envelope(&cohesive, 0.5 * (0.05 + cohesive.length)), 0.35, 1e-15);
}
END_TEST

/* 4 units in the last place. */
START_TEST(the_exponential_function_is_that_of_the_library)
{
    for (int k = -7000; k <= 7000; k++) {
        const double x = 0.1 * k, expected = exp(x);
        ck_assert_near(mpm_exponential(x), expected, 9e-16 * expected);
    }
    ck_assert(mpm_exponential(0.0) == 1.0 && mpm_exponential(-701.0) == 0.0);
}
END_TEST

Suite *suite_cohesive_laws(void)
{
    Suite *suite = suite_create("cohesive_laws");
    TCase *laws = tcase_create("laws");
    const int count = G_N_ELEMENTS(constants);
    tcase_add_loop_test(
        laws, work_of_a_law_is_the_integral_of_its_traction_and_in_the_end_the_toughness, 0, count);
    tcase_add_loop_test(laws, traction_rises_to_the_strength_and_falls_from_there_on, 0, count);
    tcase_add_test(laws, the_trilinear_law_goes_through_its_knee);
    tcase_add_test(laws, the_exponential_function_is_that_of_the_library);
    suite_add_tcase(suite, laws);
    return suite;
}
