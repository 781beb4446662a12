/* Tables of studies, from records written here: which levels an order is of, what errors are
 * counted from, where there is no order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"

#include "verification/study/study_write.h"

#include <jansson.h>
#include <math.h>
#include <string.h>

static const double ROUND = 1e-12;

/* Cells of 4, 2, 1, 0.5 for levels 1, 2, 4, 8. */
static const char scene[] = "title: numbers\ntime: {end: 4}\ngrid: {cell: [4, 4]}\n";

struct made {
    char *folder;
    struct study *study;
    struct records records;
    struct study_results results;
};

/* What a run leaves behind; NaN: it failed. */
static void add_records(struct records *records, const char *run, double value)
{
    const bool done = isfinite(value);
    json_array_append_new(records->checks,
                          json_pack("{s:s,s:s,s:s,s:f}", "case", run, "status",
                                    done ? "pass" : "error", "reason",
                                    done ? "" : "a particle left the grid", "seconds", 0.5));
    json_array_append_new(records->measurements, json_pack("{s:s,s:s,s:f}", "case", run, "quantity",
                                                           "cpu_seconds", "value", 0.25));
    if (done)
        json_array_append_new(
            records->measurements,
            json_pack("{s:s,s:s,s:f}", "case", run, "quantity", "measure_1", "value", value));
}

/* A study of one measure whose runs have these values; `within`: two ends of an interval. */
static struct made make(const char *refine, char *measure, char *vary, char *const within[2],
                        const double *values)
{
    struct made made = {.folder = test_folder_create()};
    char *path = test_folder_path(made.folder, "scene.yaml");
    char *measures[] = {measure, NULL}, *varied[] = {vary, NULL};
    const struct study_arguments given = {
        .refine = refine, .measures = measures, .vary = vary == NULL ? NULL : varied};
    struct mpm_error error = {.message = ""};
    GArray *runs;
    ck_assert(g_file_set_contents(path, scene, -1, NULL));
    made.study = study_of_scene(path);
    ck_assert_int_eq(study_take_arguments(made.study, &given, &error), MPM_OK);
    made.study->measures[0].unit = g_strdup("1");
    for (int i = 0; within != NULL && i < 2; i++)
        made.study->measures[0].order_text[i] = g_strdup(within[i]);
    ck_assert_msg(study_complete(made.study, &error) == MPM_OK, "%s", error.message);
    ck_assert_int_eq(study_runs(made.study, &runs, &error), MPM_OK);
    made.records = (struct records){json_object(), json_array(), json_array()};
    for (unsigned i = 0; i < runs->len; i++)
        add_records(&made.records, g_array_index(runs, struct study_run, i).name, values[i]);
    g_array_unref(runs);
    ck_assert_int_eq(study_results_make(made.study, &made.records, &made.results, &error), MPM_OK);
    g_free(path);
    return made;
}

static void unmake(struct made *made)
{
    study_results_clear(&made->results);
    records_clear(&made->records);
    study_free(made->study);
    test_folder_remove(made->folder);
}

static double error_at(const struct made *made, unsigned run)
{
    return made->results.rows[run].values[0].error;
}

/* ------------------------------------------------------------------------ orders */

/* 1 + h^2 on the last three levels, and far from it on the first */
static const double bent[] = {30, 5, 2, 1.25};

START_TEST(without_a_reference_order_limit_and_index_are_of_the_last_three_levels)
{
    struct made made = make("1,2,4,8", (char[]){"kinetic_energy"}, NULL, NULL, bent);
    const struct study_order *order = &made.results.orders[0];
    ck_assert_double_eq_tol(order->order, 2.0, ROUND);
    ck_assert_double_eq_tol(order->limit, 1.0, ROUND);
    ck_assert_double_eq_tol(order->index, 1.25 * 0.25 / 1.25, ROUND);
    ck_assert_double_eq_tol(order->half_width, log2(25.0 / 3.0) - 2.0, ROUND);
    ck_assert_double_eq_tol(error_at(&made, 0), 29.0, ROUND);
    ck_assert_double_eq_tol(error_at(&made, 3), 0.25, ROUND);
    unmake(&made);
}
END_TEST

