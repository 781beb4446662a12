/* Heat and mechanics: what waves without flow of heat mean for the time step, what expansion means
 * for the guard of the energy, and temperatures that have no meaning.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/heat_block.h"
#include "support/near.h"
#include "support/settings.h"

#include <glib.h>
#include <math.h>
#include <string.h>

#define MATERIAL(law, more)                                                                        \
    "materials=[{name: soft, law: " law ", density: 2, heat_capacity: 0.5, conductivity: 0, " more \
    "}]"
/* N = 9 alpha^2 K T/(rho c) = 0.225 at T = 2 */
#define SOLID "bulk: 1.25, shear: 0.75, thermal_expansion: 0.1, stress_free_temperature: 2"
#define GAS   "gas_constant: 0.3"

/* The first step, and the square of what waves without flow of heat are faster by, at most. */
static const struct {
    const char *material;
    double faster;
} media[] = {
    {MATERIAL("neo_hookean", SOLID), 1.0 / 0.775},
    {MATERIAL("linear_elastic", SOLID), 1.0 / 0.775},
    {MATERIAL("ideal_gas", GAS), 1.6},
};

static double first_step(const char *material, const char *heating)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, material);
    settings_add(&settings, heating);
    settings_add(&settings, "transport.temperature.start=2");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, 1);
    const double step = mpm_simulation_time_step(run.simulation);
    test_run_close(&run);
    settings_clear(&settings);
    return step;
}

START_TEST(the_time_step_is_that_of_waves_without_flow_of_heat)
{
    const double without = first_step(media[_i].material, "transport.temperature.heating=false");
    const double with = first_step(media[_i].material, "transport.temperature.heating=true");
    ck_assert_near(without / with, sqrt(media[_i].faster), 1e-12);
}
END_TEST

/* At rest at first, without any energy but heat: kinetic energy is work of the gas, or of a body
 * that was cold and is held at T = 12 from then on. */
static const struct {
    const char *material, *condition;
} sudden[] = {
    {MATERIAL("ideal_gas", GAS), "transport.temperature.conditions=[]"},
    {MATERIAL("linear_elastic", SOLID),
     "transport.temperature.conditions=[{region: all, value: '2+2*min(t,5)'}]"},
};

START_TEST(kinetic_energy_from_expansion_is_no_instability)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, sudden[_i].material);
    settings_add(&settings, sudden[_i].condition);
    settings_add(&settings, "transport.temperature.start=2");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, 8);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_double_gt(ledger.expansion_work, 0.1);
    ck_assert_double_gt(ledger.kinetic_energy, 0.02);
    ck_assert_double_lt(fabs(ledger.total_energy), 0.3 * ledger.expansion_work);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* No energy, no work and no waves: nothing has grown. */
START_TEST(a_gas_at_absolute_zero_makes_no_energy_from_nothing)
{
    struct settings settings = {.count = 0};
    struct mpm_energy_growth growth;
    struct mpm_error error = {0};
    settings_add(&settings, MATERIAL("ideal_gas", GAS));
    settings_add(&settings, "time={end: 1, step: 0.01}");
    settings_add(&settings, "bodies.0.velocity=[0, 0]");
    settings_add(&settings, "transport.temperature.start=0");
    settings_add(&settings, "transport.temperature.conditions=[]");
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    test_run_steps(&run, 3);
    ck_assert_int_eq(mpm_simulation_judge(run.simulation, &error), MPM_OK);
    ck_assert(!mpm_simulation_energy_growth(run.simulation, &growth));
    ck_assert_near(growth.factor, 1.0, 0.0);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ------------------------------------------------------------------ failures */

#define HEATING "transport.temperature.heating=true"
#define HELD    "boundary=[{region: all, velocity: [0, 0]}]"
#define RADIATION(ambient)                                                                         \
    "transport.temperature.fluxes=[{body: block, edge: top, radiation: {emissivity: 0.5, sigma: "  \
    "1e-3, ambient: '" ambient "'}}]"
#define UNSTABLE                                                                                   \
    MATERIAL("neo_hookean",                                                                        \
             "bulk: 1.25, shear: 0.75, thermal_expansion: 0.5, stress_free_temperature: 1")

/* Settings of the block, one of them past what is allowed, and part of the message. c_v is negative
 * from T = 2 rho_0 c/(9 K) = 16/45 on for alpha = 0.5. */
static const struct {
    const char *settings[3], *message;
} refused[] = {
    {{UNSTABLE, HEATING, "transport.temperature.start='x<3.4 && y<4 ? 0.4 : 0.3'"},
     "start: particle 0 (body 'block') is at a temperature of 0.4, at which thermal_expansion "
     "makes the heat capacity at constant volume negative; allowed: 9 alpha^2 K T below density "
     "times heat_capacity"},
    {{MATERIAL("neo_hookean", SOLID), HEATING,
      "transport.temperature.start='x<3.4 && y<4 ? -0.5 : 1'"},
     "start: particle 0 (body 'block') is at a temperature of -0.5; allowed"},
    {{MATERIAL("ideal_gas", GAS), "transport.temperature.start='x<3.4 && y<4 ? -0.5 : 1'"},
     "start: particle 0 (body 'block') is at a temperature of -0.5; allowed"},
    {{RADIATION("-1"), "transport.temperature.start=1"},
     "transport.temperature.fluxes.0.radiation.ambient: is -1 at ("},
    {{RADIATION("y-x"), "transport.temperature.start=1"},
     "transport.temperature.fluxes.0.radiation.ambient: is -"},
    {{RADIATION("1"), "transport.temperature.start='x>8 && y>7 ? -0.5 : 1'"},
     "transport.temperature.fluxes.0.radiation: body 'block' has a temperature of -0.5 at ("},
};

START_TEST(temperatures_without_meaning_are_refused_at_the_start)
{
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    char *const folder = test_folder_create();
    char *const path = test_folder_write(folder, "scene.yaml", HEAT_BLOCK);
    const size_t count = refused[_i].settings[2] == NULL ? 2 : 3;
    ck_assert_msg(mpm_scene_read(path, refused[_i].settings, count, &scene, &error) == MPM_OK, "%s",
                  error.message);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, refused[_i].message) != NULL, "%s", error.message);
    mpm_scene_free(scene);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

