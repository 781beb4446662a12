/* Simulations from a scene's text and settings, for tests.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SCENES_H
#define TESTS_SUPPORT_SCENES_H

#include "mpm.h"

/* A scene and its simulation, freed together. */
struct test_run {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
};

/* The test fails, with the message, if the scene is refused. Settings end with NULL. */
struct test_run test_run_open(const char *text, const char *const *settings, int threads);
void test_run_close(struct test_run *run);

/* Advances by `steps` steps; the test fails if one does. */
void test_run_steps(struct test_run *run, int steps);

/* A field of all particles by id, malloc'ed; *count is the number of particles. */
double *test_run_field(const struct test_run *run, enum mpm_field field, size_t *count);

#endif
