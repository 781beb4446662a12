/* What figures' scripts may do: read before they run, and run without a shell.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_gnuplot.h"
#include "suites.h"
#include "support/folder.h"

#include "verification/pages/figure.h"
#include "verification/pages/figure_script.h"

#include <glib.h>
#include <string.h>

/* ------------------------------------------------------------------ what is read */

static const char *const refused[] = {
    "system 'touch x'",
    "system(\"touch x\")",
    "x = system('date')",
    "y(x) = 1 + system ('date')",
    "!touch x",
    "  ! touch x",
    "x = 1; !touch x",
    "if (1) { !touch x }",
    "shell",
    "sh",
    "x = `date`",
    "set title \"`date`\"",
    "plot '< date'",
    "plot \"<date\"",
    "plot \"\\074 date\"",
    "plot ' <date'",
    "file = '<date'",
    "load 'other.gp'",
    "load '< date'",
    "load other",
    "load style.x",
    "call 'other.gp'",
    "eval 'plot 1'",
    "evaluate('plot 1')",
    "set output '|touch x'",
    "set output 'elsewhere.svg'",
    "set output",
    "set output output.'x'",
    "set print '|touch x'",
    "set print 'x'",
    "print 1",
    "save 'x'",
    "set table 'x'",
    "set table '| touch x'",
    "set fontpath '!date'",
    "set loadpath 'x'",
    "set terminal png",
    "set term svg",
    "set terminal 'svg'",
    "import f(x) from 'x.so'",
    "@macro",
    "plot @what",
    "cd '/'",
    "pause -1",
    "exit",
    "history",
    "fit a*x 'd' via a",
    "update 'x'",
    "reread",
    "test",
    "bind a 'x'",
    "do for [i=1:2] { shell }",
    "if (1) shell",
    "else { shell }",
    "if (1) { x = 1 } else shell",
    "set title 'x' ; shell",
    "plot 1\nshell",
    "plot x \\\n, 1\nshell",
    "$d << E\nshell\nE\nshell",
    "$d << E\nshell\n  E\nshell",
    "$d << E\nshell",
    "$d",
    "x == 1",
    "f(x) + 1",
    "plot 'open",
    "plot 1 \\ + 2",
    "set for [i=1:2] label i",
    "'text'",
    "unset print",
    "se title 'x'",
    "pl 1",
    "# a comment\nshell",
    "plot 1 # a comment \\\nshell",
};

START_TEST(a_script_that_does_more_than_draw_is_refused_with_its_line)
{
    for (size_t i = 0; i < G_N_ELEMENTS(refused); i++) {
        struct mpm_error error = {.status = MPM_OK};
        char *text = g_strconcat("load style\n", refused[i], "\n", NULL);
        ck_assert_msg(figure_script_check("a.gp", text, false, &error) == MPM_BAD_INPUT, "%s",
                      refused[i]);
        ck_assert_msg(g_str_has_prefix(error.message, "a.gp:"), "%s", error.message);
        ck_assert_msg(!g_str_has_prefix(error.message, "a.gp:1:"), "%s", error.message);
        g_free(text);
    }
}
END_TEST

START_TEST(a_script_that_draws_is_allowed)
{
    static const char *const allowed[] = {
        "",
        "# system('x') `date` !date",
        "plot 'a' using 1:2 title 'b!'; set key off",
        "set title '`no` @no system(1) !no ''quoted'' < 1'",
        "x = 1 ; f(x) = x < 2 ? 1 : !x",
        "array a[3] = ['1', '2', '3']",
        "a[1] = 'x'",
        "$d << E\nshell\n!date\nE\nplot $d using 1:2",
        "do for [i = 1:words(v)] { if (i > 1) { plot i } else { plot 1 } }",
        "if (1) plot 1; else plot 2",
        "plot f(1) \\\n, \\\n  g(2)\nset table $d\nunset table",
        "load style; load axes",
        "set terminal svg size 1,2\nset output output",
        "µ = 1",
        "plot 1 # system\\\n",
    };
    struct mpm_error error = {.status = MPM_OK};
    for (size_t i = 0; i < G_N_ELEMENTS(allowed); i++)
        ck_assert_msg(figure_script_check("a.gp", allowed[i], false, &error) == MPM_OK, "%s",
                      error.message);
    /* labels of what the report writes itself may begin as they like */
    ck_assert_int_eq(figure_script_check("a", "across='<x>'; set label '< 1'", true, &error),
                     MPM_OK);
    ck_assert_int_eq(figure_script_check("a", "x='1'; system('y'); z=''", true, &error),
                     MPM_BAD_INPUT);
}
END_TEST

