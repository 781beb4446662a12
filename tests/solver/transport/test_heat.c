/* Conduction of heat: gradients, sums and motion, with every family, geometry and order of the
 * stress update.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/heat_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

/* ----------------------------------------------------------------- gradients */

/* sum_i x_i inflow_i along both axes, of nodal values a + b . x: with an exact gradient, - sum V k
 * b whatever the body's edges do, since sum_i x_i G_ip is the unit tensor. */
static void first_moment(const struct test_run *run, const double b[AXES], double moment[AXES])
{
    struct mpm_state *const state = &run->simulation->state;
    struct mpm_nodal_scalar *const scalar = heat_block_scalar(run);
    const int64_t nodes = mpm_grid_nodes(&state->grid);
    for (int64_t node = 0; node < nodes; node++) {
        double place[AXES];
        mpm_grid_position(&state->grid, node, place);
        scalar->value[node] = 0.7 + b[0] * place[0] + b[1] * place[1];
        scalar->inflow[node] = 0.0;
    }
    state->transport.conducted = scalar;
    for (int64_t strip = 0; strip < state->strip_count; strip++)
        state->kernels.scalar->conduct(state, strip, 0);
    state->transport.conducted = NULL;
    moment[0] = moment[1] = 0.0;
    for (int64_t node = 0; node < nodes; node++) {
        double place[AXES];
        mpm_grid_position(&state->grid, node, place);
        for (int axis = 0; axis < AXES; axis++)
            moment[axis] += place[axis] * scalar->inflow[node];
    }
}

static double total_volume(const struct test_run *run)
{
    size_t count;
    double *const volume = test_run_field(run, MPM_FIELD_VOLUME, &count);
    double sum = 0.0;
    for (size_t p = 0; p < count; p++)
        sum += volume[p];
    free(volume);
    return sum;
}

/* Axisymmetric functions have sum_i r_i G_ip = 1 only for domains of points: those of uGIMP and
 * CPDI are means weighted with r. Gradients along z are exact with all. */
