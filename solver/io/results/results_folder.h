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

/* One writer for each folder: a lock on its file run.lock, which ends with the process, however
 * that ends. The file is removed with the lock; one that is left behind locks nothing. */
#define MPM_FOLDER_LOCK_NAME "run.lock"
struct mpm_folder_lock {
    int file; /* below 0: none */
    char *path;
};
/* MPM_BAD_INPUT: another run writes to the folder. */
enum mpm_status mpm_results_folder_lock(const char *folder, struct mpm_folder_lock *lock,
                                        struct mpm_error *error);
void mpm_results_folder_unlock(struct mpm_folder_lock *lock);

/* Makes the folder, its parents included, if it is not there, locks it, checks it again and removes
 * the result files of an earlier run, no other files. MPM_BAD_INPUT: another run writes to it, or
 * has left results there since the first check. MPM_ENVIRONMENT_FAILED if that cannot be done or
 * the folder cannot be written to. */
enum mpm_status mpm_results_folder_prepare(const char *folder, bool overwrite,
                                           struct mpm_folder_lock *lock, struct mpm_error *error);

/* Removes what a run has left that goes on from a checkpoint with so many snapshots: those after
 * them, run.json, temporary files. */
enum mpm_status mpm_results_folder_rewind(const char *folder, size_t snapshots,
                                          struct mpm_error *error);

#endif
