/* Bundles and scores: what is exported, that a perfect answer passes, that a spoiled one does not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/bundles.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/near.h"

#include "verification/score/score.h"
#include "verification/suite/judge.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

/* -------------------------------------------------------------------------- bundles */

static const char *const exported[] = {"D5", "E3",  "H1",  "H2", "M1", "M2", "M3",
                                       "M4", "R1b", "T1b", "T3", "T4", "W1", "W2"};
enum { EXPORTED = 14 };

/* The agreement of each criterion, from the rows of a score. */
static void assert_rows(const struct bundle *bundle, const struct score_table *results,
                        size_t spoiled)
{
    struct mpm_error error = {.message = ""};
    GString *rows = g_string_new(NULL);
    ck_assert_msg(score_rows(bundle, results, rows, &error) == MPM_OK, "%s", error.message);
    const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
    for (size_t i = 0; i < bundle->criterion_count; i++) {
        const struct check_verdict judged =
            judge_check_with_proof(&bundle->criteria[i].check, &result);
        ck_assert_msg(verdict_is_red(judged.verdict.status) == (i == spoiled), "%s: %g %%",
                      bundle->criteria[i].check.name, judged.value);
        ck_assert_uint_eq(judged.mutations, judged.mutations_red);
        if (i != spoiled) /* 12 digits of the reference file */
            ck_assert_double_eq_tol(judged.value, 100, 1e-6);
    }
    g_string_free(rows, TRUE);
}

START_TEST(a_perfect_answer_scores_100_percent)
{
    struct bundle bundle;
    test_bundle_open(exported[_i], &bundle);
    assert_rows(&bundle, &bundle.reference, SIZE_MAX);
    bundle_close(&bundle);
}
END_TEST

static double largest_of(const struct bundle *bundle, const struct bundle_criterion *criterion)
{
    double largest = 0;
    for (size_t c = 0; c < criterion->column_count; c++)
        for (size_t p = 0; p < bundle->reference.rows; p++)
            largest = fmax(largest,
                           fabs(score_table_value(&bundle->reference, criterion->columns[c], p)));
    return largest;
}

/* Criteria of the same column turn red together; the others must not. */
static bool shares(const struct bundle_criterion *one, enum score_column column)
{
    for (size_t c = 0; c < one->column_count; c++)
        if (one->columns[c] == column)
            return true;
    return false;
}

START_TEST(each_quantity_that_is_spoiled_turns_red)
{
    struct bundle bundle;
    struct score_table copy;
    struct mpm_error error;
    test_bundle_open(exported[_i], &bundle);
    for (size_t i = 0; i < bundle.criterion_count; i++)
        for (size_t c = 0; c < bundle.criteria[i].column_count; c++) {
            const enum score_column column = bundle.criteria[i].columns[c];
            const double error_of_it = largest_of(&bundle, &bundle.criteria[i]);
            score_table_open(&copy);
            ck_assert_int_eq(score_table_append(&copy, &bundle.reference, bundle.format.geometry,
                                                "copy", &error),
                             MPM_OK);
            double *values = score_table_add(&copy, column);
            for (size_t p = 0; p < copy.rows; p++)
                values[p] += error_of_it;
            GString *rows = g_string_new(NULL);
            ck_assert_int_eq(score_rows(&bundle, &copy, rows, &error), MPM_OK);
            const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
            for (size_t k = 0; k < bundle.criterion_count; k++)
                ck_assert_int_eq(
                    verdict_is_red(judge_check(&bundle.criteria[k].check, &result).verdict.status),
                    shares(&bundle.criteria[k], column));
            g_string_free(rows, TRUE);
            score_table_close(&copy);
        }
    bundle_close(&bundle);
}
END_TEST

