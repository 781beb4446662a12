/* The page of a comparison and mpm-verify compare, from runs of a small catalogue.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/cases/catalogue.h"
#include "verification/measures/comparison/run_change.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const char COMPARISON[] =
    "comparison:\n"
    "  title: Powers <compared>\n"
    "  columns:\n"
    "    - {quantity: integral, title: Integral & more, unit: \"%\", better: high, tolerance: "
    "1e-6}\n"
    "    - {quantity: particle_steps, title: Points, unit: \"1\", better: low}\n"
    "    - {quantity: value, title: Elsewhere, unit: \"1\", better: zero, case: crash}\n"
    "  pareto: {x: particle_steps, y: integral}\n";

/* Case Q with a comparison whose text is changed, and case crash; g_free with the folder. */
static char *catalogue_with(const char *from, const char *to)
{
    char *folder = test_folder_create();
    test_case_write_quadrature(folder);
    char *text = test_folder_read(folder, "T/Q/case.yaml");
    char **parts = g_strsplit(COMPARISON, from, 2);
    char *comparison = g_strjoinv(to, parts);
    char *whole = g_strconcat(text, comparison, NULL);
    g_free(test_folder_write(folder, "T/Q/case.yaml", whole));
    char *crash = test_case_text("crash", "crash");
    test_case_write(folder, "crash", crash);
    g_free(crash);
    g_free(whole);
    g_free(comparison);
    g_strfreev(parts);
    g_free(text);
    return folder;
}

