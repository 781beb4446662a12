/* A plate that tractions pull: which methods bring it to rest, how long a run waits for it, and
 * what it advises.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/results.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* A plate that is pulled at both ends and damped, with PIC damping almost all of what nodes do not
 * carry. */
#define PLATE                                                                                      \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [-2, -2], cell: [1, 1], cells: [8, 12]}\n"                                     \
    "time: {end: 2, courant: 0.4, rest: {residual: 1e-6, kinetic_energy: 1e-9, after: 0.1}}\n"     \
    "damping: {grid: 30, pic: 0.1}\n"                                                              \
    "materials: [{name: glass, law: linear_elastic, density: 1e-3, young: 1000, poisson: 0.3}]\n"  \
    "bodies: [{name: plate, material: glass, region: {rectangle: {from: [0, 0], to: [4, 8]}}}]\n"  \
    "output: {energy_balance: true}\n"                                                             \
    "loads:\n"                                                                                     \
    "  tractions:\n"                                                                               \
    "    - {body: plate, edge: top, value: [0, 't<0.1 ? t*10 : 1']}\n"                             \
    "    - {body: plate, edge: bottom, value: [0, 't<0.1 ? -t*10 : -1']}\n"

/* The stretched edges reach nodes of little mass. Where the stress update takes the velocities of
 * the momentum update (USL, USAVG without the second extrapolation), strains follow them into
 * balance. The other orders take velocities extrapolated from the particles, which these nodes
 * hardly change: their forces stay unbalanced, and work of the load goes on being lost there. */
static const struct {
    const char *method;
    bool rests;
} pulled[] = {
    {"{stress_update: usl}", true},   {"{stress_update: usavg, extrapolate: false}", true},
    {"{stress_update: musl}", false}, {"{stress_update: usavg}", false},
    {"{stress_update: usf}", false},
};

START_TEST(a_pulled_plate_comes_to_rest_where_the_strain_follows_all_nodes)
{
    char *const method = g_strdup_printf("method=%s", pulled[_i].method);
    const char *const settings[] = {method, NULL};
    struct test_run run = test_run_open(PLATE, settings, 1);
    while (test_run_ledger(&run).time < 0.6 && !mpm_simulation_at_rest(run.simulation, NULL))
        test_run_steps(&run, 1);
    const struct mpm_ledger early = test_run_ledger(&run);
    test_run_steps(&run, 1000);
    const struct mpm_ledger late = test_run_ledger(&run);
    const double work = late.external_work - early.external_work;
    ck_assert(mpm_simulation_at_rest(run.simulation, NULL) == pulled[_i].rests);
    ck_assert_double_lt(late.kinetic_energy, 1e-9 * late.strain_energy);
    /* the residual squared is the order of the work: 1e-6 and 1e-3 */
    if (pulled[_i].rests)
        ck_assert_double_lt(fabs(work), 1e-6 * late.strain_energy);
    else
        ck_assert_double_gt(work, 1e-3 * late.strain_energy);
    ck_assert_near(late.transfer_loss - early.transfer_loss, work, 1e-6 * late.strain_energy);
    g_free(method);
    test_run_close(&run);
}
END_TEST

/* What a load does to nodes that particles do not follow is no energy of the body. */
START_TEST(the_kinetic_energy_at_rest_is_measured_by_the_energy_of_the_body)
{
    struct test_run run = test_run_open(PLATE, NULL, 1);
    double largest = 0.0;
    struct mpm_rest rest;
    for (int step = 1; step <= 1500; step++) {
        test_run_steps(&run, 1);
        const struct mpm_ledger ledger = test_run_ledger(&run);
        largest =
            fmax(largest, ledger.kinetic_energy + (step % 32 == 0 ? ledger.strain_energy : 0));
    }
    const struct mpm_ledger end = test_run_ledger(&run);
    (void)mpm_simulation_at_rest(run.simulation, &rest);
    ck_assert_near(rest.kinetic_energy * largest, end.kinetic_energy, 1e-12 * end.kinetic_energy);
    test_run_close(&run);
}
END_TEST

START_TEST(patience_ends_when_the_residual_has_not_fallen_by_a_tenth)
{
    enum { PATIENCE = 300 };
    const char *const settings[] = {"time.rest.patience=300", NULL};
    struct test_run run = test_run_open(PLATE, settings, 1);
    struct mpm_rest rest;
    double lowest = HUGE_VAL, fallen = HUGE_VAL;
    int since = 0;
    while (!mpm_simulation_stagnates(run.simulation)) {
        ck_assert_int_lt(since, PATIENCE);
        test_run_steps(&run, 1);
        (void)mpm_simulation_at_rest(run.simulation, &rest);
        if (mpm_simulation_time(run.simulation) < 0.1)
            continue;
        const bool falls = rest.residual < 0.9 * fallen;
        fallen = falls ? rest.residual : fallen;
        lowest = fmin(lowest, rest.residual);
        since = falls ? 0 : since + 1;
        ck_assert(rest.lowest_residual == lowest);
        ck_assert(!falls || rest.fallen_time == mpm_simulation_time(run.simulation));
    }
    ck_assert_int_eq(since, PATIENCE);
    ck_assert_double_lt(lowest, fallen); /* this scene tells them apart */
    test_run_close(&run);
}
END_TEST

