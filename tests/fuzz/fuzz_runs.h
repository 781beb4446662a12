/* Runs that the harnesses of checkpoints go on from: small scenes, 36 steps of each taken, four of
 * them since a sort.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_FUZZ_FUZZ_RUNS_H
#define TESTS_FUZZ_FUZZ_RUNS_H

#include "model/scene.h"

enum { FUZZ_RUNS = 3, FUZZ_STEPS = 36 };

/* The scenes of tests/fuzz/scenes, read once; ends the program where one cannot be read. */
const struct mpm_scene *fuzz_run_scene(size_t run);

/* Reference kernels, which are compiled with sanitizers. */
extern const struct mpm_simulation_options fuzz_run_options;

#endif
