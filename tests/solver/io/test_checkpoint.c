/* Runs that go on from a checkpoint write the bytes of one without interruption.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint/checkpoint.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/results.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>

/* ------------------------------------------------------------- interruptions */

static int64_t steps_left; /* until an interruption; below 0: none comes */

static int interrupted(void)
{
    return steps_left >= 0 && steps_left-- == 0 ? SIGTERM : 0;
}

static enum mpm_status run_into(const char *output, bool resume, int64_t steps, int threads,
                                struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = output,
        .simulation = {.threads = threads},
        .resume = resume,
        .interrupted = interrupted,
    };
    steps_left = steps;
    return mpm_scene_run(test_results.scene, &options, error);
}

static void scene_with(const char *text, const char *const *settings)
{
    struct mpm_error error = {.status = MPM_OK};
    size_t count = 0;
    test_results_scene(text);
    while (settings[count] != NULL)
        count++;
    mpm_scene_free(test_results.scene);
    ck_assert_msg(mpm_scene_read(test_results.scene_path, settings, count, &test_results.scene,
                                 &error) == MPM_OK,
                  "%s", error.message);
}

static gint compare_names(gconstpointer one, gconstpointer other)
{
    return strcmp(*(const char *const *)one, *(const char *const *)other);
}

/* Names of the results but for run.json, checkpoints and the lock, in order; g_strfreev. */
static char **result_names(const char *folder)
{
    GPtrArray *const names = g_ptr_array_new();
    GDir *const directory = g_dir_open(folder, 0, NULL);
    ck_assert(directory != NULL);
    for (const char *name; (name = g_dir_read_name(directory)) != NULL;)
        if (strcmp(name, "run.json") != 0 && !g_str_has_prefix(name, "checkpoint"))
            g_ptr_array_add(names, g_strdup(name));
    g_dir_close(directory);
    g_ptr_array_sort(names, compare_names);
    g_ptr_array_add(names, NULL);
    return (char **)g_ptr_array_free(names, FALSE);
}

static void check_same_file(const char *one, const char *other, const char *name, const char *what)
{
    char *const paths[] = {test_folder_path(one, name), test_folder_path(other, name)};
    char *bytes[2];
    gsize size[2];
    for (int k = 0; k < 2; k++)
        ck_assert_msg(g_file_get_contents(paths[k], &bytes[k], &size[k], NULL), "%s: no %s", what,
                      name);
    ck_assert_msg(size[0] == size[1] && memcmp(bytes[0], bytes[1], size[0]) == 0, "%s: %s differs",
                  what, name);
    for (int k = 0; k < 2; k++) {
        g_free(bytes[k]);
        g_free(paths[k]);
    }
}

static void check_same_results(const char *one, const char *other, const char *what)
{
    char **const names = result_names(one), **const others = result_names(other);
    ck_assert_uint_eq(g_strv_length(names), g_strv_length(others));
    for (size_t k = 0; names[k] != NULL; k++) {
        ck_assert_str_eq(names[k], others[k]);
        check_same_file(one, other, names[k], what);
    }
    g_strfreev(names);
    g_strfreev(others);
}

/* What they conduct differs from place to place. */
#define CONDUCTING                                                                                 \
    TEST_BLOCKS_CONDUCTING, "transport.temperature.start=x", "transport.concentration.start=y/10"

