/* A run of the suite: plan, schedule, judge, record, report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_RUN_H
#define VERIFICATION_SUITE_RUN_H

#include "verification/suite/console.h"

struct run_options {
    const char *catalogue, *reports, *output; /* folders */
    const char *command;                      /* as typed, for provenance */
    const char *baseline;                     /* folder of an earlier run, or NULL */
    struct plan_selection selection;
    enum mpm_kernels kernels; /* for every measurement */
    unsigned jobs;            /* programs at a time, >= 1 */
};

/* Runs the selected checks and writes the output folder. *counts: how they came
 * out: red checks are no failure of this function. MPM_BAD_INPUT: catalogue, selection
 * or output folder; MPM_ENVIRONMENT_FAILED: interrupted, cannot be written, or a figure cannot be
 * drawn (then *counts and all else are there). */
enum mpm_status suite_run(const struct run_options *options, struct program_table programs,
                          struct console *console, struct record_counts *counts,
                          struct mpm_error *error);

#endif
