/* Slurm: the tasks of a run as job arrays.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_SLURM_H
#define VERIFICATION_SUITE_SLURM_H

#include "verification/suite/session.h"

/* What a task is asked of the engine for. */
struct slurm_task {
    char *name;       /* CASE/VARIANT; g_free */
    double minutes;   /* of the clock */
    double mebibytes; /* 0: the engine's own default */
};

/* Submits the tasks (elements struct slurm_task, sorted by what they ask for) with sbatch: one
 * array for all that ask for the same, of up to 1000. `program` is the path of mpm-verify. Scripts,
 * lists and logs go to .run/slurm/. MPM_ENVIRONMENT_FAILED: sbatch is not there, or refuses. */
enum mpm_status slurm_submit(const struct output_folder *output, const char *program,
                             const GArray *tasks, struct mpm_error *error);

/* The tasks of this run that Slurm has: name to state ("RUNNING", "PENDING", ...);
 * g_hash_table_unref. *queue is NULL if none was ever submitted. MPM_ENVIRONMENT_FAILED: Slurm does
 * not answer. */
enum mpm_status slurm_queue(const struct output_folder *output, GHashTable **queue,
                            struct mpm_error *error);

/* Numbers of the run's jobs, with blanks between them; g_free. */
char *slurm_jobs(const struct output_folder *output);

#endif
