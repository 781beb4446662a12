/* The scene of the tests of conduction: a block that may have a hot side, on cells that are not
 * square. Temperatures of order 1 in it, heat of order 30 (planar) and 200 (per radian).
 * Diffusivity 0.25; the first step is the waves'.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_HEAT_BLOCK_H
#define TESTS_SUPPORT_HEAT_BLOCK_H

#include "simulation/simulation.h"
#include "support/combinations.h"
#include "support/scenes.h"

extern const char HEAT_BLOCK[];

/* A setting: its lower side is held. */
extern const char HEAT_BLOCK_HOT_SIDE[];
/* A setting: its material has no stress. */
extern const char HEAT_BLOCK_AT_REST[];

/* Of about a hundred products and steps, over the numbers' own size. */
static const double HEAT_BLOCK_ROUND_OFF = 1e-13;

/* A setting: how temperatures follow the grid, each way once. */
enum { HEAT_BLOCK_TRANSFERS = 4 };
void heat_block_add_transfer(struct settings *settings, int transfer);

/* Temperatures and a source that vary within a cell. */
void heat_block_add_wild_heat(struct settings *settings, bool axisymmetric);

/* The block with the settings. */
struct test_run heat_block_open(const struct settings *settings, enum mpm_kernels kernels);

/* Reference kernels, then what the scene gets by itself. */
enum { HEAT_BLOCK_SETS = 2 };
enum mpm_kernels heat_block_kernels(int set);

struct mpm_nodal_scalar *heat_block_scalar(const struct test_run *run);
/* sum c m T */
double heat_block_heat(const struct test_run *run);

/* Families and geometries of scenes at rest, and settings with a fixed step, wild heat and the hot
 * side. */
enum { HEAT_BLOCK_REST = TEST_SHAPES * TEST_GEOMETRIES };
struct settings heat_block_rest_settings(int index);

#endif
