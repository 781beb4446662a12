/* The report's page of decisions, from result lines made by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "support/folder.h"
#include "support/verify.h"

#include <glib.h>
#include <string.h>

/* Two cases about impacts, and one about nothing. */
static const char run_line[] =
    "{\"kind\":\"run\",\"format\":1,\"version\":\"1\",\"revision\":\"r\",\"tier\":\"ci\",\"cases\":"
    "["
    "{\"family\":\"T\",\"case\":\"A\",\"title\":\"a\",\"tags\":[\"impact\"],\"comparison\":{"
    "\"title\":\"Which <one>\",\"columns\":[{\"quantity\":\"q\",\"title\":\"Q\",\"unit\":\"1\","
    "\"better\":\"low\"}],\"parts\":[{\"part\":\"ugimp\",\"kind\":\"shape\"},{\"part\":\"cpdi\","
    "\"kind\":\"shape\"},{\"part\":\"usl\",\"kind\":\"order\"}]},\"variants\":["
    "{\"variant\":\"ugimp_usl\",\"seconds\":1},{\"variant\":\"cpdi_usl\",\"seconds\":3},"
    "{\"variant\":\"fine_cpdi_usl\",\"seconds\":50}]},"
    "{\"family\":\"T\",\"case\":\"B\",\"title\":\"b\",\"tags\":[\"impact\"],\"variants\":[]},"
    "{\"family\":\"T\",\"case\":\"C\",\"title\":\"c\",\"tags\":[],\"variants\":[]}]}\n";

static void add_check(GString *lines, const char *name, const char *variant, const char *status)
{
    g_string_append_printf(
        lines,
        "{\"kind\":\"check\",\"family\":\"T\",\"case\":\"%s\",\"check\":\"x\","
        "\"variant\":\"%s\",\"quantity\":\"q\",\"unit\":\"%%\",\"title\":\"drift "
        "<of> energy\",\"value\":7,\"low\":1,\"high\":9,\"status\":\"%s\"}\n",
        name, variant, status);
}

static void add_value(GString *lines, const char *check, const char *variant, const char *value)
{
    g_string_append_printf(
        lines,
        "{\"kind\":\"check\",\"family\":\"T\",\"case\":\"A\",\"check\":\"%s\",\"variant\":\"%s\","
        "\"quantity\":\"q\",\"unit\":\"%%\",\"title\":\"%s\",\"value\":%s,\"low\":1,"
        "\"high\":9,\"status\":\"expected-fail\"}\n",
        check, variant, check, value);
}

static void expect(const char *folder, const char *name, const char *text)
{
    char *all = test_folder_read(folder, name);
    ck_assert_msg(strstr(all, text) != NULL, "%s: no %s in\n%.4000s", name, text, all);
    g_free(all);
}

START_TEST(methods_come_by_what_they_hold_with_cost_cases_and_what_falls_short)
{
    char *folder = test_folder_create();
    GString *lines = g_string_new(run_line);
    add_check(lines, "A", "ugimp_usl", "expected-fail");
    add_check(lines, "A", "cpdi_usl", "pass");
    add_check(lines, "A", "fine_cpdi_usl", "pass");
    add_check(lines, "B", "ugimp_usl", "pass");
    add_check(lines, "B", "cpdi_usl", "skip");
    add_check(lines, "B", "none_of_them", "fail");
    add_check(lines, "C", "cpdi_usl", "expected-fail");
    g_free(test_folder_write(folder, "checks.jsonl", lines->str));
    struct test_said said = test_verify_with("mpm-verify report @", folder, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    /* 2 of 2 checks; 3 times: the setting that only it ran does not count */
    expect(folder, "table-decision-impact.csv",
           "\"cpdi_usl\",1,3,\"0\",\"1\"\r\n\"ugimp_usl\",0.5,1,");
    expect(folder, "table-decision-impact.csv", "\"1\",\"2\"\r\n");
    expect(folder, "decision.html", "<strong>cpdi_usl</strong> holds 2 of 2 checks in 1 case of 2");
    expect(folder, "decision.html",
           "drift &lt;of&gt; energy, 7 % <span class=\"about\">(good: 1 .. 9 %)");
    expect(folder, "decision.html", "comparison.html\">A</a> <strong>Which &lt;one&gt;.</strong>");
    expect(folder, "decision.html", "This run has no case of it");
    expect(folder, "index.html", "href=\"decision.html\"");
    char *page = test_folder_read(folder, "decision.html");
    ck_assert_ptr_null(strstr(page, "cases/C/"));
    test_assert_well_formed(page, "decision.html");
    g_free(page);
    test_said_free(&said);
    g_string_free(lines, TRUE);
    test_folder_remove(folder);
}
END_TEST

START_TEST(values_of_variants_have_four_digits_and_one_number_where_these_are_the_same)
{
    char *folder = test_folder_create();
    GString *lines = g_string_new(run_line);
    add_value(lines, "alike", "ugimp_usl", "2.5347834102");
    add_value(lines, "alike", "fine_ugimp_usl", "2.5347834637");
    add_value(lines, "apart", "ugimp_usl", "2.5347834102");
    add_value(lines, "apart", "fine_ugimp_usl", "2.8");
    g_free(test_folder_write(folder, "checks.jsonl", lines->str));
    struct test_said said = test_verify_with("mpm-verify report @", folder, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    expect(folder, "decision.html", "alike, 2.535 % <span");
    expect(folder, "decision.html", "apart, 2.535 .. 2.8 % <span");
    test_said_free(&said);
    g_string_free(lines, TRUE);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_decision(void)
{
    Suite *suite = suite_create("decision");
    TCase *pages = tcase_create("pages");
    tcase_add_test(pages, methods_come_by_what_they_hold_with_cost_cases_and_what_falls_short);
    tcase_add_test(pages,
                   values_of_variants_have_four_digits_and_one_number_where_these_are_the_same);
    suite_add_tcase(suite, pages);
    return suite;
}
