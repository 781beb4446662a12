/* Planes of symmetry: half a body against the whole of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

static const struct {
    const char *name, *whole, *half, *plane, *rest, *grid;
    int axis;
    double place;
} HALVES[] = {
    {"a plane across y", "['0.3*sin(2*x)*cos(y-5.6)', '0.4*cos(x)*sin(2*(y-5.6))']",
     "{from: [3, 5.6], to: [9, 8]}", "{from: [0, 5.6], to: [14, 5.6]}", "[0.5, 0]",
     "{origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}", 1, 5.6},
    {"a plane on the edge of the grid", "['0.3*sin(2*x)*cos(y-5.6)', '0.4*cos(x)*sin(2*(y-5.6))']",
     "{from: [3, 5.6], to: [9, 8]}", "{from: [0, 5.6], to: [14, 5.6]}", "[0.5, 0]",
     "{origin: [0, 5.6], cell: [1, 0.8], cells: [14, 8]}", 1, 5.6},
    {"a plane across x", "['0.3*sin(2*(x-6))*cos(y)', '0.4*cos(x-6)*cos(2*y)']",
     "{from: [6, 3.2], to: [9, 8]}", "{from: [6, 0], to: [6, 12]}", "[0, 0.5]",
     "{origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}", 0, 6.0},
    {"a plane across x on the edge of the grid",
     "['0.3*sin(2*(x-6))*cos(y)', '0.4*cos(x-6)*cos(2*y)']", "{from: [6, 3.2], to: [9, 8]}",
     "{from: [6, 0], to: [6, 12]}", "[0, 0.5]", "{origin: [6, 0], cell: [1, 0.8], cells: [8, 15]}",
     0, 6.0},
};
enum { HALVES_COUNT = G_N_ELEMENTS(HALVES) };

/* Largest difference of the half's particles and the same ones of the whole. */
static double half_difference(const struct test_run *whole, const struct test_run *half,
                              const struct crack_block_start *start, int axis, double place,
                              enum mpm_field field)
{
    const size_t components = mpm_field_describe(field)->components;
    double *const a = test_run_field(whole, field, NULL), *const b =
                                                              test_run_field(half, field, NULL);
    double largest = 0.0;
    size_t n = 0;
    for (size_t k = 0; k < start->count; k++)
        if (start->place[AXES * k + (size_t)axis] > place) {
            for (size_t c = 0; c < components; c++)
                largest = fmax(largest, fabs(a[components * k + c] - b[components * n + c]));
            n++;
        }
    ck_assert_uint_eq(n, mpm_simulation_particle_count(half->simulation));
    free(a);
    free(b);
    return largest;
}

/* Velocities are of order 1, stresses of the velocity times 12; edges whose nodes have little mass
 * make more of round-off. */
static const double HALF_ROUND_OFF = 1e-11;

/* B-splines are others at the edge of the grid. */
static bool differs_at_edge(int index)
{
    return index % CRACK_BLOCK_FAMILIES == CRACK_BLOCK_FAMILIES - 1 &&
           index / CRACK_BLOCK_METHODS % 2 == 1;
}

static void assert_half_of(const struct test_run *whole, const struct test_run *half,
                           const struct crack_block_start *start, int axis, double place)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT, MPM_FIELD_STRESS};
    for (size_t f = 0; f < G_N_ELEMENTS(fields); f++)
        ck_assert_near(half_difference(whole, half, start, axis, place, fields[f]), 0.0,
                       HALF_ROUND_OFF);
    const struct mpm_ledger all = test_run_ledger(whole), part = test_run_ledger(half);
    ck_assert_near(2.0 * part.kinetic_energy, all.kinetic_energy, HALF_ROUND_OFF);
    ck_assert_near(2.0 * part.strain_energy, all.strain_energy, HALF_ROUND_OFF);
    ck_assert_near(2.0 * part.external_work, all.external_work, HALF_ROUND_OFF);
    ck_assert_near(2.0 * part.damping_dissipation, all.damping_dissipation, HALF_ROUND_OFF);
}

