/* Counted instructions and their budget.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/budget/budget_command.h"
#include "suites.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/skip.h"

#include <string.h>

/* ------------------------------------------------------------------- verdicts */

static const struct {
    double measured, stored, tolerance;
    enum budget_verdict verdict;
} judgements[] = {
    {100.0, 100.0, 0.03, BUDGET_KEPT},
    {102.9, 100.0, 0.03, BUDGET_KEPT},
    {103.1, 100.0, 0.03, BUDGET_EXCEEDED},
    {1000.0, 100.0, 0.03, BUDGET_EXCEEDED},
    {97.1, 100.0, 0.03, BUDGET_KEPT},
    {96.9, 100.0, 0.03, BUDGET_BETTER},
    {0.0, 100.0, 0.03, BUDGET_BETTER},
    {251.0, 250.0, BUDGET_BYTES_TOLERANCE, BUDGET_EXCEEDED}, /* a particle grown by one byte */
    {250.1, 250.0, BUDGET_BYTES_TOLERANCE, BUDGET_KEPT},
    {0.0, 0.0, 0.03, BUDGET_KEPT},
    {1e-9, 0.0, 0.03, BUDGET_EXCEEDED},
    {(double)NAN, 100.0, 0.03, BUDGET_EXCEEDED},
    {100.0, (double)NAN, 0.03, BUDGET_EXCEEDED},
    {(double)INFINITY, 100.0, 0.03, BUDGET_EXCEEDED},
};

START_TEST(a_figure_is_red_above_its_budget_and_tolerance_only)
{
    ck_assert_int_eq(
        budget_judge(judgements[_i].measured, judgements[_i].stored, judgements[_i].tolerance),
        judgements[_i].verdict);
}
END_TEST

START_TEST(each_figure_has_the_tolerance_that_is_promised)
{
    ck_assert_double_eq(budget_figures[BUDGET_INSTRUCTIONS].tolerance, 0.03);
    ck_assert_double_eq(budget_figures[BUDGET_BRANCHES].tolerance, 0.015);
    ck_assert_double_eq(budget_figures[BUDGET_BYTES].tolerance, 0.002);
}
END_TEST

/* ------------------------------------------------------------------- the file */

static const struct budget_build build = {"gcc 12", "x86_64", "-O3"};

START_TEST(a_budget_is_read_back_as_it_was_stored)
{
    char *folder = test_folder_create(), *path = test_folder_path(folder, BUDGET_FILE);
    const struct budget_cost cost = {{123.5, 4.25, 246.75}, "fast", "x86-64-v3"};
    struct budget written = budget_make(&build), read;
    budget_store(&written, "a run", &cost);
    ck_assert_int_eq(budget_write(path, &written, NULL), MPM_OK);
    ck_assert_int_eq(budget_read(path, &read, NULL), MPM_OK);

    struct budget_cost found;
    ck_assert_str_eq(read.build.compiler, build.compiler);
    ck_assert_str_eq(read.build.architecture, build.architecture);
    ck_assert_str_eq(read.build.flags, build.flags);
    ck_assert(budget_find(&read, "a run", &found));
    for (size_t i = 0; i < BUDGET_FIGURES; i++)
        ck_assert_double_eq(found.figures[i], cost.figures[i]);
    ck_assert_str_eq(found.kernels, cost.kernels);
    ck_assert_str_eq(found.simd, cost.simd);
    ck_assert(!budget_find(&read, "another run", &found));
    budget_clear(&written);
    budget_clear(&read);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

#define BUILD_KEYS "\"compiler\": \"gcc 12\", \"architecture\": \"x86_64\", \"flags\": \"\""

static const struct {
    const char *text, *said;
} wrong_files[] = {
    {"", "budget.json:1: "},
    {"{", "budget.json:1: "},
    {"[]", "Expected object"},
    {"{" BUILD_KEYS "}", "Object item not found: runs"},
    {"{" BUILD_KEYS ", \"runs\": {}, \"more\": 1}", "more"},
    {"{" BUILD_KEYS ", \"runs\": {\"a\": {}}}", "runs: \"a\": Object item not found: kernels"},
    {"{" BUILD_KEYS ", \"runs\": {\"a\": {\"kernels\": \"fast\", \"simd\": \"baseline\", "
     "\"instructions\": \"1\", \"branches\": 1, \"bytes\": 1}}}",
     "Expected real or integer"},
};

START_TEST(a_file_that_is_not_a_budget_is_refused_with_its_place)
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, BUDGET_FILE, wrong_files[_i].text);
    struct budget budget;
    struct mpm_error error;
    ck_assert_int_eq(budget_read(path, &budget, &error), MPM_BAD_INPUT);
    test_contains(error.message, wrong_files[_i].said);
    test_contains(error.message, BUDGET_FILE);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_missing_budget_file_is_named)
{
    struct budget budget;
    struct mpm_error error;
    ck_assert_int_eq(budget_read("no/such/budget.json", &budget, &error), MPM_BAD_INPUT);
    test_contains(error.message, "no/such/budget.json");
}
END_TEST

