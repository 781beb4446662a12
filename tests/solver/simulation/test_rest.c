/* Damped motion against its exact decay, rest and the static solution, and what a run reports of
 * it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/results.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A column that stands on y = 0 and cannot grow wide: one dimension, with modulus K + 4/3 G =
 * 2.25 and wave speed 1.5. */
#define COLUMN                                                                                     \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [0, 0], cell: [1, 1], cells: [4, 12]}\n"                                       \
    "time: {end: 500, courant: 0.4}\n"                                                             \
    "materials: [{name: soft, law: linear_elastic, density: 1, bulk: 1.25, shear: 0.75}]\n"        \
    "bodies:\n"                                                                                    \
    "  - {name: column, material: soft, region: {rectangle: {from: [1, 0], to: [3, 10]}},\n"       \
    "     particles_per_cell: [2, 2]}\n"                                                           \
    "boundary:\n"                                                                                  \
    "  - {region: {line: {from: [0, 0], to: [4, 0]}}, velocity: [free, 0]}\n"                      \
    "  - {region: {rectangle: {from: [0, 0], to: [4, 12]}}, velocity: [0, free]}\n"                \
    "output: {history: 20}\n"
static const double WAVE_SPEED = 1.5, LENGTH = 10.0;

/* Body force: strains of up to 4.4e-6. */
static const double WEIGHT = 1e-6;
#define STANDS "loads={body_force: [0, -1e-6]}"

static void run_to(struct test_run *run, double time)
{
    struct mpm_error error = {.message = ""};
    while (mpm_simulation_time(run->simulation) < time)
        ck_assert_msg(mpm_simulation_advance(run->simulation, time, &error) == MPM_OK, "%s",
                      error.message);
}

/* --------------------------------------------------------------- oscillator */

/* The first mode, v = sin(pi y / 2 L), of omega = pi c / 2 L, with x'' + alpha x' + omega^2 x = 0:
 * kinetic and strain energy have fallen by exp(-alpha t) whenever half a damped period has passed.
 * The explicit step adds alpha dt / 2 = 0.25 % to the rate at most; a frequency off by 0.1 %
 * shifts the phase by 0.02 and the energy by alpha / omega 0.02 = 0.4 % of exp(-4). */