/* Both have the settings, if any, a line each: the half its own ones. */
static void assert_half_is_half(int index, const char *const setting[2])
{
    const int pair = index / CRACK_BLOCK_METHODS;
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = crack_block_method(index);
        settings_add_formatted(&settings, "bodies.block.velocity=%s", HALVES[pair].whole);
        settings_add_formatted(&settings, "loads={body_force: %s}", HALVES[pair].rest);
        settings_add(&settings, "damping={grid: 0.3}");
        settings_add(&settings, "time={end: 1000, step: 0.02}");
        gchar **const lines = g_strsplit(setting == NULL ? "" : setting[k], "\n", 2);
        for (int line = 0; lines[line] != NULL; line++)
            settings_add_formatted(&settings, "%s", lines[line]);
        g_strfreev(lines);
        if (k == 1) {
            settings_add_formatted(&settings, "grid=%s", HALVES[pair].grid);
            settings_add_formatted(&settings, "bodies.block.region.rectangle=%s",
                                   HALVES[pair].half);
            settings_add_formatted(&settings, "boundary=[{region: {line: %s}, symmetry: true}]",
                                   HALVES[pair].plane);
        }
        runs[k] = crack_block_open(&settings);
    }
    struct crack_block_start start = crack_block_start(&runs[0]);
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], 30);
    if (!crack_block_amplifies(index) && !differs_at_edge(index))
        assert_half_of(&runs[0], &runs[1], &start, HALVES[pair].axis, HALVES[pair].place);
    crack_block_start_free(&start);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}

START_TEST(half_a_block_with_its_plane_of_symmetry_is_half_of_the_whole)
{
    assert_half_is_half(_i, NULL);
}
END_TEST

/* Transfers that pass velocities through the nodes once more must reflect those too; the momentum
 * form weights nodes by their masses, of which those on the plane have half. */
static const char *const TRANSFERS[] = {
    "method.transfer={kind: xpic, order: 3}",
    "method.transfer={kind: fmpm, order: 3}",
    "method.transfer={kind: apic}",
    "method.form=momentum",
};
enum { TRANSFERS_COUNT = G_N_ELEMENTS(TRANSFERS) };

START_TEST(half_a_block_is_half_of_the_whole_with_every_transfer)
{
    const char *const transfer = TRANSFERS[_i % TRANSFERS_COUNT];
    assert_half_is_half(_i / TRANSFERS_COUNT, (const char *const[2]){transfer, transfer});
}
END_TEST

/* A crack passes the plane: across y, across x, on lines of nodes and between. A body on the edge
 * of the grid has no room for what is beyond. */
static const struct {
    int half;
    const char *points[2]; /* of the whole, its own image; of the half, longer beyond */
} PASSING[] = {
    {0,
     {"[[6.3, 3.55], [6.3, 5.6], [6.3, 7.65]]",
      "[[6.3, 1.2], [6.3, 3.55], [6.3, 5.6], [6.3, 7.65]]"}},
    {0,
     {"[[5.4, 3.55], [5.4, 5.6], [5.4, 7.65]]",
      "[[5.4, 1.2], [5.4, 3.55], [5.4, 5.6], [5.4, 7.65]]"}},
    {2,
     {"[[3.45, 5.63], [6, 5.63], [8.55, 5.63]]",
      "[[1.2, 5.63], [3.45, 5.63], [6, 5.63], [8.55, 5.63]]"}},
    {2,
     {"[[8.55, 5.3], [6, 5.3], [3.45, 5.3]]", "[[8.55, 5.3], [6, 5.3], [3.45, 5.3], [1.2, 5.3]]"}},
};
static const char *const SURFACES[] = {
    "contact: none",
    "contact: frictionless",
    "contact: friction, friction: 0.3, detection: cell",
    "contact: stick, detection: displacement",
    "contact: none, opening: true",
    "contact: none, cohesive: {law: linear, strength: 2, toughness: 0.05, stiffness: 200}"};
enum { PASSING_COUNT = G_N_ELEMENTS(PASSING), SURFACES_COUNT = G_N_ELEMENTS(SURFACES) };

START_TEST(half_a_block_with_a_crack_past_its_plane_is_half_of_the_whole)
{
    const int scene = _i / CRACK_BLOCK_METHODS % PASSING_COUNT;
    const int surface = _i / CRACK_BLOCK_METHODS / PASSING_COUNT;
    char *cracks[2];
    for (int k = 0; k < 2; k++)
        cracks[k] = g_strdup_printf("cracks=[{points: %s, %s}]", PASSING[scene].points[k],
                                    SURFACES[surface]);
    assert_half_is_half(PASSING[scene].half * CRACK_BLOCK_METHODS + _i % CRACK_BLOCK_METHODS,
                        (const char *const[2]){cracks[0], cracks[1]});
    g_free(cracks[0]);
    g_free(cracks[1]);
}
END_TEST

#define PLANE_ACROSS_Y "{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, symmetry: true}"
#define PLANE_ACROSS_X "{region: {line: {from: [6, 0], to: [6, 12]}}, symmetry: true}"