START_TEST(every_run_has_a_stored_budget_and_every_budget_a_run)
{
    struct budget budget;
    ck_assert_int_eq(budget_read("benchmarks/" BUDGET_FILE, &budget, NULL), MPM_OK);
    for (size_t i = 0; i < budget_runs_count; i++) {
        struct budget_cost cost;
        ck_assert_msg(budget_find(&budget, budget_runs[i].name, &cost), "%s", budget_runs[i].name);
    }
    ck_assert_uint_eq(json_object_size(budget.runs), budget_runs_count);
    budget_clear(&budget);
}
END_TEST

START_TEST(a_budget_holds_for_one_compiler_and_architecture)
{
    const struct budget_build other_compiler = {"clang 14", "x86_64", "-O3"},
                              other_machine = {"gcc 12", "aarch64", "-O3"};
    ck_assert_ptr_null(budget_reason_to_skip(&build, &build));
    char *compiler = budget_reason_to_skip(&build, &other_compiler);
    char *machine = budget_reason_to_skip(&build, &other_machine);
    ck_assert_str_eq(compiler, "budget: skipped: stored for gcc 12 on x86_64; this is clang 14 on "
                               "x86_64");
    ck_assert_str_eq(machine, "budget: skipped: stored for gcc 12 on x86_64; this is gcc 12 on "
                              "aarch64");
    g_free(compiler);
    g_free(machine);
}
END_TEST

START_TEST(minor_versions_of_the_compiler_share_a_budget)
{
    const struct budget_build here = budget_build_here();
    ck_assert_ptr_null(strchr(here.compiler, '.'));
    ck_assert(g_str_has_prefix(mpm_build_info()->compiler, here.compiler));
    ck_assert_str_ne(here.architecture, "");
}
END_TEST

/* ------------------------------------------------------------------- counting */

/* Two functions of the program and one of a library; the first calls the others. */
#define CALLGRIND_HEAD "version: 1\nevents: Ir Bc Bcm\n\n"
#define CALLGRIND_BODY                                                                             \
    "ob=/bin/mpm\nfl=a.c\nfn=pass\n0 600 10 1\ncob=/lib/libc.so.6\ncfn=memcpy\ncalls=2 0\n"        \
    "0 300 100\n12 50\n\nfn=sort\n0 50 5\n\nob=/lib/libc.so.6\nfl=m.S\nfn=memcpy\n0 300 100\n\n"

START_TEST(counts_are_those_of_functions_and_branches_those_of_the_program)
{
    static const char text[] = CALLGRIND_HEAD CALLGRIND_BODY "totals: 1000 115 1\n";
    struct callgrind_counts counts;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(callgrind_file_parse(text, &counts, &error) == MPM_OK, "%s", error.message);
    ck_assert_uint_eq(counts.instructions, 1000);
    ck_assert_uint_eq(counts.branches, 15);
    ck_assert_str_eq(counts.top[0].name, "pass");
    ck_assert_uint_eq(counts.top[0].instructions, 650);
    ck_assert_uint_eq(counts.top[0].branches, 10);
    ck_assert_str_eq(counts.top[1].name, "memcpy");
    ck_assert_str_eq(counts.top[2].name, "sort");
    ck_assert_str_eq(counts.top[3].name, "");
}
END_TEST

START_TEST(columns_are_taken_by_the_name_of_their_event)
{
    struct callgrind_counts counts;
    ck_assert_int_eq(
        callgrind_file_parse("events: Bi Bc Ir\nfn=a\n0 4 20 90\ntotals: 4 20 90\n", &counts, NULL),
        MPM_OK);
    ck_assert_uint_eq(counts.instructions, 90);
    ck_assert_uint_eq(counts.branches, 20);
}
END_TEST

static const struct {
    const char *text, *said;
} wrong_counts[] = {
    {"", "no totals"},
    {CALLGRIND_HEAD CALLGRIND_BODY, "no totals"},
    {"events: Ir\nfn=a\n0 90\ntotals: 90\n", "no totals of the events Ir and Bc"},
    {"events: Ir Bc\ntotals: 0 0\n", "counted nothing"},
    {"events: Ir Bc\ntotals: some many\n", "counted nothing"},
    {CALLGRIND_HEAD CALLGRIND_BODY "totals: 1001 115 1\n", "functions have 1000 of event Ir"},
    {CALLGRIND_HEAD CALLGRIND_BODY "totals: 1000 114 1\n", "functions have 115 of event Bc"},
};

START_TEST(counts_that_are_missing_or_do_not_add_up_are_refused)
{
    struct callgrind_counts counts;
    struct mpm_error error;
    ck_assert_int_eq(callgrind_file_parse(wrong_counts[_i].text, &counts, &error),
                     MPM_ENVIRONMENT_FAILED);
    test_contains(error.message, wrong_counts[_i].said);
}
END_TEST

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
static const bool sanitized = true; /* valgrind does not run such programs */
#else
static const bool sanitized = TEST_UNDER_TSAN;
#endif

