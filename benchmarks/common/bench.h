/* mpm-bench: what its groups share.
 *
 * A group is one file with one line in groups.c. It measures through timing.h, or by itself,
 * and hands what it found to findings.h, which keeps it for bench.jsonl and shows it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_BENCH_H
#define BENCHMARKS_COMMON_BENCH_H

#include "mpm.h"

#include "benchmarks/common/console.h"
#include "benchmarks/common/records.h"

enum bench_tier { BENCH_QUICK, BENCH_STANDARD };

struct bench_context {
    enum bench_tier tier;
    struct mpm_simulation_options simulation; /* what a point has unless it varies them; 1 thread */
    unsigned processors;                      /* that this process may use, >= 1 */
    const char *executable;                   /* argv[0] */
    const char *benchmarks;                   /* folder that holds scenes/ */
    const char *catalogue;                    /* folder of the suite's cases; NULL: none found */
    const char *output;                       /* folder of the results; exists */
    struct bench_records *records;            /* what was found so far */
    struct bench_console *console;
};

struct bench_group {
    const char *name;        /* of --group and of the lines */
    const char *title;       /* heading, a few words */
    const char *description; /* one sentence */
    enum mpm_status (*run)(struct bench_context *context, struct mpm_error *error);
};

/* All groups in the order they run; *count of them. */
const struct bench_group *bench_groups(size_t *count);

/* "quick", "standard" */
const char *bench_tier_name(enum bench_tier tier);

/* Path of a scene of benchmarks/scenes, or of the suite's case (folder in its catalogue, as
 * "R/R1"); g_free. */
char *bench_scene(const struct bench_context *context, const char *name);
char *bench_case_scene(const struct bench_context *context, const char *folder);

/* The groups' own functions, each in the file of its name. */
enum mpm_status bench_throughput(struct bench_context *context, struct mpm_error *error);
enum mpm_status bench_limit(struct bench_context *context, struct mpm_error *error);
enum mpm_status bench_overhead(struct bench_context *context, struct mpm_error *error);
enum mpm_status bench_accuracy(struct bench_context *context, struct mpm_error *error);
enum mpm_status bench_scaling(struct bench_context *context, struct mpm_error *error);

#endif
