/* Conduction of heat between bodies in contact and across cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/heat_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { STEPS = 30, REST = HEAT_BLOCK_REST };

/* Two halves of a block, of two materials; they meet within a cell at x = 6.3. */
#define TWO_BLOCKS                                                                                 \
    TEST_BLOCK_SCENE(                                                                              \
        "{end: 1000, step: 0.05}",                                                                 \
        "{name: one, law: none, density: 2, heat_capacity: 0.5, conductivity: 0.25}, "             \
        "{name: two, law: none, density: 1, heat_capacity: 2, conductivity: 0.4}",                 \
        "  - {name: left, material: one, temperature: 1, region: {rectangle: {from: [3, 3.2],\n"   \
        "     to: [6.3, 8]}}, particles_per_cell: [3, 1]}\n"                                       \
        "  - {name: right, material: two, region: {rectangle: {from: [6.3, 3.2],\n"                \
        "     to: [9, 8]}}, particles_per_cell: [3, 1]}\n"                                         \
        "transport: {temperature: {}}\n")

static const char ELASTIC[] =
    "materials=[{name: one, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, heat_capacity: "
    "0.5, conductivity: 0.25}, {name: two, law: neo_hookean, density: 1, bulk: 1, shear: 0.75, "
    "heat_capacity: 2, conductivity: 0.4}]";
static const char MATERIAL_ONE[] = "bodies.right.material=one";
static const char WHOLE[] =
    "bodies=[{name: left, material: one, region: {rectangle: {from: [3, 3.2], to: [9, 8]}}, "
    "particles_per_cell: [3, 1]}]";
/* Along the joint, from outside of the body to outside. */
#define CRACK(heat) "cracks=[{points: [[6.3, 0.4], [6.3, 11.6]]" heat "}]"
/* The direction makes corners of the bodies have their part of the area. */
#define PAIR(of, heat)                                                                             \
    "contact={fields: bodies, pairs: [{of: [left, right], law: " of                                \
    ", normal: given, direction: [1, 0]" heat "}]}"

/* Temperatures by particle, g_free. */
static double *run_scene(const struct settings *settings, int steps, double *passed)
{
    struct test_run run = test_run_open(TWO_BLOCKS, settings->texts, 1);
    size_t count;
    test_run_steps(&run, steps);
    if (passed != NULL)
        *passed = test_run_contact_quantity(&run, "contact_0_1_heat");
    double *const values = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
    test_run_close(&run);
    return values;
}

/* Of the same particles: bodies side by side fill the whole in another order. */
static double mean_square(const double *values, size_t count, double power)
{
    double sum = 0.0;
    for (size_t k = 0; k < count; k++)
        sum += pow(fabs(values[k]), power);
    return sum;
}

enum { PARTICLES = 6 * 3 * 6 };

static void compare_scenes(const struct settings *one, const struct settings *other, bool ordered,
                           double bound)
{
    double *const a = run_scene(one, STEPS, NULL), *const b = run_scene(other, STEPS, NULL);
    for (size_t k = 0; k < PARTICLES && ordered; k++)
        ck_assert_near(a[k], b[k], bound);
    for (int power = 1; power < 4; power++)
        ck_assert_near(mean_square(a, PARTICLES, power), mean_square(b, PARTICLES, power),
                       PARTICLES * bound);
    g_free(a);
    g_free(b);
}

/* ----------------------------------------------------------------------- identity */

/* In all families, geometries and orders, bodies that move or do not. */
START_TEST(bonded_bodies_in_perfect_contact_are_one_body)
{
    const int kind = _i % 2, transfer = _i / 2 % HEAT_BLOCK_TRANSFERS;
    const int index = _i / 2 / HEAT_BLOCK_TRANSFERS;
    struct settings one = heat_block_rest_settings(index);
    struct settings other = heat_block_rest_settings(index);
    for (int k = 0; k < 2; k++) {
        struct settings *const settings = k == 0 ? &one : &other;
        if (kind == 1)
            settings_add(settings, ELASTIC);
        heat_block_add_transfer(settings, transfer);
        if (k == 0)
            settings_add(settings, PAIR("bonded", ", heat: perfect"));
    }
    compare_scenes(&one, &other, true, HEAT_BLOCK_ROUND_OFF);
    settings_clear(&one);
    settings_clear(&other);
}
END_TEST

