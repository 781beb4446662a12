/* Runs that go on, and programs as tasks: what is kept, what is run again, and what happens to the
 * report before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/same_report.h"
#include "support/verify.h"

#include "verification/records/records.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>

static const char run_line[] = "mpm-verify run --catalogue @ --output @";

struct folders {
    char *catalogue, *output;
};

static struct folders folders_create(void)
{
    return (struct folders){test_folder_create(), test_folder_create()};
}

static void folders_remove(const struct folders *folders)
{
    test_folder_remove(folders->catalogue);
    test_folder_remove(folders->output);
}

static void run(const char *line, const struct folders *folders, int exit_status)
{
    struct test_said said = test_verify_with(line, folders->catalogue, folders->output);
    ck_assert_msg(said.exit_status == exit_status, "%d: %s%s", said.exit_status, said.out,
                  said.err);
    test_said_free(&said);
}

static void resume(const struct folders *folders, int exit_status)
{
    run("mpm-verify run --resume --catalogue @ --output @", folders, exit_status);
}

/* A case that hangs for so long as nobody replaces it. */
static void write_patient(const struct folders *folders)
{
    char *text = test_case_text("Z", "hang");
    char **parts = g_strsplit(text, "timeout: 0.5", 2);
    char *patient = g_strjoinv("timeout: 500", parts);
    test_case_write(folders->catalogue, "Z", patient);
    g_free(patient);
    g_strfreev(parts);
    g_free(text);
}

static void write_passing(const struct folders *folders)
{
    char *text = test_case_text("Z", "pass");
    test_case_write(folders->catalogue, "Z", text);
    g_free(text);
}

/* The kept results by name, with when they were written; g_hash_table_unref. */
static GHashTable *kept(const char *output)
{
    GHashTable *found = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    char *folder = test_folder_path(output, ".run/results");
    GDir *directory = g_dir_open(folder, 0, NULL);
    ck_assert_ptr_nonnull(directory);
    for (const char *name; (name = g_dir_read_name(directory)) != NULL;) {
        char *path = test_folder_path(folder, name);
        GStatBuf status;
        ck_assert_int_eq(g_stat(path, &status), 0);
        g_hash_table_insert(
            found, g_strdup(name),
            g_strdup_printf("%ld %ld", (long)status.st_mtim.tv_sec, (long)status.st_mtim.tv_nsec));
        g_free(path);
    }
    g_dir_close(directory);
    g_free(folder);
    return found;
}

/* How many results of before are the same files after. */
static unsigned unchanged(GHashTable *before, GHashTable *after)
{
    GHashTableIter rows;
    void *name, *time;
    unsigned count = 0;
    g_hash_table_iter_init(&rows, before);
    while (g_hash_table_iter_next(&rows, &name, &time))
        count += g_strcmp0(time, g_hash_table_lookup(after, name)) == 0 ? 1 : 0;
    return count;
}

/* A run of Q and Z that was ended while Z was running. */
static struct folders interrupted_by(int signal_number)
{
    const struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    write_patient(&folders);
    const pid_t process = test_in_process(test_run_all, folders.catalogue, folders.output);
    /* Z is the last one, so that those of Q have been kept when another job waits for nothing */
    for (unsigned found = 0; found < 2; g_usleep(5000)) {
        char *folder = test_folder_path(folders.output, ".run/results");
        GDir *directory = g_dir_open(folder, 0, NULL);
        found = 0;
        for (const char *name; directory != NULL && (name = g_dir_read_name(directory)) != NULL;)
            found += g_str_has_suffix(name, ".json") ? 1 : 0;
        if (directory != NULL)
            g_dir_close(directory);
        g_free(folder);
    }
    test_wait_for(folders.output, ".run/report/cases/Z/rows-only.jsonl");
    ck_assert_int_eq(kill(process, signal_number), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + signal_number);
    return folders;
}

/* ----------------------------------------------------------------------- tests */