START_TEST(the_page_has_a_row_for_each_variant_and_the_csv_its_numbers)
{
    static const char *const parts[] = {"Q: Powers &lt;compared&gt;",
                                        "Integral &amp; more",
                                        "id=\"cubic\"",
                                        "id=\"ninth\"",
                                        "class=\"sortable\"",
                                        "aria-sort=\"ascending\"",
                                        "href=\"comparison.csv\"",
                                        "was not part of this run",
                                        "; from case crash</span>", /* which has no page here */
                                        "not measured",
                                        "valid run: Points (1000)",
                                        "Use cubic. Integral &amp; more: 1 %, the best of the 2",
                                        "Where each one loses",
                                        "data-first=\"descending\""};
    char *catalogue = catalogue_with("compared>", "compared>"), *output = test_folder_create();
    struct test_said said =
        test_verify_with("mpm-verify run --case Q --catalogue @ --output @", catalogue, output);
    ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
    char *page = test_folder_read(output, "cases/Q/comparison.html"),
         *csv = test_folder_read(output, "cases/Q/comparison.csv"),
         *index = test_folder_read(output, "index.html");
    for (size_t i = 0; i < G_N_ELEMENTS(parts); i++)
        ck_assert_msg(strstr(page, parts[i]) != NULL, "%s", parts[i]);
    test_assert_well_formed(page, "comparison.html");
    ck_assert_ptr_nonnull(strstr(index, "cases/Q/comparison.html"));
    ck_assert(g_str_has_prefix(csv, "\"variant\",\"run\",\"Integral & more (%)\",\"Points (1)\""));
    ck_assert_ptr_nonnull(strstr(csv, ",1000,,\"Elsewhere: case crash"));
    char *picture = test_folder_path(output, "cases/Q/figure-comparison.svg");
    ck_assert(test_file_exists(picture));
    g_free(picture);
    g_free(index);
    g_free(csv);
    g_free(page);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

/* `text` in a file of the folder becomes `other`. */
static void rewrite(const char *folder, const char *file, const char *text, const char *other)
{
    char *whole = test_folder_read(folder, file);
    char **parts = g_strsplit(whole, text, 2);
    ck_assert_msg(g_strv_length(parts) == 2, "%s is not in %s", text, file);
    char *changed = g_strjoinv(other, parts);
    g_free(test_folder_write(folder, file, changed));
    g_free(changed);
    g_strfreev(parts);
    g_free(whole);
}

static void assert_says(const char *page, const char *const *parts, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ck_assert_msg(strstr(page, parts[i]) != NULL, "%s is missing", parts[i]);
}

START_TEST(a_page_says_what_its_case_declares_and_the_front_page_who_counts)
{
    static const char *const on_page[] = {
        "fell to 0.99",
        "beyond the limit",
        "Use cubic. Integral &amp; more: 1 %, the best of the 1 run",
        "1 of 2 runs does not count",
        "A run counts with: Integral &amp; more at least 1 %",
        "<li>Mind the &lt;gap&gt;.</li>",
        "The problem.</strong> Powers of x.",
        "src=\"figure-curve.svg\"",
        "Of x^n.",
        "<span class=\"about\">A &lt;cube&gt;</span>",
        "<dt>Does not count</dt><dd>ninth: fell to 0.99"};
    static const char *const in_front[] = {"Every variant on every problem", "★ best",
                                           "✗ fell to 0.99", "Use cubic. Integral"};
    char *catalogue = catalogue_with(
             "better: high, tolerance: 1e-6}",
             "better: high, tolerance: 1e-6, limit: 0.9999, beyond: fell to, about: Of x^n.}"),
         *output = test_folder_create();
    rewrite(catalogue, "T/Q/case.yaml", "  columns:",
            "  main: integral\n  cost: particle_steps\n  setup: Powers of x.\n  figure: curve\n"
            "  notes: [Mind the <gap>.]\n  columns:");
    rewrite(catalogue, "T/Q/case.yaml", "{name: cubic,", "{name: cubic, title: A <cube>,");
    struct test_said said =
        test_verify_with("mpm-verify run --case Q --catalogue @ --output @", catalogue, output);
    char *page = test_folder_read(output, "cases/Q/comparison.html"),
         *front = test_folder_read(output, "index.html");
    assert_says(page, on_page, G_N_ELEMENTS(on_page));
    assert_says(front, in_front, G_N_ELEMENTS(in_front));
    test_assert_well_formed(page, "comparison.html");
    test_assert_well_formed(front, "index.html");
    g_free(front);
    g_free(page);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(the_cost_of_a_row_that_fell_behind_does_not_count)
{
    char *catalogue = catalogue_with("title: Points,", "title: Points, where: integral,");
    char *output = test_folder_create();
    struct test_said said =
        test_verify_with("mpm-verify run --case Q --catalogue @ --output @", catalogue, output);
    char *page = test_folder_read(output, "cases/Q/comparison.html");
    ck_assert_msg(strstr(page, "No number for Points: it fell behind in Integral &amp; more.") !=
                      NULL,
                  "%s%s", said.err, page);
    ck_assert_ptr_nonnull(strstr(page, "<dd>cubic (1000)</dd>"));
    g_free(page);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_crash_is_a_missing_number_with_its_reason_and_never_a_zero)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    char *text = test_case_text("crash", "crash");
    char *whole = g_strconcat(text,
                              "comparison:\n  title: t\n  columns:\n    - {quantity: value, title: "
                              "Value, unit: m, better: low}\n",
                              NULL);
    test_case_write(catalogue, "crash", whole);
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 1);
    char *page = test_folder_read(output, "cases/crash/comparison.html"),
         *csv = test_folder_read(output, "cases/crash/comparison.csv");
    ck_assert_msg(strstr(page, "No number for Value: the run crashed: about to &lt;crash&gt; &amp; "
                               "burn.") != NULL,
                  "%s", page);
    ck_assert_ptr_nonnull(strstr(page, "no number in this run"));
    ck_assert_ptr_nonnull(strstr(csv, "\r\n\"only\",\"crashed\",,\"Value: the run crashed"));
    g_free(csv);
    g_free(page);
    test_said_free(&said);
    g_free(whole);
    g_free(text);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(result_lines_alone_give_the_same_page_without_the_picture)
{
    char *catalogue = catalogue_with("compared>", "compared>"), *output = test_folder_create(),
         *alone = test_folder_create();
    struct test_said said =
        test_verify_with("mpm-verify run --case Q --catalogue @ --output @", catalogue, output);
    test_said_free(&said);
    static const char *const files[] = {"checks.jsonl", "measurements.jsonl"};
    char *expected = test_folder_read(output, "cases/Q/comparison.csv");
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++) {
        char *lines = test_folder_read(output, files[i]);
        g_free(test_folder_write(alone, files[i], lines));
        g_free(lines);
        said = test_verify_with("mpm-verify report @", alone, NULL);
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        test_said_free(&said);
        char *csv = test_folder_read(alone, "cases/Q/comparison.csv");
        ck_assert_int_eq(strcmp(csv, expected) == 0, i == 1);
        if (i == 0)
            ck_assert_ptr_nonnull(strstr(csv, "this folder holds no measurements.jsonl"));
        g_free(csv);
    }
    g_free(expected);
    test_folder_remove(alone);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_bad_comparison_is_refused_with_its_line)
{
    const struct {
        const char *from, *to, *message;
    } table[] = {
        {"x: particle_steps", "x: nothing", "comparison.pareto: \"nothing\" is the quantity of no"},
        {"x: particle_steps", "x: integral", "x and y are the same quantity"},
        {"title: Points", "title: Integral & more",
         "comparison.columns.1: title \"Integral & more\" is taken by another column"},
        {"tolerance: 1e-6", "tolerance: -1", "tolerance and floor: allowed are numbers >= 0"},
        {"tolerance: 1e-6", "tolerance: much", "not a number, got \"much\""},
        {"case: crash", "case: none",
         "comparison.columns.2: case \"none\": the catalogue has none of that name"},
        {"better: high", "better: high, where: none",
         "comparison.columns.0: where: \"none\" is the quantity of no other column"},
        {"tolerance: 1e-6", "limit: much", "not a number, got \"much\""},
        {"tolerance: 1e-6", "beyond: fell to", "beyond: \"fell to\" belongs to a limit"},
        {"  columns:", "  main: none\n  columns:", "main: \"none\" is the quantity of no column"},
        {"  columns:", "  cost: none\n  columns:", "cost: \"none\" is the quantity of no column"},
        {"  columns:", "  figure: none\n  columns:", "figure: \"none\" is no figure of the case"},
        {"better: high", "better: more", "comparison.columns.0.better: unknown choice"},
        {"  columns:", "  variants: [\"x*\"]\n  columns:", "\"x*\" matches no variant"},
        {"  title: Powers <compared>\n", "", "comparison.title: missing, the key is required"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *folder = catalogue_with(table[i].from, table[i].to);
        struct catalogue *catalogue;
        struct mpm_error error = {.message = "accepted"};
        ck_assert_int_eq(catalogue_read(folder, test_programs(), &catalogue, &error),
                         MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, table[i].message) != NULL, "row %zu: %s", i,
                      error.message);
        test_folder_remove(folder);
    }
}
END_TEST

