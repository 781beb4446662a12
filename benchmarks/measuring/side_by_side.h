/* Runs side by side: what the machine itself gives when it has several things to do at once.
 *
 * Simulations of one scene that have nothing in common but the scene's text are stepped at the
 * same time, each by a thread of its own. They share caches, memory and what the processor allots
 * to its cores, and wait for one another nowhere: what they fall short by is the machine's doing.
 * They hold as much data as all of them together; threads of one simulation hold less, and may
 * come to more where caches or memory are the limit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_SIDE_BY_SIDE_H
#define BENCHMARKS_MEASURING_SIDE_BY_SIDE_H

#include "benchmarks/measuring/points.h"

struct bench_runs {
    const struct mpm_scene *scene;
    const struct mpm_simulation_options *options; /* of each: one thread */
    unsigned count;                               /* >= 1 */
    unsigned warm_up, steps;                      /* of each */
};

/* Creates the simulations one after the other, warms all of them up, and times their steps from
 * the start that they have in common to the last one's end. sample->work is the number of
 * steps of all of them. Holds all of their memory. Fails as the first one that does. */
enum mpm_status bench_side_by_side(const struct bench_runs *runs, struct bench_sample *sample,
                                   struct mpm_error *error);

#endif
