/* Signals, closed streams and threads of the environment: `mpm run` from outside.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/blocks.h"
#include "support/command.h"
#include "support/folder.h"

#include <glib.h>
#include <string.h>

static struct {
    char *folder, *scene, *long_scene, *output;
} fixture;

/* Steps enough for a signal to come between two of them, whatever the machine. */
#define LONG_RUN TEST_BLOCKS_WITH("{end: 1e9, step: 1e-3}", "{history: 1}")

static void set_up(void)
{
    fixture.folder = test_folder_create();
    fixture.scene = test_folder_write(fixture.folder, "blocks.yaml", TEST_BLOCKS);
    fixture.long_scene = test_folder_write(fixture.folder, "long.yaml", LONG_RUN);
    fixture.output = test_folder_path(fixture.folder, "out");
}

static void tear_down(void)
{
    g_free(fixture.scene);
    g_free(fixture.long_scene);
    g_free(fixture.output);
    test_folder_remove(fixture.folder);
}

/* In a shell: "$mpm" is the program, "$scene", "$long" and "$out" are the paths. */
static struct test_command in_shell(const char *script)
{
    const char *const folder = g_getenv("MPM_BIN");
    char *const program =
        g_build_filename(folder != NULL ? folder : "build/release/bin", "mpm", NULL);
    char *const absolute = g_canonicalize_filename(program, NULL);
    char *const whole = g_strconcat("mpm=$1 scene=$2 long=$3 out=$4\n", script, NULL);
    const struct test_command command =
        test_command_run("/bin/sh", "-c", whole, "sh", absolute, fixture.scene, fixture.long_scene,
                         fixture.output, NULL);
    g_free(whole);
    g_free(absolute);
    g_free(program);
    return command;
}

/* Waits for the first row of the history: the signal is awaited from before that on. */
#define START_LONG_RUN                                                                             \
    "\"$mpm\" run --quiet --threads 1 --output \"$out\" \"$long\" &\n"                             \
    "run=$!\n"                                                                                     \
    "until [ \"$(wc -l < \"$out/history.csv\")\" -ge 3 ]; do sleep 0.01; done 2> /dev/null\n"

static const struct {
    const char *name;
    int number;
} asking[] = {{"INT", 2}, {"TERM", 15}, {"XCPU", 24}};

START_TEST(a_signal_ends_a_run_with_a_checkpoint)
{
    char *const script = g_strdup_printf(START_LONG_RUN "kill -%s $run\n"
                                                        "wait $run; echo $?\n"
                                                        "cat \"$out/run.json\"; ls \"$out\"\n",
                                         asking[_i].name);
    struct test_command command = in_shell(script);
    char *const status = g_strdup_printf("%d\n", 128 + asking[_i].number);
    char *const recorded = g_strdup_printf("\"exit_status\": %d", 128 + asking[_i].number);
    ck_assert_msg(g_str_has_prefix(command.output, status), "%s%s", command.output, command.errors);
    ck_assert(strstr(command.output, recorded) != NULL);
    ck_assert(strstr(command.output, "\"outcome\": \"interrupted\"") != NULL);
    ck_assert(strstr(command.output, "checkpoint.h5\n") != NULL);
    ck_assert(strstr(command.output, "run.lock") == NULL);
    ck_assert(strstr(command.errors, "--resume goes on from there") != NULL);
    g_free(recorded);
    g_free(status);
    g_free(script);
    test_command_free(&command);
}
END_TEST

/* Both come before the next step ends. */
START_TEST(a_second_signal_ends_a_run_at_once)
{
    struct test_command command = in_shell(START_LONG_RUN "kill -STOP $run\n"
                                                          "kill -TERM $run; kill -INT $run\n"
                                                          "kill -CONT $run\n"
                                                          "wait $run; echo $?; ls \"$out\"\n");
    ck_assert_msg(g_str_has_prefix(command.output, "130\n") ||
                      g_str_has_prefix(command.output, "143\n"),
                  "%s%s", command.output, command.errors);
    ck_assert(strstr(command.output, "run.json") == NULL);
    test_command_free(&command);
}
END_TEST

