/* Failing runs: they stop, state where, and leave the last good state; and what a scene
 * can only be refused for once it is built.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static const char BAR[] =
    "format: 1\n"
    "title: A bar\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [24, 6]}\n"
    "time: {end: 100, courant: 0.4}\n"
    "method: {shape: ugimp, stress_update: musl}\n"
    "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}]\n"
    "bodies:\n"
    "  - {name: bar, material: rubber, region: {rectangle: {from: [8, 2], to: [16, 4]}},\n"
    "     velocity: ['0.2*sin(x)', 0]}\n";

struct failing {
    const char *name;
    const char *settings[4];
    const char *says[3];
    enum mpm_cause cause; /* none: what ends it depends on the method */
};

static const struct failing failing[] = {
    {"a step far beyond the limit",
     {"time={end: 100, courant: 5, allow_unstable: true}"},
     {"at step", "particle"},
     MPM_CAUSE_NONE},
    {"a huge load",
     {"loads={body_force: [0, -1e6]}"},
     {"step", "particle", "(body 'bar')"},
     MPM_CAUSE_NONE},
    {"a huge load that varies in space, for an affine transfer",
     {"loads={body_force: ['0*x', -1e6]}", "method.transfer.kind=apic"},
     {"step", "particle", "(body 'bar')"},
     MPM_CAUSE_NONE},
    {"a body that flies off",
     {"bodies.bar.velocity=[4, 0]"},
     {"left the grid at step", "is at x = 24", "0 to 24"},
     MPM_CAUSE_LEFT_GRID},
    {"a body crushed by a rigid one",
     {"bodies.0.velocity=[-20, 0]", "boundary=[{region: {line: {from: [8, 0], to: [8, 6]}}, "
                                    "velocity: [0, 0]}]"},
     {"step", "particle"},
     MPM_CAUSE_NONE},
    {"a load that is not finite after a while",
     {"loads={body_force: ['1/(0.5-t)*(t>0.45)+sqrt(0.46-t)', 0]}"},
     {"load not finite at step", "the body force loads.body_force.0", "time 0.4"},
     MPM_CAUSE_LOAD},
    {"a load that varies in space and is not finite after a while",
     {"loads={body_force: ['0*x+sqrt(0.46-t)', 0]}"},
     {"(body 'bar')", "not finite: loads.body_force.0", "time 0.4"},
     MPM_CAUSE_LOAD},
    {"a boundary velocity that is not finite after a while",
     {"boundary=[{region: {line: {from: [8, 0], to: [8, 6]}}, velocity: ['sqrt(0.4-t)', free]}]"},
     {"prescribed value not finite at step", "a boundary"},
     MPM_CAUSE_CONDITION},
    {"a rigid body that leaves",
     {"bodies=[{name: bar, material: rubber, region: {rectangle: {from: [8, 2], to: [16, 4]}}}, "
      "{name: wall, rigid: {velocity: [5, free]}, region: {rectangle: {from: [20, 2], to: [21, "
      "4]}}}]"},
     {"left the grid at step", "rigid body 'wall' left the grid"},
     MPM_CAUSE_LEFT_GRID},
};
enum { FAILING = sizeof failing / sizeof failing[0] };

/* Advances until the run fails; the number of good steps. */
static uint64_t run_until_failure(struct test_run *run, struct mpm_error *error)
{
    for (int k = 0; k < 20000; k++) {
        const enum mpm_status status = mpm_simulation_advance(run->simulation, 100.0, error);
        if (status == MPM_RUN_FAILED)
            return mpm_simulation_step(run->simulation);
        ck_assert_msg(status == MPM_OK, "%s", error->message);
        if (mpm_simulation_time(run->simulation) >= 100.0)
            break;
    }
    ck_abort_msg("the run did not fail");
    return 0;
}

START_TEST(a_run_that_cannot_go_on_says_where_and_why)
{
    const struct failing *const f = &failing[_i];
    struct mpm_error error = {0}, again = {0};
    struct test_run run = test_run_open(BAR, f->settings, 1);
    (void)run_until_failure(&run, &error);
    for (int k = 0; k < 3 && f->says[k] != NULL; k++)
        ck_assert_msg(strstr(error.message, f->says[k]) != NULL, "%s: '%s' is not in: %s", f->name,
                      f->says[k], error.message);
    ck_assert_int_ne(error.cause, MPM_CAUSE_NONE);
    if (f->cause != MPM_CAUSE_NONE)
        ck_assert_int_eq(error.cause, f->cause);
    ck_assert_msg(g_str_has_prefix(error.message, mpm_cause_describe(error.cause)->words), "%s",
                  error.message);
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 100.0, &again), MPM_RUN_FAILED);
    ck_assert_int_eq(again.cause, error.cause);
    ck_assert_str_eq(again.message, error.message);
    test_run_close(&run);
}
END_TEST

