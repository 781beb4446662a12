/* Names of files, and folders.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/files/calls.h"
#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <string.h>

/* -------------------------------------------------------------------- questions */

static enum mpm_path kind_of(int failed, const struct stat *facts)
{
    if (failed != 0)
        return errno == ENOENT || errno == ENOTDIR ? MPM_PATH_NONE : MPM_PATH_UNKNOWN;
    if (S_ISREG(facts->st_mode))
        return MPM_PATH_FILE;
    return S_ISDIR(facts->st_mode) ? MPM_PATH_FOLDER : MPM_PATH_OTHER;
}

enum mpm_path mpm_path_kind(const char *path)
{
    struct stat facts;
    const int failed = system_stat(path, &facts);
    return kind_of(failed, &facts);
}

enum mpm_path mpm_path_own_kind(const char *path)
{
    struct stat facts;
    const int failed = system_lstat(path, &facts);
    return kind_of(failed, &facts);
}

bool mpm_path_exists(const char *path)
{
    return mpm_path_kind(path) > MPM_PATH_NONE;
}

bool mpm_path_is_file(const char *path)
{
    return mpm_path_kind(path) == MPM_PATH_FILE;
}

bool mpm_path_is_folder(const char *path)
{
    return mpm_path_kind(path) == MPM_PATH_FOLDER;
}

int mpm_path_access(const char *path, int rights)
{
    return system_access(path, rights);
}

/* ------------------------------------------------------------------------- names */

int mpm_path_rename(const char *from, const char *to)
{
    return system_rename(from, to);
}

int mpm_path_link(const char *target, const char *path)
{
    return system_symlink(target, path);
}

int mpm_file_remove(const char *path)
{
    return system_unlink(path);
}

/* ----------------------------------------------------------------------- folders */

/* The folder is there afterwards. */
static int make_one(const char *path)
{
    if (system_mkdir(path, 0777) == 0)
        return 0;
    int reason = errno;
    const enum mpm_path there = mpm_path_kind(path);
    if (reason == EEXIST) /* what is there is no folder, or cannot be looked at */
        reason = there == MPM_PATH_UNKNOWN ? errno : ENOTDIR;
    errno = reason;
    return there == MPM_PATH_FOLDER ? 0 : -1;
}

int mpm_folder_make(const char *path)
{
    int failed = make_one(path);
    if (failed == 0 || errno != ENOENT)
        return failed;
    char *const parent = g_strdup(path);
    failed = 0;
    for (char *c = parent + 1; failed == 0 && parent[0] != '\0' && *c != '\0'; c++)
        if (*c == '/' && c[-1] != '/') {
            *c = '\0';
            failed = make_one(parent);
            *c = '/';
        }
    g_free(parent);
    return failed == 0 ? make_one(path) : failed;
}

enum mpm_status mpm_folder_make_temporary(char **path, struct mpm_error *error)
{
    *path = g_build_filename(g_get_tmp_dir(), "touchstone-XXXXXX", NULL);
    if (system_mkdtemp(*path) != NULL)
        return MPM_OK;
    const enum mpm_status status = mpm_file_failed(*path, errno, error);
    g_free(*path);
    *path = NULL;
    return status;
}

int mpm_folder_remove(const char *path)
{
    return system_rmdir(path);
}

int mpm_folder_sync(const char *path)
{
    const int folder = mpm_file_open(path, O_RDONLY | O_DIRECTORY);
    if (folder < 0)
        return -1;
    /* EINVAL: a file system whose folders need no sync */
    const int failed = mpm_file_sync(folder) == 0 || errno == EINVAL ? 0 : -1;
    const int reason = errno;
    (void)mpm_file_close(folder);
    errno = reason;
    return failed;
}

static gint compare_names(gconstpointer a, gconstpointer b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

char **mpm_folder_list(const char *path)
{
    DIR *const folder = system_opendir(path);
    if (folder == NULL)
        return NULL;
    GPtrArray *const names = g_ptr_array_new();
    errno = 0;
    for (struct dirent *entry; (entry = system_readdir(folder)) != NULL; errno = 0)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            g_ptr_array_add(names, g_strdup(entry->d_name));
    const int reason = errno;
    (void)closedir(folder);
    g_ptr_array_sort(names, compare_names);
    g_ptr_array_add(names, NULL);
    char **const list = (char **)g_ptr_array_free(names, FALSE);
    if (reason == 0)
        return list;
    g_strfreev(list);
    errno = reason;
    return NULL;
}

void mpm_folder_list_free(char **names)
{
    g_strfreev(names);
}

/* The first thing that cannot be removed, and why. */
struct removal {
    char *path;
    int reason;
};

static void note_failure(struct removal *removal, const char *path)
{
    if (removal->path == NULL)
        *removal = (struct removal){g_strdup(path), errno};
}

/* Depth is that of what programs write: two or three. */
static void remove_all(const char *path, struct removal *removal) /* NOLINT(misc-no-recursion) */
{
    struct stat facts;
    if (system_lstat(path, &facts) != 0) {
        note_failure(removal, path);
        return;
    }
    if (!S_ISDIR(facts.st_mode)) {
        if (mpm_file_remove(path) != 0)
            note_failure(removal, path);
        return;
    }
    char **const names = mpm_folder_list(path);
    if (names == NULL)
        note_failure(removal, path);
    for (char **name = names; name != NULL && *name != NULL; name++) {
        char *const entry = g_build_filename(path, *name, NULL);
        remove_all(entry, removal);
        g_free(entry);
    }
    mpm_folder_list_free(names);
    if (mpm_folder_remove(path) != 0)
        note_failure(removal, path);
}

int mpm_folder_remove_all(const char *path, char **failed)
{
    struct removal removal = {NULL, 0};
    remove_all(path, &removal);
    const int status = removal.path == NULL ? 0 : -1;
    if (failed != NULL)
        *failed = g_steal_pointer(&removal.path);
    g_free(removal.path);
    errno = removal.reason;
    return status;
}
