/* Conduction of heat: planes of symmetry, both sets of kernels, scenes at rest, failures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/heat_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

/* ----------------------------------------------------------------- symmetry */

static const char HALF[] = "bodies.block.region.rectangle={from: [3, 5.6], to: [9, 8]}";
static const char PLANE[] =
    "boundary=[{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, symmetry: true}]";

#define END_FLUX(edge) "{body: block, edge: " edge ", convection: {coefficient: 0.4, ambient: 2}}"
static const char BOTH_ENDS[] =
    "transport.temperature.fluxes=[" END_FLUX("top") ", " END_FLUX("bottom") "]";
static const char ALL_ENDS[] = "transport.temperature.fluxes=[" END_FLUX("all") "]";
static const char UPPER_END[] = "transport.temperature.fluxes=[" END_FLUX("top") "]";

/* Left side prescribed, also at the nodes beyond the plane and on it. */
START_TEST(a_half_with_a_plane_of_symmetry_is_half_of_the_whole)
{
    const bool axisymmetric = is_axisymmetric(_i);
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, axisymmetric
                                    ? "transport.temperature.start='sin(3*r)*cos(2*(z-5.6))'"
                                    : "transport.temperature.start='sin(3*x)*cos(2*(y-5.6))'");
        settings_add(&settings, axisymmetric ? "transport.temperature.source='cos(r)*(z-5.6)^2'"
                                             : "transport.temperature.source='cos(x)*(y-5.6)^2'");
        settings_add(&settings, "transport.temperature.conditions=[{region: {line: {from: [3, 0], "
                                "to: [3, 12]}}, value: 2}]");
        settings_add(&settings, axisymmetric
                                    ? "bodies.block.velocity=['0.1*cos(r)', '0.1*sin(2*(z-5.6))']"
                                    : "bodies.block.velocity=['0.1*cos(x)', '0.1*sin(2*(y-5.6))']");
        if (k == 1) {
            settings_add(&settings, HALF);
            settings_add(&settings, PLANE);
        }
        settings_add(&settings, k == 0 ? BOTH_ENDS : UPPER_END);
        settings_add(&settings, "time={end: 1000, step: 0.05}");
        runs[k] = heat_block_open(&settings, MPM_KERNELS_AUTO);
        settings_clear(&settings);
    }
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], test_combination(_i).amplifies_round_off ? 3 : 20);
    ck_assert_near(2.0 * heat_block_scalar(&runs[1])->totals.edges,
                   heat_block_scalar(&runs[0])->totals.edges, 1e-10);
    ck_assert_near(2.0 * heat_block_heat(&runs[1]), heat_block_heat(&runs[0]), 1e-10);
    ck_assert_near(2.0 * heat_block_scalar(&runs[1])->totals.held,
                   heat_block_scalar(&runs[0])->totals.held, 1e-10);
    ck_assert_near(2.0 * heat_block_scalar(&runs[1])->totals.source,
                   heat_block_scalar(&runs[0])->totals.source, 1e-10);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* ------------------------------------------------------------------ kernels */

