/* The layer that all calls on files go through, and the order of those that write a checkpoint.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_file.h"
#include "suites.h"
#include "support/call_order.h"
#include "support/folder.h"
#include "support/results.h"
#include "support/skip.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char *folder;

static void set_up(void)
{
    folder = test_folder_create();
}

static void tear_down(void)
{
    test_folder_remove(folder);
}

/* --------------------------------------------------------------------- whole files */

START_TEST(what_is_saved_is_loaded)
{
    static const size_t sizes[] = {0, 1, 4095, 4096, 4097, 100000};
    char *const path = test_folder_path(folder, "data");
    for (size_t i = 0; i < G_N_ELEMENTS(sizes); i++) {
        char *const data = g_strnfill(sizes[i], 'x');
        size_t size = 1;
        ck_assert_int_eq(mpm_file_save(path, data, sizes[i]), 0);
        char *const loaded = mpm_file_load(path, &size);
        ck_assert_uint_eq(size, sizes[i]);
        ck_assert_str_eq(loaded, data);
        g_free(loaded);
        g_free(data);
    }
    char **const names = mpm_folder_list(folder);
    ck_assert_str_eq(names[0], "data"); /* and no file that is partly written */
    ck_assert_ptr_null(names[1]);
    mpm_folder_list_free(names);
    g_free(path);
}
END_TEST

START_TEST(a_file_of_proc_is_loaded_whole)
{
    char *const text = mpm_file_load("/proc/self/status", NULL);
    if (text == NULL && errno == ENOENT)
        TEST_SKIP("this system has no /proc/self/status");
    ck_assert_ptr_nonnull(text);
    if (text != NULL)
        ck_assert_ptr_nonnull(strstr(text, "Threads:"));
    g_free(text);
}
END_TEST

START_TEST(a_file_that_cannot_be_saved_is_as_it_was)
{
    char *const path = test_folder_path(folder, "data"), *const inside =
                                                             g_build_filename(path, "x", NULL);
    ck_assert_int_eq(mpm_file_save(path, "old", 3), 0);
    ck_assert_int_lt(mpm_file_save(inside, "new", 3), 0);
    ck_assert_int_eq(errno, ENOTDIR);
    char *const text = test_file_read(path);
    ck_assert_str_eq(text, "old");
    g_free(text);
    g_free(inside);
    g_free(path);
}
END_TEST

START_TEST(a_folder_is_not_replaced_by_a_file)
{
    char *const path = test_folder_path(folder, "name"), *const partial =
                                                             g_strconcat(path, ".partial", NULL);
    ck_assert_int_eq(mpm_folder_make(path), 0);
    ck_assert_int_lt(mpm_file_save(path, "new", 3), 0);
    ck_assert(mpm_path_is_folder(path));
    ck_assert(!mpm_path_exists(partial));
    g_free(partial);
    g_free(path);
}
END_TEST

/* Processes that save one file at a time: it always has what one of them has written. */
START_TEST(those_who_save_one_file_wait_for_each_other)
{
    enum { WRITERS = 4, TIMES = 25, SIZE = 50000 };
    char *const path = test_folder_path(folder, "shared");
    pid_t writers[WRITERS];
    for (int w = 0; w < WRITERS; w++) {
        writers[w] = fork();
        if (writers[w] == 0) {
            char *const data = g_strnfill(SIZE, (char)('a' + w));
            int failed = 0;
            for (int i = 0; i < TIMES; i++) {
                failed = mpm_file_save(path, data, SIZE) != 0 ? 1 : failed;
                char *const found = mpm_file_load(path, NULL);
                failed =
                    found == NULL || strspn(found, (char[]){found[0], '\0'}) != SIZE ? 1 : failed;
                g_free(found);
            }
            _exit(failed);
        }
    }
    for (int w = 0; w < WRITERS; w++) {
        int state;
        ck_assert_int_eq(waitpid(writers[w], &state, 0), writers[w]);
        ck_assert(WIFEXITED(state) && WEXITSTATUS(state) == 0);
    }
    g_free(path);
}
END_TEST

/* ------------------------------------------------------------------------ messages */