/* What may help depends on the method. */
static const struct {
    const char *method, *rest, *advice;
} stagnant[] = {
    {"{stress_update: musl}", "1e-6",
     "with usl it does, and with usavg and extrapolate: false; or "
     "allow a larger residual"},
    {"{stress_update: usl}", "1e-18", "nodes are not balanced: allow a larger residual"},
    {"{stress_update: usavg, extrapolate: false}", "1e-18",
     "nodes are not balanced: allow a larger residual"},
};

START_TEST(a_run_whose_residual_stays_gets_advice_that_helps)
{
    struct mpm_error error = {.status = MPM_OK};
    char *const scene = g_strdup_printf(PLATE "method: %s\n", stagnant[_i].method);
    char **parts = g_strsplit(scene, "residual: 1e-6", 2);
    char *const text =
        g_strdup_printf("%sresidual: %s, patience: 1000%s", parts[0], stagnant[_i].rest, parts[1]);
    test_results_scene(text);
    ck_assert_int_eq(test_results_run(false, &error), MPM_RUN_FAILED);
    ck_assert_msg(g_str_has_prefix(error.message, "not at rest when time.rest.patience is over"),
                  "%s", error.message);
    ck_assert_msg(g_str_has_suffix(error.message, stagnant[_i].advice), "%s", error.message);
    g_strfreev(parts);
    g_free(text);
    g_free(scene);
}
END_TEST

/* Bodies that contact holds: forces at its nodes are in balance with those of contact. Until that
 * is counted, the residual is that of the parts by themselves, about 1/2. */
#define PRESSED                                                                                    \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [-2, 0], cell: [1, 1], cells: [8, 8]}\n"                                       \
    "time: {end: 3, courant: 0.4, rest: {residual: 1e-6, kinetic_energy: 1e-9, after: 0.1}}\n"     \
    "method: {stress_update: usl}\n"                                                               \
    "damping: {grid: 30, pic: 0.1}\n"                                                              \
    "materials: [{name: glass, law: linear_elastic, density: 1e-3, young: 1000, poisson: 0.3}]\n"  \
    "boundary:\n"                                                                                  \
    "  - {region: {line: {from: [-2, 0], to: [6, 0]}}, velocity: [0, 0]}\n"                        \
    "loads: {tractions: [{body: upper, edge: top, value: [0, 't<0.1 ? -t*10 : -1']}]}\n"
#define TWO_BLOCKS                                                                                 \
    "bodies: [{name: lower, material: glass, region: {rectangle: {from: [0, 0], to: [4, 3]}}},\n"  \
    "         {name: upper, material: glass, region: {rectangle: {from: [0, 3], to: [4, 6]}}}]\n"
static const char *const pressed[] = {
    PRESSED TWO_BLOCKS "contact: {fields: bodies, law: interface, tension: 9, shear: 9,\n"
                       "          compression: 800, ratio_limit: 100}\n",
    PRESSED TWO_BLOCKS "contact: {fields: bodies, law: frictionless}\n",
    PRESSED TWO_BLOCKS "contact: {fields: bodies, law: bonded}\n",
    PRESSED "bodies: [{name: upper, material: glass,\n"
            "          region: {rectangle: {from: [0, 0], to: [4, 6]}}}]\n"
            "cracks: [{points: [[-2, 3], [6, 3]], contact: stick}]\n",
};

START_TEST(bodies_that_contact_holds_come_to_rest)
{
    struct test_run run = test_run_open(pressed[_i], NULL, 1);
    struct mpm_rest rest;
    while (mpm_simulation_time(run.simulation) < 3.0 &&
           !mpm_simulation_at_rest(run.simulation, &rest))
        test_run_steps(&run, 1);
    ck_assert_msg(mpm_simulation_at_rest(run.simulation, &rest), "residual %g, kinetic %g",
                  rest.residual, rest.kinetic_energy);
    test_run_close(&run);
}
END_TEST

Suite *suite_rest_loads(void)
{
    Suite *suite = suite_create("rest_loads");
    TCase *plate = tcase_create("plate");
    tcase_add_loop_test(plate, a_pulled_plate_comes_to_rest_where_the_strain_follows_all_nodes, 0,
                        G_N_ELEMENTS(pulled));
    tcase_add_test(plate, the_kinetic_energy_at_rest_is_measured_by_the_energy_of_the_body);
    tcase_add_test(plate, patience_ends_when_the_residual_has_not_fallen_by_a_tenth);
    tcase_add_loop_test(plate, bodies_that_contact_holds_come_to_rest, 0, G_N_ELEMENTS(pressed));
    suite_add_tcase(suite, plate);
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, test_results_set_up, test_results_tear_down);
    tcase_add_loop_test(runs, a_run_whose_residual_stays_gets_advice_that_helps, 0,
                        G_N_ELEMENTS(stagnant));
    suite_add_tcase(suite, runs);
    return suite;
}
