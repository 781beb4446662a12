/* Instructions that the steps of a scene execute, counted by valgrind's callgrind.
 *
 * Counted is what mpm_simulation_advance executes, all that it calls included; setting up
 * and writing results are not, unless selected. The run has one thread, no environment, and sees
 * the scene, the program and its results under names that do not depend on where they are, so that
 * the same binary gives the same number anywhere (README.md states how nearly).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_INSTRUCTIONS_H
#define BENCHMARKS_MEASURING_INSTRUCTIONS_H

#include "mpm.h"

#include "benchmarks/measuring/callgrind_file.h"

struct instructions_request {
    const char *program;                      /* path of `mpm` */
    const char *scene;                        /* path of the scene */
    const char *const *settings;              /* PATH=VALUE, ends with NULL; NULL for none */
    unsigned steps;                           /* to take, from t = 0 */
    struct mpm_simulation_options simulation; /* kernels and simd; always one thread */
    /* Functions of the solver that are counted with all that they call, none of them by
     * another, ends with NULL; NULL: mpm_simulation_advance. */
    const char *const *functions;
};

enum { INSTRUCTIONS_TEXT = 256 };

struct instructions {
    struct callgrind_counts counts;
    /* of the program's own record of the run */
    uint64_t steps, particles, particle_steps;
    uint64_t bytes;
    double bytes_per_particle;
    char kernels[INSTRUCTIONS_TEXT], simd[INSTRUCTIONS_TEXT];
};

/* Per particle and step; branches are those of the program itself. */
double instructions_rate(const struct instructions *counted);
double instructions_branch_rate(const struct instructions *counted);

/* MPM_ENVIRONMENT_FAILED, with what to do about it, where there is no valgrind. */
enum mpm_status instructions_available(struct mpm_error *error);

/* Counts. Cost: the run, some 50 times slower, and 1.5 s. MPM_ENVIRONMENT_FAILED: no
 * valgrind, no scratch folder, valgrind or the program could not run; a failure of the
 * program itself keeps its status and message. */
enum mpm_status instructions_count(const struct instructions_request *request,
                                   struct instructions *counted, struct mpm_error *error);

#endif