/* A source of -5, or of 5, in a body with rho c = 1; steps of 0.05. */
static const struct {
    const char *settings[4], *message;
} failing[] = {
    {{UNSTABLE, HEATING, "transport.temperature.start=0.2", "transport.temperature.source=5"},
     "particle 0 (body 'block') is at a temperature of 0."},
    {{MATERIAL("neo_hookean", SOLID), HEATING, "transport.temperature.start=1",
      "transport.temperature.source=-5"},
     "(body 'block') is at a temperature of -"},
    {{MATERIAL("ideal_gas", GAS), "transport.temperature.start=1",
      "transport.temperature.source=-5"},
     "(body 'block') is at a temperature of -"},
    {{RADIATION("1-10*t"), "transport.temperature.start=1"},
     "(body 'block') radiates to an ambient temperature of -"},
    {{RADIATION("1"), "transport.temperature.start=1", "transport.temperature.source=-5"},
     "(body 'block') radiates at a temperature of -"},
    /* alpha below zero: stretched, so that it warms, shrinks, is stretched more, without end */
    {{MATERIAL("neo_hookean", "bulk: 1.25, shear: 0.75, thermal_expansion: -0.1, "
                              "stress_free_temperature: 1.5"),
      HEATING, "transport.temperature.start=8",
      "boundary=[{region: all, velocity: ['4*(x-6)', '4*(y-5)']}]"},
     "particle 0 (body 'block') has no temperature that fits its stress after the step, from 8"},
};

START_TEST(temperatures_without_meaning_end_the_run)
{
    struct settings settings = {.count = 0};
    struct mpm_error error = {.message = ""};
    settings_add(&settings, HELD);
    settings_add(&settings, "time={end: 1000, step: 0.05}");
    for (size_t k = 0; k < 4 && failing[_i].settings[k] != NULL; k++)
        settings_add(&settings, failing[_i].settings[k]);
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_REFERENCE);
    for (int step = 0; step < 6 && error.status == MPM_OK; step++)
        (void)mpm_simulation_advance(run.simulation, 1000.0, &error);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_int_eq(error.cause, MPM_CAUSE_TEMPERATURE);
    ck_assert_msg(strstr(error.message, failing[_i].message) != NULL, "%s", error.message);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

Suite *suite_expansion_runs(void)
{
    Suite *suite = suite_create("expansion_runs");
    TCase *waves = tcase_create("waves");
    tcase_add_loop_test(waves, the_time_step_is_that_of_waves_without_flow_of_heat, 0, 3);
    tcase_add_test(waves, a_gas_at_absolute_zero_makes_no_energy_from_nothing);
    tcase_add_loop_test(waves, kinetic_energy_from_expansion_is_no_instability, 0, 2);
    tcase_add_loop_test(waves, temperatures_without_meaning_are_refused_at_the_start, 0,
                        (int)G_N_ELEMENTS(refused));
    tcase_add_loop_test(waves, temperatures_without_meaning_end_the_run, 0,
                        (int)G_N_ELEMENTS(failing));
    suite_add_tcase(suite, waves);
    return suite;
}