START_TEST(fast_kernels_conduct_as_reference_kernels_do)
{
    enum { STEPS = 30 };
    struct settings settings = test_combination_settings(_i % TEST_COMBINATIONS);
    const bool axisymmetric = is_axisymmetric(_i % TEST_COMBINATIONS);
    heat_block_add_wild_heat(&settings, axisymmetric);
    settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    settings_add(&settings,
                 "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, "
                 "heat_capacity: 0.5, principal_conductivities: [0.4, 0.1], conductivity_angle: "
                 "20}]");
    test_add_wild_velocity(&settings, axisymmetric);
    const struct kernel_side sides[HEAT_BLOCK_SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(HEAT_BLOCK, sides);
    for (int step = 0; step < STEPS && kernel_pair_step(&pair); step++)
        ;
    if (!test_combination(_i).amplifies_round_off)
        ck_assert_msg(kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND, "%s", kernel_pair_text(&pair));
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

START_TEST(fast_kernels_conduct_at_rest_as_reference_kernels_do)
{
    struct settings settings = heat_block_rest_settings(_i);
    settings_add(&settings, HEAT_BLOCK_AT_REST);
    const struct kernel_side sides[HEAT_BLOCK_SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(HEAT_BLOCK, sides);
    for (int step = 0; step < KERNEL_PAIR_STEPS; step++)
        ck_assert(kernel_pair_step(&pair));
    ck_assert_double_le(kernel_pair_worst(&pair), KERNEL_PAIR_BOUND);
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

/* What fast kernels do in other ways: four particles with the same nodes, as two by two a cell
 * mostly have, at rest and not; capacities that do not follow from masses. */
static const char *const other_ways[][2] = {
    {"bodies.block.particles_per_cell=[2, 2]", NULL},
    {"bodies.block.particles_per_cell=[2, 2]", HEAT_BLOCK_AT_REST},
    {"bodies=[{name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [6, 8]}}}, "
     "{name: other, material: dear, region: {rectangle: {from: [6, 3.2], to: [9, 8]}}}]",
     "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, "
     "heat_capacity: 0.5, conductivity: 0.25}, {name: dear, law: neo_hookean, density: 1, bulk: "
     "1.25, shear: 0.75, heat_capacity: 2, conductivity: 0.5}]"},
};
enum { OTHER_WAYS = 3 };

START_TEST(fast_kernels_conduct_in_other_ways_as_reference_kernels_do)
{
    const char *const *const way = other_ways[_i / TEST_COMBINATIONS];
    const int index = _i % TEST_COMBINATIONS;
    const bool at_rest = way[1] == HEAT_BLOCK_AT_REST;
    struct settings settings = at_rest ? heat_block_rest_settings(index % HEAT_BLOCK_REST)
                                       : test_combination_settings(index);
    for (int k = 0; k < 2; k++)
        if (way[k] != NULL)
            settings_add(&settings, way[k]);
    if (!at_rest) {
        heat_block_add_wild_heat(&settings, is_axisymmetric(index));
        settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    }
    const struct kernel_side sides[HEAT_BLOCK_SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(HEAT_BLOCK, sides);
    for (int step = 0; step < KERNEL_PAIR_STEPS; step++)
        ck_assert(kernel_pair_step(&pair));
    ck_assert_msg(kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND, "%s", kernel_pair_text(&pair));
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

/* A body with stress that nothing moves takes the passes of a step in motion. */
START_TEST(heat_alone_is_heat_in_a_body_that_does_not_move)
{
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = heat_block_rest_settings(_i);
        if (k == 1)
            settings_add(&settings, HEAT_BLOCK_AT_REST);
        runs[k] = heat_block_open(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&runs[k], 40);
        settings_clear(&settings);
    }
    size_t count;
    double *const moving = test_run_field(&runs[0], MPM_FIELD_TEMPERATURE, &count);
    double *const alone = test_run_field(&runs[1], MPM_FIELD_TEMPERATURE, NULL);
    for (size_t p = 0; p < count; p++)
        ck_assert_near(moving[p], alone[p], HEAT_BLOCK_ROUND_OFF);
    ck_assert_near(heat_block_heat(&runs[0]), heat_block_heat(&runs[1]), 1e-11);
    free(moving);
    free(alone);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

START_TEST(bits_of_temperatures_do_not_depend_on_threads)
{
    static const char *const with_stress[] = {
        TEST_BLOCK_FOR_THREADS,
        "transport.temperature.start='sin(3*x)*cos(2*y)'",
        "transport.temperature.source='cos(x+2*y+t)'",
        HEAT_BLOCK_HOT_SIDE,
        "bodies.block.velocity=['0.3*sin(2*x)*cos(y)', '0.4*cos(x+2*y)']",
        NULL};
    static const char *const alone[] = {TEST_BLOCK_FOR_THREADS,
                                        "transport.temperature.start='sin(3*x)*cos(2*y)'",
                                        "transport.temperature.source='cos(x+2*y+t)'",
                                        HEAT_BLOCK_HOT_SIDE,
                                        HEAT_BLOCK_AT_REST,
                                        NULL};
    test_same_bits_over_threads(HEAT_BLOCK, _i == 0 ? with_stress : alone, 40, NULL);
}
END_TEST

/* ------------------------------------------------------------------ failures */

/* The source is infinite from t = 2 on: the run goes back to the step before. */
START_TEST(a_failed_run_has_the_temperatures_of_its_last_good_step)
{
    struct test_run runs[2];
    struct mpm_error error = {.message = ""};
    int steps = 0;
    for (int k = 0; k < 2; k++) {
        struct settings settings = heat_block_rest_settings(_i);
        settings_add(&settings, "transport.temperature.source='1/(2-t>0.001 ? 1 : 0)'");
        if (_i == 0)
            settings_add(&settings, HEAT_BLOCK_AT_REST);
        if (_i == 2)
            settings_add(&settings, "transport.every=3");
        runs[k] = heat_block_open(&settings, MPM_KERNELS_AUTO);
        settings_clear(&settings);
    }
    while (mpm_simulation_advance(runs[0].simulation, 1000.0, &error) == MPM_OK)
        steps++;
    ck_assert_int_ge(steps, 35);
    ck_assert_ptr_nonnull(strstr(error.message, "source in transport that is not finite"));
    test_run_steps(&runs[1], steps);
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert_double_eq(heat_block_scalar(&runs[0])->totals.held,
                        heat_block_scalar(&runs[1])->totals.held);
    ck_assert_double_eq(heat_block_scalar(&runs[0])->totals.source,
                        heat_block_scalar(&runs[1])->totals.source);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

START_TEST(a_prescribed_temperature_that_is_not_finite_ends_the_run)
{
    struct settings settings = heat_block_rest_settings(_i);
    struct mpm_error error = {.message = ""};
    settings_add(&settings, "transport.temperature.conditions.0.value='1/(2-t>0.001 ? 1 : 0)'");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    while (mpm_simulation_advance(run.simulation, 1000.0, &error) == MPM_OK)
        ;
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_ptr_nonnull(
        strstr(error.message, "prescribed by transport.temperature.conditions.0"));
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* kappa = 0.25, cells of 1 by 0.8: 1/(0.5 (1 + 1/0.64)) */
START_TEST(steps_stay_below_the_limit_of_explicit_conduction)
{
    static const double LIMIT = 1.0 / (0.5 * (1.0 + 1.0 / 0.64));
    struct settings settings = {.count = 0};
    settings_add(&settings, HEAT_BLOCK_AT_REST);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.3 * LIMIT, 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
    settings_add(&settings, "materials.soft.conductivity=1000");
    run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.3 * LIMIT * 0.25e-3, 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ------------------------------------------------------------- a steady state */

/* A hot and a cold side: in the end what flows into one flows out of the other. The slowest mode
 * dies as exp(-pi^2 kappa t / 4.8^2) = exp(-0.107 t). */
START_TEST(conduction_comes_to_rest_when_what_flows_in_flows_out)
{
    static const char SIDES[] =
        "transport.temperature.conditions=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
        "value: 1}, {region: {line: {from: [0, 8], to: [14, 8]}}, value: 3}]";
    struct settings settings = {.count = 0};
    settings_add(&settings, HEAT_BLOCK_AT_REST);
    settings_add(&settings, SIDES);
    settings_add(&settings, "time={end: 1000, courant: 0.4, rest: {residual: 1e-8}}");
    struct test_run run = heat_block_open(&settings, heat_block_kernels(_i));
    struct mpm_rest rest;
    int steps = 0;
    while (!mpm_simulation_at_rest(run.simulation, &rest) && steps++ < 1000)
        test_run_steps(&run, 1);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    ck_assert(rest.residual < 1e-8 && steps > 100 && steps < 1000);
    for (size_t p = 0; p < particles->count; p++)
        ck_assert_near(particles->temperature[p],
                       1.0 + 2.0 * (particles->position[1][p] - 3.2) / 4.8, 1e-2);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ------------------------------------------------- steps of conduction of their own */

/* A block that stays where it is, after `steps` steps, fewer than there are between two sorts,
 * after which particles settle (transport.h). */
static struct test_run resting_block(int index, const char *time, const char *transport, int steps)
{
    struct settings settings = heat_block_rest_settings(index);
    settings_add(&settings, "materials.soft.conductivity=2");
    settings_add(&settings, time);
    settings_add(&settings, transport);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, steps);
    settings_clear(&settings);
    return run;
}

static void compare_temperatures(struct test_run runs[2])
{
    const struct mpm_particles *const a = &runs[0].simulation->state.particles;
    const struct mpm_particles *const b = &runs[1].simulation->state.particles;
    for (size_t p = 0; p < a->count; p++)
        ck_assert_near(a->temperature[p], b->temperature[p], 1e-12);
    ck_assert_near(heat_block_scalar(&runs[0])->totals.held,
                   heat_block_scalar(&runs[1])->totals.held, 1e-11);
    ck_assert_near(heat_block_scalar(&runs[0])->totals.source,
                   heat_block_scalar(&runs[1])->totals.source, 1e-11);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}

/* kappa = 2: its limit is 0.0976, and 0.2 has three steps of conduction. */
START_TEST(a_step_in_parts_conducts_as_so_many_steps_do)
{
    struct test_run runs[2] = {
        resting_block(_i, "time={end: 1000, step: 0.2}", "transport.substeps=10", 7),
        resting_block(_i, "time={end: 1000, step: 0.066666666666666666}", "transport.every=1", 21),
    };
    compare_temperatures(runs);
}
END_TEST

START_TEST(conduction_that_waits_is_that_of_one_long_step)
{
    struct test_run runs[2] = {
        resting_block(_i, "time={end: 1000, step: 0.015}", "transport.every=5", 30),
        resting_block(_i, "time={end: 1000, step: 0.075}", "transport.every=1", 6),
    };
    compare_temperatures(runs);
}
END_TEST

/* It would pass its limit, 0.0976, with the seventh step. */
START_TEST(conduction_does_not_wait_beyond_its_limit)
{
    struct test_run runs[2] = {
        resting_block(_i, "time={end: 1000, step: 0.015}", "transport.every=100", 30),
        resting_block(_i, "time={end: 1000, step: 0.09}", "transport.every=1", 5),
    };
    compare_temperatures(runs);
}
END_TEST

/* 28 steps that conduct every fifth time leave three. */
START_TEST(conduction_does_not_wait_beyond_the_last_step)
{
    static const char *const ends[] = {"time={end: 1000, step: 0.015}",
                                       "time={end: 1000, step: 0.015, steps: 28}"};
    static const double waited[] = {3.0 * 0.015, 0.0};
    for (int k = 0; k < 2; k++) {
        struct test_run run = resting_block(_i, ends[k], "transport.every=5", 28);
        ck_assert_near(run.simulation->state.transport.waited, waited[k], 1e-15);
        test_run_close(&run);
    }
}
END_TEST

/* -------------------------------------------------------------------- solvent */

/* The same numbers as conductivity and capacity of heat, with a saturation for the scale. */
static const char *const two_scalars[] = {
    "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, heat_capacity: "
    "0.5, principal_conductivities: [0.25, 0.1], conductivity_angle: 20, saturation: 3, "
    "principal_diffusivities: [0.25, 0.1], diffusivity_angle: 20}]",
    "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, heat_capacity: "
    "0.5, conductivity_table: [[-9, 0.1], [0.5, 0.3], [9, 0.2]], saturation: 3, "
    "diffusivity_table: [[-9, 0.1], [0.5, 0.3], [9, 0.2]]}]",
};

/* c rho_0 = 1 and k = D: both follow the same equation, and content differs by c_s / (c rho_0). */
START_TEST(a_solvent_diffuses_as_heat_does)
{
    struct settings settings = test_combination_settings(_i % TEST_COMBINATIONS);
    const bool axisymmetric = is_axisymmetric(_i % TEST_COMBINATIONS);
    settings_add(&settings, two_scalars[_i / TEST_COMBINATIONS]);
    heat_block_add_wild_heat(&settings, axisymmetric);
    settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    settings_add(&settings, "transport.temperature.fluxes=[{body: block, edge: right, convection: "
                            "{coefficient: 0.4, ambient: 2}}]");
    settings_add_formatted(
        &settings,
        "transport.concentration={start: '%s', source: '3*cos(%s+2*%s+t)', conditions: [{region: "
        "{line: {from: [0, 3.2], to: [14, 3.2]}}, value: '1+0.1*t'}], fluxes: [{body: block, edge: "
        "right, convection: {coefficient: 1.2, ambient: 2}}]}",
        axisymmetric ? "sin(3*r)*cos(2*z)" : "sin(3*x)*cos(2*y)", axisymmetric ? "r" : "x",
        axisymmetric ? "z" : "y");
    settings_add(&settings, "time={end: 1000, step: 0.05}");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    test_run_steps(&run, test_combination(_i % TEST_COMBINATIONS).amplifies_round_off ? 3 : 20);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        ck_assert_near(particles->concentration[p], particles->temperature[p], 1e-11);
    const struct mpm_nodal_scalar *const list = run.simulation->state.transport.list;
    ck_assert_near(list[1].totals.held, 3.0 * list[0].totals.held, 1e-10);
    ck_assert_near(list[1].totals.edges, 3.0 * list[0].totals.edges, 1e-10);
    ck_assert_near(list[1].totals.source, 3.0 * list[0].totals.source, 1e-10);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* `all` leaves out what lies on a plane: half the area of the whole, 2 (6 + 4.8), and one step of
 * what flows in. */
START_TEST(nothing_flows_through_a_plane_of_symmetry)
{
    double inflow[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        settings_add(&settings, ALL_ENDS);
        settings_add(&settings, "time={end: 1000, step: 0.05}");
        if (k == 1) {
            settings_add(&settings, HALF);
            settings_add(&settings, PLANE);
        }
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&run, 1);
        inflow[k] = heat_block_scalar(&run)->totals.edges;
        test_run_close(&run);
        settings_clear(&settings);
    }
    ck_assert_near(inflow[0], 0.05 * 0.8 * 2.0 * 10.8, HEAT_BLOCK_ROUND_OFF);
    ck_assert_near(2.0 * inflow[1], inflow[0], HEAT_BLOCK_ROUND_OFF);
}
END_TEST

START_TEST(a_flux_on_a_plane_of_symmetry_is_refused)
{
    static const char scene_text[] = TEST_BLOCK_SCENE(
        "{end: 1}",
        "{name: soft, law: neo_hookean, density: 2, bulk: 1, shear: 1, heat_capacity: 1, "
        "conductivity: 1}",
        "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [9, 8]}}}\n"
        "boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]\n"
        "transport: {temperature: {fluxes: [{body: block, edge: left, value: 1}]}}\n");
    struct mpm_scene *const scene = test_scene_read_text(scene_text);
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_simulation_create(scene, &(struct mpm_simulation_options){.threads = 1},
                                           &simulation, &error),
                     MPM_BAD_INPUT);
    test_contains(error.message, "transport.temperature.fluxes.0.edge: no particle of body 'block' "
                                 "has an edge on its left that is not on r = 0 or on a plane of "
                                 "symmetry");
    mpm_scene_free(scene);
}
END_TEST

Suite *suite_heat_runs(void)
{
    Suite *suite = suite_create("heat_runs");
    TCase *all = tcase_create("every combination");
    tcase_add_loop_test(all, a_half_with_a_plane_of_symmetry_is_half_of_the_whole, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, fast_kernels_conduct_as_reference_kernels_do, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, fast_kernels_conduct_at_rest_as_reference_kernels_do, 0,
                        HEAT_BLOCK_REST);
    tcase_add_loop_test(all, fast_kernels_conduct_in_other_ways_as_reference_kernels_do, 0,
                        OTHER_WAYS * TEST_COMBINATIONS);
    tcase_add_loop_test(all, heat_alone_is_heat_in_a_body_that_does_not_move, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, bits_of_temperatures_do_not_depend_on_threads, 0, 2);
    tcase_add_loop_test(all, a_failed_run_has_the_temperatures_of_its_last_good_step, 0, 3);
    tcase_add_loop_test(all, a_prescribed_temperature_that_is_not_finite_ends_the_run, 0, 1);
    tcase_add_loop_test(all, conduction_comes_to_rest_when_what_flows_in_flows_out, 0,
                        HEAT_BLOCK_SETS);
    tcase_add_loop_test(all, a_step_in_parts_conducts_as_so_many_steps_do, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, conduction_that_waits_is_that_of_one_long_step, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, conduction_does_not_wait_beyond_its_limit, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, conduction_does_not_wait_beyond_the_last_step, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, a_solvent_diffuses_as_heat_does, 0, 2 * TEST_COMBINATIONS);
    tcase_add_test(all, nothing_flows_through_a_plane_of_symmetry);
    tcase_add_test(all, a_flux_on_a_plane_of_symmetry_is_refused);
    tcase_add_test(all, steps_stay_below_the_limit_of_explicit_conduction);
    suite_add_tcase(suite, all);
    return suite;
}