/* Scenes of which each has a state of its own kind. */
static const struct kind {
    const char *name;
    const char *settings[12];
} kinds[] = {
    {"two blocks", {NULL}},
    /* the order after a sort is another than that of creation, and strips reach other nodes */
    {"particles that change cells in strips",
     {"bodies.left.velocity=[\"-2*(y-3.5)\", \"2*(x-3.5)\"]", "grid.refine=4", "time.end=0.4"}},
    {"affine motion", {"method.transfer={kind: apic}"}},
    {"a thermostat", {"damping={thermostat: {gain: 1}}"}},
    {"the balance of energies", {"damping={grid: 1, particle: 0.5}", "output.energy_balance=true"}},
    {"work from outside", {"loads={body_force: [1, 0.5]}"}},
    {"domains", {"method.shape=cpdi"}},
    {"plastic strain",
     {"materials.rubber={name: rubber, law: von_mises, density: 1, bulk: 200, shear: 100, "
      "yield_stress: 1}"}},
    {"conduction", {CONDUCTING}},
    {"conduction that waits",
     {CONDUCTING, "transport.every=7", "materials.rubber.thermal_expansion=1e-3",
      "materials.rubber.stress_free_temperature=0"}},
    /* F_zz is found by iteration, from the one before it: stress does not follow from F again */
    {"plane stress that follows temperature",
     {"geometry=plane_stress", CONDUCTING, "materials.rubber.thermal_expansion=1e-3",
      "materials.rubber.stress_free_temperature=-3"}},
    {"contact",
     {"bodies.left.velocity=[4, 0]", "contact={fields: bodies, law: friction, friction: 0.3}"}},
    {"an interface",
     {"bodies.left.velocity=[4, 0]",
      "contact={fields: bodies, law: interface, tension: 10, compression: 10, shear: 5}"}},
    {"plastic work that heats and softens",
     {"materials.rubber={name: rubber, law: johnson_cook, density: 1, bulk: 200, shear: 100, "
      "yield_stress: 1, hardening_coefficient: 2, hardening_exponent: 0.5, rate_coefficient: 0.1, "
      "reference_rate: 1, softening_exponent: 1, reference_temperature: 300, "
      "melting_temperature: 310, start_temperature: 300, specific_heat: 0.1, taylor_quinney: 0.9}",
      "output.energy_balance=true"}},
    {"plastic work and friction that heat what conducts",
     {"bodies.left.velocity=[4, 0]", "bodies.left.temperature=300+x",
      ("materials.rubber={name: rubber, law: johnson_cook, density: 1, bulk: 200, shear: 100, "
       "yield_stress: 1, softening_exponent: 1, reference_temperature: 300, "
       "melting_temperature: 310, taylor_quinney: 0.9, heat_capacity: 0.1, conductivity: 0.1, "
       "thermal_expansion: 1e-5, stress_free_temperature: 300}"),
      "transport={temperature: {start: '300', heating: true}}", "output.energy_balance=true",
      "contact={fields: bodies, law: friction, friction: 0.3, heat: conductance, conductance: 1}"}},
    {"shocks, with a pressure that breaks",
     {"bodies.left.velocity=[\"x<3.5 ? 3 : -3\", 0]", "bodies.right.velocity=[\"3*(x-8)\", 0]",
      "materials.rubber={name: rubber, law: von_mises_gruneisen, density: 1, sound_speed: 14, "
      "hugoniot_slope: 1.5, gruneisen: 2, shear: 100, yield_stress: 1, pressure_cutoff: 5, "
      "start_temperature: 300, specific_heat: 0.1, "
      "viscosity: {linear: 0.1, quadratic: 1}}"}},
    {"plastic bodies in plane stress",
     {"geometry=plane_stress",
      "materials.rubber={name: rubber, law: von_mises, density: 1, bulk: 200, shear: 100, "
      "hardening_table: [[0, 1], [0.01, 1.5], [1, 2]], kinematic_modulus: 5}"}},
    {"probes and lines, of a crack too",
     {"cracks=[{points: [[1, 3.25], [4, 3.25]], opening: true, contact: friction, friction: 0.2}]",
      "bodies.left.velocity=[0, \"2*(y-3.25)*(4.5-x)\"]", "output.derived=true",
      "output.probes=[{name: a, at: [3, 4]}, {name: outside, at: [6, 6]}]",
      "output.lines=[{name: b, from: [2, 2.5], to: [9, 2.5], points: 15}]"}},
    {"a cohesive crack",
     {"cracks=[{points: [[1, 3.25], [6, 3.25]], contact: none, cohesive: {law: trilinear, "
      "strength: 2, toughness: 0.5, stiffness: 100, knee_opening: 0.1, knee_traction: 1}}]",
      "bodies.left.velocity=[0, \"0.8*(y-3.25)\"]"}},
    {"rest", {"time.rest={residual: 1e-9, kinetic_energy: 1e-9}", "damping={grid: 10}"}},
};

/* Before the first step, within the steps after a sort, at a sort and around it. */
static const int64_t moments[] = {0, 1, 20, 31, 32, 33, 40};

START_TEST(a_run_that_goes_on_writes_the_bytes_of_one_without_interruption)
{
    const struct kind *const kind = &kinds[_i];
    struct mpm_error error = {.status = MPM_OK};
    scene_with(TEST_BLOCKS, kind->settings);
    const enum mpm_status whole = run_into(test_results.output, false, -1, 1, &error);
    ck_assert_msg(whole == MPM_OK || whole == MPM_RUN_FAILED, "%s: %s", kind->name, error.message);
    for (size_t k = 0; k < G_N_ELEMENTS(moments); k++) {
        char *const name = g_strdup_printf("interrupted-%zu", k);
        char *const other = test_folder_path(test_results.folder, name);
        enum mpm_status status = run_into(other, false, moments[k], 2, &error);
        ck_assert_msg(status == MPM_INTERRUPTED, "%s: %s", kind->name, error.message);
        status = run_into(other, true, 3, 3, &error); /* and once more, soon after */
        ck_assert_msg(status == MPM_INTERRUPTED, "%s: %s", kind->name, error.message);
        ck_assert_int_eq(run_into(other, true, -1, 1, &error), whole);
        check_same_results(test_results.output, other, kind->name);
        g_free(other);
        g_free(name);
    }
}
END_TEST

/* Checkpoints that are due change no result, and a run that has ended can go on from the last two
 * of them to the same end. */
