/* Files and folders, for the output folder and what is kept in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_FOLDERS_H
#define VERIFICATION_COMMON_FOLDERS_H

#include "verification/common/failure.h"

#include <glib.h>
#include <stdbool.h>

/* MPM_ENVIRONMENT_FAILED: "<path>: cannot be written: <errno in words>". */
enum mpm_status folder_failed(const char *path, struct mpm_error *error);

/* Makes it, with those that it is in. */
enum mpm_status folder_make(const char *path, struct mpm_error *error);

/* The names in a folder, sorted; none of one that is not there. g_ptr_array_unref, but on failure
 * NULL: MPM_ENVIRONMENT_FAILED, or MPM_BAD_INPUT for what is no folder. */
enum mpm_status folder_names(const char *folder, GPtrArray **names, struct mpm_error *error);

/* Removes a file, or a folder with all that it holds; a path where there is nothing is fine. */
enum mpm_status folder_remove(const char *path, struct mpm_error *error);

#endif
