/* Cracks that grow by a toughness criterion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/crack_blocks.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"
#include "verification/exact/cracks/williams_field.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5 };

/* Pulled apart along y; wave speed 8.5. */
static const char BLOCK[] = BLOCK_OF_GROWTH(", velocity: [0, '0.01*(y - 11.2)']");

#define CRACK(propagation)                                                                         \
    "cracks=[{points: [[0.2, 11.2], [14.3, 11.2]], contact: none, j_integral: [{contour: 4, "      \
    "propagation: " propagation "}, {contour: 5}]}]"
static const double TOUGHNESS = 0.002, INCREMENT = 0.4; /* half of the shorter side of a cell */
#define GROWS CRACK("{toughness: 0.002, longest: 8, every: 5}")

/* The block is its own mirror image but for round-off, which steps make grow. */
static const double STRAIGHT = 1e-8;

START_TEST(a_tip_grows_straight_on_by_increments_and_counts_its_work)
{
    const char *const settings[] = {_i == 0 ? "method.shape=ugimp" : "method.shape=bspline2", GROWS,
                                    NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const struct mpm_crack_chain *const chain = &run.simulation->state.cracks.chains[0];
    const size_t points = chain->count;
    double grown = 0.0;
    for (int k = 0; k < 70; k++) {
        test_run_steps(&run, 1);
        const struct mpm_j_integral value = test_run_j_integral(&run, 0);
        ck_assert(value.grown == grown || fabs(value.grown - grown - INCREMENT) < 1e-12);
        grown = value.grown;
    }
    const struct mpm_j_integral own = test_run_j_integral(&run, 0),
                                other = test_run_j_integral(&run, 1);
    ck_assert_msg(grown > 3.0, "grown by %g", grown);
    ck_assert_uint_eq(chain->count, points + (size_t)llround(grown / INCREMENT));
    ck_assert_near(own.dissipated, TOUGHNESS * 2.0 * grown, 1e-14);
    ck_assert_near(own.tip[0], 14.3 + grown, 0.05); /* the material moves little */
    for (size_t k = 0; k < chain->count; k++)
        ck_assert_near(chain->y[k], 11.2, STRAIGHT);
    ck_assert(other.grown == own.grown && other.dissipated == 0.0 && other.tip[0] == own.tip[0]);
    test_run_close(&run);
}
END_TEST

START_TEST(a_tough_crack_is_one_that_does_not_grow)
{
    const char *const settings[][2] = {
        {CRACK("{toughness: 1e9, longest: 8}"), NULL},
        {"cracks=[{points: [[0.2, 11.2], [14.3, 11.2]], contact: none}]", NULL}};
    struct test_run tough = test_run_open(BLOCK, settings[0], 1);
    struct test_run plain = test_run_open(BLOCK, settings[1], 1);
    test_run_steps(&tough, 60);
    test_run_steps(&plain, 60);
    ck_assert(test_run_same_bits(&tough, &plain));
    ck_assert(test_run_j_integral(&tough, 0).grown == 0.0);
    test_run_close(&tough);
    test_run_close(&plain);
}
END_TEST

START_TEST(a_growing_crack_gives_the_same_bits_for_any_number_of_threads)
{
    const char *const settings[] = {GROWS, "method.shape=cpdi", NULL};
    test_same_bits_over_threads(BLOCK, settings, 60, NULL);
}
END_TEST

/* Room for four increments: the fifth fails. The run goes back to the state before. */
static const struct ending {
    const char *cracks, *message;
    double grown;
} ENDINGS[] = {
    {CRACK("{toughness: 0.002, longest: 1.7}"),
     "would grow further; allowed: up to propagation.longest, 1.7", 4.0},
};

START_TEST(a_run_whose_crack_cannot_grow_goes_back_by_growing_again)
{
    const struct ending *const ending = &ENDINGS[_i];
    const char *const settings[] = {ending->cracks, NULL};
    struct test_run failed = test_run_open(BLOCK, settings, 1);
    struct test_run good = test_run_open(BLOCK, settings, 1);
    struct mpm_error error = {.message = ""};
    int steps = 0;
    while (steps < 300 && mpm_simulation_advance(failed.simulation, HUGE_VAL, &error) == MPM_OK)
        steps++;
    ck_assert_int_eq(error.status, MPM_RUN_FAILED);
    test_contains(error.message, ending->message);
    test_run_steps(&good, steps);
    ck_assert(test_run_same_bits(&failed, &good));
    const struct mpm_j_integral one = test_run_j_integral(&failed, 0),
                                other = test_run_j_integral(&good, 0);
    for (int k = 0; k < AXES; k++) {
        ck_assert_double_eq(one.tip[k], other.tip[k]);
        ck_assert_double_eq(one.direction[k], other.direction[k]);
        ck_assert_double_eq(one.j[k], other.j[k]);
        ck_assert_double_eq(one.stress_intensity[k], other.stress_intensity[k]);
    }
    ck_assert_double_eq(one.grown, other.grown);
    ck_assert_double_eq(one.dissipated, other.dissipated);
    ck_assert_near(one.grown, ending->grown * INCREMENT, 1e-12);
    const struct mpm_cracks *const cracks = &failed.simulation->state.cracks;
    for (int axis = 0; axis < AXES; axis++)
        ck_assert(memcmp(cracks->position[axis], good.simulation->state.cracks.position[axis],
                         cracks->point_count * sizeof(double)) == 0);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

/* The angle from axis 1 of the tip across which the hoop stress of its field is largest: from -110
 * to 110 degrees, in steps. */
enum { ANGLES = 2200 };

static double largest_hoop(const struct williams_field *field)
{
    const double lame = field->shear * (3.0 - field->kappa) / (field->kappa - 1.0);
    double found = 0.0, largest = -HUGE_VAL;
    for (int k = -ANGLES; k <= ANGLES; k++) {
        const double angle = 110.0 * acos(-1.0) / 180.0 * k / ANGLES;
        const double along[AXES] = {cos(angle), sin(angle)}, across[AXES] = {-along[1], along[0]};
        const double place[AXES] = {field->tip[0] + along[0], field->tip[1] + along[1]};
        double g[4], strain = 0.0;
        williams_field_gradient(field, place, g);
        for (int i = 0; i < AXES; i++)
            for (int j = 0; j < AXES; j++)
                strain += across[i] * g[2 * i + j] * across[j];
        const double hoop = lame * (g[0] + g[3]) + 2.0 * field->shear * strain;
        found = hoop > largest ? angle : found;
        largest = fmax(largest, hoop);
    }
    return found;
}

static const struct given_tip {
    const char *points, *tip;
    double direction[AXES];
} GIVEN_TIPS[] = {
    {"[[0.2, 11.3], [18.3, 11.3]]", "end", {1, 0}},
    {"[[18.3, 11.3], [0.2, 11.3]]", "start", {1, 0}},
    {"[[8.7, 4.1], [18.3, 11.3]]", "end", {0.8, 0.6}},
    {"[[18.3, 11.3], [23.7, 18.5]]", "start", {-0.6, -0.8}},
};
static const double MODES[][AXES] = {{1, 0},    {0, 1},     {0, -1},   {1, 0.2},
                                     {1, -0.5}, {0.5, 1.0}, {0.2, -1}, {1, 0.05}};
enum { GIVEN_COUNT = G_N_ELEMENTS(GIVEN_TIPS), MODE_COUNT = G_N_ELEMENTS(MODES) };
/* K_I and K_II have errors of 0.3 % of each other on a contour of 6 cells, and the angle of twice
 * that; the body has moved for a step. */
static const double ANGLE = 0.008;

static void give_field(struct test_run *run, const struct williams_field *field)
{
    size_t count;
    double *const place = test_run_field(run, MPM_FIELD_POSITION, &count);
    double *const f = g_new0(double, GRADIENT *count);
    for (size_t p = 0; p < count; p++) {
        williams_field_gradient(field, place + AXES * p, f + GRADIENT * p);
        f[GRADIENT * p] += 1.0;
        f[GRADIENT * p + 3] += 1.0;
        f[GRADIENT * p + 4] = 1.0;
    }
    ck_assert_int_eq(mpm_simulation_set_start(run->simulation, NULL, f, NULL), MPM_OK);
    g_free(f);
    free(place);
}

START_TEST(a_tip_turns_across_the_largest_hoop_stress)
{
    const struct given_tip *const tip = &GIVEN_TIPS[_i / MODE_COUNT];
    const double *const mode = MODES[_i % MODE_COUNT];
    char *const crack = g_strdup_printf(
        "cracks=[{points: %s, contact: none, j_integral: [{tip: %s, contour: 6, dynamic: false, "
        "propagation: {toughness: 1e-12, longest: 8, direction: hoop_stress}}]}]",
        tip->points, tip->tip);
    const char *const settings[] = {crack, "bodies.block.velocity=[0, 0]", NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    const double poisson = (3.0 * 80.0 - 2.0 * 48.0) / (2.0 * (3.0 * 80.0 + 48.0));
    const struct williams_field field = {
        .mode_1 = 1e-4 * mode[0],
        .mode_2 = 1e-4 * mode[1],
        .shear = 48.0,
        .kappa = 3.0 - 4.0 * poisson,
        .tip = {18.3, 11.3},
        .direction = {tip->direction[0], tip->direction[1]},
    };
    struct williams_field level = field;
    level.direction[0] = 1.0;
    level.direction[1] = 0.0;
    give_field(&run, &field);
    test_run_steps(&run, 1);
    const struct mpm_j_integral value = test_run_j_integral(&run, 0);
    const double expected = largest_hoop(&level), *const d = tip->direction;
    const double moved[AXES] = {value.tip[0] - 18.3, value.tip[1] - 11.3};
    ck_assert_near(value.grown, INCREMENT, 1e-12);
    ck_assert_near(atan2(d[0] * moved[1] - d[1] * moved[0], d[0] * moved[0] + d[1] * moved[1]),
                   expected, ANGLE);
    ck_assert_near(atan2(d[0] * value.direction[1] - d[1] * value.direction[0],
                         d[0] * value.direction[0] + d[1] * value.direction[1]),
                   expected, ANGLE);
    g_free(crack);
    test_run_close(&run);
}
END_TEST

static const struct refusal {
    const char *setting, *message;
} REFUSALS[] = {
    {"cracks=[{points: [[0.2, 11.2], [14.3, 11.2]], contact: none, j_integral: [{contour: 4, "
     "propagation: {toughness: 1, longest: 8}}, {contour: 5, propagation: {toughness: 1, longest: "
     "8}}]}]",
     "grows by cracks.0.j_integral.0 already"},
    {CRACK("{toughness: 0, longest: 8}"), "allowed: number above 0"},
};

START_TEST(growth_that_is_not_defined_is_refused_with_the_reason)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    char *const folder = test_folder_create();
    char *const path = test_folder_write(folder, "scene.yaml", BLOCK);
    ck_assert_int_eq(mpm_scene_read(path, &REFUSALS[_i].setting, 1, &scene, &error), MPM_BAD_INPUT);
    test_contains(error.message, REFUSALS[_i].message);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

/* Room for a crack to grow moves the points of those after it, and nothing else. */
START_TEST(a_crack_that_may_grow_leaves_the_openings_of_others_alone)
{
#define MAY_GROW                                                                                   \
    "{points: [[0.2, 6.3], [14.3, 6.3]], contact: none, j_integral: [{contour: 4, propagation: "   \
    "{toughness: 1e9, longest: 8}}]}"
#define HELD                                                                                       \
    "{points: [[0.2, 15.1], [2, 15.1], [14.3, 15.1]], contact: none, cohesive: {law: linear, "     \
    "strength: 0.1, "                                                                              \
    "toughness: 0.01, stiffness: 1}}"
    static const char *const cracks[] = {"cracks=[" MAY_GROW ", " HELD "]",
                                         "cracks=[" HELD ", " MAY_GROW "]"};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        runs[k] = test_run_open(BLOCK, (const char *const[]){cracks[k], NULL}, 1);
        test_run_steps(&runs[k], 40);
    }
    const size_t count = mpm_scene_crack_quantity_count(runs[0].scene);
    ck_assert_uint_gt(count, 0);
    for (size_t k = 0; k < count; k++)
        ck_assert_double_eq(mpm_simulation_crack_quantity(runs[0].simulation, k),
                            mpm_simulation_crack_quantity(runs[1].simulation, k));
    struct mpm_ledger one, other;
    mpm_simulation_ledger(runs[0].simulation, &one);
    mpm_simulation_ledger(runs[1].simulation, &other);
    ck_assert_double_gt(one.cohesive_stored, 0.0);
    ck_assert_double_eq(one.cohesive_stored, other.cohesive_stored);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

Suite *suite_crack_growth(void)
{
    Suite *suite = suite_create("crack_growth");
    TCase *growth = tcase_create("growth");
    tcase_add_loop_test(growth, a_tip_grows_straight_on_by_increments_and_counts_its_work, 0, 2);
    tcase_add_test(growth, a_tough_crack_is_one_that_does_not_grow);
    tcase_add_test(growth, a_growing_crack_gives_the_same_bits_for_any_number_of_threads);
    tcase_add_loop_test(growth, a_run_whose_crack_cannot_grow_goes_back_by_growing_again, 0,
                        G_N_ELEMENTS(ENDINGS));
    tcase_add_loop_test(growth, a_tip_turns_across_the_largest_hoop_stress, 0,
                        GIVEN_COUNT * MODE_COUNT);
    tcase_add_loop_test(growth, growth_that_is_not_defined_is_refused_with_the_reason, 0,
                        G_N_ELEMENTS(REFUSALS));
    tcase_add_test(growth, a_crack_that_may_grow_leaves_the_openings_of_others_alone);
    suite_add_tcase(suite, growth);
    return suite;
}
