/* The scheduler: runs the jobs of a plan, each in a process (and process group) of its
 * own, some at a time, each with its time-out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_SCHEDULE_H
#define VERIFICATION_SUITE_SCHEDULE_H

#include "verification/suite/judge.h"
#include "verification/suite/plan.h"

struct schedule_options {
    const char *output; /* folder; the jobs of a case write in <output>/cases/<case> */
    unsigned jobs;      /* at a time, >= 1 */
    struct mpm_simulation_options simulation; /* of each job */
    /* Called, if not NULL, about ten times a second and when a job ends; `done` of the whole plan.
     */
    void (*progress)(void *context, size_t done, size_t total);
    /* Called, if not NULL, when a job ends; a failure ends the run. */
    enum mpm_status (*finished)(void *context, size_t job, const struct job_result *result,
                                struct mpm_error *error);
    void *context;
};

/* Runs every job whose results[i] has no rows yet; results[i] belongs to plan->jobs[i] and its rows
 * are to be freed with schedule_clear. A job that fails, crashes or hangs is a result.
 * MPM_INTERRUPTED: a signal of interruption.h has come; or else what `finished` has failed with.
 * Then every process group is killed, and the jobs that have not ended are JOB_NOT_RUN. */
enum mpm_status schedule_run(const struct plan *plan, const struct schedule_options *options,
                             struct job_result *results, struct mpm_error *error);
void schedule_clear(struct job_result *results, size_t count);

/* Path of a file of a job: <output>/cases/<case>/<prefix>-<variant><suffix>; g_free. */
char *schedule_path(const char *output, const struct planned_job *job, const char *prefix,
                    const char *suffix);

#endif
