/* Blocks that tests of cracks have in common.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_CRACK_BLOCKS_H
#define TESTS_SUPPORT_CRACK_BLOCKS_H

/* A scene up to the block's velocity; wave speed 8.5; 32 by 24 cells. `motion` ends the body. */
#define BLOCK_OF_GROWTH(motion)                                                                    \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "thickness: 2\n"                                                                               \
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [36, 28]}\n"                                    \
    "time: {end: 100, courant: 0.3}\n"                                                             \
    "materials: [{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48}]\n"           \
    "bodies:\n"                                                                                    \
    "  - {name: block, material: stiff, region: {rectangle: {from: [2, 1.6], to: [34, "            \
    "20.8]}}" motion "}\n"

/* For J integrals: 32 by 41 cells, at rest. */
#define BLOCK_OF_J                                                                                 \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [36, 45]}\n"                                    \
    "time: {end: 1, courant: 0.3}\n"                                                               \
    "materials: [{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48}]\n"           \
    "bodies:\n"                                                                                    \
    "  - {name: block, material: stiff, region: {rectangle: {from: [2, 1.6], to: [34, 34.4]}}}\n"

#endif