START_TEST(results_of_the_wrong_time_are_an_error_of_their_own)
{
    struct bundle bundle;
    struct mpm_error error;
    GString *rows = g_string_new(NULL);
    test_bundle_open("E3", &bundle);
    struct score_table *table = &bundle.reference;
    const double *time = score_table_add(table, SCORE_TIME);
    /* fields of the instant before under each time: finite numbers, all wrong */
    struct score_table late;
    score_table_open(&late);
    ck_assert_int_eq(score_table_append(&late, table, MPM_PLANE_STRAIN, "copy", &error), MPM_OK);
    double *shifted = score_table_add(&late, SCORE_TIME);
    for (size_t p = 0; p < late.rows; p++)
        shifted[p] = time[p] + 4;
    ck_assert_int_eq(score_rows(&bundle, &late, rows, &error), MPM_OK);
    const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
    for (size_t i = 0; i < bundle.criterion_count; i++)
        ck_assert(verdict_is_red(judge_check(&bundle.criteria[i].check, &result).verdict.status));
    for (size_t p = 0; p < late.rows; p++)
        shifted[p] = time[p] + 1e-3;
    ck_assert_int_eq(score_rows(&bundle, &late, rows, &error), MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "nothing at time 4 ms: the nearest is at 4.001"));
    score_table_close(&late);
    g_string_free(rows, TRUE);
    bundle_close(&bundle);
}
END_TEST

/* A copy of E3's bundle with one file changed; the message of its refusal. g_free. */
static char *refusal_of(const char *name, const char *from, const char *to)
{
    char *folder = test_folder_create(), *text = NULL;
    static const char *const files[] = {"problem.json", "problem.md", "reference.csv"};
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++) {
        char *path = g_build_filename(test_bundles, "E3", files[i], NULL);
        text = test_file_read(path);
        if (strcmp(files[i], name) == 0) {
            char **parts = g_strsplit(text, from, 2);
            ck_assert_msg(g_strv_length(parts) == 2, "%s is not in %s", from, name);
            g_free(text);
            text = g_strconcat(parts[0], to, parts[1], NULL);
            g_strfreev(parts);
        }
        g_free(test_folder_write(folder, files[i], text));
        g_free(text);
        g_free(path);
    }
    struct bundle bundle;
    struct mpm_error error = {.message = "accepted"};
    if (bundle_read(folder, &bundle, &error) == MPM_OK)
        bundle_close(&bundle);
    test_folder_remove(folder);
    return g_strdup(error.message);
}

