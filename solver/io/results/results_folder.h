/* The folder that a run writes to.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_RESULTS_FOLDER_H
#define MPM_IO_RESULTS_FOLDER_H

#include "model/scene.h"

/* Checks without touching: a path that is not a folder, or a folder that holds results
 * unless `overwrite`, is MPM_BAD_INPUT. A path where there is nothing is fine. */
enum mpm_status mpm_results_folder_check(const char *folder, bool overwrite,
                                         struct mpm_error *error);

/* Makes the folder, its parents included, if it is not there and removes the result
 * files of an earlier run, no other files. MPM_ENVIRONMENT_FAILED if that cannot be
 * done or the folder cannot be written to. */
enum mpm_status mpm_results_folder_prepare(const char *folder, struct mpm_error *error);

#endif
