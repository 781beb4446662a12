/* A run of the suite from end to end: programs that misbehave, the result lines, the
 * reports rendered from them, the commands and their exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"

#include "verification/suite/commands.h"
#include "verification/suite/figures.h"
#include "verification/suite/markdown.h"
#include "verification/suite/records.h"
#include "verification/suite/report.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ------------------------------------------------------------------ support */

struct said {
    int exit_status;
    char *out, *err;
};

static char *rest_of(FILE *file)
{
    const long length = ftell(file);
    char *text = g_malloc0((size_t)length + 1);
    rewind(file);
    ck_assert_uint_eq(fread(text, 1, (size_t)length, file), (size_t)length);
    ck_assert_int_eq(fclose(file), 0);
    return text;
}

/* Runs a command line (blanks part arguments) with the programs of the tests. */
static struct said command(const char *line)
{
    char **argv = g_strsplit(line, " ", -1);
    FILE *out = tmpfile(), *err = tmpfile();
    ck_assert(out != NULL && err != NULL);
    const struct suite_world world = {out, err, false, test_programs()};
    struct said said = {suite_command((int)g_strv_length(argv), argv, &world), NULL, NULL};
    said.out = rest_of(out);
    said.err = rest_of(err);
    g_strfreev(argv);
    return said;
}

static struct said command_with(const char *format, const char *one, const char *other)
{
    char **parts = g_strsplit(format, "@", 3);
    char *line = g_strconcat(parts[0], one, parts[1], parts[2] == NULL ? "" : other,
                             parts[2] == NULL ? "" : parts[2], NULL);
    const struct said said = command(line);
    g_free(line);
    g_strfreev(parts);
    return said;
}

static void forget(struct said *said)
{
    g_free(said->out);
    g_free(said->err);
}

static const char *last_line(char *text)
{
    g_strchomp(text);
    const char *newline = strrchr(text, '\n');
    return newline == NULL ? text : newline + 1;
}

static const struct {
    const char *program;
    enum verdict_status status;
    const char *reason;
} behaviours[] = {
    {"pass", VERDICT_PASS, ""},
    {"fail", VERDICT_FAIL, "above the band"},
    {"weak", VERDICT_EXPECTED_FAIL, "known weakness"},
    {"crash", VERDICT_ERROR, "signal 9"},
    {"hang", VERDICT_TIMEOUT, "time-out of 0.5 s"},
    {"omit", VERDICT_ERROR, "value was not reported"},
    {"leave", VERDICT_ERROR, "status 7"},
    {"refuse", VERDICT_ERROR, "step 12, particle 3: J = -0.1"},
    {"spoil", VERDICT_ERROR, "not a number"},
    {"skip", VERDICT_SKIP, "no reference | data # here"},
    {"undecided", VERDICT_INCONCLUSIVE, "ended before breakdown"},
};

/* A catalogue with one case for each behaviour. */
static char *misbehaving_catalogue(void)
{
    char *folder = test_folder_create();
    for (size_t i = 0; i < G_N_ELEMENTS(behaviours); i++) {
        const char *program = behaviours[i].program;
        char *text = test_case_text(program, program);
        if (behaviours[i].status == VERDICT_EXPECTED_FAIL) {
            char *weak = g_strconcat(
                text, "    outcome: fail\n    fails_low: 8\n    fails_high: 12\n", NULL);
            g_free(text);
            text = weak;
        }
        test_case_write(folder, program, text);
        g_free(text);
    }
    return folder;
}

static const json_t *check_of(const struct records *records, const char *name)
{
    for (size_t i = 0; i < json_array_size(records->checks); i++)
        if (strcmp(record_text(json_array_get(records->checks, i), "case"), name) == 0)
            return json_array_get(records->checks, i);
    ck_abort_msg("no check of case %s", name);
    return NULL;
}

