/* A run from outside the solver: instants, outcome, refusals, a disk that fills up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/history.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/results.h"

#include <errno.h>
#include <glib.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>

/* --------------------------------------------------------------------- run */

/* Instants are k * interval, not sums of intervals: equal to the last bit. */
START_TEST(snapshots_land_on_their_instants_and_on_the_end)
{
    const double times[] = {0.0, 0.3, 2 * 0.3, 3 * 0.3, 1.0};
    test_results_run_well();
    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    ck_assert_uint_eq(json_array_size(files), G_N_ELEMENTS(times));
    for (size_t i = 0; i < G_N_ELEMENTS(times); i++) {
        struct test_snapshot snapshot = test_results_listed(files, i);
        ck_assert(snapshot.time == times[i]);
        ck_assert_uint_eq(snapshot.count, TEST_BLOCKS_PARTICLES);
        test_snapshot_free(&snapshot);
    }
    json_decref(list);
}
END_TEST

/* 0.01 is no binary fraction: 29 * 0.01 / 0.01 is below 29, and 30 * 0.01 and the end
 * 0.3 are one instant, not two. */
START_TEST(round_off_neither_loses_nor_doubles_an_instant)
{
    enum { INSTANTS = 30 };
    test_results_scene(
        TEST_BLOCKS_WITH("{end: 0.3, courant: 0.4}", "{history: 0.01, snapshots: 0.01}"));
    test_results_run_well();
    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    ck_assert_uint_eq(json_array_size(files), INSTANTS + 1);
    ck_assert_uint_eq(rows, INSTANTS + 1);
    for (size_t i = 0; i <= INSTANTS; i++) {
        struct test_snapshot snapshot = test_results_listed(files, i);
        ck_assert(snapshot.time == (i == INSTANTS ? 0.3 : (double)i * 0.01));
        ck_assert(values[i][TEST_HISTORY_TIME] == snapshot.time);
        test_snapshot_free(&snapshot);
    }
    g_free(values);
    json_decref(list);
}
END_TEST

START_TEST(history_has_the_first_step_at_or_after_each_interval)
{
    enum { INTERVALS = 10 };
    const double round_off = 1e-9; /* of an interval: as the solver itself allows */
    test_results_run_well();
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    ck_assert_uint_eq(rows, INTERVALS + 1);
    ck_assert(values[0][TEST_HISTORY_TIME] == 0.0 && values[0][TEST_HISTORY_STEP] == 0.0);
    ck_assert(values[rows - 1][TEST_HISTORY_TIME] == 1.0);
    for (size_t i = 0; i < rows; i++) {
        const double due = 0.1 * (double)i;
        ck_assert(values[i][TEST_HISTORY_TIME] >= due - 0.1 * round_off);
        ck_assert(values[i][TEST_HISTORY_TIME] < due + 0.1);
    }
    g_free(values);
}
END_TEST

START_TEST(without_intervals_the_first_and_the_last_state_are_written)
{
    test_results_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4}", "{}"));
    test_results_run_well();
    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    ck_assert_uint_eq(json_array_size(files), 2);
    ck_assert_uint_eq(rows, 2);
    ck_assert(values[1][TEST_HISTORY_TIME] == 1.0);
    g_free(values);
    json_decref(list);
}
END_TEST

START_TEST(a_number_of_steps_ends_the_run)
{
    test_results_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4, steps: 5}", "{history: 0.1}"));
    test_results_run_well();
    json_t *record = test_results_json("run.json");
    const json_t *counters = json_object_get(record, "counters");
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "done");
    ck_assert_int_eq(json_integer_value(json_object_get(counters, "steps")), 5);
    ck_assert_int_eq(json_integer_value(json_object_get(counters, "particle_steps")),
                     (json_int_t)5 * TEST_BLOCKS_PARTICLES);
    json_decref(record);
}
END_TEST

static void check_keys(const json_t *object, const char *const *keys, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ck_assert_msg(json_object_get(object, keys[i]) != NULL, "no key %s", keys[i]);
}

