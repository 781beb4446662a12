/* Running the commands of mpm-verify.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/verify.h"

#include "support/catalogue.h"
#include "support/folder.h"

#include "support/marks.h"
#include "verification/cli/commands.h"

#include <glib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char *rest_of(FILE *file)
{
    const long length = ftell(file);
    char *text = g_malloc0((size_t)length + 1);
    rewind(file);
    ck_assert_uint_eq(fread(text, 1, (size_t)length, file), (size_t)length);
    ck_assert_int_eq(fclose(file), 0);
    return text;
}

struct test_said test_verify(const char *line)
{
    char **argv = g_strsplit(line, " ", -1);
    FILE *out = tmpfile(), *err = tmpfile();
    ck_assert(out != NULL && err != NULL);
    const struct suite_world world = {out, err, false, test_programs()};
    struct test_said said = {suite_command((int)g_strv_length(argv), argv, &world), NULL, NULL};
    said.out = rest_of(out);
    said.err = rest_of(err);
    g_strfreev(argv);
    return said;
}

struct test_said test_verify_with(const char *format, const char *one, const char *other)
{
    char **parts = g_strsplit(format, "@", 3);
    char *line = g_strconcat(parts[0], one, parts[1], parts[2] == NULL ? "" : other,
                             parts[2] == NULL ? "" : parts[2], NULL);
    const struct test_said said = test_verify(line);
    g_free(line);
    g_strfreev(parts);
    return said;
}

pid_t test_in_process(int (*act)(const char *one, const char *other), const char *one,
                      const char *other)
{
    (void)fflush(NULL);
    const pid_t process = fork();
    ck_assert_int_ge(process, 0);
    if (process == 0)
        _exit(act(one, other));
    return process;
}

int test_exit_status(pid_t process)
{
    int state = 0;
    ck_assert_int_eq(waitpid(process, &state, 0), process);
    return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

int test_run_all(const char *catalogue, const char *output)
{
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    const int exit_status = said.exit_status;
    test_said_free(&said);
    return exit_status;
}

void test_wait_for(const char *folder, const char *name)
{
    char *path = test_folder_path(folder, name);
    for (int i = 0; i < 2000 && !g_file_test(path, G_FILE_TEST_EXISTS); i++)
        g_usleep(5000);
    ck_assert_msg(g_file_test(path, G_FILE_TEST_EXISTS), "%s", path);
    g_free(path);
}

void test_said_free(struct test_said *said)
{
    g_free(said->out);
    g_free(said->err);
}

const char *test_last_line(char *text)
{
    g_strchomp(text);
    const char *newline = strrchr(text, '\n');
    return newline == NULL ? text : newline + 1;
}

const struct test_behaviour test_behaviours[TEST_BEHAVIOURS] = {
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

char *test_misbehaving_catalogue(void)
{
    char *folder = test_folder_create();
    for (size_t i = 0; i < TEST_BEHAVIOURS; i++) {
        const char *program = test_behaviours[i].program;
        char *text = test_case_text(program, program);
        if (test_behaviours[i].status == VERDICT_EXPECTED_FAIL) {
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

void test_assert_well_formed(const char *text, const char *what)
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

char *test_folder_read(const char *folder, const char *name)
{
    char *path = test_folder_path(folder, name);
    char *text = test_file_read(path);
    g_free(path);
    return text;
}