static void assert_well_formed(const char *text, const char *what)
{
    const GMarkupParser nothing = {NULL, NULL, NULL, NULL, NULL};
    GMarkupParseContext *context =
        g_markup_parse_context_new(&nothing, G_MARKUP_DEFAULT_FLAGS, NULL, NULL);
    GError *error = NULL;
    const bool good = g_markup_parse_context_parse(context, text, -1, &error) &&
                      g_markup_parse_context_end_parse(context, &error);
    ck_assert_msg(good, "%s: %s", what, error == NULL ? "" : error->message);
    g_markup_parse_context_free(context);
}

static char *read_in(const char *folder, const char *name)
{
    char *path = test_folder_path(folder, name);
    char *text = test_file_read(path);
    g_free(path);
    return text;
}

/* --------------------------------------------------------------------- runs */

START_TEST(whatever_a_program_does_each_declared_check_gets_its_status)
{
    char *catalogue = misbehaving_catalogue(), *output = test_folder_create();
    struct said said =
        command_with("mpm-verify run --jobs 4 --catalogue @ --output @", catalogue, output);
    struct records records;
    struct mpm_error error;
    ck_assert_int_eq(said.exit_status, 1);
    ck_assert_str_eq(last_line(said.out), "2 passed, 8 failed, 1 skipped");
    ck_assert_ptr_nonnull(strstr(said.out, "1 known weakness shows"));
    ck_assert_int_eq(records_read(output, &records, &error), MPM_OK);
    ck_assert_uint_eq(json_array_size(records.checks), G_N_ELEMENTS(behaviours));
    for (size_t i = 0; i < G_N_ELEMENTS(behaviours); i++) {
        const json_t *check = check_of(&records, behaviours[i].program);
        ck_assert_str_eq(record_text(check, "status"), verdict_status_name(behaviours[i].status));
        ck_assert_ptr_nonnull(strstr(record_text(check, "reason"), behaviours[i].reason));
        ck_assert_double_gt(record_number(check, "mutations"), 9);
        ck_assert_double_eq(record_number(check, "mutations"),
                            record_number(check, "mutations_red"));
        const bool has_value = behaviours[i].status == VERDICT_PASS ||
                               behaviours[i].status == VERDICT_FAIL ||
                               behaviours[i].status == VERDICT_EXPECTED_FAIL;
        ck_assert_int_eq(json_is_null(json_object_get(check, "value")), !has_value);
        ck_assert_int_eq(json_is_null(json_object_get(check, "margin")), !has_value);
    }
    char *page = read_in(output, "cases/crash/index.html");
    ck_assert_ptr_nonnull(strstr(page, "about to &lt;crash&gt; &amp; burn"));
    g_free(page);
    records_clear(&records);
    forget(&said);
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
    struct said said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
    ck_assert_str_eq(last_line(said.out), "2 passed, 0 failed, 0 skipped");
    char *text = read_in(output, "checks.jsonl");
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
    forget(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

/* A process that runs `act` and exits with what it returns. */
static pid_t in_process(int (*act)(const char *one, const char *other), const char *one,
                        const char *other)
{
    (void)fflush(NULL);
    const pid_t process = fork();
    ck_assert_int_ge(process, 0);
    if (process == 0)
        _exit(act(one, other));
    return process;
}

static int exit_status_of(pid_t process)
{
    int state = 0;
    ck_assert_int_eq(waitpid(process, &state, 0), process);
    ck_assert(WIFEXITED(state));
    return WEXITSTATUS(state);
}

static int run_all(const char *catalogue, const char *output)
{
    const struct said said =
        command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    return said.exit_status;
}

static void wait_for(const char *folder, const char *name)
{
    char *path = test_folder_path(folder, name);
    for (int i = 0; i < 2000 && !g_file_test(path, G_FILE_TEST_EXISTS); i++)
        g_usleep(5000);
    ck_assert_msg(g_file_test(path, G_FILE_TEST_EXISTS), "%s", path);
    g_free(path);
}

START_TEST(an_interrupted_run_ends_its_programs_and_leaves_no_report)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    char *text = test_case_text("hang", "hang");
    char **parts = g_strsplit(text, "timeout: 0.5", 2);
    char *patient = g_strjoinv("timeout: 500", parts);
    test_case_write(catalogue, "hang", patient);
    const pid_t process = in_process(run_all, catalogue, output);
    wait_for(output, "cases/hang/rows-only.jsonl");
    /* meanwhile the folder is taken */
    struct said said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(said.err, "another run is writing"));
    forget(&said);
    ck_assert_int_eq(kill(process, SIGINT), 0);
    ck_assert_int_eq(exit_status_of(process), 4);
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
    struct said said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(said.err, "not written by mpm-verify"));
    char *kept = test_file_read(foreign);
    ck_assert_str_eq(kept, "mine");
    g_free(kept);
    forget(&said);
    ck_assert_int_eq(g_remove(foreign), 0);
    g_free(foreign);
    /* other names stay through two runs; what the first run left goes */
    char *notes = test_folder_write(output, "notes.txt", "mine");
    for (int i = 0; i < 2; i++) {
        said = command_with(i == 0 ? "mpm-verify run --catalogue @ --output @"
                                   : "mpm-verify run --catalogue @ --variant cubic --output @",
                            catalogue, output);
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        forget(&said);
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
    said = command_with("mpm-verify run --catalogue @ --output @", catalogue, file);
    ck_assert_int_eq(said.exit_status, 2);
    forget(&said);
    g_free(file);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

/* ------------------------------------------------------------------ reports */

static const char *const rendered[] = {"index.html",         "summary.md",
                                       "junit.xml",          "results.tap",
                                       "cases/Q/index.html", "cases/Q/figure-curve.svg"};

START_TEST(reports_are_well_formed_and_rendered_again_to_the_same_bytes)
{
    char *catalogue = misbehaving_catalogue(), *output = test_folder_create();
    char *before[G_N_ELEMENTS(rendered)];
    test_case_write_quadrature(catalogue);
    struct said said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 1);
    forget(&said);
    for (size_t i = 0; i < G_N_ELEMENTS(rendered); i++) {
        before[i] = read_in(output, rendered[i]);
        ck_assert_uint_gt(strlen(before[i]), 100);
        if (!g_str_has_suffix(rendered[i], ".md") && !g_str_has_suffix(rendered[i], ".tap"))
            assert_well_formed(before[i], rendered[i]);
        ck_assert_ptr_null(strstr(before[i], "<script"));
        if (i != 3)
            continue;
        /* as many results as the plan says */
        char *count = g_strdup_printf("\n1..%zu\n", G_N_ELEMENTS(behaviours) + 2);
        ck_assert_ptr_nonnull(strstr(before[i], count));
        ck_assert_ptr_nonnull(strstr(before[i], "# SKIP no reference | data \\# here\n"));
        g_free(count);
    }
    said = command_with("mpm-verify report @", output, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    for (size_t i = 0; i < G_N_ELEMENTS(rendered); i++) {
        char *after = read_in(output, rendered[i]);
        ck_assert_msg(strcmp(before[i], after) == 0, "%s", rendered[i]);
        g_free(after);
        g_free(before[i]);
    }
    forget(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(result_lines_alone_are_enough_for_a_report)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    char *alone = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct said said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    forget(&said);
    char *lines = read_in(output, "checks.jsonl");
    g_free(test_folder_write(alone, "checks.jsonl", lines));
    said = command_with("mpm-verify report @", alone, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    char *page = read_in(alone, "cases/Q/index.html"), *junit = read_in(alone, "junit.xml");
    ck_assert_ptr_nonnull(strstr(page, "result lines alone"));
    assert_well_formed(page, "page");
    assert_well_formed(junit, "junit.xml");
    forget(&said);
    g_free(page);
    g_free(junit);
    g_free(lines);
    test_folder_remove(alone);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_figure_that_cannot_be_drawn_is_an_error_of_the_report)
{
    const struct {
        const char *script;
        const char *message;
    } table[] = {
        {"load style\nplot sin(\n", "gnuplot: "},
        {"load style\nplot 'missing.dat', x\n", "missing.dat"},
        {"print 'nothing drawn'\n", "no SVG file"},
    };
    for (size_t i = 0; i <= G_N_ELEMENTS(table); i++) {
        char *catalogue = test_folder_create(), *output = test_folder_create();
        test_case_write_quadrature(catalogue);
        if (i < G_N_ELEMENTS(table))
            g_free(test_folder_write(catalogue, "T/Q/curve.gp", table[i].script));
        else
            g_setenv("PATH", catalogue, TRUE); /* the last: no gnuplot at all */
        struct said said =
            command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
        ck_assert_int_eq(said.exit_status, 4);
        ck_assert_ptr_nonnull(strstr(said.err, "figure curve of case Q"));
        ck_assert_msg(
            strstr(said.err, i < G_N_ELEMENTS(table) ? table[i].message : "cannot be run") != NULL,
            "%s", said.err);
        /* the results are there all the same, and the page says what is missing */
        ck_assert_str_eq(last_line(said.out), "2 passed, 0 failed, 0 skipped");
        char *page = read_in(output, "cases/Q/index.html");
        ck_assert_ptr_nonnull(strstr(page, "could not be drawn"));
        assert_well_formed(page, "page");
        g_free(page);
        forget(&said);
        test_folder_remove(output);
        test_folder_remove(catalogue);
    }
}
END_TEST

START_TEST(a_figure_without_its_variants_is_left_out_with_the_reason)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct said said =
        command_with("mpm-verify run --variant cubic --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 0);
    char *page = read_in(output, "cases/Q/index.html");
    ck_assert_ptr_nonnull(strstr(page, "needs variant ninth"));
    g_free(page);
    forget(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_figure_takes_its_text_colour_from_the_reader)
{
    char *dressed = figure_dress(
        "<?xml version=\"1.0\"?>\n<svg \n viewBox=\"0 0 1 1\" "
        "xmlns=\"http://www.w3.org/2000/svg\">\n"
        "<title>x</title>\n<desc>Produced by GNUPLOT 5.4 </desc>\n"
        "<path stroke='black' fill=\"rgb(  0,   0,   0)\" d='M0,0'/><path stroke='rgb(10, 0, 0)'/>"
        "</svg>",
        "a < b", "c & d");
    ck_assert_ptr_nonnull(strstr(dressed, "stroke='currentColor' fill=\"currentColor\""));
    ck_assert_ptr_nonnull(strstr(dressed, "stroke='rgb(10, 0, 0)'"));
    ck_assert_ptr_nonnull(strstr(dressed, "role=\"img\""));
    ck_assert_ptr_nonnull(strstr(dressed, "a &lt; b</title>"));
    ck_assert_ptr_null(strstr(dressed, "GNUPLOT"));
    assert_well_formed(dressed, "figure");
    g_free(dressed);
}
END_TEST

START_TEST(markdown_loses_raw_html_and_its_first_heading)
{
    char *html = markdown_html("# Title\n\n## Problem\n\n<b>raw</b> [x](javascript:alert(1))\n\n"
                               "| a |\n|---|\n| 1 |\n");
    ck_assert_ptr_null(strstr(html, "Title"));
    ck_assert_ptr_nonnull(strstr(html, "<h3>Problem</h3>"));
    ck_assert_ptr_null(strstr(html, "<b>"));
    ck_assert_ptr_null(strstr(html, "javascript"));
    ck_assert_ptr_nonnull(strstr(html, "<table>"));
    g_free(html);
}
END_TEST

/* ----------------------------------------------------------------- commands */

START_TEST(bad_usage_ends_with_2_and_says_why)
{
    const struct {
        const char *line, *message;
    } table[] = {
        {"mpm-verify", "no command"},
        {"mpm-verify fly", "unknown command fly"},
        {"mpm-verify run --catalogue @ --tier big", "--tier \"big\": allowed are ci and full"},
        {"mpm-verify run --catalogue @ --jobs none", "none"},
        {"mpm-verify run --catalogue @ --jobs -1", "--jobs -1: allowed are 1 to 1024"},
        {"mpm-verify run --catalogue @ --case X", "no check matches"},
        {"mpm-verify run --catalogue @ --speed", "Unknown option --speed"},
        {"mpm-verify run --catalogue @ extra", "\"extra\": unexpected argument"},
        {"mpm-verify run --catalogue @/none", "no such folder of a catalogue"},
        {"mpm-verify list --catalogue @ --tag none", "no case has the tag none"},
        {"mpm-verify list --catalogue @ --tier ci", "Unknown option --tier"},
        {"mpm-verify explain --catalogue @", "CHECK is missing"},
        {"mpm-verify explain --catalogue @ Q/none", "matches no check"},
        {"mpm-verify explain --catalogue @ Q/exact/cubic/more", "matches no check"},
        {"mpm-verify explain --catalogue @ Q --output @/none", "checks.jsonl: cannot be read"},
        {"mpm-verify report", "DIR is missing"},
        {"mpm-verify report @", "checks.jsonl: cannot be read"},
    };
    char *catalogue = test_folder_create();
    test_case_write_quadrature(catalogue);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct said said = strchr(table[i].line, '@') == NULL
                               ? command(table[i].line)
                               : command_with(table[i].line, catalogue, catalogue);
        ck_assert_msg(said.exit_status == 2, "%s: %d", table[i].line, said.exit_status);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "%s: %s", table[i].line,
                      said.err);
        forget(&said);
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
        struct said said = command_with("mpm-verify report @", folder, NULL);
        ck_assert_int_eq(said.exit_status, 2);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "row %zu: %s", i, said.err);
        forget(&said);
        g_free(text);
        test_folder_remove(folder);
    }
}
END_TEST

START_TEST(list_names_the_cases_and_explain_says_all_of_a_check)
{
    static const char *const parts[] = {"Q/short/ninth: too few points",
                                        "Let x < y",
                                        "degree 9 needs 5 points",
                                        "from theory",
                                        "required to lie in 0.99 .. 1",
                                        "expected-fail",
                                        "mpm-verify run --case Q --variant ninth"};
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct said said = command_with("mpm-verify list --catalogue @", catalogue, NULL);
    ck_assert_int_eq(said.exit_status, 0);
    ck_assert_ptr_nonnull(strstr(said.out, "Gauss quadrature"));
    ck_assert_ptr_nonnull(strstr(said.out, "cubic ninth fine (full)"));
    forget(&said);
    said = command_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    forget(&said);
    said = command_with("mpm-verify explain Q/sh* --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 0);
    for (size_t i = 0; i < G_N_ELEMENTS(parts); i++)
        ck_assert_msg(strstr(said.out, parts[i]) != NULL, "%s: %s", parts[i], said.out);
    ck_assert_ptr_null(strstr(said.out, "Q/exact"));
    forget(&said);
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
    tcase_add_test(runs, an_interrupted_run_ends_its_programs_and_leaves_no_report);
    tcase_add_test(runs, an_output_folder_keeps_what_is_not_ours);
    suite_add_tcase(suite, runs);
    TCase *reports = tcase_create("reports");
    tcase_add_test(reports, reports_are_well_formed_and_rendered_again_to_the_same_bytes);
    tcase_add_test(reports, result_lines_alone_are_enough_for_a_report);
    tcase_add_test(reports, a_figure_that_cannot_be_drawn_is_an_error_of_the_report);
    tcase_add_test(reports, a_figure_without_its_variants_is_left_out_with_the_reason);
    tcase_add_test(reports, a_figure_takes_its_text_colour_from_the_reader);
    tcase_add_test(reports, markdown_loses_raw_html_and_its_first_heading);
    suite_add_tcase(suite, reports);
    TCase *commands = tcase_create("commands");
    tcase_add_test(commands, bad_usage_ends_with_2_and_says_why);
    tcase_add_test(commands, tampered_result_lines_are_refused_with_their_line);
    tcase_add_test(commands, list_names_the_cases_and_explain_says_all_of_a_check);
    suite_add_tcase(suite, commands);
    return suite;
}
