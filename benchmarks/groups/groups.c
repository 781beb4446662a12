/* The groups of mpm-bench: one line each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/bench.h"

#include <glib.h>

static const struct bench_group groups[] = {
    {"throughput", "Throughput", "particle-steps per second, memory and phases of every variant",
     bench_throughput},
    {"limit", "Against the machine's limit",
     "arithmetic and memory limit of one core, measured in the rounds of the target rows",
     bench_limit},
    {"accuracy", "Error against run time",
     "R1, a vibrating bar and manufactured motions on ladders of grids: error and processor time "
     "of every variant",
     bench_accuracy},
    {"scaling", "Scaling",
     "threads at three sizes, separate runs beside them, particles per cell, empty grid",
     bench_scaling},
    {"overhead", "Overhead of features", "each feature off and on: times and counted instructions",
     bench_overhead},
};

const struct bench_group *bench_groups(size_t *count)
{
    *count = G_N_ELEMENTS(groups);
    return groups;
}

const char *bench_tier_name(enum bench_tier tier)
{
    return tier == BENCH_QUICK ? "quick" : "standard";
}

char *bench_scene(const struct bench_context *context, const char *name)
{
    return g_build_filename(context->benchmarks, "scenes", name, NULL);
}

char *bench_case_scene(const struct bench_context *context, const char *folder)
{
    return g_build_filename(context->catalogue, folder, "scene.yaml", NULL);
}
