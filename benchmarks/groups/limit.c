/* The target rows against what one core can do at most, measured in the same rounds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/findings.h"
#include "benchmarks/groups/blocks.h"
#include "benchmarks/measuring/probes.h"
#include "benchmarks/measuring/timing.h"

#include <string.h>

/* Seconds in the standard tier. */
static const double SHARE = 65;

enum heat { NO_HEAT, WITH_HEAT, HEAT_ALONE };
static const char *const heat_words[] = {NULL, "with heat", "heat alone"};

/* geometry, shape, order, size as in the project's targets. */
static const struct row {
    struct bench_block block;
    enum heat heat;
} rows[] = {
    {{"plane_strain", "ugimp", "musl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "ugimp", "usavg", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "ugimp", "usl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "ugimp", "usf", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"axisymmetric", "ugimp", "musl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "classic", "musl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "cpdi", "musl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"axisymmetric", "cpdi", "musl", BENCH_BLOCK_1E6}, NO_HEAT},
    {{"plane_strain", "ugimp", "musl", BENCH_BLOCK_1E6}, WITH_HEAT},
    {{"plane_strain", "ugimp", NULL, BENCH_BLOCK_1E6}, HEAT_ALONE},
    {{"axisymmetric", "ugimp", NULL, BENCH_BLOCK_1E6}, HEAT_ALONE},
};

enum { ROWS = sizeof rows / sizeof rows[0], ARITHMETIC = ROWS, BANDWIDTH };

/* Bytes that any order of computation must move for a particle and a step when particles do
 * not fit into the cache, and the grid does: its state read once and written once. Position
 * 2, velocity 2, and of F and stress what is not constant (planar 4 and 3, axisymmetric 5
 * and 4); temperature 1; mass is read only. Of heat alone position is read only too. */
static double least_bytes(const struct row *row)
{
    const bool hoop = strcmp(row->block.geometry, "axisymmetric") == 0;
    const int motion = 2 + 2 + (hoop ? 5 + 4 : 4 + 3), mass = 1, temperature = 1, place = 2;
    const int numbers = row->heat == HEAT_ALONE
                            ? 2 * temperature + place + mass
                            : 2 * motion + mass + (row->heat == WITH_HEAT ? 2 * temperature : 0);
    return (double)(numbers * (int)sizeof(double));
}

static struct bench_point *add_row(const struct bench_context *context, GArray *points,
                                   const struct row *row)
{
    struct bench_block block = row->block;
    if (context->tier == BENCH_QUICK)
        block.refine = BENCH_BLOCK_1E5;
    const char *const size = context->tier == BENCH_QUICK ? "10^5" : "10^6";
    if (row->heat == HEAT_ALONE)
        return bench_heat_add(context, points, &block, size);
    char *const more =
        row->heat == WITH_HEAT ? g_strconcat("with heat, ", size, NULL) : g_strdup(size);
    struct bench_point *const point = bench_block_add(context, points, &block, more);
    g_free(more);
    if (row->heat == WITH_HEAT)
        bench_block_heat(point);
    return point;
}

static GArray *make_points(struct bench_context *context)
{
    GArray *points = bench_points_new();
    for (size_t i = 0; i < ROWS; i++) {
        struct bench_point *const point = add_row(context, points, &rows[i]);
        if (heat_words[rows[i].heat] != NULL)
            bench_point_text(point, "heat", heat_words[rows[i].heat]);
        point->phases = true;
    }
    struct bench_point *arithmetic = bench_points_add_probe(
        points, bench_probe_arithmetic, NULL, "arithmetic", "GFLOP/s", "multiply-add, one core");
    bench_point_text(arithmetic, "instructions", bench_probe_instructions());
    (void)bench_points_add_probe(points, bench_probe_bandwidth, NULL, "bandwidth", "GB/s",
                                 "memory triad, one core");
    return points;
}

/* Each row over both limits, by round. */
static void write_fractions(struct bench_context *context, const GArray *points,
                            const struct bench_rates *rates)
{
    const double *flops = bench_rates_of(rates, ARITHMETIC);
    const double *bandwidth = bench_rates_of(rates, BANDWIDTH);
    double *of_flops = g_new(double, rates->rounds), *of_bandwidth = g_new(double, rates->rounds);
    for (size_t i = 0; i < ROWS; i++) {
        const struct bench_point *point = &g_array_index(points, struct bench_point, i);
        const struct bench_subject subject = {"limit", point->name, point->settings};
        const double *row = bench_rates_of(rates, i), bytes = least_bytes(&rows[i]);
        for (size_t r = 0; r < rates->rounds; r++) {
            of_flops[r] = row[r] / flops[r];
            of_bandwidth[r] = 1e-9 * bytes * row[r] / bandwidth[r];
        }
        bench_value(context, &subject, "least_bytes_per_particle_step", "B", bytes);
        bench_result(context, &subject, "particle_steps_per_gflop", "1/GFLOP", of_flops,
                     rates->rounds);
        bench_result(context, &subject, "fraction_of_bandwidth", "1", of_bandwidth, rates->rounds);
    }
    g_free(of_flops);
    g_free(of_bandwidth);
}

enum mpm_status bench_limit(struct bench_context *context, struct mpm_error *error)
{
    struct bench_rates rates;
    GArray *points = make_points(context);
    const double seconds = context->tier == BENCH_STANDARD ? SHARE : SHARE / 10;
    const enum mpm_status status = bench_measure(context, "limit", points, seconds, &rates, error);
    if (status == MPM_OK) {
        write_fractions(context, points, &rates);
        bench_rates_clear(&rates);
    }
    g_array_unref(points);
    return status;
}
