/* The time step follows the state: waves in the deformed material, and particles that are faster.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

/* Neo-Hookean material that all nodes press together: it fills 8 cells, and at t = 8 only 2. */
static const char PLUG[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [12, 4]}\n"
    "time: {end: 400, courant: 0.4}\n"
    "method: {shape: cpdi, stress_update: usavg}\n"
    "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: plug, material: rubber, region: {rectangle: {from: [0, 0], to: [8, 2]}}}\n"
    "boundary:\n"
    "  - {region: all, velocity: ['-0.75*x/(8-0.75*t)', 0]}\n";

/* rho_0 c^2 = l^2 W_ll = K/2 (J^2 + 1) + G J^(-2/3) (5/9 tr B - l^2/3) along the stretch l; the
 * transverse waves along the unstretched y have G J^(-2/3) only. */
static double wave_speed(double stretch)
{
    const double bulk = 80.0, shear = 48.0, square = stretch * stretch;
    const double factor = shear / cbrt(square);
    return sqrt(0.5 * bulk * (square + 1.0) + factor * (5.0 / 9.0 * (square + 2.0) - square / 3.0));
}

/* Volume gives way here, K/2 (J^2 + 1) falls, while the part of G grows: by 24 % in all. */
START_TEST(a_body_that_stiffens_gets_shorter_steps)
{
    const double first = 0.4 / wave_speed(1.0), last = 0.4 / wave_speed(0.25);
    const double integration = 1e-3; /* of the step, which loses 10 %; 240 steps */
    struct test_run run = test_run_open(PLUG, NULL, 1);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), first, 1e-12);
    while (mpm_simulation_time(run.simulation) < 8.0)
        test_run_steps(&run, 1);
    ck_assert_double_lt(last, 0.91 * first);
    ck_assert_near(mpm_simulation_time_step(run.simulation), last, integration * last);
    test_run_close(&run);
}
END_TEST

/* Wave speed 1.5, cells of 0.8 at least. */
static const char BULLET[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 0.8], cells: [40, 10]}\n"
    "time: {end: 10, courant: 0.5}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: slow, material: soft, region: {rectangle: {from: [1, 0.8], to: [9, 7.2]}}}\n"
    "  - {name: fast, material: soft, region: {rectangle: {from: [11, 1.6], to: [12, 2.4]}},\n"
    "     velocity: [3, 4]}\n";

static const struct {
    const char *velocity, *damping;
    double speed; /* of what is fastest, in the second step as well */
} bullets[] = {
    {"bodies.fast.velocity=[3, 4]", "damping={}", 5.0},
    {"bodies.fast.velocity=[0.9, 1.1]", "damping={}", 1.5},
    /* a step of 0.08 leaves 2/3 of the speed: 10/3 */
    {"bodies.fast.velocity=[3, 4]", "damping={particle: '25/6'}", 10.0 / 3.0},
};

START_TEST(a_particle_that_outruns_waves_gets_shorter_steps)
{
    const char *const settings[] = {bullets[_i].velocity, bullets[_i].damping, NULL};
    struct test_run run = test_run_open(BULLET, settings, 1);
    test_run_steps(&run, 2);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.5 * 0.8 / bullets[_i].speed, 1e-12);
    test_run_close(&run);
}
END_TEST

START_TEST(a_fixed_step_in_which_a_particle_would_outrun_a_cell_is_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.status = MPM_OK};
    const char *const settings[] = {"time={end: 10, step: 0.2}"};
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", BULLET);
    ck_assert_int_eq(mpm_scene_read(path, settings, 1, &scene, &error), MPM_OK);
    ck_assert_int_eq(mpm_simulation_create(scene, &(struct mpm_simulation_options){.threads = 1},
                                           &simulation, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "0.2 is beyond the stability limit; allowed: up to 0.16 "
                                        "(cell size over the speed of particles, 5)") != NULL,
                  "%s", error.message);
    mpm_scene_free(scene);
    test_folder_remove(folder);
    g_free(path);
}
END_TEST

/* --------------------------------------------------------------------- lags */

static const char FALL[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [8, 40]}\n"
    "time: {end: 10, step: 0.125}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: block, material: soft, region: {rectangle: {from: [2, 30], to: [5, 33]}}}\n"
    "loads: {body_force: [0, -0.5]}\n";

static const struct {
    const char *update, *position;
    double place, deformation;
} LAGS[] = {
    {"usl", "grid_velocity", 0.0, 0.0}, {"musl", "grid_velocity", 0.0, 0.0},
    {"usf", "grid_velocity", 0.0, 1.0}, {"usavg", "grid_velocity", 0.0, 0.5},
    {"usavg", "midpoint", 0.5, 0.5},    {"usl", "midpoint", 0.5, 0.0},
};

/* A free fall, y = -t^2/4 and v = -t/2, is computed exactly by steps whose velocities are in
 * their middle: then places and velocities of each scheme are those of their own times. */
