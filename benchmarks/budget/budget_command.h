/* `mpm-bench budget`: counts the runs and holds them against what is stored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_BUDGET_BUDGET_COMMAND_H
#define BENCHMARKS_BUDGET_BUDGET_COMMAND_H

#include "benchmarks/budget/budget_runs.h"

#include <stdio.h>

#define BUDGET_FILE "budget.json"

struct budget_options {
    const struct budget_places *places;
    bool update;    /* store what is counted */
    bool functions; /* name the costliest functions of each run */
    FILE *out;
};

/* Prints a table of the runs, counted and stored; *exceeded: whether one of
 * them costs more than its budget, has none, or took other kernels than it was stored for.
 * A build by another compiler or for another processor has no budget: one line says so, and
 * nothing is run. Cost: 25 s. */
enum mpm_status budget_command(const struct budget_options *options, bool *exceeded,
                               struct mpm_error *error);

/* Why a budget does not apply to a build, NULL if it does; g_free. */
char *budget_reason_to_skip(const struct budget_build *stored, const struct budget_build *here);

#endif
