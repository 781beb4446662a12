/* The command mpm from outside: what it accepts, prints and returns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/skip.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

static struct {
    char *folder, *scene, *unstable, *output;
} fixture;

static void set_up(void)
{
    fixture.folder = test_folder_create();
    fixture.scene = test_folder_write(fixture.folder, "blocks.yaml", TEST_BLOCKS);
    fixture.unstable = test_folder_write(fixture.folder, "unstable.yaml", TEST_BLOCKS_UNSTABLE);
    fixture.output = test_folder_path(fixture.folder, "results");
}

static void tear_down(void)
{
    g_free(fixture.scene);
    g_free(fixture.unstable);
    g_free(fixture.output);
    test_folder_remove(fixture.folder);
    memset(&fixture, 0, sizeof fixture);
}

/* One line on stderr that begins with the program's name, nothing on stdout. */
static void check_error(const struct test_command *command, const char *said)
{
    ck_assert_str_eq(command->output, "");
    ck_assert_msg(g_str_has_prefix(command->errors, "mpm: "), "said: %s", command->errors);
    ck_assert_msg(strchr(command->errors, '\n') == command->errors + strlen(command->errors) - 1,
                  "not one line: %s", command->errors);
    ck_assert_msg(strstr(command->errors, said) != NULL, "'%s' is not in: %s", said,
                  command->errors);
}

/* The command in a shell: "$1" is the program, "$2" the scene, "$3" the output folder. */
static struct test_command run_in_shell(const char *script)
{
    char *program = g_build_filename(
        g_getenv("MPM_BIN") ? g_getenv("MPM_BIN") : "build/release/bin", "mpm", NULL);
    char *absolute = g_canonicalize_filename(program, NULL);
    struct test_command command = test_command_run("/bin/sh", "-c", script, "sh", absolute,
                                                   fixture.scene, fixture.output, NULL);
    g_free(absolute);
    g_free(program);
    return command;
}

/* ------------------------------------------------------------------- usage */