/* -------------------------------------------------------------------- compare */

/* A folder with the lines of one check and one unjudged quantity. */
static char *run_with(const char *revision, const char *status, const char *value,
                      const char *margin, const char *free_value, const char *seconds)
{
    char *folder = test_folder_create();
    char *checks = g_strdup_printf(
        "{\"kind\":\"run\",\"version\":\"1\",\"revision\":\"%s\",\"tier\":\"ci\",\"cases\":[]}\n"
        "{\"family\":\"T\",\"case\":\"A\",\"check\":\"c\",\"variant\":\"v\",\"quantity\":\"q\","
        "\"unit\":\"m\",\"status\":\"%s\",\"value\":%s,\"margin\":%s,\"reason\":\"\"}\n",
        revision, status, value, margin);
    char *lines = g_strdup_printf(
        "{\"kind\":\"run\"}\n"
        "{\"family\":\"T\",\"case\":\"A\",\"variant\":\"v\",\"quantity\":\"free\",\"unit\":\"\","
        "\"value\":%s,\"reason\":\"\"}\n"
        "{\"family\":\"T\",\"case\":\"A\",\"variant\":\"v\",\"quantity\":\"cpu_seconds\",\"unit\":"
        "\"s\",\"value\":%s,\"reason\":\"\"}\n",
        free_value, seconds);
    g_free(test_folder_write(folder, "checks.jsonl", checks));
    g_free(test_folder_write(folder, "measurements.jsonl", lines));
    g_free(lines);
    g_free(checks);
    return folder;
}

