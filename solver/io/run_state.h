/* A run while it goes on; private to the files run*.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_RUN_STATE_H
#define MPM_IO_RUN_STATE_H

#include "io/observers.h"
#include "io/results/history.h"
#include "io/results/probes.h"
#include "io/results/results_folder.h"
#include "io/results/run_record.h"
#include "io/results/series.h"

struct mpm_run {
    const struct mpm_scene *scene;
    const struct mpm_run_options *options;
    struct mpm_folder_lock lock;
    struct mpm_simulation *simulation;
    struct mpm_history *history; /* NULL, as the series, when nothing is written */
    struct mpm_series *series;
    struct mpm_probes *probes; /* NULL also without output.probes and output.lines */
    struct mpm_observers *observers;
    double history_instant, snapshot_instant; /* number of the last one passed */
    double checkpoint_instant;
    double checkpoint_time; /* on the clock of mpm_run_seconds, of the last one or of the start */
    struct mpm_run_record record;
    char growth_warning[MPM_MESSAGE_SIZE]; /* empty until it was given */
    char parted_warning[MPM_MESSAGE_SIZE]; /* the same */
    char melted_warning[MPM_MESSAGE_SIZE]; /* the same */
    char older_warning[MPM_MESSAGE_SIZE];  /* of the checkpoint that it has gone on from; */
    char build_warning[MPM_MESSAGE_SIZE];  /* empty if it has none */
    bool *tip_told; /* per J integral of the scene: has the end of its tip been reported? */
};

/* run.c: a clock that only goes on. */
double mpm_run_seconds(void);
/* Which instant of 0, interval, 2 interval, … has been reached; 0 without an interval. */
double mpm_run_instant(double time, double interval);
void mpm_run_warn(const struct mpm_run *run, const char *warning);

/* run_checkpoint.c: writes a checkpoint if one is due after the step just taken, or in any case. */
enum mpm_status mpm_run_checkpoint_due(struct mpm_run *run, struct mpm_error *error);
enum mpm_status mpm_run_checkpoint(struct mpm_run *run, struct mpm_error *error);
/* Creates the simulation, in the state of the checkpoint in the folder, and opens its results, cut
 * back to what they were then. */
enum mpm_status mpm_run_resume(struct mpm_run *run, struct mpm_error *error);

#endif
