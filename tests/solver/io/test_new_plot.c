/* `mpm new` and `mpm plot`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/plot/snapshot_read.h"
#include "suites.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/skip.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <hdf5.h>
#include <string.h>

static bool has_gnuplot(void)
{
    char *const path = g_find_program_in_path("gnuplot");
    g_free(path);
    return path != NULL;
}

static char *run(int expected, const char *const *words)
{
    struct test_command command = test_command_run("mpm", words[0], words[1], words[2], words[3],
                                                   words[4], words[5], words[6], words[7], NULL);
    ck_assert_msg(command.exit_status == expected, "%s %s: exit status %d: %s", words[0], words[1],
                  command.exit_status, command.errors);
    char *const text = g_strconcat(command.output, command.errors, NULL);
    test_command_free(&command);
    return text;
}
#define RUN(expected, ...) run(expected, (const char *const[9]){__VA_ARGS__})

static double last_value(const char *folder, const char *column)
{
    char *const path = test_folder_path(folder, "history.csv"), *const text = test_file_read(path);
    char **const lines = g_strsplit(g_strstrip(text), "\n", -1);
    char **const names = g_strsplit(lines[0], ",", -1);
    char **const values = g_strsplit(lines[g_strv_length(lines) - 1], ",", -1);
    int k = 0;
    while (names[k] != NULL && strcmp(names[k], column) != 0)
        k++;
    ck_assert_msg(names[k] != NULL, "no column %s", column);
    const double value = g_ascii_strtod(values[k], NULL);
    g_strfreev(values);
    g_strfreev(names);
    g_strfreev(lines);
    g_free(text);
    g_free(path);
    return value;
}

/* ---------------------------------------------------------------------- new */

/* What the comment of each scene promises. */
static const struct {
    const char *kind, *column;
    double low, high;
} kinds[] = {
    {"impact", "momentum_x", -1e-9, 1e-9}, /* equal and opposite at the start */
    {"bar", "external_work", 0.0, 1e9},
    {"disk", "j_min", 0.3, 0.9},
    {"crack", "crack_0_contour_0_j1", 0.0018, 0.0022}, /* 0.0019 of the handbook */
    {"contact", "kinetic_energy", 1e-4, 1e-2},
    {"heat", "temperature_max", 90.0, 100.1},
    {"penetration", "plastic_dissipation", 1.0, 1e9},
};

START_TEST(a_new_scene_runs_at_once)
{
    char *const folder = test_folder_create();
    char *const scene = test_folder_path(folder, "scene.yaml");
    char *const results = test_folder_path(folder, "results");
    char *said = RUN(0, "new", kinds[_i].kind, "--output", scene);
    ck_assert_ptr_nonnull(strstr(said, "next: mpm run "));
    g_free(said);
    g_free(RUN(0, "run", scene, "--output", results, "--quiet"));
    const double value = last_value(results, kinds[_i].column);
    ck_assert_msg(value >= kinds[_i].low && value <= kinds[_i].high, "%s: %s is %g", kinds[_i].kind,
                  kinds[_i].column, value);
    if (has_gnuplot()) {
        g_free(RUN(0, "plot", results));
        char *const picture = test_folder_path(results, "plot-history.svg");
        ck_assert(test_file_exists(picture));
        g_free(picture);
    }
    g_free(results);
    g_free(scene);
    test_folder_remove(folder);
}
END_TEST

START_TEST(every_kind_is_listed_and_tested)
{
    char *const said = RUN(0, "new", "--list");
    char **const lines = g_strsplit(g_strstrip(said), "\n", -1);
    ck_assert_uint_eq(g_strv_length(lines), G_N_ELEMENTS(kinds));
    for (size_t k = 0; k < G_N_ELEMENTS(kinds); k++) {
        char *const entry = g_strdup_printf("%-12s ", kinds[k].kind);
        bool found = false;
        for (char **line = lines; *line != NULL; line++)
            found = found || g_str_has_prefix(*line, entry);
        ck_assert_msg(found, "%s", kinds[k].kind);
        g_free(entry);
    }
    g_strfreev(lines);
    g_free(said);
}
END_TEST

START_TEST(a_scene_that_cannot_be_written_is_reported_with_the_reason)
{
    char *const folder = test_folder_create();
    char *const file = test_folder_write(folder, "file", "");
    char *const paths[] = {g_build_filename(folder, "none", "scene.yaml", NULL),
                           g_build_filename(file, "scene.yaml", NULL)};
    for (size_t k = 0; k < G_N_ELEMENTS(paths); k++) {
        char *const said = RUN(4, "new", "bar", "--output", paths[k]);
        ck_assert_msg(strstr(said, "scene.yaml: cannot be written: ") != NULL, "%s", said);
        ck_assert(!test_file_exists(paths[k]));
        g_free(said);
        g_free(paths[k]);
    }
    g_free(file);
    test_folder_remove(folder);
}
END_TEST

