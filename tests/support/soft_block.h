/* The scene of the tests of loads, damping and starts: a soft block. Wave speed 1.5; of
 * TEST_SOFT_BLOCK, masses of order 20 and 80 particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SOFT_BLOCK_H
#define TESTS_SUPPORT_SOFT_BLOCK_H

#include "support/kernel_pair.h"
#include "support/scenes.h"

#define TEST_SOFT_SCENE(time, bodies)                                                              \
    TEST_BLOCK_SCENE(time, "{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}",  \
                     bodies)

/* `wall` is TEST_WALL or empty. */
#define TEST_SOFT_BLOCK(wall)                                                                      \
    TEST_SOFT_SCENE("{end: 1000, courant: 0.3}", wall                                              \
                    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2],\n"     \
                    "     to: [8, 7.2]}}, particles_per_cell: [2, 2]}\n")

/* A rigid body beside it: it has particles too, and none of them are the block's. */
#define TEST_WALL                                                                                  \
    "  - {name: wall, rigid: {velocity: [0, 0]}, region: {rectangle: {from: [11, 0],\n"            \
    "     to: [12, 0.8]}}}\n"

/* The boundary moves, so that a force has a part in the reaction there. */
#define TEST_SWINGING_FLOOR                                                                        \
    "boundary:\n"                                                                                  \
    "  - {region: {line: {from: [0, 3.2], to: [14, 3.2]}}, velocity: [free, '0.02*sin(2*t)']}\n"

/* Sums of 80 particles' products, each rounded a few times: 1e3 eps/2 of the largest. */
static const double TEST_SOFT_ROUND_OFF = 1e-13;

/* Takes `steps` steps of a pair of TEST_SOFT_BLOCK on the TEST_SWINGING_FLOOR, under a body force
 * of up to 0.085, and closes it; the test fails where motions or works are not alike. */
void test_soft_block_assert_alike(struct kernel_pair *pair, int steps);

#endif
