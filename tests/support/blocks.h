/* The scene of the tests of results and commands: two elastic blocks that deform, some
 * 50 steps until t = 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_BLOCKS_H
#define TESTS_SUPPORT_BLOCKS_H

/* `time` and `output` are the flow mappings of these two sections. */
#define TEST_BLOCKS_WITH(time, output)                                                             \
    "format: 1\n"                                                                                  \
    "title: Two blocks\n"                                                                          \
    "geometry: plane_strain\n"                                                                     \
    "units: {length: mm, mass: g, time: ms, temperature: K}\n"                                     \
    "grid: {origin: [0, 0], cell: [1, 1], cells: [12, 8]}\n"                                       \
    "time: " time "\n"                                                                             \
    "materials:\n"                                                                                 \
    "  - {name: rubber, law: neo_hookean, density: 1, bulk: 200, shear: 100}\n"                    \
    "bodies:\n"                                                                                    \
    "  - name: left\n"                                                                             \
    "    material: rubber\n"                                                                       \
    "    region: {rectangle: {from: [2, 2], to: [5, 5]}}\n"                                        \
    "    particles_per_cell: [2, 2]\n"                                                             \
    "    velocity: [\"0.5*(x-3)\", 0]\n"                                                           \
    "  - name: right\n"                                                                            \
    "    material: rubber\n"                                                                       \
    "    region: {rectangle: {from: [7, 2], to: [9, 5]}}\n"                                        \
    "    particles_per_cell: [2, 2]\n"                                                             \
    "    velocity: [0, \"0.2*(x-8)\"]\n"                                                           \
    "output: " output "\n"

#define TEST_BLOCKS TEST_BLOCKS_WITH("{end: 1, courant: 0.4}", "{history: 0.1, snapshots: 0.3}")

/* A step five times the stability limit: ends with MPM_RUN_FAILED. */
#define TEST_BLOCKS_UNSTABLE                                                                       \
    TEST_BLOCKS_WITH("{end: 1000, courant: 5, allow_unstable: true}",                              \
                     "{history: 0.1, snapshots: 50}")

/* Settings with which they conduct heat. */
#define TEST_BLOCKS_CONDUCTING                                                                     \
    "materials.rubber.heat_capacity=1", "materials.rubber.conductivity=1",                         \
        "materials.rubber.saturation=1", "materials.rubber.diffusivity=1",                         \
        "transport={temperature: {}, concentration: {}}"

enum { TEST_BLOCKS_PARTICLES = (3 * 3 + 2 * 3) * 4 };

#endif
