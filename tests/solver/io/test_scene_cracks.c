/* Cracks and planes of symmetry: how scenes state them, what is refused, which nodes a plane
 * holds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/boundary.h"
#include "model/grid.h"
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char CRACKED[] = "tests/scenes/good/cracks.yaml";

/* ------------------------------------------------------------------ content */

START_TEST(cracks_say_what_their_file_says)
{
    struct mpm_scene *scene = test_scene_read(CRACKED, NULL);
    ck_assert_int_eq(scene->crack_method, MPM_CRACKS_VISIBILITY);
    ck_assert_uint_eq(scene->crack_count, 2);
    const struct mpm_crack_spec *const crack = &scene->cracks[1];
    ck_assert_uint_eq(crack->point_count, 3);
    ck_assert_double_eq(crack->points[1][0], 4.0);
    ck_assert_double_eq(crack->points[1][1], 5.5);
    ck_assert_int_eq(crack->contact, MPM_CONTACT_FRICTION);
    ck_assert_double_eq(crack->friction, 0.3);
    ck_assert_double_eq(crack->separated, 0.8);
    ck_assert_double_eq(crack->touching, 1.2);
    ck_assert_double_eq(crack->spacing, 0.25);
    ck_assert_int_eq(crack->line, 17);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_crack_has_the_documented_defaults)
{
    struct mpm_scene *scene = test_scene_read(TEST_MINIMAL_SCENE, NULL);
    ck_assert_int_eq(scene->crack_method, MPM_CRACKS_FIELDS);
    ck_assert_uint_eq(scene->crack_count, 0);
    ck_assert_ptr_null(scene->cracks);
    mpm_scene_free(scene);
    scene = test_scene_read(TEST_MINIMAL_SCENE, "cracks=[{points: [[1, 2], [2, 2]]}]");
    const struct mpm_crack_spec *const crack = &scene->cracks[0];
    ck_assert_int_eq(scene->crack_method, MPM_CRACKS_FIELDS);
    ck_assert_int_eq(crack->contact, MPM_CONTACT_FRICTIONLESS);
    ck_assert_double_eq(crack->friction, 0.0);
    ck_assert_double_eq(crack->separated, 0.9);
    ck_assert_double_eq(crack->touching, 1.1);
    ck_assert_double_eq(crack->spacing, 0.5);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_plane_of_symmetry_holds_its_normal_velocity_at_zero)
{
    struct mpm_scene *scene = test_scene_read(CRACKED, NULL);
    ck_assert_uint_eq(scene->boundary_count, 3);
    for (int i = 0; i < 2; i++) {
        const int normal = 1 - i; /* along x, then along y */
        const struct mpm_boundary_spec *const boundary = &scene->boundaries[i];
        ck_assert(boundary->symmetry);
        ck_assert_int_eq(boundary->normal, normal);
        ck_assert_str_eq(boundary->velocity.text[normal], "0");
        ck_assert_ptr_null(boundary->velocity.text[1 - normal]);
    }
    ck_assert(!scene->boundaries[2].symmetry);
    ck_assert_str_eq(scene->boundaries[2].velocity.text[1], "0.1");
    mpm_scene_free(scene);
}
END_TEST

/* ----------------------------------------------------------------- refusals */

/* A scene of two bodies, and the rest of the file: cracks begin in line 11. In axisymmetry the grid
 * has a column of cells behind the axis. */
static char *scene_with(const char *geometry, const char *method, const char *rest)
{
    const int behind = strcmp(geometry, "axisymmetric") == 0;
    return g_strdup_printf(
        "format: 1\ngeometry: %s\ngrid: {origin: [%d, 0], cell: [1, 1], cells: [%d, 8]}\n"
        "time: {end: 1}\nmethod: {%s}\nmaterials:\n"
        "  - {name: rubber, law: neo_hookean, density: 1, bulk: 100, shear: 50}\nbodies:\n"
        "  - {name: block, material: rubber, region: {rectangle: {from: [1, 1], to: [5, 5]}}}\n"
        "  - {name: wall, rigid: {velocity: [0, free]},"
        " region: {rectangle: {from: [6, 0], to: [8, 8]}}}\n%s\n",
        geometry, -behind, 8 + behind, method, rest);
}

