/* Openings and cohesive tractions of cracks, at their points and in whole steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/cohesive_traction.h"
#include "method/cracks/crack_opening.h"
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

/* -------------------------------------------------------------------- points */

/* From edge to edge of the block, on a grid line. */
#define THROUGH "[[3, 5.6], [9, 5.6]]"
/* The same and on, past what the nodes of the edges see. */
#define PAST   "[[0, 5.6], [3, 5.6], [9, 5.6], [12, 5.6]]"
#define LINEAR "{law: linear, strength: 2, toughness: 0.3, stiffness: 200}"

static const char *const LAWS[] = {
    LINEAR,
    ("{law: trilinear, strength: 2, toughness: 0.3, stiffness: 200, knee_opening: 0.05, "
     "knee_traction: 0.7}"),
    "{law: exponential, strength: 2, toughness: 0.3, stiffness: 200}",
};

static struct test_run open_cohesive(struct settings *settings, const char *points, const char *law)
{
    settings_add_formatted(settings, "cracks=[{points: %s, contact: none, cohesive: %s}]", points,
                           law);
    return crack_block_open(settings);
}

static const struct mpm_crack_openings *openings_of(const struct test_run *run)
{
    return &crack_block_state(run)->cracks.openings;
}

/* Opens a point: along x and y. */
static void set_opening(const struct test_run *run, size_t k, double x, double y)
{
    openings_of(run)->vector[0][k] = x;
    openings_of(run)->vector[1][k] = y;
}

START_TEST(a_point_unloads_to_the_origin_and_remembers_its_largest_opening)
{
    struct settings settings = {.count = 0};
    struct test_run run = open_cohesive(&settings, THROUGH, LAWS[_i]);
    const struct mpm_cohesive *const law = &run.scene->cracks[0].cohesive;
    const struct mpm_state *const state = crack_block_state(&run);
    const double largest = 0.08, area = openings_of(&run)->area[3];
    double traction[AXES], stored, dissipated;
    openings_of(&run)->largest[3] = largest;
    for (int k = 0; k <= 4; k++) {
        const double part = 0.25 * k, angle = 0.3;
        set_opening(&run, 3, part * largest * sin(angle), part * largest * cos(angle));
        mpm_cohesive_traction_at(state, 0, 0, 3, traction);
        const double expected = part * mpm_cohesive_envelope(law, largest);
        ck_assert_near(traction[0], -expected * sin(angle), 1e-15);
        ck_assert_near(traction[1], -expected * cos(angle), 1e-15);
        mpm_cohesive_energies(state, &stored, &dissipated);
        ck_assert_near(stored, area * 0.5 * expected * part * largest, 1e-16);
        ck_assert_near(dissipated,
                       area * (mpm_cohesive_work(law, largest) -
                               0.5 * mpm_cohesive_envelope(law, largest) * largest),
                       1e-16);
    }
    test_run_close(&run);
}
END_TEST

START_TEST(surfaces_that_overlap_are_held_along_the_crack_alone)
{
    struct settings settings = {.count = 0};
    struct test_run run = open_cohesive(&settings, THROUGH, LINEAR);
    double traction[AXES];
    set_opening(&run, 3, 0.004, -0.3);
    mpm_cohesive_traction_at(crack_block_state(&run), 0, 0, 3, traction);
    ck_assert_near(traction[0], -0.8, 1e-15);
    ck_assert_near(traction[1], 0.0, 1e-15);
    ck_assert_near(mpm_cohesive_effective(crack_block_state(&run), 0, 0, 3), 0.004, 1e-15);
    test_run_close(&run);
}
END_TEST

/* Chains, and the area of all their points: times the thickness 2.5, or per radian. */
static const struct {
    const char *geometry, *points;
    double area;
} AREAS[] = {
    {"plane_strain", "[[3, 5.6], [9, 5.6]]", 15.0},
    {"plane_strain", "[[3, 4], [6, 4], [9, 8]]", 20.0},
    {"plane_strain", PAST, 15.0},
    {"axisymmetric", PAST, 36.0},
    {"axisymmetric", "[[3, 5.6], [9, 5.6]]", 36.0},     /* (9^2 - 3^2)/2 */
    {"axisymmetric", "[[3, 4], [6, 8]]", 22.5},         /* 5 (3 + 6)/2 */
    {"axisymmetric", "[[4, 3.2], [4, 8]]", 19.2},       /* 4.8 * 4 */
    {"axisymmetric", "[[8, 4], [5, 4], [5, 6]]", 29.5}, /* (8^2 - 5^2)/2 + 2 * 5 */
};

