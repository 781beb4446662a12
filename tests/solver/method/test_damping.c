/* Damping: the discrete law of decay, the particle's way, places, energy, threads, kernels.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/folder.h"
#include "support/kernel_pair.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/soft_block.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

enum { SHAPES = 3 }; /* the first of all: damping does not know them */

static double *velocities(const struct test_run *run, size_t *count)
{
    return test_run_field(run, MPM_FIELD_VELOCITY, count);
}

/* -------------------------------------------------------------- free bodies */

/* Two free bodies, five cells apart, of one velocity each: no force but damping. */
static const char FLYERS[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [20, 8]}\n"
    "time: {end: 1000, step: 0.1}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: left, material: soft, region: {rectangle: {from: [2, 2], to: [5, 5]}},\n"
    "     velocity: [0.1, 0.2]}\n"
    "  - {name: right, material: soft, region: {rectangle: {from: [12, 2], to: [15, 5]}},\n"
    "     velocity: [0.1, 0.2]}\n";
enum { FLYER_STEPS = 50, FLYER_PARTICLES = 36 };
static const double FLYER_SPEED[2] = {0.1, 0.2}, FLYER_DT = 0.1;

/* Sums of some ten terms a step and node, each good to 1.1e-16: 50 steps stay below 1e-13. */
static const double FLYER_ROUND_OFF = 1e-13;

static const struct {
    const char *damping;
    double grid, particle; /* rates */
} rates[] = {
    {"damping={grid: 0.7}", 0.7, 0.0},
    {"damping={particle: 0.7}", 0.0, 0.7},
    {"damping={grid: '0.2+0*x', particle: '0.5+0*y'}", 0.2, 0.5},
    {"damping={grid: 0.3, particle: 0.2, pic: 0.4}", 0.3, 0.2},
};
enum { RATES = G_N_ELEMENTS(rates) };

/* Notes (40): v^{n+1} = v^n (1 - alpha dt), alpha = alpha_g + alpha_p where the grid moves with
 * the particles. Notes (38): the midpoint's way is dt (v^n + v^{n+1})/2; with grid_velocity it
 * is dt v*^{n+1}, which knows alpha_g only. */
START_TEST(a_free_body_keeps_one_minus_alpha_dt_of_its_velocity_in_a_step)
{
    const int r = _i % RATES, o = _i / RATES % TEST_ORDERS, s = _i / RATES / TEST_ORDERS;
    for (int midpoint = 0; midpoint < 2; midpoint++) {
        char *order = g_strdup_printf("method.stress_update=%s", test_orders[o]);
        char *shape = g_strdup_printf("method.shape=%s", test_shapes[s]);
        const char *const settings[] = {rates[r].damping, order, shape,
                                        midpoint ? "method.position_update=midpoint"
                                                 : "method.position_update=grid_velocity",
                                        NULL};
        struct test_run run = test_run_open(FLYERS, settings, 1);
        size_t count;
        double *const from = test_run_field(&run, MPM_FIELD_POSITION, &count);
        test_run_steps(&run, FLYER_STEPS);
        double *const v = velocities(&run, NULL);
        double *const x = test_run_field(&run, MPM_FIELD_POSITION, NULL);
        const double kept = 1.0 - (rates[r].grid + rates[r].particle) * FLYER_DT;
        double factor = 1.0, way = 0.0;
        for (int k = 0; k < FLYER_STEPS; k++) {
            way += FLYER_DT * factor *
                   (midpoint ? 0.5 * (1.0 + kept) : 1.0 - rates[r].grid * FLYER_DT);
            factor *= kept;
        }
        for (size_t k = 0; k < 2 * count; k++) {
            ck_assert_near(v[k], factor * FLYER_SPEED[k % 2], FLYER_ROUND_OFF);
            ck_assert_near(x[k] - from[k], way * FLYER_SPEED[k % 2], 20.0 * FLYER_ROUND_OFF);
        }
        free(from);
        free(v);
        free(x);
        g_free(order);
        g_free(shape);
        test_run_close(&run);
    }
}
END_TEST

