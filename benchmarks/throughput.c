/* Throughput: particle-steps a second of every variant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/timing.h"

enum mpm_status bench_throughput(struct bench_context *context, struct mpm_error *error)
{
    GArray *points = bench_points_new();
    char *scene = bench_scene(context, "block.yaml");
    struct bench_point *point =
        bench_points_add(points, scene, &context->simulation, "ugimp musl planar, 10^4");
    bench_point_vary(point, "method.shape", "ugimp");
    bench_point_vary(point, "method.stress_update", "musl");
    bench_point_set(point, "grid.refine=10");
    point->phases = true;
    const enum mpm_status status = bench_measure(context, "throughput", points, 2, NULL, error);
    g_free(scene);
    g_array_unref(points);
    return status;
}
