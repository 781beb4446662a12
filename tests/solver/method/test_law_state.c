/* Laws with state variables, and laws without an energy: artificial ones in the place of a scene's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/transfer_block.h"

#include "method/fast/fast.h"
#include "method/fast/fast_laws.h"
#include "method/transfer/law_state.h"
#include "simulation/simulation.h"

#include <float.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

static const char BLOCK[] = TEST_RUBBER_BLOCK("[8, 7.2]");

/* ----------------------------------------------------------------- the laws */

/* Neo-Hookean, and a pressure that relaxes: M (J - 1 - q) with dq/dt = (J - 1 - q) / theta by the
 * backward Euler rule. */
static const double M = 60.0, THETA = 0.11, START = 0.02;

static double relaxing_energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                              const double *state)
{
    const double stretch = mpm_determinant(f) - 1.0 - state[0];
    return mpm_neo_hookean.energy(m, f, NULL) + 0.5 * M * stretch * stretch;
}

static bool relaxing_update(const struct mpm_material *m, const struct mpm_law_step *step,
                            double *state, double stress[MPM_SYMMETRIC_SIZE],
                            double *wave_speed_squared)
{
    const double j = mpm_determinant(step->f), ratio = step->duration / THETA;
    mpm_neo_hookean.stress(m, step->f, stress, wave_speed_squared);
    state[0] = (state[0] + ratio * (j - 1.0)) / (1.0 + ratio);
    for (int k = MPM_SYM_XX; k <= MPM_SYM_ZZ; k++)
        stress[k] += M * j * (j - 1.0 - state[0]);
    *wave_speed_squared += M * j * j;
    return true;
}

static const struct mpm_law_variable relaxed[] = {
    {"relaxed", MPM_DIMENSION_NONE, 0.02, "relaxed part of J - 1"}};
static const struct mpm_material_law relaxing = {
    .name = "relaxing",
    .description = "a pressure that relaxes",
    .variables = relaxed,
    .variable_count = 1,
    .update = relaxing_update,
    .energy = relaxing_energy,
};

/* With a viscous pressure, which no state variable knows; the work of the stress takes the place of
 * the energy. */
static bool viscous_update(const struct mpm_material *m, const struct mpm_law_step *step,
                           double *state, double stress[MPM_SYMMETRIC_SIZE],
                           double *wave_speed_squared)
{
    const double change = mpm_determinant(step->f) - mpm_determinant(step->old_f);
    relaxing_update(m, step, state, stress, wave_speed_squared);
    for (int k = MPM_SYM_XX; k <= MPM_SYM_ZZ && step->duration > 0.0; k++)
        stress[k] += 0.05 * change / step->duration;
    return true;
}

static const struct mpm_material_law viscous = {
    .name = "viscous",
    .description = "a pressure that relaxes, and one that follows the rate",
    .variables = relaxed,
    .variable_count = 1,
    .update = viscous_update,
};

static struct mpm_material_law without_energy(void)
{
    struct mpm_material_law law = mpm_neo_hookean;
    law.energy = NULL;
    law.energy_bound = NULL;
    return law;
}

/* ------------------------------------------------------------------- helpers */

static struct test_run open_with(const struct mpm_material_law *law, struct settings *settings)
{
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings->texts, 1);
    settings_clear(settings);
    mpm_simulation_free(run.simulation);
    run.scene->materials[0].law = law;
    const struct mpm_simulation_options options = {.threads = 1};
    const enum mpm_status status =
        mpm_simulation_create(run.scene, &options, &run.simulation, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return run;
}

