/* Velocities and deformation gradients that a caller gives a simulation to start with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/soft_block.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5 };

static const char BLOCK[] = TEST_SOFT_BLOCK(TEST_WALL);

/* Velocities and gradients that differ from particle to particle; J near 1.1. */
struct start {
    size_t count;
    double *velocity, *deformation;
};

static struct start make_start(const struct test_run *run)
{
    struct start start;
    start.velocity = test_run_field(run, MPM_FIELD_VELOCITY, &start.count);
    start.deformation = test_run_field(run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    for (size_t k = 0; k < start.count; k++) {
        const double change[GRADIENT] = {0.1 + 1e-3 * (double)k, 0.05, -1e-3 * (double)k, -0.02};
        for (size_t axis = 0; axis < AXES; axis++)
            start.velocity[AXES * k + axis] = 0.01 * sin((double)(AXES * k + axis));
        for (size_t c = 0; c < GRADIENT; c++)
            start.deformation[GRADIENT * k + c] += change[c];
    }
    return start;
}

static void free_start(struct start *start)
{
    free(start->velocity);
    free(start->deformation);
}

static double *field_at_start(const struct test_run *run, enum mpm_field field)
{
    return test_run_field(run, field, NULL);
}

/* tau = K/2 (J^2 - 1) I + G J^(-2/3) dev B: its xy and zz over J */
START_TEST(a_start_is_read_back_by_id_and_stress_and_energy_follow_from_it)
{
    const bool stress_free = _i == 1;
    const char *const settings[] = {stress_free ? "geometry=plane_stress" : "method.shape=cpdi",
                                    "method.stress_update=usavg", NULL};
    const double bulk = 1.25, shear = 0.75;
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct start start = make_start(&run);
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_simulation_set_start(run.simulation, start.velocity, start.deformation,
                                           &error) == MPM_OK,
                  "%s", error.message);
    double *const velocity = field_at_start(&run, MPM_FIELD_VELOCITY);
    double *const deformation = field_at_start(&run, MPM_FIELD_DEFORMATION_GRADIENT);
    double *const stress = field_at_start(&run, MPM_FIELD_STRESS);
    double *const mass = field_at_start(&run, MPM_FIELD_MASS);
    double energy = 0.0, kinetic = 0.0;
    for (size_t k = 0; k < start.count; k++) {
        const double *const f = &deformation[GRADIENT * k], *const v = &velocity[AXES * k];
        if (mass[k] == 0.0)
            continue; /* the wall's particles */
        for (size_t c = 0; c < AXES; c++)
            ck_assert(v[c] == start.velocity[AXES * k + c]);
        for (size_t c = 0; c < GRADIENT - 1; c++) /* F_zz is tested below */
            ck_assert(f[c] == start.deformation[GRADIENT * k + c]);
        const double j = (f[0] * f[3] - f[1] * f[2]) * f[4], factor = shear / cbrt(j * j);
        const double trace = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] + f[3] * f[3] + f[4] * f[4];
        const double zz = (0.5 * bulk * (j * j - 1.0) + factor * (f[4] * f[4] - trace / 3.0)) / j;
        ck_assert(stress_free ? f[4] < 1.0 : f[4] == 1.0);
        ck_assert_near(stress[4 * k + 2], stress_free ? 0.0 : zz, TEST_SOFT_ROUND_OFF);
        ck_assert_near(stress[4 * k + 3], factor * (f[0] * f[2] + f[1] * f[3]) / j,
                       TEST_SOFT_ROUND_OFF);
        kinetic += 0.5 * mass[k] * (v[0] * v[0] + v[1] * v[1]);
        energy += mass[k] * (0.5 * bulk * (0.5 * (j * j - 1.0) - log(j)) +
                             0.5 * (factor * trace - 3.0 * shear));
    }
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_near(ledger.kinetic_energy, kinetic, TEST_SOFT_ROUND_OFF);
    ck_assert_near(ledger.strain_energy, energy, TEST_SOFT_ROUND_OFF * 10.0);
    ck_assert(energy > 0.01);
    double *const values[] = {velocity, deformation, stress, mass};
    for (size_t k = 0; k < G_N_ELEMENTS(values); k++)
        free(values[k]);
    free_start(&start);
    test_run_close(&run);
}
END_TEST