START_TEST(a_crack_that_conducts_is_none)
{
    struct settings one = heat_block_rest_settings(_i), other = heat_block_rest_settings(_i);
    settings_add(&one, WHOLE);
    settings_add(&other, WHOLE);
    settings_add(&one, CRACK(", heat: perfect"));
    compare_scenes(&one, &other, true, HEAT_BLOCK_ROUND_OFF);
    settings_clear(&one);
    settings_clear(&other);
}
END_TEST

/* Areas at nodes are those of the side beyond the crack, between bodies the smaller of both: cubic
 * splines, whose sums over particles are no exact integrals, give two. Temperatures of order 1. */
static const double TWO_AREAS = 2e-4;

/* Insulated, and with a conductance. */
START_TEST(a_body_with_a_crack_is_two_bodies)
{
    for (int kind = 0; kind < 2; kind++) {
        struct settings one = heat_block_rest_settings(_i), other = heat_block_rest_settings(_i);
        settings_add(&one, WHOLE);
        settings_add(&other, MATERIAL_ONE);
        settings_add(&one, kind == 0 ? CRACK("") : CRACK(", heat: conductance, conductance: 0.7"));
        settings_add(&other, kind == 0 ? PAIR("bonded", "")
                                       : PAIR("bonded", ", heat: conductance, conductance: 0.7"));
        settings_add(&one, "bodies.left.temperature=1");
        settings_add(&other, "bodies.right.temperature=1");
        const bool exact = kind == 0 || _i % TEST_SHAPES != MPM_BSPLINE3;
        compare_scenes(&one, &other, false, exact ? HEAT_BLOCK_ROUND_OFF : TWO_AREAS);
        settings_clear(&one);
        settings_clear(&other);
    }
}
END_TEST

/* The other way round: fields and pairs change places. */
START_TEST(the_order_of_bodies_does_not_matter)
{
    static const char *const bodies[] = {
        "{name: left, material: one, temperature: 1, region: {rectangle: {from: [3, 3.2], to: "
        "[6.3, 5.5]}}, particles_per_cell: [3, 1]}",
        "{name: right, material: two, region: {rectangle: {from: [6.3, 3.2], to: [9, 8]}}, "
        "particles_per_cell: [3, 1]}",
        "{name: top, material: one, temperature: 3, region: {rectangle: {from: [3, 5.5], to: [6.3, "
        "8]}}, particles_per_cell: [3, 1]}",
    };
    static const char *const pairs[] = {"{of: [left, right], law: stick, heat: perfect}",
                                        "{of: [top, left], law: stick, heat: conductance, "
                                        "conductance: 2}",
                                        "{of: [right, top], law: stick, heat: conductance, "
                                        "conductance: 40}"};
    static const int orders[2][3] = {{0, 1, 2}, {2, 1, 0}};
    double heat[2], square[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = heat_block_rest_settings(_i);
        const int *const o = orders[k];
        settings_add_formatted(&settings, "bodies=[%s, %s, %s]", bodies[o[0]], bodies[o[1]],
                               bodies[o[2]]);
        settings_add_formatted(&settings, "contact={fields: bodies, pairs: [%s, %s, %s]}",
                               pairs[o[0]], pairs[o[1]], pairs[o[2]]);
        struct test_run run = test_run_open(TWO_BLOCKS, settings.texts, 1);
        test_run_steps(&run, STEPS);
        size_t count;
        double *const values = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        heat[k] = heat_block_heat(&run);
        square[k] = mean_square(values, count, 2.0);
        g_free(values);
        test_run_close(&run);
        settings_clear(&settings);
    }
    ck_assert_near(heat[1], heat[0], 100.0 * HEAT_BLOCK_ROUND_OFF);
    ck_assert_near(square[1], square[0], 300.0 * HEAT_BLOCK_ROUND_OFF);
}
END_TEST

/* Hot left, cold right, as in a mirror at x = 7. */
START_TEST(a_mirrored_scene_has_mirrored_temperatures)
{
    static const char *const bodies[] = {
        "bodies=[{name: left, material: one, temperature: 1, region: {rectangle: {from: [3, 3.2], "
        "to: [6.3, 8]}}, particles_per_cell: [3, 1]}, {name: right, material: two, region: "
        "{rectangle: {from: [6.3, 3.2], to: [9, 8]}}, particles_per_cell: [3, 1]}]",
        "bodies=[{name: left, material: one, temperature: 1, region: {rectangle: {from: [7.7, "
        "3.2], to: [11, 8]}}, particles_per_cell: [3, 1]}, {name: right, material: two, region: "
        "{rectangle: {from: [5, 3.2], to: [7.7, 8]}}, particles_per_cell: [3, 1]}]"};
    double square[2], passed[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "method.shape=%s", test_shapes[_i]);
        settings_add(&settings, bodies[k]);
        settings_add(&settings, "contact={law: stick, heat: perfect, normal: average}");
        double *const values = run_scene(&settings, STEPS, &passed[k]);
        square[k] = mean_square(values, PARTICLES, 2.0);
        g_free(values);
        settings_clear(&settings);
    }
    ck_assert_near(square[1], square[0], 100.0 * HEAT_BLOCK_ROUND_OFF);
    ck_assert_near(passed[1], passed[0], HEAT_BLOCK_ROUND_OFF * 10.0);
}
END_TEST

