/* Grid damping at the particles, Notes (46)-(57), (106), (107), against that at the nodes.
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

/* A free block that swings: particle and grid velocities differ. */
static const char BLOCK[] = TEST_SOFT_SCENE(
    "{end: 1000, step: 0.1}",
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [8, 7.2]}},\n"
    "     velocity: ['0.05*sin(2*x)', '0.04*cos(y)']}\n");
static const double STEP = 0.1;
enum { ONE = 1, STEPS = 50, AXES = 2 };

static const char *const ways[] = {"method.position_update=grid_velocity",
                                   "method.position_update=midpoint"};
static const char *const exchanges[] = {
    "method.transfer={kind: flip}",
    "method.transfer={kind: flip, fraction: 0.9}",
    "method.transfer={kind: pic}",
    "method.transfer={kind: xpic, order: 3}",
    "method={form: momentum}",
    "damping.pic=0.9",
    "damping.thermostat={gain: 0.1}",
    "damping.particle=0.1+0.02*y",
    "loads={body_force: [0, '-0.001*x']}",
};
enum { EXCHANGES = G_N_ELEMENTS(exchanges), WAYS = 2 };

static double largest_difference(const struct test_run *one, const struct test_run *other,
                                 enum mpm_field field)
{
    size_t count;
    double *const a = test_run_field(one, field, &count);
    double *const b = test_run_field(other, field, NULL);
    double largest = 0.0;
    for (size_t k = 0; k < mpm_field_describe(field)->components * count; k++)
        largest = fmax(largest, fabs(a[k] - b[k]));
    free(a);
    free(b);
    return largest;
}

/* With MUSL no task uses the nodes' velocities at the end of the step but that of the particles:
 * what (46)-(57) give them is what (58)-(65) do. Velocities of 0.05, positions of 8 and 50 steps: a
 * hundred times TEST_SOFT_ROUND_OFF is below what any term of the step would change. */
START_TEST(damping_at_the_particles_is_that_at_the_nodes_after_extrapolation)
{
    const int e = _i % EXCHANGES, w = _i / EXCHANGES % WAYS, s = _i / EXCHANGES / WAYS;
    char *shape = g_strdup_printf("method.shape=%s", test_shapes[s]);
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        const char *const settings[] = {exchanges[e],
                                        shape,
                                        ways[w],
                                        "method.stress_update=musl",
                                        "damping.grid=0.2+0.05*x",
                                        k == 0 ? "damping.grid_form=nodes"
                                               : "damping.grid_form=particles",
                                        NULL};
        runs[k] = test_run_open(BLOCK, settings, 1);
        test_run_steps(&runs[k], STEPS);
    }
    ck_assert_near(largest_difference(&runs[0], &runs[1], MPM_FIELD_VELOCITY), 0.0,
                   100.0 * TEST_SOFT_ROUND_OFF);
    ck_assert_near(largest_difference(&runs[0], &runs[1], MPM_FIELD_POSITION), 0.0,
                   100.0 * TEST_SOFT_ROUND_OFF);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
    g_free(shape);
}
END_TEST

/* (47): the same for a rate of time alone, in every order; also where it is found place by place,
 * beside a thermostat. */
START_TEST(the_rate_at_the_particle_is_that_at_the_nodes_where_all_have_one)
{
    char *order = g_strdup_printf("method.stress_update=%s", test_orders[_i % TEST_ORDERS]);
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        const char *const settings[] = {
            order,
            _i < TEST_ORDERS ? "damping={grid: '0.3+0.1*t'}"
                             : "damping={grid: '0.3+0*x', thermostat: {gain: 0.1}}",
            k == 0 ? "damping.grid_form=particles" : "damping.grid_form=particle_rate", NULL};
        runs[k] = test_run_open(BLOCK, settings, 1);
        test_run_steps(&runs[k], STEPS);
    }
    ck_assert_near(largest_difference(&runs[0], &runs[1], MPM_FIELD_VELOCITY), 0.0,
                   TEST_SOFT_ROUND_OFF);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
    g_free(order);
}
END_TEST

