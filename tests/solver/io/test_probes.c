/* Probes, lines, derived fields and crack lines of a run's output.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/results.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A block that moves as a whole, and one that is sheared evenly at the start. */
#define SCENE(velocity, more, output)                                                              \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "units: {length: mm, mass: g, time: ms}\n"                                                     \
    "grid: {cell: [1, 0.5], cells: [12, 16]}\n"                                                    \
    "time: {end: 0.5, step: 0.05}\n"                                                               \
    "materials: [{name: rubber, law: neo_hookean, density: 2, bulk: 1, shear: 1}]\n"               \
    "bodies:\n"                                                                                    \
    "  - {name: block, material: rubber, velocity: [" velocity "],\n"                              \
    "     region: {rectangle: {from: [2, 2], to: [8, 6]}}}\n" more "output: " output "\n"

static const char probed[] =
    SCENE("0.4, 0.2", "",
          "{history: 0.1, snapshots: 0.5, probes: [{name: inside, at: [5, 4]}, {name: outside, at: "
          "[11, 7]}], lines: [{name: cut, from: [2, 4], to: [8, 5], points: 4}]}");

static char *csv(const char *name)
{
    char *const path = test_folder_path(test_results.output, name);
    char *const text = test_file_read(path);
    g_free(path);
    return text;
}

/* A value of probes.csv: of the n-th row of that name and point. */
static double value_of(const char *text, const char *column, const char *name, int point, int n)
{
    char **const lines = g_strsplit(text, "\n", -1), **const names = g_strsplit(lines[0], ",", -1);
    int k = 0, found = 0;
    double value = (double)INFINITY;
    while (names[k] != NULL && strcmp(names[k], column) != 0)
        k++;
    ck_assert_msg(names[k] != NULL, "no column %s in %s", column, lines[0]);
    for (int row = 2; lines[row] != NULL && lines[row][0] != '\0'; row++) {
        char **const values = g_strsplit(lines[row], ",", -1);
        ck_assert_uint_eq(g_strv_length(values), g_strv_length(names));
        if (strcmp(values[2], name) == 0 && (int)strtol(values[3], NULL, 10) == point &&
            found++ == n)
            value = g_ascii_strtod(values[k], NULL);
        g_strfreev(values);
    }
    g_strfreev(names);
    g_strfreev(lines);
    ck_assert_msg(isnan(value) || isfinite(value), "no row %d of %s %d", n, name, point);
    return value;
}

/* Means of one value, with weights that add up to 1: a few roundings of it. */
static const double mean_tolerance = 1e-12;

START_TEST(probes_have_the_fields_at_their_places)
{
    test_results_scene(probed);
    test_results_run_well();
    char *const text = csv("probes.csv");
    for (int n = 0; n < 6; n++) {
        ck_assert_double_eq_tol(value_of(text, "time", "inside", 0, n), 0.1 * n, 1e-9);
        ck_assert_double_eq_tol(value_of(text, "velocity_x", "inside", 0, n), 0.4, mean_tolerance);
        ck_assert_double_eq_tol(value_of(text, "velocity_y", "inside", 0, n), 0.2, mean_tolerance);
        ck_assert(isnan(value_of(text, "velocity_x", "outside", 0, n)));
        ck_assert(value_of(text, "weight", "outside", 0, n) == 0.0);
    }
    for (int k = 0; k < 4; k++) {
        ck_assert_double_eq_tol(value_of(text, "x", "cut", k, 0), 2.0 + 2.0 * k, 1e-12);
        ck_assert_double_eq_tol(value_of(text, "y", "cut", k, 0), 4.0 + k / 3.0, 1e-12);
        ck_assert_double_eq_tol(value_of(text, "deformation_gradient_xx", "cut", k, 5), 1.0, 1e-9);
    }
    g_free(text);
}
END_TEST

/* At t = 0 particles lie symmetrically about a node: a linear field is met; the weight is the mass
 * that hats of 1 by 0.5 hold, density times area. */
START_TEST(a_linear_field_is_met_between_symmetric_particles)
{
    test_results_scene(
        SCENE("0.1*x, 0.3*y - 0.2*x", "", "{history: 0.5, probes: [{name: node, at: [5, 4]}]}"));
    test_results_run_well();
    char *const text = csv("probes.csv");
    ck_assert_double_eq_tol(value_of(text, "velocity_x", "node", 0, 0), 0.5, mean_tolerance);
    ck_assert_double_eq_tol(value_of(text, "velocity_y", "node", 0, 0), 0.2, mean_tolerance);
    ck_assert_double_eq_tol(value_of(text, "weight", "node", 0, 0), 2.0 * 0.5, mean_tolerance);
    g_free(text);
}
END_TEST