START_TEST(a_bundle_that_was_changed_is_refused_with_the_reason)
{
    static const struct {
        const char *name, *from, *to, *message;
    } table[] = {
        {"problem.json", "{", "[", "problem.json:2: "},
        {"problem.json", "\"format\": 1", "\"format\": 2", "format: allowed is 1"},
        {"problem.json", "\"case\": \"E3\"", "\"case\": \"../E3\"", "family, case: allowed is"},
        {"problem.json", "plane_strain", "plane", "geometry: allowed is plane_strain"},
        {"problem.json", "\"end\": 64.0", "\"end\": -1", "an end > 0"},
        {"problem.json", "\"instants\": 16", "\"instants\": 17", "has 1105 rows: allowed are 1170"},
        {"problem.json", "\"instants\": 16", "\"instants\": \"16\"", "1 to 1000 instants"},
        {"problem.json", "65,", "0,", "a count from 1 to 10000"},
        {"problem.json", "\"count\"", "\"counts\"", "from, to and count, two numbers each"},
        {"problem.json", "\"norm\": \"l2\"", "\"norm\": \"l3\"", "l1, l2, linf or mean"},
        {"problem.json", "\"low\": 92.0", "\"low\": -92.0", "the band holds zero"},
        {"problem.json", "\"low\": 92.0", "\"low\": null", "criterion displacement: "},
        {"problem.json", "        \"displacement_x\"", "        \"displacement_y\"",
         "a column of reference.csv"},
        {"problem.json", "\"criterion\": \"stress\"", "\"criterion\": \"a/b\"",
         "criterion, title and why"},
        {"problem.json", "\"criterion\": \"stress\"", "\"criterion\": \"displacement\"",
         "criteria: criterion: allowed is each name once"},
        {"reference.csv", "[mm]", "[m]", "reference.csv:1: initial_x is in \"m\""},
        {"reference.csv", "\n0,0.25,0.5,0", "\n0,0.25,0.5,nan", "is not a finite number"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *message = refusal_of(table[i].name, table[i].from, table[i].to);
        ck_assert_msg(strstr(message, table[i].message) != NULL, "row %zu: %s", i, message);
        g_free(message);
    }
}
END_TEST

/* ---------------------------------------------------------------------- the command */

/* Scores the bundle's own reference with the first `from` replaced by `to`. */
static struct test_command score_text(const char *name, const char *from, const char *to,
                                      const char *output)
{
    char *path = g_build_filename(test_bundles, name, "reference.csv", NULL);
    char *good = test_file_read(path), *home = test_folder_path(test_bundles, name);
    char **parts = g_strsplit(good, from, 2);
    ck_assert_uint_eq(g_strv_length(parts), 2);
    char *text = g_strconcat(parts[0], to, parts[1], NULL);
    char *results = test_folder_write(test_bundles, "results.csv", text);
    struct test_command command = test_command_run("mpm-verify", "score", home, results, "--output",
                                                   output, "--name", "mine", NULL);
    g_free(results);
    g_free(text);
    g_strfreev(parts);
    g_free(home);
    g_free(good);
    g_free(path);
    return command;
}

START_TEST(the_command_says_and_reports_what_the_score_is)
{
    char *output = test_folder_path(test_bundles, "report");
    struct test_command command =
        score_text("E3", "stress_xx [g mm^-1 ms^-2]\n", "stress_xx\n", output);
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    ck_assert_ptr_nonnull(strstr(command.output, "3 passed, 0 failed, 0 skipped"));
    char *page_path = g_build_filename(output, "cases/E3/index.html", NULL);
    char *page = test_file_read(page_path);
    ck_assert_ptr_nonnull(strstr(page, "displacement along the bar"));
    ck_assert_ptr_nonnull(strstr(page, "mpm-verify score "));
    ck_assert_ptr_nonnull(strstr(page, "mine"));
    test_command_free(&command);
    command = score_text("E3", "8,4,0.5,7.0", "8,4,0.5,-9e9\n8,4,0.5,7.0", output);
    ck_assert_int_eq(command.exit_status, 2); /* a row with cells missing */
    test_command_free(&command);
    command = score_text("E3", ",displacement_x", ",colour,displacement_x", output);
    ck_assert_int_eq(command.exit_status, 2);
    test_command_free(&command);
    g_free(page);
    g_free(page_path);
    g_free(output);
}
END_TEST

START_TEST(bad_results_end_with_status_2_and_touch_nothing)
{
    static const struct {
        const char *name, *from, *to, *message;
    } table[] = {
        {"E3", "displacement_x", "displacement_q",
         "the results have no column displacement_x, in mm"},
        {"E3", "time [ms]", "age [ms]", "the results have no column time, in ms"},
        {"E3", "initial_x", "place_x", "the results have no column initial_x, in mm"},
        {"E3", "[mm ms^-1]", "[m/s]", "velocity_x is in \"m/s\": allowed is \"mm ms^-1\""},
        {"E3", "\n64,16,", "\n64,17,", "starts at (17, 0.5), outside of the body"},
        {"E3", "\n4,", "\n4.5,", NULL}, /* one point less at 4 ms: enough of them */
        {"T3", "initial_r [mm]", "initial_x [mm]", "no column initial_r"},
        {"T3", "10.0625,", "inf,", "\"inf\" is not a finite number"},
    };
    char *output = test_folder_path(test_bundles, "none");
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct test_command command = score_text(table[i].name, table[i].from, table[i].to, output);
        if (table[i].message == NULL) {
            ck_assert_msg(command.exit_status == 0, "row %zu: %s", i, command.errors);
            char *made = g_strdup_printf("rm -r %s", output);
            test_command_free(&command);
            ck_assert(g_spawn_command_line_sync(made, NULL, NULL, NULL, NULL));
            g_free(made);
            continue;
        }
        ck_assert_msg(command.exit_status == 2, "row %zu: %s%s", i, command.output, command.errors);
        ck_assert_msg(strstr(command.errors, table[i].message) != NULL, "row %zu: %s", i,
                      command.errors);
        ck_assert(!test_file_exists(output));
        test_command_free(&command);
    }
    g_free(output);
}
END_TEST