START_TEST(an_interrupted_run_reports_what_there_is_and_goes_on)
{
    static const char *const files[] = {"index.html", "summary.md", "junit.xml", "results.tap"};
    const struct folders folders = interrupted_by(_i == 0 ? SIGTERM : SIGINT);
    struct records records;
    struct mpm_error error;
    ck_assert_int_eq(records_read(folders.output, &records, &error), MPM_OK);
    const json_t *incomplete = json_object_get(records.run, "incomplete");
    ck_assert_int_eq(json_integer_value(json_object_get(incomplete, "done")), 2);
    ck_assert_int_eq(json_integer_value(json_object_get(incomplete, "programs")), 3);
    const json_t *last = json_array_get(records.checks, 2);
    ck_assert_str_eq(record_text(last, "status"), "error");
    ck_assert_ptr_nonnull(strstr(record_text(last, "reason"), "not run: interrupted by signal"));
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++) {
        char *text = test_folder_read(folders.output, files[i]);
        ck_assert_msg(strstr(text, "Incomplete: interrupted by signal") != NULL, "%s", files[i]);
        g_free(text);
    }
    records_clear(&records);
    /* goes on: Z alone runs */
    write_passing(&folders);
    GHashTable *before = kept(folders.output);
    resume(&folders, 0);
    GHashTable *after = kept(folders.output);
    ck_assert_uint_eq(unchanged(before, after), 2);
    ck_assert_uint_eq(g_hash_table_size(after), 3);
    struct folders whole = {folders.catalogue, test_folder_create()};
    run(run_line, &whole, 0);
    test_assert_same_report(folders.output, whole.output);
    test_folder_remove(whole.output);
    g_hash_table_unref(before);
    g_hash_table_unref(after);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_run_that_was_killed_leaves_the_report_before_and_goes_on)
{
    struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    run(run_line, &folders, 0);
    char *before = test_folder_read(folders.output, "checks.jsonl");
    write_patient(&folders);
    const pid_t process = test_in_process(test_run_all, folders.catalogue, folders.output);
    test_wait_for(folders.output, ".run/report/cases/Z/rows-only.jsonl");
    ck_assert_int_eq(kill(process, SIGKILL), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGKILL);
    char *after = test_folder_read(folders.output, "checks.jsonl");
    ck_assert_str_eq(before, after);
    write_passing(&folders);
    resume(&folders, 0);
    struct folders whole = {folders.catalogue, test_folder_create()};
    run(run_line, &whole, 0);
    test_assert_same_report(folders.output, whole.output);
    test_folder_remove(whole.output);
    g_free(before);
    g_free(after);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_finished_run_goes_on_with_what_has_changed)
{
    const struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    write_passing(&folders);
    run(run_line, &folders, 0);
    GHashTable *first = kept(folders.output);
    resume(&folders, 0);
    GHashTable *second = kept(folders.output);
    ck_assert_uint_eq(unchanged(first, second), 3);
    /* the words of a case change no result */
    char *home = test_folder_path(folders.catalogue, "T/Q");
    g_free(test_folder_write(home, "README.md", "## Other words\n"));
    resume(&folders, 0);
    GHashTable *third = kept(folders.output);
    ck_assert_uint_eq(unchanged(first, third), 3);
    char *page = test_folder_read(folders.output, "cases/Q/index.html");
    ck_assert_ptr_nonnull(strstr(page, "Other words"));
    /* a data file of the case does */
    g_free(test_folder_write(home, "points.csv", "1\n"));
    resume(&folders, 0);
    GHashTable *fourth = kept(folders.output);
    ck_assert_uint_eq(unchanged(first, fourth), 3); /* the old results are there still */
    ck_assert_uint_eq(g_hash_table_size(fourth), 5);
    g_free(page);
    g_free(home);
    g_hash_table_unref(first);
    g_hash_table_unref(second);
    g_hash_table_unref(third);
    g_hash_table_unref(fourth);
    folders_remove(&folders);
}
END_TEST

