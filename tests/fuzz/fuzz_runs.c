/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz_runs.h"

#include <stdio.h>
#include <stdlib.h>

const struct mpm_simulation_options fuzz_run_options = {.threads = 1,
                                                        .kernels = MPM_KERNELS_REFERENCE};

static struct mpm_scene *scenes[FUZZ_RUNS];

static void free_scenes(void)
{
    for (size_t k = 0; k < FUZZ_RUNS; k++)
        mpm_scene_free(scenes[k]);
}

const struct mpm_scene *fuzz_run_scene(size_t run)
{
    static const char *const paths[FUZZ_RUNS] = {"tests/fuzz/scenes/crack.yaml",
                                                 "tests/fuzz/scenes/disk.yaml",
                                                 "tests/fuzz/scenes/impact.yaml"};
    struct mpm_error error = {.status = MPM_OK};
    if (scenes[0] == NULL)
        (void)atexit(free_scenes);
    if (scenes[run] == NULL &&
        mpm_scene_read(paths[run], NULL, 0, &scenes[run], &error) != MPM_OK) {
        (void)fprintf(stderr, "fuzz: %s\n", error.message);
        exit(2);
    }
    return scenes[run];
}
