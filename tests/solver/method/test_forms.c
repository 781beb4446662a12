/* The momentum form, USAVG without re-extrapolation, and how scenes with a transfer or form run:
 * threads, failures, kernels.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "support/transfer_block.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ----------------------------------------------------------------------- forms */

/* Eight cells from the edges of the body below: a particle has the same mass at all its nodes, and
 * nothing that edges do in a step comes there. */
static bool is_inside(const double x[2])
{
    return x[0] > 11.0 && x[0] < 13.0 && x[1] > 9.6 && x[1] < 11.2;
}

START_TEST(both_forms_are_one_where_the_nodes_have_one_mass)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT};
    /* and what comes from the edges by the thin ends of cubic splines */
    static const double ROUND_OFF = 1e-12;
    static const char *const kinds[] = {"{kind: flip}", "{kind: pic}", "{fraction: 0.9}"};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(
            &settings, "method={shape: %s, %s, transfer: %s, position_update: %s, form: %s}",
            test_shapes[_i % TEST_SHAPES], block_orders[_i / TEST_SHAPES], kinds[_i % 3],
            _i % 2 == 0 ? "midpoint" : "grid_velocity", k == 0 ? "velocity" : "momentum");
        test_add_wild_velocity(&settings, false);
        settings_add(&settings, "grid.cells=[24, 26]");
        settings_add(&settings, "bodies.block.region.rectangle={from: [3, 3.2], to: [21, 17.6]}");
        settings_add(&settings, "loads={body_force: [0.5, '0.3*x']}");
        runs[k] = block_open(&settings, 1);
    }
    size_t n;
    double *const start = test_run_field(&runs[0], MPM_FIELD_POSITION, &n);
    test_run_steps(&runs[0], 1);
    test_run_steps(&runs[1], 1);
    int inside = 0;
    for (size_t f = 0; f < G_N_ELEMENTS(fields); f++) {
        const size_t components = mpm_field_describe(fields[f])->components;
        double *const one = test_run_field(&runs[0], fields[f], NULL);
        double *const other = test_run_field(&runs[1], fields[f], NULL);
        double edge = 0.0;
        for (size_t k = 0; k < n * components; k++)
            if (is_inside(&start[2 * (k / components)])) {
                ck_assert_near(other[k], one[k], ROUND_OFF);
                inside++;
            } else {
                edge = fmax(edge, fabs(other[k] - one[k]));
            }
        ck_assert(edge > 1e-4); /* where the mass has a slope, the momentum has it too */
        free(one);
        free(other);
    }
    ck_assert_int_ge(inside, 9 * 16);
    free(start);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

START_TEST(usavg_extrapolates_unless_told_otherwise)
{
    static const char *const words[] = {"", ", extrapolate: true", ", extrapolate: false"};
    struct test_run runs[3];
    for (int k = 0; k < 3; k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "method={stress_update: usavg%s}", words[k]);
        test_add_wild_velocity(&settings, false);
        runs[k] = block_open(&settings, 1);
        test_run_steps(&runs[k], 10);
    }
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert(test_run_difference(&runs[0], &runs[2], MPM_FIELD_DEFORMATION_GRADIENT) > 1e-6);
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* --------------------------------------------------------------------- runs */

/* Enough particles for three workers, in several strips. */
START_TEST(any_number_of_threads_gives_the_same_bits)
{
    static const char *const methods[] = {
        "transfer: {kind: xpic, order: 3}",
        "transfer: {kind: fmpm, order: 3}, shape: cpdi, stress_update: usavg",
        "transfer: {kind: apic}, stress_update: usavg",
        "form: momentum, shape: cpdi, transfer: {fraction: 0.9}",
    };
    struct test_run runs[3];
    for (int k = 0; k < 3; k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "method={%s}", methods[_i]);
        settings_add(&settings, "grid.cells=[60, 70]");
        settings_add(&settings, "bodies.block.region.rectangle={from: [3, 3.2], to: [53, 51.2]}");
        settings_add(&settings, "bodies.block.velocity=['sin(y/5)', 'cos(x/4)']");
        settings_add(&settings, "boundary=[{region: {line: {from: [0, 3.2], to: [60, 3.2]}}, "
                                "velocity: [free, '0.1*cos(t)']}]");
        runs[k] = block_open(&settings, k + 1);
        test_run_steps(&runs[k], 6);
    }
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert(test_run_same_bits(&runs[0], &runs[2]));
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* The last good state has the affine part that the next step would have begun with: repeated
 * from the copy after the last sort, past one. */
START_TEST(after_a_failure_the_affine_part_is_that_of_the_last_good_step)
{
    struct mpm_error error = {.message = ""};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = {.count = 0};
        block_add_method(&settings, test_shapes[_i], "stress_update: musl", "{kind: apic}");
        test_add_wild_velocity(&settings, false);
        settings_add(&settings, "loads={body_force: ['0*x+sqrt(1-t)', 0]}");
        runs[k] = block_open(&settings, 1);
    }
    while (mpm_simulation_advance(runs[0].simulation, 100.0, &error) == MPM_OK)
        test_run_steps(&runs[1], 1);
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    const struct mpm_ledger failed = test_run_ledger(&runs[0]), good = test_run_ledger(&runs[1]);
    ck_assert(good.step > (_i == MPM_CLASSIC ? 2 : 40));
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert(failed.angular_momentum == good.angular_momentum);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

START_TEST(what_has_no_fast_kernels_is_refused_with_the_reason)
{
    static const struct {
        const char *setting, *reason;
    } rows[] = {{"method={shape: cpdi, stress_update: musl, transfer: {kind: apic}}",
                 "there are no fast kernels for method.transfer: apic with CPDI"},
                {"method.form=momentum", "there are no fast kernels for method.form: momentum"}};
    const struct mpm_simulation_options fast = {.threads = 1, .kernels = MPM_KERNELS_FAST};
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        struct settings settings = {.count = 0};
        settings_add(&settings, rows[k].setting);
        struct test_run run = block_open(&settings, 1);
        struct mpm_error error = {.message = ""};
        struct mpm_simulation *refused = NULL;
        struct mpm_plan plan;
        ck_assert_str_eq(mpm_simulation_kernels(run.simulation), "reference");
        ck_assert_int_eq(mpm_simulation_create(run.scene, &fast, &refused, &error), MPM_BAD_INPUT);
        ck_assert_ptr_null(refused);
        ck_assert_ptr_nonnull(strstr(error.message, rows[k].reason));
        ck_assert_int_eq(mpm_scene_plan(run.scene, &(struct mpm_simulation_options){.threads = 1},
                                        &plan, &error),
                         MPM_OK);
        ck_assert_str_eq(plan.kernels_reason, rows[k].reason);
        test_run_close(&run);
    }
}
END_TEST

Suite *suite_forms(void)
{
    Suite *const suite = suite_create("forms");
    TCase *const forms = tcase_create("forms");
    tcase_add_loop_test(forms, both_forms_are_one_where_the_nodes_have_one_mass, 0,
                        TEST_SHAPES * BLOCK_ORDERS);
    tcase_add_test(forms, usavg_extrapolates_unless_told_otherwise);
    suite_add_tcase(suite, forms);
    TCase *const runs = tcase_create("runs");
    tcase_add_loop_test(runs, any_number_of_threads_gives_the_same_bits, 0, 4);
    tcase_add_loop_test(runs, after_a_failure_the_affine_part_is_that_of_the_last_good_step, 0,
                        TEST_SHAPES);
    tcase_add_test(runs, what_has_no_fast_kernels_is_refused_with_the_reason);
    suite_add_tcase(suite, runs);
    return suite;
}