/* In a rigid body there is no mass; on the border of two bodies both count by theirs. */
START_TEST(a_probe_is_the_mean_of_deformable_bodies)
{
    test_results_scene(SCENE("0.4, 0.2",
                             "  - {name: other, material: rubber, velocity: [0.2, 0],\n"
                             "     region: {rectangle: {from: [8, 2], to: [10, 6]}}}\n"
                             "  - {name: tool, rigid: {velocity: [1, 0]},\n"
                             "     region: {rectangle: {from: [2, 7], to: [5, 8]}}}\n",
                             "{history: 0.5, probes: [{name: tool, at: [3.5, 7.5]},\n"
                             "  {name: border, at: [8, 4]}, {name: edge, at: [2, 4]},\n"
                             "  {name: corner, at: [12, 0]}]}"));
    test_results_run_well();
    char *const text = csv("probes.csv");
    static const char *const nothing[] = {"tool", "corner"};
    for (size_t k = 0; k < G_N_ELEMENTS(nothing); k++) {
        ck_assert(value_of(text, "weight", nothing[k], 0, 0) == 0.0);
        ck_assert(isnan(value_of(text, "velocity_x", nothing[k], 0, 0)));
    }
    ck_assert_double_eq_tol(value_of(text, "velocity_x", "border", 0, 0), 0.3, mean_tolerance);
    ck_assert_double_eq_tol(value_of(text, "velocity_x", "edge", 0, 0), 0.4, mean_tolerance);
    ck_assert_double_eq_tol(value_of(text, "weight", "edge", 0, 0), 0.5, mean_tolerance);
    g_free(text);
}
END_TEST

static const struct {
    const char *output, *message;
} mistakes[] = {
    {"output={probes: [{name: a, at: [13, 1]}]}",
     "output.probes.0: outside the grid, got x = 13; allowed: from 0 to 12"},
    {"output={lines: [{name: a, from: [1, 1], to: [1, 9], points: 3}]}",
     "output.lines.0: outside the grid, got y = 9"},
    {"output={lines: [{name: a, from: [1, 1], to: [1, 2], points: 1}]}",
     "allowed: integer from 2 to 10000"},
    {"output={probes: [{name: a, at: [1, 1]}], lines: [{name: a, from: [1, 1], to: [1, 2], points: "
     "2}]}",
     "output.lines.0: another probe or line is named \"a\""},
    {"output={probes: [{name: 'a,b', at: [1, 1]}]}", "the name has a comma"},
    {"output={probes: [{name: \"a\\r\", at: [1, 1]}]}", "control characters"},
};

START_TEST(wrong_probes_are_refused)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(
        mpm_scene_parse("block", probed, strlen(probed), &mistakes[_i].output, 1, &scene, &error),
        MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, mistakes[_i].message) != NULL, "%s", error.message);
}
END_TEST

/* ----------------------------------------------------------------- derived */

static hid_t open_snapshot(size_t number)
{
    char *const name = g_strdup_printf("particles-%06zu.hdf", number);
    char *const path = test_folder_path(test_results.output, name);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    ck_assert_int_ge(file, 0);
    g_free(path);
    g_free(name);
    return file;
}

START_TEST(derived_fields_are_what_they_are_named)
{
    test_results_scene(SCENE("0.1*x, 0.3*y - 0.2*x", "", "{derived: true}"));
    test_results_run_well();
    const hid_t first = open_snapshot(0), last = open_snapshot(1);
    size_t count, n;
    double *const start = test_dataset_read(first, "/mpm/particles/position", &count),
                  *const end = test_dataset_read(last, "/mpm/particles/position", &n),
                  *const moved = test_dataset_read(last, "/mpm/particles/displacement", &n),
                  *const s = test_dataset_read(last, "/mpm/particles/stress", &n),
                  *const equivalent = test_dataset_read(last, "/mpm/particles/von_mises", &n),
                  *const pressure = test_dataset_read(last, "/mpm/particles/pressure", &n),
                  *const xy = test_dataset_read(last, "/VTKHDF/PointData/stress_xy", &n),
                  *const f = test_dataset_read(last, "/mpm/particles/deformation_gradient", &n),
                  *const yx =
                      test_dataset_read(last, "/VTKHDF/PointData/deformation_gradient_yx", &n);
    for (size_t k = 0; k < count; k++)
        ck_assert_double_eq_tol(moved[k], end[k] - start[k], 1e-14);
    for (size_t p = 0; p < count / 2; p++) {
        const double *const t = &s[4 * p];
        const double mean = (t[0] + t[1] + t[2]) / 3.0;
        const double square = (t[0] - mean) * (t[0] - mean) + (t[1] - mean) * (t[1] - mean) +
                              (t[2] - mean) * (t[2] - mean) + 2.0 * t[3] * t[3];
        ck_assert_double_eq_tol(equivalent[p], sqrt(1.5 * square), 1e-12);
        ck_assert_double_eq_tol(pressure[p], -mean, 1e-14);
        ck_assert(xy[p] == t[3]);
        ck_assert(yx[p] == f[5 * p + 2]);
    }
    double *const all[] = {start, end, moved, s, equivalent, pressure, xy, f, yx};
    for (size_t k = 0; k < G_N_ELEMENTS(all); k++)
        g_free(all[k]);
    H5Fclose(first);
    H5Fclose(last);
}
END_TEST

