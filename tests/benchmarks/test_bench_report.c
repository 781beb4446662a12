/* The report of mpm-bench from a few lines written by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/verify.h"

#include "benchmarks/report/report.h"

#include <glib.h>
#include <string.h>

/* --------------------------------------------------------------- the lines */

#define RUN                                                                                        \
    "{\"kind\":\"run\",\"format\":1,\"tier\":\"quick\",\"command\":\"mpm-bench run\","             \
    "\"version\":\"9.8.7\",\"revision\":\"abcdef012345\",\"compiler\":\"somecc 1.2\","             \
    "\"flags\":\"-O3 -DX=<1&2>\",\"libraries\":\"none\",\"processor\":\"<script>Fast | one\","     \
    "\"cores\":2,\"memory_bytes\":8e9,\"simd\":\"AVX2\",\"rounds\":5}\n"

#define RESULT(group, point, settings, quantity, median, low, high)                                \
    "{\"kind\":\"result\",\"group\":\"" group "\",\"point\":\"" point "\",\"settings\":{" settings \
    "},\"quantity\":\"" quantity "\",\"unit\":\"1/s\",\"median\":" median ",\"low\":" low          \
    ",\"high\":" high ",\"rounds\":[" low "," median "," high "]}\n"

#define VALUE(group, point, settings, quantity, value)                                             \
    "{\"kind\":\"value\",\"group\":\"" group "\",\"point\":\"" point "\",\"settings\":{" settings  \
    "},\"quantity\":\"" quantity "\",\"unit\":\"1\",\"value\":" value "}\n"

#define COMPARISON(group, point, against, ratio, low, high, verdict)                               \
    "{\"kind\":\"comparison\",\"group\":\"" group "\",\"point\":\"" point                          \
    "\",\"against\":\"" against "\",\"quantity\":\"particle_steps_per_second\",\"ratio\":" ratio   \
    ",\"low\":" low ",\"high\":" high ",\"verdict\":\"" verdict "\"}\n"

#define RATE "particle_steps_per_second"
#define UGIMP(geometry)                                                                            \
    "\"geometry\":\"" geometry "\",\"shape\":\"ugimp\",\"stress_update\":\"musl\","                \
    "\"particles\":1e6,\"kernels\":\"fast\",\"simd\":\"x86-64-v3\""

static const char run_line[] = RUN;

static const char limit_lines[] = RESULT("limit", "plane_strain ugimp musl, 10^6",
                                         UGIMP("plane_strain"), RATE, "2.5e7", "2.4e7", "2.6e7")
    VALUE("limit", "plane_strain ugimp musl, 10^6", UGIMP("plane_strain"), "bytes_per_particle",
          "239.25") RESULT("limit", "plane_strain ugimp musl, 10^6", UGIMP("plane_strain"),
                           "particle_steps_per_gflop", "500000", "490000", "510000")
        RESULT("limit", "multiply-add, one core", "", "arithmetic", "50", "49", "51");

static const char throughput_lines[] = RESULT("throughput", "plane_strain ugimp musl",
                                              UGIMP("plane_strain"), RATE, "2e7", "1.9e7", "2.1e7");

static const char overhead_lines[] = RESULT("overhead", "plain", "", RATE, "2e7", "1.9e7", "2.1e7")
    RESULT("overhead", "<b>ring</b>", "", RATE, "1.9e7", "1.8e7", "2.1e7")
        RESULT("overhead", "USAVG", "", RATE, "1e7", "9e6", "1.1e7")
            COMPARISON("overhead", "<b>ring</b>", "plain", "0.9777", "0.93", "1.02", "not resolved")
                COMPARISON("overhead", "USAVG", "plain", "0.5", "0.4", "0.625", "slower")
                    VALUE("overhead", "USAVG", "", "instructions_ratio", "1.4567");

static const char scaling_lines[] = RESULT(
    "scaling", "block, 1 thread", "\"threads\":1,\"particles\":1e5", RATE, "2e7", "1.9e7", "2.1e7")
    RESULT("scaling", "block, 2 threads", "\"threads\":2,\"threads_used\":2,\"particles\":1e5",
           RATE, "3.8e7", "3.7e7", "3.9e7")
        COMPARISON("scaling", "block, 2 threads", "block, 1 thread", "1.9", "1.85", "1.95",
                   "faster")
            RESULT("scaling", "block, 2 runs of 1 thread",
                   "\"threads\":1,\"runs\":2,\"particles\":1e5", RATE, "3.9e7", "3.8e7", "4e7")
                COMPARISON("scaling", "block, 2 runs of 1 thread", "block, 1 thread", "1.93", "1.9",
                           "1.97", "faster")
                    RESULT("scaling", "block, 8 threads",
                           "\"threads\":8,\"threads_used\":3,\"particles\":1e5", RATE, "4e7",
                           "3.9e7", "4.1e7");

#define CPDI(cells, outcome)                                                                       \
    "\"problem\":\"bar\",\"shape\":\"cpdi\",\"stress_update\":\"usl\",\"cells\":" cells            \
    ",\"outcome\":\"" outcome "\""