/* The scene's own velocity is one start, the caller's the other. Also where domains are stored. */
START_TEST(a_velocity_is_the_same_from_the_scene_and_from_the_caller)
{
    const char *const shape = _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi";
    const char *const settings[2][4] = {
        {shape, "method.stress_update=usf", "bodies.block.velocity=['0.1*sin(y)', '0.1*x']", NULL},
        {shape, "method.stress_update=usf", NULL},
    };
    struct test_run own = test_run_open(BLOCK, settings[0], 1);
    struct test_run given = test_run_open(BLOCK, settings[1], 1);
    size_t count;
    double *const velocity = test_run_field(&own, MPM_FIELD_VELOCITY, &count);
    double *const unit = field_at_start(&own, MPM_FIELD_DEFORMATION_GRADIENT);
    ck_assert_int_eq(mpm_simulation_set_start(given.simulation, velocity, unit, NULL), MPM_OK);
    test_run_steps(&own, 40);
    test_run_steps(&given, 40);
    double *const a = test_run_field(&own, MPM_FIELD_STRESS, NULL);
    double *const b = test_run_field(&given, MPM_FIELD_STRESS, NULL);
    ck_assert_int_eq(memcmp(a, b, 4 * count * sizeof *a), 0);
    double *const values[] = {velocity, unit, a, b};
    for (size_t k = 0; k < G_N_ELEMENTS(values); k++)
        free(values[k]);
    test_run_close(&own);
    test_run_close(&given);
}
END_TEST

static void spoilt_force(void *context, double time, size_t count, const uint32_t id[],
                         double *const force[AXES])
{
    (void)context;
    (void)id;
    for (size_t k = 0; k < count; k++)
        force[0][k] = force[1][k] = time + (double)NAN;
}

START_TEST(a_run_that_fails_at_once_goes_back_to_the_start_that_was_given)
{
    const char *const settings[] = {
        _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi",
        _i == 0 ? "method.stress_update=usl" : "method.stress_update=usavg", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct start start = make_start(&run);
    const struct mpm_body_force force = {spoilt_force, NULL};
    ck_assert_int_eq(
        mpm_simulation_set_start(run.simulation, start.velocity, start.deformation, NULL), MPM_OK);
    ck_assert_int_eq(mpm_simulation_set_body_force(run.simulation, &force, NULL), MPM_OK);
    double *const before = field_at_start(&run, MPM_FIELD_STRESS);
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 10.0, NULL), MPM_RUN_FAILED);
    double *const after = field_at_start(&run, MPM_FIELD_STRESS);
    double *const deformation = field_at_start(&run, MPM_FIELD_DEFORMATION_GRADIENT);
    ck_assert_int_eq(memcmp(before, after, 4 * start.count * sizeof *after), 0);
    ck_assert(deformation[GRADIENT * 17] == start.deformation[GRADIENT * 17]);
    free(before);
    free(after);
    free(deformation);
    free_start(&start);
    test_run_close(&run);
}
END_TEST

struct bad_start {
    size_t component; /* of F; or of the velocity, GRADIENT more */
    double value;
    const char *words;
};
static const struct bad_start BAD_STARTS[] = {
    {0, (double)NAN, "start: deformation gradient of particle 17 is nan 0.05"},
    {0, -1.0, "allowed: finite, F_xx F_yy - F_xy F_yx > 0 and F_zz > 0"},
    {4, 0.0, "F_zz > 0"},
    {4, 1.25, "start: F_zz of particle 17 is 1.25; allowed: 1 in plane strain"},
    {GRADIENT, (double)INFINITY, "start: velocity 0 of particle 17 is inf; allowed: finite"},
};

