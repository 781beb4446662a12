/* The block that most points step: benchmarks/scenes/block.yaml and its axisymmetric twin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_GROUPS_BLOCKS_H
#define BENCHMARKS_GROUPS_BLOCKS_H

#include "benchmarks/common/bench.h"
#include "benchmarks/measuring/points.h"

struct bench_block {
    const char *geometry, *shape, *stress_update; /* as scenes name them */
    unsigned refine;                              /* 100 refine^2 particles */
};

/* Refinements of 10^4, 10^5 (102400), 10^6 and 4 10^6 particles. */
enum { BENCH_BLOCK_1E4 = 10, BENCH_BLOCK_1E5 = 32, BENCH_BLOCK_1E6 = 100, BENCH_BLOCK_4E6 = 200 };

/* uGIMP, MUSL, plane strain. */
struct bench_block bench_block_plain(unsigned refine);

/* Adds a point "GEOMETRY SHAPE ORDER[, MORE]" with their settings; valid until the next is
 * added. */
struct bench_point *bench_block_add(const struct bench_context *context, GArray *points,
                                    const struct bench_block *block, const char *more);

/* The block with heat that is conducted beside its mechanics. */
void bench_block_heat(struct bench_point *block);

/* Adds a point "heat alone, GEOMETRY SHAPE[, MORE]", of scenes/heat.yaml: the block without
 * mechanics. */
struct bench_point *bench_heat_add(const struct bench_context *context, GArray *points,
                                   const struct bench_block *block, const char *more);

#endif