START_TEST(too_few_points_are_refused)
{
    char *home = test_folder_path(test_bundles, "T3"),
         *output = test_folder_path(test_bundles, "few");
    char *results = test_folder_write(test_bundles, "few.csv",
                                      "initial_r,displacement_r,stress_rr,stress_zz,stress_tt\n11,"
                                      "1,1,1,1\n14,1,1,1,1\n19,1,1,1,1\n");
    struct test_command command =
        test_command_run("mpm-verify", "score", home, results, "--output", output, NULL);
    ck_assert_int_eq(command.exit_status, 2);
    ck_assert_msg(strstr(command.errors, "too few points: none in part 3, 1 of 4 x 1") != NULL,
                  "%s", command.errors);
    test_command_free(&command);
    command = test_command_run("mpm-verify", "score", home, "/nowhere", NULL);
    ck_assert_int_eq(command.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(command.errors, "/nowhere: no such file or folder"));
    test_command_free(&command);
    command = test_command_run("mpm-verify", "score", test_bundles, results, NULL);
    ck_assert_int_eq(command.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(command.errors, "problem.json"));
    test_command_free(&command);
    command = test_command_run("mpm-verify", "export", NULL);
    ck_assert_int_eq(command.exit_status, 2);
    test_command_free(&command);
    g_free(results);
    g_free(output);
    g_free(home);
}
END_TEST

/* A folder of the name of a case with a file of somebody's, and a bundle of the case. */
START_TEST(an_export_replaces_bundles_of_the_case_alone)
{
    static const struct {
        const char *name, *text;
        int status;
    } table[] = {
        {"problem.md", "mine", 2},
        {"problem.json", "{\"format\": 1, \"case\": \"E1\"}", 2},
        {"problem.json", "{\"format\": 2, \"case\": \"E3\"}", 2},
        {"problem.json", "{\"format\": 1, \"case\": \"E3\"}", 0},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *folder = test_folder_create(), *home = test_folder_path(folder, "E3");
        ck_assert_int_eq(g_mkdir(home, 0700), 0);
        char *path = test_folder_write(home, table[i].name, table[i].text);
        struct test_command command =
            test_command_run("mpm-verify", "export", "--case", "E3", "--output", folder, NULL);
        char *text = test_file_read(path);
        ck_assert_msg(command.exit_status == table[i].status, "row %zu: %s", i, command.errors);
        ck_assert(table[i].status == 0 || strcmp(text, table[i].text) == 0);
        ck_assert(table[i].status == 0 ||
                  strstr(command.errors, "E3: is there and no bundle of case E3") != NULL);
        test_command_free(&command);
        g_free(text);
        g_free(path);
        g_free(home);
        test_folder_remove(folder);
    }
}
END_TEST

START_TEST(an_export_of_several_cases_is_of_each)
{
    static const char *const ways[][3] = {
        {"--case=E3", "--case", "R1"}, {"--case=E3,R1", "--catalogue", "verification/catalogue"}};
    for (size_t i = 0; i < G_N_ELEMENTS(ways); i++) {
        char *folder = test_folder_create();
        struct test_command command = test_command_run("mpm-verify", "export", "--output", folder,
                                                       ways[i][0], ways[i][1], ways[i][2], NULL);
        ck_assert_msg(command.exit_status == 0, "%s", command.errors);
        ck_assert_msg(strstr(command.output, "\n2 exported, 0 not exportable\n") != NULL, "%s",
                      command.output);
        test_command_free(&command);
        test_folder_remove(folder);
    }
}
END_TEST