/* ------------------------------------------------------------------------ balance */

/* Without anything else the first body loses what has passed. */
START_TEST(the_history_has_the_heat_that_has_passed)
{
    static const char *const laws[] = {"perfect", "conductance, conductance: 3"};
    for (size_t law = 0; law < G_N_ELEMENTS(laws); law++)
        for (int transfer = 0; transfer < HEAT_BLOCK_TRANSFERS; transfer++) {
            struct settings settings = {.count = 0};
            double passed;
            settings_add_formatted(&settings, "method.shape=%s", test_shapes[_i]);
            settings_add_formatted(&settings, "contact={law: stick, heat: %s}", laws[law]);
            heat_block_add_transfer(&settings, transfer);
            struct test_run run = test_run_open(TWO_BLOCKS, settings.texts, 1);
            const struct mpm_state *const state = &run.simulation->state;
            double content[2] = {0.0, 0.0};
            const double start = heat_block_heat(&run);
            for (int when = 0; when < 2; when++) {
                const double *const value =
                    mpm_particle_array(&state->particles, MPM_PARTICLE_TEMPERATURE, 0);
                for (size_t p = 0; p < state->particles.count; p++)
                    if (state->particles.body[p] == 0)
                        content[when] += 0.5 * state->particles.mass[p] * value[p];
                if (when == 0)
                    test_run_steps(&run, STEPS);
            }
            passed = test_run_contact_quantity(&run, "contact_0_1_heat");
            ck_assert_double_gt(passed, 0.1);
            ck_assert_near(content[0] - content[1], passed, 100.0 * HEAT_BLOCK_ROUND_OFF);
            ck_assert_near(heat_block_heat(&run), start, 100.0 * HEAT_BLOCK_ROUND_OFF);
            test_run_close(&run);
            settings_clear(&settings);
        }
}
END_TEST

/* -------------------------------------------------------------------- where it flows */

/* Sites of particles are as wide: the left block ends at 6 1/3. */
static const double third = 1.0 / 3.0;

/* The right block is moved by that much, along x. */
static double passed_at(double gap, const char *contact)
{
    struct settings settings = {.count = 0};
    double passed;
    settings_add_formatted(&settings,
                           "bodies.right.region.rectangle={from: [%g, 3.2], to: [%g, 8]}",
                           6.0 + third + gap - 1e-6, 9.0 + gap);
    settings_add(&settings, contact);
    g_free(run_scene(&settings, STEPS, &passed));
    settings_clear(&settings);
    return passed;
}

START_TEST(heat_flows_where_bodies_touch_alone)
{
    static const char extent[] = PAIR("stick", ", heat: perfect");
    static const char within[] = PAIR("stick", ", heat: perfect, heat_gap: 0.35");
    static const char shared[] = PAIR("stick", ", heat: perfect, detection: shared");
    ck_assert_double_gt(passed_at(0.0, extent), 0.5);
    ck_assert_double_eq(passed_at(third, extent), 0.0);
    ck_assert_double_gt(passed_at(third, within), 0.5);
    ck_assert_double_eq(passed_at(2.0 * third, within), 0.0);
    ck_assert_double_gt(passed_at(third, shared), 0.5);
    ck_assert_double_eq(passed_at(3.0, shared), 0.0);
}
END_TEST

