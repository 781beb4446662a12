/* A run of the suite from end to end: programs that misbehave, the result lines, the
 * output folder, the commands and their exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/records/records.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/types.h>

static const json_t *check_of(const struct records *records, const char *name)
{
    for (size_t i = 0; i < json_array_size(records->checks); i++)
        if (strcmp(record_text(json_array_get(records->checks, i), "case"), name) == 0)
            return json_array_get(records->checks, i);
    ck_abort_msg("no check of case %s", name);
    return NULL;
}

/* --------------------------------------------------------------------- runs */

START_TEST(whatever_a_program_does_each_declared_check_gets_its_status)
{
    char *catalogue = test_misbehaving_catalogue(), *output = test_folder_create();
    struct test_said said =
        test_verify_with("mpm-verify run --jobs 4 --catalogue @ --output @", catalogue, output);
    struct records records;
    struct mpm_error error;
    ck_assert_int_eq(said.exit_status, 1);
    ck_assert_str_eq(test_last_line(said.out), "2 passed, 8 failed, 1 skipped");
    ck_assert_ptr_nonnull(strstr(said.out, "1 known weakness shows"));
    ck_assert_ptr_nonnull(
        strstr(said.out, "\nmeasured, and checked or compared by no case (1): omit another\n"));
    ck_assert_int_eq(records_read(output, &records, &error), MPM_OK);
    ck_assert_uint_eq(json_array_size(records.checks), (size_t)TEST_BEHAVIOURS);
    for (size_t i = 0; i < (size_t)TEST_BEHAVIOURS; i++) {
        const json_t *check = check_of(&records, test_behaviours[i].program);
        ck_assert_str_eq(record_text(check, "status"),
                         verdict_status_name(test_behaviours[i].status));
        ck_assert_ptr_nonnull(strstr(record_text(check, "reason"), test_behaviours[i].reason));
        ck_assert_double_gt(record_number(check, "mutations"), 9);
        ck_assert_double_eq(record_number(check, "mutations"),
                            record_number(check, "mutations_red"));
        const bool has_value = test_behaviours[i].status == VERDICT_PASS ||
                               test_behaviours[i].status == VERDICT_FAIL ||
                               test_behaviours[i].status == VERDICT_EXPECTED_FAIL;
        ck_assert_int_eq(json_is_null(json_object_get(check, "value")), !has_value);
        ck_assert_int_eq(json_is_null(json_object_get(check, "margin")), !has_value);
    }
    char *page = test_folder_read(output, "cases/crash/index.html");
    ck_assert_ptr_nonnull(strstr(page, "about to &lt;crash&gt; &amp; burn"));
    g_free(page);
    records_clear(&records);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_result_line_has_the_promised_keys)
{
    static const char *const keys[] = {
        "family",   "case", "check", "variant", "quantity", "unit",   "norm",    "value",
        "expected", "low",  "high",  "margin",  "status",   "reason", "seconds", "particle_steps"};
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
    ck_assert_str_eq(test_last_line(said.out), "2 passed, 0 failed, 0 skipped");
    char *text = test_folder_read(output, "checks.jsonl");
    char **lines = g_strsplit(text, "\n", -1);
    ck_assert_uint_eq(g_strv_length(lines), 4); /* the run, two checks, the end */
    json_t *run = json_loads(lines[0], 0, NULL);
    ck_assert_str_eq(record_text(run, "kind"), "run");
    ck_assert_str_eq(record_text(run, "revision"), mpm_build_info()->revision);
    for (size_t line = 1; line < 3; line++) {
        json_t *check = json_loads(lines[line], 0, NULL);
        for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
            ck_assert_msg(json_object_get(check, keys[i]) != NULL, "%s", keys[i]);
        ck_assert_double_eq(record_number(check, "particle_steps"), 1000);
        json_decref(check);
    }
    json_decref(run);
    g_strfreev(lines);
    g_free(text);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(an_interrupted_run_ends_its_programs_and_without_results_leaves_no_report)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    char *text = test_case_text("hang", "hang");
    char **parts = g_strsplit(text, "timeout: 0.5", 2);
    char *patient = g_strjoinv("timeout: 500", parts);
    test_case_write(catalogue, "hang", patient);
    const pid_t process = test_in_process(test_run_all, catalogue, output);
    test_wait_for(output, ".run/report/cases/hang/rows-only.jsonl");
    /* meanwhile the folder is taken */
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(said.err, "another run is writing"));
    test_said_free(&said);
    ck_assert_int_eq(kill(process, SIGINT), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGINT);
    char *lines = test_folder_path(output, "checks.jsonl");
    ck_assert(!g_file_test(lines, G_FILE_TEST_EXISTS));
    g_free(lines);
    g_free(patient);
    g_strfreev(parts);
    g_free(text);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(an_output_folder_keeps_what_is_not_ours)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    /* a stranger's index.html would be replaced: refused */
    char *foreign = test_folder_write(output, "index.html", "mine");
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(said.err, "not written by mpm-verify"));
    char *kept = test_file_read(foreign);
    ck_assert_str_eq(kept, "mine");
    g_free(kept);
    test_said_free(&said);
    ck_assert_int_eq(g_remove(foreign), 0);
    g_free(foreign);
    /* other names stay through two runs; what the first run left goes */
    char *notes = test_folder_write(output, "notes.txt", "mine");
    for (int i = 0; i < 2; i++) {
        said = test_verify_with(i == 0 ? "mpm-verify run --catalogue @ --output @"
                                       : "mpm-verify run --catalogue @ --variant cubic --output @",
                                catalogue, output);
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        test_said_free(&said);
    }
    kept = test_file_read(notes);
    ck_assert_str_eq(kept, "mine");
    char *old = test_folder_path(output, "cases/Q/data-ninth-curve.dat");
    ck_assert(!g_file_test(old, G_FILE_TEST_EXISTS));
    g_free(old);
    g_free(kept);
    g_free(notes);
    /* a file in place of the folder */
    char *file = test_folder_write(output, "file", "");
    said = test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, file);
    ck_assert_int_eq(said.exit_status, 2);
    test_said_free(&said);
    g_free(file);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_list_of_pairs_selects_those_and_is_recorded)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    char *list = test_folder_write(catalogue, "list", "Q/ninth\n\n  Q/fine \nR1/cubic\n");
    char *line =
        g_strdup_printf("mpm-verify run --tier full --catalogue @ --output @ --only %s", list);
    struct test_said said = test_verify_with(line, catalogue, output);
    struct records records;
    struct mpm_error error;
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    ck_assert_int_eq(records_read(output, &records, &error), MPM_OK);
    ck_assert_uint_eq(json_array_size(records.checks), 2);
    for (size_t i = 0; i < 2; i++)
        ck_assert_str_ne(record_text(json_array_get(records.checks, i), "variant"), "cubic");
    ck_assert_str_eq(record_text(records.run, "only"), list);
    records_clear(&records);
    test_said_free(&said);
    g_free(line);
    g_free(list);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