/* Cut short, changed, or of other inputs under this name. */
START_TEST(a_kept_result_that_is_damaged_is_run_again)
{
    const struct folders folders = folders_create();
    write_passing(&folders);
    run(run_line, &folders, 0);
    GHashTable *names = kept(folders.output);
    GHashTableIter rows;
    void *name;
    g_hash_table_iter_init(&rows, names);
    ck_assert(g_hash_table_iter_next(&rows, &name, NULL));
    char *folder = test_folder_path(folders.output, ".run/results");
    char *good = test_folder_read(folder, name);
    for (int i = 0; i < 3; i++) {
        char *text = g_strndup(good, i == 0 ? strlen(good) / 2 : i == 1 ? 0 : strlen(good));
        if (i == 2) { /* another number, which only the sum shows */
            char *digit = strpbrk(strstr(text, "\"seconds\""), "0123456789");
            *digit = *digit == '7' ? '8' : '7';
        }
        g_free(test_folder_write(folder, name, text));
        struct test_said said = test_verify_with("mpm-verify run --resume --catalogue @ --output @",
                                                 folders.catalogue, folders.output);
        ck_assert_int_eq(said.exit_status, 0);
        ck_assert_msg(strstr(said.out, "is damaged: its program runs again") != NULL, "%d: %s", i,
                      said.out);
        test_said_free(&said);
        g_free(text);
    }
    g_free(good);
    g_free(folder);
    g_hash_table_unref(names);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_result_that_the_environment_spoiled_is_not_kept)
{
    const struct folders folders = folders_create();
    char *text = test_case_text("Z", "crash"); /* by SIGKILL */
    test_case_write(folders.catalogue, "Z", text);
    run(run_line, &folders, 1);
    GHashTable *names = kept(folders.output);
    ck_assert_uint_eq(g_hash_table_size(names), 0);
    g_hash_table_unref(names);
    g_free(text);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_run_goes_on_with_its_own_selection_alone)
{
    static const struct {
        const char *line, *message;
    } table[] = {
        {"mpm-verify run --resume --catalogue @ --output @ --tier ci", "--tier \"ci\": the run in"},
        {"mpm-verify run --resume --catalogue @ --output @ --case R*",
         "was begun with \"Q\"; leave it out to go on"},
        {"mpm-verify run --resume --catalogue @ --output @ --variant cubic",
         "was begun without it"},
        {"mpm-verify run --resume --catalogue @ --output @ --kernels fast", "--kernels \"fast\""},
    };
    const struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    struct test_said said = test_verify_with("mpm-verify run --resume --catalogue @ --output @",
                                             folders.catalogue, folders.output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(said.err, "no run was begun here that could go on"));
    test_said_free(&said);
    run("mpm-verify run --tier full --case Q --catalogue @ --output @", &folders, 0);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        said = test_verify_with(table[i].line, folders.catalogue, folders.output);
        ck_assert_msg(said.exit_status == 2 && strstr(said.err, table[i].message) != NULL,
                      "%s: %d, %s", table[i].line, said.exit_status, said.err);
        test_said_free(&said);
    }
    /* not given: as it was begun, with the full size */
    said = test_verify_with("mpm-verify run --resume --output @", folders.output, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    ck_assert_ptr_nonnull(strstr(said.out, "3 passed, 0 failed"));
    test_said_free(&said);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_publication_that_was_cut_short_is_ended_by_the_next_run)
{
    const struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    run(run_line, &folders, 0);
    char *state = test_folder_path(folders.output, ".run");
    char *stage = test_folder_path(folders.output, ".run/report");
    ck_assert_int_eq(g_mkdir(stage, 0777), 0);
    g_free(test_folder_write(stage, "summary.md", "the new one"));
    /* checks.jsonl was moved before, and summary.md was not */
    g_free(test_folder_write(state, "publish", "checks.jsonl\nsummary.md"));
    write_patient(&folders);
    const pid_t process = test_in_process(test_run_all, folders.catalogue, folders.output);
    test_wait_for(folders.output, ".run/report/cases/Z/rows-only.jsonl");
    char *summary = test_folder_read(folders.output, "summary.md");
    ck_assert_str_eq(summary, "the new one");
    char *page = test_folder_path(folders.output, "index.html");
    ck_assert(!test_file_exists(page)); /* of the report before, and not in the list */
    ck_assert_int_eq(kill(process, SIGKILL), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGKILL);
    g_free(page);
    g_free(summary);
    g_free(stage);
    g_free(state);
    folders_remove(&folders);
}
END_TEST

/* No file may be larger: as on a disk that is full. One program at a time: what ends before the
 * first that fails is known. */
static int run_on_a_small_disk(const char *catalogue, const char *output)
{
    static const char line[] = "mpm-verify run --jobs 1 --catalogue @ --output @";
    const struct rlimit limit = {100000, 100000};
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGXFSZ, &ignore, NULL);
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0)
        return -1;
    struct test_said said = test_verify_with(line, catalogue, output);
    const bool told = strstr(said.err, "mpm-verify run --resume goes on") != NULL;
    return told ? said.exit_status : -1;
}

START_TEST(a_full_disk_ends_the_run_and_loses_nothing)
{
    const struct folders folders = folders_create();
    char *text = test_case_text("Z", "talk");
    test_case_write_quadrature(folders.catalogue);
    run(run_line, &folders, 0);
    char *before = test_folder_read(folders.output, "checks.jsonl");
    test_case_write(folders.catalogue, "Z", text);
    const pid_t process = test_in_process(run_on_a_small_disk, folders.catalogue, folders.output);
    ck_assert_int_eq(test_exit_status(process), 4);
    char *after = test_folder_read(folders.output, "checks.jsonl");
    ck_assert_str_eq(before, after);
    GHashTable *names = kept(folders.output);
    ck_assert_uint_eq(g_hash_table_size(names), 2);
    resume(&folders, 0);
    g_hash_table_unref(names);
    g_free(after);
    g_free(before);
    g_free(text);
    folders_remove(&folders);
}
END_TEST

/* ------------------------------------------------------------------------ tasks */

static const char tasks_line[] = "mpm-verify tasks --catalogue @ --output @";

