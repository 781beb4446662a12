/* mpm-bench: timing of points, runs side by side, the scenes that are timed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "benchmarks/common/bench.h"
#include "benchmarks/measuring/side_by_side.h"
#include "benchmarks/measuring/timing.h"
#include "verification/common/record.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* A probe that counts its calls and takes ever the same time. */
static enum mpm_status count_calls(const void *context, struct bench_sample *sample,
                                   struct mpm_error *error)
{
    int *const calls = *(int *const *)context;
    (void)error;
    ++*calls;
    *sample = (struct bench_sample){.work = 6, .cpu = 2, .wall = 3};
    return MPM_OK;
}

struct bench_of_test {
    struct bench_context context;
    struct bench_console console;
    struct bench_records records;
    FILE *out;
};

static void open_bench(struct bench_of_test *test)
{
    test->out = tmpfile();
    test->console = (struct bench_console){.out = test->out};
    test->records = bench_records_make("quick", "test", BENCH_ROUNDS_MAX);
    test->context = (struct bench_context){
        .tier = BENCH_QUICK,
        .simulation = {.threads = 1},
        .processors = 1,
        .benchmarks = "benchmarks",
        .records = &test->records,
        .console = &test->console,
    };
}

static void close_bench(struct bench_of_test *test)
{
    bench_records_clear(&test->records);
    (void)fclose(test->out);
}

START_TEST(every_point_has_one_value_for_each_round_by_its_clock)
{
    struct bench_of_test test;
    struct bench_rates rates;
    struct mpm_error error;
    int calls = 0, *counter = &calls;
    open_bench(&test);
    GArray *points = bench_points_new();
    char *scene = bench_scene(&test.context, "block.yaml");
    (void)bench_points_add_probe(points, count_calls, &counter, "apples", "1/s", "by cpu");
    bench_points_add_probe(points, count_calls, &counter, "apples", "1/s", "by wall")->clock =
        BENCH_CLOCK_WALL;
    struct bench_point *block = bench_points_add(points, scene, &test.context.simulation, "block");
    block->steps = 3;
    block->phases = true;
    block->against = g_strdup("block");
    ck_assert_int_eq(bench_measure(&test.context, "test", points, 1e-3, &rates, &error), MPM_OK);
    ck_assert_uint_eq(rates.rounds, BENCH_ROUNDS_MIN);
    ck_assert_int_eq(calls, 2 * (BENCH_ROUNDS_MIN + 1)); /* and the rehearsal */
    for (size_t r = 0; r < rates.rounds; r++) {
        ck_assert_double_eq(bench_rates_of(&rates, 0)[r], 3);
        ck_assert_double_eq(bench_rates_of(&rates, 1)[r], 2);
        ck_assert_double_gt(bench_rates_of(&rates, 2)[r], 0);
    }
    const json_t *line =
        bench_records_find(&test.records, "result", "test", "block", "particle_steps_per_second");
    const json_t *settings = json_object_get(line, "settings");
    ck_assert_double_eq(record_number(settings, "particles"), 100);
    ck_assert_double_eq(record_number(settings, "steps"), 3);
    ck_assert_str_eq(record_text(settings, "clock"), "cpu");
    line = bench_records_find(&test.records, "comparison", "test", "block", NULL);
    ck_assert_str_eq(record_text(line, "verdict"), "not resolved");
    ck_assert_ptr_nonnull(
        bench_records_find(&test.records, "value", "test", "block", "bytes_per_particle"));
    bench_rates_clear(&rates);
    g_array_unref(points);
    g_free(scene);
    close_bench(&test);
}
END_TEST

START_TEST(a_scene_that_fails_is_named)
{
    struct bench_of_test test;
    struct mpm_error error;
    open_bench(&test);
    GArray *points = bench_points_new();
    (void)bench_points_add(points, "nowhere.yaml", &test.context.simulation, "nothing");
    ck_assert_int_eq(bench_measure(&test.context, "test", points, 1, NULL, &error), MPM_BAD_INPUT);
    ck_assert_msg(g_str_has_prefix(error.message, "nothing: "), "%s", error.message);
    g_array_unref(points);
    close_bench(&test);
}
END_TEST