/* SCENE stands for a good scene file, OUT for a folder that is not there. */
static const struct bad_line {
    const char *arguments[6];
    const char *said;
} bad_lines[] = {
    {{NULL}, "a command is missing"},
    {{""}, "unknown command \"\""},
    {{"rum"}, "unknown command \"rum\""},
    {{"run me"}, "unknown command \"run me\""},
    {{"two\nlines"}, "unknown command \"two?lines\""},
    {{"--bogus"}, "unknown command \"--bogus\""},
    {{"rum"}, "; did you mean run?; see 'mpm --help'"},
    {{"run", "--outptu", "OUT"}, "unknown option --outptu; did you mean --output?; see"},
    {{"run", "--outptu=OUT"}, "did you mean --output?"},
    {{"run"}, "SCENE is missing"},
    {{"check"}, "SCENE is missing"},
    {{"run", "SCENE", "more"}, "unexpected argument \"more\""},
    {{"check", "SCENE", "more"}, "unexpected argument \"more\""},
    {{"info", "more"}, "unexpected argument \"more\""},
    {{"schema", "more"}, "unexpected argument \"more\""},
    {{"run", "--bogus", "SCENE"}, "--bogus"},
    {{"info", "--threads", "1"}, "--threads"},
    {{"check", "SCENE", "--threads", "0"}, "'0' is not a whole number from 1 to 1024"},
    {{"info", "--set", "a=1"}, "--set"},
    {{"run", "SCENE", "--output"}, "run: --output: DIR is missing; see 'mpm run --help'"},
    {{"run", "SCENE", "-q", "-o"}, "run: --output: DIR is missing; see"},
    {{"run", "SCENE", "--threads"}, "run: --threads: N is missing; see"},
    {{"run", "SCENE", "--set"}, "run: --set: PATH=VALUE is missing; see"},
    {{"run", ""}, "run: SCENE is empty; see 'mpm run --help'"},
    {{"new", "--list", "--names"}, "new: allowed: one of --list and --names; see"},
    {{"new", ""}, "new: KIND is empty; see 'mpm new --help'"},
    {{"help", "run", "more"}, "help: unexpected argument \"more\"; see 'mpm --help'"},
    {{"completion", "bash", "more"}, "completion: unexpected argument \"more\""},
    {{"--version", "more"}, "--version: unexpected argument \"more\""},
    {{"--help", "more"}, "--help: unexpected argument \"more\""},
    {{"run", "SCENE", "--output", ""}, "run: --output: DIR is empty; see 'mpm run --help'"},
    {{"run", "SCENE", "--output="}, "run: --output: DIR is empty; see"},
    {{"run", "SCENE", "-o", ""}, "run: --output: DIR is empty; see"},
    {{"run", "SCENE", "-o="}, "run: --output: DIR is empty; see"},
    {{"run", "SCENE", "--set", ""}, "run: --set: PATH=VALUE is empty; see"},
    {{"run", "SCENE", "-qo"}, "run: --output: DIR is missing; see"},
    {{"run", "SCENE", "-qx", "-oOUT"}, "run: unknown option -qx; see"},
    {{"run", "SCENE", "-oOUT", "-oOUT"}, "run: --output is given twice"},
    {{"run", "SCENE", "-q=1"}, "run: no value is allowed: -q=1; see"},
    {{"run", "SCENE", "--help=1"}, "run: no value is allowed: --help=1; see"},
    {{"run", "--", "-oOUT"}, "-oOUT: No such file"},
    {{"run", "SCENE", "--output", "SCENE"}, "is a file"},
    {{"run", "SCENE", "--threads", "0"}, "'0' is not a whole number from 1 to 1024"},
    {{"run", "SCENE", "--threads", "-1"}, "'-1' is not a whole number"},
    {{"run", "SCENE", "--threads", "1.5"}, "'1.5' is not a whole number"},
    {{"run", "SCENE", "--threads", "two"}, "'two' is not a whole number"},
    {{"run", "SCENE", "--threads", ""}, "--threads: N is empty"},
    {{"run", "SCENE", "--threads", "1025"}, "'1025' is not a whole number"},
    {{"run", "SCENE", "--threads", "99999999999999999999"}, "is not a whole number"},
    {{"run", "SCENE", "--resume", "--output", "OUT"}, "there is no checkpoint in"},
    {{"run", "SCENE", "--set", "nonsense"}, "nonsense"},
    {{"run", "--output", "OUT", "-o", "OUT"}, "run: --output is given twice; allowed: once; see"},
    {{"run", "SCENE", "-q", "--quiet"}, "run: --quiet is given twice"},
    {{"check", "SCENE", "--simd", "auto", "--simd=auto"}, "check: --simd is given twice"},
    {{"run", "SCENE", "--quiet=1"}, "run: no value is allowed: --quiet=1; see"},
    {{"help", "rum"}, "unknown command \"rum\""},
    {{"run", "SCENE", "--kernels"}, "--kernels"},
    {{"run", "SCENE", "--kernels", "quick"},
     "run: --kernels \"quick\"; allowed: "
     "auto, reference, fast; see"},
    {{"run", "SCENE", "--kernels", "Fast"},
     "--kernels \"Fast\"; allowed: auto, reference, fast; did you mean fast?"},
    {{"run", "SCENE", "--kernels", ""}, "--kernels \"\"; allowed"},
    {{"check", "SCENE", "--kernels", "quick"}, "allowed: auto, reference, fast"},
    {{"run", "SCENE", "--simd", "avx"},
     "--simd \"avx\"; allowed: auto, "
     "baseline, x86-64-v3"},
    {{"check", "SCENE", "--simd", "avx"}, "allowed: auto, baseline, x86-64-v3"},
    {{"info", "--kernels", "auto"}, "--kernels"},
    {{"check", "SCENE", "--set", "no.such.key=1"}, "no"},
    {{"check", "SCENE", "--set", "time.courant=nan"}, "courant"},
    {{"run", "no-such-file.yaml"}, "no-such-file.yaml"},
    {{"check", "no-such-file.yaml"}, "no-such-file.yaml"},
    {{"check", "/"}, "/"},
};

static const char *filled(const char *argument)
{
    if (argument != NULL && strcmp(argument, "SCENE") == 0)
        return fixture.scene;
    return argument != NULL && strcmp(argument, "OUT") == 0 ? fixture.output : argument;
}