START_TEST(after_a_failure_the_state_is_that_of_the_last_good_step_to_the_bit)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT, MPM_FIELD_STRESS};
    static const char *const shapes[] = {"method.shape=classic", "method.shape=ugimp",
                                         "method.shape=cpdi"};
    struct mpm_error error = {0};
    const char *settings[5] = {shapes[_i % 3]};
    for (int k = 0; k < 3; k++)
        settings[k + 1] = failing[_i / 3].settings[k];
    struct test_run failed = test_run_open(BAR, settings, 1);
    struct test_run good = test_run_open(BAR, settings, 1);
    const uint64_t steps = run_until_failure(&failed, &error);
    for (uint64_t k = 0; k < steps; k++)
        ck_assert_int_eq(mpm_simulation_advance(good.simulation, 100.0, &error), MPM_OK);
    ck_assert(mpm_simulation_time(failed.simulation) == mpm_simulation_time(good.simulation));
    for (size_t f = 0; f < sizeof fields / sizeof fields[0]; f++) {
        size_t n;
        double *const one = test_run_field(&failed, fields[f], &n);
        double *const other = test_run_field(&good, fields[f], NULL);
        ck_assert_int_eq(
            memcmp(one, other, n * mpm_field_describe(fields[f])->components * sizeof *one), 0);
        free(one);
        free(other);
    }
    struct mpm_ledger one, other;
    mpm_simulation_ledger(failed.simulation, &one);
    mpm_simulation_ledger(good.simulation, &other);
    ck_assert(one.external_work == other.external_work);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

START_TEST(two_rigid_bodies_may_not_contradict_each_other)
{
    static const char *const settings[] = {
        "bodies=[{name: bar, material: rubber, region: {rectangle: {from: [8, 2], to: [16, 4]}}}, "
        "{name: up, rigid: {velocity: [free, 1]}, region: {rectangle: {from: [8, 0], to: [12, "
        "2]}}}, "
        "{name: down, rigid: {velocity: [free, -1]}, region: {rectangle: {from: [12, 0], to: [16, "
        "2]}}}]",
        NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BAR, settings, 1);
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, &error), MPM_RUN_FAILED);
    ck_assert_ptr_nonnull(strstr(error.message, "'up' and 'down' both drive the node at"));
    test_run_close(&run);
}
END_TEST

/* The wall holds the bar's left end although a rigid body pushes the same nodes. */
START_TEST(boundaries_win_over_rigid_bodies)
{
    static const char *const settings[] = {
        "bodies=[{name: bar, material: rubber, region: {rectangle: {from: [8, 2], to: [16, 4]}}}, "
        "{name: pusher, rigid: {velocity: [1, free]}, region: {rectangle: {from: [6, 2], to: [8, "
        "4]}}}]",
        "boundary=[{region: {rectangle: {from: [5, 0], to: [10, 6]}}, velocity: [0, 0]}]", NULL};
    struct test_run run = test_run_open(BAR, settings, 1);
    struct mpm_ledger ledger;
    test_run_steps(&run, 20);
    mpm_simulation_ledger(run.simulation, &ledger);
    ck_assert_double_eq(ledger.strain_energy, 0.0);
    ck_assert_double_eq(ledger.kinetic_energy, 0.0);
    ck_assert_double_eq(ledger.external_work, 0.0);
    test_run_close(&run);
}
END_TEST

/* sqrt(x) has no value at the ghost nodes x < 0, which continue the edge's condition. */
START_TEST(ghost_nodes_take_the_velocity_of_the_edge)
{
    static const char *const settings[] = {
        "bodies.bar.region.rectangle.from=[0, 2]", "bodies.bar.region.rectangle.to=[4, 4]",
        "bodies.bar.velocity=[-1, 0]",
        "boundary=[{region: {line: {from: [0, 0], to: [0, 6]}}, velocity: ['sqrt(x)', free]}]",
        NULL};
    struct test_run run = test_run_open(BAR, settings, 1);
    test_run_steps(&run, 20);
    test_run_close(&run);
}
END_TEST

