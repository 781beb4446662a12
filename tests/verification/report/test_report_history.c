/* The report's pages of history and of decisions, from folders of earlier runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "mpm_file.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include <glib.h>
#include <string.h>

static struct {
    char *catalogue, *old, *now;
} folders;

static void run_into(const char *output)
{
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", folders.catalogue, output);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    test_said_free(&said);
}

static void set_up(void)
{
    folders.catalogue = test_folder_create();
    folders.old = test_folder_create();
    folders.now = test_folder_create();
    test_case_write_quadrature(folders.catalogue);
    run_into(folders.old);
    run_into(folders.now);
}

static void tear_down(void)
{
    test_folder_remove(folders.catalogue);
    test_folder_remove(folders.old);
    test_folder_remove(folders.now);
}

static void expect(const char *name, const char *text)
{
    char *all = test_folder_read(folders.now, name);
    ck_assert_msg(strstr(all, text) != NULL, "%s: no %s in\n%s", name, text, all);
    g_free(all);
}

/* The old run with the value of check short [ninth] and its revision changed. */
static void spoil_old_run(void)
{
    char *text = test_folder_read(folders.old, "checks.jsonl");
    char *at = strstr(strstr(text, "\"check\":\"short\""), "\"value\":0.9");
    ck_assert_ptr_nonnull(at);
    at[strlen("\"value\":0.")] = '8';
    at = strstr(text, "\"revision\":\"");
    at[strlen("\"revision\":\"")] = '~';
    g_free(test_folder_write(folders.old, "checks.jsonl", text));
    g_free(text);
}

static const char bench_lines[] =
    "{\"kind\":\"run\",\"format\":1,\"revision\":\"abc\",\"version\":\"1\"}\n"
    "{\"kind\":\"result\",\"group\":\"throughput\",\"point\":\"disk\",\"settings\":{},"
    "\"quantity\":\"rate\",\"unit\":\"1/s\",\"median\":%s,\"low\":1,\"high\":9,\"rounds\":[5]}\n";

/* A folder with benchmarks alone; g_free. */
static char *bench_folder(const char *name, const char *median)
{
    char *home = g_build_filename(folders.catalogue, name, NULL);
    char **parts = g_strsplit(bench_lines, "%s", 2);
    char *text = g_strjoinv(median, parts), *file = g_strconcat(name, "/bench.jsonl", NULL);
    ck_assert_int_eq(mpm_folder_make(home), 0);
    g_free(test_folder_write(folders.catalogue, file, text));
    g_free(file);
    g_free(text);
    g_strfreev(parts);
    return home;
}

static void expect_report(const char *line, int exit_status, const char *words)
{
    struct test_said said = test_verify(line);
    ck_assert_msg(said.exit_status == exit_status, "%d: %s", said.exit_status, said.err);
    ck_assert_msg(words == NULL || strstr(said.err, words) != NULL, "%s", said.err);
    test_said_free(&said);
}

START_TEST(a_value_and_a_benchmark_that_step_are_marked_and_stay_in_the_folder)
{
    spoil_old_run();
    char *first = bench_folder("first", "5"), *second = bench_folder("second", "7");
    char *line =
        g_strdup_printf("mpm-verify report %s --history %s --history %s --history %s --history %s",
                        folders.now, folders.old, folders.old, first, second);
    char *again = g_strdup_printf("mpm-verify report %s", folders.now);
    for (int round = 0; round < 2; round++) {
        expect_report(round == 0 ? line : again, 0, NULL);
        expect("table-history-steps.csv", "\"Q/short [ninth]\"");
        expect("table-history-steps.csv", "\"throughput/disk: rate (1/s)\",\"abc\",5,7,");
        expect("table-history-runs.csv", "\"~");
        expect("history.html", "aria-label=\"5 runs, 1 step\"");
        expect("table-history-runs.csv", "3,\"abc\",\"\",\"\",,,1,"); /* no checks: none failed */
        expect("history.html", ">no checks</td>");
        expect("index.html", "href=\"history.html\"");
        char *page = test_folder_read(folders.now, "history.html");
        test_assert_well_formed(page, "history.html");
        g_free(page);
    }
    g_free(again);
    g_free(line);
    g_free(second);
    g_free(first);
}
END_TEST

