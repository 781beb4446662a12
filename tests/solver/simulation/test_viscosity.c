/* Artificial viscosity and equations of state: the pressure, its stable step, the ledger of runs,
 * runs that end at the pole, scenes that are refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/viscosity.h"
#include "mpm.h"
#include "suites.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* ----------------------------------------------------------------------- functions */

START_TEST(the_pressure_has_a_linear_and_a_quadratic_part_in_compression_alone)
{
    static const double H = 0.3, C = 7.0;
    const struct mpm_viscosity linear = {true, 0.4, 0.0}, quadratic = {true, 0.0, 1.7};
    for (double rate = -5.0; rate < 5.0; rate += 0.37) {
        const double d = fmax(-rate, 0.0);
        ck_assert_near(mpm_viscous_pressure(&linear, H, C * C, rate), H * d * 0.4 * C, 1e-14);
        ck_assert_near(mpm_viscous_pressure(&quadratic, H, C * C, rate), H * d * 1.7 * H * d,
                       1e-14);
    }
}
END_TEST

/* The highest mode of nodes at distance h, x'' = -w^2 x - nu k^2 x', w = c k, k = 2/h, with force
 * and viscosity of the step before: the largest size of the roots of
 * z^2 - (2 - d - (w dt)^2) z + (1 - d), d = nu k^2 dt. */
static double growth(double c, double nu, double h, double dt)
{
    const double k = 2.0 / h, d = nu * k * k * dt, w = c * k * dt;
    const double trace = 2.0 - d - w * w, determinant = 1.0 - d;
    const double discriminant = 0.25 * trace * trace - determinant;
    return discriminant < 0.0 ? sqrt(determinant) : fabs(0.5 * trace) + sqrt(discriminant);
}

START_TEST(the_stable_step_is_that_of_the_highest_mode)
{
    static const double H = 0.3, C = 7.0, NEAR = 1e-3;
    for (double linear = 0.0; linear < 3.0; linear += 0.4)
        for (double rate = 0.0; rate > -200.0; rate -= 31.0) {
            const struct mpm_viscosity viscosity = {true, linear, 1.5};
            const double wave = sqrt(mpm_viscous_wave_squared(&viscosity, H, C * C, rate));
            const double step = 1e-6; /* derivative of q J / rho_0 by D */
            const double nu = (mpm_viscous_pressure(&viscosity, H, C * C, rate - step) -
                               mpm_viscous_pressure(&viscosity, H, C * C, rate)) /
                              step;
            ck_assert_double_le(growth(C, nu, H, (1.0 - NEAR) * H / wave), 1.0 + 1e-12);
            ck_assert_double_gt(growth(C, nu, H, (1.0 + NEAR) * H / wave), 1.0);
        }
}
END_TEST

/* ---------------------------------------------------------------------------- runs */

#define VISCOUS ", viscosity: {linear: 0.5, quadratic: 1.5}"
static const char *const materials[] = {
    "{name: m, law: mie_gruneisen, density: 2, sound_speed: 10, hugoniot_slope: 1.5, gruneisen: "
    "2" VISCOUS "}",
    "{name: m, law: stiffened_gas, density: 2, adiabatic_index: 1.4, start_pressure: 10" VISCOUS
    "}",
    "{name: m, law: neo_hookean, density: 2, bulk: 200, shear: 50" VISCOUS "}",
    "{name: m, law: von_mises, density: 2, bulk: 200, shear: 50, yield_stress: 3" VISCOUS "}",
};
enum { MATERIALS = sizeof materials / sizeof materials[0] };
static const char *const updates[] = {"usl", "musl", "usf", "usavg"};
enum { UPDATES = sizeof updates / sizeof updates[0] };

/* Planes of symmetry: its end and its sides. */
static const char planes[] =
    "boundary=[{region: {line: {from: [0, 0], to: [0, 2]}}, symmetry: true},"
    " {region: {line: {from: [0, 0], to: [24, 0]}}, symmetry: true},"
    " {region: {line: {from: [0, 2], to: [24, 2]}}, symmetry: true}]";