START_TEST(the_run_record_tells_outcome_cost_and_origin)
{
    static const char *const top[] = {"outcome",  "cause",         "reason",     "exit_status",
                                      "warnings", "energy_growth", "ended_tips", "counters",
                                      "kernels",  "simd",          "provenance", "resumed"};
    static const char *const counted[] = {"steps",   "particles", "particle_steps",
                                          "seconds", "bytes",     "checkpoints"};
    static const char *const timed[] = {"setup", "step", "output", "checkpoint"};
    static const char *const sized[] = {"total", "per_particle"};
    static const char *const origin[] = {"scene",     "scene_sha256", "settings", "revision",
                                         "version",   "compiler",     "flags",    "libraries",
                                         "processor", "threads"};
    test_results_run_well();
    json_t *record = test_results_json("run.json");
    const json_t *counters = json_object_get(record, "counters");
    check_keys(record, top, G_N_ELEMENTS(top));
    check_keys(counters, counted, G_N_ELEMENTS(counted));
    check_keys(json_object_get(counters, "seconds"), timed, G_N_ELEMENTS(timed));
    check_keys(json_object_get(counters, "bytes"), sized, G_N_ELEMENTS(sized));
    check_keys(json_object_get(record, "provenance"), origin, G_N_ELEMENTS(origin));
    ck_assert_uint_eq(json_object_size(record), G_N_ELEMENTS(top));
    ck_assert_uint_eq(json_object_size(counters), G_N_ELEMENTS(counted));
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "done");
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), 0);
    ck_assert(json_is_null(json_object_get(record, "cause")));
    ck_assert(json_is_null(json_object_get(record, "energy_growth")));
    ck_assert_uint_eq(json_array_size(json_object_get(record, "warnings")), 0);
    json_decref(record);
}
END_TEST

START_TEST(a_failed_run_writes_its_last_good_state)
{
    test_results_scene(TEST_BLOCKS_UNSTABLE);
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(test_results_run(false, &error), MPM_RUN_FAILED);
    json_t *record = test_results_json("run.json");
    const json_int_t steps =
        json_integer_value(json_object_get(json_object_get(record, "counters"), "steps"));
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "failed");
    ck_assert_str_eq(json_string_value(json_object_get(record, "reason")), error.message);
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), MPM_RUN_FAILED);

    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    struct test_snapshot last = test_results_listed(files, json_array_size(files) - 1);
    ck_assert_int_eq(last.step, steps);
    for (size_t i = 0; i < 2 * last.count; i++)
        ck_assert(isfinite(last.fields[MPM_FIELD_POSITION][i]));
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    ck_assert(values[rows - 1][TEST_HISTORY_STEP] == (double)steps);
    g_free(values);
    test_snapshot_free(&last);
    json_decref(list);
    json_decref(record);
}
END_TEST

/* The blocks at a Courant number at which USL feeds their energy: far above ten times that of the
 * start, with no load at all. */
static const char *const blown_up[] = {"time={end: 10, courant: 1}", "method={stress_update: usl}",
                                       "bodies.left.velocity=['2*(x-3.5)', '-2*(y-3.5)']",
                                       "output={history: 0.001, snapshots: 0.05}"};

START_TEST(no_row_is_of_a_state_with_more_than_ten_times_the_energy)
{
    const double limit = 10.0;
    struct mpm_error error = {.status = MPM_OK};
    mpm_scene_free(test_results.scene);
    ck_assert_int_eq(mpm_scene_read(test_results.scene_path, blown_up, G_N_ELEMENTS(blown_up),
                                    &test_results.scene, NULL),
                     MPM_OK);
    ck_assert_int_eq(test_results_run(false, &error), MPM_RUN_FAILED);
    json_t *record = test_results_json("run.json");
    const json_t *growth = json_object_get(record, "energy_growth");
    ck_assert_str_eq(json_string_value(json_object_get(record, "cause")), "energy_grown");
    ck_assert(json_number_value(json_object_get(growth, "largest_factor")) <= limit);
    ck_assert_uint_eq(json_array_size(json_object_get(record, "warnings")), 2);
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    for (size_t i = 0; i < rows; i++)
        ck_assert(values[i][TEST_HISTORY_TOTAL] <= limit * values[0][TEST_HISTORY_TOTAL]);
    g_free(values);
    json_decref(record);
}
END_TEST

START_TEST(a_run_without_a_folder_writes_nothing)
{
    const struct mpm_run_options options = {.simulation = {.threads = 1}};
    ck_assert_int_eq(mpm_scene_run(test_results.scene, &options, NULL), MPM_OK);
    ck_assert(!test_file_exists(test_results.output));
}
END_TEST

