/* The report's pages beside those of cases: tables as HTML and CSV, headroom, what is stored in the
 * folder, coverage by declared evidence, limits, mutants.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/records/headroom_table.h"
#include "verification/report/report_stored.h"
#include "verification/report/report_table.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* ---------------------------------------------------------------------- tables */

START_TEST(a_table_has_the_same_cells_as_html_and_as_csv)
{
    static const struct report_column columns[] = {
        {"Name", NULL, CELLS_TEXT, false},
        {"Length", "mm", CELLS_NUMBER, true},
        {"Status", NULL, CELLS_TEXT, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    report_table_name(table, "a_\"b\" < c");
    report_table_number(table, 0.1, g_strdup("0.1"));
    report_table_status(table, VERDICT_PASS);
    report_table_link(table, "x.html", "second");
    report_table_number(table, (double)NAN, g_strdup("none"));
    report_table_status(table, VERDICT_FAIL);
    ck_assert_uint_eq(report_table_rows(table), 2);

    char *csv = report_table_csv(table);
    ck_assert_str_eq(csv, "\"Name\",\"Length (mm)\",\"Status\"\r\n"
                          "\"a_\"\"b\"\" < c\",0.10000000000000001,\"pass\"\r\n"
                          "\"second\",,\"fail\"\r\n");
    g_free(csv);
    report_table_link(table, "x.html", "another");
    report_table_number(table, 1, g_strdup("1"));
    report_table_status(table, VERDICT_PASS);
    report_table_sort(table);
    csv = report_table_csv(table);
    ck_assert_ptr_nonnull(strstr(csv, "\"pass\"\r\n\"another\",1,\"pass\"\r\n\"second\","));

    GString *html = g_string_new(NULL);
    report_table_html(table, "caption", "x.csv", html);
    char *whole = g_strdup_printf("<div>%s</div>", html->str);
    test_assert_well_formed(whole, "table");
    ck_assert_ptr_nonnull(strstr(whole, "class=\"n\" data-first=\"descending\">Length"));
    ck_assert_ptr_nonnull(strstr(whole, "data-key=\"0.10000000000000001\">0.1<"));
    ck_assert_ptr_nonnull(strstr(whole, "data-key=\"\">none<")); /* sorts last */
    ck_assert_ptr_nonnull(strstr(whole, "<a href=\"x.csv\">"));
    g_free(whole);
    g_string_free(html, TRUE);
    g_free(csv);
    report_table_free(table);
}
END_TEST

/* -------------------------------------------------------------------- headroom */

START_TEST(headroom_is_the_room_on_the_side_of_the_value_over_its_deviation)
{
    const struct verdict_band band = {.expected = 2, .low = 1, .high = 6};
    const struct {
        double value, headroom;
        enum headroom judged;
    } table[] = {
        {3, 4, HEADROOM_FINE},                 /* 4 above, deviates by 1 */
        {1.5, 2, HEADROOM_FINE},               /* 1 below, deviates by 0.5 */
        {1, 1, HEADROOM_FLAKY},                /* on the end */
        {0, 0.5, HEADROOM_FLAKY},              /* outside */
        {2.015625, 256, HEADROOM_SLACK},       /* 4 / 2^-6 */
        {2, (double)INFINITY, HEADROOM_EXACT}, /* the expected value */
        {(double)NAN, (double)NAN, HEADROOM_UNKNOWN},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const double headroom = headroom_of(&band, table[i].value);
        ck_assert_msg(isnan(table[i].headroom) ? isnan(headroom) : headroom == table[i].headroom,
                      "%g: %g", table[i].value, headroom);
        ck_assert_int_eq(headroom_judge(headroom), table[i].judged);
    }
    ck_assert_double_eq(headroom_spread(&band, 2, 3), 0.4); /* over half of 5 */
    /* decades: by how much the value may grow, unless it is near the lower end */
    const struct verdict_band errors = {.expected = 16, .low = 1, .high = 64};
    ck_assert_double_eq(headroom_of(&errors, 2), 32);
    ck_assert_double_eq(headroom_of(&errors, 60), 64.0 / 60);
    ck_assert_double_eq(headroom_of(&errors, 1.25), 1.25);
    ck_assert_double_eq(headroom_of(&errors, 0.5), 0.5);
    ck_assert_double_eq(headroom_of(&errors, 128), 0.5);
    ck_assert_double_lt(headroom_of(&errors, 0), 1);
    const struct verdict_band negative = {.expected = -16, .low = -64, .high = -1};
    ck_assert_double_eq(headroom_of(&negative, -2), 32);
    /* a weakness: from the middle of its own band, 4.5 */
    const struct verdict_band weakness = {
        .expected = 1, .low = 0, .high = 2, .weakness = true, .fails_low = 3, .fails_high = 6};
    ck_assert_double_eq(headroom_of(&weakness, 5.25), 2);
}
END_TEST

/* Band 1..6 about 2: 3 is fine, 5 flaky, 2.015625 slack, 2 exact. */
static char *check_text(const char *variant, const char *value, const char *reason)
{
    return g_strdup_printf(
        "{\"case\":\"A\",\"check\":\"c\",\"variant\":\"%s\",\"title\":\"t\","
        "\"quantity\":\"q\",\"basis\":\"theory\",\"why\":\"\","
        "\"fails_low\":null,\"fails_high\":null,\"status\":\"pass\",\"expected\":2.0,\"low\":1.0,"
        "\"high\":6.0,\"value\":%s,\"headroom\":\"%s\"}",
        variant, value, reason);
}

/* Of a check with two variants in this run, and of the first of them in another build. */
static struct headroom_table table_of(const char *const *values, const char *reason,
                                      const char *other, json_t **text)
{
    char *one = check_text("v", values[0], reason), *two = check_text("w", values[1], reason);
    char *whole =
        g_strdup_printf("{\"checks\":[%s,%s],\"builds\":[{\"name\":\"old\",\"values\":{%s%s}}]}",
                        one, two, *other == '\0' ? "" : "\"A/c/v\":", other);
    *text = json_loads(whole, 0, NULL);
    ck_assert_ptr_nonnull(*text);
    g_free(one);
    g_free(two);
    g_free(whole);
    return headroom_table_make(json_object_get(*text, "checks"), json_object_get(*text, "builds"));
}

START_TEST(a_check_outside_needs_a_reason_and_no_other_may_have_one)
{
    static const struct {
        const char *values[2], *other, *reason;
        enum headroom_fault fault;
        size_t flaky; /* in the other build */
    } table[] = {
        {{"3.0", "3.0"}, "3.0", "", HEADROOM_SOUND, 0},
        {{"5.0", "3.0"}, "3.0", "", HEADROOM_UNREASONED, 0},
        {{"6.5", "3.0"}, "3.0", "a limit", HEADROOM_OUTSIDE, 0},
        {{"3.0", "3.0"}, "0.5", "a limit", HEADROOM_OUTSIDE, 1},
        {{"3.0", "5.0"}, "3.0", "", HEADROOM_UNREASONED, 0},
        {{"3.0", "3.0"}, "5.0", "", HEADROOM_UNREASONED, 1},
        {{"3.0", "3.0"}, "5.0", "a limit", HEADROOM_SOUND, 1},
        {{"3.0", "3.0"}, "3.0", "a limit", HEADROOM_STALE, 0},
        {{"2.015625", "2.015625"}, "2.015625", "", HEADROOM_UNREASONED, 0},
        {{"2.015625", "2.015625"}, "2.015625", "a count", HEADROOM_SOUND, 0},
        {{"2.015625", "3.0"}, "2.015625", "", HEADROOM_SOUND, 0}, /* the least counts */
        {{"3.0", "3.0"}, "null", "", HEADROOM_MISSING, 0},
        {{"3.0", "null"}, "3.0", "", HEADROOM_MISSING, 0},
        {{"null", "null"}, "null", "", HEADROOM_MISSING, 0},
        {{"3.0", "3.0"}, "", "", HEADROOM_SOUND, 0}, /* not run there */
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        json_t *text;
        struct headroom_table headroom =
            table_of(table[i].values, table[i].reason, table[i].other, &text);
        ck_assert_uint_eq(headroom.checks->len, 1);
        for (int fault = 0; fault < HEADROOM_FAULTS; fault++)
            ck_assert_msg(headroom_table_faults(&headroom, (enum headroom_fault)fault) ==
                              ((enum headroom_fault)fault == table[i].fault),
                          "row %zu: fault %d", i, fault);
        ck_assert_uint_eq(headroom_table_count(&headroom, 1, HEADROOM_FLAKY), table[i].flaky);
        ck_assert_uint_eq(headroom.values[1] + headroom.without[1], *table[i].other != '\0');
        ck_assert_uint_eq(headroom.without[1], strcmp(table[i].other, "null") == 0);
        headroom_table_clear(&headroom);
        json_decref(text);
    }
}
END_TEST

/* --------------------------------------------------------------------- mutants */

START_TEST(mutants_that_are_not_as_described_are_refused)
{
    static const char good[] =
        "{\"name\":\"a\",\"room\":\"r\",\"what\":\"d\",\"patch\":\"\","
        "\"outcome\":\"killed\",\"killed_by\":[\"Q/exact\"],\"equivalent\":\"\"}";
    const struct {
        const char *from, *to, *message;
    } table[] = {
        {"\"room\":\"r\",", "", "mutants.0: room: a text is missing"},
        {"\"killed\"", "\"dead\"", "outcome: \"dead\": allowed are"},
        {"[\"Q/exact\"]", "[]", "killed_by: allowed is"},
        {"[\"Q/exact\"]", "[1]", "killed_by: allowed is"},
        {"\"killed\"", "\"survived\"", "killed_by: allowed is"},
        {"\"outcome\":\"killed\",\"killed_by\":[\"Q/exact\"]",
         "\"outcome\":\"equivalent\",\"killed_by\":[]", "equivalent: the reason is missing"},
    };
    for (size_t i = 0; i <= G_N_ELEMENTS(table); i++) {
        const bool fine = i == G_N_ELEMENTS(table);
        char **parts = g_strsplit(good, fine ? "none of this" : table[i].from, 2);
        char *mutant = g_strjoinv(fine ? "" : table[i].to, parts);
        char *text = g_strdup_printf("{\"mutants\":[%s]}", mutant);
        json_t *object = json_loads(text, 0, NULL);
        struct mpm_error error;
        ck_assert_ptr_nonnull(object);
        ck_assert_int_eq(mutants_check(object, "m.json", &error), fine ? MPM_OK : MPM_BAD_INPUT);
        if (!fine)
            ck_assert_msg(strstr(error.message, table[i].message) != NULL, "%s", error.message);
        json_decref(object);
        g_free(text);
        g_free(mutant);
        g_strfreev(parts);
    }
}
END_TEST

/* ------------------------------------------------------------------------ site */

static const char mutants_file[] =
    "{\"format\":1,\"revision\":\"abc\",\"mutants\":["
    "{\"name\":\"sign\",\"room\":\"method\",\"what\":\"wrong sign\",\"patch\":\"-a\\n+b <c>\","
    "\"outcome\":\"killed\",\"killed_by\":[\"Q/exact\"],\"equivalent\":\"\"},"
    "{\"name\":\"norm\",\"room\":\"measures\",\"what\":\"wrong norm\",\"patch\":\"\","
    "\"outcome\":\"survived\",\"killed_by\":[],\"equivalent\":\"\"}]}";

static struct {
    char *catalogue, *first, *second;
} folders;

static void run_into(const char *output)
{
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", folders.catalogue, output);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    test_said_free(&said);
}

/* Case Q with evidence declared for the case, and another one for a check. */
static void set_up(void)
{
    folders.catalogue = test_folder_create();
    folders.first = test_folder_create();
    folders.second = test_folder_create();
    test_case_write_quadrature(folders.catalogue);
    char *text = test_folder_read(folders.catalogue, "T/Q/case.yaml");
    char **parts = g_strsplit(text, "program: quadrature\n", 2);
    char *tagged = g_strjoinv("tags: [planar]\nevidence: quadrature\nprogram: quadrature\n", parts);
    char **checks = g_strsplit(tagged, "{check: short,", 2);
    char *whole =
        g_strjoinv("{check: short, evidence: invariant, headroom: \"as wide as <it> is\",", checks);
    test_case_write(folders.catalogue, "Q", whole);
    g_free(whole);
    g_strfreev(checks);
    g_free(tagged);
    g_strfreev(parts);
    g_free(text);
    run_into(folders.first);
}

static void tear_down(void)
{
    test_folder_remove(folders.catalogue);
    test_folder_remove(folders.first);
    test_folder_remove(folders.second);
}

/* Fails the test unless the file has the text. */
static void expect(const char *folder, const char *name, const char *text)
{
    char *all = test_folder_read(folder, name);
    ck_assert_msg(strstr(all, text) != NULL, "%s: no %s in\n%s", name, text, all);
    g_free(all);
}

START_TEST(the_coverage_counts_checks_by_the_evidence_that_they_declare)
{
    /* quadrature, exact, manufactured, invariant, cross-variant, reference data, holes */
    expect(folders.first, "table-coverage.csv", "\"planar\",\"geometry\",1,0,0,1,0,0,4\r\n");
    expect(folders.first, "index.html", "<span class=\"hole\">none</span>");
    expect(folders.first, "checks.jsonl", "\"evidence\":\"quadrature\"");
    expect(folders.first, "checks.jsonl", "\"headroom\":\"as wide as <it> is\"");
}
END_TEST

START_TEST(evidence_that_is_none_of_the_kinds_is_refused)
{
    char *text = test_folder_read(folders.catalogue, "T/Q/case.yaml");
    char **parts = g_strsplit(text, "evidence: quadrature", 2);
    char *wrong = g_strjoinv("evidence: hearsay", parts);
    test_case_write(folders.catalogue, "Q", wrong);
    struct test_said said =
        test_verify_with("mpm-verify list --catalogue @", folders.catalogue, NULL);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_msg(strstr(said.err, "case.yaml:7: ") != NULL && strstr(said.err, "hearsay") != NULL,
                  "%s", said.err);
    test_said_free(&said);
    g_free(wrong);
    g_strfreev(parts);
    g_free(text);
}
END_TEST

START_TEST(every_page_is_well_formed_and_limits_hold_the_weaknesses)
{
    static const char *const pages[] = {"index.html",        "limits.html",   "headroom.html",
                                        "mutants.html",      "glossary.html", "checks.html",
                                        "cases/Q/index.html"};
    for (size_t i = 0; i < G_N_ELEMENTS(pages); i++) {
        char *page = test_folder_read(folders.first, pages[i]);
        test_assert_well_formed(page, pages[i]);
        ck_assert_msg(strstr(page, "href=\"mutants.html\"") == NULL,
                      "%s: a link to the page of mutants, of which there are none", pages[i]);
        g_free(page);
    }
    expect(folders.first, "table-weaknesses.csv", "\"Q\",\"ninth\",\"too few points\"");
    expect(folders.first, "mutants.html", "holds no run of mutants");
    expect(folders.first, "table-all-checks.csv", "\"Q/exact\",");
    expect(folders.first, "index.html", "action=\"checks.html\"");
    expect(folders.first, "index.html", "None is stored with this report");
    expect(folders.first, "glossary.html", "id=\"evidence\"");
    expect(folders.first, "cases/Q/index.html", "Revision ");
    expect(folders.first, "cases/Q/index.html", "mpm-verify run --tier ci --case Q --output DIR\n");
    expect(folders.first, "cases/Q/index.html", "<span>Evidence: invariant</span>");
    expect(folders.first, "cases/Q/checks.csv", "\"Q\",\"exact\",\"cubic\"");
    expect(folders.first, "cases/Q/runs.csv", "\"cubic\"");
}
END_TEST

/* Moves a value of the first run by one part in a hundred. */
static void change_a_value(void)
{
    char *text = test_folder_read(folders.first, "checks.jsonl");
    char *at = strstr(text, "\"check\":\"short\"");
    at = strstr(at, "\"value\":0.9");
    ck_assert_ptr_nonnull(at);
    at[strlen("\"value\":0.")] = '8';
    g_free(test_folder_write(folders.first, "checks.jsonl", text));
    g_free(text);
}

START_TEST(what_is_stored_is_shown_again_from_the_folder_alone)
{
    run_into(folders.second);
    change_a_value();
    char *mutants = test_folder_write(folders.catalogue, "mutants.json", mutants_file);
    char *line =
        g_strdup_printf("mpm-verify report %s --baseline %s --headroom old=%s --mutants %s",
                        folders.second, folders.first, folders.first, mutants);
    for (int round = 0; round < 2; round++) {
        struct test_said said = round == 0
                                    ? test_verify(line)
                                    : test_verify_with("mpm-verify report @", folders.second, NULL);
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        test_said_free(&said);
        expect(folders.second, "table-changes.csv", "\"Q/short [ninth]\"");
        expect(folders.second, "index.html", "changed otherwise</strong> since revision");
        expect(folders.second, "table-mutants.csv",
               "\"sign\",\"method\",\"wrong sign\",\"killed\",1,");
        expect(folders.second, "mutants.html", "<strong>50.0 %</strong>");
        expect(folders.second, "index.html", "<a href=\"mutants.html\">Mutants</a>");
        expect(folders.second, "mutants.html", "+b &lt;c&gt;");
        expect(folders.second, "table-killers.csv", "\"Q/exact\",1,1\r\n");
        expect(folders.second, "table-builds.csv", "\"old\"");
        expect(folders.second, "table-headroom.csv", "\"old\""); /* the least is there */
    }
    g_free(line);
    g_free(mutants);
}
END_TEST

/* Runs mpm-verify headroom on the second folder and compares what it prints. */
static void expect_headroom(int exit_status, const char *const *texts)
{
    struct test_said said = test_verify_with("mpm-verify headroom @", folders.second, NULL);
    ck_assert_msg(said.exit_status == exit_status, "%d: %s%s", said.exit_status, said.out,
                  said.err);
    for (; *texts != NULL; texts++)
        ck_assert_msg(strstr(said.out, *texts) != NULL || strstr(said.err, *texts) != NULL,
                      "no %s in\n%s%s", *texts, said.out, said.err);
    test_said_free(&said);
}

/* Replaces every `from` in a file of the second folder. */
static void edit(const char *name, const char *from, const char *to)
{
    char *text = test_folder_read(folders.second, name);
    char **parts = g_strsplit(text, from, -1);
    ck_assert_msg(g_strv_length(parts) > 1, "%s: no %s in\n%s", name, from, text);
    char *whole = g_strjoinv(to, parts);
    g_free(test_folder_write(folders.second, name, whole));
    g_free(whole);
    g_strfreev(parts);
    g_free(text);
}

START_TEST(headroom_without_a_reason_and_values_missing_elsewhere_are_told)
{
    run_into(folders.second);
    struct test_said said =
        test_verify_with("mpm-verify explain Q/short/ninth --catalogue @ --output @",
                         folders.catalogue, folders.second);
    ck_assert_ptr_nonnull(
        strstr(said.out, "\n  evidence   invariant\n  headroom   as wide as <it> is\n"));
    test_said_free(&said);
    expect_headroom(2, (const char *[]){"no headroom.json", NULL});
    char *line =
        g_strdup_printf("mpm-verify report %s --headroom old=%s", folders.second, folders.first);
    said = test_verify(line);
    ck_assert_int_eq(said.exit_status, 0);
    test_said_free(&said);
    g_free(line);
    expect_headroom(1, (const char *[]){"Q/exact [cubic], this run: ", ": no reason written",
                                        "1 passed, 1 failed, 0 skipped", NULL});
    edit("checks.jsonl", "\"headroom\":\"\"", "\"headroom\":\"a fixture\"");
    expect_headroom(0, (const char *[]){"2 passed, 0 failed, 0 skipped", NULL});
    edit("headroom.json", "\"Q/exact/cubic\": ", "\"Q/exact/cubic\": 1.000000000005, \"was\": ");
    expect_headroom(1, (const char *[]){"Q/exact [cubic], old: 2: a reason is written", NULL});
    edit("headroom.json", "\"Q/exact/cubic\": ", "\"Q/exact/cubic\": null, \"is\": ");
    expect_headroom(1,
                    (const char *[]){"Q/exact [cubic], old: no value: no value in a build", NULL});
    said = test_verify_with("mpm-verify report @", folders.second, NULL);
    test_said_free(&said);
    expect(folders.second, "headroom.html", "<p class=\"notice\">1 of 2 checks: no value in a");
    char *page = test_folder_read(folders.second, "headroom.html");
    ck_assert_msg(strstr(page, "notice good") == NULL, "all is well beside what is not");
    g_free(page);
    expect(folders.second, "table-headroom.csv", "no value in a build that ran it");
    expect(folders.second, "table-builds.csv", "\"old\",1,0,1,1,");
}
END_TEST

/* As a file from elsewhere may have it. */
START_TEST(a_comparison_without_columns_is_none)
{
    run_into(folders.second);
    edit("checks.jsonl",
         "\"figures\":", "\"comparison\":{\"title\":\"Nothing\",\"columns\":[]},\"figures\":");
    struct test_said said = test_verify_with("mpm-verify report @", folders.second, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    test_said_free(&said);
    char *front = test_folder_read(folders.second, "index.html");
    ck_assert_ptr_null(strstr(front, "Nothing"));
    g_free(front);
}
END_TEST

START_TEST(additions_that_cannot_be_are_refused)
{
    const struct {
        const char *line, *message;
    } table[] = {
        {"mpm-verify report @ --headroom nothing", "--headroom \"nothing\": allowed is NAME=DIR"},
        {"mpm-verify report @ --headroom a=@/none", "none/checks.jsonl: cannot be read"},
        {"mpm-verify report @ --headroom a=@ --headroom a=.", "\"a\" is given twice"},
        {"mpm-verify report @ --catalogue @/none", "none: no such folder of a catalogue"},
        {"mpm-verify run --output @ --costs @", "--costs: allowed with --launcher slurm"},
        {"mpm-verify export --output @/checks.jsonl", "is a file; --output names a folder"},
        {"mpm-verify report @ --baseline @/none", "none/checks.jsonl: cannot be read"},
        {"mpm-verify report @ --mutants @/none", "none"},
        {"mpm-verify run --output @ --baseline @", "is the output folder"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct test_said said = test_verify_with(table[i].line, folders.first, folders.first);
        ck_assert_msg(said.exit_status == 2 && strstr(said.err, table[i].message) != NULL,
                      "%s: %d, %s", table[i].line, said.exit_status, said.err);
        test_said_free(&said);
    }
}
END_TEST

Suite *suite_report_site(void)
{
    Suite *suite = suite_create("report_site");
    TCase *pieces = tcase_create("pieces");
    tcase_add_test(pieces, a_table_has_the_same_cells_as_html_and_as_csv);
    tcase_add_test(pieces, headroom_is_the_room_on_the_side_of_the_value_over_its_deviation);
    tcase_add_test(pieces, a_check_outside_needs_a_reason_and_no_other_may_have_one);
    tcase_add_test(pieces, mutants_that_are_not_as_described_are_refused);
    suite_add_tcase(suite, pieces);
    TCase *site = tcase_create("site");
    tcase_add_checked_fixture(site, set_up, tear_down);
    tcase_add_test(site, the_coverage_counts_checks_by_the_evidence_that_they_declare);
    tcase_add_test(site, evidence_that_is_none_of_the_kinds_is_refused);
    tcase_add_test(site, every_page_is_well_formed_and_limits_hold_the_weaknesses);
    tcase_add_test(site, what_is_stored_is_shown_again_from_the_folder_alone);
    tcase_add_test(site, headroom_without_a_reason_and_values_missing_elsewhere_are_told);
    tcase_add_test(site, a_comparison_without_columns_is_none);
    tcase_add_test(site, additions_that_cannot_be_are_refused);
    suite_add_tcase(suite, site);
    return suite;
}
