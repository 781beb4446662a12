/* Paths inside a folder of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/result_path.h"

#include "mpm_file.h"

#include <errno.h>

static enum mpm_status check(const char *path, enum mpm_path allowed, struct mpm_error *error)
{
    const enum mpm_path kind = mpm_path_own_kind(path);
    if (kind == MPM_PATH_UNKNOWN)
        return mpm_file_unread(path, errno, NULL, error);
    if (kind == allowed || kind == MPM_PATH_NONE)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "%s: is %s: allowed is a %s", path,
                       kind == MPM_PATH_FILE                   ? "a file"
                       : kind == MPM_PATH_FOLDER               ? "a folder"
                       : mpm_path_kind(path) != MPM_PATH_OTHER ? "a link"
                                                               : "no ordinary file",
                       allowed == MPM_PATH_FOLDER ? "folder" : "file");
}

enum mpm_status result_file_check(const char *path, struct mpm_error *error)
{
    return check(path, MPM_PATH_FILE, error);
}

enum mpm_status result_folder_check(const char *path, struct mpm_error *error)
{
    return check(path, MPM_PATH_FOLDER, error);
}