/* A strip that hits the plane x = 0. */
static struct mpm_simulation *start(const char *material, const char *speed, const char *update,
                                    struct mpm_scene **scene)
{
    char *velocity = g_strdup_printf("bodies.0.velocity=[%s, 0]", speed);
    char *law = g_strdup_printf("materials=[%s]", material);
    char *order = g_strdup_printf("method.stress_update=%s", update);
    const char *const settings[] = {
        "grid={cell: [1, 1], cells: [24, 2]}",
        law,
        "bodies=[{name: b, material: m, region: {rectangle: {from: [0, 0], to: [20, 2]}}}]",
        velocity,
        planes,
        "time={end: 1, courant: 0.3}",
        "output={energy_balance: true}",
        order,
    };
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_simulation *simulation = NULL;
    ck_assert_msg(mpm_scene_read(TEST_MINIMAL_SCENE, settings, G_N_ELEMENTS(settings), scene,
                                 &error) == MPM_OK,
                  "%s", error.message);
    ck_assert_msg(mpm_simulation_create(*scene, &options, &simulation, &error) == MPM_OK, "%s",
                  error.message);
    g_free(velocity);
    g_free(law);
    g_free(order);
    return simulation;
}

/* What viscosity takes it takes for good, and the ledger has all of it. The transfer loss is that
 * of E1's orders of update: up to 2.5 % for USL. */
START_TEST(the_ledger_of_a_shock_is_balanced_and_dissipation_never_falls)
{
    static const double ROUND_OFF = 1e-11, LOSS = 0.06;
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *const simulation =
        start(materials[_i / UPDATES], "-2", updates[_i % UPDATES], &scene);
    struct mpm_ledger begin, now;
    struct mpm_error error = {.message = ""};
    double last = 0.0;
    mpm_simulation_ledger(simulation, &begin);
    now = begin;
    while (mpm_simulation_time(simulation) < 0.9) {
        ck_assert_msg(mpm_simulation_advance(simulation, 0.9, &error) == MPM_OK, "%s",
                      error.message);
        mpm_simulation_ledger(simulation, &now);
        ck_assert_double_ge(now.viscous_dissipation, last * (1.0 - ROUND_OFF));
        last = now.viscous_dissipation;
    }
    ck_assert_double_gt(last, 0.01 * begin.kinetic_energy);
    ck_assert_near(now.total_energy + now.transfer_loss, begin.total_energy,
                   ROUND_OFF * begin.total_energy);
    ck_assert_double_le(fabs(now.transfer_loss), LOSS * begin.kinetic_energy);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
}
END_TEST

/* Below zero time there was no viscosity: in tension it never acts. */
START_TEST(tension_dissipates_nothing)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *const simulation = start(materials[_i], "0.01*x", "usavg", &scene);
    struct mpm_ledger now;
    for (int k = 0; k < 3; k++)
        ck_assert_int_eq(mpm_simulation_advance(simulation, 1.0, NULL), MPM_OK);
    mpm_simulation_ledger(simulation, &now);
    ck_assert_double_le(now.viscous_dissipation, 1e-9 * now.kinetic_energy);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
}
END_TEST

#define STIFF                                                                                      \
    "{name: m, law: mie_gruneisen, density: 2, sound_speed: 10, hugoniot_slope: 6, gruneisen: 0, " \
    "viscosity: {linear: 0, quadratic: 0.1}}"

/* Advances to the end or to a failure. */
static enum mpm_status run_on(struct mpm_simulation *simulation, double *dissipated, size_t steps,
                              struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    while (status == MPM_OK && mpm_simulation_time(simulation) < 0.9) {
        struct mpm_ledger now;
        mpm_simulation_ledger(simulation, &now);
        ck_assert_uint_lt(now.step, steps);
        dissipated[now.step] = now.viscous_dissipation;
        status = mpm_simulation_advance(simulation, 0.9, error);
    }
    return status;
}

enum { STEPS = 4096 };

/* J = 1 - 1/s = 5/6, in the first step. */
START_TEST(a_run_ends_at_the_pole_with_the_particle_and_its_volume)
{
    static double dissipated[STEPS];
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *const simulation = start(STIFF, "-40", "musl", &scene);
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(run_on(simulation, dissipated, STEPS, &error), MPM_RUN_FAILED);
    ck_assert_int_eq(error.cause, MPM_CAUSE_STATE);
    ck_assert_msg(strstr(error.message, "allowed by its equation of state: above 0.833") != NULL,
                  "%s", error.message);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
}
END_TEST