/* A block that flies at 0.5 meets the other one 0.9 away after 1.8, 36 steps. */
START_TEST(heat_flows_from_when_bodies_meet)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, ELASTIC);
    settings_add(&settings, "bodies.right.region.rectangle={from: [7.2, 3.2], to: [9.9, 8]}");
    settings_add(&settings, "bodies.left.velocity=[0.5, 0]");
    settings_add(&settings, PAIR("stick", ", heat: conductance, conductance: 2"));
    struct test_run run = test_run_open(TWO_BLOCKS, settings.texts, 1);
    test_run_steps(&run, 34);
    ck_assert_double_eq(test_run_contact_quantity(&run, "contact_0_1_heat"), 0.0);
    test_run_steps(&run, 10);
    ck_assert_double_gt(test_run_contact_quantity(&run, "contact_0_1_heat"), 0.01);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Over the whole section, the heat of the exchange of two slabs of one temperature each: the sum of
 * the areas at nodes is that of the crack, a circle's per radian in axisymmetry. */
START_TEST(areas_of_a_crack_add_up_to_its_own)
{
    const struct test_combination c = test_combination(_i);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", c.shape);
    settings_add_formatted(&settings, "geometry=%s", c.geometry);
    settings_add(&settings, WHOLE);
    settings_add(&settings, CRACK(", heat: conductance, conductance: 1"));
    struct test_run run = test_run_open(TWO_BLOCKS, settings.texts, 1);
    test_run_steps(&run, 1);
    const struct mpm_nodal_scalar *const scalar = heat_block_scalar(&run);
    double sum = 0.0;
    for (size_t k = 0; k < scalar->passage_count; k++)
        sum += scalar->passages[k].conductance;
    const double joint = 19.0 / 3.0; /* where the sites of particles on both sides meet */
    ck_assert_near(sum, 4.8 * (c.axisymmetric ? joint : 1.0), 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ------------------------------------------------------------------------- kernels */

START_TEST(fast_kernels_exchange_as_reference_kernels_do)
{
    static const char *const laws[] = {PAIR("stick", ", heat: perfect"),
                                       PAIR("stick", ", heat: conductance, conductance: 3"),
                                       CRACK(", heat: conductance, conductance: 3")};
    for (size_t law = 0; law < G_N_ELEMENTS(laws); law++) {
        struct settings settings = heat_block_rest_settings(_i);
        settings_add(&settings, laws[law]);
        const struct kernel_side sides[] = {
            {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
            {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
        };
        struct kernel_pair pair = kernel_pair_open_text(TWO_BLOCKS, sides);
        for (int step = 0; step < STEPS; step++)
            ck_assert(kernel_pair_step(&pair));
        ck_assert_double_le(kernel_pair_worst(&pair), KERNEL_PAIR_BOUND);
        kernel_pair_close(&pair);
        settings_clear(&settings);
    }
}
END_TEST

START_TEST(threads_change_no_bit_of_an_exchange)
{
    const char *const settings[] = {
        "grid.cells=[70, 70]",
        "bodies.left.region.rectangle={from: [3, 3.2], to: [33, 51.2]}",
        "bodies.right.region.rectangle={from: [33, 3.2], to: [63, 51.2]}",
        _i == 0 ? "contact={law: stick, heat: perfect}"
                : "cracks=[{points: [[32.7, 2], [33.3, 53]], heat: conductance, conductance: 3}]",
        "transport.temperature.start='sin(3*x)*cos(2*y)'",
        NULL};
    test_same_bits_over_threads(TWO_BLOCKS, settings, 5, NULL);
}
END_TEST

Suite *suite_heat_contact(void)
{
    Suite *const suite = suite_create("heat_contact");
    TCase *const tests = tcase_create("heat_contact");
    tcase_add_loop_test(tests, bonded_bodies_in_perfect_contact_are_one_body, 0,
                        2 * HEAT_BLOCK_TRANSFERS * REST);
    tcase_add_loop_test(tests, a_crack_that_conducts_is_none, 0, REST);
    tcase_add_loop_test(tests, a_body_with_a_crack_is_two_bodies, 0, REST);
    tcase_add_loop_test(tests, the_order_of_bodies_does_not_matter, 0, REST);
    tcase_add_loop_test(tests, a_mirrored_scene_has_mirrored_temperatures, 0, TEST_SHAPES);
    tcase_add_loop_test(tests, the_history_has_the_heat_that_has_passed, 0, TEST_SHAPES);
    tcase_add_test(tests, heat_flows_where_bodies_touch_alone);
    tcase_add_test(tests, heat_flows_from_when_bodies_meet);
    tcase_add_loop_test(tests, areas_of_a_crack_add_up_to_its_own, 0, REST);
    tcase_add_loop_test(tests, fast_kernels_exchange_as_reference_kernels_do, 0, REST);
    tcase_add_loop_test(tests, threads_change_no_bit_of_an_exchange, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
