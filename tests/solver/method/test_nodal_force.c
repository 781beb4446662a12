/* A body force that is taken at the nodes, Notes (22), against one at the particles, (20).
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

static const char BLOCK[] = TEST_SOFT_SCENE(
    "{end: 1000, step: 0.1}",
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2], to: [8, 7.2]}}}\n");
static const double STEP = 0.1;
enum { AXES = 2, STEPS = 30 };

static const char AT_NODES[] = "loads.body_force_at=nodes";

/* sum_i S_ip x_i = x_p: a linear b gives each particle its b(x_p) in the first step, up to the
 * edges; taken at the particles it is smoothed on the way to the nodes and back. */
START_TEST(a_linear_force_accelerates_each_particle_by_its_value)
{
    char *shape = g_strdup_printf("method.shape=%s", test_shapes[_i]);
    for (int nodes = 0; nodes < 2; nodes++) {
        const char *const settings[] = {shape, "loads.body_force=['0.1*x-0.3', '0.2*y+0.1*x']",
                                        nodes ? AT_NODES : "loads.body_force_at=particles", NULL};
        struct test_run run = test_run_open(BLOCK, settings, 1);
        size_t count;
        double *const x = test_run_field(&run, MPM_FIELD_POSITION, &count);
        test_run_steps(&run, 1);
        double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
        double worst = 0.0;
        for (size_t p = 0; p < count; p++) {
            const double *const at = &x[AXES * p];
            worst = fmax(worst, fabs(v[AXES * p] - STEP * (0.1 * at[0] - 0.3)));
            worst = fmax(worst, fabs(v[AXES * p + 1] - STEP * (0.2 * at[1] + 0.1 * at[0])));
        }
        if (nodes)
            ck_assert_near(worst, 0.0, 1e-15);
        else
            ck_assert(worst > 1e-3);
        free(x);
        free(v);
        test_run_close(&run);
    }
    g_free(shape);
}
END_TEST

/* m_i b, with the m_i of axisymmetry. */
START_TEST(a_linear_force_along_z_accelerates_each_particle_by_its_value)
{
    const char *const settings[] = {"geometry=axisymmetric", "loads.body_force=[0, '0.2*z']",
                                    AT_NODES, NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    size_t count;
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, &count);
    test_run_steps(&run, 1);
    double *const v = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    for (size_t p = 0; p < count; p++)
        ck_assert_near(v[AXES * p + 1], STEP * 0.2 * x[AXES * p + 1], 1e-15);
    free(x);
    free(v);
    test_run_close(&run);
}
END_TEST

#define HELD_FLOOR                                                                                 \
    ("boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "                                \
     "velocity: [free, '0.02*sin(2*t)']}]")

/* With each exchange of a step. A force that varies in time alone is the same both ways. */
static const char *const others[] = {
    "damping={grid: 0.2, grid_form: particles, pic: 0.9}",
    HELD_FLOOR,
    "boundary=[{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]",
};
enum { EXCHANGES = TEST_EXCHANGES + G_N_ELEMENTS(others) };

static const char *exchange_of(int index)
{
    return index < TEST_EXCHANGES ? test_exchanges[index] : others[index - TEST_EXCHANGES];
}

START_TEST(a_force_that_does_not_vary_in_space_is_the_same_at_the_nodes)
{
    const struct mpm_simulation_options options = {.threads = 1};
    const char *const uniform[] = {exchange_of(_i), "loads.body_force=[0, '-0.08*cos(3*t)']", NULL};
    const char *const nodal[] = {exchange_of(_i), "loads.body_force=[0, '-0.08*cos(3*t)+0*x']",
                                 AT_NODES, NULL};
    const struct kernel_side sides[2] = {{uniform, options}, {nodal, options}};
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    kernel_pair_assert_alike(&pair, STEPS);
    kernel_pair_assert_same_work(&pair, 0.08 * 20.0, 1.5);
    kernel_pair_close(&pair);
}
END_TEST