/* ----------------------------------------------------------------- commands */

START_TEST(bad_usage_ends_with_2_and_says_why)
{
    const struct {
        const char *line, *message;
    } table[] = {
        {"mpm-verify", "a command is missing: list, run"},
        {"mpm-verify fly", "unknown command \"fly\"; allowed: list, run"},
        {"mpm-verify help fly", "unknown command \"fly\""},
        {"mpm-verify run --catalogue @ --tier big", "--tier \"big\"; allowed: ci, full;"},
        {"mpm-verify run --catalogue @ --tier fulll", "allowed: ci, full; did you mean full?"},
        {"mpm-verify run --catalogue @ --jobs none", "none"},
        {"mpm-verify run --catalogue @ --jobs -1", "--jobs -1: allowed are 1 to 1024"},
        {"mpm-verify run --catalogue @ --kernels quick",
         "--kernels \"quick\"; allowed: auto, reference, fast;"},
        {"mpm-verify list --catalogue @ --kernels fast", "list: unknown option --kernels"},
        {"mpm-verify run --catalogue @ --case X", "--case \"X\" matches no case; see"},
        {"mpm-verify run --catalogue @ --variant cubik",
         "--variant \"cubik\" matches no variant of the cases; did you mean cubic?"},
        {"mpm-verify rum", "did you mean run?"},
        {"mpm-verify run --kernel fast", "unknown option --kernel; did you mean --kernels?"},
        {"mpm-verify explain --catalogue @ Q/exakt", "did you mean exact?"},
        {"mpm-verify run --catalogue @ --variant fine", "no check matches"},
        {"mpm-verify run --catalogue @ --only @/none", "none: cannot be read"},
        {"mpm-verify run --catalogue @ --only @/empty", "empty; allowed: lines CASE/VARIANT"},
        {"mpm-verify run --catalogue @ --only @/strangers", "and the list --only"},
        {"mpm-verify run --catalogue @ --speed", "run: unknown option --speed"},
        {"mpm-verify run --catalogue @ --tier ci --tier full", "run: --tier is given twice"},
        {"mpm-verify run --catalogue @ --resume --resume", "run: --resume is given twice"},
        {"mpm-verify run --catalogue @ extra", "run: unexpected argument \"extra\""},
        {"mpm-verify run --catalogue @/none", "no such folder of a catalogue"},
        {"mpm-verify list --catalogue @ --tag none", "no case has the tag none"},
        {"mpm-verify list --catalogue @ --tier ci", "list: unknown option --tier"},
        {"mpm-verify explain --catalogue @", "CHECK is missing"},
        {"mpm-verify explain --catalogue @ Q/none", "matches no check"},
        {"mpm-verify explain --catalogue @ Q/exact/cubic/more", "matches no check"},
        {"mpm-verify explain --catalogue @ Q --output @/none", "checks.jsonl: cannot be read"},
        {"mpm-verify report", "DIR is missing"},
        {"mpm-verify report @", "checks.jsonl: cannot be read"},
    };
    char *catalogue = test_folder_create();
    test_case_write_quadrature(catalogue);
    g_free(test_folder_write(catalogue, "empty", "\n \n"));
    g_free(test_folder_write(catalogue, "strangers", "Q/none\nR1/ugimp\n"));
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct test_said said = strchr(table[i].line, '@') == NULL
                                    ? test_verify(table[i].line)
                                    : test_verify_with(table[i].line, catalogue, catalogue);
        ck_assert_msg(said.exit_status == 2, "%s: %d", table[i].line, said.exit_status);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "%s: %s", table[i].line,
                      said.err);
        test_said_free(&said);
    }
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(tampered_result_lines_are_refused_with_their_line)
{
    static const char run[] =
        "{\"kind\":\"run\",\"version\":\"1\",\"revision\":\"r\",\"tier\":\"ci\","
        "\"cases\":[]}\n";
    const struct {
        const char *run, *rest, *message;
    } table[] = {
        {"", "", "is empty"},
        {"{", "", ":1: is no record of a run"},
        {run, "{\"kind\":\"check\"}\n", ":2: is no record of a check"},
        {run, run, ":2: is no record of a check"},
        {"{\"kind\":\"run\",\"version\":\"1\",\"revision\":\"r\",\"tier\":\"ci\",\"cases\":"
         "[{\"case\":\"../../x\"}]}",
         "", ":1: is no record of a run"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *folder = test_folder_create();
        char *text = g_strconcat(table[i].run, table[i].rest, NULL);
        g_free(test_folder_write(folder, "checks.jsonl", text));
        struct test_said said = test_verify_with("mpm-verify report @", folder, NULL);
        ck_assert_int_eq(said.exit_status, 2);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "row %zu: %s", i, said.err);
        test_said_free(&said);
        g_free(text);
        test_folder_remove(folder);
    }
}
END_TEST

