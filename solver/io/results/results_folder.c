/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/results_folder.h"

#include "io/checkpoint/checkpoint.h"
#include "io/results/file_write.h"
#include "io/results/history.h"
#include "io/results/run_record.h"
#include "io/results/series.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* particles-123456.hdf, with as many digits as it likes. */
static bool is_snapshot_name(const char *name)
{
    if (!g_str_has_prefix(name, MPM_SERIES_PREFIX))
        return false;
    const char *number = name + strlen(MPM_SERIES_PREFIX);
    const size_t digits = strspn(number, "0123456789");
    return digits > 0 && strcmp(number + digits, MPM_SERIES_SUFFIX) == 0;
}

/* Also what an interrupted run may leave: the name with MPM_PARTIAL_SUFFIX. */
static bool is_result_name(const char *name)
{
    static const char *const names[] = {MPM_RUN_RECORD_NAME, MPM_HISTORY_NAME, MPM_SERIES_LIST,
                                        MPM_CHECKPOINT_NAME, MPM_CHECKPOINT_PREVIOUS};
    char *whole = g_strdup(name);
    if (g_str_has_suffix(whole, MPM_PARTIAL_SUFFIX))
        whole[strlen(whole) - strlen(MPM_PARTIAL_SUFFIX)] = '\0';
    bool is_result = is_snapshot_name(whole);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        is_result = is_result || strcmp(whole, names[i]) == 0;
    g_free(whole);
    return is_result;
}

static bool is_any_result(const char *name, size_t snapshots)
{
    (void)snapshots;
    return is_result_name(name);
}

/* Of a run that goes on after so many snapshots. */
static bool is_left_over(const char *name, size_t snapshots)
{
    if (!is_result_name(name))
        return false;
    return strcmp(name, MPM_RUN_RECORD_NAME) == 0 || g_str_has_suffix(name, MPM_PARTIAL_SUFFIX) ||
           (is_snapshot_name(name) &&
            g_ascii_strtoull(name + strlen(MPM_SERIES_PREFIX), NULL, 10) >= snapshots);
}

typedef bool (*name_test)(const char *name, size_t snapshots);

/* The name of a file in the folder that is one of those (g_free), or NULL. */
static char *find_result(const char *folder, name_test is_one, size_t snapshots, GError **failure)
{
    GDir *directory = g_dir_open(folder, 0, failure);
    if (directory == NULL)
        return NULL;
    const char *name = g_dir_read_name(directory);
    while (name != NULL && !is_one(name, snapshots))
        name = g_dir_read_name(directory);
    char *found = g_strdup(name);
    g_dir_close(directory);
    return found;
}

enum mpm_status mpm_results_folder_check(const char *folder, bool overwrite,
                                         struct mpm_error *error)
{
    if (folder[0] == '\0')
        return mpm_error_set(error, MPM_BAD_INPUT, "output: the name of the folder is empty");
    if (!g_file_test(folder, G_FILE_TEST_EXISTS))
        return MPM_OK;
    if (!g_file_test(folder, G_FILE_TEST_IS_DIR))
        return mpm_error_set(error, MPM_BAD_INPUT, "output: '%s' is a file; a folder is needed",
                             folder);
    GError *failure = NULL;
    char *name = find_result(folder, is_any_result, 0, &failure);
    enum mpm_status status = MPM_OK;
    if (failure != NULL)
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "output: %s", failure->message);
    else if (name != NULL && !overwrite)
        status = mpm_error_set(error, MPM_BAD_INPUT,
                               "output: '%s' holds results (%s); name another folder or allow "
                               "--overwrite",
                               folder, name);
    g_clear_error(&failure);
    g_free(name);
    return status;
}

static enum mpm_status remove_results(const char *folder, name_test is_one, size_t snapshots,
                                      struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    for (char *name;
         status == MPM_OK && (name = find_result(folder, is_one, snapshots, NULL)) != NULL;
         g_free(name)) {
        char *path = g_build_filename(folder, name, NULL);
        if (g_unlink(path) != 0)
            status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be removed: %s", path,
                                   g_strerror(errno));
        g_free(path);
    }
    return status;
}

enum mpm_status mpm_results_folder_rewind(const char *folder, size_t snapshots,
                                          struct mpm_error *error)
{
    return remove_results(folder, is_left_over, snapshots, error);
}

/* --------------------------------------------------------------------- lock */

/* Is the open file still the one of that name? The run before may have removed it in between. */
static bool has_name(int file, const char *path)
{
    struct stat opened, named;
    return fstat(file, &opened) == 0 && stat(path, &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

/* A descriptor that has the lock, or below 0 with errno: EWOULDBLOCK where another has it. */
static int take_lock(const char *path)
{
    for (;;) {
        const int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file < 0)
            return file;
        if (flock(file, LOCK_EX | LOCK_NB) == 0) {
            if (has_name(file, path))
                return file;
        } else if (errno != EINTR) {
            const int failure = errno;
            (void)close(file);
            errno = failure;
            return -1;
        }
        (void)close(file);
    }
}

enum mpm_status mpm_results_folder_lock(const char *folder, struct mpm_folder_lock *lock,
                                        struct mpm_error *error)
{
    char *const path = g_build_filename(folder, MPM_FOLDER_LOCK_NAME, NULL);
    enum mpm_status status = MPM_OK;
    lock->file = take_lock(path);
    if (lock->file < 0 && errno == EWOULDBLOCK)
        status = mpm_error_set(error, MPM_BAD_INPUT,
                               "output: another run writes to '%s'; name another folder, or wait "
                               "for its end",
                               folder);
    else if (lock->file < 0)
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be locked: %s", path,
                               g_strerror(errno));
    lock->path = status == MPM_OK ? path : NULL;
    if (status != MPM_OK)
        g_free(path);
    return status;
}

void mpm_results_folder_unlock(struct mpm_folder_lock *lock)
{
    if (lock->path == NULL)
        return;
    (void)g_unlink(lock->path); /* while it is locked: nobody else has this file and the lock */
    (void)close(lock->file);
    g_free(lock->path);
    *lock = (struct mpm_folder_lock){.file = -1};
}

/* -------------------------------------------------------------------- start */

enum mpm_status mpm_results_folder_prepare(const char *folder, bool overwrite,
                                           struct mpm_folder_lock *lock, struct mpm_error *error)
{
    if (g_mkdir_with_parents(folder, 0777) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be made: %s", folder, g_strerror(errno));
    if (g_access(folder, W_OK | X_OK) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be written to: %s", folder,
                             g_strerror(errno));
    MPM_TRY(mpm_results_folder_lock(folder, lock, error));
    MPM_TRY(mpm_results_folder_check(folder, overwrite, error));
    return remove_results(folder, is_any_result, 0, error);
}