#define PLANAR "plane_strain"
#define GOOD   "cracks: [{points: [[1, 3], [4, 3]]}]"

static const struct {
    const char *geometry, *method, *rest, *message;
} refused[] = {
    {PLANAR, "", "cracks: [{contact: stick}]", "11: cracks.0.points: missing"},
    {PLANAR, "", "cracks: [{points: [[1, 3]]}]",
     "11: cracks.0.points: wrong number of points, got a list of 1; allowed: list of 2 numbers 2 "
     "to 10000 points"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [2, 3], [2, 3]]}]",
     "11: cracks.0.points: a segment of no length, from point 1 (2, 3)"},
    {PLANAR, "", "cracks: [{points: [[1, 1], [4, 4], [4, 1], [1, 4]]}]",
     "11: cracks.0.points: the crack crosses or touches itself, with the segments that start at "
     "points 0 and 2"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3], [4, 4], [2, 3]]}]",
     "cracks.0.points: the crack crosses or touches itself"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3], [2, 3]]}]",
     "cracks.0.points: the crack crosses or touches itself, with the segments that start at "
     "points 0 and 1"},
    {PLANAR, "", "cracks: [{points: [[1, 1], [4, 1], [4, 4], [1, 1]]}]",
     "allowed: an open chain whose segments share only its points"},
    {PLANAR, "", "cracks:\n- {points: [[1, 3], [4, 3]]}\n- {points: [[1, 2], [3, 2], [3, 4]]}",
     "13: cracks.1.points: crosses or touches cracks.0, with the segment that starts at point 1"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]]}, {points: [[3, 3], [3, 4]]}]",
     "cracks.1.points: crosses or touches cracks.0"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [3, 3]]}, {points: [[3, 3.0000005], [4, 4]]}]",
     "cracks.1.points: crosses or touches cracks.0"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [3, 8.5]]}]",
     "11: cracks.0.points: point 1 is outside the grid, got y = 8.5; allowed: 0 to 8"},
    {"axisymmetric", "", "cracks: [{points: [[-0.1, 3], [3, 3]]}]",
     "11: cracks.0.points: point 0 is outside the grid, got r = -0.1; allowed: 0 to 8"},
    {PLANAR, "", "cracks: [{points: [[5.5, 3], [7, 3]]}]",
     "11: cracks.0.points: outside every deformable body, from (5.5, 3) on"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], contact: friction}]",
     "11: cracks.0.contact: friction without its coefficient"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], contact: stick, friction: 0}]",
     "11: cracks.0.friction: a coefficient, got 0, without contact: friction"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], contact: friction, friction: -0.1}]",
     "11: cracks.0.friction: out of range, got \"-0.1\"; allowed: number at least 0"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], contact: glue}]",
     "allowed: frictionless | friction | stick | none"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], separated: 1}]",
     "11: cracks.0.separated: out of range, got \"1\"; allowed: number between 0 and 1"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], touching: 1}]",
     "11: cracks.0.touching: out of range, got \"1\"; allowed: number above 1"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3]], spacing: 1.5}]",
     "11: cracks.0.spacing: out of range, got \"1.5\"; allowed: number from 0.05 to 1"},
    {PLANAR, "cracks: fields", "", "5: method.cracks: given for a scene without cracks"},
    {PLANAR, "cracks: fields", "cracks: []", "5: method.cracks: given for a scene without cracks"},
    {PLANAR, "cracks: some", GOOD,
     "5: method.cracks: unknown choice, got \"some\"; allowed: fields |"},
    {PLANAR, "transfer: {kind: apic}, cracks: visibility", GOOD,
     "5: method.cracks: visibility is not defined with transfer apic"},
    {PLANAR, "", "boundary: [{region: {line: {from: [0, 1], to: [8, 1]}}, symmetry: false}]",
     "11: boundary.0.symmetry: got false; allowed: true"},
    {PLANAR, "",
     "boundary: [{region: {line: {from: [0, 1], to: [8, 1]}}, symmetry: true, velocity: [0, 0]}]",
     "11: boundary.0: both of velocity and symmetry given"},
    {PLANAR, "", "boundary: [{region: all, symmetry: true}]",
     "11: boundary.0.symmetry: a plane of symmetry with a region other than a line"},
    {PLANAR, "", "boundary: [{region: {line: {from: [2, 1], to: [2, 1]}}, symmetry: true}]",
     "11: boundary.0.region.line: a plane of symmetry that is a single point, got (2, 1)"},
    {PLANAR, "", "boundary: [{region: {line: {from: [0, 0], to: [8, 1]}}, symmetry: true}]",
     "boundary.0.region.line: an oblique line"},
    {PLANAR, "", "boundary: [{region: {line: {from: [0, 1.1], to: [8, 1.1]}}, symmetry: true}]",
     "11: boundary.0.region.line: a plane of symmetry between nodes or off the grid, got y = 1.1, "
     "the nearest nodes are at 1"},
    {PLANAR, "", "boundary: [{region: {line: {from: [9, 0], to: [9, 8]}}, symmetry: true}]",
     "between nodes or off the grid, got x = 9, the nearest nodes are at 8"},
    {"axisymmetric", "", "boundary: [{region: {line: {from: [0, 0], to: [0, 8]}}, symmetry: true}]",
     "11: boundary.0.region.line: a plane of symmetry at r = 0; allowed: r above 0"},
};