START_TEST(areas_of_points_make_up_the_area_of_the_crack)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "geometry=%s", AREAS[_i].geometry);
    if (strcmp(AREAS[_i].geometry, "plane_strain") == 0)
        settings_add(&settings, "thickness=2.5");
    struct test_run run = open_cohesive(&settings, AREAS[_i].points, LINEAR);
    const size_t count = crack_block_state(&run)->cracks.point_count;
    double sum = 0.0;
    for (size_t k = 0; k < count; k++)
        sum += openings_of(&run)->area[k];
    ck_assert_near(sum, AREAS[_i].area, 1e-14 * AREAS[_i].area);
    double stored, dissipated;
    for (size_t k = 0; k < count; k++)
        openings_of(&run)->largest[k] = 1.0;
    mpm_cohesive_energies(crack_block_state(&run), &stored, &dissipated);
    ck_assert_near(stored, 0.0, 1e-14);
    ck_assert_near(dissipated, 0.3 * AREAS[_i].area, 1e-14 * AREAS[_i].area);
    test_run_close(&run);
}
END_TEST

/* --------------------------------------------------------------------- steps */

/* Of 15 units of mass per half, in sums over some hundred particles and nodes. */
static const double MOMENTUM_ROUND_OFF = 1e-13;

/* From rest the first step gives each half the sum of -+ t A dt, whatever the order: in one that
 * updates stresses first nothing moves yet. Openings along and across the crack; no two alike. */
START_TEST(the_first_step_gives_each_half_the_impulse_of_the_tractions)
{
    const bool axisymmetric = _i / CRACK_BLOCK_METHODS == 1;
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    settings_add(&settings, axisymmetric ? "geometry=axisymmetric" : "thickness=2.5");
    settings_add(&settings,
                 "bodies.block.velocity=[0, -0.2]"); /* more energy than tractions give */
    struct test_run run = open_cohesive(&settings, PAST, LINEAR);
    struct crack_block_start start = crack_block_start(&run);
    double expected[AXES] = {0.0, 0.0}, above[2][AXES], below[2][AXES];
    /* from 3 to 9 segments of 6/15, ends with half of one; r of the hat function's middle */
    const size_t first = 8, count = 16;
    ck_assert_uint_eq(crack_block_state(&run)->cracks.point_count, 2 * first + count);
    for (size_t k = 0; k < count; k++) {
        const double r = 3.0 + 0.4 * (double)k, end = k == 0 || k + 1 == count ? 0.5 : 1.0;
        const double shift = k == 0 ? 0.4 / 3.0 : k + 1 == count ? -0.4 / 3.0 : 0.0;
        const double area = 0.4 * end * (axisymmetric ? r + shift : 2.5);
        const double x = 0.001 * (double)k, y = 0.0005 * (double)(k + 2);
        const double lambda = sqrt(x * x + y * y);
        const double t = lambda < 0.01 ? 200.0 * lambda : 2.0 * (0.3 - lambda) / 0.29;
        set_opening(&run, first + k, x, y);
        expected[0] -= t * area * x / lambda;
        expected[1] -= t * area * y / lambda;
    }
    for (int k = 0; k < 2; k++) {
        crack_block_momentum(&run, &start, true, above[k]);
        crack_block_momentum(&run, &start, false, below[k]);
        test_run_steps(&run, k == 0 ? 1 : 0);
    }
    const double step = mpm_simulation_time_step(run.simulation);
    const double mass = test_run_ledger(&run).mass;
    for (int axis = 0; axis < AXES; axis++) {
        const double scale = mass * MOMENTUM_ROUND_OFF + fabs(expected[axis] * step) * 1e-12;
        ck_assert_near(above[1][axis] - above[0][axis], expected[axis] * step, scale);
        ck_assert_near(below[1][axis] - below[0][axis], -expected[axis] * step, scale);
    }
    crack_block_start_free(&start);
    test_run_close(&run);
}
END_TEST