START_TEST(snapshots_have_derived_fields_only_where_asked)
{
    test_results_scene(probed);
    test_results_run_well();
    const hid_t file = open_snapshot(0);
    ck_assert_int_eq(H5Lexists(file, "/mpm/particles/displacement", H5P_DEFAULT), 0);
    ck_assert_int_eq(H5Lexists(file, "/mpm/particles/stress_xx", H5P_DEFAULT), 0);
    H5Fclose(file);
}
END_TEST

/* ------------------------------------------------------------------- cracks */

START_TEST(cracks_are_lines_beside_each_snapshot)
{
    test_results_scene(SCENE("0.1, 0",
                             "cracks:\n"
                             "  - {points: [[1, 3.25], [5, 3.25]]}\n"
                             "  - {points: [[5, 4.75], [6, 4.85], [7, 4.75]]}\n",
                             "{snapshots: 0.25}"));
    test_results_run_well();
    json_t *const list = test_results_json("cracks.vtp.series");
    json_t *const files = json_object_get(list, "files");
    ck_assert_uint_eq(json_array_size(files), 3);
    ck_assert_str_eq(json_string_value(json_object_get(json_array_get(files, 2), "name")),
                     "cracks-000002.vtp");
    char *const text = csv("cracks-000002.vtp");
    ck_assert_ptr_nonnull(strstr(text, "NumberOfLines=\"2\""));
    const char *const offsets = strstr(text, "Name=\"offsets\"");
    ck_assert_ptr_nonnull(offsets);
    char **const lines = g_strsplit(offsets, "\n", 4);
    char *const points = g_strdup_printf("NumberOfPoints=\"%s\"", lines[2]);
    ck_assert_msg(strstr(text, points) != NULL, "no %s", points);
    ck_assert_int_gt((int)strtol(lines[1], NULL, 10), 1);
    /* the end of the first one, in the block, has moved with it by 0.1 * 0.5 */
    char **const rows = g_strsplit(strstr(text, "Name=\"Points\""), "\n", -1);
    char *rest = NULL;
    const char *const last = rows[strtol(lines[1], NULL, 10)];
    ck_assert_double_eq_tol(g_ascii_strtod(last, &rest), 5.05, 1e-9);
    ck_assert_double_eq_tol(g_ascii_strtod(rest, NULL), 3.25, 1e-9);
    g_strfreev(rows);
    ck_assert_int_gt((int)strtol(lines[2], NULL, 10), (int)strtol(lines[1], NULL, 10));
    g_free(points);
    g_strfreev(lines);
    g_free(text);
    json_decref(list);
}
END_TEST

/* ---------------------------------------------------------------- going on */

/* A checkpoint of t = 0.3, and rows after it: a run that goes on takes them back. */
START_TEST(a_run_that_goes_on_leaves_the_same_rows)
{
    static const char text[] =
        SCENE("0.4*x, 0", "cracks: [{points: [[1, 3.25], [5, 3.25]]}]\n",
              "{history: 0.05, snapshots: 0.1, checkpoint: 0.3, probes: [{name: a, at: [5, 4]}]}");
    test_results_scene(text);
    test_results_run_well();
    static const char *const names[] = {"probes.csv", "cracks.vtp.series", "cracks-000005.vtp"};
    char *whole[G_N_ELEMENTS(names)];
    for (size_t k = 0; k < G_N_ELEMENTS(names); k++)
        whole[k] = csv(names[k]);
    const struct mpm_run_options options = {
        .output = test_results.output, .simulation = {.threads = 1}, .resume = true};
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_scene_run(test_results.scene, &options, &error) == MPM_OK, "%s",
                  error.message);
    for (size_t k = 0; k < G_N_ELEMENTS(names); k++) {
        char *const again = csv(names[k]);
        ck_assert_str_eq(whole[k], again);
        g_free(again);
        g_free(whole[k]);
    }
}
END_TEST

Suite *suite_probes(void)
{
    Suite *suite = suite_create("probes");
    TCase *tcase = tcase_create("output");
    tcase_add_checked_fixture(tcase, test_results_set_up, test_results_tear_down);
    tcase_add_test(tcase, probes_have_the_fields_at_their_places);
    tcase_add_test(tcase, a_linear_field_is_met_between_symmetric_particles);
    tcase_add_test(tcase, a_probe_is_the_mean_of_deformable_bodies);
    tcase_add_loop_test(tcase, wrong_probes_are_refused, 0, (int)G_N_ELEMENTS(mistakes));
    tcase_add_test(tcase, derived_fields_are_what_they_are_named);
    tcase_add_test(tcase, snapshots_have_derived_fields_only_where_asked);
    tcase_add_test(tcase, cracks_are_lines_beside_each_snapshot);
    tcase_add_test(tcase, a_run_that_goes_on_leaves_the_same_rows);
    suite_add_tcase(suite, tcase);
    return suite;
}