START_TEST(against_the_finest_level_errors_are_differences_from_its_number)
{
    struct made made = make("1,2,4,8", (char[]){"kinetic_energy=finest"}, NULL, NULL, bent);
    ck_assert_double_eq_tol(error_at(&made, 0), 28.75, ROUND);
    ck_assert_double_eq_tol(error_at(&made, 2), 0.75, ROUND);
    ck_assert_double_nan(error_at(&made, 3));
    ck_assert_double_eq_tol(made.results.rows[2].values[0].order, log2(3.75 / 0.75), ROUND);
    ck_assert_double_eq_tol(made.results.orders[0].order, 2.0, ROUND);
    unmake(&made);
}
END_TEST

START_TEST(against_a_number_the_order_is_fitted_to_the_errors_of_all_levels)
{
    struct made made = make("1,2,4,8", (char[]){"kinetic_energy=1"}, NULL, NULL,
                            (const double[]){17, -3, 2, 1.25}); /* a sign does not count */
    ck_assert_double_eq_tol(made.results.orders[0].order, 2.0, ROUND);
    ck_assert_uint_eq(made.results.orders[0].levels, 4);
    ck_assert_double_nan(made.results.orders[0].limit);
    unmake(&made);
}
END_TEST

START_TEST(each_variant_has_an_order_of_its_own_levels)
{
    struct made made = make("1,2,4", (char[]){"kinetic_energy=1"}, (char[]){"time.courant=0.2,0.4"},
                            NULL, (const double[]){5, 3, 2, 17, 5, 2});
    ck_assert_uint_eq(made.results.groups, 2);
    ck_assert_double_eq_tol(made.results.orders[0].order, 1.0, ROUND);
    ck_assert_double_eq_tol(made.results.orders[1].order, 2.0, ROUND);
    unmake(&made);
}
END_TEST

/* ---------------------------------------------------------------------- no order */

static const struct {
    const char *refine, *measure, *reason;
    double values[4];
} none[] = {
    {"1", "kinetic_energy", "fewer than three levels", {1}},
    {"1", "kinetic_energy=0", "fewer than two levels", {1}},
    {"1,2", "kinetic_energy=finest", "fewer than three levels", {2, 1}},
    {"1,2,4", "kinetic_energy", "do not fall with one sign", {1, 1, 1}},
    {"1,2,4", "kinetic_energy", "do not fall with one sign", {2, 1, 1}},
    {"1,2,4", "kinetic_energy", "do not fall with one sign", {0, 0, 0}},
    {"1,2,4", "kinetic_energy", "do not fall with one sign", {1, 2, 1.5}},
    {"1,2,4", "kinetic_energy=finest", "do not fall with one sign", {1, 2, 4}},
    {"1,2,3", "kinetic_energy", "have not one ratio", {3, 2, 1.5}},
    {"1,2,4", "kinetic_energy=1", "an error is zero", {3, 1, 2}},
};

START_TEST(a_series_without_an_order_has_the_reason_and_no_number)
{
    char *measure = g_strdup(none[_i].measure);
    char *const within[] = {(char[]){"0"}, (char[]){"9"}};
    struct made made = make(none[_i].refine, measure, NULL, within, none[_i].values);
    char *markdown = study_markdown(&made.results, false), *csv = study_csv(&made.results);
    char *lines = study_jsonl(&made.results, made.records.run);
    char *text = g_strconcat(markdown, csv, lines, NULL);
    ck_assert_double_nan(made.results.orders[0].order);
    ck_assert_msg(strstr(made.results.orders[0].reason, none[_i].reason) != NULL, "%s",
                  made.results.orders[0].reason);
    ck_assert_ptr_nonnull(strstr(markdown, "- the scene: no observed order: "));
    ck_assert_ptr_null(strstr(markdown, "grid-convergence index"));
    ck_assert_ptr_null(strstr(text, "nan"));
    ck_assert_ptr_null(strstr(text, "inf"));
    ck_assert_uint_eq(made.results.out_of_order, 1);
    g_free(text);
    g_free(lines);
    g_free(csv);
    g_free(markdown);
    g_free(measure);
    unmake(&made);
}
END_TEST