/* Also with a bent crack between nodes, while all is deformed: axisymmetric along z alone, radial
 * momentum being none. */
START_TEST(tractions_keep_momentum)
{
    const bool axisymmetric = _i / CRACK_BLOCK_METHODS == 1;
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    if (axisymmetric)
        settings_add(&settings, "geometry=axisymmetric");
    settings_add(&settings,
                 axisymmetric
                     ? "bodies.block.velocity=['0.2*sin(z)', '(z > 5.6 ? 0.6 : -0.4)*cos(0.3*r)']"
                     : "bodies.block.velocity=['0.2*sin(y)', '(y > 5.6 ? 0.6 : -0.4)*cos(0.3*x)']");
    struct test_run run =
        open_cohesive(&settings, "[[1, 5.4], [3, 5.4], [6, 5.8], [9, 5.6], [11, 5.6]]", LINEAR);
    const struct mpm_ledger before = test_run_ledger(&run);
    test_run_steps(&run, 12);
    const struct mpm_ledger after = test_run_ledger(&run);
    ck_assert_double_gt(after.cohesive_stored, 1e-3);
    for (int axis = axisymmetric ? 1 : 0; axis < AXES; axis++)
        ck_assert_near(after.momentum[axis], before.momentum[axis],
                       before.mass * MOMENTUM_ROUND_OFF);
    test_run_close(&run);
}
END_TEST

/* Halves that fly apart: their openings are the time that they had times the velocity between them,
 * away from the block's edges, where the halves slide past each other's. */
START_TEST(surfaces_open_at_the_velocity_between_both_sides)
{
    static const char *const chains[] = {PAST, "[[0, 5.6], [6, 5.7], [12, 5.6]]"};
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    settings_add(&settings,
                 "bodies.block.velocity=['y > 5.6 ? 0.3 : -0.7', 'y > 5.6 ? 0.9 : -0.4']");
    settings_add_formatted(&settings, "cracks=[{points: %s, opening: true}]",
                           chains[_i / CRACK_BLOCK_METHODS]);
    struct test_run run = crack_block_open(&settings);
    test_run_steps(&run, 30);
    const struct mpm_cracks *const cracks = &crack_block_state(&run)->cracks;
    const double time = mpm_simulation_time(run.simulation);
    const double bound = crack_block_amplifies(_i) ? 1e-9 : 1e-12;
    for (size_t k = 0; k < cracks->point_count; k++) {
        if (!(cracks->position[0][k] > 4.0 && cracks->position[0][k] < 8.0))
            continue;
        ck_assert_near(cracks->openings.vector[0][k], 1.0 * time, bound);
        ck_assert_near(cracks->openings.vector[1][k], 1.3 * time, bound);
    }
    test_run_close(&run);
}
END_TEST

/* A tip inside, a body that turns: nothing opens, but for second-order errors. The velocities of
 * nodes beside the crack are those of the mass centres that they see: surfaces seem to slide by the
 * angle times the distance of those, which is less than a cell, 0.8. */
START_TEST(a_body_that_moves_as_a_whole_opens_no_crack)
{
    struct settings settings = crack_block_method(_i);
    settings_add(&settings,
                 "bodies.block.velocity=['0.3 - 0.02*(y - 5.6)', '-0.2 + 0.02*(x - 6)']");
    settings_add(&settings, "cracks=[{points: [[3, 5.5], [7, 5.6]], opening: true}]");
    struct test_run run = crack_block_open(&settings);
    test_run_steps(&run, 30);
    const double angle = 0.02 * mpm_simulation_time(run.simulation);
    for (size_t k = 0; k < crack_block_state(&run)->cracks.point_count; k++) {
        const struct mpm_crack_gap gap = mpm_crack_gap_at(
            crack_block_state(&run), &crack_block_state(&run)->cracks.chains[0], 0, k);
        ck_assert_near(gap.opening, 0.0, 0.1 * angle);
        ck_assert_near(gap.sliding, 0.0, 0.8 * angle);
    }
    test_run_close(&run);
}
END_TEST

