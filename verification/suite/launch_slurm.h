/* A run on Slurm.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_LAUNCH_SLURM_H
#define VERIFICATION_SUITE_LAUNCH_SLURM_H

#include "verification/suite/run.h"

/* As suite_run, with the programs as tasks of job arrays; waits for them and makes the report. Time
 * and memory are asked for by what the programs took in the run that `costs` names (folder of a
 * report; the output folder if NULL), or else by the time-outs of their cases. A task that ends
 * without a result is submitted again, twice at most, with the time-out of its case.
 * MPM_INTERRUPTED: the tasks go on, and a run that goes on waits for them again. */
enum mpm_status launch_slurm(const struct run_options *options, struct program_table programs,
                             const char *program, const char *costs, struct console *console,
                             struct record_counts *counts, int *signal_number,
                             struct mpm_error *error);

#endif
