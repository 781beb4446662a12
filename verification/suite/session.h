/* What all ways of running the programs of a run share: locally, one at a time, or on an engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_SESSION_H
#define VERIFICATION_SUITE_SESSION_H

#include "verification/suite/kept_result.h"
#include "verification/suite/run.h"

struct session {
    const struct run_options *options;
    struct catalogue *catalogue;
    struct plan plan;
    struct console *console;
    struct output_folder output;
    struct kept_place place;
    char **keys;                /* of the plan's jobs */
    struct job_result *results; /* of the plan's jobs; rows NULL: not known yet */
    gint64 start;               /* microseconds */
    const char *incomplete;     /* why, or NULL */
};

/* Reads the catalogue, makes plan and keys; the folder is named and not opened. On failure nothing
 * is to be closed. */
enum mpm_status session_open(const struct run_options *options, struct program_table programs,
                             struct console *console, struct session *session,
                             struct mpm_error *error);
void session_close(struct session *session);

/* Opens the folder for this process; begins a run there, unless it goes on with one. */
enum mpm_status session_take_folder(struct session *session, struct mpm_error *error);

/* Has the job a sound result? */
bool session_has(const struct session *session, size_t job);

/* By the results that the output folder has from an earlier run, if any: how long programs take. */
void session_expect_costs(const struct session *session);

/* Takes the results that are kept, with their files, into `results`, and prints their checks. */
enum mpm_status session_take_kept(const struct session *session, struct mpm_error *error);

/* The report of what there is. MPM_ENVIRONMENT_FAILED as output_report. */
enum mpm_status session_report(const struct session *session, struct record_counts *counts,
                               struct mpm_error *error);

/* The same of an interrupted run: *error says why, and goes into the report. MPM_INTERRUPTED, or
 * what the report has failed with. Without any result an earlier report stays. */
enum mpm_status session_report_interrupted(struct session *session, struct record_counts *counts,
                                           struct mpm_error *error);

#endif
