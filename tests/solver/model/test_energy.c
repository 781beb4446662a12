/* The guard of the total energy: what it stops, what it lets go on, where it leaves a run that it
 * stops; the bound that it evaluates first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A free block that is stretched along x and squeezed along y. */
static const char BLOCK[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [14, 14]}\n"
    "time: {end: 10, courant: 1}\n"
    "method: {shape: ugimp, stress_update: usl, transfer: {kind: flip}}\n"
    "materials: [{name: m, law: neo_hookean, density: 1, young: 10, poisson: 0.3}]\n"
    "bodies:\n"
    "  - {name: b, material: m, particles_per_cell: [2, 2], velocity: ['0.5*(x-6)', "
    "'-0.3*(y-6)'],\n"
    "     region: {rectangle: {from: [4, 4], to: [8, 8]}}}\n";

enum { SETTINGS = 4 };
static const double LIMIT = 10.0, END = 10.0; /* as mpm.h promises; as the scene has it */

/* 1 + (E - W - E_0)/(E_0 + largest W) of the ledger; `largest` is kept from call to call. */
static double factor_of(const struct test_run *run, double start, double *largest)
{
    const struct mpm_ledger ledger = test_run_ledger(run);
    *largest = fmax(*largest, ledger.external_work);
    return 1.0 + (ledger.total_energy - ledger.external_work - start) / (start + *largest);
}

/* Advances to the end or a failure, judging each step or none; the largest factor seen. */
static enum mpm_status go(struct test_run *run, double end, bool judged, double *most,
                          struct mpm_error *error)
{
    const double start = test_run_ledger(run).total_energy;
    enum mpm_status status = MPM_OK;
    double largest = 0.0;
    *most = 0.0;
    while (status == MPM_OK && mpm_simulation_time(run->simulation) < end) {
        status = mpm_simulation_advance(run->simulation, end, error);
        if (status == MPM_OK && judged)
            status = mpm_simulation_judge(run->simulation, error);
        *most = fmax(*most, factor_of(run, start, &largest));
    }
    return status;
}

/* --------------------------------------------------------------- blown up */

#define SETTING(name, shape) "method.shape=" name,
static const char *const shapes[] = {MPM_SHAPES(SETTING)};
#undef SETTING
static const char *const orders[] = {"method.stress_update=usl", "method.stress_update=musl",
                                     "method.stress_update=usf", "method.stress_update=usavg"};
static const char *const transfers[] = {
    "method.transfer={kind: flip}", "method.transfer={kind: flip, fraction: 0.5}",
    "method.transfer={kind: xpic, order: 3}", "method.transfer={kind: fmpm, order: 4}",
    "method.transfer={kind: apic}"};
enum { SHAPES = MPM_SHAPE_COUNT, ORDERS = 4, TRANSFERS = 5 };

