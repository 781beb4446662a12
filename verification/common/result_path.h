/* Paths inside a folder of results, which may come from anywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RESULT_PATH_H
#define VERIFICATION_COMMON_RESULT_PATH_H

#include "verification/common/failure.h"

/* Whether the path is missing or a file (a folder) itself: a link could lead out of the folder of
 * results, and a pipe or a device never ends. MPM_BAD_INPUT else. Folders above `path` are not
 * looked at. */
enum mpm_status result_file_check(const char *path, struct mpm_error *error);
enum mpm_status result_folder_check(const char *path, struct mpm_error *error);

#endif