/* On one plane and past another: a centre crack. */
START_TEST(a_quarter_of_a_block_with_a_centre_crack_is_half_of_the_half)
{
    static const char *const models[2][3] = {
        {"boundary=[" PLANE_ACROSS_Y "]", "{from: [3, 5.6], to: [9, 8]}",
         "[[3.45, 5.6], [6, 5.6], [8.55, 5.6]]"},
        {"boundary=[" PLANE_ACROSS_Y ", " PLANE_ACROSS_X "]", "{from: [6, 5.6], to: [9, 8]}",
         "[[1.2, 5.6], [3.45, 5.6], [6, 5.6], [8.55, 5.6]]"}};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = crack_block_method(_i);
        settings_add(&settings, "bodies.block.velocity=['0.3*sin(2*(x-6))*cos(y-5.6)', "
                                "'0.4*cos(x-6)*(0.5+sin(2*(y-5.6)))']");
        settings_add(&settings, "time={end: 1000, step: 0.02}");
        settings_add(&settings, models[k][0]);
        settings_add_formatted(&settings, "bodies.block.region.rectangle=%s", models[k][1]);
        settings_add_formatted(&settings, "cracks=[{points: %s, contact: none}]", models[k][2]);
        runs[k] = crack_block_open(&settings);
    }
    struct crack_block_start start = crack_block_start(&runs[0]);
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], 30);
    if (!crack_block_amplifies(_i))
        assert_half_of(&runs[0], &runs[1], &start, 0, 6.0);
    crack_block_start_free(&start);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

/* A triangle that tapers towards the corner of both: cubic splines reach nodes beyond each plane
 * and none beyond both, whose rows have shorter strips. The same with x and y exchanged. */
static const struct {
    const char *grid, *region, *velocity;
} EXCHANGED[] = {
    {"{origin: [0, 0], cell: [1, 0.8], cells: [14, 15]}",
     "{polygon: {points: [[2, 5.6], [6, 5.6], [3.863, 8]]}}", "['0.2*(x-6)', '0.3*(y-8)']"},
    {"{origin: [0, 0], cell: [0.8, 1], cells: [15, 14]}",
     "{polygon: {points: [[5.6, 2], [5.6, 6], [8, 3.863]]}}", "['0.3*(x-8)', '0.2*(y-6)']"},
};

START_TEST(images_of_images_have_what_is_beyond_either_plane)
{
    static const char *const planes[] = {
        "boundary=[{region: {line: {from: [0, 8], to: [14, 8]}}, symmetry: true}, " PLANE_ACROSS_X
        "]",
        "boundary=[{region: {line: {from: [8, 0], to: [8, 14]}}, symmetry: true}, "
        "{region: {line: {from: [0, 6], to: [12, 6]}}, symmetry: true}]",
    };
    struct mpm_ledger ledgers[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = crack_block_method(_i * CRACK_BLOCK_FAMILIES);
        settings_add(&settings, "method.shape=bspline3");
        settings_add_formatted(&settings, "grid=%s", EXCHANGED[k].grid);
        settings_add_formatted(&settings, "bodies.block.region=%s", EXCHANGED[k].region);
        settings_add_formatted(&settings, "bodies.block.velocity=%s", EXCHANGED[k].velocity);
        settings_add(&settings, planes[k]);
        settings_add(&settings, "time={end: 1000, step: 0.02}");
        struct test_run run = crack_block_open(&settings);
        test_run_steps(&run, 30);
        ledgers[k] = test_run_ledger(&run);
        test_run_close(&run);
    }
    ck_assert_near(ledgers[0].kinetic_energy, ledgers[1].kinetic_energy, HALF_ROUND_OFF);
    ck_assert_near(ledgers[0].strain_energy, ledgers[1].strain_energy, HALF_ROUND_OFF);
}
END_TEST

START_TEST(a_crack_past_a_plane_goes_with_every_transfer)
{
    const int scene = _i / TRANSFERS_COUNT / CRACK_BLOCK_METHODS;
    const int method = _i / TRANSFERS_COUNT % CRACK_BLOCK_METHODS;
    char *settings[2];
    for (int k = 0; k < 2; k++)
        settings[k] = g_strdup_printf("%s\ncracks=[{points: %s, contact: none}]",
                                      TRANSFERS[_i % TRANSFERS_COUNT], PASSING[scene].points[k]);
    assert_half_is_half(PASSING[scene].half * CRACK_BLOCK_METHODS + method,
                        (const char *const[2]){settings[0], settings[1]});
    g_free(settings[0]);
    g_free(settings[1]);
}
END_TEST

