/* Folders for results that nobody keeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_SCRATCH_H
#define BENCHMARKS_COMMON_SCRATCH_H

#include "mpm.h"

/* A new empty folder in the system's folder for temporary files. MPM_ENVIRONMENT_FAILED
 * if there can be none; then *path is NULL. */
enum mpm_status scratch_create(char **path, struct mpm_error *error);

/* Removes the folder with all that it holds and frees the path; links are not followed.
 * NULL is fine. */
void scratch_remove(char *path);

#endif
