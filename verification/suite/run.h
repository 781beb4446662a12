/* A run of the suite: plan, schedule, judge, record, report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_RUN_H
#define VERIFICATION_SUITE_RUN_H

#include "verification/suite/console.h"
#include "verification/suite/run_state.h"

struct run_options {
    const char *reports, *output; /* folders */
    struct run_texts texts;       /* completed, or of a run that goes on: taken from there */
    const char *command;          /* as typed, for provenance */
    const json_t *resumed;        /* run.json of a run that goes on, or NULL */
    struct plan_selection selection;
    enum mpm_kernels kernels; /* for every measurement */
    unsigned jobs;            /* programs at a time, >= 1 */
};

/* Runs the selected checks and writes the output folder; a run that goes on runs only what it has
 * no result of, by the keys of task_key.h. Each result is kept as its program ends. *counts: how
 * they came out: red checks are no failure of this function. MPM_BAD_INPUT: catalogue, selection or
 * output folder; MPM_ENVIRONMENT_FAILED: a file cannot be written, or a figure cannot be drawn
 * (then *counts and all else are there). MPM_INTERRUPTED: by *signal_number; the report of what
 * there is, marked incomplete, is written, unless there is nothing yet. */
enum mpm_status suite_run(const struct run_options *options, struct program_table programs,
                          struct console *console, struct record_counts *counts, int *signal_number,
                          struct mpm_error *error);

#endif
