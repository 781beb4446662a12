/* XPIC and FMPM of temperatures: what they are in terms of PIC, held nodes, planes of symmetry,
 * both sets of kernels.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/heat_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static bool is_axisymmetric(int index)
{
    return test_combination(index).axisymmetric;
}

/* ------------------------------------------------------------------ definition */

static double *temperatures(const struct test_run *run)
{
    return mpm_particle_array(&run->simulation->state.particles, MPM_PARTICLE_TEMPERATURE, 0);
}

/* A block at rest without conditions. */
static struct settings free_settings(int index)
{
    const struct test_combination c = test_combination(index);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", c.shape);
    settings_add_formatted(&settings, "geometry=%s", c.geometry);
    settings_add(&settings, "time={end: 1000, step: 0.05}");
    settings_add(&settings, HEAT_BLOCK_AT_REST);
    heat_block_add_wild_heat(&settings, c.axisymmetric);
    return settings;
}

/* Temperatures after a step: of the start if `from` is NULL, else of those. With `bare` nothing
 * flows in. Their number comes in *count. */
static double *step_of(int index, const char *transfer, int order, bool bare, const double *from,
                       size_t *count)
{
    struct settings settings = free_settings(index);
    settings_add_formatted(&settings, "transport.temperature.transfer=%s", transfer);
    if (order > 0)
        settings_add_formatted(&settings, "transport.temperature.order=%d", order);
    if (bare) {
        settings_add(&settings, "materials.soft.conductivity=0");
        settings_add(&settings, "transport.temperature.source=0");
    }
    struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
    *count = run.simulation->state.particles.count;
    if (from != NULL)
        memcpy(temperatures(&run), from, *count * sizeof *from);
    test_run_steps(&run, 1);
    double *const values = g_memdup2(temperatures(&run), *count * sizeof *values);
    test_run_close(&run);
    settings_clear(&settings);
    return values;
}

/* sum over r < order of (1 - P)^r x, P being a bare step of PIC. */
static double *series(int index, int order, const double *x, size_t count)
{
    double *const term = g_memdup2(x, count * sizeof *x);
    double *const sum = g_memdup2(x, count * sizeof *x);
    for (int r = 1; r < order; r++) {
        double *const seen = step_of(index, "pic", 0, true, term, &count);
        for (size_t p = 0; p < count; p++) {
            term[p] -= seen[p];
            sum[p] += term[p];
        }
        g_free(seen);
    }
    g_free(term);
    return sum;
}

enum { ORDERS = 3 };

/* S S+ = P, a bare step of PIC; one with all that flows in, S (v + dt a), is Q. So XPIC(m) gives
 * sum (1 - P)^r P v + Q - P v, and FMPM(k) sum (1 - P)^r Q. */
START_TEST(their_orders_are_a_series_of_steps_of_pic)
{
    for (int order = 1; order <= ORDERS; order++) {
        size_t count;
        double *const bare = step_of(_i, "pic", 0, true, NULL, &count);
        double *const all = step_of(_i, "pic", 0, false, NULL, &count);
        double *const of_start = series(_i, order, bare, count);
        double *const of_end = series(_i, order, all, count);
        double *const xpic = step_of(_i, "xpic", order, false, NULL, &count);
        double *const fmpm = step_of(_i, "fmpm", order, false, NULL, &count);
        for (size_t p = 0; p < count; p++) {
            ck_assert_near(xpic[p], of_start[p] + all[p] - bare[p], HEAT_BLOCK_ROUND_OFF);
            ck_assert_near(fmpm[p], of_end[p], HEAT_BLOCK_ROUND_OFF);
        }
        double *const lists[] = {bare, all, of_start, of_end, xpic, fmpm};
        for (size_t k = 0; k < G_N_ELEMENTS(lists); k++)
            g_free(lists[k]);
    }
}
END_TEST

START_TEST(order_1_is_pic_bit_by_bit)
{
    static const char *const transfers[] = {"xpic", "fmpm"};
    size_t count;
    double *const pic = step_of(_i, "pic", 0, false, NULL, &count);
    for (size_t k = 0; k < G_N_ELEMENTS(transfers); k++) {
        double *const other = step_of(_i, transfers[k], 1, false, NULL, &count);
        ck_assert_mem_eq(pic, other, count * sizeof *pic);
        g_free(other);
    }
    g_free(pic);
}
END_TEST

/* ------------------------------------------------------------------- held nodes */

/* All nodes have 1 + 2 t from the first step on, whatever particles had. */
START_TEST(held_nodes_keep_their_value_in_each_order)
{
    for (int k = 0; k < 2 * HEAT_BLOCK_SETS; k++) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, "transport.temperature.conditions=[{region: all, value: '1+2*t'}]");
        settings_add(&settings, "transport.temperature.start=5");
        heat_block_add_transfer(&settings, 2 + k / HEAT_BLOCK_SETS);
        struct test_run run = heat_block_open(&settings, heat_block_kernels(k % HEAT_BLOCK_SETS));
        const double start = heat_block_heat(&run);
        test_run_steps(&run, 3);
        const double expected = 1.0 + 2.0 * mpm_simulation_time(run.simulation);
        for (size_t p = 0; p < run.simulation->state.particles.count; p++)
            ck_assert_near(temperatures(&run)[p], expected, 1e-12);
        ck_assert_near((heat_block_heat(&run) - start) / start,
                       heat_block_scalar(&run)->totals.held / start, HEAT_BLOCK_ROUND_OFF);
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

