/* Snapshots, read back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/snapshot.h"
#include "io/units.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/results.h"
#include "support/skip.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Advances a simulation by some steps, so that nothing has its initial value. */
static struct mpm_simulation *simulate(int steps)
{
    struct mpm_simulation *simulation = NULL;
    const struct mpm_simulation_options options = {.threads = 1};
    ck_assert_int_eq(mpm_simulation_create(test_results.scene, &options, &simulation, NULL),
                     MPM_OK);
    const double end = mpm_scene_end_time(test_results.scene);
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(mpm_simulation_advance(simulation, end, NULL), MPM_OK);
    return simulation;
}

static char *write_snapshot(const struct mpm_simulation *simulation, const char *name)
{
    char *path = test_folder_path(test_results.folder, name);
    double *work = g_new(double, mpm_snapshot_work_size(test_results.scene,
                                                        mpm_simulation_particle_count(simulation)));
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(mpm_snapshot_write(path, test_results.scene, simulation, work, &error) == MPM_OK,
                  "%s", error.message);
    g_free(work);
    return path;
}

/* Reads the fixture's scene again with settings. */
static void set_all(const char *const *settings, size_t count)
{
    mpm_scene_free(test_results.scene);
    ck_assert_int_eq(
        mpm_scene_read(test_results.scene_path, settings, count, &test_results.scene, NULL),
        MPM_OK);
}

static void set(const char *setting)
{
    set_all(&setting, 1);
}

/* ------------------------------------------------------------------- fields */

static const char RIGID_BETWEEN[] =
    "bodies=[{name: wall, rigid: {velocity: [0, 0.1]}, region: {rectangle: {from: [1, 1], to: "
    "[2, 2]}}}, {name: left, material: rubber, region: {rectangle: {from: [2, 2], to: [5, 5]}}, "
    "velocity: ['2*sin(y)', 'cos(x)']}, {name: lid, rigid: {velocity: [free, 0]}, region: "
    "{rectangle: {from: [2, 7], to: [4, 8]}}}, {name: right, material: rubber, region: "
    "{rectangle: {from: [7, 2], to: [9, 5]}}}]";

static void check_ranges(const struct mpm_simulation *simulation, enum mpm_field field)
{
    static const size_t sizes[] = {1, 5, 61};
    const size_t count = mpm_simulation_particle_count(simulation);
    const size_t components = mpm_field_describe(field)->components;
    double *whole = g_new(double, count *components), *part = g_new(double, count *components);
    mpm_simulation_field(simulation, field, whole);
    for (size_t k = 0; k < G_N_ELEMENTS(sizes); k++)
        for (size_t first = 0; first + sizes[k] <= count; first++) {
            mpm_simulation_field_range(simulation, field, first, sizes[k], part);
            ck_assert_mem_eq(part, whole + first * components,
                             sizes[k] * components * sizeof *part);
        }
    g_free(whole);
    g_free(part);
}

/* Between any two steps, over two sorts that move particles: ids ascend through rigid and
 * deformable bodies in turn, and the index of places has to notice what a step does to it. */
START_TEST(a_range_of_a_field_is_that_part_of_the_whole)
{
    enum { STEPS = 70 };
    set(RIGID_BETWEEN);
    struct mpm_simulation *simulation = simulate(0);
    for (int step = 0; step < STEPS; step++) {
        for (int field = 0; field < MPM_FIELD_COUNT; field++)
            check_ranges(simulation, (enum mpm_field)field);
        ck_assert_int_eq(mpm_simulation_advance(simulation, HUGE_VAL, NULL), MPM_OK);
    }
    mpm_simulation_free(simulation);
}
END_TEST

/* --------------------------------------------------------------- snapshots */

static void check_bits(const struct mpm_simulation *simulation,
                       const struct test_snapshot *snapshot, enum mpm_field field)
{
    const size_t size = snapshot->count * mpm_field_describe(field)->components;
    double *values = g_new(double, size);
    mpm_simulation_field(simulation, field, values);
    ck_assert_mem_eq(values, snapshot->fields[field], size * sizeof *values);
    g_free(values);
}