static unsigned check_scripts(const char *folder)
{
    unsigned count = 0;
    GDir *directory = g_dir_open(folder, 0, NULL);
    for (const char *name; directory != NULL && (name = g_dir_read_name(directory)) != NULL;) {
        char *path = g_build_filename(folder, name, NULL);
        struct mpm_error error = {.status = MPM_OK};
        if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
            count += check_scripts(path);
        } else if (g_str_has_suffix(name, ".gp")) {
            char *text = test_file_read(path);
            ck_assert_msg(figure_script_check(path, text, false, &error) == MPM_OK, "%s",
                          error.message);
            g_free(text);
            count++;
        }
        g_free(path);
    }
    if (directory != NULL)
        g_dir_close(directory);
    return count;
}

START_TEST(every_script_of_the_catalogue_and_of_reports_is_allowed)
{
    ck_assert_uint_ge(check_scripts("reports"), 5);
    ck_assert_uint_ge(check_scripts("verification/catalogue"), 100);
}
END_TEST

/* ------------------------------------------------------------------- what is run */

/* Runs the text, past the reading, as mpm_gnuplot_run() does it. Whether `mark` was left. */
static bool leaves_mark(const char *text, char **said)
{
    char *folder = test_folder_create();
    char *failure = NULL;
    g_free(test_folder_write(folder, "script.gp", text));
    (void)mpm_gnuplot_run(folder, "set terminal svg; set output 'x.svg'", "script.gp", said,
                          &failure);
    ck_assert_ptr_nonnull(*said);
    char *mark = test_folder_path(folder, "mark");
    const bool left = test_file_exists(mark);
    g_free(failure);
    g_free(mark);
    test_folder_remove(folder);
    return left;
}

#if defined __linux__ && (defined __x86_64__ || defined __aarch64__)
START_TEST(gnuplot_starts_no_program_whatever_a_script_does)
{
    static const char *const scripts[] = {
        "system 'echo x > mark'",
        "x = system('echo x > mark')",
        "c = '/bin/touch mark'; system(c)",
        "!echo x > mark",
        "x = \"`echo x > mark`\"",
        "plot '< echo 1 2 > mark; echo 1 2'",
        "c = sprintf('%c /bin/touch mark', 60); plot c",
        "set output '|cat > mark'; plot 1; set output",
        "set print '|cat > mark'; print 1; set print",
        "set table '|cat > mark'; plot 1; unset table",
        "load '< echo x > mark; echo plot 1'",
        "save '|cat > mark'",
        "eval 'system ''echo x > mark'''",
        "set fontpath '!echo x > mark'",
        "set terminal x11; plot 1",
    };
    for (size_t i = 0; i < G_N_ELEMENTS(scripts); i++) {
        char *said = NULL;
        ck_assert_msg(!leaves_mark(scripts[i], &said), "%s", scripts[i]);
        ck_assert_ptr_null(strstr(said, "cannot keep it from"));
        g_free(said);
    }
}
END_TEST
#endif

/* That gnuplot writes the mark itself shows that the test above could see one. */
START_TEST(gnuplot_runs_in_its_folder_without_the_settings_of_a_user)
{
    char *home = test_folder_create(), *said = NULL, *old = g_strdup(g_getenv("HOME"));
    g_free(test_folder_write(home, ".gnuplot", "print 'settings of a user'\n"));
    g_setenv("HOME", home, TRUE);
    ck_assert(leaves_mark("set print 'mark'; print 1; set print", &said));
    ck_assert_str_eq(said, "");
    if (old == NULL)
        g_unsetenv("HOME");
    else
        g_setenv("HOME", old, TRUE);
    g_free(said);
    g_free(old);
    test_folder_remove(home);
}
END_TEST

START_TEST(a_text_between_quotes_stays_one)
{
    static const char *const texts[][2] = {
        {"", "''"},
        {"a'; system('x'); '", "'a''; system(''x''); '''"},
        {"`date` \"$x\" \\", "'`date` \"$x\" \\'"},
        {"''; x", "\"''\".'; x'"},
        {"one\ntwo\rthree", "'onetwothree'"},
        {"µs, θ", "'µs, θ'"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++) {
        char *quoted = figure_quoted(texts[i][0]);
        ck_assert_str_eq(quoted, texts[i][1]);
        g_free(quoted);
    }
}
END_TEST

Suite *suite_figure_script(void)
{
    Suite *suite = suite_create("figure_script");
    TCase *reading = tcase_create("reading");
    tcase_add_test(reading, a_script_that_does_more_than_draw_is_refused_with_its_line);
    tcase_add_test(reading, a_script_that_draws_is_allowed);
    tcase_add_test(reading, every_script_of_the_catalogue_and_of_reports_is_allowed);
    tcase_add_test(reading, a_text_between_quotes_stays_one);
    suite_add_tcase(suite, reading);
    TCase *running = tcase_create("running");
#if defined __linux__ && (defined __x86_64__ || defined __aarch64__)
    tcase_add_test(running, gnuplot_starts_no_program_whatever_a_script_does);
#endif
    tcase_add_test(running, gnuplot_runs_in_its_folder_without_the_settings_of_a_user);
    suite_add_tcase(suite, running);
    return suite;
}