START_TEST(a_run_that_was_killed_leaves_a_folder_that_can_be_written_to)
{
    struct test_command command =
        in_shell(START_LONG_RUN "\"$mpm\" run --quiet --overwrite --output \"$out\" "
                                "\"$scene\"; echo $?\n"
                                "kill -KILL $run; wait $run\n"
                                "\"$mpm\" run --quiet --overwrite --output \"$out\" "
                                "\"$scene\"; echo $?\n"
                                "ls \"$out\"\n");
    ck_assert_msg(g_str_has_prefix(command.output, "2\n0\n"), "%s%s", command.output,
                  command.errors);
    ck_assert(strstr(command.errors, "another run writes to") != NULL);
    ck_assert(strstr(command.output, "run.lock") == NULL);
    test_command_free(&command);
}
END_TEST

/* The results are in files, and the status is that of run.json. */
START_TEST(closed_streams_change_neither_results_nor_status)
{
    static const char *const streams[] = {">&-", "> /dev/null 2>&-", ">&- 2>&-", "<&- >&- 2>&-",
                                          "> /dev/full"};
    char *const script = g_strdup_printf(
        "\"$mpm\" run --threads 1 --output \"$out-1\" \"$scene\" > /dev/null 2>&1 || exit\n"
        "\"$mpm\" run --threads 1 --output \"$out-2\" \"$scene\" %s; echo $?\n"
        "grep -c '\"exit_status\": 0' \"$out-2/run.json\"\n"
        "cmp \"$out-1/history.csv\" \"$out-2/history.csv\" && echo same\n",
        streams[_i]);
    struct test_command command = in_shell(script);
    ck_assert_msg(strcmp(command.output, "0\n1\nsame\n") == 0, "%s: %s%s", streams[_i],
                  command.output, command.errors);
    g_free(script);
    test_command_free(&command);
}
END_TEST

static const struct {
    const char *value;
    int status;
} numbers[] = {{"1", 0},   {"2,1", 0}, {" 2 ", 0},  {"0", 2},   {"-1", 2}, {"two", 2},
               {"1.5", 2}, {"", 2},    {"1025", 2}, {"2;1", 2}, {",", 2},  {"99999999999", 2}};

START_TEST(omp_num_threads_is_read_as_strictly_as_the_option)
{
    char *const script =
        g_strdup_printf("OMP_NUM_THREADS='%s' \"$mpm\" check \"$scene\" > /dev/null; echo $?\n"
                        "OMP_NUM_THREADS='%s' \"$mpm\" check --threads 1 \"$scene\" > /dev/null\n"
                        "echo $?; OMP_NUM_THREADS='%s' \"$mpm\" info > /dev/null; echo $?\n",
                        numbers[_i].value, numbers[_i].value, numbers[_i].value);
    char *const expected = g_strdup_printf("%d\n0\n0\n", numbers[_i].status);
    struct test_command command = in_shell(script);
    ck_assert_msg(strcmp(command.output, expected) == 0, "'%s': %s%s", numbers[_i].value,
                  command.output, command.errors);
    ck_assert((strstr(command.errors, "OMP_NUM_THREADS: '") != NULL) == (numbers[_i].status != 0));
    g_free(expected);
    g_free(script);
    test_command_free(&command);
}
END_TEST

START_TEST(resume_and_overwrite_exclude_each_other)
{
    struct test_command command =
        in_shell("\"$mpm\" run --resume --overwrite --output \"$out\" \"$scene\"; echo $?\n");
    ck_assert_str_eq(command.output, "2\n");
    ck_assert(strstr(command.errors, "--resume and --overwrite") != NULL);
    test_command_free(&command);
}
END_TEST

Suite *suite_interruption(void)
{
    Suite *suite = suite_create("interruption");
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, set_up, tear_down);
    tcase_add_loop_test(runs, a_signal_ends_a_run_with_a_checkpoint, 0, G_N_ELEMENTS(asking));
    tcase_add_test(runs, a_second_signal_ends_a_run_at_once);
    tcase_add_test(runs, a_run_that_was_killed_leaves_a_folder_that_can_be_written_to);
    tcase_add_loop_test(runs, closed_streams_change_neither_results_nor_status, 0, 5);
    tcase_add_loop_test(runs, omp_num_threads_is_read_as_strictly_as_the_option, 0,
                        G_N_ELEMENTS(numbers));
    tcase_add_test(runs, resume_and_overwrite_exclude_each_other);
    suite_add_tcase(suite, runs);
    return suite;
}
