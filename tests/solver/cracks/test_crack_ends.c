/* Tips that end at a crack, their own or another one, while the run goes on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/results.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2 };
static const double PI = 3.14159265358979323846;

/* Pulled apart along y; wave speed 8.5. */
static const char BLOCK[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [32, 26]}\n"
    "time: {end: 100, courant: 0.3}\n"
    "method: {shape: ugimp}\n"
    "materials: [{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: block, material: stiff, region: {rectangle: {from: [2, 3], to: [30, 23]}},\n"
    "     velocity: [0, '0.02*(y - 13)']}\n";

#define GROWS "propagation: {toughness: 1e-4, longest: 20, every: 4}"

/* The first crack grows from the left along y = 13.37 towards the second, which passes there at
 * x = 20.3 and an angle to the x axis. */
static struct test_run open_junction(double degrees, bool from_start, const char *more)
{
    const double angle = PI / 180.0 * degrees, half = 4.0;
    const double c = half * cos(angle), s = half * sin(angle);
    char *const text = g_strdup_printf(
        "cracks=[{points: %s, contact: none, j_integral: [{tip: %s, contour: 2, " GROWS
        "}, {tip: %s, contour: 3}]}, {points: [[%.9g, %.9g], [%.9g, %.9g]], contact: none%s}]",
        from_start ? "[[11.4, 13.37], [1, 13.37]]" : "[[1, 13.37], [11.4, 13.37]]",
        from_start ? "start" : "end", from_start ? "start" : "end", 20.3 - c, 13.37 - s, 20.3 + c,
        13.37 + s, more);
    const char *const settings[] = {text, NULL};
    const struct test_run run = test_run_open(BLOCK, settings, 1);
    g_free(text);
    return run;
}

/* From a tip to the nearest point of the second crack's chain, at points 1/50 of a segment apart.
 */
static double distance_to_second(const struct test_run *run, const double tip[AXES])
{
    const struct mpm_crack_chain *const chain = &run->simulation->state.cracks.chains[1];
    double least = HUGE_VAL;
    for (size_t k = 0; k + 1 < chain->count; k++)
        for (int i = 0; i <= 50; i++) {
            const double part = 0.02 * i;
            least =
                fmin(least, hypot(chain->x[k] + part * (chain->x[k + 1] - chain->x[k]) - tip[0],
                                  chain->y[k] + part * (chain->y[k + 1] - chain->y[k]) - tip[1]));
        }
    return least;
}

/* Increments of half a cell: the contour around the tip reaches from 1.5 to 2.5 cells on, the tip
 * is at most one increment short of it, and a crack that is oblique is met at the contour's edge,
 * beside the tip's way. */
static const double ANGLES[] = {90, 75, 60, 45, 120, 135};

START_TEST(a_tip_ends_before_another_crack_and_the_run_goes_on)
{
    const bool from_start = _i % 2 == 1;
    struct test_run run = open_junction(ANGLES[_i / 2], from_start, "");
    struct mpm_tip_end end = {.reason = MPM_TIP_GOES_ON};
    char message[MPM_MESSAGE_SIZE] = "";
    int steps = 0;
    for (; steps < 120; steps++) {
        test_run_steps(&run, 1);
        if (mpm_simulation_tip_end(run.simulation, 0, &end, message))
            break;
    }
    ck_assert_int_lt(steps, 120);
    ck_assert_int_eq((int)end.reason, MPM_TIP_CONTOUR_MEETS_CRACK);
    ck_assert_uint_eq(end.met, 1);
    ck_assert_uint_eq(end.step, mpm_simulation_step(run.simulation));
    ck_assert_near(end.time, mpm_simulation_time(run.simulation), 1e-12);
    const struct mpm_j_integral ended = test_run_j_integral(&run, 0);
    ck_assert_msg(ended.grown > 2.0, "grown by %g", ended.grown);
    const double left = distance_to_second(&run, end.place);
    ck_assert_msg(left > 1.5 && left < 3.0 * sqrt(2.0), "%g cells left", left);
    for (int k = 0; k < AXES; k++) {
        ck_assert_double_eq(ended.tip[k], end.place[k]);
        ck_assert(isnan(ended.j[k]) && isnan(ended.stress_intensity[k]));
    }
    test_run_steps(&run, 30);
    const struct mpm_j_integral later = test_run_j_integral(&run, 0);
    ck_assert(later.grown == ended.grown && later.dissipated == ended.dissipated);
    test_run_close(&run);
}
END_TEST