/* Snapshots of `mpm run` carry their units. */
static const struct {
    const char *scene, *end, *unit, *bundle, *message;
} OTHER_UNITS[] = {
    {"verification/catalogue/E/E3/scene.yaml", "time.end=4", "units.mass=kg", "E3",
     "stress: stress_xx is in \"kg mm^-1 ms^-2\": allowed is"},
    {"verification/catalogue/H/H2/cylinder.yaml", "time.end=0.1", "units.temperature=F", "H2",
     "temperature: temperature is in \"F\": allowed is \"K\""},
};

START_TEST(snapshots_in_other_units_are_refused)
{
    char *folder = test_folder_create(), *results = test_folder_path(folder, "mpm"),
         *home = test_folder_path(test_bundles, OTHER_UNITS[_i].bundle);
    char *output = test_folder_path(folder, "units");
    struct test_command command = test_command_run("mpm", "run", OTHER_UNITS[_i].scene, "--quiet",
                                                   "--set", OTHER_UNITS[_i].end, "--set",
                                                   OTHER_UNITS[_i].unit, "--output", results, NULL);
    ck_assert_msg(command.exit_status == 0, "%s", command.errors);
    test_command_free(&command);
    command = test_command_run("mpm-verify", "score", home, results, "--output", output, NULL);
    ck_assert_int_eq(command.exit_status, 2);
    ck_assert_msg(strstr(command.errors, OTHER_UNITS[_i].message) != NULL, "%s", command.errors);
    test_command_free(&command);
    g_free(output);
    g_free(home);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

/* Temperatures of snapshots, per radian and of a slab, which the cylinder's field is not. */
START_TEST(snapshots_with_temperatures_are_scored)
{
    static const char *const geometries[] = {"geometry=axisymmetric", "geometry=plane_strain"};
    char *folder = test_folder_create(), *home = test_folder_path(test_bundles, "H2");
    for (int k = 0; k < 2; k++) {
        char *results = test_folder_path(folder, geometries[k]);
        char *output = test_folder_path(folder, "score");
        struct test_command command =
            test_command_run("mpm", "run", "verification/catalogue/H/H2/cylinder.yaml", "--quiet",
                             "--set", geometries[k], "--set", "grid.refine=4", "--set",
                             "output.snapshots=0.05", "--output", results, NULL);
        ck_assert_msg(command.exit_status == 0, "%s", command.errors);
        test_command_free(&command);
        command = test_command_run("mpm-verify", "score", home, results, "--output", output, NULL);
        ck_assert_msg(command.exit_status == k, "%s: %s", geometries[k], command.output);
        test_command_free(&command);
        g_free(output);
        g_free(results);
    }
    g_free(home);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_score(void)
{
    Suite *suite = suite_create("score");
    TCase *scores = tcase_create("scores");
    tcase_add_unchecked_fixture(scores, test_bundles_export, test_bundles_remove);
    tcase_add_loop_test(scores, a_perfect_answer_scores_100_percent, 0, EXPORTED);
    tcase_add_loop_test(scores, each_quantity_that_is_spoiled_turns_red, 0, EXPORTED);
    tcase_add_test(scores, results_of_the_wrong_time_are_an_error_of_their_own);
    tcase_add_test(scores, a_bundle_that_was_changed_is_refused_with_the_reason);
    tcase_add_test(scores, the_command_says_and_reports_what_the_score_is);
    tcase_add_test(scores, bad_results_end_with_status_2_and_touch_nothing);
    tcase_add_test(scores, too_few_points_are_refused);
    tcase_add_test(scores, an_export_replaces_bundles_of_the_case_alone);
    tcase_add_test(scores, an_export_of_several_cases_is_of_each);
    tcase_add_loop_test(scores, snapshots_in_other_units_are_refused, 0, G_N_ELEMENTS(OTHER_UNITS));
    tcase_add_test(scores, snapshots_with_temperatures_are_scored);
    suite_add_tcase(suite, scores);
    return suite;
}
