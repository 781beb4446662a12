/* Throughput: particle-steps a second of every variant, of sizes, of plastic laws, and of small
 * scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/blocks.h"
#include "benchmarks/groups/variants.h"
#include "benchmarks/measuring/timing.h"

static const char *const geometries[] = {"plane_strain", "axisymmetric"};

/* Seconds for each list, in the standard tier. */
static const double VARIANTS = 60, SIZES = 50, HEAT = 20, PLASTIC = 15, OTHERS = 25;

static unsigned usual_size(const struct bench_context *context)
{
    return context->tier == BENCH_STANDARD ? BENCH_BLOCK_1E5 : BENCH_BLOCK_1E4;
}

static void add_variants(struct bench_context *context, GArray *points)
{
    for (size_t g = 0; g < G_N_ELEMENTS(geometries); g++)
        for (size_t v = 0; v < bench_variants_plain(); v++) {
            const struct bench_variant variant = bench_variant(v);
            const struct bench_block block = {geometries[g], variant.shape, variant.stress_update,
                                              usual_size(context)};
            bench_block_add(context, points, &block, NULL)->phases = true;
        }
}

static void add_sizes(struct bench_context *context, GArray *points)
{
    static const struct {
        unsigned refine;
        const char *name;
    } sizes[] = {{BENCH_BLOCK_1E4, "10^4"},
                 {BENCH_BLOCK_1E5, "10^5"},
                 {BENCH_BLOCK_1E6, "10^6"},
                 {BENCH_BLOCK_4E6, "4 10^6"}};
    for (size_t i = 0; i < (context->tier == BENCH_STANDARD ? G_N_ELEMENTS(sizes) : 2); i++) {
        const struct bench_block block = bench_block_plain(sizes[i].refine);
        struct bench_point *point = bench_block_add(context, points, &block, sizes[i].name);
        point->phases = true;
        if (i > 0)
            point->against = g_strdup_printf("plane_strain ugimp musl, %s", sizes[0].name);
    }
}

/* Heat alone by every family, and beside the plain block. */
static void add_heat(struct bench_context *context, GArray *points)
{
    static const char *const shapes[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3"};
    const struct bench_block plain = bench_block_plain(usual_size(context));
    for (size_t g = 0; g < G_N_ELEMENTS(geometries); g++)
        for (size_t k = 0; k < G_N_ELEMENTS(shapes); k++) {
            const struct bench_block block = {geometries[g], shapes[k], NULL, plain.refine};
            bench_heat_add(context, points, &block, NULL);
        }
    bench_block_add(context, points, &plain, "without heat");
    struct bench_point *both = bench_block_add(context, points, &plain, "with heat");
    bench_block_heat(both);
    both->against = g_strdup("plane_strain ugimp musl, without heat");
}

/* The axisymmetric block of metals that yield at a tenth of its stresses, beside that of rubber;
 * and the penetration of case P9, with APIC, artificial viscosity and contact, on cells of 0.5 mm.
 */
static void add_plastic(struct bench_context *context, GArray *points)
{
#define JOHNSON_COOK                                                                               \
    "yield_stress: 0.1, hardening_coefficient: 0.1, hardening_exponent: 0.3, rate_coefficient: "   \
    "0.02, reference_rate: 0.001, softening_exponent: 1, reference_temperature: 300, "             \
    "melting_temperature: 1700, start_temperature: 300, specific_heat: 1, taylor_quinney: 0.9"
    static const struct {
        const char *name, *law, *parameters;
    } laws[] = {
        {"von Mises", "von_mises", "bulk: 60, shear: 30, yield_stress: 0.1, hardening_modulus: 1"},
        {"Johnson-Cook", "johnson_cook", "bulk: 60, shear: 30, " JOHNSON_COOK},
        {"Johnson-Cook and Mie-Gruneisen", "johnson_cook_gruneisen",
         "shear: 30, sound_speed: 7.746, hugoniot_slope: 1.5, gruneisen: 2, " JOHNSON_COOK},
    };
#undef JOHNSON_COOK
    struct bench_block block = bench_block_plain(usual_size(context));
    block.geometry = "axisymmetric";
    bench_block_add(context, points, &block, "rubber");
    for (size_t k = 0; k < G_N_ELEMENTS(laws); k++) {
        struct bench_point *point = bench_block_add(context, points, &block, laws[k].name);
        bench_point_set(point, "units={length: m, mass: kg, time: s, temperature: K}");
        bench_point_set(point, "materials.rubber={name: rubber, density: 1, law: %s, %s}",
                        laws[k].law, laws[k].parameters);
        bench_point_text(point, "law", laws[k].law);
        point->phases = true;
        point->against = g_strdup("axisymmetric ugimp musl, rubber");
    }
    char *scene = bench_case_scene(context, "P/P9");
    struct bench_point *rod =
        bench_points_add(points, scene, &context->simulation, "P9: axisymmetric ugimp musl, apic");
    bench_point_set(rod, "grid.refine=2");
    rod->phases = true;
    g_free(scene);
}

/* What the tables of variants and sizes leave out, each beside the plain block. */
static void add_others(struct bench_context *context, GArray *points)
{
    static const char plain_name[] = "plane_strain ugimp musl, plain";
    const struct bench_block plain = bench_block_plain(usual_size(context));
    struct bench_block stressed = plain;
    stressed.geometry = "plane_stress";
    bench_block_add(context, points, &plain, "plain");
    bench_block_add(context, points, &stressed, NULL)->against = g_strdup(plain_name);

    struct bench_point *elastic = bench_block_add(context, points, &plain, "linear elastic");
    bench_point_set(elastic, "materials.rubber.law=linear_elastic");
    bench_point_text(elastic, "law", "linear_elastic");
    elastic->against = g_strdup(plain_name);

    struct bench_point *baseline =
        bench_block_add(context, points, &plain, "baseline instructions");
    baseline->simulation.simd = MPM_SIMD_BASELINE;
    baseline->against = g_strdup(plain_name);

    struct bench_point *reference = bench_block_add(context, points, &plain, "reference kernels");
    reference->simulation.kernels = MPM_KERNELS_REFERENCE;
    reference->against = g_strdup(plain_name);
    if (context->simulation.kernels == MPM_KERNELS_REFERENCE)
        g_array_set_size(points, points->len - 2); /* neither kernels nor instructions to compare */

    char *scene = bench_case_scene(context, "R/R1");
    struct bench_point *small =
        bench_points_add(points, scene, &context->simulation, "R1: axisymmetric ugimp musl, rigid");
    small->phases = true;
    g_free(scene);
}

enum mpm_status bench_throughput(struct bench_context *context, struct mpm_error *error)
{
    const struct bench_list lists[] = {{add_variants, VARIANTS},
                                       {add_sizes, SIZES},
                                       {add_heat, HEAT},
                                       {add_plastic, PLASTIC},
                                       {add_others, OTHERS}};
    return bench_measure_lists(context, "throughput", lists, G_N_ELEMENTS(lists), error);
}