/* ----------------------------------------------------------------- refusal */

/* Too few threads, and a body that turns out to be empty when it is filled. */
START_TEST(bad_input_leaves_no_folder_behind)
{
    static const char *const settings[] = {"bodies.left.region.rectangle.to.0=2.1"};
    struct mpm_error error = {.status = MPM_OK};
    const struct mpm_run_options options = {.output = test_results.output,
                                            .simulation = {.threads = 0}};
    ck_assert_int_eq(mpm_scene_run(test_results.scene, &options, &error), MPM_BAD_INPUT);
    ck_assert(strstr(error.message, "threads") != NULL);
    mpm_scene_free(test_results.scene);
    ck_assert_int_eq(
        mpm_scene_read(test_results.scene_path, settings, 1, &test_results.scene, NULL), MPM_OK);
    ck_assert_int_eq(test_results_run(false, &error), MPM_BAD_INPUT);
    ck_assert(strstr(error.message, "left") != NULL);
    ck_assert(!test_file_exists(test_results.output));
}
END_TEST

START_TEST(a_file_in_place_of_the_folder_is_refused)
{
    struct mpm_error error = {.status = MPM_OK};
    char *file = test_folder_write(test_results.folder, "results", "mine\n");
    for (int overwrite = 0; overwrite < 2; overwrite++)
        ck_assert_int_eq(test_results_run(overwrite == 1, &error), MPM_BAD_INPUT);
    char *text = test_file_read(file);
    ck_assert_str_eq(text, "mine\n");
    g_free(text);
    g_free(file);
}
END_TEST

START_TEST(a_folder_with_results_is_refused_unless_it_may_be_overwritten)
{
    static const char *const results[] = {"run.json",
                                          "history.csv",
                                          "particles-999999.hdf",
                                          "particles-1234567.hdf",
                                          "particles.hdf.series",
                                          "checkpoint.h5",
                                          "checkpoint-previous.h5",
                                          "run.json.partial",
                                          "checkpoint.h5.partial",
                                          "particles-000007.hdf.partial"};
    static const char stale[] = "stale\n";
    for (size_t i = 0; i < G_N_ELEMENTS(results); i++) {
        struct mpm_error error = {.status = MPM_OK};
        g_free(test_results.output);
        test_results.output = g_strdup_printf("%s/results-%zu", test_results.folder, i);
        ck_assert_int_eq(g_mkdir_with_parents(test_results.output, 0755), 0);
        char *path = test_folder_write(test_results.output, results[i], stale);
        ck_assert_int_eq(test_results_run(false, &error), MPM_BAD_INPUT);
        ck_assert(strstr(error.message, results[i]) != NULL);
        ck_assert_int_eq(test_results_run(true, &error), MPM_OK);
        gchar *text = NULL;
        ck_assert(!g_file_get_contents(path, &text, NULL, NULL) || strcmp(text, stale) != 0);
        g_free(text);
        g_free(path);
    }
}
END_TEST

START_TEST(overwriting_removes_no_file_of_the_user)
{
    static const char *const mine[] = {"notes.txt", "particles-best.hdf", "particles.hdf",
                                       "history.csv.bak"};
    struct mpm_error error = {.status = MPM_OK};
    test_results_run_well();
    for (size_t i = 0; i < G_N_ELEMENTS(mine); i++)
        g_free(test_folder_write(test_results.output, mine[i], "mine\n"));
    ck_assert_int_eq(test_results_run(true, &error), MPM_OK);
    for (size_t i = 0; i < G_N_ELEMENTS(mine); i++) {
        char *path = test_folder_path(test_results.output, mine[i]);
        ck_assert(test_file_exists(path));
        g_free(path);
    }
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_the_environments_failure)
{
    struct mpm_error error = {.status = MPM_OK};
    g_free(test_results.output);
    test_results.output = test_folder_path(test_results.scene_path, "below-a-file");
    ck_assert_int_eq(test_results_run(false, &error), MPM_ENVIRONMENT_FAILED);
    ck_assert(strstr(error.message, "below-a-file") != NULL);
}
END_TEST

/* --------------------------------------------------------------- full disk */