/* At Courant number 1 some of these blow up; what has been judged sound is. */
START_TEST(no_run_goes_on_with_more_than_ten_times_its_energy)
{
    const char *const settings[SETTINGS] = {shapes[_i % SHAPES], orders[_i / SHAPES % ORDERS],
                                            transfers[_i / SHAPES / ORDERS], NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    double most;
    const enum mpm_status status = go(&run, END, true, &most, &error);
    ck_assert_msg(most <= LIMIT, "%s %s %s: %g", settings[0], settings[1], settings[2], most);
    ck_assert(status == MPM_OK ? error.cause == MPM_CAUSE_NONE : error.cause != MPM_CAUSE_NONE);
    test_run_close(&run);
}
END_TEST

START_TEST(a_run_whose_strain_energy_blows_up_fails_for_its_energy)
{
    for (int judged = 0; judged < 2; judged++) {
        struct mpm_error error = {0};
        struct test_run run = test_run_open(BLOCK, NULL, 1);
        double most;
        ck_assert_int_eq(go(&run, END, judged == 1, &most, &error), MPM_RUN_FAILED);
        ck_assert_int_eq(error.cause, MPM_CAUSE_ENERGY);
        ck_assert_msg(strstr(error.message, "unstable in energy at step 7,") == error.message, "%s",
                      error.message);
        ck_assert_uint_eq(mpm_simulation_step(run.simulation), 6);
        double largest = 0.0;
        const double left = factor_of(&run, 3.57, &largest);
        ck_assert_msg(left <= LIMIT, "the last good state has %g times its energy", left);
        test_run_close(&run);
    }
}
END_TEST

/* In whatever step the evaluation falls that finds it. */
START_TEST(the_last_good_state_is_that_before_the_energy_was_too_large_to_the_bit)
{
    struct mpm_error error = {0};
    struct test_run failed = test_run_open(BLOCK, NULL, 1), good = test_run_open(BLOCK, NULL, 1);
    double most;
    ck_assert_int_eq(go(&failed, END, false, &most, &error), MPM_RUN_FAILED);
    while (mpm_simulation_step(good.simulation) < mpm_simulation_step(failed.simulation))
        ck_assert_int_eq(mpm_simulation_advance(good.simulation, END, NULL), MPM_OK);
    ck_assert(test_run_same_bits(&failed, &good));
    ck_assert_int_eq(mpm_simulation_judge(good.simulation, NULL), MPM_OK);
    ck_assert_int_eq(mpm_simulation_judge(failed.simulation, &error), MPM_RUN_FAILED);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

/* Its particles are inverted at step 36; long before, its energy was too large. */
START_TEST(a_run_that_breaks_after_its_energy_blew_up_says_so_and_goes_back_before_it)
{
    static const char *const settings[] = {"time={end: 10, courant: 2.5, allow_unstable: true}",
                                           "method.stress_update=musl", NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const double start = test_run_ledger(&run).total_energy;
    double most, largest = 0.0;
    ck_assert_int_eq(go(&run, END, false, &most, &error), MPM_RUN_FAILED);
    ck_assert(factor_of(&run, start, &largest) <= LIMIT);
    test_run_close(&run);
}
END_TEST

/* ---------------------------------------------------------------- growing */

START_TEST(a_run_whose_energy_grows_and_stays_bounded_goes_on_and_tells)
{
    static const char *const settings[] = {"method.shape=classic", "method.stress_update=musl",
                                           NULL};
    struct mpm_error error = {0};
    struct mpm_energy_growth growth;
    struct test_run run = test_run_open(BLOCK, settings, 1);
    double most;
    ck_assert(!mpm_simulation_energy_growth(run.simulation, &growth) && !growth.seen);
    ck_assert_int_eq(go(&run, END, true, &most, &error), MPM_OK);
    ck_assert(mpm_simulation_energy_growth(run.simulation, &growth) && growth.seen);
    ck_assert(most > 1.5 && most < LIMIT);
    const double noise = 1e-10; /* 1e-12 m c^2, which the guard adds, over the energy */
    ck_assert_near(growth.largest, most, noise * most);
    ck_assert(growth.step > 0 && growth.time > 0.0 && growth.time < END);
    test_run_close(&run);
}
END_TEST

/* A wall that moves to and fro works with both signs on a block at rest; a load that is taken away
 * again; a body that presses itself: all are what was put in. */
static const struct {
    const char *name, *settings[SETTINGS];
} sound[] = {
    {"a wall to and fro",
     {"bodies.b.velocity=[0, 0]", "boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, "
                                  "velocity: ['0.3*sin(3*t)', free]}]"}},
    {"a fast wall that starts at once",
     {"bodies.b.velocity=[0, 0]",
      "boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, velocity: [0.3, free]}]"}},
    {"a load to and fro", {"bodies.b.velocity=[0, 0]", "loads={body_force: ['0.5*sin(2*t)', 0]}"}},
    {"a wall that takes the energy out",
     {"boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, velocity: ['-0.3*exp(-t)', 0]}]"}},
    {"a load on a block at rest",
     {"bodies.b.velocity=[0, 0]", "loads={body_force: [0.05, 0]}",
      "boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, velocity: [0, free]}]"}},
#define SUDDEN_WALL                                                                                \
    "bodies.b.velocity=[0, 0]",                                                                    \
        "boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, velocity: [0.1, free]}]"
    {"a wall that starts at once", {SUDDEN_WALL}},
    {"a wall that starts at once, USL", {SUDDEN_WALL, "method.stress_update=usl"}},
    {"a wall that starts at once, MUSL", {SUDDEN_WALL, "method.stress_update=musl"}},
    {"a wall that starts at once, USF", {SUDDEN_WALL, "method.stress_update=usf"}},
    {"a damped block", {"damping={grid: 0.5}"}},
    {"a block at rest", {"bodies.b.velocity=[0, 0]"}},
};
enum { SOUND = sizeof sound / sizeof sound[0] };

START_TEST(work_of_either_sign_is_no_growth)
{
    const char *settings[SETTINGS + 2] = {"time={end: 10, courant: 0.4}",
                                          "method.stress_update=usavg"};
    for (int k = 0; k < SETTINGS - 1; k++)
        settings[k + 2] = sound[_i].settings[k];
    struct mpm_error error = {0};
    struct mpm_energy_growth growth;
    struct test_run run = test_run_open(BLOCK, settings, 1);
    double most;
    ck_assert_msg(go(&run, END, true, &most, &error) == MPM_OK, "%s: %s", sound[_i].name,
                  error.message);
    ck_assert_msg(!mpm_simulation_energy_growth(run.simulation, &growth), "%s: %g", sound[_i].name,
                  growth.largest);
    test_run_close(&run);
}
END_TEST

/* The ends of a block at rest are pulled at once, one of them or a node is, or a rigid body goes
 * along its side: the first steps strain what does no work yet. In small motion, for which the
 * limits of methods hold. */
static const char *const sudden[] = {
    "boundary=[{region: {line: {from: [0, 8], to: [14, 8]}}, velocity: [0, 0.003]}, "
    "{region: {line: {from: [0, 4], to: [14, 4]}}, velocity: [0, -0.003]}]",
    "boundary=[{region: {line: {from: [4, 0], to: [4, 14]}}, velocity: [-0.003, 0.002]}]",
    "boundary=[{region: {rectangle: {from: [6, 6], to: [6.1, 6.1]}}, velocity: [0.002, 0.002]}]",
    "bodies=[{name: b, material: m, region: {rectangle: {from: [4, 4], to: [8, 8]}}}, "
    "{name: r, rigid: {velocity: [0.003, free]}, region: {rectangle: {from: [3, 3], to: [4, 9]}}}]",
};
static const double courants[] = {0.3, 0.5, 0.7, 0.9, 1.0};
enum { SUDDEN = G_N_ELEMENTS(sudden), COURANTS = G_N_ELEMENTS(courants), FEW_STEPS = 12 };

START_TEST(a_condition_that_starts_at_once_is_no_growth)
{
    char *const time =
        g_strdup_printf("time={end: 10, courant: %g}", courants[_i / SUDDEN % COURANTS]);
    const char *const order = orders[_i / SUDDEN / COURANTS];
    for (int shape = 0; shape < SHAPES; shape++) {
        const char *const settings[] = {
            time, order, "bodies.b.velocity=[0, 0]", shapes[shape], sudden[_i % SUDDEN], NULL};
        struct mpm_energy_growth growth;
        struct test_run run = test_run_open(BLOCK, settings, 1);
        const struct mpm_stability stability = mpm_scene_stability(run.scene);
        if (courants[_i / SUDDEN % COURANTS] <= stability.small) /* else growth is what it is */
            for (int step = 0; step < FEW_STEPS; step++) {
                test_run_steps(&run, 1);
                ck_assert_int_eq(mpm_simulation_judge(run.simulation, NULL), MPM_OK);
            }
        ck_assert_msg(!mpm_simulation_energy_growth(run.simulation, &growth),
                      "%s %s %s %s: %g at step %d", time, order, shapes[shape], sudden[_i % SUDDEN],
                      growth.largest, (int)growth.step);
        test_run_close(&run);
    }
    g_free(time);
}
END_TEST

/* What a condition may put in at once does not hide a run that blows up. */
START_TEST(a_driven_block_beyond_its_limit_fails_for_its_energy)
{
    const char *const settings[] = {"time={end: 100, courant: 1}", "bodies.b.velocity=[0, 0]",
                                    sudden[_i], NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    double most;
    ck_assert_int_eq(go(&run, 100.0, true, &most, &error), MPM_RUN_FAILED);
    ck_assert_msg(error.cause == MPM_CAUSE_ENERGY, "%s", error.message);
    test_run_close(&run);
}
END_TEST

/* Two blocks that spin, joined by an interface: normals that follow the stairs of the particles,
 * and a stiffness of 500 in shear, of which they take a part for the opening, make 20 times the
 * energy put in. The ledger has it as dissipation of -20 times, and a total that falls. */
START_TEST(energy_that_contact_makes_is_not_balanced_by_a_negative_dissipation)
{
    static const char *const settings[] = {
        "grid={origin: [-12, -12], cell: [1, 1], cells: [24, 24]}",
        "time={end: 150, courant: 0.4}",
        "method.stress_update=usavg",
        "materials=[{name: a, law: neo_hookean, density: 1, young: 10, poisson: 0.2}, "
        "{name: b, law: neo_hookean, density: 1, young: 10, poisson: 0.2}]",
        "bodies=[{name: a, material: a, region: {rectangle: {from: [-6, -2], to: [0, 2]}}, "
        "velocity: ['-0.02*y', '0.02*x']}, {name: b, material: b, "
        "region: {rectangle: {from: [0, -2], to: [6, 2]}}, velocity: ['-0.02*y', '0.02*x']}]",
        "contact={law: interface, tension: 0.05, compression: 0.05, shear: 500, normal: average, "
        "ratio_limit: 10000}",
        NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const double start = test_run_ledger(&run).total_energy;
    double most;
    ck_assert_int_eq(go(&run, 150.0, false, &most, &error), MPM_RUN_FAILED);
    ck_assert_msg(error.cause == MPM_CAUSE_ENERGY, "%s", error.message);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_double_lt(ledger.contact_dissipated, -start);
    ck_assert_double_lt(ledger.total_energy, start);
    test_run_close(&run);
}
END_TEST

START_TEST(strain_energy_that_a_caller_gives_is_put_in)
{
    static const char *const settings[] = {"time={end: 10, courant: 0.4}",
                                           "method.stress_update=usavg", "bodies.b.velocity=[0, 0]",
                                           NULL};
    struct mpm_error error = {0};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const size_t count = mpm_simulation_particle_count(run.simulation);
    double *const f = calloc(5 * count, sizeof *f);
    for (size_t p = 0; f != NULL && p < count; p++) {
        f[5 * p] = 0.8;
        f[5 * p + 3] = f[5 * p + 4] = 1.0;
    }
    ck_assert_int_eq(mpm_simulation_set_start(run.simulation, NULL, f, &error), MPM_OK);
    double most;
    ck_assert_msg(go(&run, END, true, &most, &error) == MPM_OK, "%s", error.message);
    ck_assert(most < 1.2);
    free(f);
    test_run_close(&run);
}
END_TEST

/* --------------------------------------------------------------- no number */

static const struct {
    const char *settings[SETTINGS], *says;
} endless[] = {
    {{"bodies.b.velocity.0=1e200"}, "kinetic energy is inf"},
    {{"bodies.b.velocity.0=1e154", "materials.m.density=1e300"}, "is inf"},
    {{"materials.m={name: m, law: neo_hookean, density: 1e-200, young: 1e200, poisson: 0.3}"},
     "speed of waves is inf"},
    {{"time.end=1e308"}, "time.end: 1e+308 takes more than 9.01e+15 time steps"},
};
enum { ENDLESS = sizeof endless / sizeof endless[0] };

START_TEST(a_start_that_is_no_number_or_has_no_end_is_refused)
{
    size_t settings = 0;
    while (settings < SETTINGS && endless[_i].settings[settings] != NULL)
        settings++;
    char *folder = test_folder_create(), *path = test_folder_write(folder, "block.yaml", BLOCK);
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {0};
    ck_assert_msg(mpm_scene_read(path, endless[_i].settings, settings, &scene, &error) == MPM_OK,
                  "%s", error.message);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_BAD_INPUT);
    test_contains(error.message, endless[_i].says);
    mpm_scene_free(scene);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_number_of_steps_takes_the_place_of_an_end_that_is_never_reached)
{
    static const char *const settings[] = {"time={end: 1e308, courant: 0.4, steps: 3}", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    test_run_steps(&run, 3);
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------------- bound */

static double random_number(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 16777216.0 - 0.5;
}

/* Small strains: the bound leaves out terms of third order, and adds G e^2 / 6 of K e^2 / 2. */
START_TEST(the_bound_is_not_below_the_energy_and_near_it_at_small_strains)
{
    static const struct mpm_material_law *const laws[] = {&mpm_neo_hookean, &mpm_linear_elastic};
    static const double moduli[] = {[MPM_PARAMETER_BULK] = 2.0, [MPM_PARAMETER_SHEAR] = 1.0};
    static const double sizes[] = {1e-3, 0.1, 0.5, 0.9};
    enum { TRIES = 2000 };
    const struct mpm_material material = mpm_material_make(laws[_i % 2], 1.0, moduli, NULL);
    const double size = sizes[_i / 2];
    unsigned seed = 1;
    for (int k = 0; k < TRIES; k++) {
        double f[MPM_GRADIENT_SIZE], mass = 1.0 + random_number(&seed);
        double *component[MPM_GRADIENT_SIZE];
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++) {
            f[i] = size * 2.0 * random_number(&seed);
            component[i] = &f[i];
        }
        for (int i = 0; i < 3; i++)
            f[(const int[]){MPM_XX, MPM_YY, MPM_ZZ}[i]] += 1.0;
        if (!(mpm_determinant(f) > 1e-3) || !(f[MPM_ZZ] > 0.0))
            continue;
        const double energy = mass * material.law->energy(&material, f, NULL);
        const double bound = material.law->energy_bound(&material, component, &mass, 0, 1);
        const double round_off = 1e-14;
        ck_assert_msg(bound >= energy * (1.0 - 1e-12) - round_off, "%g %g", bound, energy);
        if (size <= 0.1)
            ck_assert_msg(bound <= 1.5 * energy + round_off, "%g %g", bound, energy);
    }
}
END_TEST

Suite *suite_energy(void)
{
    Suite *const suite = suite_create("energy");
    TCase *const tests = tcase_create("energy");
    tcase_add_loop_test(tests, no_run_goes_on_with_more_than_ten_times_its_energy, 0,
                        SHAPES * ORDERS * TRANSFERS);
    tcase_add_test(tests, a_run_whose_strain_energy_blows_up_fails_for_its_energy);
    tcase_add_test(tests, the_last_good_state_is_that_before_the_energy_was_too_large_to_the_bit);
    tcase_add_test(tests,
                   a_run_that_breaks_after_its_energy_blew_up_says_so_and_goes_back_before_it);
    tcase_add_test(tests, a_run_whose_energy_grows_and_stays_bounded_goes_on_and_tells);
    tcase_add_loop_test(tests, work_of_either_sign_is_no_growth, 0, SOUND);
    tcase_add_loop_test(tests, a_condition_that_starts_at_once_is_no_growth, 0,
                        SUDDEN * COURANTS * ORDERS);
    tcase_add_loop_test(tests, a_driven_block_beyond_its_limit_fails_for_its_energy, 0, SUDDEN);
    tcase_add_test(tests, energy_that_contact_makes_is_not_balanced_by_a_negative_dissipation);
    tcase_add_test(tests, strain_energy_that_a_caller_gives_is_put_in);
    tcase_add_loop_test(tests, a_start_that_is_no_number_or_has_no_end_is_refused, 0, ENDLESS);
    tcase_add_test(tests, a_number_of_steps_takes_the_place_of_an_end_that_is_never_reached);
    tcase_add_loop_test(tests, the_bound_is_not_below_the_energy_and_near_it_at_small_strains, 0,
                        8);
    suite_add_tcase(suite, tests);
    return suite;
}
