/* Scaling: threads and runs side by side, particles per cell, empty grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/blocks.h"
#include "benchmarks/measuring/timing.h"

/* Seconds for each list, in the standard tier. */
static const double THREADS = 30, CELLS = 10, GRID = 10;

static bool is_quick(const struct bench_context *context)
{
    return context->tier == BENCH_QUICK;
}

/* 1, 2, 4, ... and all processors; 0 after the last one. */
static unsigned next_threads(unsigned threads, unsigned processors)
{
    if (threads >= processors)
        return 0;
    return 2 * threads < processors ? 2 * threads : processors;
}

/* What the machine gives to two runs of one thread each, to hold two threads against. */
static void add_pair(struct bench_context *context, GArray *points, const struct bench_block *block,
                     const char *size, const char *one)
{
    char *more = g_strdup_printf("%s, 2 runs of 1 thread", size);
    struct bench_point *point = bench_block_add(context, points, block, more);
    point->simulation.threads = 1;
    point->clock = BENCH_CLOCK_WALL;
    point->runs = 2;
    bench_point_number(point, "runs", point->runs);
    point->against = g_strdup(one);
    g_free(more);
}

/* By the wall clock, one thread as well: that is what the others are compared with. */
static void add_threads(struct bench_context *context, GArray *points)
{
    static const struct {
        unsigned refine;
        const char *name;
    } sizes[] = {{BENCH_BLOCK_1E4, "10^4"}, {BENCH_BLOCK_1E5, "10^5"}, {BENCH_BLOCK_1E6, "10^6"}};
    for (size_t i = 0; i < (is_quick(context) ? 2 : G_N_ELEMENTS(sizes)); i++) {
        const struct bench_block block = bench_block_plain(sizes[i].refine);
        char *one = NULL;
        for (unsigned n = 1; n != 0; n = next_threads(n, context->processors)) {
            char *more = g_strdup_printf("%s, %u thread%s", sizes[i].name, n, n == 1 ? "" : "s");
            struct bench_point *point = bench_block_add(context, points, &block, more);
            point->simulation.threads = (int)n;
            point->clock = BENCH_CLOCK_WALL;
            point->against = g_strdup(one);
            if (one == NULL)
                one = g_strdup(point->name);
            g_free(more);
        }
        if (context->processors > 1)
            add_pair(context, points, &block, sizes[i].name, one);
        g_free(one);
    }
}

/* The same number of particles, to a percent or three, in fewer cells. */
static void add_cells(struct bench_context *context, GArray *points)
{
    static const struct {
        unsigned along, refine, refine_quick;
    } fillings[] = {{2, 32, 10}, {1, 63, 20}, {3, 21, 7}, {4, 16, 5}};
    char *usual = NULL;
    for (size_t i = 0; i < G_N_ELEMENTS(fillings); i++) {
        const unsigned along = fillings[i].along;
        const struct bench_block block =
            bench_block_plain(is_quick(context) ? fillings[i].refine_quick : fillings[i].refine);
        char *more = g_strdup_printf("%u per cell", along * along);
        struct bench_point *point = bench_block_add(context, points, &block, more);
        bench_point_set(point, "bodies.block.particles_per_cell=[%u,%u]", along, along);
        bench_point_number(point, "particles_per_cell", along * along);
        point->against = g_strdup(usual);
        if (usual == NULL)
            usual = g_strdup(point->name);
        g_free(more);
    }
    g_free(usual);
}

/* The block in a corner of a grid of so many times its cells. */
static void add_grids(struct bench_context *context, GArray *points)
{
    static const unsigned sides[] = {5, 16, 50}; /* of the block: 5 */
    const struct bench_block block =
        bench_block_plain(is_quick(context) ? BENCH_BLOCK_1E4 : BENCH_BLOCK_1E5);
    char *full = NULL;
    for (size_t i = 0; i < G_N_ELEMENTS(sides); i++) {
        const unsigned side = sides[i];
        const double times = side * side / 25.0;
        char *more = g_strdup_printf("grid %.0f x body", times);
        struct bench_point *point = bench_block_add(context, points, &block, more);
        bench_point_set(point, "grid.cells=[%u,%u]", side, side);
        bench_point_number(point, "grid_over_body", times);
        point->phases = true;
        point->against = g_strdup(full);
        if (full == NULL)
            full = g_strdup(point->name);
        g_free(more);
    }
    g_free(full);
}

enum mpm_status bench_scaling(struct bench_context *context, struct mpm_error *error)
{
    const struct bench_list lists[] = {
        {add_threads, THREADS}, {add_cells, CELLS}, {add_grids, GRID}};
    return bench_measure_lists(context, "scaling", lists, G_N_ELEMENTS(lists), error);
}