START_TEST(nothing_is_overwritten_and_an_unknown_kind_lists_those_allowed)
{
    char *const folder = test_folder_create();
    char *const scene = test_folder_write(folder, "scene.yaml", "mine\n");
    char *said = RUN(2, "new", "bar", "--output", scene);
    ck_assert_ptr_nonnull(strstr(said, "is there already, and not overwritten"));
    g_free(said);
    char *const kept = test_file_read(scene);
    ck_assert_str_eq(kept, "mine\n");
    g_free(kept);
    said = RUN(2, "new", "baar");
    ck_assert_ptr_nonnull(strstr(said, "unknown kind 'baar'; allowed: bar, contact, crack, disk"));
    g_free(said);
    said = RUN(2, "new");
    ck_assert_ptr_nonnull(strstr(said, "a kind is missing"));
    g_free(said);
    g_free(scene);
    test_folder_remove(folder);
}
END_TEST

/* --------------------------------------------------------------------- plot */

static const char block[] = "format: 1\n"
                            "title: \"it's `date` $HOME\"\n"
                            "geometry: plane_strain\n"
                            "units: {length: \"'; system('echo x > mark'); '\", time: µs}\n"
                            "grid: {cell: [1, 2], cells: [6, 4]}\n"
                            "time: {end: 1, steps: 4}\n"
                            "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 1,\n"
                            "             shear: 1}]\n"
                            "bodies:\n"
                            "  - {name: block, material: rubber, velocity: [0.1*x, 0],\n"
                            "     region: {rectangle: {from: [1, 2], to: [3, 6]}}}\n"
                            "output: {snapshots: 0.5}\n";

static char *results_of_block(char **folder)
{
    *folder = test_folder_create();
    char *const scene = test_folder_write(*folder, "scene.yaml", block);
    char *const results = test_folder_path(*folder, "results");
    g_free(RUN(0, "run", scene, "--output", results, "--quiet"));
    g_free(scene);
    return results;
}

static size_t occurrences(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)) != NULL; at++)
        count++;
    return count;
}

/* White lines that begin anew. */
static size_t outlines(const char *text)
{
    static const char white[] = "<path stroke='rgb(255, 255, 255)'";
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, white)) != NULL; at += strlen(white)) {
        char *const path = g_strndup(at, strcspn(at, ">"));
        count += occurrences(path, "M");
        g_free(path);
    }
    return count;
}

/* Four columns of four particles, the first in the lowest colour, the last in the highest; the
 * colour bar begins with the lowest. */