#define TWO_SCENE_HEAD                                                                             \
    "format: 1\ngeometry: plane_strain\n"                                                          \
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [14, 12]}\n"                                    \
    "time: {end: 1000, step: 0.02}\nmaterials: ["
#define TWO_SCENE_MIDDLE "]\nbodies:\n"

/* A scene of two materials with those laws. */
static struct test_run open_two(const char *text, const struct mpm_material_law *const laws[2])
{
    struct mpm_error error = {0};
    struct test_run run = test_run_open(text, NULL, 1);
    mpm_simulation_free(run.simulation);
    for (int k = 0; k < 2; k++)
        run.scene->materials[k].law = laws[k];
    const struct mpm_simulation_options options = {.threads = 1};
    const enum mpm_status status =
        mpm_simulation_create(run.scene, &options, &run.simulation, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return run;
}

/* Of plane strain and axisymmetry, as the law of the path here has no plane stress. */
static bool combination_settings(int index, struct settings *settings)
{
    *settings = test_combination_settings(index);
    if (strcmp(test_combination(index).geometry, "plane_stress") != 0)
        return true;
    settings_clear(settings);
    return false;
}

static const struct mpm_particles *particles_of(const struct test_run *run)
{
    return &run->simulation->state.particles;
}

static void deformation_of(const struct test_run *run, size_t p, double f[MPM_GRADIENT_SIZE])
{
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = particles_of(run)->deformation[k][p];
}

/* Where the particle with that id is. */
static size_t place_of(const struct test_run *run, uint32_t id)
{
    size_t p = 0;
    while (particles_of(run)->id[p] != id)
        p++;
    return p;
}

/* Without a step the law gives the stress of F and the state: that is what the particle has. */
static void assert_stress_is_of_the_state(const struct test_run *run)
{
    const struct mpm_particles *const particles = particles_of(run);
    for (size_t p = 0; p < particles->count; p++) {
        double f[MPM_GRADIENT_SIZE], stress[MPM_SYMMETRIC_SIZE], unused;
        double state = *mpm_particle_law_state(particles, p, 0);
        deformation_of(run, p, f);
        const struct mpm_law_step none = {f, f, 0.0, (double)NAN, (double)NAN, 0.0, (double)NAN};
        relaxing_update(&run->simulation->state.bodies[0].material, &none, &state, stress, &unused);
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
            ck_assert_double_eq(particles->stress[k][p], stress[k]);
    }
}

/* --------------------------------------------------------------------- tests */

START_TEST(state_variables_stay_with_their_particles)
{
    enum { STEPS = 70 }; /* particles are sorted every 32 */
    struct settings settings;
    if (!combination_settings(_i, &settings))
        return;
    test_add_wild_velocity(&settings, test_combination(_i).axisymmetric);
    struct test_run run = open_with(&relaxing, &settings);
    const struct mpm_particles *const particles = particles_of(&run);
    for (size_t p = 0; p < particles->count; p++)
        ck_assert_double_eq(*mpm_particle_law_state(particles, p, 0), START);
    test_run_steps(&run, STEPS);
    assert_stress_is_of_the_state(&run);
    double sum = 0.0, low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t p = 0; p < particles->count; p++) {
        double f[MPM_GRADIENT_SIZE];
        deformation_of(&run, p, f);
        sum += particles->mass[p] * relaxing_energy(&run.simulation->state.bodies[0].material, f,
                                                    mpm_particle_law_state(particles, p, 0));
        low = fmin(low, *mpm_particle_law_state(particles, p, 0));
        high = fmax(high, *mpm_particle_law_state(particles, p, 0));
    }
    ck_assert_double_gt(high - low, 1e-3); /* or a wrong order would not be seen */
    const double round_off = 1e-13 * sum;
    ck_assert_near(test_run_ledger(&run).strain_energy, sum, round_off);
    test_run_close(&run);
}
END_TEST

/* All nodes are held, so that J is known: dq/dt = (J - 1 - q) / theta, whatever the parts that the
 * order of the stress update divides a step into. The rule is of first order in the step. */
START_TEST(a_state_variable_follows_its_equation_in_time)
{
    enum { STEPS = 40 };
    static const double STEP = 0.004;
    struct settings settings;
    if (!combination_settings(_i, &settings))
        return;
    const bool axisymmetric = test_combination(_i).axisymmetric;
    settings_add(&settings, axisymmetric
                                ? "boundary=[{region: all, velocity: ['0.3*r', '0.1*z']}]"
                                : "boundary=[{region: all, velocity: ['0.5*x', '0.1*y']}]");
    settings_add(&settings, axisymmetric ? "bodies.block.velocity=['0.3*r', '0.1*z']"
                                         : "bodies.block.velocity=['0.5*x', '0.1*y']");
    settings_add_formatted(&settings, "time={end: 1000, step: %g}", STEP);
    struct test_run run = open_with(&relaxing, &settings);
    double expected = START, j = 1.0;
    for (int k = 0; k < STEPS; k++) {
        double f[MPM_GRADIENT_SIZE];
        test_run_steps(&run, 1);
        deformation_of(&run, 0, f);
        const double mean = 0.5 * (j + mpm_determinant(f)) - 1.0, decay = exp(-STEP / THETA);
        expected = mean + (expected - mean) * decay;
        j = mpm_determinant(f);
    }
    const double rate = (START + 0.13) / THETA; /* not below |dq/dt| */
    ck_assert_double_gt(fabs(expected - START), 0.01);
    ck_assert_near(*mpm_particle_law_state(particles_of(&run), 0, 0), expected, 0.5 * STEP * rate);
    test_run_close(&run);
}
END_TEST

START_TEST(the_last_good_state_has_state_variables_and_stress_to_the_bit)
{
    enum { STEPS = 45, BACK = 41 }; /* saved at the sort at 32 */
    struct settings settings;
    if (!combination_settings(_i, &settings))
        return;
    const bool axisymmetric = test_combination(_i).axisymmetric;
    struct settings same = test_combination_settings(_i);
    test_add_wild_velocity(&settings, axisymmetric);
    test_add_wild_velocity(&same, axisymmetric);
    struct test_run run = open_with(&viscous, &settings);
    struct test_run good = open_with(&viscous, &same);
    test_run_steps(&run, STEPS);
    test_run_steps(&good, BACK);
    mpm_backup_restore(run.simulation, BACK);
    ck_assert(test_run_same_bits(&run, &good));
    for (size_t p = 0; p < particles_of(&run)->count; p++)
        for (size_t k = 0; k < 2; k++)
            ck_assert_double_eq(*mpm_particle_law_state(particles_of(&run), p, k),
                                *mpm_particle_law_state(particles_of(&good), p, k));
    test_run_close(&run);
    test_run_close(&good);
}
END_TEST

/* Of the same motion, as the energy has no part in it. */
static double work_less_energy(int combination, double step, int steps)
{
    const struct mpm_material_law law = without_energy();
    struct settings settings = test_combination_settings(combination);
    test_add_wild_velocity(&settings, test_combination(combination).axisymmetric);
    settings_add_formatted(&settings, "time={end: 1000, step: %g}", step);
    struct test_run run = open_with(&law, &settings);
    test_run_steps(&run, steps);
    double energy = 0.0;
    for (size_t p = 0; p < particles_of(&run)->count; p++) {
        double f[MPM_GRADIENT_SIZE];
        deformation_of(&run, p, f);
        energy += particles_of(&run)->mass[p] *
                  mpm_neo_hookean.energy(&run.simulation->state.bodies[0].material, f, NULL);
    }
    const double work = test_run_ledger(&run).strain_energy;
    ck_assert_double_gt(energy, 0.1);
    test_run_close(&run);
    return fabs(work / energy - 1.0);
}

/* Of a hyperelastic law the work is the energy, up to the trapezoidal rule's error: it is of second
 * order in the step, so that half the step leaves a quarter. */
START_TEST(without_an_energy_the_work_of_the_stress_takes_its_place)
{
    const double whole = work_less_energy(_i, 0.004, 40);
    const double half = work_less_energy(_i, 0.002, 80);
    ck_assert_double_lt(whole, 2e-3);
    ck_assert_double_lt(half, 0.3 * whole);
}
END_TEST

/* The start is a state, not a step: nothing has relaxed yet. */
START_TEST(a_given_start_has_the_stress_of_the_state_at_the_start)
{
    struct mpm_error error = {0};
    struct settings settings = test_combination_settings(0);
    struct test_run run = open_with(&relaxing, &settings);
    const size_t count = particles_of(&run)->count;
    double *const f = calloc(count * MPM_GRADIENT_SIZE, sizeof *f);
    ck_assert_ptr_nonnull(f);
    for (size_t p = 0; p < count; p++)
        memcpy(f + MPM_GRADIENT_SIZE * p, (const double[]){1.1, 0.02, 0.0, 1.05, 1.0},
               MPM_GRADIENT_SIZE * sizeof *f);
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, f, &error), MPM_OK);
    for (size_t p = 0; p < count; p++)
        ck_assert_double_eq(*mpm_particle_law_state(particles_of(&run), p, 0), START);
    assert_stress_is_of_the_state(&run);
    free(f);
    test_run_close(&run);
}
END_TEST