/* The second crack runs along x = 20.3, so that the contour of two cells around a node at x = 18
 * would reach 20 and that around 19 would reach past it: the tip does not pass x = 18.5. Half a
 * cell from 11.4 on, with a material that moves by less than 0.1. */
START_TEST(a_tip_ends_at_the_last_increment_whose_contour_has_no_other_crack)
{
    struct test_run run = open_junction(90.0, _i == 1, "");
    struct mpm_tip_end end;
    char message[MPM_MESSAGE_SIZE];
    test_run_steps(&run, 120);
    ck_assert(mpm_simulation_tip_end(run.simulation, 0, &end, message));
    ck_assert_near(test_run_j_integral(&run, 0).grown, 7.0, 1e-12);
    ck_assert_ptr_nonnull(strstr(message, "would meet or surround cracks.1; it grows no further"));
    test_run_close(&run);
}
END_TEST

/* A contour of three cells meets the other crack before the tip has ended: it has no value there.
 * The other tip of the growing crack, and those of the second one, are not concerned. */
START_TEST(a_contour_that_growth_brings_to_another_crack_has_no_value)
{
    struct test_run run = open_junction(90.0, false, ", j_integral: [{contour: 2}]");
    test_run_steps(&run, 120);
    ck_assert(isnan(test_run_j_integral(&run, 1).j[0]));
    ck_assert(isnan(test_run_j_integral(&run, 1).stress_intensity[0]));
    ck_assert(isfinite(test_run_j_integral(&run, 2).j[0]));
    test_run_close(&run);
}
END_TEST