START_TEST(the_scenes_of_the_block_make_the_particles_that_they_promise)
{
    static const char *const scenes[] = {"benchmarks/scenes/block.yaml",
                                         "benchmarks/scenes/block_axisymmetric.yaml"};
    for (size_t i = 0; i < G_N_ELEMENTS(scenes); i++) {
        static const char *const settings[] = {"grid.refine=3"};
        const struct mpm_simulation_options options = {.threads = 1};
        struct mpm_scene *scene;
        struct mpm_plan plan;
        struct mpm_error error;
        ck_assert_int_eq(mpm_scene_read(scenes[i], settings, 1, &scene, &error), MPM_OK);
        ck_assert_int_eq(mpm_scene_plan(scene, &options, &plan, &error), MPM_OK);
        ck_assert_uint_eq(plan.particles, 900);
        mpm_scene_free(scene);
    }
}
END_TEST

/* --------------------------------------------------------------- side by side */

START_TEST(runs_side_by_side_are_counted_together_by_the_wall_clock)
{
    struct bench_of_test test;
    struct bench_rates rates;
    struct mpm_error error = {.message = ""};
    open_bench(&test);
    GArray *points = bench_points_new();
    char *scene = bench_scene(&test.context, "block.yaml");
    struct bench_point *point = bench_points_add(points, scene, &test.context.simulation, "two");
    point->steps = 4;
    point->runs = 2;
    point->clock = BENCH_CLOCK_WALL;
    ck_assert_msg(bench_measure(&test.context, "test", points, 1e-3, &rates, &error) == MPM_OK,
                  "%s", error.message);
    for (size_t r = 0; r < rates.rounds; r++)
        ck_assert(bench_rates_of(&rates, 0)[r] > 0 && isfinite(bench_rates_of(&rates, 0)[r]));
    bench_rates_clear(&rates);
    g_array_unref(points);
    g_free(scene);
    close_bench(&test);
}
END_TEST

/* All steps of all runs are counted; together they take no more processor time than there is
 * between the first one's start and the last one's end. */
START_TEST(runs_side_by_side_take_all_their_steps_at_once)
{
    enum { RUNS = 3, STEPS = 20 };
    static const double CLOCKS = 1e-3; /* s; of two clocks, read one after the other */
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_scene *scene;
    struct bench_sample sample;
    struct mpm_error error;
    ck_assert_int_eq(mpm_scene_read("benchmarks/scenes/block.yaml", NULL, 0, &scene, &error),
                     MPM_OK);
    const struct bench_runs runs = {scene, &options, RUNS, 2, STEPS};
    ck_assert_int_eq(bench_side_by_side(&runs, &sample, &error), MPM_OK);
    ck_assert_double_eq(sample.work, RUNS * STEPS);
    ck_assert_double_gt(sample.cpu, 0.0);
    ck_assert_double_le(sample.cpu, RUNS * (sample.wall + CLOCKS));
    mpm_scene_free(scene);
}
END_TEST

/* In the warm-up, before the start that they have in common, and after it. */
START_TEST(runs_side_by_side_fail_as_one_of_them_does)
{
    static const char *const settings[] = {"time={end: 1000, step: 0.001, allow_unstable: true}",
                                           "loads={body_force: ['sqrt(0.0045-t)', 0]}"};
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_scene *scene;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_scene_read("benchmarks/scenes/block.yaml", settings, G_N_ELEMENTS(settings),
                                 &scene, &error) == MPM_OK,
                  "%s", error.message);
    for (unsigned warm_up = 1; warm_up < 10; warm_up += 8) {
        struct bench_sample sample;
        const struct bench_runs runs = {scene, &options, 2, warm_up, 9};
        ck_assert_int_eq(bench_side_by_side(&runs, &sample, &error), MPM_RUN_FAILED);
        ck_assert_msg(strstr(error.message, "load not finite") != NULL, "%s", error.message);
    }
    mpm_scene_free(scene);
}
END_TEST

Suite *suite_timing(void)
{
    Suite *suite = suite_create("timing");
    TCase *tcase = tcase_create("timing");
    tcase_add_test(tcase, every_point_has_one_value_for_each_round_by_its_clock);
    tcase_add_test(tcase, a_scene_that_fails_is_named);
    tcase_add_test(tcase, the_scenes_of_the_block_make_the_particles_that_they_promise);
    tcase_add_test(tcase, runs_side_by_side_are_counted_together_by_the_wall_clock);
    tcase_add_test(tcase, runs_side_by_side_take_all_their_steps_at_once);
    tcase_add_test(tcase, runs_side_by_side_fail_as_one_of_them_does);
    suite_add_tcase(suite, tcase);
    return suite;
}
