/* A body force that a caller gives for each particle and step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/kernel_pair.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/soft_block.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

static const char BLOCK[] = TEST_SOFT_BLOCK(TEST_WALL) TEST_SWINGING_FLOOR;

/* --------------------------------------------------------------- body force */

static void uniform_force(void *context, double time, size_t count, const uint32_t id[],
                          double *const force[AXES])
{
    (void)context;
    (void)id;
    ck_assert(count > 0 && count <= MPM_BODY_FORCE_BLOCK);
    for (size_t k = 0; k < count; k++) {
        force[0][k] = 0.03 * cos(3.0 * time);
        force[1][k] = -0.08;
    }
}
static const struct mpm_body_force UNIFORM = {uniform_force, NULL};
static const char UNIFORM_SETTING[] = "loads={body_force: ['0.03*cos(3*t)', -0.08]}";

/* Besides families, geometries and orders: exchanges, and PIC damping. */
static const char *exchange_of(int index)
{
    return index < TEST_EXCHANGES ? test_exchanges[index] : "damping={pic: 0.9}";
}
enum {
    EXCHANGES = TEST_EXCHANGES + 1,
    KERNEL_SETS = 2,
};

/* The scene with its own force, and without one, but the caller's. `settings` end with NULL and
 * have room for one more. */
static struct kernel_pair open_pair(const char *settings[], enum mpm_kernels kernels)
{
    const struct mpm_simulation_options options = {.threads = 1, .kernels = kernels};
    const char *own[8] = {UNIFORM_SETTING};
    for (size_t k = 0; settings[k] != NULL; k++)
        own[k + 1] = settings[k];
    const struct kernel_side sides[2] = {{own, options}, {settings, options}};
    struct mpm_error error = {.message = ""};
    const struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    ck_assert_msg(mpm_simulation_set_body_force(pair.simulation[1], &UNIFORM, &error) == MPM_OK,
                  "%s", error.message);
    return pair;
}

START_TEST(a_uniform_force_is_the_same_from_the_scene_and_from_the_caller)
{
    struct settings settings = test_combination_settings(_i);
    struct kernel_pair pair = open_pair(
        settings.texts, _i < TEST_COMBINATIONS ? MPM_KERNELS_REFERENCE : MPM_KERNELS_FAST);
    test_soft_block_assert_alike(&pair,
                                 test_combination(_i).amplifies_round_off ? 10 : KERNEL_PAIR_STEPS);
    settings_clear(&settings);
}
END_TEST

START_TEST(a_callers_force_is_added_in_every_exchange_and_under_damping)
{
    const char *settings[] = {exchange_of(_i), "method.shape=bspline2", NULL};
    struct kernel_pair pair = open_pair(settings, MPM_KERNELS_AUTO);
    test_soft_block_assert_alike(&pair, 20);
}
END_TEST

/* A force that no other particle has. */
static void own_force(void *context, double time, size_t count, const uint32_t id[],
                      double *const force[AXES])
{
    (void)context;
    for (size_t k = 0; k < count; k++) {
        force[0][k] = 1e-3 * id[k];
        force[1][k] = 0.01 * sin(id[k]) - 1e-3 * time;
    }
}
static const struct mpm_body_force OWN = {own_force, NULL};

/* Also where the scene has a force of its own, at nodes or at particles. */
START_TEST(a_free_block_gains_the_momentum_that_its_particles_are_given)
{
    static const char *const loads[] = {"loads={body_force: [0, 0]}",
                                        "loads={body_force: [0.01, '0*t']}",
                                        "loads={body_force: [0.01, '0*x']}"};
    const char *const settings[] = {"boundary=[]", loads[_i], NULL};
    const double own[3] = {0.0, 0.01, 0.01};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    ck_assert_int_eq(mpm_simulation_set_body_force(run.simulation, &OWN, NULL), MPM_OK);
    test_run_steps(&run, 1);
    size_t count;
    double *const mass = test_run_field(&run, MPM_FIELD_MASS, &count);
    double expected[AXES] = {0.0, 0.0};
    for (size_t k = 0; k < count; k++) {
        const uint32_t id = (uint32_t)k;
        double b[AXES], *const block[AXES] = {&b[0], &b[1]};
        own_force(NULL, 0.0, 1, &id, block);
        expected[0] += mass[k] * (b[0] + own[_i]);
        expected[1] += mass[k] * b[1];
    }
    const struct mpm_ledger ledger = test_run_ledger(&run);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(ledger.momentum[axis], expected[axis] * ledger.time, TEST_SOFT_ROUND_OFF);
    /* from rest, in one step: force . v dt/2 = (force dt)^2 / 2 m of the nodes, not less than what
     * particles get of it */
    ck_assert(ledger.external_work >= ledger.kinetic_energy * (1.0 - TEST_SOFT_ROUND_OFF));
    free(mass);
    test_run_close(&run);
}
END_TEST

static void give_own_force(struct test_run *run)
{
    ck_assert_int_eq(mpm_simulation_set_body_force(run->simulation, &OWN, NULL), MPM_OK);
}

