/* A run of mpm-bench: folder, groups one after the other, records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_CLI_RUN_H
#define BENCHMARKS_CLI_RUN_H

#include "benchmarks/common/bench.h"

struct bench_run {
    const char *executable; /* argv[0] */
    const char *command;    /* as typed */
    const char *output;     /* folder; NULL: the usual one */
    char *const *groups;    /* names, NULL at the end; NULL: all */
    enum bench_tier tier;
    struct mpm_simulation_options simulation;
};

/* Runs the groups and writes bench.jsonl after each. MPM_BAD_INPUT, with nothing written: no
 * such group, or an output that is a file or a folder with something else in it. */
enum mpm_status bench_run(const struct bench_run *run, struct bench_console *console,
                          struct mpm_error *error);

#endif