static char *run_before(void)
{
    return run_with("one", "pass", "1", "0.5", "7", "1");
}

START_TEST(compare_tells_what_changed_and_whether_anything_got_worse)
{
    const struct {
        const char *status, *value, *margin, *free_value, *seconds;
        int exit_status;
        const char *said;
    } table[] = {
        {"pass", "1", "0.5", "7", "1", 0, "0 worse, 0 better, 0 changed otherwise"},
        {"fail", "3", "-1", "7", "1", 1, "pass, then fail"},
        {"expected-fail", "1", "0.5", "7", "1", 1, "pass, then expected-fail"},
        {"pass", "1.1", "0.45", "7", "1", 0, "1 m, then 1.1 m (+10 %); margin 0.5, then 0.45"},
        {"pass", "1.0005", "0.5", "7", "1", 0, "0 worse, 0 better, 0 changed otherwise"},
        {"pass", "1.2", "0.3", "7", "1", 1, "worse    A/c [v]"},
        {"pass", "0.8", "0.7", "7", "1", 0, "better   A/c [v]"},
        {"pass", "null", "null", "7", "1", 0, "1 m, then none"},
        {"pass", "null", "null", "7", "1", 0, "  after    no check has a margin\n"},
        {"pass", "1", "0.5", "8", "1", 0, "A/free [v]"},
        {"pass", "1", "0.5", "7", "9", 0, "slower   A [v]"},
        {"pass", "1", "0.5", "7", "1.5", 0, "\n\n0 worse, 0 better, 0 changed otherwise\n"},
    };
    char *before = run_before();
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *after = run_with("two", table[i].status, table[i].value, table[i].margin,
                               table[i].free_value, table[i].seconds);
        struct test_said said = test_verify_with("mpm-verify compare @ @", before, after);
        ck_assert_msg(said.exit_status == table[i].exit_status, "row %zu: %d %s%s", i,
                      said.exit_status, said.out, said.err);
        ck_assert_msg(strstr(said.out, table[i].said) != NULL, "row %zu: %s", i, said.out);
        ck_assert_ptr_nonnull(strstr(said.out, "one, then two"));
        ck_assert_ptr_null(strstr(said.out, "  none\n")); /* no section is empty */
        test_said_free(&said);
        test_folder_remove(after);
    }
    test_folder_remove(before);
}
END_TEST

START_TEST(a_check_that_vanished_is_worse_unless_another_selection_was_run)
{
    static const struct {
        const char *tier;
        int exit_status;
        const char *said;
    } table[] = {{"ci", 1, "gone: was pass"}, {"full", 0, "which selected otherwise"}};
    char *before = run_before();
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *after = test_folder_create();
        char *run = g_strdup_printf("{\"kind\":\"run\",\"version\":\"1\",\"revision\":\"r\","
                                    "\"tier\":\"%s\",\"cases\":[]}\n",
                                    table[i].tier);
        g_free(test_folder_write(after, "checks.jsonl", run));
        struct test_said said = test_verify_with("mpm-verify compare @ @", before, after);
        ck_assert_msg(said.exit_status == table[i].exit_status, "%s", said.out);
        ck_assert_msg(strstr(said.out, table[i].said) != NULL, "%s", said.out);
        test_said_free(&said);
        said = test_verify_with("mpm-verify compare @ @", after, before);
        ck_assert_int_eq(said.exit_status, 0);
        ck_assert_ptr_nonnull(strstr(said.out, "new: pass"));
        test_said_free(&said);
        g_free(run);
        test_folder_remove(after);
    }
    test_folder_remove(before);
}
END_TEST