START_TEST(any_number_of_threads_gives_the_same_bits_under_a_callers_force)
{
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS,
        _i == 0 ? "method.stress_update=usl" : "method.stress_update=usavg",
        _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi",
        NULL,
    };
    test_same_bits_over_threads(BLOCK, settings, 20, give_own_force);
}
END_TEST

START_TEST(a_force_that_was_taken_away_leaves_no_trace)
{
    struct test_run runs[2];
    double *values[2];
    size_t count;
    for (int k = 0; k < 2; k++) {
        runs[k] = test_run_open(BLOCK, NULL, 1);
        const size_t bytes = mpm_simulation_bytes(runs[k].simulation);
        if (k == 1) {
            ck_assert_int_eq(mpm_simulation_set_body_force(runs[k].simulation, &OWN, NULL), MPM_OK);
            ck_assert_uint_gt(mpm_simulation_bytes(runs[k].simulation), bytes);
            ck_assert_int_eq(mpm_simulation_set_body_force(runs[k].simulation, NULL, NULL), MPM_OK);
        }
        ck_assert_uint_eq(mpm_simulation_bytes(runs[k].simulation), bytes);
        test_run_steps(&runs[k], 5);
        values[k] = test_run_field(&runs[k], MPM_FIELD_VELOCITY, &count);
    }
    ck_assert_int_eq(memcmp(values[0], values[1], AXES * count * sizeof **values), 0);
    for (int k = 0; k < 2; k++) {
        free(values[k]);
        test_run_close(&runs[k]);
    }
}
END_TEST

/* *context is the time from which on one particle's force is not a number. */
static void spoilt_force(void *context, double time, size_t count, const uint32_t id[],
                         double *const force[AXES])
{
    const double *const spoilt = context;
    uniform_force(NULL, time, count, id, force);
    for (size_t k = 0; k < count; k++)
        if (id[k] == 17 && time >= *spoilt)
            force[1][k] = (double)NAN;
}

START_TEST(a_force_that_is_not_finite_fails_the_run_and_names_the_particle)
{
    struct test_run run = test_run_open(BLOCK, NULL, 1);
    struct mpm_error error = {.message = ""};
    double spoilt = 2.0;
    const struct mpm_body_force force = {spoilt_force, &spoilt};
    ck_assert_int_eq(mpm_simulation_set_body_force(run.simulation, &force, &error), MPM_OK);
    enum mpm_status status = MPM_OK;
    double *before = NULL, time = 0.0;
    size_t count;
    while (status == MPM_OK) {
        free(before);
        before = test_run_field(&run, MPM_FIELD_VELOCITY, &count);
        time = mpm_simulation_time(run.simulation);
        status = mpm_simulation_advance(run.simulation, 10.0, &error);
    }
    ck_assert_int_eq(status, MPM_RUN_FAILED);
    ck_assert_msg(strstr(error.message, "particle 17 (body 'block')") != NULL &&
                      strstr(error.message, "body force that is not finite: nan along y") != NULL,
                  "%s", error.message);
    double *const after = test_run_field(&run, MPM_FIELD_VELOCITY, &count);
    ck_assert(time > 1.5 && mpm_simulation_time(run.simulation) == time);
    ck_assert_int_eq(memcmp(before, after, AXES * count * sizeof *after), 0);
    free(before);
    free(after);
    test_run_close(&run);
}
END_TEST

START_TEST(a_force_without_a_function_or_set_too_late_is_refused)
{
    static const struct mpm_body_force nothing = {NULL, NULL};
    struct test_run run = test_run_open(BLOCK, NULL, 1);
    struct mpm_error error;
    ck_assert_int_eq(mpm_simulation_set_body_force(run.simulation, &nothing, &error),
                     MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "body force: evaluate is NULL; allowed: a function");
    test_run_steps(&run, 2);
    ck_assert_int_eq(mpm_simulation_set_body_force(run.simulation, &UNIFORM, &error),
                     MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "body force: set after step 2; allowed: before the first");
    test_run_close(&run);
}
END_TEST

Suite *suite_user_force(void)
{
    Suite *suite = suite_create("user_force");
    TCase *force = tcase_create("force");
    tcase_add_loop_test(force, a_uniform_force_is_the_same_from_the_scene_and_from_the_caller, 0,
                        TEST_COMBINATIONS * KERNEL_SETS);
    tcase_add_loop_test(force, a_callers_force_is_added_in_every_exchange_and_under_damping, 0,
                        EXCHANGES);
    tcase_add_loop_test(force, a_free_block_gains_the_momentum_that_its_particles_are_given, 0, 3);
    tcase_add_loop_test(force, any_number_of_threads_gives_the_same_bits_under_a_callers_force, 0,
                        2);
    tcase_add_test(force, a_force_that_was_taken_away_leaves_no_trace);
    tcase_add_test(force, a_force_that_is_not_finite_fails_the_run_and_names_the_particle);
    tcase_add_test(force, a_force_without_a_function_or_set_too_late_is_refused);
    suite_add_tcase(suite, force);
    return suite;
}
