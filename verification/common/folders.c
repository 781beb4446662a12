/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/folders.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <string.h>

enum mpm_status folder_failed(const char *path, struct mpm_error *error)
{
    return failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                       g_strerror(errno));
}

enum mpm_status folder_make(const char *path, struct mpm_error *error)
{
    return g_mkdir_with_parents(path, 0777) == 0 ? MPM_OK : folder_failed(path, error);
}

static int compare_texts(const void *one, const void *other)
{
    return strcmp(*(const char *const *)one, *(const char *const *)other);
}

GPtrArray *folder_names(const char *folder)
{
    GPtrArray *names = g_ptr_array_new_with_free_func(g_free);
    GDir *directory = g_dir_open(folder, 0, NULL);
    for (const char *name; directory != NULL && (name = g_dir_read_name(directory)) != NULL;)
        g_ptr_array_add(names, g_strdup(name));
    if (directory != NULL)
        g_dir_close(directory);
    g_ptr_array_sort(names, compare_texts);
    return names;
}

/* A link to a folder is removed, and not what it leads to. */
static bool is_folder(const char *path)
{
    return g_file_test(path, G_FILE_TEST_IS_DIR) && !g_file_test(path, G_FILE_TEST_IS_SYMLINK);
}

enum mpm_status folder_remove(const char *path, struct mpm_error *error)
{
    if (!is_folder(path))
        return g_remove(path) == 0 || errno == ENOENT ? MPM_OK : folder_failed(path, error);
    enum mpm_status status = MPM_OK;
    GPtrArray *names = folder_names(path);
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        char *inner = g_build_filename(path, names->pdata[i], NULL);
        status = folder_remove(inner, error);
        g_free(inner);
    }
    g_ptr_array_unref(names);
    if (status == MPM_OK && g_rmdir(path) != 0 && errno != ENOENT)
        status = folder_failed(path, error);
    return status;
}