/* A body of one velocity keeps 1 - dt alpha_g(x_p) of it with (107), and 1 - dt sum S alpha_g(x_i)
 * with (106). For alpha_g = c x^2 the sum has x_p^2 + s: from 0 to 1 hat functions interpolate x^2
 * by x, whose mean over uGIMP's domain at a quarter of the cell is 1/4, and s = 1/4 - 1/16. */
START_TEST(one_step_has_the_rate_of_the_place_that_the_form_names)
{
    static const char *const forms[] = {"damping.grid_form=nodes", "damping.grid_form=particles",
                                        "damping.grid_form=particle_rate"};
    static const double spread = 3.0 / 16.0; /* of cells of width 1 */
    static const double rate = 0.01, speed = 0.1;
    const char *const settings[] = {"damping.grid=0.01*x*x", forms[_i],
                                    "bodies.0.velocity=[0.1, 0.1]", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    size_t count;
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, &count);
    test_run_steps(&run, ONE);
    double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    for (size_t k = 0; k < AXES * count; k++) {
        const double at = x[k - k % AXES];
        const double alpha = rate * (at * at + (_i == 2 ? 0.0 : spread));
        ck_assert_near(v[k], speed * (1.0 - STEP * alpha), 1e-15);
    }
    free(x);
    free(v);
    test_run_close(&run);
}
END_TEST

/* USL: the strain of (46)-(57) follows nodes that are not damped, v = 0.1 y: dt 0.1 in xy; that of
 * the nodes' form is of v (1 - alpha dt). */