/* The law has nothing to do: what velocities of round-off open is of no account. */
START_TEST(a_crack_that_stays_closed_does_nothing)
{
    static const char *const laws[] = {"", ", cohesive: " LINEAR};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings settings = crack_block_method(_i);
        settings_add(&settings, "bodies.block.velocity=[0.3, -0.2]");
        settings_add_formatted(&settings, "cracks=[{points: " THROUGH "%s}]", laws[k]);
        runs[k] = crack_block_open(&settings);
        test_run_steps(&runs[k], 10);
    }
    size_t count;
    double *const one = test_run_field(&runs[0], MPM_FIELD_VELOCITY, &count);
    double *const other = test_run_field(&runs[1], MPM_FIELD_VELOCITY, NULL);
    for (size_t k = 0; k < AXES * count; k++)
        ck_assert_near(other[k], one[k], crack_block_amplifies(_i) ? 1e-9 : 1e-12);
    const struct mpm_ledger ledger = test_run_ledger(&runs[1]);
    ck_assert(ledger.cohesive_stored < 1e-20 && ledger.cohesive_dissipated == 0.0);
    free(one);
    free(other);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

/* Halves torn apart: the crack takes its toughness times its area out of their kinetic energy, and
 * the energies balance. What the step's scheme does to energy is allowed 1 % of it; USL dissipates.
 */
START_TEST(a_torn_crack_has_taken_its_toughness_times_its_area)
{
    const int method = _i % CRACK_BLOCK_METHODS;
    const bool axisymmetric = _i / CRACK_BLOCK_METHODS == 1;
    const double area = axisymmetric ? 36.0 : 6.0;
    struct settings settings = crack_block_method(method);
    if (axisymmetric)
        settings_add(&settings, "geometry=axisymmetric");
    settings_add_formatted(&settings, "bodies.block.velocity=[0, '%s > 5.6 ? 1.2 : -1.2']",
                           axisymmetric ? "z" : "y");
    settings_add(&settings, "time.courant=0.05"); /* 30 steps for the linear law */
    struct test_run run = open_cohesive(&settings, PAST, LAWS[_i % 2]);
    const struct mpm_ledger before = test_run_ledger(&run);
    test_run_steps(&run, 280);
    const struct mpm_ledger after = test_run_ledger(&run);
    ck_assert_near(after.cohesive_dissipated, 0.3 * area, 1e-13 * area);
    ck_assert_near(after.cohesive_stored, 0.0, 1e-13 * area);
    ck_assert_near(after.total_energy,
                   after.kinetic_energy + after.strain_energy + after.cohesive_dissipated,
                   1e-14 * before.total_energy);
    const bool dissipates = method / CRACK_BLOCK_FAMILIES == 0;
    ck_assert_near(after.total_energy, before.total_energy,
                   (dissipates ? 0.2 : 0.01) * before.total_energy);
    test_run_close(&run);
}
END_TEST

/* ---------------------------------------------------------------------- runs */

START_TEST(results_are_the_same_bits_for_any_number_of_threads)
{
    static const char *const crack =
        "cracks=[{points: [[3, 10], [30, 25.6], [40, 45], [62, 20]], cohesive: {law: exponential, "
        "strength: 0.5, toughness: 0.01, stiffness: 200}}]";
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS, "method={shape: cpdi, stress_update: usavg}", crack,
        "bodies.block.velocity=['0.3*sin(0.2*x)*cos(0.3*y)', '0.4*cos(0.1*x+0.2*y)']", NULL};
    test_same_bits_over_threads(CRACK_BLOCK, settings, 6, NULL);
}
END_TEST