START_TEST(its_work_is_in_the_energy)
{
    const char *const settings[] = {exchange_of(_i), "loads.body_force=[0, '-0.05*sin(y)']",
                                    AT_NODES, "output={energy_balance: true}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    ck_assert(fabs(end.external_work) > 1e-4);
    ck_assert_near(end.total_energy + end.transfer_loss - end.external_work, start.total_energy,
                   TEST_SOFT_ROUND_OFF);
    test_run_close(&run);
}
END_TEST

/* Of the half, the force is the mirrored one on its own side of the plane alone. */
START_TEST(a_half_model_has_the_force_of_the_whole)
{
    const char *const whole_settings[] = {
        "loads.body_force=[0, '-0.05*abs(x-6)']", AT_NODES, "method.shape=bspline2",
        "bodies.0.region={rectangle: {from: [3, 3.2], to: [9, 7.2]}}", NULL};
    const char *const half_settings[] = {
        "loads.body_force=[0, '-0.05*(x-6)']",
        AT_NODES,
        "method.shape=bspline2",
        "bodies.0.region={rectangle: {from: [6, 3.2], to: [9, 7.2]}}",
        "boundary=[{region: {line: {from: [6, 0], to: [6, 12]}}, symmetry: true}]",
        NULL};
    struct test_run whole = test_run_open(BLOCK, whole_settings, 1);
    struct test_run half = test_run_open(BLOCK, half_settings, 1);
    test_run_steps(&whole, STEPS);
    test_run_steps(&half, STEPS);
    const struct mpm_ledger all = test_run_ledger(&whole), part = test_run_ledger(&half);
    ck_assert(all.strain_energy > 1e-6);
    ck_assert_near(2.0 * part.kinetic_energy, all.kinetic_energy, TEST_SOFT_ROUND_OFF);
    ck_assert_near(2.0 * part.strain_energy, all.strain_energy, TEST_SOFT_ROUND_OFF);
    ck_assert_near(2.0 * part.external_work, all.external_work, TEST_SOFT_ROUND_OFF);
    test_run_close(&whole);
    test_run_close(&half);
}
END_TEST

START_TEST(fast_and_reference_kernels_have_the_same)
{
    char *order = g_strdup_printf("method.stress_update=%s", test_orders[_i % TEST_ORDERS]);
    char *shape = g_strdup_printf("method.shape=%s", test_shapes[1 + _i / TEST_ORDERS]);
    const char *const settings[] = {order, shape, "loads.body_force=['0.02*y*y', '-0.05*sin(x)']",
                                    AT_NODES, NULL};
    const struct kernel_side sides[2] = {
        {settings, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {settings, {.threads = 1, .kernels = MPM_KERNELS_FAST}}};
    struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    kernel_pair_assert_alike(&pair, STEPS);
    kernel_pair_close(&pair);
    g_free(order);
    g_free(shape);
}
END_TEST

START_TEST(any_number_of_threads_has_the_same_bits)
{
    const char *const settings[] = {TEST_BLOCK_FOR_THREADS, "loads.body_force=[0, '-0.01*sin(x)']",
                                    AT_NODES, NULL};
    test_same_bits_over_threads(BLOCK, settings, 20, NULL);
}
END_TEST

START_TEST(a_force_that_is_not_finite_at_a_node_fails_the_run)
{
    const char *const settings[] = {"loads.body_force=[0, '0.1*sqrt(9.1-x-2*t)']", AT_NODES,
                                    "method.shape=classic", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    struct mpm_error error = {.status = MPM_OK};
    while (mpm_simulation_advance(run.simulation, HUGE_VAL, &error) == MPM_OK)
        ck_assert_uint_lt(mpm_simulation_step(run.simulation), 100);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    ck_assert_msg(strstr(error.message, "the body force at the node (8, ") != NULL, "%s",
                  error.message);
    ck_assert_uint_eq(mpm_simulation_step(run.simulation), 6);
    test_run_close(&run);
}
END_TEST

Suite *suite_nodal_force(void)
{
    Suite *suite = suite_create("nodal_force");
    TCase *values = tcase_create("values");
    tcase_add_loop_test(values, a_linear_force_accelerates_each_particle_by_its_value, 0,
                        TEST_SHAPES);
    tcase_add_test(values, a_linear_force_along_z_accelerates_each_particle_by_its_value);
    tcase_add_loop_test(values, a_force_that_does_not_vary_in_space_is_the_same_at_the_nodes, 0,
                        EXCHANGES);
    tcase_add_loop_test(values, its_work_is_in_the_energy, 0, EXCHANGES);
    tcase_add_test(values, a_half_model_has_the_force_of_the_whole);
    suite_add_tcase(suite, values);
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, fast_and_reference_kernels_have_the_same, 0,
                        TEST_ORDERS * (TEST_SHAPES - 1));
    tcase_add_test(runs, any_number_of_threads_has_the_same_bits);
    tcase_add_test(runs, a_force_that_is_not_finite_at_a_node_fails_the_run);
    suite_add_tcase(suite, runs);
    return suite;
}