START_TEST(a_crack_or_plane_that_cannot_be_is_refused_with_its_place)
{
    char *text = scene_with(refused[_i].geometry, refused[_i].method, refused[_i].rest);
    char *message = test_scene_refusal_of_text(text);
    test_contains(message, refused[_i].message);
    g_free(message);
    g_free(text);
}
END_TEST

/* Segments are compared pair by pair, so that points are limited. */
START_TEST(all_cracks_together_may_have_10000_points)
{
    enum { HALF = 5000 };
    GString *cracks = g_string_new("cracks:");
    for (int crack = 0; crack < 2; crack++) {
        g_string_append(cracks, "\n- {points: [");
        for (int i = 0; i <= HALF; i++)
            g_string_append_printf(cracks, "[%.4f, %d], ", 5e-4 * i, 2 + crack);
        g_string_append(cracks, "[4, 3.5]]}");
    }
    char *text = scene_with(PLANAR, "", cracks->str);
    char *message = test_scene_refusal_of_text(text);
    test_contains(message, "cracks: too many points, got 10004 in all cracks");
    g_free(message);
    g_free(text);
    g_string_free(cracks, TRUE);
}
END_TEST

/* Near to what is refused, and good. */
static const struct {
    const char *geometry, *method, *rest;
} accepted[] = {
    {PLANAR, "transfer: {kind: pic}", GOOD},
    {PLANAR, "transfer: {kind: flip, fraction: 0.9}", GOOD},
    {PLANAR, "cracks: fields", GOOD},
    {PLANAR, "", "cracks: [{points: [[0, 3], [5, 3]]}, {points: [[0, 3.01], [5, 3.01]]}]"},
    {PLANAR, "", "cracks: [{points: [[1, 3], [4, 3], [1, 3.01]]}]"},
    {PLANAR, "", "cracks: [{points: [[0, 0], [8, 8]], contact: friction, friction: 0}]"},
    {PLANAR, "", GOOD "\nloads: {tractions: [{body: block, edge: top, value: [0, 1]}]}"},
    {"axisymmetric", "", "cracks: [{points: [[0, 3], [4, 3]]}]"},
    {"axisymmetric", "",
     "boundary: [{region: {line: {from: [0, 0], to: [8, 0]}}, symmetry: true}]"},
};

START_TEST(a_crack_or_plane_that_is_near_to_one_that_cannot_be_is_read)
{
    char *text = scene_with(accepted[_i].geometry, accepted[_i].method, accepted[_i].rest);
    mpm_scene_free(test_scene_read_text(text));
    g_free(text);
}
END_TEST