START_TEST(strain_follows_nodes_that_are_not_damped)
{
    for (int form = 0; form < 2; form++) {
        const char *const settings[] = {
            "damping.grid=0.5", "bodies.0.velocity=['0.1*y', 0]", "method.stress_update=usl",
            form == 0 ? "damping.grid_form=nodes" : "damping.grid_form=particles", NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        size_t count;
        double *const x = test_run_field(&run, MPM_FIELD_POSITION, &count);
        test_run_steps(&run, ONE);
        double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
        const double shear = STEP * 0.1 * (form == 0 ? 1.0 - 0.5 * STEP : 1.0);
        bool inside = false;
        for (size_t p = 0; p < count; p++)
            if (fabs(x[AXES * p + 1] - 5.2) < 0.5) { /* away from edges: sum S y = y */
                ck_assert_near(f[5 * p + 1], shear, 1e-15);
                inside = true;
            }
        ck_assert(inside);
        free(x);
        free(f);
        test_run_close(&run);
    }
}
END_TEST

/* A mirrored block with a mirrored rate and half of it, whose rate is a negative one beyond the
 * plane: images have the rate of their originals. */
START_TEST(a_half_model_is_damped_as_the_whole)
{
    static const char *const forms[] = {"damping.grid_form=nodes", "damping.grid_form=particles",
                                        "damping.grid_form=particle_rate"};
    struct mpm_ledger ledgers[2];
    for (int half = 0; half < 2; half++) {
        const char *const settings[] = {
            "method.shape=bspline2",
            "bodies.0.velocity=['0.05*sin(2*(x-6))', '0.04*cos(y)*cos(x-6)']",
            half ? "damping.grid=0.2*max(x-6, 3*(6-x))" : "damping.grid=0.2*abs(x-6)",
            half ? "bodies.0.region={rectangle: {from: [6, 3.2], to: [9, 7.2]}}"
                 : "bodies.0.region={rectangle: {from: [3, 3.2], to: [9, 7.2]}}",
            half ? "boundary=[{region: {line: {from: [6, 0], to: [6, 12]}}, symmetry: true}]"
                 : "boundary=[]",
            forms[_i],
            NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        test_run_steps(&run, STEPS);
        ledgers[half] = test_run_ledger(&run);
        test_run_close(&run);
    }
    ck_assert(ledgers[0].damping_dissipation > 1e-3);
    ck_assert_near(2.0 * ledgers[1].damping_dissipation, ledgers[0].damping_dissipation,
                   TEST_SOFT_ROUND_OFF);
    ck_assert_near(2.0 * ledgers[1].kinetic_energy, ledgers[0].kinetic_energy, TEST_SOFT_ROUND_OFF);
}
END_TEST

static const char *const both_forms[] = {"damping.grid_form=particles",
                                         "damping.grid_form=particle_rate"};

/* All energy that a body of one velocity loses is booked, and its momentum alone falls. */
START_TEST(what_it_takes_out_is_booked)
{
    const char *const settings[] = {"damping.grid=0.2+0.05*x", both_forms[_i % 2], ways[_i / 2],
                                    "output={energy_balance: true}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    ck_assert(end.damping_dissipation > 0.1 * start.total_energy);
    ck_assert_near(end.total_energy + end.transfer_loss, start.total_energy, TEST_SOFT_ROUND_OFF);
    test_run_close(&run);
}
END_TEST

START_TEST(fast_and_reference_kernels_take_the_same)
{
    char *order = g_strdup_printf("method.stress_update=%s", test_orders[_i / 4]);
    const char *const settings[] = {"damping={grid: '0.2*x', particle: '0.1+0.02*y', pic: 0.95}",
                                    both_forms[_i % 2], ways[_i / 2 % 2], order, NULL};
    const struct kernel_side sides[2] = {
        {settings, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {settings, {.threads = 1, .kernels = MPM_KERNELS_FAST}}};
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    kernel_pair_assert_alike(&pair, KERNEL_PAIR_STEPS);
    kernel_pair_close(&pair);
    g_free(order);
}
END_TEST

START_TEST(any_number_of_threads_takes_the_same_bits)
{
    const char *const settings[] = {TEST_BLOCK_FOR_THREADS, "damping.grid=0.02*x", both_forms[_i],
                                    NULL};
    test_same_bits_over_threads(BLOCK, settings, 20, NULL);
}
END_TEST

static const struct {
    const char *setting, *says;
} failing[] = {
    {"damping={grid: '0.01*x-0.5*t', grid_form: particles}", "damping.grid at the node ("},
    {"damping={grid: '0.01*x-0.5*t', grid_form: particle_rate}", "has damping.grid = -"},
    {"damping={grid: '4*t', grid_form: particles}", "damping.grid is 10"},
};

START_TEST(a_rate_that_goes_astray_fails_the_run)
{
    const char *const settings[] = {failing[_i].setting, NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_error error = {.status = MPM_OK};
    while (mpm_simulation_advance(run.simulation, HUGE_VAL, &error) == MPM_OK)
        ck_assert_uint_lt(mpm_simulation_step(run.simulation), 100);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_msg(strstr(error.message, failing[_i].says) != NULL, "%s", error.message);
    test_run_close(&run);
}
END_TEST

Suite *suite_grid_drag(void)
{
    Suite *suite = suite_create("grid_drag");
    TCase *forms = tcase_create("forms");
    tcase_add_loop_test(forms, damping_at_the_particles_is_that_at_the_nodes_after_extrapolation, 0,
                        EXCHANGES * WAYS * TEST_SHAPES);
    tcase_add_loop_test(forms, the_rate_at_the_particle_is_that_at_the_nodes_where_all_have_one, 0,
                        2 * TEST_ORDERS);
    tcase_add_loop_test(forms, one_step_has_the_rate_of_the_place_that_the_form_names, 0, 3);
    tcase_add_test(forms, strain_follows_nodes_that_are_not_damped);
    tcase_add_loop_test(forms, a_half_model_is_damped_as_the_whole, 0, 3);
    tcase_add_loop_test(forms, what_it_takes_out_is_booked, 0, 4);
    suite_add_tcase(suite, forms);
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, fast_and_reference_kernels_take_the_same, 0, 4 * TEST_ORDERS);
    tcase_add_loop_test(runs, any_number_of_threads_takes_the_same_bits, 0, 2);
    tcase_add_loop_test(runs, a_rate_that_goes_astray_fails_the_run, 0, G_N_ELEMENTS(failing));
    suite_add_tcase(suite, runs);
    return suite;
}