START_TEST(list_names_the_cases_and_explain_says_all_of_a_check)
{
    static const char *const parts[] = {"Q/short/ninth: too few points",
                                        "degree 9 needs 5 points",
                                        "from theory",
                                        "evidence   not stated",
                                        "required to lie in 0.99 .. 1",
                                        "expected-fail",
                                        "mpm-verify run --case Q --variant ninth"};
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct test_said said = test_verify_with("mpm-verify list --catalogue @", catalogue, NULL);
    ck_assert_int_eq(said.exit_status, 0);
    ck_assert_ptr_nonnull(strstr(said.out, "Gauss quadrature"));
    ck_assert_ptr_nonnull(strstr(said.out, "cubic ninth fine (full)"));
    test_said_free(&said);
    said = test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    test_said_free(&said);
    said = test_verify_with("mpm-verify explain Q/sh* --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 0);
    for (size_t i = 0; i < G_N_ELEMENTS(parts); i++)
        ck_assert_msg(strstr(said.out, parts[i]) != NULL, "%s: %s", parts[i], said.out);
    ck_assert_ptr_null(strstr(said.out, "Q/exact"));
    ck_assert_ptr_null(strstr(said.out, "Let x < y")); /* of the case */
    test_said_free(&said);
    said = test_verify_with("mpm-verify explain Q --catalogue @ --output @", catalogue, output);
    ck_assert_ptr_nonnull(strstr(said.out, "Let x < y"));
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

/* To the programs, into the result lines, and from there into report and explanation. */
START_TEST(the_kernels_asked_for_reach_every_measurement_and_are_recorded)
{
    static const struct {
        const char *name, *option, *command;
    } sets[] = {
        {"auto", "", "--variant cubic --output"},
        {"auto", " --kernels auto", "--variant cubic --output"},
        {"reference", " --kernels reference", "--variant cubic --kernels reference --output"},
        {"fast", " --kernels fast", "--variant cubic --kernels fast --output"},
    };
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    for (size_t i = 0; i < G_N_ELEMENTS(sets); i++) {
        char *line = g_strconcat("mpm-verify run --variant cubic --catalogue @ --output @",
                                 sets[i].option, NULL);
        struct test_said said = test_verify_with(line, catalogue, output);
        ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
        test_said_free(&said);
        g_free(line);
        const struct {
            const char *file, *format;
        } places[] = {
            {"checks.jsonl", "\"kernels\":\"%s\""},
            {"index.html", "<dt>Kernels</dt><dd>%s</dd>"},
            {"summary.md", ", kernels %s, size ci"},
            {"cases/Q/index.html", "%s kernels"}, /* the program's own note */
        };
        for (size_t k = 0; k < G_N_ELEMENTS(places); k++) {
            char *text = test_folder_read(output, places[k].file);
            char **parts = g_strsplit(places[k].format, "%s", 2);
            char *expected = g_strconcat(parts[0], sets[i].name, parts[1], NULL);
            ck_assert_msg(strstr(text, expected) != NULL, "no %s in %s", expected, places[k].file);
            ck_assert(k != 3 || strstr(text, sets[i].command) != NULL);
            g_free(expected);
            g_strfreev(parts);
            g_free(text);
        }
        said = test_verify_with("mpm-verify explain Q/exact/cubic --catalogue @ --output @",
                                catalogue, output);
        ck_assert_ptr_nonnull(strstr(said.out, sets[i].command));
        test_said_free(&said);
    }
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

Suite *suite_suite(void)
{
    Suite *suite = suite_create("suite");
    TCase *runs = tcase_create("runs");
    tcase_add_test(runs, whatever_a_program_does_each_declared_check_gets_its_status);
    tcase_add_test(runs, a_result_line_has_the_promised_keys);
    tcase_add_test(runs, an_interrupted_run_ends_its_programs_and_without_results_leaves_no_report);
    tcase_add_test(runs, an_output_folder_keeps_what_is_not_ours);
    tcase_add_test(runs, a_list_of_pairs_selects_those_and_is_recorded);
    tcase_add_test(runs, the_kernels_asked_for_reach_every_measurement_and_are_recorded);
    suite_add_tcase(suite, runs);
    TCase *commands = tcase_create("commands");
    tcase_add_test(commands, bad_usage_ends_with_2_and_says_why);
    tcase_add_test(commands, tampered_result_lines_are_refused_with_their_line);
    tcase_add_test(commands, list_names_the_cases_and_explain_says_all_of_a_check);
    suite_add_tcase(suite, commands);
    return suite;
}