/* Its energy would be unknown. Undeformed, it may have velocities. */
START_TEST(without_an_energy_no_deformed_start_is_accepted)
{
    static const double deformed[] = {1.1, 0.02, 0.0, 1.05, 1.0}, none[] = {1, 0, 0, 1, 1};
    struct mpm_error error = {0};
    struct settings settings = test_combination_settings(0);
    struct test_run run = open_with(&viscous, &settings);
    const size_t count = particles_of(&run)->count;
    double *const f = calloc(count * MPM_GRADIENT_SIZE, sizeof *f);
    ck_assert_ptr_nonnull(f);
    for (size_t p = 0; p < count; p++)
        memcpy(f + MPM_GRADIENT_SIZE * p, none, sizeof none);
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, f, &error), MPM_OK);
    memcpy(f, deformed, sizeof deformed);
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, f, &error), MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "without a strain energy"));
    free(f);
    test_run_close(&run);
}
END_TEST

/* One with a state variable and an energy, one with the work of its stress alone: each carries its
 * own, and moves as it does alone. The bodies are apart. */
START_TEST(bodies_with_different_laws_have_state_variables_of_their_own)
{
    enum { STEPS = 50 };
    static const char ONE[] = "  - {name: one, material: rubber, velocity: ['0.1*(x-4)', 0], "
                              "region: {rectangle: {from: [3, 3.2], to: [5, 5.6]}}}\n";
    static const char OTHER[] = "  - {name: other, material: hard, velocity: [0, '0.1*(y-4)'], "
                                "region: {rectangle: {from: [8, 3.2], to: [10, 5.6]}}}\n";
    static const char MATERIALS[] =
        "{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}, "
        "{name: hard, law: neo_hookean, density: 2, bulk: 80, shear: 48}";
    const struct mpm_material_law law = without_energy();
    const struct mpm_material_law *const laws[] = {&relaxing, &law};
    const char *const bodies[] = {ONE, OTHER};
    char *const both = g_strconcat(TWO_SCENE_HEAD, MATERIALS, TWO_SCENE_MIDDLE, ONE, OTHER, NULL);
    struct test_run together = open_two(both, laws);
    test_run_steps(&together, STEPS);
    size_t first = 0;
    for (int k = 0; k < 2; k++) {
        char *const single =
            g_strconcat(TWO_SCENE_HEAD, MATERIALS, TWO_SCENE_MIDDLE, bodies[k], NULL);
        struct test_run alone = open_two(single, laws);
        test_run_steps(&alone, STEPS);
        for (size_t p = 0; p < particles_of(&alone)->count; p++) {
            const size_t own = place_of(&alone, (uint32_t)p);
            const size_t there = place_of(&together, (uint32_t)(first + p));
            ck_assert_double_ne(*mpm_particle_law_state(particles_of(&alone), own, 0), 0.0);
            ck_assert_double_eq(*mpm_particle_law_state(particles_of(&together), there, 0),
                                *mpm_particle_law_state(particles_of(&alone), own, 0));
        }
        first += particles_of(&alone)->count;
        test_run_close(&alone);
        g_free(single);
    }
    test_run_close(&together);
    g_free(both);
}
END_TEST

