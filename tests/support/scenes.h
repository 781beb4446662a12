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

/* The largest difference of places, velocities and deformation gradients, particle by particle. */
double test_run_largest_difference(const struct test_run *one, const struct test_run *other);

/* A value of the history for a pair of bodies in contact, by its name. */
double test_run_contact_quantity(const struct test_run *run, const char *name);

struct mpm_ledger test_run_ledger(const struct test_run *run);
/* The J integral of that index, which must have a value. */
struct mpm_j_integral test_run_j_integral(const struct test_run *run, size_t index);

/* Position, velocity, deformation gradient, stress and temperature of two runs, and their ledgers:
 * byte by byte, so that not-a-numbers are told from one another as well. */
bool test_run_same_bits(const struct test_run *one, const struct test_run *other);

/* The scene after `steps` steps with 1, 2 and 3 threads: the test fails where bits differ.
 * `prepare`, if not NULL, is called before the first step. */
void test_same_bits_over_threads(const char *text, const char *const *settings, int steps,
                                 void (*prepare)(struct test_run *run));

/* The scenes of most tests of the step: bodies on cells that are not square. `time` and `material`
 * are flow mappings, `bodies` the rest of the scene from there on. */
#define TEST_BLOCK_SCENE(time, material, bodies)                                                   \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}\n"                                    \
    "time: " time "\n"                                                                             \
    "materials: [" material "]\n"                                                                  \
    "bodies:\n" bodies

/* Room for a body as large as three workers share, and that body, in a TEST_BLOCK_SCENE. */
#define TEST_BLOCK_FOR_THREADS                                                                     \
    "grid.cells=[70, 70]", "bodies.block.region.rectangle={from: [3, 3.2], to: [63, 51.2]}"

#endif
