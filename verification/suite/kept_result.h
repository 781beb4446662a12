/* Results of programs that have ended, kept so that a run can go on: one file each, named by its
 * key (task_key.h), written whole, synced and renamed. It holds outcome, rows, log and data files,
 * in one line of JSON, and the SHA-256 of that line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_KEPT_RESULT_H
#define VERIFICATION_SUITE_KEPT_RESULT_H

#include "verification/suite/judge.h"
#include "verification/suite/plan.h"

struct kept_place {
    const char *results; /* folder of the kept files */
    const char *work;    /* folder whose cases/<case>/ has the files of the programs */
};

enum kept_state {
    KEPT_NOT,     /* there is none */
    KEPT_DAMAGED, /* a file that is cut short or changed: as if there were none */
    KEPT_SOUND,
};

/* Is it the program's own result? One that the environment or another process has ended is none: it
 * is reported, and run again when the run goes on. */
bool kept_is_result(const struct job_result *result);

/* Keeps what the job has left in place->work. MPM_ENVIRONMENT_FAILED: cannot be written; then there
 * is no such file. */
enum mpm_status kept_write(const struct kept_place *place, const char *key,
                           const struct planned_job *job, const struct job_result *result,
                           struct mpm_error *error);

/* Reads it into *result (rows: g_free) and puts its files into place->work, unless that is NULL.
 * MPM_ENVIRONMENT_FAILED: these cannot be written. */
enum mpm_status kept_read(const struct kept_place *place, const char *key,
                          const struct planned_job *job, struct job_result *result,
                          enum kept_state *state, struct mpm_error *error);

char *kept_path(const char *results, const char *key); /* g_free */

#endif