/* A run that fails goes back to its last good step: openings and what they remember too. */
START_TEST(a_failed_run_goes_back_with_its_openings)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "method.shape=ugimp");
    settings_add(&settings, "bodies.block.velocity=['2*sin(y)', 'y > 5.6 ? 3 : 1']");
    settings_add_formatted(&settings, "cracks=[{points: " THROUGH ", cohesive: %s}]", LAWS[0]);
    struct test_run failed = test_run_open(CRACK_BLOCK, settings.texts, 1);
    struct test_run good = crack_block_open(&settings);
    struct mpm_error error = {.message = ""};
    enum mpm_status status = MPM_OK;
    for (int step = 0; status == MPM_OK && step < 1000; step++)
        status = mpm_simulation_advance(failed.simulation, 100.0, &error);
    ck_assert_msg(status == MPM_RUN_FAILED, "%s", error.message);
    test_run_steps(&good, (int)mpm_simulation_step(failed.simulation));
    ck_assert(test_run_same_bits(&failed, &good));
    const struct mpm_crack_openings *const one = openings_of(&failed), *const other =
                                                                           openings_of(&good);
    const size_t bytes = crack_block_state(&good)->cracks.point_count * sizeof(double);
    ck_assert_mem_eq(one->vector[0], other->vector[0], bytes);
    ck_assert_mem_eq(one->vector[1], other->vector[1], bytes);
    ck_assert_mem_eq(one->largest, other->largest, bytes);
    ck_assert_double_gt(one->largest[0], 0.01);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

START_TEST(cracks_that_are_not_followed_keep_nothing_of_openings)
{
    static const char *const cracked[] = {"cracks=[{points: " THROUGH ", contact: none}]", NULL};
    static const char *const followed[] = {
        "cracks=[{points: " THROUGH ", contact: none, opening: true}]", NULL};
    struct test_run without = test_run_open(CRACK_BLOCK, cracked, 1);
    struct test_run with = test_run_open(CRACK_BLOCK, followed, 1);
    const struct mpm_crack_openings *const openings = openings_of(&without);
    ck_assert(openings->vector[0] == NULL && openings->surfaces == NULL && openings->cuts == NULL);
    ck_assert(openings->largest == NULL && openings->area == NULL);
    ck_assert(openings_of(&with)->vector[0] != NULL && openings_of(&with)->largest == NULL);
    ck_assert_uint_eq(mpm_scene_crack_quantity_count(without.scene), 0);
    ck_assert_uint_eq(mpm_scene_crack_quantity_count(with.scene), 6);
    test_run_close(&without);
    test_run_close(&with);
}
END_TEST

/* Of the second crack of two, which alone has it. */
START_TEST(the_history_tells_how_far_a_crack_has_opened_and_slid)
{
    static const struct {
        const char *name;
        double value;
    } expected[] = {
        {"crack_1_opening_first", 0.25},   {"crack_1_sliding_first", -0.5},
        {"crack_1_opening_last", -0.125},  {"crack_1_sliding_last", 0.375},
        {"crack_1_opening_largest", 0.75}, {"crack_1_sliding_largest", -0.5},
    };
    struct settings settings = {.count = 0};
    settings_add(&settings,
                 "cracks=[{points: [[3, 4], [9, 4]], contact: none}, {points: [[9, 7], [3, "
                 "7]], contact: none, opening: true}]");
    struct test_run run = crack_block_open(&settings);
    const size_t first = crack_block_state(&run)->cracks.chains[0].count;
    const size_t last = crack_block_state(&run)->cracks.point_count - 1;
    set_opening(&run, first, 0.5, -0.25); /* it runs to the left: below is above */
    set_opening(&run, first + 2, 0.25, -0.75);
    set_opening(&run, last, -0.375, 0.125);
    ck_assert_uint_eq(mpm_scene_crack_quantity_count(run.scene), G_N_ELEMENTS(expected));
    for (size_t k = 0; k < G_N_ELEMENTS(expected); k++) {
        const struct mpm_quantity_info info = mpm_scene_crack_quantity(run.scene, k);
        ck_assert_str_eq(info.name, expected[k].name);
        ck_assert(info.dimension.length == 1 && info.dimension.mass == 0 &&
                  info.dimension.time == 0);
        ck_assert_near(mpm_simulation_crack_quantity(run.simulation, k), expected[k].value, 1e-15);
    }
    test_run_close(&run);
}
END_TEST