START_TEST(a_disk_that_fails_is_no_bad_input)
{
    static const struct {
        int reason;
        enum mpm_status status;
    } reasons[] = {{ENOENT, MPM_BAD_INPUT},          {EACCES, MPM_BAD_INPUT},
                   {EISDIR, MPM_BAD_INPUT},          {EIO, MPM_ENVIRONMENT_FAILED},
                   {ENOMEM, MPM_ENVIRONMENT_FAILED}, {EMFILE, MPM_ENVIRONMENT_FAILED}};
    for (size_t i = 0; i < G_N_ELEMENTS(reasons); i++) {
        struct mpm_error error = {.status = MPM_OK};
        ck_assert_int_eq(mpm_file_unread("a/b", reasons[i].reason, "a table", &error),
                         reasons[i].status);
        ck_assert(g_str_has_prefix(error.message, "a/b: cannot be read: "));
        ck_assert_ptr_nonnull(strstr(error.message, g_strerror(reasons[i].reason)));
        ck_assert(g_str_has_suffix(error.message, ": allowed is a table"));
    }
}
END_TEST

/* --------------------------------------------------------------------------- names */

START_TEST(folders_are_made_with_their_parents)
{
    char *const path = g_build_filename(folder, "a//b", "c", NULL);
    ck_assert_int_eq(mpm_folder_make(path), 0);
    ck_assert_int_eq(mpm_folder_make(path), 0);
    ck_assert(mpm_path_is_folder(path));
    char *const file = test_folder_write(folder, "file", "text"), *const below = g_build_filename(
                                                                      file, "d", NULL);
    ck_assert_int_lt(mpm_folder_make(file), 0);
    ck_assert_int_eq(errno, ENOTDIR);
    ck_assert_int_lt(mpm_folder_make(below), 0);
    ck_assert_int_eq(errno, ENOTDIR);
    ck_assert_int_lt(mpm_folder_make(""), 0);
    ck_assert_int_eq(errno, ENOENT);
    g_free(below);
    g_free(file);
    g_free(path);
}
END_TEST

START_TEST(each_temporary_folder_is_a_new_one)
{
    struct mpm_error error = {.message = ""};
    char *paths[2];
    for (size_t k = 0; k < 2; k++) {
        ck_assert_int_eq(mpm_folder_make_temporary(&paths[k], &error), MPM_OK);
        ck_assert(mpm_path_is_folder(paths[k]));
        ck_assert(g_str_has_prefix(paths[k], g_get_tmp_dir()));
    }
    ck_assert_str_ne(paths[0], paths[1]);
    for (size_t k = 0; k < 2; k++) {
        ck_assert_int_eq(mpm_folder_remove_all(paths[k], NULL), 0);
        g_free(paths[k]);
    }
}
END_TEST

START_TEST(a_folder_is_listed_in_order_and_removed_with_what_is_in_it)
{
    char *const deep = g_build_filename(folder, "top", "deep", NULL), *const top = test_folder_path(
                                                                          folder, "top");
    char *const kept = test_folder_write(folder, "kept", "text"), *const link = g_build_filename(
                                                                      deep, "link", NULL);
    ck_assert_int_eq(mpm_folder_make(deep), 0);
    g_free(test_folder_write(top, "b", ""));
    g_free(test_folder_write(top, "a", ""));
    ck_assert_int_eq(mpm_path_link(kept, link), 0);
    char **const names = mpm_folder_list(top), *const all = g_strjoinv(" ", names);
    ck_assert_str_eq(all, "a b deep");
    ck_assert_int_eq(mpm_folder_remove_all(top, NULL), 0);
    ck_assert_int_eq(mpm_path_kind(top), MPM_PATH_NONE);
    ck_assert_int_eq(mpm_path_kind(kept), MPM_PATH_FILE); /* a link goes, not what it is to */
    ck_assert_ptr_null(mpm_folder_list(top));
    ck_assert_int_eq(errno, ENOENT);
    mpm_folder_list_free(names);
    g_free(all);
    g_free(link);
    g_free(kept);
    g_free(top);
    g_free(deep);
}
END_TEST

/* ---------------------------------------------------------------------- open files */

