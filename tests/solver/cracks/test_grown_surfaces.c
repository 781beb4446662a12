/* Surfaces that a crack grows: their contact, their openings and their cohesive law.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/cohesive_traction.h"
#include "method/cracks/crack_fields.h"
#include "simulation/simulation.h"
#include "suites.h"
#include "support/crack_blocks.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2 };

/* Wave speed 8.5; a strip of 24 by 24 cells. */
static const char BLOCK[] = BLOCK_OF_GROWTH("");

/* ------------------------------------------------------------------- contact */

static const char *const METHODS[] = {
    "method={shape: ugimp}",
    "method={shape: cpdi, stress_update: usl, transfer: {kind: apic}}",
    "method={shape: bspline2, stress_update: usf, transfer: {kind: flip, fraction: 0.9}}",
    "method={shape: cpdi, stress_update: usavg}",
};
/* Fields that stick, or have friction enough, move as one. Without friction those of nodes around a
 * tip have particles of different places along the crack, and slide by what the block stretches
 * there. */
static const char *const CONTACTS[] = {
    "contact: stick, detection: volume",
    "contact: stick, detection: displacement",
    "contact: friction, friction: 100, detection: volume",
    "contact: friction, friction: 100, detection: displacement",
};
static const double CLOSED = 1e-13; /* round-off over 36 steps */

/* A crack along a line of nodes, from the left end of the block to `tip` and on. */
static struct test_run open_pressed(const char *method, const char *contact, double tip, bool grows)
{
    char *const cracks = g_strdup_printf(
        "cracks=[{points: [[0.2, 11.2], [%.17g, 11.2]], %s, j_integral: [{contour: 3%s}]}]", tip,
        contact, grows ? ", propagation: {toughness: 1e-12, longest: 12, every: 2}" : "");
    const char *const settings[] = {
        cracks, method, "bodies.block.velocity=[0, '-0.02*(y - 11.2)*(1 + 0.02*x)']", NULL};
    const struct test_run run = test_run_open(BLOCK, settings, 1);
    g_free(cracks);
    return run;
}

static void check_same_state(const struct test_run *one, const struct test_run *other)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT};
    static const size_t width[] = {2, 2, 5};
    for (size_t i = 0; i < G_N_ELEMENTS(fields); i++) {
        size_t count;
        double *const mine = test_run_field(one, fields[i], &count);
        double *const theirs = test_run_field(other, fields[i], &count);
        for (size_t k = 0; k < width[i] * count; k++)
            ck_assert_near(mine[k], theirs[k], CLOSED);
        free(mine);
        free(theirs);
    }
}

/* For 36 steps: waves from the ends open it then. */
START_TEST(a_pressed_crack_that_has_grown_is_one_that_was_there_from_the_start)
{
    const char *const method = METHODS[_i / (int)G_N_ELEMENTS(CONTACTS)];
    const char *const contact = CONTACTS[_i % (int)G_N_ELEMENTS(CONTACTS)];
    struct test_run grown = open_pressed(method, contact, 9.3, true);
    test_run_steps(&grown, 36);
    const struct mpm_j_integral tip = test_run_j_integral(&grown, 0);
    ck_assert_msg(tip.grown > 6.0, "grown by %g", tip.grown);
    struct test_run whole = open_pressed(method, contact, 9.3 + tip.grown, false);
    test_run_steps(&whole, 36);
    check_same_state(&grown, &whole);
    ck_assert_near(tip.j[0], test_run_j_integral(&whole, 0).j[0], 10.0 * CLOSED);
    test_run_close(&grown);
    test_run_close(&whole);
}
END_TEST