START_TEST(checkpoints_change_no_result)
{
    static const char *const plain[] = {NULL};
    static const struct {
        const char *setting;
        json_int_t written; /* TEST_BLOCKS take some 50 steps until 1 */
    } dues[] = {{"output.checkpoint=0.2", 4}, {"output.checkpoint_seconds=1e-9", 40}};
    struct mpm_error error = {.status = MPM_OK};
    char *const whole = test_folder_path(test_results.folder, "whole");
    scene_with(TEST_BLOCKS, plain);
    ck_assert_int_eq(run_into(whole, false, -1, 1, &error), MPM_OK);
    const char *const settings[] = {dues[_i].setting, NULL};
    scene_with(TEST_BLOCKS, settings);
    ck_assert_int_eq(run_into(test_results.output, false, -1, 1, &error), MPM_OK);
    json_t *const record = test_results_json("run.json");
    const json_t *const counted =
        json_object_get(json_object_get(record, "counters"), "checkpoints");
    ck_assert_int_ge(json_integer_value(json_object_get(counted, "written")), dues[_i].written);
    check_same_file(whole, test_results.output, "history.csv", dues[_i].setting);
    char *const newest = test_folder_path(test_results.output, MPM_CHECKPOINT_NAME);
    char *const before = test_folder_path(test_results.output, MPM_CHECKPOINT_PREVIOUS);
    for (int k = 0; k < 2; k++) {
        ck_assert(test_file_exists(before));
        ck_assert_int_eq(run_into(test_results.output, true, -1, 1, &error), MPM_OK);
        check_same_file(whole, test_results.output, "history.csv", dues[_i].setting);
        ck_assert_int_eq(g_unlink(newest), 0);
    }
    json_decref(record);
    g_free(newest);
    g_free(before);
    g_free(whole);
}
END_TEST

START_TEST(an_interrupted_run_reports_its_state)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(run_into(test_results.output, false, 20, 1, &error), MPM_INTERRUPTED);
    ck_assert(strstr(error.message, "interrupted by signal 15") != NULL);
    json_t *record = test_results_json("run.json");
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "interrupted");
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), 128 + SIGTERM);
    ck_assert_str_eq(json_string_value(json_object_get(record, "reason")), error.message);
    ck_assert(json_is_null(json_object_get(record, "resumed")));
    json_decref(record);
    size_t rows = 0;
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.output, &rows);
    ck_assert(values[rows - 1][TEST_HISTORY_STEP] == 20.0);
    g_free(values);

    ck_assert_int_eq(run_into(test_results.output, true, -1, 1, &error), MPM_OK);
    record = test_results_json("run.json");
    const json_t *const resumed = json_object_get(record, "resumed");
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "done");
    ck_assert_int_eq(json_integer_value(json_object_get(resumed, "times")), 1);
    ck_assert_int_eq(json_integer_value(json_object_get(resumed, "last_step")), 20);
    json_decref(record);
}
END_TEST

/* What a run leaves behind that is killed later is taken away. */
START_TEST(results_after_the_checkpoint_are_taken_back)
{
    static const char *const plain[] = {NULL};
    static const char *const later[] = {"particles-000099.hdf", "particles-000002.hdf.partial"};
    struct mpm_error error = {.status = MPM_OK};
    char *const whole = test_folder_path(test_results.folder, "whole");
    scene_with(TEST_BLOCKS, plain);
    ck_assert_int_eq(run_into(whole, false, -1, 1, &error), MPM_OK);
    ck_assert_int_eq(run_into(test_results.output, false, 20, 1, &error), MPM_INTERRUPTED);
    for (size_t k = 0; k < G_N_ELEMENTS(later); k++)
        g_free(test_folder_write(test_results.output, later[k], "of a run that was killed"));
    char *const history = test_folder_path(test_results.output, "history.csv");
    FILE *const file = fopen(history, "a");
    ck_assert(file != NULL && fputs("0.9,half a ro", file) >= 0 && fclose(file) == 0);
    ck_assert_int_eq(run_into(test_results.output, true, -1, 1, &error), MPM_OK);
    check_same_results(whole, test_results.output, "after a kill");
    g_free(history);
    g_free(whole);
}
END_TEST

Suite *suite_checkpoint(void)
{
    Suite *suite = suite_create("checkpoint");
    TCase *runs = tcase_create("runs");
    tcase_add_checked_fixture(runs, test_results_set_up, test_results_tear_down);
    tcase_add_loop_test(runs, a_run_that_goes_on_writes_the_bytes_of_one_without_interruption, 0,
                        G_N_ELEMENTS(kinds));
    tcase_add_loop_test(runs, checkpoints_change_no_result, 0, 2);
    tcase_add_test(runs, an_interrupted_run_reports_its_state);
    tcase_add_test(runs, results_after_the_checkpoint_are_taken_back);
    suite_add_tcase(suite, runs);
    return suite;
}
