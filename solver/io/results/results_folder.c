/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/results_folder.h"

#include "io/checkpoint/checkpoint.h"
#include "io/results/crack_lines.h"
#include "io/results/history.h"
#include "io/results/probes.h"
#include "io/results/run_record.h"
#include "io/results/series.h"
#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <string.h>
#include <unistd.h>

/* particles-123456.hdf or cracks-123456.vtp; *number is that. */
static bool is_snapshot_name(const char *name, uint64_t *number)
{
    return mpm_series_number(name, MPM_SERIES_PREFIX, MPM_SERIES_SUFFIX, number) ||
           mpm_series_number(name, MPM_CRACKS_PREFIX, MPM_CRACKS_SUFFIX, number);
}

/* Also what an interrupted run may leave: the name with MPM_PARTIAL_SUFFIX. */
static bool is_result_name(const char *name)
{
    static const char *const names[] = {
        MPM_RUN_RECORD_NAME, MPM_HISTORY_NAME,    MPM_SERIES_LIST,        MPM_CRACKS_LIST,
        MPM_PROBES_NAME,     MPM_CHECKPOINT_NAME, MPM_CHECKPOINT_PREVIOUS};
    char *whole = g_strdup(name);
    if (g_str_has_suffix(whole, MPM_PARTIAL_SUFFIX))
        whole[strlen(whole) - strlen(MPM_PARTIAL_SUFFIX)] = '\0';
    uint64_t number;
    bool is_result = is_snapshot_name(whole, &number);
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
    uint64_t number = 0;
    if (!is_result_name(name))
        return false;
    return strcmp(name, MPM_RUN_RECORD_NAME) == 0 || g_str_has_suffix(name, MPM_PARTIAL_SUFFIX) ||
           (is_snapshot_name(name, &number) && number >= snapshots);
}

typedef bool (*name_test)(const char *name, size_t snapshots);

/* MPM_ENVIRONMENT_FAILED: the folder cannot be read. The first of its files that is one of those
 * (g_free), or NULL. */
static enum mpm_status find_result(const char *folder, char **name, struct mpm_error *error)
{
    char **const names = mpm_folder_list(folder);
    *name = NULL;
    if (names == NULL)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "output: %s: cannot be read: %s",
                             folder, g_strerror(errno));
    for (char **one = names; *name == NULL && *one != NULL; one++)
        if (is_any_result(*one, 0))
            *name = g_strdup(*one);
    mpm_folder_list_free(names);
    return MPM_OK;
}

enum mpm_status mpm_results_folder_check(const char *folder, bool overwrite,
                                         struct mpm_error *error)
{
    if (folder[0] == '\0')
        return mpm_error_set(error, MPM_BAD_INPUT, "output: the name of the folder is empty");
    const enum mpm_path kind = mpm_path_kind(folder);
    if (kind == MPM_PATH_NONE)
        return MPM_OK;
    if (kind == MPM_PATH_UNKNOWN)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "output: %s: cannot be read: %s",
                             folder, g_strerror(errno));
    if (kind != MPM_PATH_FOLDER)
        return mpm_error_set(error, MPM_BAD_INPUT, "output: '%s' is a file; a folder is needed",
                             folder);
    char *name = NULL;
    MPM_TRY(find_result(folder, &name, error));
    enum mpm_status status = MPM_OK;
    if (name != NULL && !overwrite)
        status = mpm_error_set(error, MPM_BAD_INPUT,
                               "output: '%s' holds results (%s); name another folder or allow "
                               "--overwrite",
                               folder, name);
    g_free(name);
    return status;
}

static enum mpm_status remove_results(const char *folder, name_test is_one, size_t snapshots,
                                      struct mpm_error *error)
{
    char **const names = mpm_folder_list(folder);
    if (names == NULL)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "output: %s: cannot be read: %s",
                             folder, g_strerror(errno));
    enum mpm_status status = MPM_OK;
    for (char **name = names; status == MPM_OK && *name != NULL; name++) {
        char *path = g_build_filename(folder, *name, NULL);
        if (is_one(*name, snapshots) && mpm_file_remove(path) != 0)
            status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be removed: %s", path,
                                   g_strerror(errno));
        g_free(path);
    }
    mpm_folder_list_free(names);
    return status;
}

enum mpm_status mpm_results_folder_rewind(const char *folder, size_t snapshots,
                                          struct mpm_error *error)
{
    return remove_results(folder, is_left_over, snapshots, error);
}

/* --------------------------------------------------------------------- lock */

enum mpm_status mpm_results_folder_lock(const char *folder, struct mpm_folder_lock *lock,
                                        struct mpm_error *error)
{
    char *const path = g_build_filename(folder, MPM_FOLDER_LOCK_NAME, NULL);
    enum mpm_status status = MPM_OK;
    lock->file = mpm_file_open_locked(path, false);
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
    /* while it is locked: nobody else has this file and the lock */
    (void)mpm_file_remove(lock->path);
    (void)mpm_file_close(lock->file);
    g_free(lock->path);
    *lock = (struct mpm_folder_lock){.file = -1};
}

/* -------------------------------------------------------------------- start */

enum mpm_status mpm_results_folder_prepare(const char *folder, bool overwrite,
                                           struct mpm_folder_lock *lock, struct mpm_error *error)
{
    if (mpm_folder_make(folder) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be made: %s", folder, g_strerror(errno));
    if (mpm_path_access(folder, W_OK | X_OK) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be written to: %s", folder,
                             g_strerror(errno));
    MPM_TRY(mpm_results_folder_lock(folder, lock, error));
    MPM_TRY(mpm_results_folder_check(folder, overwrite, error));
    return remove_results(folder, is_any_result, 0, error);
}