/* In the undeformed body, which a body that turns as it grows has left behind. */
START_TEST(a_grown_point_has_its_place_in_the_undeformed_body)
{
    static const char *const cracks[] = {
        "cracks=[{points: [[0.2, 11.2], [14.3, 11.2]], detection: displacement, j_integral: "
        "[{contour: 4, propagation: {toughness: 1e-9, longest: 8, every: 5}}]}]",
        "cracks=[{points: [[14.3, 11.2], [0.2, 11.2]], detection: displacement, j_integral: "
        "[{tip: start, contour: 4, propagation: {toughness: 1e-9, longest: 8, every: 5}}]}]",
    };
    /* Turns by 0.04 a unit of time, and is drawn apart a little. */
    const char *const settings[] = {
        cracks[_i], "bodies.block.velocity=['-0.04*(y - 11.2)', '0.04*(x - 18) + 0.01*(y - 11.2)']",
        NULL};
    struct test_run run = test_run_open(BLOCK, settings, 1);
    test_run_steps(&run, 60);
    const double grown = test_run_j_integral(&run, 0).grown;
    const struct mpm_cracks *const state = &run.simulation->state.cracks;
    const struct mpm_crack_chain *const chain = &state->undeformed[0];
    const size_t points = (size_t)llround(grown / 0.4);
    ck_assert_uint_gt(points, 3);
    ck_assert_uint_eq(chain->count, 2 + points);
    for (size_t k = 0; k <= points; k++) {
        const size_t at = _i == 0 ? 1 + k : points - k;
        ck_assert_near(chain->x[at], 14.3 + 0.4 * (double)k, 1e-12);
        ck_assert_near(chain->y[at], 11.2, 1e-12);
    }
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------------ cohesive */

#define LAW    "cohesive: {law: linear, strength: 0.1, toughness: 0.002, stiffness: 20}"
#define GROWTH "propagation: {toughness: 2e-4, longest: 12, every: 12}"
#define PULLED "bodies.block.velocity=[0, '0.02*(y - 11.2)']"
static const double TOUGHNESS = 0.002, FULL = 0.04; /* per area; opening without traction */

/* Also from the other end of the chain, and per radian. */
static const struct cohesive_case {
    const char *cracks, *geometry;
    bool at_start;
} COHESIVE[] = {
    {"cracks=[{points: [[1, 11.2], [2, 11.2], [10.3, 11.2]], contact: none, " LAW
     ", j_integral: [{contour: 3, " GROWTH "}]}]",
     "geometry=plane_strain", false},
    {"cracks=[{points: [[10.3, 11.2], [2, 11.2], [1, 11.2]], contact: none, " LAW
     ", j_integral: [{tip: start, contour: 3, " GROWTH "}]}]",
     "geometry=plane_strain", true},
    {"cracks=[{points: [[1, 11.2], [2, 11.2], [10.3, 11.2]], contact: none, " LAW
     ", j_integral: [{contour: 3, " GROWTH "}]}]",
     "geometry=axisymmetric", false},
};

static struct test_run open_cohesive(int index, const char *method)
{
    const struct cohesive_case *const own = &COHESIVE[index];
    const bool curved = strstr(own->geometry, "axi") != NULL;
    const char *const settings[] = {own->cracks,
                                    own->geometry,
                                    method,
                                    "output.energy_balance=true",
                                    curved ? "bodies.block.velocity=[0, '0.02*(z - 11.2)']"
                                           : PULLED,
                                    NULL};
    GString *const text = g_string_new(BLOCK);
    if (curved)
        g_string_replace(text, "thickness: 2\n", "", 1);
    const struct test_run run = test_run_open(text->str, settings, 1);
    g_string_free(text, TRUE);
    return run;
}

/* Area of the undeformed crack in the block, from x = 2 on. */
static double area_to(const struct test_run *run, double x)
{
    return run->scene->geometry == MPM_AXISYMMETRIC ? 0.5 * (x * x - 4.0) : 2.0 * (x - 2.0);
}

START_TEST(a_point_that_a_cohesive_crack_grows_is_closed_and_has_its_full_law)
{
    struct test_run run = open_cohesive(_i, "method={shape: ugimp}");
    const struct mpm_state *const state = &run.simulation->state;
    const struct mpm_crack_openings *const openings = &state->cracks.openings;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[0];
    double grown = 0.0, area = 0.0;
    for (int k = 0; k < 100; k++) {
        test_run_steps(&run, 1);
        const double now = test_run_j_integral(&run, 0).grown;
        const size_t first = mpm_crack_first_point(state, 0);
        const size_t tip = COHESIVE[_i].at_start ? 0 : chain->count - 1;
        double traction[AXES];
        if (now == grown)
            continue;
        grown = now;
        for (int axis = 0; axis < AXES; axis++)
            ck_assert_double_eq(openings->vector[axis][first + tip], 0.0);
        ck_assert_double_eq(openings->largest[first + tip], 0.0);
        mpm_cohesive_traction_at(state, 0, first, tip, traction);
        ck_assert_double_eq(traction[1], 0.0);
        area = 0.0;
        for (size_t p = 0; p < chain->count; p++)
            area += openings->area[first + p];
        ck_assert_near(area, area_to(&run, 10.3 + grown), 1e-12 * area);
    }
    ck_assert_msg(grown > 2.0, "grown by %g", grown);
    test_run_close(&run);
}
END_TEST

/* Total energy has what the law stores and takes: the area that is added must come without any. */
START_TEST(the_balance_of_energy_closes_while_a_cohesive_crack_grows)
{
    const int cases = (int)G_N_ELEMENTS(COHESIVE);
    struct test_run run =
        _i < cases ? open_cohesive(_i, METHODS[0]) : open_cohesive(0, METHODS[_i - cases + 1]);
    struct mpm_ledger before = test_run_ledger(&run);
    const double start = before.total_energy;
    for (int k = 0; k < 100; k++) {
        test_run_steps(&run, 1);
        const struct mpm_ledger now = test_run_ledger(&run);
        const double held = now.total_energy + now.transfer_loss - now.external_work;
        ck_assert_near(held, before.total_energy + before.transfer_loss - before.external_work,
                       1e-13 * start);
        before = now;
    }
    ck_assert_double_ge(test_run_j_integral(&run, 0).grown, 2.0 - 1e-9);
    ck_assert_double_gt(before.cohesive_dissipated, 0.0);
    test_run_close(&run);
}
END_TEST

/* Each area that has been torn has taken its toughness, and what is not torn less. */
START_TEST(tearing_a_crack_that_has_grown_takes_its_toughness_times_the_grown_area)
{
    struct test_run run = open_cohesive(_i, "method={shape: ugimp}");
    const struct mpm_crack_openings *const openings = &run.simulation->state.cracks.openings;
    const struct mpm_crack_chain *const chain = &run.simulation->state.cracks.chains[0];
    test_run_steps(&run, 250);
    const size_t first = mpm_crack_first_point(&run.simulation->state, 0);
    const double end = 10.3 + test_run_j_integral(&run, 0).grown;
    double torn = 0.0;
    size_t grown = 0; /* points that are torn, of those that have been added */
    for (size_t k = 0; k < chain->count; k++)
        if (openings->largest[first + k] >= FULL) {
            torn += openings->area[first + k];
            grown += chain->x[k] > 10.4;
        }
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_msg(grown >= 8, "%zu points that have grown are torn", grown);
    ck_assert_double_ge(ledger.cohesive_dissipated, TOUGHNESS * torn * (1.0 - 1e-12));
    ck_assert_double_le(ledger.cohesive_dissipated + ledger.cohesive_stored,
                        TOUGHNESS * area_to(&run, end));
    test_run_close(&run);
}
END_TEST

/* -------------------------------------------------------------------- repeat */

static void check_points(const struct mpm_cracks *one, const struct mpm_cracks *other)
{
    const double *const mine[] = {one->position[0],        one->position[1],
                                  one->openings.vector[0], one->openings.vector[1],
                                  one->openings.largest,   one->openings.area};
    const double *const theirs[] = {other->position[0],        other->position[1],
                                    other->openings.vector[0], other->openings.vector[1],
                                    other->openings.largest,   other->openings.area};
    for (size_t k = 0; k < G_N_ELEMENTS(mine); k++)
        ck_assert(memcmp(mine[k], theirs[k], one->point_count * sizeof(double)) == 0);
    ck_assert_uint_eq(one->undeformed[0].count, other->undeformed[0].count);
    for (size_t k = 0; k < one->undeformed[0].count; k++) {
        ck_assert_double_eq(one->undeformed[0].x[k], other->undeformed[0].x[k]);
        ck_assert_double_eq(one->undeformed[0].y[k], other->undeformed[0].y[k]);
    }
}

/* There is room for five increments; the sixth fails the run, which goes back. */
START_TEST(a_failed_run_goes_back_to_the_surfaces_that_had_grown)
{
    static const char *const cracks[] = {
        "cracks=[{points: [[1, 11.2], [2, 11.2], [10.3, 11.2]], detection: displacement, " LAW
        ", j_integral: [{contour: 3, propagation: {toughness: 2e-4, longest: 2, every: 4}}]}]",
        "cracks=[{points: [[10.3, 11.2], [2, 11.2], [1, 11.2]], detection: volume, " LAW
        ", j_integral: [{tip: start, contour: 3, propagation: {toughness: 2e-4, longest: 2, every: "
        "4}}]}]",
    };
    const char *const settings[] = {cracks[_i], PULLED, NULL};
    struct test_run failed = test_run_open(BLOCK, settings, 1);
    struct test_run good = test_run_open(BLOCK, settings, 1);
    int steps = 0;
    while (steps < 300 && mpm_simulation_advance(failed.simulation, HUGE_VAL, NULL) == MPM_OK)
        steps++;
    ck_assert_int_lt(steps, 300);
    test_run_steps(&good, steps);
    ck_assert(test_run_same_bits(&failed, &good));
    ck_assert_near(test_run_j_integral(&failed, 0).grown, 2.0, 1e-12);
    check_points(&failed.simulation->state.cracks, &good.simulation->state.cracks);
    test_run_close(&failed);
    test_run_close(&good);
}
END_TEST

START_TEST(grown_surfaces_have_the_same_bits_for_any_number_of_threads)
{
    static const char cracks[] =
        "cracks=[{points: [[1, 11.2], [2, 11.2], [10.3, 11.2]], detection: volume, " LAW
        ", j_integral: [{contour: 3, " GROWTH "}]}]";
    const char *const settings[] = {cracks, PULLED, "method.shape=cpdi", NULL};
    test_same_bits_over_threads(BLOCK, settings, 60, NULL);
}
END_TEST

Suite *suite_grown_surfaces(void)
{
    Suite *suite = suite_create("grown_surfaces");
    TCase *grown = tcase_create("grown");
    const int cases = (int)G_N_ELEMENTS(COHESIVE), methods = (int)G_N_ELEMENTS(METHODS);
    tcase_add_loop_test(grown, a_pressed_crack_that_has_grown_is_one_that_was_there_from_the_start,
                        0, methods * (int)G_N_ELEMENTS(CONTACTS));
    tcase_add_loop_test(grown, a_grown_point_has_its_place_in_the_undeformed_body, 0, 2);
    tcase_add_loop_test(grown, a_point_that_a_cohesive_crack_grows_is_closed_and_has_its_full_law,
                        0, cases);
    tcase_add_loop_test(grown, the_balance_of_energy_closes_while_a_cohesive_crack_grows, 0,
                        cases + methods - 1);
    tcase_add_loop_test(
        grown, tearing_a_crack_that_has_grown_takes_its_toughness_times_the_grown_area, 0, cases);
    tcase_add_loop_test(grown, a_failed_run_goes_back_to_the_surfaces_that_had_grown, 0, 2);
    tcase_add_test(grown, grown_surfaces_have_the_same_bits_for_any_number_of_threads);
    suite_add_tcase(suite, grown);
    return suite;
}
