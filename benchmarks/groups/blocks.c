/* The block that most points step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/blocks.h"

#include <string.h>

struct bench_block bench_block_plain(unsigned refine)
{
    return (struct bench_block){"plane_strain", "ugimp", "musl", refine};
}

struct bench_point *bench_block_add(const struct bench_context *context, GArray *points,
                                    const struct bench_block *block, const char *more)
{
    const bool twin = strcmp(block->geometry, "axisymmetric") == 0;
    char *scene = bench_scene(context, twin ? "block_axisymmetric.yaml" : "block.yaml");
    struct bench_point *point = bench_points_add(
        points, scene, &context->simulation, "%s %s %s%s%s", block->geometry, block->shape,
        block->stress_update, more == NULL ? "" : ", ", more == NULL ? "" : more);
    g_free(scene);
    bench_point_vary(point, "geometry", block->geometry);
    bench_point_vary(point, "method.shape", block->shape);
    bench_point_vary(point, "method.stress_update", block->stress_update);
    bench_point_set(point, "grid.refine=%u", block->refine);
    bench_point_text(point, "law", "neo_hookean");
    return point;
}

void bench_block_heat(struct bench_point *block)
{
    bench_point_set(block, "units={length: m, mass: kg, time: s, temperature: K}");
    bench_point_set(block, "materials.rubber.heat_capacity=1");
    bench_point_set(block, "materials.rubber.conductivity=0.001");
    bench_point_set(block, "transport={temperature: {start: 'x'}}");
}

struct bench_point *bench_heat_add(const struct bench_context *context, GArray *points,
                                   const struct bench_block *block, const char *more)
{
    char *scene = bench_scene(context, "heat.yaml");
    struct bench_point *point = bench_points_add(
        points, scene, &context->simulation, "heat alone, %s %s%s%s", block->geometry, block->shape,
        more == NULL ? "" : ", ", more == NULL ? "" : more);
    g_free(scene);
    bench_point_vary(point, "geometry", block->geometry);
    bench_point_vary(point, "method.shape", block->shape);
    bench_point_set(point, "grid.refine=%u", block->refine);
    bench_point_text(point, "law", "none");
    return point;
}
