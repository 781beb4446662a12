/* Workers: threads that share the items of a job.
 *
 * The thread that calls is worker 0; the others are helpers that it keeps from job to job. Items
 * are taken one by one by whoever is free, so that a helper that other programs keep from running
 * delays nobody who has not seen it take an item: with helpers asleep, worker 0 does all of them.
 *
 * Helpers without an item, and worker 0 while a helper has the last one, look for a change during
 * 50 microseconds and then sleep. OMP_WAIT_POLICY=passive in the environment lets them sleep at
 * once, OMP_WAIT_POLICY=active search without end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_WORKERS_H
#define MPM_BASE_WORKERS_H

#include <stdint.h>

/* Runs work(context, item, worker) for items 0 .. count - 1, in no stated order, `worker` in
 * [0, workers). Returns when all are done. Each calling thread has helpers of its own: made when
 * first needed, gone when it ends. If the system has no thread to give, fewer workers do the same
 * work. In a child of fork helpers are made again. Called by `work` of a shared job, it runs all
 * items in the thread that calls, in order, as worker 0: the team is busy with the job outside. */
void mpm_workers_run(int64_t count, int workers,
                     void (*work)(void *context, int64_t item, int worker), void *context);

/* How many helpers of the calling thread sleep: 0 .. the number it has. One that looks for a change
 * counts from when it gives up. Cost: an atomic load. */
int mpm_workers_asleep(void);

#endif
