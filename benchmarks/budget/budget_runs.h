/* The runs that have a budget, and counting them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_BUDGET_BUDGET_RUNS_H
#define BENCHMARKS_BUDGET_BUDGET_RUNS_H

#include "benchmarks/budget/budget.h"

enum { BUDGET_SETTINGS = 5 };

struct budget_run {
    const char *name;
    const char *scene; /* of benchmarks/scenes, or a case's folder in the catalogue */
    enum mpm_kernels kernels;
    const char *settings[BUDGET_SETTINGS]; /* PATH=VALUE, ends with NULL */
};

extern const struct budget_run budget_runs[];
extern const size_t budget_runs_count;

/* Where the programs and scenes are. */
struct budget_places {
    const char *program;    /* mpm */
    const char *benchmarks; /* folder that holds scenes/ and budget.json */
    const char *catalogue;  /* folder of the suite's cases */
};

/* Takes the run's steps under callgrind. The errors of instructions_count. */
enum mpm_status budget_run_count(const struct budget_run *run, const struct budget_places *places,
                                 struct instructions *counted, struct mpm_error *error);

#endif