/* Both grow towards each other, and both end. */
START_TEST(tips_that_grow_towards_each_other_both_end)
{
    static const char cracks[] =
        "cracks=[{points: [[1, 13.37], [9.4, 13.37]], contact: none, j_integral: [{contour: "
        "2, " GROWS "}]}, {points: [[31.6, 14.61], [22.6, 14.61]], contact: none, j_integral: "
        "[{contour: 2, " GROWS "}]}]";
    const char *const settings[] = {cracks, NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_tip_end end;
    char message[MPM_MESSAGE_SIZE];
    test_run_steps(&run, 120);
    for (size_t k = 0; k < 2; k++) {
        ck_assert(mpm_simulation_tip_end(run.simulation, k, &end, message));
        ck_assert_uint_eq(end.met, 1 - k);
        ck_assert_double_gt(test_run_j_integral(&run, k).grown, 2.0);
    }
    test_run_close(&run);
}
END_TEST

/* A tip that has turned back meets its own crack with its third increment. */
START_TEST(a_tip_ends_at_its_own_crack)
{
    static const char cracks[] =
        "cracks=[{points: [[14.3, 0.2], [14.3, 14.6], [18, 14.6], [18, 13.2], [16.1, 13.2]], "
        "contact: "
        "none, j_integral: [{contour: 4, propagation: {toughness: 1e-7, longest: 8, every: 5}}]}]";
    const char *const settings[] = {cracks, NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_tip_end end = {.reason = MPM_TIP_GOES_ON};
    char message[MPM_MESSAGE_SIZE];
    test_run_steps(&run, 120);
    ck_assert(mpm_simulation_tip_end(run.simulation, 0, &end, message));
    ck_assert_int_eq((int)end.reason, MPM_TIP_MEETS_CRACK);
    ck_assert_uint_eq(end.met, 0);
    ck_assert_near(test_run_j_integral(&run, 0).grown, 1.5, 1e-12);
    ck_assert_ptr_nonnull(strstr(message, "the next increment would meet cracks.0"));
    test_run_close(&run);
}
END_TEST

/* In steps 37, 74 and 111 both cracks would grow: the third time the first one ends, and there is
 * no room for the second one, which fails the run. It goes back to where the first one has not
 * ended. */
START_TEST(a_failed_run_goes_back_to_a_tip_that_has_not_ended)
{
    static const char *const cracks =
        "cracks=[{points: [[1, 13.37], [11.2, 13.37]], contact: none, j_integral: [{contour: 2, "
        "propagation: {toughness: 1e-5, longest: 20, every: 37}}]}, {points: [[1, 18.61], [11.2, "
        "18.61]], contact: none, j_integral: [{contour: 2, propagation: {toughness: 1e-9, longest: "
        "%g, every: 37}}]}, {points: [[14.3, 10.1], [14.3, 15.2]], contact: none}]";
    for (int k = 0; k < 2; k++) {
        char *const text = g_strdup_printf(cracks, k == 0 ? 1.1 : 8.0);
        const char *const settings[] = {text, NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        struct mpm_tip_end end;
        char message[MPM_MESSAGE_SIZE];
        struct mpm_error error = {.status = MPM_OK};
        test_run_steps(&run, 110);
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, HUGE_VAL, &error),
                         k == 0 ? MPM_RUN_FAILED : MPM_OK);
        ck_assert(mpm_simulation_tip_end(run.simulation, 0, &end, message) == (k == 1));
        ck_assert(isfinite(test_run_j_integral(&run, 0).j[0]) == (k == 0));
        ck_assert_near(test_run_j_integral(&run, 0).grown, 1.0, 1e-12);
        test_run_close(&run);
        g_free(text);
    }
}
END_TEST

START_TEST(the_run_record_lists_tips_that_have_ended_and_the_history_has_no_value_there)
{
    GString *const text = g_string_new(BLOCK);
    g_string_replace(text, "end: 100, courant: 0.3", "end: 100, courant: 0.3, steps: 110", 1);
    g_string_append(text, "cracks: [{points: [[1, 13.37], [15.4, 13.37]], contact: none, "
                          "j_integral: [{contour: 2, " GROWS
                          "}]}, {points: [[20.3, 9.2], [20.3, 17.1]], contact: none}]\n"
                          "output: {history: 1}\n");
    test_results_scene(text->str);
    g_string_free(text, TRUE);
    test_results_run_well();
    json_t *const record = test_results_json("run.json");
    const json_t *const tips = json_object_get(record, "ended_tips");
    const json_t *const tip = json_array_get(tips, 0);
    ck_assert_uint_eq(json_array_size(tips), 1);
    ck_assert_str_eq(json_string_value(json_object_get(tip, "integral")), "cracks.0.j_integral.0");
    ck_assert_str_eq(json_string_value(json_object_get(tip, "reason")), "contour_meets_crack");
    ck_assert_int_eq(json_integer_value(json_object_get(tip, "met")), 1);
    ck_assert_uint_eq(json_array_size(json_object_get(record, "warnings")), 1);
    json_decref(record);
    char *const path = g_build_filename(test_results.output, "history.csv", NULL);
    char *history = NULL;
    ck_assert(g_file_get_contents(path, &history, NULL, NULL));
    const char *const last = g_strrstr_len(history, (gssize)strlen(history) - 1, "\n");
    ck_assert_ptr_nonnull(strstr(last, ",nan,nan,nan,nan,3,"));
    g_free(history);
    g_free(path);
}
END_TEST

Suite *suite_crack_ends(void)
{
    Suite *suite = suite_create("crack_ends");
    TCase *ends = tcase_create("ends"), *results = tcase_create("results");
    tcase_add_loop_test(ends, a_tip_ends_before_another_crack_and_the_run_goes_on, 0,
                        2 * (int)G_N_ELEMENTS(ANGLES));
    tcase_add_loop_test(ends, a_tip_ends_at_the_last_increment_whose_contour_has_no_other_crack, 0,
                        2);
    tcase_add_test(ends, a_contour_that_growth_brings_to_another_crack_has_no_value);
    tcase_add_test(ends, tips_that_grow_towards_each_other_both_end);
    tcase_add_test(ends, a_tip_ends_at_its_own_crack);
    tcase_add_test(ends, a_failed_run_goes_back_to_a_tip_that_has_not_ended);
    tcase_add_checked_fixture(results, test_results_set_up, test_results_tear_down);
    tcase_add_test(results,
                   the_run_record_lists_tips_that_have_ended_and_the_history_has_no_value_there);
    suite_add_tcase(suite, ends);
    suite_add_tcase(suite, results);
    return suite;
}