static const struct {
    const char *rest, *words;
} REFUSED[] = {
    {"loads: {body_force: [0, 2]}\n"
     "boundary: [{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]\n",
     "loads.body_force: acts across a plane of symmetry, got '2'; allowed: 0 there"},
    {"loads: {body_force: ['0*t', 0]}\n"
     "boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]\n",
     "loads.body_force: acts across a plane of symmetry, got '0*t'"},
    {"boundary: [{region: {line: {from: [0, 5.6], to: [14, 5.6]}}, symmetry: true}]\n",
     "bodies on both sides of the plane at 5.6; allowed: on one"},
    {"boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]\n"
     "cracks: [{points: [[0, 5.5], [3, 5.5], [7, 5.6]]}]\n",
     "a crack that meets the plane of symmetry at 3; allowed: on it as a whole, inside, or past "
     "it"},
    {"boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]\n"
     "cracks: [{points: [[3, 5.5], [7, 5.5]]}]\n",
     "a crack that meets the plane of symmetry at 3"},
    {"boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]\n"
     "cracks: [{points: [[0, 5.5], [4.5, 5.5]]}]\n",
     "a crack that meets the plane of symmetry at 3"},
    {"boundary: [{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}, {region: {line: "
     "{from: [0, 3.2], to: [14, 3.2]}}, symmetry: true}]\n"
     "cracks: [{points: [[0, 3.2], [7, 3.2]]}]\n",
     "cracks.contact: contact of a crack that lies on a plane of symmetry and passes another one"},
    {"boundary: [{region: {line: {from: [6, 0], to: [6, 12]}}, symmetry: true}]\n",
     "bodies on both sides of the plane at 6; allowed: on one"},
};

START_TEST(a_plane_with_a_load_across_it_or_bodies_on_both_sides_is_refused)
{
    char *const text = g_strconcat(CRACK_BLOCK, REFUSED[_i].rest, NULL);
    struct mpm_scene *const scene = test_scene_read_text(text);
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_simulation_create(scene, &(struct mpm_simulation_options){.threads = 1},
                                           &simulation, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, REFUSED[_i].words) != NULL, "%s", error.message);
    ck_assert_ptr_null(simulation);
    mpm_scene_free(scene);
    g_free(text);
}
END_TEST

/* The lower corner of a domain that is sheared beside the crack reaches a field beyond the plane,
 * and no corner the one inside that it is the image of: the sum of both must be there all the same.
 */
START_TEST(a_field_beyond_a_plane_has_one_inside)
{
    static const char scene[] =
        "format: 1\n"
        "geometry: axisymmetric\n"
        "grid: {origin: [3, 0], cell: [1, 1], cells: [13, 13]}\n"
        "time: {end: 497613, courant: 0.5}\n"
        "method: {shape: cpdi, stress_update: usl, position_update: midpoint}\n"
        "materials: [{name: m, law: neo_hookean, density: 1, young: 3, poisson: 0.3}]\n"
        "bodies:\n"
        "  - {name: b, material: m, region: {rectangle: {from: [6, 4], to: [13, 10]}},\n"
        "     velocity: ['0.0114834*(r - 9.5)', '0.0133973*(z - 7)']}\n"
        "boundary: [{region: {line: {from: [3, 4], to: [16, 4]}}, symmetry: true}]\n"
        "cracks: [{points: [[8.8837, 0.3], [8.8837, 7.6]], contact: none}]\n"
        "output: {energy_balance: true}\n";
    const char *const settings[] = {NULL};
    struct test_run run = test_run_open(scene, settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, 10);
    const struct mpm_ledger end = test_run_ledger(&run);
    ck_assert_near(end.total_energy + end.transfer_loss - end.external_work, start.total_energy,
                   1e-13 * start.total_energy);
    test_run_close(&run);
}
END_TEST

Suite *suite_symmetry(void)
{
    Suite *suite = suite_create("symmetry");
    TCase *halves = tcase_create("halves");
    tcase_add_loop_test(halves, half_a_block_with_a_crack_past_its_plane_is_half_of_the_whole, 0,
                        CRACK_BLOCK_METHODS * PASSING_COUNT * SURFACES_COUNT);
    tcase_add_loop_test(halves, a_quarter_of_a_block_with_a_centre_crack_is_half_of_the_half, 0,
                        CRACK_BLOCK_METHODS);
    tcase_add_loop_test(halves, images_of_images_have_what_is_beyond_either_plane, 0, TEST_ORDERS);
    tcase_add_test(halves, a_field_beyond_a_plane_has_one_inside);
    tcase_add_loop_test(halves, a_crack_past_a_plane_goes_with_every_transfer, 0,
                        CRACK_BLOCK_METHODS * PASSING_COUNT * TRANSFERS_COUNT);
    tcase_add_loop_test(halves, half_a_block_with_its_plane_of_symmetry_is_half_of_the_whole, 0,
                        HALVES_COUNT * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(halves, half_a_block_is_half_of_the_whole_with_every_transfer, 0,
                        HALVES_COUNT * CRACK_BLOCK_METHODS * TRANSFERS_COUNT);
    suite_add_tcase(suite, halves);
    TCase *refusals = tcase_create("refusals");
    tcase_add_loop_test(refusals, a_plane_with_a_load_across_it_or_bodies_on_both_sides_is_refused,
                        0, G_N_ELEMENTS(REFUSED));
    suite_add_tcase(suite, refusals);
    return suite;
}