/* Files end at `bytes`, as on a disk that fills up; until lift_limit. */
static struct rlimit set_limit(rlim_t bytes)
{
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGXFSZ, &ignore, NULL);
    struct rlimit before, limited;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
    limited = before;
    limited.rlim_cur = bytes;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limited), 0);
    return before;
}

static void lift_limit(const struct rlimit *before)
{
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, before), 0);
}

/* Wherever in a snapshot the disk ends: no half file, and HDF5 comes out of it well. */
START_TEST(a_full_disk_leaves_no_half_snapshot)
{
    static const rlim_t limits[] = {2048, 8192, 20000};
    char *snapshot = test_folder_path(test_results.output, "particles-000000.hdf");
    char *partial = g_strconcat(snapshot, ".partial", NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(limits); i++) {
        struct mpm_error error = {.status = MPM_OK};
        const struct rlimit before = set_limit(limits[i]);
        const enum mpm_status status = test_results_run(true, &error);
        lift_limit(&before);
        ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
        ck_assert_msg(strstr(error.message, "particles-000000.hdf") != NULL &&
                          strstr(error.message, g_strerror(EFBIG)) != NULL &&
                          strstr(error.message, "step 0") != NULL &&
                          strstr(error.message, "last complete snapshot: none") != NULL,
                      "%s", error.message);
        ck_assert(!test_file_exists(snapshot));
        ck_assert(!test_file_exists(partial));
        json_t *record = test_results_json("run.json");
        ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")),
                         MPM_ENVIRONMENT_FAILED);
        json_decref(record);
    }
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(test_results_run(true, &error), MPM_OK);
    g_free(partial);
    g_free(snapshot);
}
END_TEST

START_TEST(a_full_disk_leaves_whole_rows_in_the_history)
{
    const struct mpm_ledger ledgers[] = {{.step = 0}, {.step = 1}, {.step = 2, .mass = 1.0 / 3.0}};
    struct mpm_history *history = NULL;
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(mpm_history_create(test_results.folder, test_results.scene, &history, NULL),
                     MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledgers[0], NULL, NULL), MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledgers[1], NULL, NULL), MPM_OK);
    char *path = test_folder_path(test_results.folder, MPM_HISTORY_NAME);
    char *text = test_file_read(path);
    const struct rlimit before = set_limit(strlen(text) + 10);
    const enum mpm_status status = mpm_history_write(history, &ledgers[2], NULL, &error);
    lift_limit(&before);
    ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
    ck_assert(strstr(error.message, path) != NULL);
    char *left = test_file_read(path);
    ck_assert_str_eq(left, text);
    g_free(left);
    g_free(text);
    g_free(path);
    mpm_history_free(history);
}
END_TEST

static void add_case(Suite *suite, const char *name, const TTest *const *tests, size_t count)
{
    TCase *test_case = tcase_create(name);
    tcase_add_checked_fixture(test_case, test_results_set_up, test_results_tear_down);
    for (size_t i = 0; i < count; i++)
        tcase_add_test(test_case, tests[i]);
    suite_add_tcase(suite, test_case);
}

Suite *suite_scene_run(void)
{
    const TTest *const runs[] = {
        snapshots_land_on_their_instants_and_on_the_end,
        round_off_neither_loses_nor_doubles_an_instant,
        history_has_the_first_step_at_or_after_each_interval,
        without_intervals_the_first_and_the_last_state_are_written,
        a_number_of_steps_ends_the_run,
        the_run_record_tells_outcome_cost_and_origin,
        a_failed_run_writes_its_last_good_state,
        no_row_is_of_a_state_with_more_than_ten_times_the_energy,
        a_run_without_a_folder_writes_nothing,
    };
    const TTest *const refusals[] = {
        bad_input_leaves_no_folder_behind,
        a_file_in_place_of_the_folder_is_refused,
        a_folder_with_results_is_refused_unless_it_may_be_overwritten,
        overwriting_removes_no_file_of_the_user,
        a_folder_that_cannot_be_made_is_the_environments_failure,
        a_full_disk_leaves_no_half_snapshot,
        a_full_disk_leaves_whole_rows_in_the_history,
    };
    Suite *suite = suite_create("run");
    add_case(suite, "runs", runs, G_N_ELEMENTS(runs));
    add_case(suite, "refusals", refusals, G_N_ELEMENTS(refusals));
    return suite;
}