/* Fewer particles than one block of writing (16384) holds, and more. */
START_TEST(a_snapshot_reads_back_as_the_bits_of_the_simulation)
{
    static const struct {
        const char *setting;
        size_t particles;
    } sizes[] = {{"grid.refine=1", TEST_BLOCKS_PARTICLES},
                 {"grid.refine=18", 18 * 18 * TEST_BLOCKS_PARTICLES}};
    set(sizes[_i].setting);
    struct mpm_simulation *simulation = simulate(7);
    char *path = write_snapshot(simulation, "one.hdf");
    struct test_snapshot snapshot = test_snapshot_read(path);
    ck_assert(snapshot.time == mpm_simulation_time(simulation));
    ck_assert_int_eq(snapshot.step, 7);
    ck_assert_uint_eq(snapshot.count, sizes[_i].particles);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const bool has = mpm_scene_has_field(test_results.scene, (enum mpm_field)field);
        ck_assert((snapshot.fields[field] != NULL) == has);
        ck_assert(has == (field < MPM_FIELD_TEMPERATURE)); /* then those of some scenes alone */
        if (has)
            check_bits(simulation, &snapshot, (enum mpm_field)field);
    }
    test_snapshot_free(&snapshot);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* CRAMP (23) of the stress beside it; rigid particles have none. */