START_TEST(a_limit_of_zero_at_the_finest_level_has_no_index)
{
    struct made made = make("1,2,4", (char[]){"kinetic_energy"}, NULL, NULL,
                            (const double[]){3, 1, 0}); /* towards -1 */
    char *markdown = study_markdown(&made.results, false);
    ck_assert_double_eq_tol(made.results.orders[0].limit, -1.0, ROUND);
    ck_assert_ptr_nonnull(strstr(markdown, "; limit -1\n"));
    g_free(markdown);
    unmake(&made);
}
END_TEST

/* -------------------------------------------------------------------------- runs */

START_TEST(a_failed_run_is_a_row_and_no_level)
{
    struct made made = make("1,2,4,8", (char[]){"kinetic_energy=1"}, NULL, NULL,
                            (const double[]){17, 5, (double)NAN, 1.25});
    char *markdown = study_markdown(&made.results, false), *csv = study_csv(&made.results);
    ck_assert_int_eq(made.results.rows[2].state, STUDY_FAILED);
    ck_assert_uint_eq(made.results.failed, 1);
    ck_assert_uint_eq(made.results.orders[0].levels, 3);
    ck_assert_double_eq_tol(made.results.orders[0].order, 2.0, ROUND);
    ck_assert(g_regex_match_simple("\\| 4 +\\| 1 +\\| failed +\\|", markdown, 0, 0));
    ck_assert_ptr_nonnull(strstr(markdown, "- r4 failed: a particle left the grid\n"));
    ck_assert(g_regex_match_simple("^r4,.*,failed,.*\"a particle left the grid\"$", csv,
                                   G_REGEX_MULTILINE, 0));
    g_free(csv);
    g_free(markdown);
    unmake(&made);
}
END_TEST

START_TEST(runs_have_names_of_their_own_whatever_the_values_are)
{
    struct made made = make("1,2", (char[]){"kinetic_energy"}, (char[]){"method.shape=v3,a b,a_b"},
                            NULL, (const double[]){1, 2, 3, 4, 5, 6});
    ck_assert_ptr_nonnull(made.results.rows);
    for (unsigned i = 0; i < 6; i++) {
        ck_assert_double_eq(made.results.rows[i].values[0].value, i + 1.0);
        for (unsigned k = 0; k < i; k++)
            ck_assert_str_ne(made.results.rows[i].run->name, made.results.rows[k].run->name);
    }
    unmake(&made);
}
END_TEST

Suite *suite_study_results(void)
{
    Suite *suite = suite_create("study_results");
    TCase *tests = tcase_create("study_results");
    tcase_add_test(tests, without_a_reference_order_limit_and_index_are_of_the_last_three_levels);
    tcase_add_test(tests, against_the_finest_level_errors_are_differences_from_its_number);
    tcase_add_test(tests, against_a_number_the_order_is_fitted_to_the_errors_of_all_levels);
    tcase_add_test(tests, each_variant_has_an_order_of_its_own_levels);
    tcase_add_loop_test(tests, a_series_without_an_order_has_the_reason_and_no_number, 0,
                        G_N_ELEMENTS(none));
    tcase_add_test(tests, a_limit_of_zero_at_the_finest_level_has_no_index);
    tcase_add_test(tests, a_failed_run_is_a_row_and_no_level);
    tcase_add_test(tests, runs_have_names_of_their_own_whatever_the_values_are);
    suite_add_tcase(suite, tests);
    return suite;
}