START_TEST(tasks_that_run_one_by_one_give_the_report_of_a_local_run)
{
    static const char *const tasks[] = {"Q/ninth", "Z/only", "Q/cubic", "Q/cubic"};
    const struct folders folders = folders_create();
    struct folders local = {folders.catalogue, test_folder_create()};
    test_case_write_quadrature(folders.catalogue);
    write_passing(&folders);
    struct test_said said = test_verify_with(tasks_line, folders.catalogue, folders.output);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    char **lines = g_strsplit(g_strchomp(said.out), "\n", -1);
    ck_assert_uint_eq(g_strv_length(lines), 3);
    ck_assert(g_str_has_suffix(lines[0], "' Q/cubic"));
    ck_assert(g_str_has_suffix(lines[2], "' Z/only"));
    for (size_t i = 0; i < G_N_ELEMENTS(tasks); i++)
        run("mpm-verify task @ @", &(struct folders){folders.output, (char *)(uintptr_t)tasks[i]},
            0);
    test_said_free(&said);
    said = test_verify_with("mpm-verify run --status --output @", folders.output, NULL);
    ck_assert_str_eq(test_last_line(said.out), "3 done, 0 failed, 0 running, 0 waiting, 0 missing");
    test_said_free(&said);
    said = test_verify_with("mpm-verify collect @", folders.output, NULL);
    ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
    test_said_free(&said);
    run(run_line, &local, 0);
    test_assert_same_report(folders.output, local.output);
    g_strfreev(lines);
    test_folder_remove(local.output);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_collection_without_all_results_is_incomplete)
{
    const struct folders folders = folders_create();
    test_case_write_quadrature(folders.catalogue);
    run(tasks_line, &folders, 0);
    struct folders task = {folders.output, (char *)(uintptr_t) "Q/ninth"};
    run("mpm-verify task @ @", &task, 0);
    struct test_said said = test_verify_with("mpm-verify collect @", folders.output, NULL);
    ck_assert_int_eq(said.exit_status, 1);
    ck_assert_ptr_nonnull(strstr(said.out, "1 of 2 programs had left no result"));
    ck_assert_str_eq(test_last_line(said.out), "1 passed, 1 failed, 0 skipped");
    test_said_free(&said);
    /* what is missing is printed again, and the run goes on with it */
    said = test_verify_with("mpm-verify tasks --resume --output @", folders.output, NULL);
    ck_assert(g_str_has_suffix(test_last_line(said.out), "' Q/cubic"));
    ck_assert_ptr_null(strstr(said.out, "Q/ninth"));
    test_said_free(&said);
    resume(&folders, 0);
    folders_remove(&folders);
}
END_TEST

START_TEST(a_task_without_a_result_fails)
{
    static const struct {
        const char *program, *task, *message;
        int exit_status;
    } table[] = {
        {"crash", "Z/only", "ended by signal 9, which is not its own doing", 4},
        {"pass", "Z/none", "has no such task", 2},
        {"leave", "Z/only", "", 0}, /* its own doing: a result, and a failed one */
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct folders folders = folders_create();
        char *text = test_case_text("Z", table[i].program);
        test_case_write(folders.catalogue, "Z", text);
        run(tasks_line, &folders, 0);
        struct test_said said =
            test_verify_with("mpm-verify task @ @", folders.output, table[i].task);
        ck_assert_int_eq(said.exit_status, table[i].exit_status);
        ck_assert_msg(strstr(said.err, table[i].message) != NULL, "%s", said.err);
        test_said_free(&said);
        said = test_verify_with("mpm-verify run --status --output @", folders.output, NULL);
        ck_assert_str_eq(test_last_line(said.out),
                         i == 2 ? "0 done, 1 failed, 0 running, 0 waiting, 0 missing"
                                : "0 done, 0 failed, 0 running, 0 waiting, 1 missing");
        test_said_free(&said);
        g_free(text);
        folders_remove(&folders);
    }
}
END_TEST

Suite *suite_resume(void)
{
    Suite *suite = suite_create("resume");
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, an_interrupted_run_reports_what_there_is_and_goes_on, 0, 2);
    tcase_add_test(runs, a_run_that_was_killed_leaves_the_report_before_and_goes_on);
    tcase_add_test(runs, a_finished_run_goes_on_with_what_has_changed);
    tcase_add_test(runs, a_kept_result_that_is_damaged_is_run_again);
    tcase_add_test(runs, a_result_that_the_environment_spoiled_is_not_kept);
    tcase_add_test(runs, a_run_goes_on_with_its_own_selection_alone);
    tcase_add_test(runs, a_publication_that_was_cut_short_is_ended_by_the_next_run);
    tcase_add_test(runs, a_full_disk_ends_the_run_and_loses_nothing);
    suite_add_tcase(suite, runs);
    TCase *tasks = tcase_create("tasks");
    tcase_add_test(tasks, tasks_that_run_one_by_one_give_the_report_of_a_local_run);
    tcase_add_test(tasks, a_collection_without_all_results_is_incomplete);
    tcase_add_test(tasks, a_task_without_a_result_fails);
    suite_add_tcase(suite, tasks);
    return suite;
}
