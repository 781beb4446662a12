/* Numerical fracture: pairs of neighbours that have no node in common.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>

/* Two halves that fly apart across x = 6 between particles at 5.75 and 6.25. */
#define SCENE                                                                                      \
    "format: 1\ngeometry: plane_strain\n"                                                          \
    "grid: {cell: [1, 0.8], cells: [12, 8]}\n"                                                     \
    "time: {end: 1, step: 0.01}\n"                                                                 \
    "materials: [{name: soft, law: von_mises, density: 1, bulk: 3, shear: 1, yield_stress: "       \
    "0.1}]\n"                                                                                      \
    "bodies:\n"                                                                                    \
    "  - {name: block, material: soft, region: {rectangle: {from: [4, 1.6], to: [8, 4]}},\n"       \
    "     velocity: [\"x > 6 ? 3 : -3\", 0]}\n"

static struct test_run open_with(const char *setting)
{
    const char *const settings[] = {setting, NULL};
    return test_run_open(SCENE, settings, 1);
}

/* Nodes along an axis that a particle at x reaches, of a domain from -half to half. */
static void reach_of(double x, double half, double cell, double range[2])
{
    range[0] = floor((x - half) / cell);
    range[1] = ceil((x + half) / cell);
}

static bool have_a_node(const double a[2], const double b[2], const double half[2])
{
    static const double cell[2] = {1.0, 0.8};
    for (int axis = 0; axis < 2; axis++) {
        double one[2], other[2];
        reach_of(a[axis], half[axis], cell[axis], one);
        reach_of(b[axis], half[axis], cell[axis], other);
        if (one[0] >= other[1] || other[0] >= one[1]) /* at ranges' ends weights are 0 */
            return fmax(one[0], other[0]) == fmin(one[1], other[1]);
    }
    return true;
}

/* By all pairs of particles that were one spacing apart. */
static uint64_t count_by_hand(const double *start, const double *now, size_t count,
                              const double half[2], uint64_t *pairs)
{
    uint64_t parted = 0;
    *pairs = 0;
    for (size_t i = 0; i < count; i++)
        for (size_t j = i + 1; j < count; j++) {
            const double x = fabs(start[2 * i] - start[2 * j]) / (2.0 * half[0]);
            const double y = fabs(start[2 * i + 1] - start[2 * j + 1]) / (2.0 * half[1]);
            if (fabs(x + y - 1.0) > 1e-9)
                continue;
            ++*pairs;
            parted += !have_a_node(&now[2 * i], &now[2 * j], half);
        }
    return parted;
}

START_TEST(parted_pairs_are_those_without_a_common_node)
{
    static const double half[2] = {0.25, 0.2};
    struct test_run run = test_run_open(SCENE, NULL, 1);
    const size_t count = mpm_simulation_particle_count(run.simulation);
    double *const start = g_new(double, 2 * count), *const now = g_new(double, 2 * count);
    uint64_t last = 0, pairs = 0;
    mpm_simulation_field(run.simulation, MPM_FIELD_POSITION, start);
    for (int k = 0; k <= 60; k++) {
        struct mpm_ledger ledger;
        mpm_simulation_ledger(run.simulation, &ledger);
        mpm_simulation_field(run.simulation, MPM_FIELD_POSITION, now);
        ck_assert_uint_eq(ledger.parted_pairs, count_by_hand(start, now, count, half, &pairs));
        ck_assert(k > 0 || ledger.parted_pairs == 0);
        last = ledger.parted_pairs;
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, NULL), MPM_OK);
    }
    ck_assert_uint_eq(last, 6); /* one a row of particles */
    ck_assert_uint_eq(pairs, 6 * 7 + 5 * 8);
    g_free(start);
    g_free(now);
    test_run_close(&run);
}
END_TEST

static const char *const shapes[] = {"method.shape=classic", "method.shape=ugimp",
                                     "method.shape=cpdi", "method.shape=bspline2",
                                     "method.shape=bspline3"};
enum { SHAPES = sizeof shapes / sizeof shapes[0], CONVECTED = 2 };

START_TEST(each_family_but_cpdi_sees_that_the_halves_part)
{
    struct test_run run = open_with(shapes[_i]);
    struct mpm_ledger ledger;
    mpm_simulation_ledger(run.simulation, &ledger);
    ck_assert_uint_eq(ledger.parted_pairs, 0);
    for (int k = 0; k < 100 && ledger.parted_pairs == 0; k++) {
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 1.0, NULL), MPM_OK);
        mpm_simulation_ledger(run.simulation, &ledger);
    }
    /* domains of CPDI stretch with the body, and reach each other as long as F is finite */
    if (_i == CONVECTED)
        ck_assert_uint_eq(ledger.parted_pairs, 0);
    else
        ck_assert_uint_ge(ledger.parted_pairs, 6);
    ck_assert(mpm_scene_counts_parted(run.scene));
    test_run_close(&run);
}
END_TEST

START_TEST(scenes_without_plastic_strain_have_no_pairs)
{
    struct test_run run =
        open_with("materials.soft={name: soft, law: neo_hookean, density: 1, bulk: 3, shear: 1}");
    ck_assert(!mpm_scene_counts_parted(run.scene));
    struct mpm_ledger ledger;
    mpm_simulation_ledger(run.simulation, &ledger);
    ck_assert_uint_eq(ledger.parted_pairs, 0);
    test_run_close(&run);
}
END_TEST

Suite *suite_parting(void)
{
    Suite *const suite = suite_create("parting");
    TCase *const tests = tcase_create("pairs");
    tcase_add_test(tests, parted_pairs_are_those_without_a_common_node);
    tcase_add_loop_test(tests, each_family_but_cpdi_sees_that_the_halves_part, 0, SHAPES);
    tcase_add_test(tests, scenes_without_plastic_strain_have_no_pairs);
    suite_add_tcase(suite, tests);
    return suite;
}