START_TEST(a_bad_command_line_is_refused_in_one_line)
{
    const struct bad_line *line = &bad_lines[_i];
    const char *words[G_N_ELEMENTS(line->arguments)];
    for (size_t i = 0; i < G_N_ELEMENTS(words); i++)
        words[i] = filled(line->arguments[i]);
    struct test_command command =
        test_command_run("mpm", words[0], words[1], words[2], words[3], words[4], words[5], NULL);
    ck_assert_int_eq(command.exit_status, MPM_BAD_INPUT);
    check_error(&command, line->said);
    ck_assert(!test_file_exists(fixture.output));
    test_command_free(&command);
}
END_TEST

START_TEST(help_and_version_end_well)
{
    static const struct {
        const char *arguments[2], *said;
    } lines[] = {
        {{"--help", NULL}, "Exit status"},  {{"-h", NULL}, "Usage"},
        {{"--version", NULL}, "mpm "},      {{"run", "--help"}, "--overwrite"},
        {{"run", "--help"}, "--kernels"},   {{"check", "--help"}, "--simd"},
        {{"check", "--help"}, "--set"},     {{"info", "-h"}, "Usage"},
        {{"schema", "--help"}, "Usage"},    {{"help", NULL}, "Exit status"},
        {{"help", "run"}, "--overwrite"},   {{"help", "--help"}, "mpm help [COMMAND]"},
        {{"help", "-h"}, "this list"},      {{"completion", "-h"}, "mpm completion SHELL"},
        {{"completion", "--help"}, "bash"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(lines); i++) {
        struct test_command command =
            test_command_run("mpm", lines[i].arguments[0], lines[i].arguments[1], NULL);
        ck_assert_int_eq(command.exit_status, MPM_OK);
        ck_assert_str_eq(command.errors, "");
        ck_assert(strstr(command.output, lines[i].said) != NULL);
        test_command_free(&command);
    }
}
END_TEST

START_TEST(info_tells_what_the_binary_is_made_of)
{
    static const char *const names[] = {"version", "revision",  "compiler",
                                        "flags",   "libraries", "simd"};
    struct test_command command = test_command_run("mpm", "info", NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        ck_assert(strstr(command.output, names[i]) != NULL);
    ck_assert(strstr(command.output, mpm_build_info()->revision) != NULL);
    char *simd = g_strdup_printf("\nsimd       %s\n", mpm_build_info()->simd);
    ck_assert(strstr(command.output, simd) != NULL);
    g_free(simd);
    test_command_free(&command);
}
END_TEST

START_TEST(schema_names_the_required_keys)
{
    static const char *const keys[] = {"format", "geometry", "grid", "time", "materials", "bodies"};
    struct test_command command = test_command_run("mpm", "schema", NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        ck_assert(strstr(command.output, keys[i]) != NULL);
    test_command_free(&command);
}
END_TEST

START_TEST(check_prints_the_cost_and_writes_nothing)
{
    static const char *const names[] = {
        "particles  60",
        "cells      96",
        "memory",
        "time step  0.0219089 ms",
        "steps",
        "kernels    reference (",
        "simd       none",
        "threads    1 (of 3 allowed: 60 particles, one more thread for each 4096)\n"};
    struct test_command command = test_command_run("mpm", "check", "--kernels", "reference",
                                                   "--threads", "3", fixture.scene, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    ck_assert_str_eq(command.errors, "");
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        ck_assert_msg(strstr(command.output, names[i]) != NULL, "no %s in: %s", names[i],
                      command.output);
    test_command_free(&command);
}
END_TEST

/* What the command prints is what the library chooses. */
START_TEST(check_tells_the_kernels_and_why)
{
    static const struct {
        const char *name;
        enum mpm_kernels kernels;
    } sets[] = {{"auto", MPM_KERNELS_AUTO}, {"reference", MPM_KERNELS_REFERENCE}};
    for (size_t i = 0; i < G_N_ELEMENTS(sets); i++) {
        struct mpm_scene *scene = NULL;
        struct mpm_plan plan;
        const struct mpm_simulation_options options = {.threads = 1, .kernels = sets[i].kernels};
        ck_assert_int_eq(mpm_scene_read(fixture.scene, NULL, 0, &scene, NULL), MPM_OK);
        ck_assert_int_eq(mpm_scene_plan(scene, &options, &plan, NULL), MPM_OK);
        if (strcmp(plan.kernels, "fast") == 0)
            ck_assert_str_eq(plan.simd, mpm_build_info()->simd);
        char *expected = g_strdup_printf("\nkernels    %s (%s)\nsimd       %s\n", plan.kernels,
                                         plan.kernels_reason, plan.simd);
        struct test_command command =
            test_command_run("mpm", "check", fixture.scene, "--kernels", sets[i].name, NULL);
        ck_assert_msg(strstr(command.output, expected) != NULL, "%s is not in: %s", expected,
                      command.output);
        test_command_free(&command);
        g_free(expected);
        mpm_scene_free(scene);
    }
}
END_TEST

/* --------------------------------------------------------------------- run */

START_TEST(a_pipe_sees_a_line_for_each_tenth_and_one_summary)
{
    struct test_command command =
        test_command_run("mpm", "run", fixture.scene, "--output", fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    char **lines = g_strsplit(g_strchomp(command.errors), "\n", -1);
    ck_assert_uint_eq(g_strv_length(lines), 10);
    for (gint64 i = 0; i < 10; i++)
        ck_assert_int_eq(g_ascii_strtoll(lines[i], NULL, 10), 10 * (i + 1));
    ck_assert(g_str_has_prefix(command.output, "done: "));
    ck_assert(strstr(command.output, fixture.output) != NULL);
    g_strfreev(lines);
    test_command_free(&command);
}
END_TEST

START_TEST(quiet_prints_nothing_but_errors)
{
    struct test_command command = test_command_run("mpm", "run", "--quiet", "--threads", "1",
                                                   fixture.scene, "--output", fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    ck_assert_str_eq(command.output, "");
    ck_assert_str_eq(command.errors, "");
    test_command_free(&command);
    command = test_command_run("mpm", "run", "--quiet", "--threads", "1", fixture.scene, "--output",
                               fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_BAD_INPUT);
    check_error(&command, "--overwrite");
    test_command_free(&command);
    command = test_command_run("mpm", "run", "--quiet", "--threads", "1", "--overwrite",
                               fixture.scene, "--output", fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    test_command_free(&command);
}
END_TEST

START_TEST(the_run_record_names_the_kernels_that_were_asked_for)
{
    struct test_command command =
        test_command_run("mpm", "run", "--quiet", "--threads", "1", "--kernels", "reference",
                         fixture.scene, "--output", fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    char *path = g_build_filename(fixture.output, "run.json", NULL);
    char *record = test_file_read(path);
    ck_assert(strstr(record, "\"kernels\": \"reference\"") != NULL);
    ck_assert(strstr(record, "\"simd\": \"none\"") != NULL);
    g_free(record);
    g_free(path);
    test_command_free(&command);
}
END_TEST

START_TEST(results_go_by_default_to_a_folder_named_after_the_scene)
{
    struct test_command command =
        run_in_shell("cd \"$(dirname \"$2\")\" && exec \"$1\" run --quiet --threads 1 blocks.yaml");
    ck_assert_msg(command.exit_status == MPM_OK, "%s", command.errors);
    char *record = g_build_filename(fixture.folder, "blocks-results", "run.json", NULL);
    ck_assert(test_file_exists(record));
    g_free(record);
    test_command_free(&command);
}
END_TEST

/* Every snapshot, the list and the history; run.json holds times, threads and instructions.
 * Refined, so that there are particles enough for three workers. */
START_TEST(any_number_of_threads_and_any_simd_give_the_same_bytes)
{
    struct test_command command = run_in_shell(
        "run() { folder=$1; shift; "
        "\"$mpm\" run -q -o \"$folder\" --set grid.refine=12 --set time.steps=40 \"$@\" "
        "\"$scene\" || exit; }\n"
        "mpm=$1 scene=$2 out=$3\n"
        "for k in reference auto; do\n"
        "  for n in 1 2 3; do OMP_NUM_THREADS=$n run \"$out-$k-$n\" --kernels $k; done\n"
        "  run \"$out-$k-4\" --kernels $k --threads 4\n"
        "  run \"$out-$k-5\" --kernels $k --threads 2 --simd baseline\n"
        "  for n in 2 3 4 5; do for f in \"$out-$k-1\"/p* \"$out-$k-1\"/h*; do\n"
        "    cmp \"$f\" \"$out-$k-$n/${f##*/}\" || exit; done; done\n"
        "  ls \"$out-$k-1\" | grep -c 'particles-.*hdf$'\n"
        "done");
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    ck_assert_str_eq(command.output, "2\n2\n");
    test_command_free(&command);
}
END_TEST

/* The folder that a value attached to its letter names, alone, after flags and with '='. */
START_TEST(a_short_option_may_have_its_value_attached)
{
    static const char *const forms[][3] = {{"-q", "-oA"},   {"-qoA", NULL}, {"-q", "-o=A"},
                                           {"-qo=A", NULL}, {"-qo", "A"},   {"-q", "-o-A", "-A"}};
    char *const before = g_get_current_dir(), *const there = test_folder_create();
    ck_assert_int_eq(g_chdir(there), 0);
    for (size_t k = 0; k < G_N_ELEMENTS(forms); k++) {
        const char *const name = forms[k][2] != NULL ? forms[k][2] : "A";
        struct test_command command =
            test_command_run("mpm", "new", "bar", forms[k][0], forms[k][1], NULL);
        ck_assert_msg(command.exit_status == 0, "%zu: %s", k, command.errors);
        ck_assert_msg(g_unlink(name) == 0, "%zu: no %s", k, name);
        test_command_free(&command);
    }
    ck_assert_int_eq(g_chdir(before), 0);
    test_folder_remove(there);
    g_free(before);
}
END_TEST

START_TEST(a_run_that_blows_up_ends_with_3_and_says_where)
{
    struct test_command command =
        test_command_run("mpm", "run", "--quiet", "--threads", "1", fixture.unstable, "--output",
                         fixture.output, NULL);
    ck_assert_int_eq(command.exit_status, MPM_RUN_FAILED);
    check_error(&command, "step");
    char *record = g_build_filename(fixture.output, "run.json", NULL);
    ck_assert(test_file_exists(record));
    g_free(record);
    test_command_free(&command);
}
END_TEST

/* USL with uGIMP kept small motions bounded up to 0.567 in case G1; 0.4 is within all. */
START_TEST(a_courant_number_beyond_the_measured_limit_is_warned_of_and_taken)
{
    static const char *const courants[] = {"time.courant=0.4", "time.courant=1"};
    for (int beyond = 0; beyond < 2; beyond++) {
        struct test_command command = test_command_run("mpm", "check", fixture.scene, "--set",
                                                       "method={shape: ugimp, stress_update: usl}",
                                                       "--set", courants[beyond], NULL);
        ck_assert_int_eq(command.exit_status, MPM_OK);
        ck_assert(strstr(command.output, "case G1 has limits of 0.567 in small motions, 0.823 in "
                                         "large ones") != NULL);
        ck_assert((strstr(command.output, "warning    Courant number 1 is above") != NULL) ==
                  (beyond == 1));
        test_command_free(&command);
        command =
            test_command_run("mpm", "run", "--threads", "1", "--overwrite", fixture.scene, "--set",
                             "method={shape: ugimp, stress_update: usl}", "--set", courants[beyond],
                             "--set", "time.steps=2", "--output", fixture.output, NULL);
        ck_assert_int_eq(command.exit_status, MPM_OK);
        ck_assert((strstr(command.errors, "mpm: warning: Courant number 1 is above") != NULL) ==
                  (beyond == 1));
        char *path = g_build_filename(fixture.output, "run.json", NULL);
        char *record = test_file_read(path);
        ck_assert((strstr(record, "Courant number 1 is above the largest one, 0.567,") != NULL) ==
                  (beyond == 1));
        g_free(record);
        g_free(path);
        test_command_free(&command);
    }
}
END_TEST

START_TEST(no_infinity_is_printed_for_a_run_that_has_no_end)
{
    struct test_command command = test_command_run("mpm", "check", fixture.scene, "--set",
                                                   "time.end=1e308", "--set", "output={}", NULL);
    ck_assert_int_eq(command.exit_status, MPM_BAD_INPUT);
    check_error(&command, "time.end: 1e+308 takes more than 9.01e+15 time steps");
    ck_assert(strstr(command.output, "inf") == NULL && strstr(command.errors, "inf") == NULL);
    test_command_free(&command);
}
END_TEST

START_TEST(a_folder_that_cannot_be_written_ends_with_4)
{
    char *below = test_folder_path(fixture.scene, "below-a-file");
    struct test_command command = test_command_run("mpm", "run", "--quiet", "--threads", "1",
                                                   fixture.scene, "--output", below, NULL);
    ck_assert_int_eq(command.exit_status, MPM_ENVIRONMENT_FAILED);
    check_error(&command, below);
    g_free(below);
    test_command_free(&command);
}
END_TEST

/* The shell's limit is in blocks of 512 bytes: the first snapshot does not fit. */
START_TEST(a_full_disk_ends_with_4_and_names_the_state)
{
    if (TEST_UNDER_TSAN)
        TEST_SKIP("the thread sanitizer's own memory does not bear a limit on file sizes");
    struct test_command command =
        run_in_shell("ulimit -f 16; exec \"$1\" run --quiet --threads 1 \"$2\" --output \"$3\"");
    ck_assert_int_eq(command.exit_status, MPM_ENVIRONMENT_FAILED);
    check_error(&command, "last complete snapshot: none");
    test_command_free(&command);
}
END_TEST

START_TEST(standard_output_that_is_full_or_gone_is_no_crash)
{
    struct test_command command = run_in_shell("exec \"$1\" schema > /dev/full");
    ck_assert_int_eq(command.exit_status, MPM_ENVIRONMENT_FAILED);
    check_error(&command, "standard output");
    test_command_free(&command);
    command = run_in_shell("{ sleep 0.2; \"$1\" schema; echo $? >&2; } | true");
    ck_assert_str_eq(command.errors, "0\n");
    test_command_free(&command);
}
END_TEST

Suite *suite_cli(void)
{
    Suite *suite = suite_create("cli");
    TCase *usage = tcase_create("usage");
    tcase_add_checked_fixture(usage, set_up, tear_down);
    tcase_add_loop_test(usage, a_bad_command_line_is_refused_in_one_line, 0,
                        (int)G_N_ELEMENTS(bad_lines));
    tcase_add_test(usage, help_and_version_end_well);
    tcase_add_test(usage, info_tells_what_the_binary_is_made_of);
    tcase_add_test(usage, schema_names_the_required_keys);
    tcase_add_test(usage, check_prints_the_cost_and_writes_nothing);
    tcase_add_test(usage, check_tells_the_kernels_and_why);
    suite_add_tcase(suite, usage);
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, set_up, tear_down);
    tcase_add_test(runs, a_pipe_sees_a_line_for_each_tenth_and_one_summary);
    tcase_add_test(runs, quiet_prints_nothing_but_errors);
    tcase_add_test(runs, the_run_record_names_the_kernels_that_were_asked_for);
    tcase_add_test(runs, results_go_by_default_to_a_folder_named_after_the_scene);
    tcase_add_test(runs, any_number_of_threads_and_any_simd_give_the_same_bytes);
    tcase_add_test(runs, a_short_option_may_have_its_value_attached);
    tcase_add_test(runs, a_run_that_blows_up_ends_with_3_and_says_where);
    tcase_add_test(runs, a_courant_number_beyond_the_measured_limit_is_warned_of_and_taken);
    tcase_add_test(runs, no_infinity_is_printed_for_a_run_that_has_no_end);
    tcase_add_test(runs, a_folder_that_cannot_be_written_ends_with_4);
    tcase_add_test(runs, a_full_disk_ends_with_4_and_names_the_state);
    tcase_add_test(runs, standard_output_that_is_full_or_gone_is_no_crash);
    suite_add_tcase(suite, runs);
    return suite;
}
