/* What takes part in manufactured solutions, and the refusal of degenerate choices, names and
 * values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/manufactured.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2 };

/* ----------------------------------------------------------------- activity */

START_TEST(every_field_has_all_terms_at_its_own_end)
{
    struct manufactured_problem problem;
    struct mpm_error error = {.message = ""};
    if (!test_problem_at(_i, &problem))
        return;
    struct manufactured_activity activity;
    const double cell[AXES] = {problem.domain.high[0] / 16.0, problem.domain.high[1] / 16.0};
    const enum mpm_status status =
        manufactured_activity(&problem, problem.end, cell, &activity, &error);
    if (problem.geometry == MPM_AXISYMMETRIC &&
        strcmp(manufactured_name(problem.field), "axis_aligned") == 0) {
        ck_assert_int_eq(status, MPM_BAD_INPUT); /* P_zr = 0: nothing of the hoop in z */
        ck_assert_msg(strstr(error.message, "the share of the hoop terms of component 1 is 0") !=
                          NULL,
                      "%s", error.message);
        return;
    }
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    for (int axis = 0; axis < AXES; axis++) {
        const double squares = activity.acceleration[axis] * activity.acceleration[axis] +
                               activity.divergence[axis] * activity.divergence[axis];
        ck_assert_near(squares, activity.velocity[axis] > 0.0 ? 1.0 : 0.0, 1e-14);
    }
    if (problem.law == MANUFACTURED_NEO_HOOKEAN)
        ck_assert_double_ge(activity.nonlinear, 0.02);
}
END_TEST

struct degenerate {
    const char *field, *parameter;
    double value, part_of_period; /* 0: the field's own end */
    double cells;
    enum mpm_geometry geometry;
    const char *words;
};
static const struct degenerate DEGENERATES[] = {
    {"axis_aligned", "waves", 1, 0.25, 16, MPM_PLANE_STRAIN, "a turning point"},
    {"cylinder", "waves", 1, 0.75, 16, MPM_AXISYMMETRIC, "a turning point"},
    {"vortex", "amplitude", 0.2, 0.25, 16, MPM_PLANE_STRAIN, "a turning point"},
    {"axis_aligned", "waves", 1, 0.5, 16, MPM_PLANE_STRAIN, "a passage through zero"},
    {"expanding_ring", "amplitude", 0.1, 1.0, 16, MPM_PLANE_STRESS, "a passage through zero"},
    {"axis_aligned", "waves", 8, 0, 16, MPM_PLANE_STRAIN, "displacement at the nodes"},
    {"axis_aligned", "waves", 32, 0, 64, MPM_PLANE_STRAIN, "displacement at the nodes"},
    {"axis_aligned", "amplitude", 1e-3, 0, 1e4, MPM_PLANE_STRAIN, "cells of 0.0001 by 0.0001"},
    {"axis_aligned", "waves", 4, 0, 16, MPM_PLANE_STRAIN, "det F is"},
    {"axis_aligned", "amplitude", 1e-3, 0, 16, MPM_AXISYMMETRIC, "hoop terms of component 1"},
    {"axis_aligned", "waves", 4, 0, 64, MPM_PLANE_STRAIN, "the share of the acceleration"},
};

START_TEST(a_degenerate_choice_is_refused_with_its_reason)
{
    const struct degenerate *const d = &DEGENERATES[_i];
    struct manufactured_problem problem = test_problem(d->field, "neo_hookean", d->geometry);
    struct manufactured_activity activity;
    struct mpm_error error = {.message = ""};
    const bool large = strstr(d->words, "det F") != NULL;
    if (strcmp(d->parameter, "waves") == 0 && !large)
        ck_assert_int_eq(manufactured_set(&problem, "amplitude", 1e-4, &error), MPM_OK);
    ck_assert_int_eq(manufactured_set(&problem, d->parameter, d->value, &error), MPM_OK);
    const double end = d->part_of_period > 0.0 ? d->part_of_period * problem.period : problem.end;
    const double cell[AXES] = {1.0 / d->cells, 1.0 / d->cells};
    ck_assert_msg(manufactured_activity(&problem, end, cell, &activity, &error) == MPM_BAD_INPUT,
                  "passed: %s %g", d->field, d->value);
    ck_assert_msg(strstr(error.message, d->words) != NULL, "%s", error.message);
}
END_TEST

/* ------------------------------------------------------------------ choices */

START_TEST(names_and_values_that_are_not_allowed_are_refused)
{
    struct manufactured_setup setup = {"vortex", "neo_hookean", MPM_PLANE_STRAIN, 1.0, 1.0, 1.0};
    struct manufactured_problem problem;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_OK);
    ck_assert_int_eq(manufactured_set(&problem, "radius", 1.0, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "parameter `radius` of field `vortex`; allowed: amplitude");
    ck_assert_int_eq(manufactured_set(&problem, "amplitude", 2.0, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "amplitude of field `vortex` is 2; allowed: 1e-09 to 1");
    ck_assert_int_eq(manufactured_set(&problem, "amplitude", (double)NAN, &error), MPM_BAD_INPUT);
    setup.shear = 0.0;
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "shear modulus is 0; allowed: above 0");
    setup.law = "rubber";
    setup.shear = 1.0;
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "law `rubber`; allowed: neo_hookean, linear_elastic");
    setup.field = "whirl";
    ck_assert_int_eq(manufactured_open(&setup, &problem, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "field `whirl`; allowed: axis_aligned, expanding_ring, vortex, "
                                    "cylinder, bar");
    ck_assert(manufactured_at(TEST_FIELDS) == NULL && manufactured_at(TEST_FIELDS - 1) != NULL);
}
END_TEST

/* verification/exact/README.md goes through a new field with one that is in the build. */
START_TEST(the_tutorials_field_is_a_file_of_the_build_with_less_than_60_lines)
{
    char *tutorial = NULL, *field = NULL;
    size_t lines = 0;
    ck_assert(g_file_get_contents("verification/exact/README.md", &tutorial, NULL, NULL));
    ck_assert(
        g_file_get_contents("verification/exact/manufactured/field_bar.c", &field, NULL, NULL));
    char *block = g_strdup_printf("```c\n%s```\n", field);
    ck_assert_msg(strstr(tutorial, block) != NULL, "README.md and field_bar.c differ");
    for (const char *c = field; *c != 0; c++)
        lines += *c == '\n';
    ck_assert_uint_lt(lines, 60);
    g_free(tutorial);
    g_free(field);
    g_free(block);
}
END_TEST

Suite *suite_activity(void)
{
    Suite *suite = suite_create("activity");
    TCase *choices = tcase_create("choices");
    tcase_add_loop_test(choices, every_field_has_all_terms_at_its_own_end, 0, TEST_PROBLEMS);
    tcase_add_loop_test(choices, a_degenerate_choice_is_refused_with_its_reason, 0,
                        sizeof DEGENERATES / sizeof *DEGENERATES);
    tcase_add_test(choices, names_and_values_that_are_not_allowed_are_refused);
    tcase_add_test(choices, the_tutorials_field_is_a_file_of_the_build_with_less_than_60_lines);
    suite_add_tcase(suite, choices);
    return suite;
}