#define CLASSIC                                                                                    \
    "\"problem\":\"bar\",\"shape\":\"classic\",\"stress_update\":\"usf\",\"cells\":8,"             \
    "\"outcome\":\"failed\""
/* A name that must reach neither gnuplot nor a path. */
#define ODD                                                                                        \
    "\"problem\":\"../o'; exit status 1; '\",\"shape\":\"ugimp\",\"stress_update\":\"usl\","       \
    "\"cells\":8"

/* Error 1/cost from 1 to 1/16: 10 % costs 10 s, 1 % is not reached. */
static const char accuracy_lines[] =
    VALUE("accuracy", "a", CPDI("8", "done"), "error_displacement", "1")
        RESULT("accuracy", "a", CPDI("8", "done"), "cpu_seconds", "1", "0.5", "2")
            VALUE("accuracy", "b", CPDI("16", "done"), "error_displacement", "0.0625")
                RESULT("accuracy", "b", CPDI("16", "done"), "cpu_seconds", "16", "8", "32")
                    VALUE("accuracy", "c", CLASSIC, "error_displacement", "null")
                        VALUE("accuracy", "d", ODD, "error_odd", "0.5")
                            RESULT("accuracy", "d", ODD, "cpu_seconds", "1", "0.5", "2");

static char *write_folder(const char *const *parts)
{
    char *folder = test_folder_create(), *text = g_strjoinv("", (char **)(uintptr_t)parts);
    g_free(test_folder_write(folder, "bench.jsonl", text));
    g_free(text);
    return folder;
}

static char *whole(void)
{
    const char *const parts[] = {
        run_line,       limit_lines, throughput_lines, overhead_lines, scaling_lines,
        accuracy_lines, NULL};
    return write_folder(parts);
}

static void assert_holds(const char *text, const char *part)
{
    ck_assert_msg(strstr(text, part) != NULL, "no \"%s\" in %.200s", part, text);
}

static void render(const char *folder)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(bench_report_write(folder, &error) == MPM_OK, "%s", error.message);
}

/* ------------------------------------------------------------------ the tests */

START_TEST(every_section_and_fact_stands_on_the_page_and_in_the_summary)
{
    static const char *const parts[] = {"One core",
                                        "Throughput",
                                        "Machine limit",
                                        "Error against run time",
                                        "Overhead of features",
                                        "Scaling",
                                        "somecc 1.2",
                                        "abcdef012345",
                                        "AVX2",
                                        "x86-64-v3",
                                        "fast",
                                        "25.0",
                                        "24.0 .. 26.0",
                                        "500",
                                        "239",
                                        "not reached",
                                        "10.0",
                                        "5.00 .. 20.0",
                                        "1 failed",
                                        "1.46",
                                        "2.00 slower",
                                        "1.60 .. 2.50",
                                        "1.90 faster"};
    char *folder = whole();
    render(folder);
    char *page = test_folder_read(folder, "index.html");
    char *summary = test_folder_read(folder, "summary.md");
    for (size_t i = 0; i < G_N_ELEMENTS(parts); i++) {
        assert_holds(page, parts[i]);
        assert_holds(summary, parts[i]);
    }
    test_assert_well_formed(page, "index.html");
    g_free(page);
    g_free(summary);
    test_folder_remove(folder);
}
END_TEST

START_TEST(what_is_not_resolved_is_not_printed_as_a_difference)
{
    char *folder = whole();
    render(folder);
    char *page = test_folder_read(folder, "index.html");
    assert_holds(page, ">not resolved<");
    assert_holds(page, "0.980 .. 1.08"); /* of the times: 1 / 1.02, 1 / 0.93 */
    ck_assert_ptr_null(strstr(page, "1.02 not"));
    ck_assert_ptr_null(strstr(page, ">1.02")); /* 1 / 0.9777 */
    ck_assert_ptr_null(strstr(page, "0.978"));
    g_free(page);
    test_folder_remove(folder);
}
END_TEST

START_TEST(texts_of_the_lines_are_escaped)
{
    char *folder = whole();
    render(folder);
    char *page = test_folder_read(folder, "index.html");
    char *summary = test_folder_read(folder, "summary.md");
    ck_assert_ptr_null(strstr(page, "<script>Fast"));
    ck_assert_ptr_null(strstr(page, "<b>"));
    assert_holds(page, "&lt;script&gt;Fast | one");
    assert_holds(page, "&lt;b&gt;ring&lt;/b&gt;");
    assert_holds(page, "-DX=&lt;1&amp;2&gt;");
    ck_assert_ptr_null(strstr(summary, "<script"));
    assert_holds(summary, "&lt;script\\>Fast \\| one");
    g_free(page);
    g_free(summary);
    test_folder_remove(folder);
}
END_TEST

