/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/folders.h"

#include "mpm_file.h"
#include "verification/common/input.h"

#include <errno.h>

enum mpm_status folder_failed(const char *path, struct mpm_error *error)
{
    return mpm_file_failed(path, errno, error);
}

enum mpm_status folder_make(const char *path, struct mpm_error *error)
{
    return mpm_folder_make(path) == 0 ? MPM_OK : folder_failed(path, error);
}

enum mpm_status folder_names(const char *folder, GPtrArray **names, struct mpm_error *error)
{
    enum mpm_path kind;
    *names = NULL;
    TRY(input_kind(folder, &kind, error));
    if (kind != MPM_PATH_NONE)
        return input_names(folder, names, error);
    *names = g_ptr_array_new_with_free_func(g_free);
    return MPM_OK;
}

enum mpm_status folder_remove(const char *path, struct mpm_error *error)
{
    char *failed;
    enum mpm_status status = MPM_OK;
    if (mpm_folder_remove_all(path, &failed) != 0 && errno != ENOENT)
        status = folder_failed(failed, error);
    g_free(failed);
    return status;
}
