/* The programs of a run as tasks of an engine: each is a command line of its own, and leaves its
 * result in the shared output folder, named by its key.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_CAMPAIGN_H
#define VERIFICATION_SUITE_CAMPAIGN_H

#include "verification/suite/run.h"
#include "verification/suite/session.h"

/* Begins a run, or goes on with one, and prints a command line for each program that has no result:
 * `program` is the path of mpm-verify. In the order of the catalogue. */
enum mpm_status campaign_tasks(const struct run_options *options, struct program_table programs,
                               const char *program, FILE *out, struct mpm_error *error);

/* Runs the task CASE/VARIANT of the run in options->output, unless it has a result, and keeps what
 * it leaves. Any number of tasks may run at a time. MPM_ENVIRONMENT_FAILED: there is no result; to
 * be run again. MPM_INTERRUPTED: the same, by *signal_number. */
enum mpm_status campaign_task(const struct run_options *options, struct program_table programs,
                              const char *task, int *signal_number, struct mpm_error *error);

/* The report of the results that there are, without running anything; incomplete if some are
 * missing. Else as suite_run. */
enum mpm_status campaign_collect(const struct run_options *options, struct program_table programs,
                                 struct console *console, struct record_counts *counts,
                                 struct mpm_error *error);
/* The same in a session whose folder is open. */
enum mpm_status campaign_report(struct session *session, struct record_counts *counts,
                                struct mpm_error *error);

/* How far the run in options->output is: a line for each program that is not done, and counts. */
enum mpm_status campaign_status(const struct run_options *options, struct program_table programs,
                                FILE *out, struct mpm_error *error);

char *campaign_task_name(const struct planned_job *job); /* CASE/VARIANT; g_free */

#endif
