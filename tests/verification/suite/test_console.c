/* What a run prints: a line for each case with the time to go, or one for each check.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"
#include "verification/cases/catalogue.h"
#include "verification/suite/console_cases.h"

#include <glib.h>
#include <string.h>

static struct {
    char *catalogue, *output;
} folders;

static void set_up(void)
{
    folders.catalogue = test_folder_create();
    folders.output = test_folder_create();
    test_case_write_quadrature(folders.catalogue);
    char *text = test_case_text("B", "fail");
    test_case_write(folders.catalogue, "B", text);
    g_free(text);
}

static void tear_down(void)
{
    test_folder_remove(folders.output);
    test_folder_remove(folders.catalogue);
}

/* The lines of a text that begin with some words. */
static size_t lines_with(const char *text, const char *start)
{
    char **lines = g_strsplit(text, "\n", -1);
    size_t count = 0;
    for (char **line = lines; *line != NULL; line++)
        count += g_str_has_prefix(*line, start) ? 1 : 0;
    g_strfreev(lines);
    return count;
}

START_TEST(a_run_prints_a_line_for_each_case_and_failures_whole)
{
    struct test_said said = test_verify_with("mpm-verify run --jobs 1 --catalogue @ --output @",
                                             folders.catalogue, folders.output);
    ck_assert_int_eq(said.exit_status, 1);
    ck_assert_msg(lines_with(said.out, "pass   Q        2 checks") == 1, "%s", said.out);
    ck_assert_uint_eq(lines_with(said.out, "fail   B        1 check "), 1);
    ck_assert_ptr_nonnull(strstr(said.out, "; 1 failed\n"));
    ck_assert_ptr_null(strstr(said.out, "Q/exact"));
    ck_assert_uint_eq(lines_with(said.out, "fail             B/value [only]"), 1); /* as it comes */
    ck_assert_uint_eq(lines_with(said.out, "fail: B/value [only]: value"), 1);     /* at the end */
    ck_assert_uint_eq(lines_with(said.out, "status "), 0);
    ck_assert_str_eq(test_last_line(said.out), "2 passed, 1 failed, 0 skipped");
    test_said_free(&said);
}
END_TEST

START_TEST(a_verbose_run_prints_a_line_for_each_check)
{
    static const char *const forms[] = {"mpm-verify run -v --catalogue @ --output @",
                                        "mpm-verify run --verbose --catalogue @ --output @"};
    for (size_t i = 0; i < G_N_ELEMENTS(forms); i++) {
        struct test_said said = test_verify_with(forms[i], folders.catalogue, folders.output);
        ck_assert_uint_eq(lines_with(said.out, "status           check"), 1);
        ck_assert_msg(lines_with(said.out, "pass             Q/exact [cubic]") == 1, "%s",
                      said.out);
        ck_assert_uint_eq(lines_with(said.out, "expected-fail    Q/short [ninth]"), 1);
        ck_assert_uint_eq(lines_with(said.out, "pass   Q"), 0);
        ck_assert_str_eq(test_last_line(said.out), "2 passed, 1 failed, 0 skipped");
        test_said_free(&said);
    }
}
END_TEST

/* Q has two programs of the size ci, B one. */
static void check_text(const struct console_cases *cases, const char *expected)
{
    char *text = console_cases_text(cases);
    ck_assert_str_eq(text, expected);
    g_free(text);
}

START_TEST(the_time_to_go_follows_from_what_programs_took_before)
{
    enum { TEN_SECONDS = 10000000 };
    const struct plan_selection selection = {.tier = TIER_CI, .case_globs = "Q"};
    struct catalogue *catalogue;
    struct mpm_error error;
    struct plan plan;
    ck_assert_int_eq(catalogue_read(folders.catalogue, test_programs(), &catalogue, &error),
                     MPM_OK);
    ck_assert_int_eq(plan_make(catalogue, &selection, &plan, &error), MPM_OK);
    ck_assert_uint_eq(plan.job_count, 2);
    json_t *measured =
        json_pack("[{ss ss ss sf}]", "case", "Q", "variant", plan.jobs[0].variant->name, "quantity",
                  "cpu_seconds", "value", 2.0);
    json_t *other = json_pack("{ss ss ss sf}", "case", "Q", "variant", plan.jobs[1].variant->name,
                              "quantity", "cpu_seconds", "value", 6.0);
    struct console_cases *cases = console_cases_make(&plan);
    check_text(cases, "0 of 1 cases"); /* nothing is known */
    cases->start -= TEN_SECONDS;
    ck_assert_ptr_null(console_cases_finish(cases, 0, 1.0));
    check_text(cases, "0 of 1 cases, 0:10 to go"); /* one of two alike */
    console_cases_free(cases);
    ck_assert_int_eq(json_array_append_new(measured, other), 0);
    cases = console_cases_make(&plan);
    console_cases_expect(cases, &plan, measured);
    cases->start -= TEN_SECONDS;
    ck_assert_ptr_null(console_cases_finish(cases, 0, 1.0));
    check_text(cases, "0 of 1 cases, 0:30 to go"); /* 2 of 8 in ten seconds */
    struct console_case *row = console_cases_finish(cases, 1, 2.5);
    ck_assert_ptr_nonnull(row);
    ck_assert_double_eq(row->seconds, 3.5);
    check_text(cases, "1 of 1 cases");
    console_cases_free(cases);
    json_decref(measured);
    plan_clear(&plan);
    catalogue_free(catalogue);
}
END_TEST

Suite *suite_console(void)
{
    Suite *suite = suite_create("console");
    TCase *console = tcase_create("console");
    tcase_add_checked_fixture(console, set_up, tear_down);
    tcase_add_test(console, a_run_prints_a_line_for_each_case_and_failures_whole);
    tcase_add_test(console, a_verbose_run_prints_a_line_for_each_check);
    tcase_add_test(console, the_time_to_go_follows_from_what_programs_took_before);
    suite_add_tcase(suite, console);
    return suite;
}
