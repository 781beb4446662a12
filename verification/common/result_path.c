/* Paths inside a folder of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/result_path.h"

#include <stdbool.h>
#include <sys/stat.h>

static enum mpm_status check(const char *path, bool folder, struct mpm_error *error)
{
    struct stat found;
    if (lstat(path, &found) != 0 || (folder ? S_ISDIR(found.st_mode) : S_ISREG(found.st_mode)))
        return MPM_OK; /* a path that cannot be looked at cannot be read or written either */
    return failure_set(error, MPM_BAD_INPUT, "%s: is %s: allowed is a %s", path,
                       S_ISLNK(found.st_mode)   ? "a link"
                       : S_ISDIR(found.st_mode) ? "a folder"
                                                : "no ordinary file",
                       folder ? "folder" : "file");
}

enum mpm_status result_file_check(const char *path, struct mpm_error *error)
{
    return check(path, false, error);
}

enum mpm_status result_folder_check(const char *path, struct mpm_error *error)
{
    return check(path, true, error);
}
