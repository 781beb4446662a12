/* Statistics of repeated measurements.
 *
 * Medians, since a shared machine's noise is one-sided; intervals by the bootstrap, since
 * its distribution is not known: resamples with replacement, their 2.5 and 97.5 percentiles.
 * The generator starts from a fixed seed: the same samples give the same interval.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_STATISTICS_H
#define BENCHMARKS_COMMON_STATISTICS_H

#include <stddef.h>

struct bench_interval {
    double median, low, high; /* 95 % */
};

/* Is a larger value of the quantity a faster program (a rate), or a slower one (a time)? */
enum bench_sense { BENCH_RATE, BENCH_COST };

enum bench_verdict { BENCH_NOT_RESOLVED, BENCH_FASTER, BENCH_SLOWER };

/* A difference smaller than this part is not called one, however well it is resolved. */
#define BENCH_LEAST_DIFFERENCE 0.05

/* The least number of rounds: all of n rounds lie on one side of the true median with
 * probability 2^(1-n), so no interval of fewer than five can be one of 94 % or more. */
enum { BENCH_ROUNDS_MIN = 5 };

/* Median of `count` >= 1 values. */
double bench_median(const double *values, size_t count);

/* Median with its interval; one value is its own interval. */
struct bench_interval bench_interval_of(const double *values, size_t count);

/* Of the ratios values[i] / against[i], i a round: what slows a round down cancels. */
struct bench_interval bench_ratio_paired(const double *values, const double *against, size_t count);

/* Of the ratio of the medians of two sets of rounds that have nothing to do with each other. */
struct bench_interval bench_ratio_unpaired(const double *values, size_t count,
                                           const double *against, size_t against_count);

/* Faster or slower only if 1 lies outside the interval and the ratio is beyond 1 by
 * BENCH_LEAST_DIFFERENCE (over 1.05, or under 1/1.05); never from fewer than BENCH_ROUNDS_MIN
 * rounds. */
enum bench_verdict bench_verdict_of(struct bench_interval ratio, size_t rounds,
                                    enum bench_sense sense);

/* "faster", "slower", "not resolved" */
const char *bench_verdict_name(enum bench_verdict verdict);

#endif