/* On an edge but for round-off, wherever the body moves: neither moved there nor lost. */
START_TEST(points_a_rounding_error_outside_of_the_grid_are_on_its_edge)
{
    static const double outside = 5e-10;
    const char *const settings[] = {
        "cracks=[{points: [[-5e-10, 3.1], [8.0000000005, 3.1]]}]",
        "bodies=[{name: block, material: rubber, velocity: [0, 0.1], region: {rectangle: {from: "
        "[0, 1], to: [8, 7]}}}]",
        NULL};
    char *text = scene_with(PLANAR, "", GOOD);
    struct test_run run = test_run_open(text, settings, 1);
    const struct mpm_crack_chain *const chain = &run.simulation->state.cracks.chains[0];
    test_run_steps(&run, 3);
    ck_assert_near(chain->x[0], -outside, 1e-15);
    ck_assert_near(chain->x[chain->count - 1], 8.0 + outside, 1e-14);
    ck_assert(chain->y[0] > 3.1);
    test_run_close(&run);
    g_free(text);
}
END_TEST

/* --------------------------------------------------------------- conditions */

static double at_rest(const void *context, int32_t boundary, int32_t component,
                      const double position[2], double time)
{
    (void)context, (void)boundary, (void)component, (void)position, (void)time;
    return 0.0;
}

/* How many nodes have a condition, and the box around them. */
static size_t held_nodes(const char *setting, double low[2], double high[2])
{
    struct mpm_scene *scene = test_scene_read(TEST_MINIMAL_SCENE, setting);
    const struct mpm_grid grid = mpm_grid_describe(scene);
    struct mpm_condition *conditions = NULL;
    struct mpm_error error = {.message = ""};
    size_t count = 0;
    ck_assert_int_eq(mpm_conditions_list(scene, &grid, at_rest, NULL, &conditions, &count, &error),
                     MPM_OK);
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = HUGE_VAL;
        high[axis] = -HUGE_VAL;
    }
    for (size_t k = 0; k < count; k++) {
        double position[2];
        ck_assert_int_eq(conditions[k].component, 1);
        mpm_grid_position(&grid, conditions[k].node, position);
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], position[axis]);
            high[axis] = fmax(high[axis], position[axis]);
        }
    }
    free(conditions);
    mpm_scene_free(scene);
    return count;
}

/* Cells of 1, nodes from 0 to 4, two ghost rows at each side. */
START_TEST(a_plane_of_symmetry_holds_its_own_nodes_and_none_behind)
{
    double low[2], high[2];
    const size_t wall = held_nodes(
        "boundary=[{region: {line: {from: [0, 0], to: [4, 0]}}, velocity: [free, 0]}]", low, high);
    ck_assert_uint_eq(wall, 9 * 3);
    ck_assert_double_eq(low[1], -2.0);
    const size_t plane = held_nodes(
        "boundary=[{region: {line: {from: [0, 0], to: [4, 0]}}, symmetry: true}]", low, high);
    ck_assert_uint_eq(plane, 9);
    ck_assert_double_eq(low[1], 0.0);
    ck_assert_double_eq(high[1], 0.0);
    ck_assert_double_eq(low[0], -2.0);
    ck_assert_double_eq(high[0], 6.0);
}
END_TEST

Suite *suite_scene_cracks(void)
{
    Suite *suite = suite_create("scene cracks");
    TCase *content = tcase_create("content");
    tcase_add_test(content, cracks_say_what_their_file_says);
    tcase_add_test(content, a_crack_has_the_documented_defaults);
    tcase_add_test(content, a_plane_of_symmetry_holds_its_normal_velocity_at_zero);
    suite_add_tcase(suite, content);
    TCase *refusals = tcase_create("refusals");
    tcase_add_loop_test(refusals, a_crack_or_plane_that_cannot_be_is_refused_with_its_place, 0,
                        G_N_ELEMENTS(refused));
    tcase_add_loop_test(refusals, a_crack_or_plane_that_is_near_to_one_that_cannot_be_is_read, 0,
                        G_N_ELEMENTS(accepted));
    tcase_add_test(refusals, all_cracks_together_may_have_10000_points);
    tcase_add_test(refusals, points_a_rounding_error_outside_of_the_grid_are_on_its_edge);
    suite_add_tcase(suite, refusals);
    TCase *conditions = tcase_create("conditions");
    tcase_add_test(conditions, a_plane_of_symmetry_holds_its_own_nodes_and_none_behind);
    suite_add_tcase(suite, conditions);
    return suite;
}