/* --------------------------------------------------------------------- symmetry */

/* With a held side that passes the plane. */
START_TEST(a_half_has_half_of_the_heat)
{
    double heat[2], held[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = test_combination_settings(_i % TEST_COMBINATIONS);
        const bool axisymmetric = is_axisymmetric(_i % TEST_COMBINATIONS);
        settings_add(&settings, axisymmetric
                                    ? "transport.temperature.start='sin(3*r)*cos(2*(z-5.6))'"
                                    : "transport.temperature.start='sin(3*x)*cos(2*(y-5.6))'");
        settings_add(&settings, "transport.temperature.conditions=[{region: {line: {from: [3, 0], "
                                "to: [3, 12]}}, value: 2}]");
        settings_add(&settings, "time={end: 1000, step: 0.05}");
        heat_block_add_transfer(&settings, 2 + _i / TEST_COMBINATIONS);
        if (k == 1) {
            settings_add(&settings, "bodies.block.region.rectangle={from: [3, 5.6], to: [9, 8]}");
            settings_add(&settings, "boundary=[{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, "
                                    "symmetry: true}]");
        }
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
        test_run_steps(&run, 10);
        heat[k] = heat_block_heat(&run);
        held[k] = heat_block_scalar(&run)->totals.held;
        test_run_close(&run);
        settings_clear(&settings);
    }
    ck_assert_near(2.0 * heat[1], heat[0], 1e-10);
    ck_assert_near(2.0 * held[1], held[0], 1e-10);
}
END_TEST

/* ------------------------------------------------------------------------ kernels */

/* Beside mechanics, and at rest. */
START_TEST(fast_kernels_have_the_orders_of_reference_kernels)
{
    const int transfer = 2 + _i % 2, index = _i / 4;
    const bool at_rest = _i / 2 % 2 == 1;
    struct settings settings = at_rest ? heat_block_rest_settings(index % HEAT_BLOCK_REST)
                                       : test_combination_settings(index);
    if (at_rest) {
        settings_add(&settings, HEAT_BLOCK_AT_REST);
    } else {
        heat_block_add_wild_heat(&settings, is_axisymmetric(index));
        test_add_wild_velocity(&settings, is_axisymmetric(index));
        settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    }
    heat_block_add_transfer(&settings, transfer);
    const struct kernel_side sides[HEAT_BLOCK_SETS] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(HEAT_BLOCK, sides);
    for (int step = 0; step < KERNEL_PAIR_STEPS; step++)
        ck_assert(kernel_pair_step(&pair));
    if (!test_combination(index).amplifies_round_off)
        ck_assert_msg(kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND, "%s", kernel_pair_text(&pair));
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

/* --------------------------------------------------------------------------- step */

/* 4/(k + 2) of FLIP's; XPIC has FLIP's: kappa = 0.25, cells of 1 by 0.8. */
START_TEST(steps_of_fmpm_are_shorter_the_higher_its_order)
{
    static const double LIMIT = 1.0 / (0.5 * (1.0 + 1.0 / 0.64));
    static const struct {
        const char *transfer;
        int order;
        double part;
    } rows[] = {{"xpic", 6, 1.0}, {"fmpm", 1, 1.0}, {"fmpm", 2, 1.0}, {"fmpm", 6, 0.5}};
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        struct settings settings = {.count = 0};
        settings_add(&settings, HEAT_BLOCK_AT_REST);
        settings_add_formatted(&settings, "transport.temperature={transfer: %s, order: %d}",
                               rows[k].transfer, rows[k].order);
        struct test_run run = heat_block_open(&settings, MPM_KERNELS_AUTO);
        for (int step = 0; step < 2; step++) { /* the first one by the scene, then by the strips */
            test_run_steps(&run, 1);
            ck_assert_near(mpm_simulation_time_step(run.simulation), 0.3 * LIMIT * rows[k].part,
                           1e-12);
        }
        test_run_close(&run);
        settings_clear(&settings);
    }
}
END_TEST

Suite *suite_scalar_smoothing(void)
{
    Suite *const suite = suite_create("scalar_smoothing");
    TCase *const all = tcase_create("every combination");
    tcase_add_loop_test(all, their_orders_are_a_series_of_steps_of_pic, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, order_1_is_pic_bit_by_bit, 0, HEAT_BLOCK_REST);
    tcase_add_loop_test(all, held_nodes_keep_their_value_in_each_order, 0, TEST_COMBINATIONS);
    tcase_add_loop_test(all, a_half_has_half_of_the_heat, 0, 2 * TEST_COMBINATIONS);
    tcase_add_loop_test(all, fast_kernels_have_the_orders_of_reference_kernels, 0,
                        4 * TEST_COMBINATIONS);
    tcase_add_test(all, steps_of_fmpm_are_shorter_the_higher_its_order);
    suite_add_tcase(suite, all);
    return suite;
}