/* A crack that comes round to itself: of nodes between, particles on three sides have fields. */
START_TEST(the_history_counts_nodes_that_contact_leaves_alone)
{
    static const char *const cracks[] = {
        "cracks=[{points: [[5.8, 3.6], [5.8, 7.4], [8.4, 7.4], [8.4, 4.1], [6.3, 4.1], [6.3, "
        "6.5]]}]",
        "cracks=[{points: [[5.8, 3.6], [5.8, 7.4]]}]"};
    for (int k = 0; k < 2; k++) {
        struct test_run run = test_run_open(CRACK_BLOCK, (const char *const[]){cracks[k], NULL}, 1);
        ck_assert_uint_eq(mpm_scene_crack_quantity_count(run.scene), 1);
        const struct mpm_quantity_info info = mpm_scene_crack_quantity(run.scene, 0);
        ck_assert_str_eq(info.name, "crack_0_nodes_without_contact");
        ck_assert_double_eq(mpm_simulation_crack_quantity(run.simulation, 0), 0.0);
        test_run_steps(&run, 1);
        /* those at x = 6 and y = 4 to 6.4, between both legs; of one leg none */
        ck_assert_double_eq(mpm_simulation_crack_quantity(run.simulation, 0), k == 0 ? 4.0 : 0.0);
        test_run_close(&run);
    }
}
END_TEST

START_TEST(a_cohesive_crack_says_what_its_file_says)
{
    struct mpm_scene *scene = test_scene_read_text(CRACK_BLOCK);
    ck_assert(!mpm_scene_is_cohesive(scene));
    mpm_scene_free(scene);
    char *text =
        g_strdup_printf("%scracks: [{points: %s, cohesive: %s}]\n", CRACK_BLOCK, THROUGH, LAWS[1]);
    scene = test_scene_read_text(text);
    const struct mpm_cohesive *const cohesive = &scene->cracks[0].cohesive;
    ck_assert(mpm_scene_is_cohesive(scene) && !scene->cracks[0].opening);
    ck_assert_ptr_eq(cohesive->law, &mpm_cohesive_trilinear);
    ck_assert_double_eq(cohesive->strength, 2.0);
    ck_assert_double_eq(cohesive->toughness, 0.3);
    ck_assert_double_eq(cohesive->stiffness, 200.0);
    ck_assert_double_eq(cohesive->knee_opening, 0.05);
    ck_assert_double_eq(cohesive->knee_traction, 0.7);
    ck_assert_double_eq(cohesive->onset, 0.01);
    mpm_scene_free(scene);
    g_free(text);
}
END_TEST

Suite *suite_cohesive(void)
{
    Suite *suite = suite_create("cohesive");
    TCase *points = tcase_create("points");
    tcase_add_loop_test(points, a_point_unloads_to_the_origin_and_remembers_its_largest_opening, 0,
                        G_N_ELEMENTS(LAWS));
    tcase_add_test(points, surfaces_that_overlap_are_held_along_the_crack_alone);
    tcase_add_loop_test(points, areas_of_points_make_up_the_area_of_the_crack, 0,
                        G_N_ELEMENTS(AREAS));
    suite_add_tcase(suite, points);
    TCase *steps = tcase_create("steps");
    tcase_add_loop_test(steps, the_first_step_gives_each_half_the_impulse_of_the_tractions, 0,
                        2 * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(steps, tractions_keep_momentum, 0, 2 * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(steps, surfaces_open_at_the_velocity_between_both_sides, 0,
                        2 * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(steps, a_body_that_moves_as_a_whole_opens_no_crack, 0, CRACK_BLOCK_METHODS);
    tcase_add_loop_test(steps, a_crack_that_stays_closed_does_nothing, 0, CRACK_BLOCK_METHODS);
    tcase_add_loop_test(steps, a_torn_crack_has_taken_its_toughness_times_its_area, 0,
                        2 * CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, steps);
    TCase *runs = tcase_create("runs");
    tcase_add_test(runs, results_are_the_same_bits_for_any_number_of_threads);
    tcase_add_test(runs, a_failed_run_goes_back_with_its_openings);
    tcase_add_test(runs, cracks_that_are_not_followed_keep_nothing_of_openings);
    tcase_add_test(runs, the_history_tells_how_far_a_crack_has_opened_and_slid);
    tcase_add_test(runs, the_history_counts_nodes_that_contact_leaves_alone);
    tcase_add_test(runs, a_cohesive_crack_says_what_its_file_says);
    suite_add_tcase(suite, runs);
    return suite;
}