START_TEST(what_particles_carry_stands_at_the_times_that_the_lags_say)
{
    char *const update = g_strdup_printf("method.stress_update=%s", LAGS[_i].update);
    char *const position = g_strdup_printf("method.position_update=%s", LAGS[_i].position);
    const char *const settings[] = {update, position, NULL};
    const double step = 0.125, steps = 40, round = 1e-12; /* 40 sums of numbers up to 40 */
    struct test_run run = test_run_open(FALL, settings, 1);
    const struct mpm_lags lags = mpm_scene_lags(run.scene);
    ck_assert_double_eq(lags.position, LAGS[_i].place);
    ck_assert_double_eq(lags.velocity, 0.5);
    ck_assert_double_eq(lags.deformation, LAGS[_i].deformation);
    size_t count;
    double *const start = test_run_field(&run, MPM_FIELD_POSITION, &count);
    double *const velocity = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    for (size_t p = 0; p < count; p++)
        velocity[2 * p + 1] = 0.5 * lags.velocity * step;
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, velocity, NULL, NULL), MPM_OK);
    test_run_steps(&run, (int)steps);
    double *const place = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const speed = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    const double from = -lags.position * step, to = from + steps * step;
    for (size_t p = 0; p < count; p++) {
        ck_assert_near(place[2 * p + 1] - start[2 * p + 1], -0.25 * (to * to - from * from), round);
        ck_assert_near(speed[2 * p + 1], -0.5 * (steps - lags.velocity) * step, round);
    }
    free(place);
    free(speed);
    free(start);
    free(velocity);
    test_run_close(&run);
    g_free(update);
    g_free(position);
}
END_TEST

/* -------------------------------------------------------------- stability */

/* Measured by case G1, which holds its measurements against all rows. Where it has no such method:
 * the least of shape with order, and of each further choice. */
static const struct {
    const char *settings[4];
    bool measured;
    double small, large;
} known[] = {
    {{"method={shape: ugimp, stress_update: usl}"}, true, 0.567, 0.823},
    {{"method={shape: ugimp, stress_update: musl}"}, true, 1.668, 1.173},
    {{"method={shape: classic, stress_update: usl}"}, true, 0.748, 0.0},
    {{"method={shape: bspline3, stress_update: usf}"}, true, 2.364, 0.535},
    {{"method={shape: ugimp, stress_update: usavg, extrapolate: false}"}, true, 0.787, 1.121},
    {{"method={shape: ugimp, stress_update: musl, transfer: {kind: fmpm, order: 4}}"},
     true,
     1.095,
     0.285},
    {{"method={shape: ugimp, stress_update: musl, form: momentum}"}, true, 1.574, 0.141},
    {{"method={shape: cpdi, stress_update: usl, transfer: {kind: apic}}"}, false, 0.761, 0.712},
    {{"method={shape: ugimp, stress_update: musl, transfer: {kind: fmpm, order: 3}}"},
     false,
     1.095,
     0.285},
    {{"method={shape: cpdi, stress_update: usavg, transfer: {kind: flip, fraction: 0.5}}"},
     false,
     1.448,
     1.023},
    {{"method={shape: ugimp, stress_update: musl, position_update: midpoint, form: momentum}"},
     false,
     1.574,
     0.141},
    {{"method={shape: bspline2, stress_update: usavg, extrapolate: false}"}, true, 1.134, 1.321},
};
enum { KNOWN = sizeof known / sizeof known[0] };

START_TEST(a_method_has_the_limits_that_were_measured_or_the_least_of_its_parts)
{
    struct test_run run = test_run_open(PLUG, known[_i].settings, 1);
    const struct mpm_stability found = mpm_scene_stability(run.scene);
    ck_assert(found.measured == known[_i].measured);
    ck_assert_double_eq(found.small, known[_i].small);
    ck_assert_double_eq(found.large, known[_i].large);
    test_run_close(&run);
}
END_TEST

/* A fixed step has a Courant number too: here 0.3 c over 1. */
START_TEST(advice_is_given_beyond_the_limits_alone)
{
    static const struct {
        const char *settings[3], *says;
    } cases[] = {
        {{"method={shape: ugimp, stress_update: usl}", "time={end: 1, courant: 0.55}"}, ""},
        {{"method={shape: ugimp, stress_update: usl}", "time={end: 1, courant: 0.6}"},
         "Courant number 0.6 is above the largest one, 0.567, at which this method kept small "
         "motions bounded (case G1)"},
        {{"method={shape: ugimp, stress_update: usf}", "time={end: 1, courant: 0.6}"},
         "Courant number 0.6 is above the largest one, 0.48, at which this method kept motions at "
         "0.3 of the wave speed bounded (case G1)"},
        {{"method={shape: classic, stress_update: usl}", "time={end: 1, courant: 0.1}"}, ""},
        {{"method={shape: classic, stress_update: usl}", "time={end: 1, courant: 0.2}"},
         "none from 0.1 on"},
        {{"method={shape: ugimp, stress_update: usl}", "time={end: 1, step: 0.05}"},
         "Courant number 0.6 is above"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct test_run run = test_run_open(PLUG, cases[k].settings, 1);
        const char *const advice = mpm_simulation_advice(run.simulation);
        ck_assert_msg(strstr(advice, cases[k].says) != NULL, "%zu: %s", k, advice);
        ck_assert((advice[0] == '\0') == (cases[k].says[0] == '\0'));
        test_run_close(&run);
    }
}
END_TEST

Suite *suite_time_step(void)
{
    Suite *suite = suite_create("time_step");
    TCase *state = tcase_create("state");
    tcase_add_test(state, a_body_that_stiffens_gets_shorter_steps);
    tcase_add_loop_test(state, a_particle_that_outruns_waves_gets_shorter_steps, 0,
                        G_N_ELEMENTS(bullets));
    tcase_add_test(state, a_fixed_step_in_which_a_particle_would_outrun_a_cell_is_refused);
    TCase *lags = tcase_create("lags");
    tcase_add_loop_test(lags, what_particles_carry_stands_at_the_times_that_the_lags_say, 0,
                        sizeof LAGS / sizeof LAGS[0]);
    tcase_add_loop_test(state, a_method_has_the_limits_that_were_measured_or_the_least_of_its_parts,
                        0, KNOWN);
    tcase_add_test(state, advice_is_given_beyond_the_limits_alone);
    suite_add_tcase(suite, lags);
    suite_add_tcase(suite, state);
    return suite;
}