static const char *reason_not_to_count(void)
{
    if (sanitized)
        return "valgrind does not run a program built for this sanitizer";
    return instructions_available(NULL) == MPM_OK ? NULL : "no valgrind";
}

static enum mpm_status count_with(const char *scene, const char *const *settings,
                                  struct instructions *counted, struct mpm_error *error)
{
    const char *folder = g_getenv("MPM_BIN") != NULL ? g_getenv("MPM_BIN") : "build/release/bin";
    char *program = g_build_filename(folder, "mpm", NULL);
    const struct instructions_request request = {
        .program = program, .scene = scene, .settings = settings, .steps = 3};
    const enum mpm_status status = instructions_count(&request, counted, error);
    g_free(program);
    return status;
}

START_TEST(the_same_program_counts_the_same_twice)
{
    const char *reason = reason_not_to_count();
    if (reason != NULL)
        TEST_SKIP(reason);
    struct instructions first, second;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(count_with("benchmarks/scenes/block.yaml", NULL, &first, &error) == MPM_OK, "%s",
                  error.message);
    ck_assert(g_setenv("SOME_VARIABLE", "a longer environment than the first time", TRUE));
    ck_assert_int_eq(count_with("benchmarks/scenes/block.yaml", NULL, &second, &error), MPM_OK);
    g_unsetenv("SOME_VARIABLE");
    ck_assert_uint_eq(first.counts.instructions, second.counts.instructions);
    ck_assert_uint_eq(first.counts.branches, second.counts.branches);
    ck_assert_uint_eq(first.steps, 3);
    ck_assert_uint_eq(first.particles, 100);
    ck_assert_uint_eq(first.particle_steps, 300);
    ck_assert_uint_eq(first.bytes, second.bytes);
    ck_assert_uint_lt(first.counts.branches, first.counts.instructions);
    ck_assert_str_ne(first.kernels, "");
    ck_assert_str_ne(first.simd, "");
}
END_TEST

START_TEST(a_run_that_is_refused_passes_on_what_the_program_said)
{
    const char *reason = reason_not_to_count();
    if (reason != NULL)
        TEST_SKIP(reason);
    const char *const settings[] = {"method.shape=round", NULL};
    struct instructions counted;
    struct mpm_error error;
    ck_assert_int_eq(count_with("benchmarks/scenes/block.yaml", settings, &counted, &error),
                     MPM_BAD_INPUT);
    test_contains(error.message, "exit status 2");
    test_contains(error.message, "round");
}
END_TEST

START_TEST(a_scene_that_is_not_there_is_named)
{
    const char *reason = reason_not_to_count();
    if (reason != NULL)
        TEST_SKIP(reason);
    struct instructions counted;
    struct mpm_error error;
    ck_assert_int_eq(count_with("no/such/scene.yaml", NULL, &counted, &error), MPM_BAD_INPUT);
    test_contains(error.message, "no/such/scene.yaml");
}
END_TEST

START_TEST(without_valgrind_it_is_said_what_to_do)
{
    char *path = g_strdup(g_getenv("PATH"));
    ck_assert(g_setenv("PATH", "/no/such/folder", TRUE));
    struct instructions counted;
    struct mpm_error error;
    const enum mpm_status status =
        count_with("benchmarks/scenes/block.yaml", NULL, &counted, &error);
    g_setenv("PATH", path, TRUE);
    g_free(path);
    ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
    test_contains(error.message, "make deps");
}
END_TEST

Suite *suite_budget(void)
{
    Suite *suite = suite_create("budget");
    TCase *tests = tcase_create("budget");
    tcase_add_loop_test(tests, a_figure_is_red_above_its_budget_and_tolerance_only, 0,
                        G_N_ELEMENTS(judgements));
    tcase_add_test(tests, each_figure_has_the_tolerance_that_is_promised);
    tcase_add_test(tests, a_budget_is_read_back_as_it_was_stored);
    tcase_add_loop_test(tests, a_file_that_is_not_a_budget_is_refused_with_its_place, 0,
                        G_N_ELEMENTS(wrong_files));
    tcase_add_test(tests, a_missing_budget_file_is_named);
    tcase_add_test(tests, every_run_has_a_stored_budget_and_every_budget_a_run);
    tcase_add_test(tests, a_budget_holds_for_one_compiler_and_architecture);
    tcase_add_test(tests, minor_versions_of_the_compiler_share_a_budget);
    tcase_add_test(tests, counts_are_those_of_functions_and_branches_those_of_the_program);
    tcase_add_test(tests, columns_are_taken_by_the_name_of_their_event);
    tcase_add_loop_test(tests, counts_that_are_missing_or_do_not_add_up_are_refused, 0,
                        G_N_ELEMENTS(wrong_counts));
    tcase_add_test(tests, the_same_program_counts_the_same_twice);
    tcase_add_test(tests, a_run_that_is_refused_passes_on_what_the_program_said);
    tcase_add_test(tests, a_scene_that_is_not_there_is_named);
    tcase_add_test(tests, without_valgrind_it_is_said_what_to_do);
    suite_add_tcase(suite, tests);
    return suite;
}
