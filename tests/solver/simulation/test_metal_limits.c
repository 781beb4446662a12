/* Where runs of metals end, and what they report: the pole of the equation of state, no way back to
 * yield, no temperature, and particles that melt.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/scenes.h"

#include <glib.h>
#include <string.h>

#define PRESSURE  ", sound_speed: 10, hugoniot_slope: 1.5, gruneisen: 2"
#define VON_MISES "bulk: 200, shear: 50, yield_stress: 1"
#define SOFTENING                                                                                  \
    "shear: 50, yield_stress: 1, softening_exponent: 1, reference_temperature: 1, "                \
    "melting_temperature: 1000, taylor_quinney: 1"
#define INWARDS    "['-x', '-y']"
#define OUTWARDS   "['20*x', '20*y']"
#define HUGE_SHEAR "['1e160*(y - 0.5)', 0]" /* 0 at the one particle of ALONE */
#define ALONE      "bodies.b.region={rectangle: {from: [0, 0], to: [1, 1]}}"
#define IN_STEPS   "time={end: 1, courant: 0.3}"
#define AT_ONCE    "time={end: 10, step: 1, allow_unstable: true}"

/* A block whose nodes all have the given velocity, without end. */
static struct test_run open_with(const char *material, const char *velocity, const char *time)
{
    static const char SCENE[] =
        "format: 1\ngeometry: plane_strain\n"
        "grid: {origin: [-6, -6], cell: [1, 1], cells: [12, 12]}\n"
        "time: {end: 1, courant: 0.3}\n"
        "method: {shape: ugimp, stress_update: usl}\n"
        "materials: [{name: m, law: none, density: 1}]\n"
        "bodies:\n"
        "  - {name: b, material: m, region: {rectangle: {from: [-1, -1], to: [2, 2]}},\n"
        "     particles_per_cell: [1, 1]}\n";
    char *const law = g_strdup_printf("materials=[{name: m, density: 2, %s}]", material);
    char *const start = g_strdup_printf("bodies.b.velocity=%s", velocity);
    char *const all = g_strdup_printf("boundary=[{region: all, velocity: %s}]", velocity);
    const char *const settings[] = {
        law, start, all, time, strcmp(time, AT_ONCE) == 0 ? ALONE : NULL, NULL};
    struct test_run run = test_run_open(SCENE, settings, 1);
    g_free(law);
    g_free(start);
    g_free(all);
    return run;
}

static const struct limit {
    const char *material, *velocity, *time;
    enum mpm_cause cause;
    const char *says[2];
} limits[] = {
    {"law: mie_gruneisen" PRESSURE,
     INWARDS,
     IN_STEPS,
     MPM_CAUSE_STATE,
     {"(body 'b') has J = 0.33", "the pole of its equation of state at J = 0.333333"}},
    {"law: von_mises_gruneisen, shear: 50, yield_stress: 1" PRESSURE,
     INWARDS,
     IN_STEPS,
     MPM_CAUSE_STATE,
     {"(body 'b') has J = 0.33", "the pole of its equation of state at J = 0.333"}},
    {"law: von_mises, " VON_MISES,
     HUGE_SHEAR,
     AT_ONCE,
     MPM_CAUSE_PLASTIC,
     {"(body 'b') has a component of F of size 1e+160", "no number"}},
    {"law: von_mises, kinematic_modulus: 5, " VON_MISES,
     HUGE_SHEAR,
     AT_ONCE,
     MPM_CAUSE_PLASTIC,
     {"(body 'b') has a component of F of size 1e+160", "no number"}},
    {"law: johnson_cook, " VON_MISES,
     HUGE_SHEAR,
     AT_ONCE,
     MPM_CAUSE_PLASTIC,
     {"(body 'b') has a component of F of size 1e+160", "no number"}},
    {"law: von_mises_gruneisen, shear: 50, yield_stress: 1" PRESSURE,
     HUGE_SHEAR,
     AT_ONCE,
     MPM_CAUSE_PLASTIC,
     {"(body 'b') has a component of F of size 1e+160", "no number"}},
    {"law: johnson_cook_gruneisen, " SOFTENING
     ", start_temperature: 1, specific_heat: 1e-4" PRESSURE,
     OUTWARDS,
     IN_STEPS,
     MPM_CAUSE_TEMPERATURE,
     {"(body 'b') is at a temperature of -", "allowed: absolute, at least 0"}},
};
enum { LIMITS = sizeof limits / sizeof limits[0] };

START_TEST(a_run_ends_at_a_limit_with_the_particle_and_the_value)
{
    const struct limit *const limit = &limits[_i];
    struct test_run run = open_with(limit->material, limit->velocity, limit->time);
    struct mpm_error error = {.message = ""};
    enum mpm_status status = MPM_OK;
    for (int k = 0; k < 20000 && status == MPM_OK; k++)
        status = mpm_simulation_advance(run.simulation, 10.0, &error);
    ck_assert_int_eq(status, MPM_RUN_FAILED);
    ck_assert_msg(error.cause == limit->cause, "%s", error.message);
    for (int k = 0; k < 2; k++)
        ck_assert_msg(strstr(error.message, limit->says[k]) != NULL, "%s", error.message);
    ck_assert_msg(strstr(error.message, "nan") == NULL, "%s", error.message);
    test_run_close(&run);
}
END_TEST

/* By plastic work, the part that is sheared most: at rates at which a step alone heats by more than
 * is left up to melting. */
START_TEST(melted_particles_are_those_at_their_melting_temperature_or_above)
{
    static const double MELTING = 20.0;
    struct test_run run =
        open_with("law: johnson_cook, bulk: 200, shear: 50, yield_stress: 1, "
                  "softening_exponent: 1, reference_temperature: 1, melting_temperature: 20, "
                  "taylor_quinney: 1, start_temperature: 10, specific_heat: 0.002",
                  "['2*y*abs(y)', 0]", IN_STEPS);
    size_t count, by_hand = 0;
    ck_assert(mpm_scene_melts(run.scene));
    ck_assert_uint_eq(test_run_ledger(&run).melted_particles, 0);
    while (mpm_simulation_time(run.simulation) < 0.8)
        test_run_steps(&run, 1);
    double *const temperature = test_run_field(&run, MPM_FIELD_STATE_TEMPERATURE, &count);
    for (size_t p = 0; p < count; p++)
        by_hand += temperature[p] >= MELTING;
    g_free(temperature);
    ck_assert_uint_gt(by_hand, 0);
    ck_assert_uint_lt(by_hand, count);
    ck_assert_uint_eq(test_run_ledger(&run).melted_particles, by_hand);
    test_run_close(&run);
}
END_TEST

START_TEST(scenes_without_a_melting_temperature_have_no_melted_particles)
{
    struct test_run run = open_with("law: von_mises, " VON_MISES, INWARDS, IN_STEPS);
    ck_assert(!mpm_scene_melts(run.scene));
    ck_assert_uint_eq(test_run_ledger(&run).melted_particles, 0);
    test_run_close(&run);
}
END_TEST

Suite *suite_metal_limits(void)
{
    Suite *const suite = suite_create("metal_limits");
    TCase *const tests = tcase_create("runs");
    tcase_add_loop_test(tests, a_run_ends_at_a_limit_with_the_particle_and_the_value, 0, LIMITS);
    tcase_add_test(tests, melted_particles_are_those_at_their_melting_temperature_or_above);
    tcase_add_test(tests, scenes_without_a_melting_temperature_have_no_melted_particles);
    suite_add_tcase(suite, tests);
    return suite;
}