START_TEST(steps_land_on_the_limit_and_leave_no_sliver)
{
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BAR, NULL, 1);
    double smallest = 1.0, largest = 0.0;
    for (int target = 1; target <= 20; target++) {
        const double limit = 0.0731 * target;
        while (mpm_simulation_time(run.simulation) < limit) {
            ck_assert_int_eq(mpm_simulation_advance(run.simulation, limit, &error), MPM_OK);
            smallest = fmin(smallest, mpm_simulation_time_step(run.simulation));
            largest = fmax(largest, mpm_simulation_time_step(run.simulation));
        }
        ck_assert(mpm_simulation_time(run.simulation) == limit);
    }
    ck_assert_msg(smallest > 0.4 * largest, "steps from %g to %g", smallest, largest);
    ck_assert_int_eq(mpm_simulation_advance(run.simulation, 0.1, &error), MPM_BAD_INPUT);
    test_run_close(&run);
}
END_TEST

START_TEST(a_fixed_step_is_kept_and_counted)
{
    static const char *const settings[] = {"time={end: 1, step: 0.01}", NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BAR, settings, 1);
    while (mpm_simulation_time(run.simulation) < 1.0) {
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, &error), MPM_OK);
        ck_assert_near(mpm_simulation_time_step(run.simulation), 0.01, 1e-10);
    }
    ck_assert_uint_eq(mpm_simulation_step(run.simulation), 100);
    test_run_close(&run);
}
END_TEST

/* Cell size over wave speed sqrt((K + 4 G / 3) / rho) = 12. */
START_TEST(the_step_follows_courant_number_and_wave_speed)
{
    struct test_run run = test_run_open(BAR, NULL, 1);
    test_run_steps(&run, 1);
    ck_assert_near(mpm_simulation_time_step(run.simulation), 0.4 / 12.0, 1e-15);
    test_run_close(&run);
}
END_TEST

/* v = 0 at a wall, and the wall does no work; a moving wall does. */
START_TEST(a_wall_stops_a_body_and_only_a_moving_one_works)
{
    static const char *const walls[2][3] = {
        {"boundary=[{region: {rectangle: {from: [0, 0], to: [8, 6]}}, velocity: [0, free]}]",
         "bodies.bar.velocity=[-1, 0]"},
        {"boundary=[{region: {rectangle: {from: [0, 0], to: [8, 6]}}, velocity: [0.5, free]}]",
         "bodies.bar.velocity=[0, 0]"}};
    for (int k = 0; k < 2; k++) {
        struct mpm_ledger start, end;
        struct test_run run = test_run_open(BAR, walls[k], 1);
        mpm_simulation_ledger(run.simulation, &start);
        test_run_steps(&run, 30);
        mpm_simulation_ledger(run.simulation, &end);
        ck_assert(end.j_min > 0.2 && end.j_min < 0.99);
        if (k == 0)
            ck_assert_double_eq(end.external_work, 0.0);
        else /* the momentum balance of the driven bar: W = energy gained, to a few percent */
            ck_assert_near(end.external_work, end.total_energy, 0.1 * end.total_energy);
        test_run_close(&run);
    }
}
END_TEST

Suite *suite_guard(void)
{
    Suite *const suite = suite_create("guard");
    TCase *const failures = tcase_create("failures");
    tcase_add_loop_test(failures, a_run_that_cannot_go_on_says_where_and_why, 0, FAILING);
    tcase_add_loop_test(failures,
                        after_a_failure_the_state_is_that_of_the_last_good_step_to_the_bit, 0,
                        3 * FAILING);
    tcase_add_test(failures, two_rigid_bodies_may_not_contradict_each_other);
    tcase_add_test(failures, boundaries_win_over_rigid_bodies);
    tcase_add_test(failures, ghost_nodes_take_the_velocity_of_the_edge);
    suite_add_tcase(suite, failures);
    TCase *const steps = tcase_create("steps");
    tcase_add_test(steps, steps_land_on_the_limit_and_leave_no_sliver);
    tcase_add_test(steps, a_fixed_step_is_kept_and_counted);
    tcase_add_test(steps, the_step_follows_courant_number_and_wave_speed);
    tcase_add_test(steps, a_wall_stops_a_body_and_only_a_moving_one_works);
    suite_add_tcase(suite, steps);
    return suite;
}
