/* The budget: how many instructions and bytes a handful of small runs may cost.
 *
 * All figures are deterministic, so that a gate can rest on them on any machine, busy or
 * not. A stored budget holds for one compiler and one processor architecture, and each run
 * of it for the instructions (SIMD) that it was stored with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_BUDGET_BUDGET_H
#define BENCHMARKS_BUDGET_BUDGET_H

#include "benchmarks/measuring/instructions.h"

#include <glib.h>
#include <jansson.h>

/* ------------------------------------------------------------------- verdicts */

/* What a figure may grow by. Instructions: 3 %, since another minor version of the compiler
 * or of the C library moves them a little. Branches: 1.5 %, since one more for each vector
 * of four particles is 0.25 of 10 to 13, 2 %. Bytes: 0.2 %, room for a few hundred bytes that a
 * simulation has once; one byte more for each particle is 0.23 % of R1's 426. */
#define BUDGET_INSTRUCTIONS_TOLERANCE 0.03
#define BUDGET_BRANCHES_TOLERANCE     0.015
#define BUDGET_BYTES_TOLERANCE        0.002

enum budget_verdict {
    BUDGET_KEPT,
    BUDGET_BETTER, /* so far below that the lower figure should be stored */
    BUDGET_EXCEEDED,
};

/* Exceeded above stored (1 + tolerance), better below stored (1 - tolerance). What is not a
 * number exceeds any budget, and anything above zero a budget of zero. */
enum budget_verdict budget_judge(double measured, double stored, double tolerance);

/* -------------------------------------------------------------------- figures */

enum budget_figure { BUDGET_INSTRUCTIONS, BUDGET_BRANCHES, BUDGET_BYTES, BUDGET_FIGURES };

/* Name in the file and in the table. */
extern const struct budget_figure_kind {
    const char *name;
    double tolerance;
} budget_figures[BUDGET_FIGURES];

/* What one run costs: instructions and conditional branches for each particle and step,
 * bytes for each particle. */
struct budget_cost {
    double figures[BUDGET_FIGURES];
    char kernels[INSTRUCTIONS_TEXT], simd[INSTRUCTIONS_TEXT];
};
struct budget_cost budget_cost_of(const struct instructions *counted);

/* ------------------------------------------------------------------- the file */

/* What a budget holds for: "gcc 12" of "gcc 12.2.0", "x86_64", the flags of the build. */
struct budget_build {
    char compiler[INSTRUCTIONS_TEXT], architecture[INSTRUCTIONS_TEXT], flags[INSTRUCTIONS_TEXT];
};

/* Of this program, which is built with the others. */
struct budget_build budget_build_here(void);

struct budget {
    struct budget_build build;
    json_t *runs; /* object: name of the run to its cost */
};

/* An empty one. */
struct budget budget_make(const struct budget_build *build);
void budget_clear(struct budget *budget);

/* MPM_BAD_INPUT: the file is missing, is not JSON, or lacks one of the keys. */
enum mpm_status budget_read(const char *path, struct budget *budget, struct mpm_error *error);

/* Writes the file whole or not at all. MPM_ENVIRONMENT_FAILED. */
enum mpm_status budget_write(const char *path, const struct budget *budget,
                             struct mpm_error *error);

/* The cost stored for a run; false if there is none. */
bool budget_find(const struct budget *budget, const char *run, struct budget_cost *cost);
void budget_store(struct budget *budget, const char *run, const struct budget_cost *cost);

#endif
