/* Fixed row strips in two colours: the unit of parallel work and, later, of
 * distributed runs.
 *
 * The grid is cut into strips of MPM_STRIP_ROWS cell rows, whatever the number of
 * workers. Even strips run first, then odd ones; strips of one colour do not touch
 * the same nodes, so scatter needs no atomics, and every node receives its
 * contributions in one order: results are the same bits for any number of workers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_STRIPS_H
#define MPM_BASE_STRIPS_H

#include <stdint.h>

enum { MPM_STRIP_ROWS = 8 };

/* Runs work(context, strip, worker) for every strip, even ones first. `worker` is
 * in [0, workers); a worker runs one strip at a time. */
void mpm_strips_run(int64_t strip_count, int workers,
                    void (*work)(void *context, int64_t strip, int worker), void *context);

/* Runs work(context, row, worker) for rows first..last, in no stated order. */
void mpm_rows_run(int64_t first, int64_t last, int workers,
                  void (*work)(void *context, int64_t row, int worker), void *context);

#endif