START_TEST(runs_that_are_the_same_have_no_step)
{
    char *line = g_strdup_printf("mpm-verify report %s --history %s", folders.now, folders.old);
    expect_report(line, 0, NULL);
    expect("history.html", "No value and no benchmark steps");
    char *page = test_folder_read(folders.now, "history.html");
    ck_assert_msg(strstr(page, "<caption>Every step") == NULL &&
                      strstr(page, "id=\"benchmarks\"") == NULL,
                  "a table without rows: %s", page);
    g_free(page);
    g_free(line);
}
END_TEST

START_TEST(folders_that_are_no_results_are_refused_and_nothing_is_stored)
{
    static const char *const spoiled[][2] = {
        {"", "bench.jsonl: is empty"},
        {"{\"kind\":\"run\"}\n", "revision: allowed is a text"},
        {"{\"kind\":\"result\",\"revision\":\"a\"}\n", "kind: allowed is run"},
        {"{\"kind\":\"run\",\"revision\":\"a\"}\n{\"kind\":\"x\",\"group\":\"g\",\"point\":\"p\"}"
         "\n",
         "bench.jsonl:2: is no record of a benchmark: kind: allowed is"},
    };
    char *home = g_build_filename(folders.catalogue, "bad", NULL);
    char *line = g_strdup_printf("mpm-verify report %s --history %s", folders.now, home);
    ck_assert_int_eq(mpm_folder_make(home), 0);
    expect_report(line, 2, "has neither checks.jsonl nor bench.jsonl");
    for (size_t i = 0; i < G_N_ELEMENTS(spoiled); i++) {
        g_free(test_folder_write(folders.catalogue, "bad/bench.jsonl", spoiled[i][0]));
        expect_report(line, 2, spoiled[i][1]);
    }
    char *stored = g_build_filename(folders.now, "history.json", NULL);
    ck_assert(!mpm_path_exists(stored));
    g_free(stored);
    g_free(line);
    g_free(home);
}
END_TEST

START_TEST(a_history_that_is_not_as_described_is_refused)
{
    static const char *const spoiled[][2] = {
        {"{\"format\":2,\"runs\":[],\"benchmarks\":{}}", "format: allowed is 1"},
        {"{\"format\":1,\"runs\":[{\"revision\":\"a\",\"values\":{\"k\":\"x\"},\"failed\":0,"
         "\"benchmarks\":{}}],\"benchmarks\":{}}",
         "values"},
        {"{\"format\":1,\"runs\":[{\"revision\":\"a\\u0007\",\"values\":{},\"failed\":0,"
         "\"benchmarks\":{}}],\"benchmarks\":{}}",
         "cannot be shown"},
    };
    char *line = g_strdup_printf("mpm-verify report %s", folders.now);
    for (size_t i = 0; i < G_N_ELEMENTS(spoiled); i++) {
        g_free(test_folder_write(folders.now, "history.json", spoiled[i][0]));
        expect_report(line, 2, spoiled[i][1]);
    }
    g_free(line);
}
END_TEST

Suite *suite_report_history(void)
{
    Suite *suite = suite_create("report_history");
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, set_up, tear_down);
    tcase_set_timeout(runs, 60);
    tcase_add_test(runs, a_value_and_a_benchmark_that_step_are_marked_and_stay_in_the_folder);
    tcase_add_test(runs, runs_that_are_the_same_have_no_step);
    tcase_add_test(runs, folders_that_are_no_results_are_refused_and_nothing_is_stored);
    tcase_add_test(runs, a_history_that_is_not_as_described_is_refused);
    suite_add_tcase(suite, runs);
    return suite;
}