START_TEST(fringes_are_the_cosine_of_the_difference_of_principal_stresses)
{
    static const double CONSTANT = 0.7;
    const char *settings[] = {RIGID_BETWEEN, "output.fringe=0.7"};
    set_all(settings, 2);
    struct mpm_simulation *simulation = simulate(9);
    char *path = write_snapshot(simulation, "one.hdf");
    struct test_snapshot snapshot = test_snapshot_read(path);
    const double *const stress = snapshot.fields[MPM_FIELD_STRESS];
    double least = 1.0;
    for (size_t i = 0; i < snapshot.count; i++) {
        const double *const s = &stress[4 * i];
        const double mean = (s[0] + s[1]) / 2.0;
        const double radius = sqrt(mean * mean - (s[0] * s[1] - s[3] * s[3]));
        ck_assert_near(snapshot.fields[MPM_FIELD_FRINGE][i], cos(CONSTANT * 2.0 * radius), 1e-9);
        least = fmin(least, snapshot.fields[MPM_FIELD_FRINGE][i]);
    }
    ck_assert(least < -0.9);
    check_bits(simulation, &snapshot, MPM_FIELD_FRINGE);
    test_snapshot_free(&snapshot);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

static double *dataset(hid_t file, const char *object, const char *unit, size_t *count)
{
    char *found = test_attribute_text(file, object, "unit");
    ck_assert_str_eq(found, unit);
    g_free(found);
    return test_dataset_read(file, object, count);
}

/* In a block that moves as one, with which the points of its cracks move. */
START_TEST(a_snapshot_of_a_cracked_scene_has_the_points_of_its_cracks)
{
    enum { POINTS = 5 + 2 }; /* segments of a quarter of two cells, and of half a cell */
    static const double start[POINTS][3] = {{3, 4, 0}, {3.25, 4, 0}, {3.5, 4, 0},  {3.75, 4, 0},
                                            {4, 4, 0}, {4, 5.5, 1},  {3.6, 5.5, 1}};
    const char *settings[] = {
        "bodies=[{name: block, material: rubber, region: {rectangle: {from: [2, 2], to: [8, 7]}}, "
        "velocity: [2, -1]}]",
        "cracks=[{points: [[3, 4], [4, 4]], spacing: 0.25}, {points: [[4, 5.5], [3.6, 5.5]]}]"};
    set_all(settings, 2);
    struct mpm_simulation *simulation = simulate(5);
    char *path = write_snapshot(simulation, "one.hdf");
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    size_t count = 0;
    double *const position = dataset(file, "/mpm/cracks/position", "mm", &count);
    double *const crack = dataset(file, "/mpm/cracks/crack", "1", &count);
    ck_assert_uint_eq(count, POINTS);
    const double time = mpm_simulation_time(simulation);
    for (size_t i = 0; i < POINTS; i++) {
        ck_assert_near(position[2 * i], start[i][0] + 2.0 * time, 1e-12);
        ck_assert_near(position[2 * i + 1], start[i][1] - time, 1e-12);
        ck_assert(crack[i] == start[i][2]);
    }
    H5Fclose(file);
    g_free(position);
    g_free(crack);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* Checks the datasets of a scene, and notes which they are. */
static void check_datasets(const char *const *settings, size_t count, bool seen[MPM_FIELD_COUNT])
{
    set_all(settings, count);
    struct mpm_simulation *simulation = simulate(1);
    char *path = write_snapshot(simulation, "one.hdf");
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        if (!mpm_scene_has_field(test_results.scene, (enum mpm_field)field))
            continue;
        seen[field] = true;
        const struct mpm_field_info *info = mpm_field_describe((enum mpm_field)field);
        char *object = g_strdup_printf("/mpm/particles/%s", info->name);
        char *unit = test_attribute_text(file, object, "unit");
        char *description = test_attribute_text(file, object, "description");
        char *components = test_attribute_text(file, object, "components");
        char expected[MPM_UNIT_SIZE];
        mpm_unit_text(test_results.scene, info->dimension, expected);
        ck_assert_str_eq(unit, expected);
        ck_assert_str_eq(description, info->description);
        char **names = g_strsplit(components, ", ", -1);
        ck_assert_uint_eq(g_strv_length(names), info->components);
        g_strfreev(names);
        char *const texts[] = {unit, description, components, object};
        for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
            g_free(texts[i]);
    }
    H5Fclose(file);
    mpm_simulation_free(simulation);
    g_free(path);
}

START_TEST(every_dataset_names_its_unit_its_meaning_and_its_components)
{
    static const char *const solid[] = {"output.fringe=0.5", "output.derived=true",
                                        "materials.rubber.law=von_mises",
                                        "materials.rubber.yield_stress=1", TEST_BLOCKS_CONDUCTING};
    static const char *const fluid[] = {
        "materials=[{name: rubber, law: mie_gruneisen, density: 1, sound_speed: 30, "
        "hugoniot_slope: 1.5, gruneisen: 2, specific_heat: 3, start_temperature: 4, "
        "viscosity: {linear: 0.1, quadratic: 1}}]"};
    bool seen[MPM_FIELD_COUNT] = {false};
    check_datasets(solid, G_N_ELEMENTS(solid), seen);
    check_datasets(fluid, G_N_ELEMENTS(fluid), seen);
    for (int field = 0; field < MPM_FIELD_COUNT; field++)
        ck_assert_msg(seen[field], "%s", mpm_field_describe((enum mpm_field)field)->name);
}
END_TEST

START_TEST(a_snapshot_tells_where_it_comes_from)
{
    struct mpm_simulation *simulation = simulate(1);
    char *path = write_snapshot(simulation, "one.hdf");
    const struct mpm_build_info *build = mpm_build_info();
    const struct {
        const char *name, *value;
    } facts[] = {
        {"title", "Two blocks"},     {"geometry", "plane_strain"},  {"units_length", "mm"},
        {"units_mass", "g"},         {"units_time", "ms"},          {"units_temperature", "K"},
        {"version", build->version}, {"revision", build->revision}, {"compiler", build->compiler},
        {"flags", build->flags},
    };
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (size_t i = 0; i < G_N_ELEMENTS(facts); i++) {
        char *value = test_attribute_text(file, "/mpm", facts[i].name);
        ck_assert_str_eq(value, facts[i].value);
        g_free(value);
    }
    char *text = test_file_read(test_results.scene_path);
    char *expected = g_compute_checksum_for_string(G_CHECKSUM_SHA256, text, -1);
    char *sha256 = test_attribute_text(file, "/mpm", "scene_sha256");
    ck_assert_str_eq(sha256, expected);
    /* what changes no bit of the data changes none of the file */
    static const char *const absent[] = {"simd", "kernels", "threads", "processor"};
    for (size_t i = 0; i < G_N_ELEMENTS(absent); i++)
        ck_assert_int_eq(H5Aexists_by_name(file, "/mpm", absent[i], H5P_DEFAULT), 0);
    H5Fclose(file);
    g_free(text);
    g_free(expected);
    g_free(sha256);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* Neither dates nor leftovers of memory: `ctime` and the like are 0 where none is stored. */
START_TEST(the_same_state_makes_the_same_bytes)
{
    struct mpm_simulation *simulation = simulate(3);
    char *paths[2] = {write_snapshot(simulation, "one.hdf"), write_snapshot(simulation, "two.hdf")};
    char *bytes[2];
    gsize sizes[2];
    for (int i = 0; i < 2; i++)
        ck_assert(g_file_get_contents(paths[i], &bytes[i], &sizes[i], NULL));
    ck_assert_uint_eq(sizes[0], sizes[1]);
    ck_assert_mem_eq(bytes[0], bytes[1], sizes[0]);
    const hid_t file = H5Fopen(paths[0], H5F_ACC_RDONLY, H5P_DEFAULT);
    const char *const objects[] = {
        "/", "/mpm", "/mpm/particles", "/mpm/particles/mass", "/VTKHDF", "/VTKHDF/Points"};
    for (size_t i = 0; i < G_N_ELEMENTS(objects); i++) {
        H5O_info_t info;
        ck_assert_int_ge(H5Oget_info_by_name(file, objects[i], &info, H5P_DEFAULT), 0);
        ck_assert_msg(info.ctime == 0 && info.mtime == 0, "%s has a date", objects[i]);
    }
    H5Fclose(file);
    for (int i = 0; i < 2; i++) {
        g_free(bytes[i]);
        g_free(paths[i]);
    }
    mpm_simulation_free(simulation);
}
END_TEST

static haddr_t address_of(hid_t file, const char *group, const char *name)
{
    char *path = g_strdup_printf("%s/%s", group, name);
    H5O_info_t info;
    ck_assert_int_ge(H5Oget_info_by_name(file, path, &info, H5P_DEFAULT), 0);
    g_free(path);
    return info.addr;
}

START_TEST(vtk_sees_the_same_data_by_hard_links)
{
    set(_i == 0 ? "grid.refine=1" : "grid.refine=18");
    struct mpm_simulation *simulation = simulate(2);
    char *path = write_snapshot(simulation, "one.hdf");
    struct test_snapshot snapshot = test_snapshot_read(path);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const char *name = mpm_field_describe((enum mpm_field)field)->name;
        if (mpm_scene_has_field(test_results.scene, (enum mpm_field)field))
            ck_assert_uint_eq(address_of(file, "/mpm/particles", name),
                              address_of(file, "/VTKHDF/PointData", name));
    }
    size_t count = 0;
    double *points = test_dataset_read(file, "/VTKHDF/Points", &count);
    ck_assert_uint_eq(count, 3 * snapshot.count);
    for (size_t i = 0; i < snapshot.count; i++) {
        ck_assert(points[3 * i] == snapshot.fields[MPM_FIELD_POSITION][2 * i]);
        ck_assert(points[3 * i + 1] == snapshot.fields[MPM_FIELD_POSITION][2 * i + 1]);
        ck_assert(points[3 * i + 2] == 0.0);
    }
    double *offsets = test_dataset_read(file, "/VTKHDF/Offsets", &count);
    ck_assert_uint_eq(count, snapshot.count + 1);
    for (size_t i = 0; i < count; i++)
        ck_assert(offsets[i] == (double)i);
    g_free(points);
    g_free(offsets);
    test_snapshot_free(&snapshot);
    H5Fclose(file);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* VTK itself, through Debian's python3-vtk9 where that is installed. Prints points,
 * components of the stress, sum of the first components of position, and the time. */
static const char vtk_script[] =
    "import sys\n"
    "from vtkmodules.vtkIOHDF import vtkHDFReader\n"
    "reader = vtkHDFReader()\n"
    "assert reader.CanReadFile(sys.argv[1])\n"
    "reader.SetFileName(sys.argv[1])\n"
    "reader.Update()\n"
    "grid = reader.GetOutput()\n"
    "stress = grid.GetPointData().GetArray('stress')\n"
    "points = range(grid.GetNumberOfPoints())\n"
    "print(grid.GetNumberOfPoints(), grid.GetNumberOfCells(),\n"
    "      stress.GetNumberOfComponents(),\n"
    "      repr(sum(grid.GetPoint(i)[0] for i in points)),\n"
    "      repr(sum(stress.GetComponent(i, 3) for i in points)),\n"
    "      repr(grid.GetFieldData().GetArray('TimeValue').GetValue(0)))\n";

static bool python(const char *interpreter, const char *script, const char *argument, char **output)
{
    const char *const command[] = {interpreter, "-c", script, argument, NULL};
    int status = 1;
    g_clear_pointer(output, g_free);
    return g_spawn_sync(NULL, (char **)(void *)command, NULL,
                        G_SPAWN_SEARCH_PATH | G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL, output, NULL,
                        &status, NULL) &&
           status == 0;
}

START_TEST(vtk_reads_positions_stress_and_time)
{
    static const char *const interpreters[] = {"python3", "/usr/bin/python3"};
    const char *found = NULL;
    g_autofree char *output = NULL;
    for (size_t i = 0; i < G_N_ELEMENTS(interpreters) && found == NULL; i++)
        if (python(interpreters[i], "import vtkmodules.vtkIOHDF", NULL, &output))
            found = interpreters[i];
    if (found == NULL)
        TEST_SKIP("no Python with VTK 9.1 or later (python3-vtk9)");
    struct mpm_simulation *simulation = simulate(5);
    char *path = write_snapshot(simulation, "one.hdf");
    ck_assert_msg(python(found, vtk_script, path, &output), "VTK cannot read the snapshot");

    struct test_snapshot snapshot = test_snapshot_read(path);
    double x = 0.0, shear = 0.0; /* summed in VTK's order: the same bits */
    for (size_t i = 0; i < snapshot.count; i++) {
        x += snapshot.fields[MPM_FIELD_POSITION][2 * i];
        shear += snapshot.fields[MPM_FIELD_STRESS][4 * i + 3];
    }
    char **words = g_strsplit(g_strchomp(output), " ", -1);
    ck_assert_uint_eq(g_strv_length(words), 6);
    ck_assert_int_eq(g_ascii_strtoll(words[0], NULL, 10), TEST_BLOCKS_PARTICLES);
    ck_assert_int_eq(g_ascii_strtoll(words[1], NULL, 10), TEST_BLOCKS_PARTICLES);
    ck_assert_int_eq(g_ascii_strtoll(words[2], NULL, 10), 4);
    ck_assert(g_ascii_strtod(words[3], NULL) == x);
    ck_assert(g_ascii_strtod(words[4], NULL) == shear);
    ck_assert(g_ascii_strtod(words[5], NULL) == snapshot.time);
    g_strfreev(words);
    test_snapshot_free(&snapshot);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

Suite *suite_results(void)
{
    const TTest *const files[] = {
        a_range_of_a_field_is_that_part_of_the_whole,
        every_dataset_names_its_unit_its_meaning_and_its_components,
        fringes_are_the_cosine_of_the_difference_of_principal_stresses,
        a_snapshot_of_a_cracked_scene_has_the_points_of_its_cracks,
        a_snapshot_tells_where_it_comes_from,
        the_same_state_makes_the_same_bytes,
        vtk_reads_positions_stress_and_time,
    };
    Suite *suite = suite_create("results");
    TCase *test_case = tcase_create("files");
    tcase_add_checked_fixture(test_case, test_results_set_up, test_results_tear_down);
    for (size_t i = 0; i < G_N_ELEMENTS(files); i++)
        tcase_add_test(test_case, files[i]);
    tcase_add_loop_test(test_case, a_snapshot_reads_back_as_the_bits_of_the_simulation, 0, 2);
    tcase_add_loop_test(test_case, vtk_sees_the_same_data_by_hard_links, 0, 2);
    suite_add_tcase(suite, test_case);
    return suite;
}