START_TEST(a_linear_field_has_an_exact_gradient)
{
    static const double b[AXES] = {0.3, -0.8};
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        double moment[AXES];
        const double scale = 0.25 * total_volume(&run);
        first_moment(&run, b, moment);
        for (int axis = is_axisymmetric(_i) ? 1 : 0; axis < AXES; axis++)
            ck_assert_near(moment[axis] / scale, -b[axis], HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* The rate of a linear field is zero where no node lacks a particle: cubic splines see an edge up
 * to eight cells away. With r, div grad r = 1/r. */
START_TEST(a_linear_field_stays_inside)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, is_axisymmetric(_i)
                                    ? "transport.temperature.start='2-0.8*z'"
                                    : "transport.temperature.start='2+0.3*x-0.8*y'");
        settings_add(&settings, "grid.cells=[24, 24]");
        settings_add(&settings, "bodies.block.region.rectangle={from: [2, 1.6], to: [22, 17.6]}");
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        size_t count;
        double *const before = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        test_run_steps(&run, 1);
        double *const after = test_run_field(&run, MPM_FIELD_TEMPERATURE, NULL);
        double *const place = test_run_field(&run, MPM_FIELD_POSITION, NULL);
        size_t inside = 0;
        for (size_t p = 0; p < count; p++) {
            const double x = place[AXES * p], y = place[AXES * p + 1];
            if (x < 11.0 || x > 13.0 || y < 8.8 || y > 10.4)
                continue;
            ck_assert_near(after[p], before[p], HEAT_BLOCK_ROUND_OFF);
            inside++;
        }
        ck_assert_uint_eq(inside, 12);
        free(before);
        free(after);
        free(place);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* -------------------------------------------------------------------- sums */

START_TEST(heat_is_what_source_and_conditions_have_given)
{
    for (int k = 0; k < HEAT_BLOCK_SETS * HEAT_BLOCK_TRANSFERS; k++) {
        struct settings settings = test_combination_settings(_i);
        heat_block_add_wild_heat(&settings, is_axisymmetric(_i));
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
        heat_block_add_transfer(&settings, k / HEAT_BLOCK_SETS);
        struct test_run run = heat_block_open(&settings, heat_block_kernels(k % HEAT_BLOCK_SETS));
        const double start = heat_block_heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        const struct mpm_scalar_totals *const totals = &heat_block_scalar(&run)->totals;
        const double scale = 1.0 + fabs(start) + fabs(totals->held) + fabs(totals->source);
        ck_assert(fabs(totals->held) > 1e-3 && fabs(totals->source) > 1e-3);
        ck_assert_near((heat_block_heat(&run) - start) / scale,
                       (totals->held + totals->source) / scale, HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* All nodes are held at a value that is linear in the places and in time: particles have it at the
 * end of every step. Means over domains weighted with r are not at the particle's r. */
START_TEST(particles_follow_nodes_that_are_held)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        const bool axisymmetric = is_axisymmetric(_i);
        settings_add(&settings,
                     axisymmetric
                         ? "transport.temperature.conditions=[{region: all, value: '1+0.3*z+2*t'}]"
                         : "transport.temperature.conditions=[{region: all, value: "
                           "'1+0.3*y-0.2*x+2*t'}]");
        settings_add(&settings, axisymmetric ? "transport.temperature.start='1+0.3*z'"
                                             : "transport.temperature.start='1+0.3*y-0.2*x'");
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        test_run_steps(&run, 5);
        size_t count;
        double *const value = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        double *const place = test_run_field(&run, MPM_FIELD_POSITION, NULL);
        const double time = mpm_simulation_time(run.simulation);
        for (size_t p = 0; p < count; p++)
            ck_assert_near(value[p],
                           1.0 + 0.3 * place[AXES * p + 1] + 2.0 * time -
                               (axisymmetric ? 0.0 : 0.2 * place[AXES * p]),
                           1e-12);
        free(value);
        free(place);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* Their values at t = 0 do not fit the condition: the first step settles that. */
START_TEST(particles_learn_of_held_nodes_at_once)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "transport.temperature.conditions=[{region: all, value: '1+2*t'}]");
        settings_add(&settings, "transport.temperature.start=5");
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        test_run_steps(&run, 1);
        size_t count;
        double *const value = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        for (size_t p = 0; p < count; p++)
            ck_assert_near(value[p], 1.0 + 2.0 * mpm_simulation_time(run.simulation), 1e-12);
        free(value);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

START_TEST(heat_is_per_radian_or_for_the_thickness)
{
    struct settings settings = test_combination_settings(_i);
    settings_add(&settings, "transport.temperature.start=3");
    if (!is_axisymmetric(_i))
        settings_add(&settings, "thickness=0.5");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    const double area = 6.0 * 4.8, per = is_axisymmetric(_i) ? 6.0 : 0.5;
    ck_assert_near(heat_block_heat(&run), 2.0 * 0.5 * 3.0 * area * per, 1e-10);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Of each kind one, on all sides; T^4 of absolute temperatures. */
static const char FLUXES[] =
    "transport.temperature.fluxes=[{body: block, edge: all, value: '0.3+0.1*t'}, {body: block, "
    "edge: right, convection: {coefficient: 0.4, ambient: '3+t'}}, {body: block, edge: bottom, "
    "radiation: {emissivity: 0.5, sigma: 0.01, ambient: 5}}]";

START_TEST(heat_is_what_fluxes_have_given)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        settings_add(&settings, is_axisymmetric(_i) ? "transport.temperature.start='3+sin(3*r)'"
                                                    : "transport.temperature.start='3+sin(3*x)'");
        settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
        settings_add(&settings, FLUXES);
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        const double start = heat_block_heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        const struct mpm_scalar_totals *const totals = &heat_block_scalar(&run)->totals;
        const double scale = 1.0 + fabs(start) + fabs(totals->held) + fabs(totals->edges);
        ck_assert(fabs(totals->edges) > 1e-2);
        ck_assert_near((heat_block_heat(&run) - start) / scale,
                       (totals->held + totals->edges) / scale, HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* A flux of 2 on one side: 6 wide at the top, 4.8 high at r = 9. */
START_TEST(a_flux_gives_its_area_and_per_radian)
{
    static const char *const sides[] = {"top", "right"};
    for (int side = 0; side < 2; side++) {
        struct settings settings = test_combination_settings(_i);
        const double planar[] = {6.0, 4.8}, per_radian[] = {0.5 * (81.0 - 9.0), 9.0 * 4.8};
        settings_add_formatted(&settings,
                               "transport.temperature.fluxes=[{body: block, edge: %s, value: 2}]",
                               sides[side]);
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&run, 3);
        const double area = (is_axisymmetric(_i) ? per_radian : planar)[side];
        ck_assert_near(heat_block_heat(&run), 2.0 * area * mpm_simulation_time(run.simulation),
                       1e-10);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* In the first step, of a body of temperature 2. */
static const struct {
    const char *flux;
    double value;
} kinds[] = {{"value: '2+y-y'", 2.0},
             {"convection: {coefficient: 0.4, ambient: 3}", 0.4},
             {"radiation: {emissivity: 0.5, sigma: 0.01, ambient: 3}", 0.325}};

START_TEST(fluxes_are_given_or_proportional_or_those_of_stefan_and_boltzmann)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "transport.temperature.fluxes=[{body: block, edge: top, %s}]",
                           kinds[_i].flux);
    settings_add(&settings, "transport.temperature.start=2");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    const double start = heat_block_heat(&run);
    test_run_steps(&run, 1);
    ck_assert_near((heat_block_heat(&run) - start) / mpm_simulation_time(run.simulation),
                   6.0 * kinds[_i].value, 1e-11);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* A body of one temperature, whose conductivity keeps it so: dT/dt = h A (ambient - T)/(c rho V),
 * A/V = 2 (6 + 4.8)/(6 4.8). */
START_TEST(a_body_cools_to_its_surroundings)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "materials=[{name: soft, law: none, density: 2, heat_capacity: 0.5, "
                            "conductivity: 100}]");
    settings_add_formatted(&settings, "method.shape=%s", test_shapes[_i]);
    settings_add(&settings, "transport.temperature.start=5");
    settings_add(&settings, "transport.temperature.fluxes=[{body: block, edge: all, convection: "
                            "{coefficient: 0.5, ambient: 1}}]");
    settings_add(&settings, "time.end=1");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    struct mpm_error error = {.message = ""};
    while (mpm_simulation_time(run.simulation) < 1.0)
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, &error), MPM_OK);
    const double rate = 0.5 * 2.0 * 10.8 / 28.8;
    /* explicit steps of 1e-3 and gradients of 0.5 in a conductivity of 100 */
    ck_assert_near(heat_block_heat(&run) / 28.8, 1.0 + 4.0 * exp(-rate), 0.01);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Only the source, and no motion: c rho dT/dt = s. */
START_TEST(a_source_warms_a_free_body_evenly)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "transport.temperature.source=3");
        settings_add(&settings, "transport.temperature.start=1");
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        test_run_steps(&run, 5);
        size_t count;
        double *const value = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        const double expected = 1.0 + 3.0 * mpm_simulation_time(run.simulation);
        for (size_t p = 0; p < count; p++)
            ck_assert_near(value[p], expected, 1e-12);
        free(value);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* ------------------------------------------------------------------- motion */

START_TEST(particles_keep_their_temperature_without_conduction_bit_by_bit)
{
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "materials.soft.conductivity=0");
        settings_add(&settings, is_axisymmetric(_i)
                                    ? "transport.temperature.start='2+sin(3*r)*cos(2*z)'"
                                    : "transport.temperature.start='2+sin(3*x)*cos(2*y)'");
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        size_t count;
        double *const before = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        double *const after = test_run_field(&run, MPM_FIELD_TEMPERATURE, NULL);
        ck_assert_mem_eq(before, after, count * sizeof *before);
        free(before);
        free(after);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

START_TEST(pic_conducts_without_conductivity)
{
    struct settings settings = test_combination_settings(_i);
    settings_add(&settings, "materials.soft.conductivity=0");
    settings_add(&settings, "transport.temperature.transfer=pic");
    heat_block_add_wild_heat(&settings, is_axisymmetric(_i));
    settings_add(&settings, "transport.temperature.source=0");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    double before[2], after[2];
    const double start =
        mpm_transport_content(&run.simulation->state, heat_block_scalar(&run), before);
    test_run_steps(&run, 10);
    ck_assert_near(mpm_transport_content(&run.simulation->state, heat_block_scalar(&run), after),
                   start, 1e-10);
    ck_assert_double_lt(after[1] - after[0], 0.8 * (before[1] - before[0]));
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* Conductivities of a material, turned by 30 degrees: F is a rotation by 50 degrees more. */
START_TEST(conductivities_turn_with_the_material)
{
    static const double b[AXES] = {0.6, -0.2};
    const double turn = 50.0 * G_PI / 180.0, angle = 80.0 * G_PI / 180.0;
    const double f[] = {cos(turn), -sin(turn), sin(turn), cos(turn), 1.0};
    for (int set = 0; set < HEAT_BLOCK_SETS; set++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings,
                     "materials=[{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: "
                     "0.75, heat_capacity: 0.5, principal_conductivities: [0.5, 0.1], "
                     "conductivity_angle: 30}]");
        struct test_run run = heat_block_open(&settings, heat_block_kernels(set));
        struct mpm_error error = {.message = ""};
        size_t count;
        double *const place = test_run_field(&run, MPM_FIELD_POSITION, &count);
        double *const start = g_new(double, 5 * count);
        for (size_t p = 0; p < count; p++)
            memcpy(start + 5 * p, f, sizeof f);
        ck_assert_msg(mpm_simulation_set_start(run.simulation, NULL, start, &error) == MPM_OK, "%s",
                      error.message);
        double moment[AXES];
        first_moment(&run, b, moment);
        const double volume = total_volume(&run), c = cos(angle), s = sin(angle);
        const double along = c * b[0] + s * b[1], across = c * b[1] - s * b[0];
        const double flow[AXES] = {c * 0.5 * along - s * 0.1 * across,
                                   s * 0.5 * along + c * 0.1 * across};
        for (int axis = is_axisymmetric(_i) ? 1 : 0; axis < AXES; axis++)
            if (!is_axisymmetric(_i))
                ck_assert_near(moment[axis] / volume, -flow[axis], HEAT_BLOCK_ROUND_OFF);
        free(place);
        g_free(start);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

Suite *suite_heat(void)
{
    Suite *suite = suite_create("heat");
    TCase *all = tcase_create("every combination");
    tcase_add_loop_test(all, a_linear_field_has_an_exact_gradient, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_linear_field_stays_inside, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, heat_is_what_source_and_conditions_have_given, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, particles_follow_nodes_that_are_held, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, particles_learn_of_held_nodes_at_once, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, heat_is_what_fluxes_have_given, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_flux_gives_its_area_and_per_radian, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, fluxes_are_given_or_proportional_or_those_of_stefan_and_boltzmann, 0,
                        (int)G_N_ELEMENTS(kinds));
    tcase_add_loop_test(all, a_body_cools_to_its_surroundings, 0, TEST_SHAPES);
    tcase_add_loop_test(all, heat_is_per_radian_or_for_the_thickness, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, a_source_warms_a_free_body_evenly, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, particles_keep_their_temperature_without_conduction_bit_by_bit, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, pic_conducts_without_conductivity, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, conductivities_turn_with_the_material, 0, HEAT_BLOCK_REST);
    suite_add_tcase(suite, all);
    return suite;
}