START_TEST(a_start_that_is_not_allowed_is_refused_and_changes_nothing)
{
    const struct bad_start *const bad = &BAD_STARTS[_i];
    struct test_run run = test_run_open(BLOCK, NULL, 1);
    struct start start = make_start(&run);
    struct mpm_error error = {.message = ""};
    if (bad->component < GRADIENT)
        start.deformation[GRADIENT * 17 + bad->component] = bad->value;
    else
        start.velocity[AXES * 17 + bad->component - GRADIENT] = bad->value;
    ck_assert_int_eq(
        mpm_simulation_set_start(run.simulation, start.velocity, start.deformation, &error),
        MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, bad->words) != NULL, "%s", error.message);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert(ledger.kinetic_energy == 0.0 && ledger.strain_energy == 0.0);
    ck_assert(ledger.j_min == 1.0 && ledger.j_max == 1.0);
    test_run_steps(&run, 1);
    free_start(&start);
    test_run_close(&run);
}
END_TEST

/* Waves at 1.5 cross 0.8 in 0.533; those of J = 1.5, with rho c^2 = K/2 (J^2 + 1) + ... , sooner.
 */
START_TEST(a_fixed_step_beyond_the_limit_of_the_start_is_refused_for_good)
{
    const char *const settings[] = {"time={end: 10, step: 0.52}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct start start = make_start(&run);
    struct mpm_error error = {.message = ""}, again = {.message = ""};
    for (size_t k = 0; k < start.count; k++)
        start.deformation[GRADIENT * k] = 1.5;
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, start.deformation, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "0.52 is beyond the stability limit") != NULL, "%s",
                  error.message);
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 10.0, &again), MPM_BAD_INPUT);
    ck_assert_str_eq(again.message, error.message);
    free_start(&start);
    test_run_close(&run);
}
END_TEST

/* F_xx = 50 makes half a domain of 12.5 cells out of a quarter of one. */
START_TEST(a_start_whose_domains_leave_the_grid_is_refused_for_good)
{
    static const char *const settings[] = {"method.shape=cpdi", NULL};
    struct test_run run = test_run_open(BLOCK, settings, _i == 0 ? 1 : 3);
    struct start start = make_start(&run);
    struct mpm_error error, again;
    for (size_t k = 0; k < GRADIENT; k++)
        start.deformation[GRADIENT * 11 + k] = k == 0 ? 50.0 : 0.0;
    start.deformation[GRADIENT * 11 + 3] = start.deformation[GRADIENT * 11 + 4] = 1.0;
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, start.deformation, &error),
                     MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "start: particle 11 (body 'block') has a domain that reaches "
                                    "12.5 cells along x, beyond the ghost rows of the grid");
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 10.0, &again), MPM_BAD_INPUT);
    ck_assert_str_eq(again.message, error.message);
    free_start(&start);
    test_run_close(&run);
}
END_TEST

START_TEST(a_start_after_a_step_is_refused)
{
    struct test_run run = test_run_open(BLOCK, NULL, 1);
    struct mpm_error error;
    test_run_steps(&run, 2);
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, NULL, &error), MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "start: set after step 2; allowed: before the first");
    test_run_close(&run);
}
END_TEST

Suite *suite_start(void)
{
    Suite *suite = suite_create("start");
    TCase *start = tcase_create("start");
    tcase_add_loop_test(start, a_start_is_read_back_by_id_and_stress_and_energy_follow_from_it, 0,
                        2);
    tcase_add_loop_test(start, a_velocity_is_the_same_from_the_scene_and_from_the_caller, 0, 2);
    tcase_add_loop_test(start, a_run_that_fails_at_once_goes_back_to_the_start_that_was_given, 0,
                        2);
    tcase_add_loop_test(start, a_start_that_is_not_allowed_is_refused_and_changes_nothing, 0,
                        G_N_ELEMENTS(BAD_STARTS));
    tcase_add_test(start, a_fixed_step_beyond_the_limit_of_the_start_is_refused_for_good);
    tcase_add_loop_test(start, a_start_whose_domains_leave_the_grid_is_refused_for_good, 0, 2);
    tcase_add_test(start, a_start_after_a_step_is_refused);
    suite_add_tcase(suite, start);
    return suite;
}