START_TEST(figures_are_drawn_and_the_same_lines_give_the_same_bytes)
{
    static const char *const files[] = {"index.html",
                                        "summary.md",
                                        "figures/accuracy_1.svg",
                                        "figures/accuracy_2.svg",
                                        "figures/throughput.svg",
                                        "figures/threads.svg"};
    char *folder = whole(), *before[G_N_ELEMENTS(files)];
    render(folder);
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++)
        before[i] = test_folder_read(folder, files[i]);
    render(folder);
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++) {
        char *after = test_folder_read(folder, files[i]);
        ck_assert_msg(strcmp(before[i], after) == 0, "%s", files[i]);
        if (!g_str_has_suffix(files[i], ".md"))
            test_assert_well_formed(after, files[i]);
        g_free(after);
        g_free(before[i]);
    }
    test_folder_remove(folder);
}
END_TEST

/* In words beside the threads, and not as a point of their curve. */
START_TEST(threads_are_held_against_runs_side_by_side)
{
    char *folder = whole();
    render(folder);
    char *page = test_folder_read(folder, "index.html");
    char *data = test_folder_read(folder, "figures/threads.dat");
    assert_holds(page, " particles: 2 threads of one run come to 1.9 (1.85 .. 1.95) times one "
                       "thread; 2 separate runs of one thread each, side by side, to 1.93 (1.9 .. "
                       "1.97) times one alone.");
    assert_holds(page, "block, 8 threads: there is work for 3 of the 8 threads");
    ck_assert_msg(g_str_has_suffix(data, "\"\n1 20 19 21\n2 38 37 39\n8 40 39 41\n"), "%s", data);
    g_free(page);
    g_free(data);
    test_folder_remove(folder);
}
END_TEST

START_TEST(missing_groups_are_left_out_with_a_sentence)
{
    const char *const parts[] = {run_line, overhead_lines, NULL};
    static const char *const groups[] = {"limit", "throughput", "accuracy", "scaling"};
    char *folder = write_folder(parts);
    render(folder);
    char *page = test_folder_read(folder, "index.html");
    for (size_t i = 0; i < G_N_ELEMENTS(groups); i++) {
        char *sentence = g_strdup_printf("did not select the group %s.", groups[i]);
        assert_holds(page, sentence);
        g_free(sentence);
    }
    ck_assert_ptr_null(strstr(page, "the group overhead"));
    ck_assert_ptr_null(strstr(page, "<img"));
    test_assert_well_formed(page, "index.html");
    g_free(page);
    test_folder_remove(folder);
}
END_TEST

START_TEST(lines_that_are_none_are_refused_with_file_and_line_and_nothing_is_written)
{
    static const struct {
        const char *text, *message;
    } table[] = {
        {"", "is empty"},
        {"{\"kind\":\"result\"}\n", "bench.jsonl:1: "},
        {RUN "{\"kind\":\"value\",\"group\":\"pays\",\"poi", "bench.jsonl:2: "},
        {RUN "\n{\"kind\":\"check\",\"case\":\"R1\"}\n", "bench.jsonl:3: "},
        {RUN "not json\n", "bench.jsonl:2: "},
        {"{\"kind\":\"run\",\"format\":2}\n", "bench.jsonl:1: "},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const char *const parts[] = {table[i].text, NULL};
        char *folder = write_folder(parts), *page = test_folder_path(folder, "index.html");
        struct mpm_error error = {.status = MPM_OK};
        ck_assert_int_eq(bench_report_write(folder, &error), MPM_BAD_INPUT);
        assert_holds(error.message, table[i].message);
        ck_assert(!test_file_exists(page));
        g_free(page);
        test_folder_remove(folder);
    }
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(bench_report_write("/no/such/folder", &error), MPM_BAD_INPUT);
}
END_TEST

START_TEST(a_figure_that_cannot_be_drawn_is_told_and_the_rest_is_written)
{
    char *folder = whole();
    struct mpm_error error = {.status = MPM_OK};
    char *path = g_strdup(g_getenv("PATH"));
    g_setenv("PATH", folder, TRUE); /* no gnuplot there */
    const enum mpm_status status = bench_report_write(folder, &error);
    g_setenv("PATH", path, TRUE);
    g_free(path);
    ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
    assert_holds(error.message, "gnuplot cannot be run");
    char *page = test_folder_read(folder, "index.html");
    assert_holds(page, "could not be drawn");
    assert_holds(page, "2.00 slower");
    g_free(page);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_bench_report(void)
{
    Suite *suite = suite_create("bench_report");
    TCase *tests = tcase_create("bench_report");
    tcase_add_test(tests, every_section_and_fact_stands_on_the_page_and_in_the_summary);
    tcase_add_test(tests, what_is_not_resolved_is_not_printed_as_a_difference);
    tcase_add_test(tests, texts_of_the_lines_are_escaped);
    tcase_add_test(tests, figures_are_drawn_and_the_same_lines_give_the_same_bytes);
    tcase_add_test(tests, threads_are_held_against_runs_side_by_side);
    tcase_add_test(tests, missing_groups_are_left_out_with_a_sentence);
    tcase_add_test(tests,
                   lines_that_are_none_are_refused_with_file_and_line_and_nothing_is_written);
    tcase_add_test(tests, a_figure_that_cannot_be_drawn_is_told_and_the_rest_is_written);
    suite_add_tcase(suite, tests);
    return suite;
}
