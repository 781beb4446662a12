/* Completion of command lines in real shells, lines of progress on terminals of all widths, and
 * JSON Schema in a real validator: by scripts of Python.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/command.h"
#include "support/skip.h"

#include <glib.h>
#include <string.h>

static const char *const programs[] = {"mpm", "mpm-verify", "mpm-bench"};
static const char *const shells[] = {"bash", "zsh", "fish"};

static bool can_run(const char *program)
{
    char *path = g_find_program_in_path(program);
    g_free(path);
    return path != NULL;
}

/* The scripts are of the system's Python: that is what the packages of `make deps` are for. */
static bool has_module(const char *module)
{
    if (!g_file_test("/usr/bin/python3", G_FILE_TEST_IS_EXECUTABLE))
        return false;
    char *code = g_strdup_printf("import %s", module);
    struct test_command command = test_command_run("/usr/bin/python3", "-c", code, NULL);
    const bool found = command.exit_status == 0;
    test_command_free(&command);
    g_free(code);
    return found;
}

START_TEST(a_shell_completes_commands_options_values_and_files)
{
    const char *shell = shells[_i];
    static const char *const reasons[] = {"needs bash and /usr/bin/python3",
                                          "needs zsh and /usr/bin/python3",
                                          "needs fish and /usr/bin/python3"};
    if (!can_run(shell) || !has_module("pty"))
        TEST_SKIP(reasons[_i]);
    struct test_command command = test_command_run(
        "/usr/bin/python3", "-B", "tests/completion/complete.py", g_getenv("MPM_BIN"), shell, NULL);
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    test_command_free(&command);
}
END_TEST

/* The names of the options of a text: "--word", or "-l word" for fish. */
static bool names_option(const char *script, const char *option)
{
    char *fish = g_strdup_printf(" -l %s", option + 2);
    const bool found = strstr(script, option) != NULL || strstr(script, fish) != NULL;
    g_free(fish);
    return found;
}

START_TEST(completion_has_every_option_of_every_command)
{
    for (size_t s = 0; s < G_N_ELEMENTS(shells); s++) {
        struct test_command script = test_command_run(programs[_i], "completion", shells[s], NULL);
        ck_assert_int_eq(script.exit_status, 0);
        struct test_command help = test_command_run(programs[_i], "help", "run", NULL);
        size_t options = 0;
        for (const char *at = strstr(help.output, "--"); at != NULL; at = strstr(at + 2, "--")) {
            char *option = g_strndup(at, 2 + strspn(at + 2, "abcdefghijklmnopqrstuvwxyz"));
            ck_assert_msg(strlen(option) == 2 || names_option(script.output, option), "%s: no %s",
                          shells[s], option);
            options++;
            g_free(option);
        }
        ck_assert_uint_ge(options, 5);
        test_command_free(&help);
        test_command_free(&script);
    }
}
END_TEST

START_TEST(no_other_shell_is_completed)
{
    static const char *const words[] = {"tcsh", NULL};
    for (size_t i = 0; i < G_N_ELEMENTS(words); i++) {
        struct test_command command = test_command_run("mpm", "completion", words[i], NULL);
        ck_assert_int_eq(command.exit_status, 2);
        ck_assert_str_eq(command.output, "");
        ck_assert_ptr_nonnull(strstr(command.errors, "allowed: bash|zsh|fish\n"));
        test_command_free(&command);
    }
}
END_TEST

START_TEST(progress_fits_into_any_terminal_and_colours_can_be_off)
{
    if (!has_module("pty"))
        TEST_SKIP("needs /usr/bin/python3");
    struct test_command command = test_command_run(
        "/usr/bin/python3", "-B", "tests/terminal/progress.py", g_getenv("MPM_BIN"), NULL);
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    test_command_free(&command);
}
END_TEST

START_TEST(json_schema_accepts_all_scenes_and_refuses_what_it_can_express)
{
    if (!has_module("jsonschema, yaml"))
        TEST_SKIP("needs python3-jsonschema and python3-yaml of /usr/bin/python3");
    char *mpm = g_build_filename(g_getenv("MPM_BIN"), "mpm", NULL);
    struct test_command command =
        test_command_run("/usr/bin/python3", "-B", "tests/scenes/editor/validate.py", mpm, NULL);
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    test_command_free(&command);
    g_free(mpm);
}
END_TEST

Suite *suite_completion(void)
{
    Suite *suite = suite_create("completion");
    TCase *completion = tcase_create("completion");
    tcase_add_loop_test(completion, a_shell_completes_commands_options_values_and_files, 0,
                        (int)G_N_ELEMENTS(shells));
    tcase_add_loop_test(completion, completion_has_every_option_of_every_command, 0,
                        (int)G_N_ELEMENTS(programs));
    tcase_add_test(completion, no_other_shell_is_completed);
    tcase_add_test(completion, progress_fits_into_any_terminal_and_colours_can_be_off);
    tcase_add_test(completion, json_schema_accepts_all_scenes_and_refuses_what_it_can_express);
    tcase_set_timeout(completion, 120);
    suite_add_tcase(suite, completion);
    return suite;
}
