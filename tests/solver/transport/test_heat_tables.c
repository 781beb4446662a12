/* Conduction with properties that are tables of the temperature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "suites.h"
#include "support/heat_block.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MATERIAL(law, capacity, conductivity)                                                      \
    "materials=[{name: soft, law: " law ", density: 2, heat_capacity_table: " capacity             \
    ", conductivity_table: " conductivity "}]"
#define SOFT         "neo_hookean, bulk: 1.25, shear: 0.75"
#define CAPACITY     "[[-3, 0.4], [0, 0.5], [0.5, 1.5], [1, 0.6], [6, 0.9]]"
#define CONDUCTIVITY "[[-3, 0.05], [-0.5, 0.25], [0.3, 0.1], [6, 0.3]]"
static const char TABLES[] = MATERIAL(SOFT, CAPACITY, CONDUCTIVITY);

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

/* ----------------------------------------------------------------- the first law */

static const char FLUXES[] =
    "transport.temperature.fluxes=[{body: block, edge: all, value: '0.05+0.1*t'}, {body: block, "
    "edge: right, convection: {coefficient: 0.1, ambient: '1+t'}}]";

/* Of enthalpy; the held side jumps in the first step. */
START_TEST(enthalpy_is_what_the_source_fluxes_and_held_nodes_have_given)
{
    for (int k = 0; k < HEAT_BLOCK_TRANSFERS; k++) {
        struct settings settings = test_combination_settings(_i);
        heat_block_add_wild_heat(&settings, is_axisymmetric(_i));
        test_add_wild_velocity(&settings, is_axisymmetric(_i));
        settings_add(&settings, TABLES);
        settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
        settings_add(&settings, FLUXES);
        heat_block_add_transfer(&settings, k);
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
        const double start = heat_block_heat(&run);
        test_run_steps(&run, test_combination(_i).amplifies_round_off ? 3 : 40);
        const struct mpm_scalar_totals *const totals = &heat_block_scalar(&run)->totals;
        const double scale =
            1.0 + fabs(start) + fabs(totals->held) + fabs(totals->source) + fabs(totals->edges);
        ck_assert(fabs(totals->held) > 1e-3 && fabs(totals->edges) > 1e-3);
        ck_assert_near((heat_block_heat(&run) - start) / scale,
                       (totals->held + totals->source + totals->edges) / scale,
                       HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* --------------------------------------------------------- tables and constants */

/* Moving or at rest. */
START_TEST(tables_of_one_value_are_constants)
{
    const bool at_rest = _i >= TEST_COMBINATIONS;
    const int combination = _i % TEST_COMBINATIONS;
    struct test_run runs[2];
    if (at_rest && combination >= HEAT_BLOCK_REST)
        return;
    for (int k = 0; k < 2; k++) {
        struct settings settings = at_rest ? heat_block_rest_settings(combination)
                                           : test_combination_settings(combination);
        if (!at_rest) {
            heat_block_add_wild_heat(&settings, is_axisymmetric(combination));
            settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
        }
        if (at_rest)
            settings_add(&settings, HEAT_BLOCK_AT_REST);
        if (k == 1)
            settings_add(&settings, at_rest ? MATERIAL("none", "[[-9, 0.5], [0.2, 0.5], [9, 0.5]]",
                                                       "[[-8, 0.25], [8, 0.25]]")
                                            : MATERIAL(SOFT, "[[-9, 0.5], [0.2, 0.5], [9, 0.5]]",
                                                       "[[-8, 0.25], [8, 0.25]]"));
        runs[k] = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
        test_run_steps(&runs[k], test_combination(combination).amplifies_round_off ? 3 : 20);
        settings_clear(&settings);
    }
    const struct mpm_particles *const one = &runs[0].simulation->state.particles;
    const struct mpm_particles *const other = &runs[1].simulation->state.particles;
    for (size_t p = 0; p < one->count; p++)
        ck_assert_near(other->temperature[p], one->temperature[p], 1e-12);
    ck_assert_near(heat_block_heat(&runs[1]), heat_block_heat(&runs[0]), 1e-10);
    ck_assert_near(heat_block_scalar(&runs[1])->totals.held,
                   heat_block_scalar(&runs[0])->totals.held, 1e-10);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* Whatever the capacity does on the way. */
START_TEST(particles_learn_of_held_nodes_at_once_and_follow_them)
{
    struct settings settings = test_combination_settings(_i);
    settings_add(&settings, TABLES);
    settings_add(&settings, "transport.temperature.conditions=[{region: all, value: '1+2*t'}]");
    settings_add(&settings, "transport.temperature.start=-2");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    for (int step = 0; step < 3; step++) {
        test_run_steps(&run, 1);
        size_t count;
        double *const value = test_run_field(&run, MPM_FIELD_TEMPERATURE, &count);
        for (size_t p = 0; p < count; p++)
            ck_assert_near(value[p], 1.0 + 2.0 * mpm_simulation_time(run.simulation), 1e-12);
        free(value);
    }
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* An insulated body of one temperature takes a source: dT = s dt/(rho c), in enthalpy exact. */
START_TEST(a_source_raises_the_enthalpy_by_its_heat)
{
    struct settings settings = heat_block_rest_settings(0);
    settings_add(&settings, MATERIAL("none", "[[0, 1], [10, 3]]", "[[0, 1], [20, 1]]"));
    settings_add(&settings, "transport.temperature.conditions=[]");
    settings_add(&settings, "transport.temperature.start=2");
    settings_add(&settings, "transport.temperature.source=4");
    settings_add(&settings, "time={end: 1000, step: 0.02}");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    enum { STEPS = 200 };
    test_run_steps(&run, STEPS);
    /* h = T + T^2/10, from 2.4 by s t/rho = 8 */
    const double wanted = 5.0 * (sqrt(1.0 + 0.4 * (2.4 + 8.0)) - 1.0);
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        ck_assert_near(particles->temperature[p], wanted, 1e-12);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* --------------------------------------------------------------------- the step */

/* k/c at the points of both tables: 1/1, 2/1.5, 5/3 (both end there), of density 2. */
START_TEST(the_step_is_that_of_the_largest_diffusivity_of_the_tables)
{
    static const char *const materials[] = {
        MATERIAL("none", "[[0, 1], [10, 1.5], [30, 3]]", "[[0, 1], [10, 2], [30, 5]]"),
        "materials=[{name: soft, law: none, density: 2, heat_capacity: 2, conductivity_table: [[0, "
        "1], [10, 7], [30, 5]]}]",
        "materials=[{name: soft, law: none, density: 2, heat_capacity_table: [[0, 3], [10, 0.5], "
        "[30, 5]], conductivity: 2}]",
    };
    static const double wanted[] = {0.5 * 5.0 / 3.0, 0.5 * 3.5, 0.5 * 4.0};
    struct settings settings = {.count = 0};
    settings_add(&settings, materials[_i]);
    settings_add(&settings, "transport.temperature.start=1");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    ck_assert_near(run.simulation->diffusivity, wanted[_i], 1e-15);
    test_run_steps(&run, 2);
    ck_assert_near(run.simulation->diffusivity, wanted[_i], 1e-15);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ---------------------------------------------------------- outside of a table */

START_TEST(a_temperature_outside_of_a_table_ends_the_run_with_its_last_good_state)
{
    struct settings settings = heat_block_rest_settings(0);
    settings_add(&settings, _i == 0 ? MATERIAL("none", "[[0, 1], [3, 3]]", "[[-1, 1], [20, 1]]")
                                    : MATERIAL("none", "[[0, 1], [30, 3]]", "[[-1, 1], [3, 1]]"));
    settings_add(&settings, "transport.temperature.conditions=[]");
    settings_add(&settings, "transport.temperature.start=2");
    settings_add(&settings, "transport.temperature.source=4");
    settings_add(&settings, "time={end: 1000, step: 0.02}");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    struct mpm_error error = {.message = ""};
    const struct mpm_particles *const particles = &run.simulation->state.particles;
    double last = 2.0;
    enum mpm_status status = MPM_OK;
    for (int step = 0; step < 1000 && status == MPM_OK; step++) {
        last = particles->temperature[0];
        status = mpm_simulation_advance(run.simulation, 1000.0, &error);
    }
    ck_assert_int_eq(status, MPM_RUN_FAILED);
    ck_assert_int_eq(error.cause, MPM_CAUSE_TEMPERATURE);
    test_contains(error.message, "particle 0 (body 'block') is at a temperature of 3.0");
    test_contains(error.message, _i == 0
                                     ? "allowed: 0 to 3, the range of the heat_capacity_table of"
                                     : "allowed: -1 to 3, the range of the conductivity_table of");
    ck_assert_double_eq(particles->temperature[0], last);
    ck_assert_double_le(particles->temperature[0], 3.0);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

#define REFUSED(more)                                                                              \
    TEST_BLOCK_SCENE("{end: 1000, courant: 0.3}",                                                  \
                     "{name: soft, law: " SOFT ", density: 2, heat_capacity_table: " CAPACITY      \
                     ", conductivity_table: " CONDUCTIVITY "}",                                    \
                     "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2],\n"    \
                     "     to: [9, 8]}}}\n"                                                        \
                     "  - {name: other, material: soft, region: {rectangle: {from: [3, 8],\n"      \
                     "     to: [9, 9.6]}}}\n" more)

/* Scenes that are refused when they are made. */
static const char *const refused[][2] = {
    {REFUSED("transport: {temperature: {start: 6.5}}\n"),
     "initial temperature of body 'block' is 6.5 at ("},
    {REFUSED("transport: {temperature: {start: -3.5}}\n"),
     "allowed: -3 to 6, the range of the heat_capacity_table of 'soft'"},
    {TEST_BLOCK_SCENE("{end: 1000, courant: 0.3}",
                      "{name: soft, law: " SOFT ", density: 2, saturation: 3, diffusivity_table: "
                      "[[0, 1], [0.5, 2]]}",
                      "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2],\n"
                      "     to: [9, 8]}}}\n"
                      "transport: {concentration: {start: 0.6}}\n"),
     "allowed: 0 to 0.5, the range of the diffusivity_table of 'soft'"},
    {REFUSED("transport: {temperature: {}}\n"
             "contact: {fields: bodies, law: stick, heat: perfect}\n"),
     "heat: perfect between bodies that may part, with a heat_capacity_table"},
};

START_TEST(what_tables_do_not_have_is_refused_at_the_start)
{
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_simulation *simulation = NULL;
    struct mpm_scene *scene = test_scene_read_text(refused[_i][0]);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_BAD_INPUT);
    test_contains(error.message, refused[_i][1]);
    mpm_scene_free(scene);
}
END_TEST

/* c_s D over c_s: saturation 3, D up to 2. A source of 3 takes 1 of concentration in its time. */
START_TEST(a_solvent_has_the_step_and_the_range_of_its_table)
{
    struct settings settings = {.count = 0};
    struct mpm_error error = {.message = ""};
    settings_add(&settings, "materials=[{name: soft, law: none, density: 2, saturation: 3, "
                            "diffusivity_table: [[0, 1], [0.5, 2], [1, 1.5]]}]");
    settings_add(&settings, "transport={concentration: {start: 0.5, source: 3}}");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    ck_assert_near(run.simulation->diffusivity, 2.0, 1e-15);
    enum mpm_status status = MPM_OK;
    while (status == MPM_OK && mpm_simulation_time(run.simulation) < 1.0)
        status = mpm_simulation_advance(run.simulation, 1.0, &error);
    ck_assert_int_eq(status, MPM_RUN_FAILED);
    test_contains(error.message, "is at a concentration of 1.0");
    test_contains(error.message, "allowed: 0 to 1, the range of the diffusivity_table of 'soft'");
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

Suite *suite_heat_tables(void)
{
    Suite *suite = suite_create("heat_tables");
    TCase *all = tcase_create("tables");
    tcase_add_loop_test(all, enthalpy_is_what_the_source_fluxes_and_held_nodes_have_given, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(all, tables_of_one_value_are_constants, 0, 2 * TEST_COMBINATIONS);
    tcase_add_loop_test(all, particles_learn_of_held_nodes_at_once_and_follow_them, 0,
                        TEST_COMBINATIONS);
    tcase_add_test(all, a_source_raises_the_enthalpy_by_its_heat);
    tcase_add_loop_test(all, the_step_is_that_of_the_largest_diffusivity_of_the_tables, 0, 3);
    tcase_add_loop_test(all, a_temperature_outside_of_a_table_ends_the_run_with_its_last_good_state,
                        0, 2);
    tcase_add_loop_test(all, what_tables_do_not_have_is_refused_at_the_start, 0,
                        (int)(sizeof refused / sizeof refused[0]));
    tcase_add_test(all, a_solvent_has_the_step_and_the_range_of_its_table);
    suite_add_tcase(suite, all);
    return suite;
}