START_TEST(compare_refuses_what_is_no_run)
{
    const struct {
        const char *line, *message;
    } table[] = {
        {"mpm-verify compare @", "DIR is missing"},
        {"mpm-verify compare @ @/none", "none/checks.jsonl: cannot be read"},
        {"mpm-verify compare @/none @", "none/checks.jsonl: cannot be read"},
        {"mpm-verify compare @ @ --change much", "--change \"much\": allowed is a number"},
        {"mpm-verify compare @ @ --change -1", "--change \"-1\": allowed is a number"},
        {"mpm-verify compare @ @ --tier ci", "compare: unknown option --tier"},
        {"mpm-verify report @ --change 1", "report: unknown option --change"},
    };
    char *folder = run_before();
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct test_said said = test_verify_with(table[i].line, folder, folder);
        ck_assert_msg(said.exit_status == 2, "%s: %d", table[i].line, said.exit_status);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "%s: %s", table[i].line,
                      said.err);
        test_said_free(&said);
    }
    test_folder_remove(folder);
}
END_TEST

START_TEST(noise_is_the_spread_of_the_ratios_about_their_median)
{
    /* a machine twice as slow, within some per cent; one program five times */
    const double before[] = {1, 2, 3, 4, 5, 6, 7}, after[] = {2, 4.1, 6, 7.9, 10, 60, 14.2};
    double work[7];
    const struct run_noise noise = run_change_noise(before, after, 7, work);
    ck_assert_double_eq_tol(noise.middle, 2.0, 0.05);
    ck_assert_double_eq(noise.factor, 1.5);
    for (size_t i = 0; i < 7; i++)
        ck_assert_int_eq(run_change_time(&noise, before[i], after[i]),
                         i == 5 ? RUN_WORSE : RUN_SAME);
    const struct run_noise few = run_change_noise(before, after, 4, work);
    ck_assert_double_eq(few.middle, 1);
    ck_assert_double_eq(few.factor, 2);
    ck_assert(isinf(run_change_relative(1, (double)NAN)));
    ck_assert_double_eq(run_change_relative((double)NAN, (double)NAN), 0);
    ck_assert_double_eq(run_change_relative(-1, 1), 2);
}
END_TEST

Suite *suite_comparison_page(void)
{
    Suite *suite = suite_create("comparison_page");
    TCase *page = tcase_create("page");
    tcase_add_test(page, the_page_has_a_row_for_each_variant_and_the_csv_its_numbers);
    tcase_add_test(page, a_page_says_what_its_case_declares_and_the_front_page_who_counts);
    tcase_add_test(page, the_cost_of_a_row_that_fell_behind_does_not_count);
    tcase_add_test(page, a_crash_is_a_missing_number_with_its_reason_and_never_a_zero);
    tcase_add_test(page, result_lines_alone_give_the_same_page_without_the_picture);
    tcase_add_test(page, a_bad_comparison_is_refused_with_its_line);
    suite_add_tcase(suite, page);
    TCase *compare = tcase_create("compare");
    tcase_add_test(compare, compare_tells_what_changed_and_whether_anything_got_worse);
    tcase_add_test(compare, a_check_that_vanished_is_worse_unless_another_selection_was_run);
    tcase_add_test(compare, compare_refuses_what_is_no_run);
    tcase_add_test(compare, noise_is_the_spread_of_the_ratios_about_their_median);
    suite_add_tcase(suite, compare);
    return suite;
}
