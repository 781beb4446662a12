/* The scene of the tests of properties, transfers and forms: one block with settings, and what
 * runs of it have in common or not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_TRANSFER_BLOCK_H
#define TESTS_SUPPORT_TRANSFER_BLOCK_H

#include "support/combinations.h"
#include "support/scenes.h"

/* A block from (3, 3.2) to the corner `to`, at a distance from the axis in axisymmetry. Wave speed
 * 12, so that a step is near 0.02. */
#define TEST_RUBBER_BLOCK(to)                                                                      \
    TEST_BLOCK_SCENE("{end: 1000, courant: 0.3}",                                                  \
                     "{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}",          \
                     "  - {name: block, material: rubber, region: {rectangle: {from: [3, 3.2],\n"  \
                     "     to: " to "}}, particles_per_cell: [2, 2]}\n")

/* Every order of the stress update, and USAVG without re-extrapolation, as keys of the method. */
enum { BLOCK_ORDERS = 5 };
extern const char *const block_orders[BLOCK_ORDERS];

/* `order`: one of these, with more keys of the method or without */
void block_add_method(struct settings *settings, const char *shape, const char *order,
                      const char *transfer);

/* The block with the settings, which are cleared. */
struct test_run block_open(struct settings *settings, int threads);

/* The largest difference of a field of two runs. */
double test_run_difference(const struct test_run *one, const struct test_run *other,
                           enum mpm_field field);

#endif
