/* Timing: a list of points measured paired and interleaved, in rounds.
 *
 * A round visits every point once; rounds go forward and backward in turn, so that what
 * drifts meets every point alike. A simulation is created anew for each timing: every round
 * sees the same state and another placement in memory, which so becomes part of the noise
 * that the interval states, and no more than one simulation is held at a time (or those that run
 * side by side). Creation and warm-up are not timed. The first visit only chooses the number of
 * steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_TIMING_H
#define BENCHMARKS_MEASURING_TIMING_H

#include "benchmarks/common/bench.h"
#include "benchmarks/measuring/points.h"

/* Rounds: as many as fit into `seconds`, between BENCH_ROUNDS_MIN and this. */
enum { BENCH_ROUNDS_MAX = 9 };

/* The rates of a list: work per second, by the clock of the point. */
struct bench_rates {
    size_t points, rounds;
    double *values; /* [point * rounds + round] */
};
void bench_rates_clear(struct bench_rates *rates);
const double *bench_rates_of(const struct bench_rates *rates, size_t point);

/* Measures the list and writes its lines: for each point a result
 * "particle_steps_per_second" in 1/s (or the probe's quantity) by the clock of the point, one
 * by the other clock ("..._wall" or "..._cpu"), a value "bytes_per_particle" and results
 * "phase_NAME" in ns a particle-step where phases are selected, and a comparison where
 * `against` names a point. Rigid particles do not count. The rates are handed out if `rates`
 * is not NULL. Failures of a scene are passed on with the name of the point. */
enum mpm_status bench_measure(struct bench_context *context, const char *group, GArray *points,
                              double seconds, struct bench_rates *rates, struct mpm_error *error);

/* The usual group: lists measured one after the other. In the quick tier each has a tenth of
 * its seconds. */
struct bench_list {
    void (*add)(struct bench_context *context, GArray *points);
    double seconds; /* in the standard tier */
};
enum mpm_status bench_measure_lists(struct bench_context *context, const char *group,
                                    const struct bench_list *lists, size_t count,
                                    struct mpm_error *error);

/* Seconds: of the clock; of the processor, all threads of this process; the calling one. */
double bench_clock_wall(void);
double bench_clock_cpu(void);
double bench_clock_thread(void);

/* Takes so many steps. */
enum mpm_status bench_advance(struct mpm_simulation *simulation, unsigned steps,
                              struct mpm_error *error);

#endif