/* In the undeformed body: K + 4 G / 3 + M, over the density 1. */
START_TEST(the_wave_speed_at_the_start_is_that_of_the_law)
{
    struct settings settings = test_combination_settings(0);
    struct test_run run = open_with(&relaxing, &settings);
    const double round_off = 16.0 * DBL_EPSILON;
    ck_assert_near(run.simulation->wave_speed_start, sqrt(80.0 + 4.0 / 3.0 * 48.0 + M),
                   12.0 * round_off);
    test_run_close(&run);
}
END_TEST

START_TEST(a_law_without_equations_on_vectors_is_taken_particle_by_particle)
{
    struct settings settings = test_combination_settings(0);
    struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    settings_clear(&settings);
    struct mpm_material_spec *const material = &run.scene->materials[0];
    ck_assert(mpm_fast_body_has_vectors(material));
    material->viscosity.given = true;
    ck_assert(!mpm_fast_body_has_vectors(material));
    material->viscosity.given = false;
    material->law = &relaxing;
    ck_assert(!mpm_fast_body_has_vectors(material));
    ck_assert_ptr_null(mpm_fast_lacks(run.scene));
    test_run_close(&run);
}
END_TEST

START_TEST(no_law_has_more_state_variables_than_there_is_room_for)
{
    const struct mpm_material_law *law;
    for (size_t k = 0; (law = mpm_material_law_at(k)) != NULL; k++)
        ck_assert_uint_le(mpm_law_state_count(law), MPM_LAW_STATES);
}
END_TEST

Suite *suite_law_state(void)
{
    Suite *const suite = suite_create("law_state");
    TCase *const tests = tcase_create("law_state");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, state_variables_stay_with_their_particles, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(tests, a_state_variable_follows_its_equation_in_time, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(tests, the_last_good_state_has_state_variables_and_stress_to_the_bit, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(tests, without_an_energy_the_work_of_the_stress_takes_its_place, 0,
                        TEST_COMBINATIONS);
    tcase_add_test(tests, a_given_start_has_the_stress_of_the_state_at_the_start);
    tcase_add_test(tests, the_wave_speed_at_the_start_is_that_of_the_law);
    tcase_add_test(tests, without_an_energy_no_deformed_start_is_accepted);
    tcase_add_test(tests, bodies_with_different_laws_have_state_variables_of_their_own);
    tcase_add_test(tests, no_law_has_more_state_variables_than_there_is_room_for);
    tcase_add_test(tests, a_law_without_equations_on_vectors_is_taken_particle_by_particle);
    suite_add_tcase(suite, tests);
    return suite;
}
