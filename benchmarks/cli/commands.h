/* The commands of mpm-bench.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_CLI_COMMANDS_H
#define BENCHMARKS_CLI_COMMANDS_H

#include <stdbool.h>
#include <stdio.h>

/* What the commands see of the world; tests bring their own. */
struct bench_world {
    FILE *out, *err;
    bool terminal; /* out is one */
};

/* Runs the command of the arguments. Returns the exit status: 0 done, 1 a stored budget is
 * exceeded, 2 bad usage or bad input (nothing was written), 3 a run failed, 4 the environment
 * failed. */
int bench_command(int argc, char **argv, const struct bench_world *world);

#endif