/* Every transfer hands a uniform velocity over as it is, less what damping takes. */
START_TEST(every_transfer_is_damped_alike)
{
    static const char *const transfers[] = {
        "method.transfer={kind: flip, fraction: 0.8}",
        "method.transfer={kind: pic}",
        "method.transfer={kind: xpic, order: 3}",
        "method.transfer={kind: fmpm, order: 3}",
        "method.transfer={kind: apic}",
        "method={extrapolate: false, stress_update: usavg}",
    };
    const char *const settings[] = {transfers[_i], "damping={grid: 0.3, particle: 0.2}", NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    size_t count;
    test_run_steps(&run, FLYER_STEPS);
    double *const v = velocities(&run, &count);
    for (size_t k = 0; k < 2 * count; k++)
        ck_assert_near(v[k], pow(1.0 - 0.5 * FLYER_DT, FLYER_STEPS) * FLYER_SPEED[k % 2],
                       FLYER_ROUND_OFF);
    free(v);
    test_run_close(&run);
}
END_TEST

START_TEST(a_place_is_damped_and_another_is_not)
{
    static const char *const damped[] = {"damping={grid: 'x < 8 ? 0.7 : 0'}",
                                         "damping={particle: 'x < 8 ? 0.7 : 0'}"};
    const char *const settings[] = {damped[_i], NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    size_t count;
    test_run_steps(&run, FLYER_STEPS);
    double *const v = velocities(&run, &count);
    ck_assert_uint_eq(count, 2 * FLYER_PARTICLES);
    for (size_t k = 0; k < 2 * count; k++) {
        const double factor = k < 2 * FLYER_PARTICLES ? pow(1.0 - 0.7 * FLYER_DT, FLYER_STEPS) : 1;
        ck_assert_near(v[k], factor * FLYER_SPEED[k % 2], FLYER_ROUND_OFF);
    }
    free(v);
    test_run_close(&run);
}
END_TEST

/* v* = v (1 - 0.2 x dt) strains by - 0.2 v dt^2 in the first step of USL, which takes the gradient
 * of the nodes' new velocity; dF by two terms of exp(h). */
START_TEST(strain_follows_the_damped_velocity_of_the_nodes)
{
    const char *const settings[] = {"damping={grid: '0.2*x'}", "method.stress_update=usl", NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    size_t count;
    test_run_steps(&run, 1);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, &count);
    const double h = -0.2 * FLYER_SPEED[0] * FLYER_DT * FLYER_DT;
    for (size_t p = 0; p < count; p++)
        ck_assert_near(f[5 * p], 1.0 + h + 0.5 * h * h, 1e-15);
    free(f);
    test_run_close(&run);
}
END_TEST

/* All nodes are driven along x, none along y: only there is energy taken out, m alpha v (v +
 * v')/2 dt with v' = (1 - alpha dt) v. */
START_TEST(a_held_component_is_not_damped)
{
    static const char *const damped[] = {"damping={grid: 0.7}", "damping={grid: '0.7+0*x'}"};
    const char *const settings[] = {damped[_i], "boundary=[{region: all, velocity: [0.1, free]}]",
                                    NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    struct mpm_ledger ledger;
    test_run_steps(&run, 1);
    double *const v = velocities(&run, NULL);
    mpm_simulation_ledger(run.simulation, &ledger);
    const double kept = 1.0 - 0.7 * FLYER_DT, speed = FLYER_SPEED[1];
    ck_assert_near(v[0], FLYER_SPEED[0], FLYER_ROUND_OFF);
    ck_assert_near(v[1], kept * speed, FLYER_ROUND_OFF);
    ck_assert_near(ledger.damping_dissipation,
                   0.5 * ledger.mass * speed * speed * (1.0 - kept * kept), FLYER_ROUND_OFF);
    free(v);
    test_run_close(&run);
}
END_TEST

START_TEST(rates_follow_time)
{
    const char *const settings[] = {"damping={grid: 't < 0.95 ? 0.7 : 0', particle: '0.1*t'}",
                                    NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    test_run_steps(&run, 20);
    double *const v = velocities(&run, NULL);
    double factor = 1.0;
    for (int k = 0; k < 20; k++)
        factor *= 1.0 - FLYER_DT * ((k < 10 ? 0.7 : 0.0) + 0.1 * k * FLYER_DT);
    ck_assert_near(v[0], factor * FLYER_SPEED[0], FLYER_ROUND_OFF);
    free(v);
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------- PIC damping */

/* A free block that swings: particle and grid velocities differ. */
static const char BLOCK[] = TEST_SOFT_SCENE(
    "{end: 1000, step: 0.1}",
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [8, 7.2]}},\n"
    "     velocity: ['0.05*sin(2*x)', '0.04*cos(y)']}\n" TEST_SWINGING_FLOOR);

static const char *const kernels_pair_settings[2][3] = {
    {"damping={pic: 0.9}", NULL, NULL},
    {"method.transfer={kind: flip, fraction: 0.9}", NULL, NULL},
};

START_TEST(pic_damping_is_a_flip_fraction)
{
    const struct mpm_simulation_options options = {
        .threads = 1, .kernels = _i == 0 ? MPM_KERNELS_REFERENCE : MPM_KERNELS_FAST};
    const struct kernel_side sides[2] = {{kernels_pair_settings[0], options},
                                         {kernels_pair_settings[1], options}};
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    kernel_pair_assert_alike(&pair, KERNEL_PAIR_STEPS);
    kernel_pair_close(&pair);
}
END_TEST

/* Notes (42), (43): against a step without, PIC damping changes the velocity by - dt q and the
 * way by - dt^2/2 q; a FLIP fraction changes the velocity alone. */
START_TEST(pic_damping_moves_particles_with_the_midpoint_update)
{
    const char *const tried[3] = {"damping={}", "damping={pic: 0.6}",
                                  "method.transfer={kind: flip, fraction: 0.6}"};
    double *v[3], *x[3];
    double largest = 0.0;
    size_t count;
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {tried[k], "method.position_update=midpoint", NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        test_run_steps(&run, 1);
        v[k] = velocities(&run, &count);
        x[k] = test_run_field(&run, MPM_FIELD_POSITION, NULL);
        test_run_close(&run);
    }
    for (size_t k = 0; k < 2 * count; k++) {
        const double change = v[1][k] - v[0][k];
        ck_assert_near(v[2][k] - v[0][k], change, 1e-16);
        ck_assert_near(x[1][k] - x[0][k], 0.5 * 0.1 * change, 2e-15); /* a few ulps of x */
        ck_assert_near(x[2][k] - x[0][k], 0.0, 2e-15);
        largest = fmax(largest, fabs(change));
    }
    ck_assert(largest > 1e-3);
    for (int k = 0; k < 3; k++) {
        free(v[k]);
        free(x[k]);
    }
}
END_TEST

/* ----------------------------------------------------------------- kernels */

static const char ALL_OF_IT[] = "damping={grid: '0.2*x', particle: '0.1+0.02*y', pic: 0.95, "
                                "thermostat: {gain: 0.1}}";

START_TEST(fast_and_reference_kernels_damp_alike)
{
    char *order =
        g_strdup_printf("method.stress_update=%s", test_orders[_i / SHAPES % TEST_ORDERS]);
    char *shape = g_strdup_printf("method.shape=%s", test_shapes[_i % SHAPES]);
    const char *const settings[] = {ALL_OF_IT,
                                    order,
                                    shape,
                                    _i / SHAPES / TEST_ORDERS == 0
                                        ? "method.position_update=grid_velocity"
                                        : "method.position_update=midpoint",
                                    "loads={body_force: [0, '-0.001*x']}",
                                    NULL};
    const struct kernel_side sides[2] = {
        {settings, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {settings, {.threads = 1, .kernels = MPM_KERNELS_FAST}}};
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    const bool amplifies = _i % SHAPES == 0 && _i / SHAPES % TEST_ORDERS == 0;
    kernel_pair_assert_alike(&pair, amplifies ? 10 : KERNEL_PAIR_STEPS);
    kernel_pair_close(&pair);
    g_free(order);
    g_free(shape);
}
END_TEST

/* Enough particles for three workers; and a sort and a restored state on the way. */
START_TEST(any_number_of_threads_gives_the_same_bits_with_damping)
{
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS,
        "time={end: 1000, step: 0.1, rest: {residual: 1e-3, kinetic_energy: 1e-3}}",
        "damping={grid: '0.02*x', particle: '0.1+0.002*y', pic: 0.95, thermostat: {gain: 0.1}}",
        _i == 0 ? "method={position_update: midpoint}" : "method={shape: cpdi, stress_update: usf}",
        NULL,
    };
    struct test_run one = test_run_open(BLOCK, settings, 1);
    struct mpm_rest rest;
    test_run_steps(&one, 40);
    (void)mpm_simulation_at_rest(one.simulation, &rest);
    ck_assert(test_run_ledger(&one).damping_dissipation > 0.0 && rest.residual > 0.0);
    for (int threads = 2; threads <= 3; threads++) {
        struct test_run more = test_run_open(BLOCK, settings, threads);
        test_run_steps(&more, 40);
        struct mpm_rest other_rest;
        (void)mpm_simulation_at_rest(more.simulation, &other_rest);
        ck_assert(rest.residual == other_rest.residual);
        ck_assert(rest.kinetic_energy == other_rest.kinetic_energy);
        ck_assert(test_run_same_bits(&one, &more));
        test_run_close(&more);
    }
    test_run_close(&one);
}
END_TEST

/* ---------------------------------------------------------------- refusals */

static const struct {
    const char *setting, *says;
} refused[] = {
    {"damping={grid: -1}", "damping.grid: a negative rate, got -1; allowed: at least 0"},
    {"damping={particle: '-x'}", "damping.particle: a negative rate"},
    {"damping={grid: 'sqrt(-1)'}", "not a number"},
    {"damping={grid: .nan}", "damping.grid"},
    {"damping={grid: free}", "damping.grid: a component cannot be free"},
    {"damping={grid: 10}", "damping.grid: '10' is 10 at (2.25, 2.25), time 0; allowed: at least "
                           "0 and below 10, 1 over the time step"},
    {"damping={particle: 'x > 14 ? 20 : 0'}", "is 20 at (14.25, 2.25)"},
    {"damping={grid: 'x > 14 ? -2 : 0'}", "is -2 at (14.25, 2.25)"},
    {"damping={pic: 1.5}", "damping.pic: out of range, got 1.5; allowed: from 0 to 1"},
    {"damping={pic: -0.1}", "damping.pic: out of range"},
    {"damping={pic: '1-0.001*x'}", "damping.pic: '1-0.001*x' varies in space"},
    {"damping={pic: 0.9, viscosity: 1}", "unknown key \"viscosity\"; allowed: grid, grid_form, "
                                         "particle, pic, thermostat"},
    {"damping={thermostat: {}}", "damping.thermostat.gain: missing"},
    {"damping={thermostat: {gain: 0}}", "damping.thermostat.gain: out of range"},
    {"damping={thermostat: {gain: 1, target: -1}}", "allowed: number at least 0"},
    {"damping={thermostat: {gain: 1, scale: 0}}", "damping.thermostat.scale: out of range"},
    {"damping={particle: 0.1, grid_form: particles}", "damping.grid_form: without damping.grid"},
    {"damping={grid: 0.1, grid_form: particle}", "damping.grid_form"},
    {"loads={body_force_at: nodes}", "loads.body_force_at: without loads.body_force"},
};

static struct mpm_error refusal(const char *const *settings, size_t count)
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", FLYERS);
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status = mpm_scene_read(path, settings, count, &scene, &error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, &(struct mpm_simulation_options){.threads = 1},
                                       &simulation, &error);
    ck_assert_int_eq(status, MPM_BAD_INPUT);
    mpm_scene_free(scene);
    test_folder_remove(folder);
    g_free(path);
    return error;
}

START_TEST(damping_that_cannot_be_is_refused)
{
    const struct mpm_error error = refusal(&refused[_i].setting, 1);
    ck_assert_msg(strstr(error.message, refused[_i].says) != NULL, "%s", error.message);
}
END_TEST

START_TEST(damping_at_the_particles_with_velocities_of_other_nodes_is_refused)
{
    static const char *const others[][2] = {
        {"method.transfer={kind: fmpm, order: 2}", "with transfer fmpm, which gives"},
        {"method.transfer.kind=apic", "with transfer apic, which carries"},
        {"method={radius_update: hoop}", "with radius_update: hoop"},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(others); k++) {
        const char *const settings[] = {"damping={grid: 0.1, grid_form: particle_rate}",
                                        k == 2 ? "geometry=axisymmetric" : "geometry=plane_strain",
                                        others[k][0]};
        const struct mpm_error error = refusal(settings, 3);
        ck_assert_msg(strstr(error.message, others[k][1]) != NULL, "%s", error.message);
    }
}
END_TEST

START_TEST(pic_damping_beside_what_does_the_same_is_refused)
{
    static const char *const others[][2] = {
        {"method.transfer={kind: flip, fraction: 0.9}", "both damping.pic and a method.transfer"},
        {"method.transfer.kind=pic", "PIC damping with a method.transfer other than flip"},
        {"method.transfer={kind: xpic, order: 2}", "PIC damping with a method.transfer other"},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(others); k++) {
        const char *const settings[] = {"damping={pic: 0.9}", others[k][0]};
        const struct mpm_error error = refusal(settings, 2);
        ck_assert_msg(strstr(error.message, others[k][1]) != NULL, "%s", error.message);
    }
}
END_TEST

static const struct {
    const char *setting, *says;
} failing[] = {
    {"damping={grid: '4*t'}", "step 26, time 2.6: damping.grid is 10; allowed: at least 0 and"},
    {"damping={grid: '1-t'}", "step 12, time 1.2: damping.grid is -0.1"},
    {"damping={grid: 'sqrt(0.45-t)+0*x'}", "step 6, time 0.6: damping.grid at the node ("},
    {"damping={particle: '0.01*x+(t > 0.45 ? -1 : 0)'}",
     "particle 0 (body 'left') has damping.particle = -0.9"},
    {"damping={particle: 't < 0.45 ? 1 : 11'}", "damping.particle is 11"},
    {"damping={pic: '1-t'}", "damping.pic is -0.1; allowed: from 0 to 1"},
    {"damping={grid: 5, thermostat: {gain: 60}}", "damping.grid with the thermostat's rate"},
};

/* The last good state has the damping totals of that state: those of a run that stops there. */
START_TEST(a_rate_that_goes_astray_fails_the_run)
{
    const char *const settings[] = {failing[_i].setting, NULL};
    struct test_run run = test_run_open(FLYERS, settings, 1);
    struct mpm_error error = {.status = MPM_OK};
    while (mpm_simulation_advance(run.simulation, HUGE_VAL, &error) == MPM_OK)
        ck_assert_uint_lt(mpm_simulation_step(run.simulation), 100);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_msg(strstr(error.message, failing[_i].says) != NULL, "%s", error.message);
    struct test_run good = test_run_open(FLYERS, settings, 1);
    test_run_steps(&good, (int)mpm_simulation_step(run.simulation));
    struct mpm_ledger ledgers[2];
    mpm_simulation_ledger(run.simulation, &ledgers[0]);
    mpm_simulation_ledger(good.simulation, &ledgers[1]);
    ck_assert(ledgers[0].damping_dissipation > 0.0);
    ck_assert(ledgers[0].damping_dissipation == ledgers[1].damping_dissipation);
    test_run_close(&run);
    test_run_close(&good);
}
END_TEST

Suite *suite_damping(void)
{
    Suite *suite = suite_create("damping");
    TCase *free_bodies = tcase_create("free bodies");
    tcase_add_loop_test(free_bodies, a_free_body_keeps_one_minus_alpha_dt_of_its_velocity_in_a_step,
                        0, RATES * TEST_ORDERS * SHAPES);
    tcase_add_loop_test(free_bodies, every_transfer_is_damped_alike, 0, 6);
    tcase_add_loop_test(free_bodies, a_place_is_damped_and_another_is_not, 0, 2);
    tcase_add_test(free_bodies, strain_follows_the_damped_velocity_of_the_nodes);
    tcase_add_loop_test(free_bodies, a_held_component_is_not_damped, 0, 2);
    tcase_add_test(free_bodies, rates_follow_time);
    suite_add_tcase(suite, free_bodies);
    TCase *kernels = tcase_create("kernels");
    tcase_add_loop_test(kernels, pic_damping_is_a_flip_fraction, 0, 2);
    tcase_add_test(kernels, pic_damping_moves_particles_with_the_midpoint_update);
    tcase_add_loop_test(kernels, fast_and_reference_kernels_damp_alike, 0,
                        2 * SHAPES * TEST_ORDERS);
    tcase_add_loop_test(kernels, any_number_of_threads_gives_the_same_bits_with_damping, 0, 2);
    suite_add_tcase(suite, kernels);
    TCase *refusals = tcase_create("refusals");
    tcase_add_loop_test(refusals, damping_that_cannot_be_is_refused, 0, G_N_ELEMENTS(refused));
    tcase_add_test(refusals, damping_at_the_particles_with_velocities_of_other_nodes_is_refused);
    tcase_add_test(refusals, pic_damping_beside_what_does_the_same_is_refused);
    tcase_add_loop_test(refusals, a_rate_that_goes_astray_fails_the_run, 0, G_N_ELEMENTS(failing));
    suite_add_tcase(suite, refusals);
    return suite;
}