START_TEST(parts_of_files_are_read_written_and_cut)
{
    char *const path = test_folder_path(folder, "data"), text[8] = "";
    struct stat facts;
    const int file = mpm_file_open(path, O_RDWR | O_CREAT);
    ck_assert_int_eq(mpm_file_write(file, "abcdef", 6), 0);
    ck_assert_int_eq(mpm_file_write_at(file, "XY", 2, 2), 0);
    ck_assert_int_eq(mpm_file_read_at(file, text, 7, 1), 5); /* to the end of the file */
    ck_assert_str_eq(text, "bXYef");
    ck_assert_int_eq(mpm_file_cut(file, 3), 0);
    ck_assert_int_eq(mpm_file_facts(file, &facts), 0);
    ck_assert_int_eq(facts.st_size, 3);
    ck_assert_int_ne(fcntl(file, F_GETFD) & FD_CLOEXEC, 0);
    ck_assert_int_eq(mpm_file_sync(file), 0);
    ck_assert_int_eq(mpm_file_close(file), 0);
    ck_assert_int_lt(mpm_file_close(file), 0);
    ck_assert_int_eq(errno, EBADF);
    g_free(path);
}
END_TEST

START_TEST(a_lock_is_for_one)
{
    char *const path = test_folder_path(folder, "lock");
    const int first = mpm_file_open_locked(path, false);
    ck_assert_int_ge(first, 0);
    ck_assert_int_lt(mpm_file_open_locked(path, false), 0);
    ck_assert_int_eq(errno, EWOULDBLOCK);
    ck_assert_int_eq(mpm_file_close(first), 0);
    const int second = mpm_file_open_locked(path, false);
    ck_assert_int_ge(second, 0);
    ck_assert_int_eq(mpm_file_close(second), 0);
    g_free(path);
}
END_TEST

/* --------------------------------------------------------------------------- order */

static int stop_at_once(void)
{
    return SIGTERM;
}

/* Each in its order: rows of the history that the checkpoint counts, the checkpoint, its name, the
 * names of the folder. Otherwise a crash of the system could leave a name without its bytes. */
START_TEST(a_checkpoint_is_synced_before_it_has_its_name_and_the_folder_after_it)
{
    const struct mpm_run_options options = {
        .output = test_results.output, .simulation = {.threads = 1}, .interrupted = stop_at_once};
    struct mpm_error error = {.status = MPM_OK};
    if (!test_call_order_start())
        TEST_SKIP("calls are recorded on Linux alone");
    ck_assert_msg(mpm_scene_run(test_results.scene, &options, &error) == MPM_INTERRUPTED, "%s",
                  error.message);
    char *const order = test_call_order_end(), *const name =
                                                   g_path_get_basename(test_results.output);
    char *const wanted = g_strdup_printf("fsync history.csv\nfsync checkpoint.h5.partial\n"
                                         "rename checkpoint.h5\nrename checkpoint.h5.partial\n"
                                         "fsync %s\n",
                                         name);
    ck_assert_msg(strstr(order, wanted) != NULL, "%s is not in:\n%s", wanted, order);
    g_free(wanted);
    g_free(name);
    g_free(order);
}
END_TEST

Suite *suite_file(void)
{
    Suite *const suite = suite_create("file");
    TCase *const files = tcase_create("files"), *const order = tcase_create("order");
    tcase_add_checked_fixture(files, set_up, tear_down);
    tcase_add_test(files, what_is_saved_is_loaded);
    tcase_add_test(files, a_file_of_proc_is_loaded_whole);
    tcase_add_test(files, a_file_that_cannot_be_saved_is_as_it_was);
    tcase_add_test(files, a_folder_is_not_replaced_by_a_file);
    tcase_add_test(files, those_who_save_one_file_wait_for_each_other);
    tcase_add_test(files, a_disk_that_fails_is_no_bad_input);
    tcase_add_test(files, folders_are_made_with_their_parents);
    tcase_add_test(files, each_temporary_folder_is_a_new_one);
    tcase_add_test(files, a_folder_is_listed_in_order_and_removed_with_what_is_in_it);
    tcase_add_test(files, parts_of_files_are_read_written_and_cut);
    tcase_add_test(files, a_lock_is_for_one);
    suite_add_tcase(suite, files);
    tcase_add_checked_fixture(order, test_results_set_up, test_results_tear_down);
    tcase_add_test(order, a_checkpoint_is_synced_before_it_has_its_name_and_the_folder_after_it);
    suite_add_tcase(suite, order);
    return suite;
}