START_TEST(an_oscillation_dies_away_at_the_exact_rate)
{
    static const char *const dampings[] = {"damping={grid: 0.05}", "damping={particle: 0.05}",
                                           "damping={grid: '0.02+0*x', particle: 0.03}"};
    const double alpha = 0.05, omega = 0.5 * G_PI * WAVE_SPEED / LENGTH, tolerance = 0.01;
    const double half_period = G_PI / sqrt(omega * omega - 0.25 * alpha * alpha);
    const char *const settings[] = {dampings[_i], "time={end: 500, step: 0.1}",
                                    "method.stress_update=usavg",
                                    "bodies.column.velocity=[0, '0.001*sin(pi*y/20)']", NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    run_to(&run, 6.0 * half_period);
    const struct mpm_ledger end = test_run_ledger(&run);
    const double rate =
        log(start.kinetic_energy / (end.kinetic_energy + end.strain_energy)) / end.time;
    ck_assert_near(rate, alpha, tolerance * alpha);
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------------- energy */

static double energy_left_open(const char *damping, const char *method, const char *time)
{
    const char *const settings[] = {STANDS, damping, method, time, NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    run_to(&run, 10.0);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert(ledger.total_energy ==
              ledger.kinetic_energy + ledger.strain_energy + ledger.damping_dissipation);
    ck_assert(ledger.damping_dissipation > 0.1 * ledger.external_work);
    test_run_close(&run);
    return fabs(ledger.total_energy - ledger.external_work) / ledger.external_work;
}

/* A wall that shakes the column. Its force on the nodes that it drives, with their masses' share,
 * works along its own velocity; particles have that share at the velocity extrapolated to the
 * nodes, which is the wall's but for the first order in the cell, as the share itself is. */
START_TEST(the_work_of_a_wall_that_accelerates_closes_the_balance_at_second_order)
{
    static const char *const refinements[] = {"grid.refine=1", "grid.refine=2", "grid.refine=4"};
    double open[3];
    for (size_t level = 0; level < 3; level++) {
        const char *const settings[] = {"method.stress_update=usavg",
                                        "boundary.0.velocity.1='1e-6*sin(0.3*t)'",
                                        refinements[level], NULL};
        struct test_run run = test_run_open(COLUMN, settings, 1);
        run_to(&run, 10.0);
        const struct mpm_ledger ledger = test_run_ledger(&run);
        open[level] = fabs(ledger.total_energy - ledger.external_work) / ledger.external_work;
        test_run_close(&run);
    }
    for (size_t level = 1; level < 3; level++)
        ck_assert_double_eq_tol(log2(open[level - 1] / open[level]), 2.0, 0.2);
    ck_assert_double_lt(open[2], 1e-3);
}
END_TEST

/* What the orders leave open without damping as well: in MUSL stresses lag behind by the order of
 * the time step; USAVG has second order, with a small part at the step of the sudden load. */
START_TEST(what_damping_takes_out_closes_the_balance_of_energy)
{
    static const char *const dampings[] = {
        "damping={grid: 0.3}", "damping={particle: 0.3}", "damping={grid: '0.03*y', pic: 0.9}",
        "damping={particle: '0.03*y'}", "damping={grid: 0.2, thermostat: {gain: 0.2}}"};
    static const char *const methods[] = {"method={stress_update: musl}",
                                          "method={stress_update: usavg}",
                                          "method={position_update: midpoint}"};
    const char *const damping = dampings[_i / 3], *const method = methods[_i % 3];
    const double coarse = energy_left_open(damping, method, "time={end: 500, step: 0.2}");
    const double fine = energy_left_open(damping, method, "time={end: 500, step: 0.05}");
    if (_i % 3 == 1) {
        ck_assert_double_lt(coarse, 2e-3);
        ck_assert_double_lt(fine, 2e-3);
    } else {
        ck_assert_double_lt(coarse, 0.02);
        ck_assert_double_lt(fine, 0.3 * coarse); /* 1/4 by first order */
    }
}
END_TEST

/* Work that nodes do not know of is counted as lost for output.energy_balance alone. */
START_TEST(what_nothing_measures_is_not_summed)
{
    static const char *const balances[] = {"output.energy_balance=false",
                                           "output.energy_balance=true"};
    const char *const settings[] = {STANDS, "damping={particle: 0.3}", balances[_i], NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    test_run_steps(&run, 5);
    ck_assert((run.simulation->state.energy.lost != 0.0) == (_i == 1));
    test_run_close(&run);
}
END_TEST

/* --------------------------------------------------------------------- rest */

static const char *const dampings[] = {"damping={grid: 0.3}", "damping={particle: 0.3}",
                                       "damping={thermostat: {gain: 0.222, scale: 1.48e-10}}"};
static const char *const shapes[] = {"classic", "ugimp", "cpdi"};
enum { DAMPINGS = G_N_ELEMENTS(dampings), SHAPES = G_N_ELEMENTS(shapes) };
static const double RESIDUAL = 1e-5;
#define RESTS "time.rest={residual: 1e-5, kinetic_energy: 1e-9}"

/* The section at Y, in the column as it was, carries what is above it, since it cannot grow
 * wide: sigma_yy = - rho g (L - Y). Linear shape functions make that constant in each cell, as at
 * its centre. All unbalanced forces are below RESIDUAL times all internal ones: twice the weight
 * 2 rho g L, and the walls' 2 (sigma_xx / sigma_yy = 1/3) rho g L^2 / 2 = 10/3 rho g L; over the
 * width of 2 a section is right to 3.7 RESIDUAL. Where domains do not follow F, in classic and
 * uGIMP, there is the strain beside it. */
START_TEST(a_column_comes_to_rest_under_its_own_weight)
{
    const double strain = WEIGHT * LENGTH / 2.25;
    const double tolerance = (3.7 * RESIDUAL + strain) * WEIGHT * LENGTH;
    char *shape = g_strdup_printf("method.shape=%s", shapes[_i % SHAPES]);
    const char *const settings[] = {STANDS, dampings[_i / SHAPES], shape, RESTS, NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    size_t count;
    double *const from = test_run_field(&run, MPM_FIELD_POSITION, &count);
    struct mpm_rest rest;
    while (!mpm_simulation_at_rest(run.simulation, &rest) && test_run_ledger(&run).time < 500.0)
        test_run_steps(&run, 1);
    ck_assert(mpm_simulation_at_rest(run.simulation, NULL));
    ck_assert_double_lt(rest.residual, RESIDUAL);
    ck_assert_double_lt(rest.kinetic_energy, 1e-9);
    double *const stress = test_run_field(&run, MPM_FIELD_STRESS, NULL);
    for (size_t p = 0; p < count; p++)
        ck_assert_near(stress[4 * p + 1], -WEIGHT * (LENGTH - floor(from[2 * p + 1]) - 0.5),
                       tolerance);
    free(from);
    free(stress);
    g_free(shape);
    test_run_close(&run);
}
END_TEST

/* alpha^2 = gain D / scale, up to the size of a step: alpha dt = 0.12 */
START_TEST(the_thermostat_grows_with_what_it_takes_out)
{
    const char *const settings[] = {STANDS, dampings[2], NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    run_to(&run, 60.0);
    const double rate = run.simulation->state.damping.totals.rate;
    const double dissipated = test_run_ledger(&run).damping_dissipation;
    ck_assert_near(rate * rate, 0.222 * dissipated / 1.48e-10, 0.12 * rate * rate);
    test_run_close(&run);
}
END_TEST

START_TEST(the_thermostat_leads_to_its_target_and_adds_no_energy)
{
    const char *const settings[] = {"damping={thermostat: {gain: 0.05, target: 2e-6, scale: 2e-6}}",
                                    "bodies.column.velocity=[0, '0.001*sin(pi*y/20)']", NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    double before = test_run_ledger(&run).damping_dissipation;
    for (int k = 0; k < 500; k++) {
        test_run_steps(&run, 1);
        const double now = test_run_ledger(&run).damping_dissipation;
        ck_assert(now >= before && run.simulation->state.damping.totals.rate >= 0.0);
        before = now;
    }
    test_run_close(&run);
}
END_TEST

START_TEST(a_body_that_nothing_moves_is_at_rest_after_its_steps_and_not_before_its_time)
{
    const char *const settings[] = {"time={end: 9, step: 0.1, rest: {residual: 0.1, "
                                    "kinetic_energy: 0.1, steps: 5, after: 0.35}}",
                                    NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    struct mpm_rest rest;
    for (int step = 0; step < 8; step++) {
        ck_assert(!mpm_simulation_at_rest(run.simulation, &rest));
        ck_assert(rest.asked && rest.residual == (step == 0 ? 1.0 : 0.0));
        test_run_steps(&run, 1);
    }
    ck_assert(mpm_simulation_at_rest(run.simulation, NULL)); /* 0.4 is the first that counts */
    test_run_close(&run);
}
END_TEST

/* The residual is 0 from the first step on, and cannot fall. */
START_TEST(patience_does_not_end_while_the_residual_is_below_its_bound)
{
    const char *const settings[] = {"time={end: 9, step: 0.1, rest: {residual: 0.1, "
                                    "kinetic_energy: 0.1, steps: 10, patience: 5}}",
                                    NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    for (int step = 0; step < 10; step++) {
        ck_assert(!mpm_simulation_at_rest(run.simulation, NULL));
        ck_assert(!mpm_simulation_stagnates(run.simulation));
        test_run_steps(&run, 1);
    }
    ck_assert(mpm_simulation_at_rest(run.simulation, NULL));
    ck_assert(!mpm_simulation_stagnates(run.simulation));
    test_run_close(&run);
}
END_TEST

/* Particles that still move while nodes are balanced: patience begins anew at the last balance. */
START_TEST(patience_begins_anew_when_the_residual_leaves_its_bound)
{
    enum { PATIENCE = 40 };
    const char *const settings[] = {"time={end: 500, courant: 0.4, rest: {residual: 0.3, "
                                    "kinetic_energy: 1e-12, patience: 40}}",
                                    STANDS, "damping={particle: 0.01}", NULL};
    struct test_run run = test_run_open(COLUMN, settings, 1);
    struct mpm_rest rest;
    double fallen = HUGE_VAL;
    int since = 0, balanced = 0;
    while (!mpm_simulation_stagnates(run.simulation) && mpm_simulation_time(run.simulation) < 400) {
        ck_assert_int_lt(since, PATIENCE);
        test_run_steps(&run, 1);
        (void)mpm_simulation_at_rest(run.simulation, &rest);
        const bool falls = rest.residual < 0.9 * fallen;
        fallen = falls ? rest.residual : fallen;
        balanced += rest.residual < 0.3;
        since = falls || rest.residual < 0.3 ? 0 : since + 1;
    }
    ck_assert_int_gt(balanced, PATIENCE);
    ck_assert(mpm_simulation_stagnates(run.simulation) == (since == PATIENCE));
    test_run_close(&run);
}
END_TEST

/* --------------------------------------------------------- what runs report */

static const char STANDING[] = COLUMN "loads: {body_force: [0, -0.001]}\n";

static void check_record(const char *outcome, const char *reason, int exit_status)
{
    json_t *record = test_results_json("run.json");
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), outcome);
    const char *said = json_string_value(json_object_get(record, "reason"));
    ck_assert_msg(g_str_has_prefix(said, reason), "%s", said);
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), exit_status);
    json_decref(record);
}

static void use_scene(const char *time, const char *damping)
{
    char **parts = g_strsplit(STANDING, "time: {end: 500, courant: 0.4}\n", 2);
    char *text = g_strdup_printf("%stime: %s\n%sdamping: %s\n", parts[0], time, parts[1], damping);
    test_results_scene(text);
    g_free(text);
    g_strfreev(parts);
}

static char *history_head(void)
{
    char *path = test_folder_path(test_results.output, "history.csv");
    char *text = test_file_read(path);
    *strchr(text, '\n') = '\0';
    g_free(path);
    return text;
}

START_TEST(a_run_at_rest_is_done_and_says_so)
{
    use_scene("{end: 500, rest: {residual: 1e-3, kinetic_energy: 1e-6}}", "{particle: 0.3}");
    test_results_run_well();
    check_record("done", "at rest", 0);
    char *head = history_head();
    ck_assert(g_str_has_suffix(head, "j_min,j_max,damping_dissipation"));
    g_free(head);
    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    ck_assert_uint_eq(json_array_size(files), 2);
    struct test_snapshot last = test_results_listed(files, 1);
    ck_assert(last.time > 20.0 && last.time < 400.0);
    test_snapshot_free(&last);
    json_decref(list);
}
END_TEST

static const char *const unrested[][2] = {
    {"{end: 30, rest: {residual: 1e-3, kinetic_energy: 1e-6}}",
     "not at rest when time.end reached, at step 113, time 30: residual "},
    {"{end: 30, steps: 20, rest: {residual: 1e-3, kinetic_energy: 1e-6}}",
     "not at rest when time.steps taken, at step 20, "},
    {"{end: 30, rest: {residual: 1e-3, kinetic_energy: 1e-6, patience: 5}}",
     "not at rest when time.rest.patience is over, at step "},
};

static const char *const unrested_advice[] = {
    "damp more, or run longer",
    "the residual still falls: run longer, or damp more",
    "damp more, or give time.rest.patience more steps",
};

START_TEST(a_run_that_ends_without_rest_has_failed_with_its_last_state_written)
{
    struct mpm_error error = {.status = MPM_OK};
    use_scene(unrested[_i][0], "{particle: 0.01}");
    ck_assert_int_eq(test_results_run(false, &error), MPM_RUN_FAILED);
    ck_assert_msg(g_str_has_prefix(error.message, unrested[_i][1]), "%s", error.message);
    ck_assert_ptr_nonnull(strstr(error.message, "allowed: below 0.001 and 1e-06 for 10 steps"));
    ck_assert_ptr_nonnull(strstr(error.message, "the residual was lowest at time "));
    ck_assert_msg(g_str_has_suffix(error.message, unrested_advice[_i]), "%s", error.message);
    check_record("failed", unrested[_i][1], MPM_RUN_FAILED);
    json_t *files = NULL;
    json_t *list = test_results_series(&files);
    struct test_snapshot last = test_results_listed(files, json_array_size(files) - 1);
    ck_assert(_i != 0 || last.time == 30.0);
    test_snapshot_free(&last);
    json_decref(list);
}
END_TEST

START_TEST(a_scene_that_does_not_damp_has_no_column_of_it)
{
    static const char *const idle[] = {"{}", "{grid: 0, particle: 0.0, pic: 1}"};
    use_scene("{end: 1}", idle[_i]);
    test_results_run_well();
    char *head = history_head();
    ck_assert(g_str_has_suffix(head, "j_min,j_max"));
    g_free(head);
}
END_TEST

static const char *const refused[][2] = {
    {"{end: 9, rest: {residual: 0, kinetic_energy: 0.1}}", "time.rest.residual: out of range"},
    {"{end: 9, rest: {residual: 0.1, kinetic_energy: 2}}", "time.rest.kinetic_energy: out of"},
    {"{end: 9, rest: {residual: 0.1}}", "time.rest.kinetic_energy: missing"},
    {"{end: 9, rest: {residual: .nan, kinetic_energy: 0.1}}", "time.rest.residual: not a number"},
    {"{end: 9, rest: {residual: 0.1, kinetic_energy: 0.1, steps: 0}}", "time.rest.steps: out of"},
    {"{end: 9, rest: {residual: 0.1, kinetic_energy: 0.1, after: 9}}",
     "rest is tested from 9 on, and the run ends at 9"},
    {"{end: 9, rest: {residual: 0.1, kinetic_energy: 0.1, velocity: 1}}", "unknown key"},
};

START_TEST(rest_that_cannot_be_is_refused)
{
    char *setting = g_strdup_printf("time=%s", refused[_i][0]);
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", COLUMN);
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.status = MPM_OK};
    const char *const settings[] = {setting};
    ck_assert_int_eq(mpm_scene_read(path, settings, 1, &scene, &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, refused[_i][1]) != NULL, "%s", error.message);
    test_folder_remove(folder);
    g_free(path);
    g_free(setting);
}
END_TEST

Suite *suite_rest(void)
{
    Suite *suite = suite_create("rest");
    TCase *motion = tcase_create("motion");
    tcase_add_loop_test(motion, an_oscillation_dies_away_at_the_exact_rate, 0, 3);
    tcase_add_test(motion, the_work_of_a_wall_that_accelerates_closes_the_balance_at_second_order);
    tcase_add_loop_test(motion, what_damping_takes_out_closes_the_balance_of_energy, 0, 15);
    tcase_add_loop_test(motion, a_column_comes_to_rest_under_its_own_weight, 0, DAMPINGS * SHAPES);
    tcase_add_loop_test(motion, what_nothing_measures_is_not_summed, 0, 2);
    tcase_add_test(motion, the_thermostat_grows_with_what_it_takes_out);
    tcase_add_test(motion, the_thermostat_leads_to_its_target_and_adds_no_energy);
    tcase_add_test(motion,
                   a_body_that_nothing_moves_is_at_rest_after_its_steps_and_not_before_its_time);
    tcase_add_test(motion, patience_does_not_end_while_the_residual_is_below_its_bound);
    tcase_add_test(motion, patience_begins_anew_when_the_residual_leaves_its_bound);
    tcase_add_loop_test(motion, rest_that_cannot_be_is_refused, 0, G_N_ELEMENTS(refused));
    suite_add_tcase(suite, motion);
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, test_results_set_up, test_results_tear_down);
    tcase_add_test(runs, a_run_at_rest_is_done_and_says_so);
    tcase_add_loop_test(runs, a_run_that_ends_without_rest_has_failed_with_its_last_state_written,
                        0, G_N_ELEMENTS(unrested));
    tcase_add_loop_test(runs, a_scene_that_does_not_damp_has_no_column_of_it, 0, 2);
    suite_add_tcase(suite, runs);
    return suite;
}
