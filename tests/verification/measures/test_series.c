/* Steps in series of numbers over revisions, by series made by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/measures/comparison/series_steps.h"

#include <math.h>

enum { MOST = 10 };

#define NONE (double)NAN

static const struct series_case {
    const char *what;
    size_t count;
    double numbers[MOST], least, noise;
    size_t step_count, at[MOST];
} SERIES[] = {
    {"nothing", 0, {0}, 1e-3, 0, 0, {0}},
    {"one number", 1, {3}, 1e-3, 0, 0, {0}},
    {"always the same", 5, {2, 2, 2, 2, 2}, 1e-3, 0, 0, {0}},
    {"one step for good", 6, {2, 2, 2, 3, 3, 3}, 1e-3, 0, 1, {3}},
    {"there and back", 6, {2, 2, 3, 2, 2, 2}, 1e-3, 0, 2, {2, 3}},
    {"round-off", 6, {2, 2 + 1e-12, 2, 2 - 1e-12, 2, 2}, 1e-3, 5e-13, 0, {0}},
    {"just below what counts", 2, {1000, 1000.9}, 1e-3, 0, 0, {0}},
    {"just above what counts", 2, {1000, 1001.1}, 1e-3, 0, 1, {1}},
    /* changes 1/8 of the larger: four times that is more than the last one, 0.36 */
    {"no larger than the noise", 6, {7, 8, 7, 8, 7, 11}, 1e-3, 0.125, 0, {0}},
    /* the last change is 1 - 7/15 = 0.53 */
    {"larger than the noise", 6, {7, 8, 7, 8, 7, 15}, 1e-3, 0.125, 1, {5}},
    {"a run without the number", 5, {2, NONE, 2, NONE, 3}, 1e-3, 0, 1, {4}},
    {"begins later", 4, {NONE, NONE, 2, 2}, 1e-3, 0, 0, {0}},
    {"a sign", 2, {-1, 1}, 1e-3, 0, 1, {1}},
    {"from zero", 2, {0, 1e-9}, 1e-3, 0, 1, {1}},
};

START_TEST(steps_are_changes_beyond_the_noise_and_beyond_what_counts)
{
    const struct series_case *c = &SERIES[_i];
    double work[MOST];
    struct series_step steps[MOST];
    const double noise = series_noise(c->numbers, c->count, work);
    ck_assert_msg(fabs(noise - c->noise) <= 1e-15, "%s: noise %g", c->what, noise);
    const size_t count = series_steps(c->numbers, c->count, noise, c->least, steps);
    ck_assert_msg(count == c->step_count, "%s: %zu steps", c->what, count);
    for (size_t i = 0; i < count; i++)
        ck_assert_msg(steps[i].to == c->at[i], "%s: step at %zu", c->what, steps[i].to);
}
END_TEST

START_TEST(a_step_is_from_the_last_number_that_is_known)
{
    const double numbers[] = {2, NONE, NONE, 4};
    struct series_step steps[4];
    ck_assert_uint_eq(series_steps(numbers, 4, 0, SERIES_LEAST_VALUE, steps), 1);
    ck_assert_uint_eq(steps[0].from, 0);
    ck_assert_double_eq(steps[0].change, 0.5);
}
END_TEST

Suite *suite_series(void)
{
    Suite *suite = suite_create("series");
    TCase *pieces = tcase_create("steps");
    tcase_add_loop_test(pieces, steps_are_changes_beyond_the_noise_and_beyond_what_counts, 0,
                        sizeof SERIES / sizeof *SERIES);
    tcase_add_test(pieces, a_step_is_from_the_last_number_that_is_known);
    suite_add_tcase(suite, pieces);
    return suite;
}