START_TEST(a_picture_has_every_domain_the_unit_and_the_title)
{
    if (!has_gnuplot())
        TEST_SKIP("gnuplot is not installed");
    char *folder, *const results = results_of_block(&folder);
    g_free(RUN(0, "plot", results, "--field", "velocity.x", "--snapshot", "0"));
    char *const path = test_folder_path(results, "plot-velocity.x-000000.svg");
    char *const text = test_file_read(path);
    ck_assert_uint_eq(occurrences(text, "<polygon fill = 'rgb(253, 231,  37)'"), 4 + 1);
    ck_assert_uint_eq(occurrences(text, "<polygon fill = 'rgb( 68,   1,  84)'"), 4);
    ck_assert_uint_eq(outlines(text), 16);
    ck_assert_ptr_nonnull(strstr(text, "it’s `date` $HOME"));
    ck_assert_ptr_nonnull(strstr(text, "µs^-1"));
    g_free(text);
    g_free(path);
    char *const mark = test_folder_path(folder, "mark");
    ck_assert(!test_file_exists(mark) && !test_file_exists("mark"));
    g_free(mark);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

/* A block that is sheared evenly: domains of neighbours share their corners, to what two steps
 * leave of an even motion. */
START_TEST(outlines_of_neighbours_meet_in_an_even_shear)
{
    static const char sheared[] = "format: 1\n"
                                  "geometry: plane_strain\n"
                                  "grid: {cell: [1, 2], cells: [6, 4]}\n"
                                  "time: {end: 1, step: 0.1, steps: 4}\n"
                                  "materials: [{name: rubber, law: neo_hookean, density: 1,\n"
                                  "             bulk: 1, shear: 1}]\n"
                                  "boundary: [{region: all, velocity: [y, 0]}]\n"
                                  "bodies:\n"
                                  "  - {name: block, material: rubber, velocity: [y, 0],\n"
                                  "     region: {rectangle: {from: [1, 2], to: [3, 6]}}}\n";
    char *const folder = test_folder_create();
    char *const scene = test_folder_write(folder, "scene.yaml", sheared);
    char *const results = test_folder_path(folder, "results");
    g_free(RUN(0, "run", scene, "--output", results, "--quiet"));
    char *const path = test_folder_path(results, "particles-000001.hdf");
    struct mpm_picture picture;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_picture_read(path, "mass", &picture, &error) == MPM_OK, "%s", error.message);
    ck_assert_uint_eq(picture.count, 16); /* rows of 4, from below */
    for (size_t p = 0; p < 12; p++)
        for (int k = 0; k < 2; k++) {
            ck_assert_double_eq_tol(picture.corners[p][3][k], picture.corners[p + 4][0][k], 1e-9);
            if (p % 4 != 3)
                ck_assert_double_eq_tol(picture.corners[p][1][k], picture.corners[p + 1][0][k],
                                        1e-9);
        }
    ck_assert_double_gt(picture.corners[0][3][0], picture.corners[0][0][0] + 0.1);
    mpm_picture_free(&picture);
    g_free(path);
    g_free(results);
    g_free(scene);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_picture_can_be_png)
{
    if (!has_gnuplot())
        TEST_SKIP("gnuplot is not installed");
    char *folder, *const results = results_of_block(&folder);
    char *const other = test_folder_path(folder, "pictures");
    char *const said = RUN(0, "plot", results, "--format", "png", "--output", other);
    ck_assert_uint_eq(occurrences(said, ".png\n"), 2);
    char *const path = test_folder_path(other, "plot-history.png"), *bytes = NULL;
    ck_assert(g_file_get_contents(path, &bytes, NULL, NULL));
    ck_assert_int_eq(memcmp(bytes, "\x89PNG", 4), 0);
    g_free(bytes);
    g_free(path);
    g_free(said);
    g_free(other);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

static const struct {
    const char *words[3], *said;
} mistakes[] = {
    {{"--field", "strain"}, "--field strain: "},
    {{"--field", "stress"}, "the field has components; allowed: one of xx, yy, zz, xy"},
    {{"--field", "stress.rr"}, "allowed: one of xx, yy, zz, xy"},
    {{"--field", "../particles/mass"}, "has no such field"},
    {{"--field", "mass.x"},
     "has no such field; allowed: those of 'mpm plot --list' that the scene has\n"},
    {{"--field", "stres.xx"}, "that the scene has; did you mean stress?\n"},
    {{"--field", "temperatur"}, "; did you mean temperature?\n"},
    {{"--snapshot", "77"}, "--snapshot 77: "},
    {{"--snapshot", "last"}, "--snapshot last: "},
    {{"--list", "--names"}, "plot: allowed: one of --list and --names; see"},
    {{"--output", "/proc/version"}, "plot: /proc/version: is a file; allowed: a folder"},
    {{"--format", "pdf"}, "--format \"pdf\"; allowed: svg, png"},
};

START_TEST(a_mistake_is_reported_with_what_is_allowed)
{
    char *folder, *const results = results_of_block(&folder);
    char *const said = RUN(2, "plot", results, mistakes[_i].words[0], mistakes[_i].words[1]);
    ck_assert_msg(strstr(said, mistakes[_i].said) != NULL, "%s", said);
    ck_assert_uint_eq(occurrences(said, "\n"), 1);
    g_free(said);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

/* Each name can be drawn; a field of the folder's file that a shell would act on is left out. */
START_TEST(names_are_those_that_the_snapshot_has)
{
    char *folder, *const results = results_of_block(&folder);
    char *const path = test_folder_path(results, "particles-000000.hdf");
    const hsize_t size[1] = {16};
    const hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(1, size, NULL);
    static const char *const added[] = {"$(touch mark)", "own", "two words"};
    for (size_t k = 0; k < G_N_ELEMENTS(added); k++) {
        char *const name = g_strconcat("/mpm/particles/", added[k], NULL);
        const hid_t dataset =
            H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        ck_assert_int_ge(H5Dclose(dataset), 0);
        g_free(name);
    }
    ck_assert(H5Sclose(space) >= 0 && H5Fclose(file) >= 0);
    char *const own = RUN(0, "plot", "--names", "--snapshot", "0", results);
    ck_assert_msg(strcmp(own, "von_mises\npressure\nspeed\nrelative_volume\nbody\n"
                              "deformation_gradient.xx\ndeformation_gradient.xy\n"
                              "deformation_gradient.yx\ndeformation_gradient.yy\n"
                              "deformation_gradient.zz\nid\nmass\nown\nposition.x\nposition.y\n"
                              "stress.xx\nstress.yy\nstress.zz\nstress.xy\n"
                              "velocity.x\nvelocity.y\nvolume\n") == 0,
                  "%s", own);
    char *const all = RUN(0, "plot", "--names");
    char **const names = g_strsplit(all, "\n", -1);
    ck_assert(g_strv_contains((const char *const *)names, "stress.rr") &&
              g_strv_contains((const char *const *)names, "stress.tt") &&
              g_strv_contains((const char *const *)names, "temperature"));
    for (char **name = names; *name != NULL; name++)
        for (char **other = name + 1; *other != NULL; other++)
            ck_assert_msg(strcmp(*name, *other) != 0, "%s twice", *name);
    g_strfreev(names);
    g_free(all);
    g_free(own);
    g_free(RUN(2, "plot", "--names", folder)); /* no snapshots there */
    g_free(path);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_name_that_needs_quotes_has_them_in_what_comes_next)
{
    static const char *const table[][2] = {{"plain.yaml", "next: mpm run plain.yaml\n"},
                                           {"it's a.yaml", "next: mpm run 'it'\\''s a.yaml'\n"},
                                           {"$(x).yaml", "next: mpm run '$(x).yaml'\n"},
                                           {"-x.yaml", "next: mpm run -- -x.yaml\n"}};
    char *const before = g_get_current_dir(), *const there = test_folder_create();
    ck_assert_int_eq(g_chdir(there), 0);
    for (size_t k = 0; k < G_N_ELEMENTS(table); k++) {
        char *const said = RUN(0, "new", "bar", "--output", table[k][0]);
        ck_assert_msg(g_str_has_suffix(said, table[k][1]), "%s", said);
        g_free(said);
    }
    ck_assert_int_eq(g_chdir(before), 0);
    test_folder_remove(there);
    g_free(before);
}
END_TEST

START_TEST(what_is_no_folder_of_results_is_refused)
{
    char *const folder = test_folder_create();
    char *said = RUN(2, "plot", folder);
    ck_assert_ptr_nonnull(strstr(said, "no snapshots there"));
    g_free(said);
    g_free(test_folder_write(folder, "particles-000000.hdf", "no HDF5"));
    said = RUN(2, "plot", folder);
    ck_assert_ptr_nonnull(strstr(said, "no snapshot; allowed: "));
    g_free(said);
    g_free(test_folder_write(folder, "particles-999999.hdf", "no HDF5"));
    g_free(test_folder_write(folder, "particles-1000000.hdf", "no HDF5"));
    g_free(test_folder_write(folder, "particles- 2000000.hdf", "no HDF5"));
    said = RUN(2, "plot", folder); /* the last one by its number */
    ck_assert_msg(strstr(said, "/particles-1000000.hdf: no snapshot") != NULL, "%s", said);
    g_free(said);
    said = RUN(2, "plot", "no-such-folder");
    ck_assert_ptr_nonnull(strstr(said, "no-such-folder: cannot be read"));
    g_free(said);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_new_plot(void)
{
    Suite *suite = suite_create("new_plot");
    TCase *scenes = tcase_create("new");
    tcase_set_timeout(scenes, 60.0);
    tcase_add_loop_test(scenes, a_new_scene_runs_at_once, 0, (int)G_N_ELEMENTS(kinds));
    tcase_add_test(scenes, every_kind_is_listed_and_tested);
    tcase_add_test(scenes, a_scene_that_cannot_be_written_is_reported_with_the_reason);
    tcase_add_test(scenes, nothing_is_overwritten_and_an_unknown_kind_lists_those_allowed);
    suite_add_tcase(suite, scenes);
    TCase *plots = tcase_create("plot");
    tcase_add_test(plots, a_picture_has_every_domain_the_unit_and_the_title);
    tcase_add_test(plots, outlines_of_neighbours_meet_in_an_even_shear);
    tcase_add_test(plots, a_picture_can_be_png);
    tcase_add_loop_test(plots, a_mistake_is_reported_with_what_is_allowed, 0,
                        (int)G_N_ELEMENTS(mistakes));
    tcase_add_test(plots, names_are_those_that_the_snapshot_has);
    tcase_add_test(plots, a_name_that_needs_quotes_has_them_in_what_comes_next);
    tcase_add_test(plots, what_is_no_folder_of_results_is_refused);
    suite_add_tcase(suite, plots);
    return suite;
}