/* A body that rebounds and leaves the grid: steps are repeated from the last good state. */
START_TEST(steps_that_are_repeated_dissipate_once)
{
    static double dissipated[STEPS];
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *const simulation = start(STIFF, "-1*x", "musl", &scene);
    struct mpm_error error = {.message = ""};
    struct mpm_ledger now;
    ck_assert_int_eq(run_on(simulation, dissipated, STEPS, &error), MPM_RUN_FAILED);
    ck_assert_int_eq(error.cause, MPM_CAUSE_LEFT_GRID);
    mpm_simulation_ledger(simulation, &now);
    ck_assert_double_gt(now.viscous_dissipation, 0.0);
    ck_assert_double_eq(now.viscous_dissipation, dissipated[now.step]);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
}
END_TEST

/* ------------------------------------------------------------------------- scenes */

#define MIE                                                                                        \
    "name: m, law: mie_gruneisen, density: 2, sound_speed: 10, hugoniot_slope: 2, gruneisen: 1"
#define GAS "name: m, law: stiffened_gas, density: 2, adiabatic_index: 1.4"
static const char *const refused[][3] = {
    {"{" MIE ", specific_heat: 1}", "title=x",
     "materials.0: temperature requires specific_heat and start_temperature; allowed: both or"},
    {"{" GAS ", start_pressure: 0}", "title=x",
     "materials.0: without start_pressure and stiffening_pressure sound has no speed"},
    {"{" GAS "}", "title=x", "the law stiffened_gas requires start_pressure, which is missing"},
    {"{" MIE "}", "geometry=plane_stress", "the law mie_gruneisen has no plane stress"},
    {"{" MIE ", heat_capacity: 1, conductivity: 1}", "transport={temperature: {start: 1}}",
     "materials.0.law: got mie_gruneisen, whose equation of state keeps its own heat, in a scene"},
    {"{name: m, law: neo_hookean, density: 2, bulk: 200, shear: 50" VISCOUS "}",
     "geometry=plane_stress", "materials.0.viscosity: given in plane stress"},
    {"{name: m, law: neo_hookean, density: 2, bulk: 200, shear: 50, heat_capacity: 1, "
     "conductivity: 1, thermal_expansion: 1e-3, stress_free_temperature: 1" VISCOUS "}",
     "transport={temperature: {start: 1, heating: true}}",
     "materials.0.viscosity: given in a scene with transport.temperature.heating"},
    {"{name: m, law: ideal_gas, density: 2, gas_constant: 1, heat_capacity: 1, conductivity: "
     "1" VISCOUS "}",
     "transport={temperature: {start: 1}}",
     "materials.0.viscosity: given for the law ideal_gas, which cannot take its heat"},
    {"{" MIE ", viscosity: {linear: 1}}", "title=x", "quadratic"},
    {"{" MIE ", viscosity: {linear: -1, quadratic: 1}}", "title=x", "linear: out of range"},
};

START_TEST(what_has_no_meaning_is_refused)
{
    char *law = g_strdup_printf("materials=[%s]", refused[_i][0]);
    const char *const settings[] = {law, "bodies.0.material=m", refused[_i][1]};
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_read(TEST_MINIMAL_SCENE, settings, 3, &scene, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, refused[_i][2]) != NULL, "%s", error.message);
    g_free(law);
}
END_TEST

/* --------------------------------------------------------------------------- suite */

Suite *suite_viscosity(void)
{
    Suite *suite = suite_create("viscosity");
    TCase *tests = tcase_create("functions");
    tcase_add_test(tests, the_pressure_has_a_linear_and_a_quadratic_part_in_compression_alone);
    tcase_add_test(tests, the_stable_step_is_that_of_the_highest_mode);
    suite_add_tcase(suite, tests);
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, the_ledger_of_a_shock_is_balanced_and_dissipation_never_falls, 0,
                        MATERIALS * UPDATES);
    tcase_add_loop_test(runs, tension_dissipates_nothing, 0, MATERIALS);
    tcase_add_test(runs, a_run_ends_at_the_pole_with_the_particle_and_its_volume);
    tcase_add_test(runs, steps_that_are_repeated_dissipate_once);
    suite_add_tcase(suite, runs);
    TCase *scenes = tcase_create("scenes");
    tcase_add_loop_test(scenes, what_has_no_meaning_is_refused, 0, G_N_ELEMENTS(refused));
    suite_add_tcase(suite, scenes);
    return suite;
}
