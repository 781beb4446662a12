/* What a run writes, read back: snapshots, list of snapshots, history, run record.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/history.h"
#include "io/snapshot.h"
#include "io/units.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/skip.h"
#include "support/snapshot.h"

#include <errno.h>
#include <glib.h>
#include <jansson.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* ----------------------------------------------------------------- fixture */

/* One folder a test, with the scene in it; results go to `output`. */
static struct {
    char *folder, *scene_path, *output;
    struct mpm_scene *scene;
} fixture;

static void read_scene(const char *text)
{
    struct mpm_error error = {.status = MPM_OK};
    mpm_scene_free(fixture.scene);
    g_free(fixture.scene_path);
    fixture.scene_path = test_folder_write(fixture.folder, "blocks.yaml", text);
    ck_assert_msg(mpm_scene_read(fixture.scene_path, NULL, 0, &fixture.scene, &error) == MPM_OK,
                  "%s", error.message);
}

static void set_up(void)
{
    fixture.folder = test_folder_create();
    fixture.output = test_folder_path(fixture.folder, "results");
    read_scene(TEST_BLOCKS);
}

static void tear_down(void)
{
    mpm_scene_free(fixture.scene);
    g_free(fixture.scene_path);
    g_free(fixture.output);
    test_folder_remove(fixture.folder);
    memset(&fixture, 0, sizeof fixture);
}

static enum mpm_status run(bool overwrite, struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = fixture.output, .threads = 1, .overwrite = overwrite};
    return mpm_scene_run(fixture.scene, &options, error);
}

static void run_well(void)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(run(false, &error) == MPM_OK, "%s", error.message);
}

static json_t *read_json(const char *name)
{
    char *path = test_folder_path(fixture.output, name);
    json_error_t error;
    json_t *root = json_load_file(path, 0, &error);
    ck_assert_msg(root != NULL, "%s: %s", path, error.text);
    g_free(path);
    return root;
}

/* Listed snapshots; the caller frees the list, which owns the array. */
static json_t *read_series(json_t **files)
{
    json_t *list = read_json("particles.hdf.series");
    ck_assert_str_eq(json_string_value(json_object_get(list, "file-series-version")), "1.0");
    *files = json_object_get(list, "files");
    ck_assert(json_is_array(*files) && json_array_size(*files) > 0);
    return list;
}

static struct test_snapshot read_listed(const json_t *files, size_t index)
{
    const json_t *entry = json_array_get(files, index);
    char *path =
        test_folder_path(fixture.output, json_string_value(json_object_get(entry, "name")));
    struct test_snapshot snapshot = test_snapshot_read(path);
    ck_assert(snapshot.time == json_real_value(json_object_get(entry, "time")));
    g_free(path);
    return snapshot;
}

enum { HISTORY_COLUMNS = 12, TIME_COLUMN = 0, STEP_COLUMN = 1 };

/* Rows of a history file as numbers; g_free. */
static double (*read_history(const char *folder, size_t *rows))[HISTORY_COLUMNS]
{
    char *path = test_folder_path(folder, MPM_HISTORY_NAME);
    char *text = test_file_read(path);
    ck_assert(g_str_has_suffix(text, "\n"));
    char **lines = g_strsplit(text, "\n", -1);
    const size_t count = g_strv_length(lines) - 1; /* nothing after the last newline */
    ck_assert_str_eq(lines[0], "time,step,mass,momentum_x,momentum_y,angular_momentum,"
                               "kinetic_energy,strain_energy,external_work,total_energy,"
                               "j_min,j_max");
    ck_assert(g_str_has_prefix(lines[1], "# "));
    double(*values)[HISTORY_COLUMNS] = g_malloc0(sizeof *values * count);
    for (size_t line = 1; line < count; line++) {
        char **cells = g_strsplit(lines[line], ",", -1);
        ck_assert_uint_eq(g_strv_length(cells), HISTORY_COLUMNS);
        for (size_t i = 0; line > 1 && i < HISTORY_COLUMNS; i++) {
            char *end = NULL;
            values[line - 2][i] = g_ascii_strtod(cells[i], &end);
            ck_assert(*end == '\0' && end != cells[i]);
        }
        g_strfreev(cells);
    }
    *rows = count - 2;
    g_strfreev(lines);
    g_free(text);
    g_free(path);
    return values;
}

/* Advances a simulation by some steps, so that nothing has its initial value. */
static struct mpm_simulation *simulate(int steps)
{
    struct mpm_simulation *simulation = NULL;
    ck_assert_int_eq(mpm_simulation_create(fixture.scene, 1, &simulation, NULL), MPM_OK);
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(
            mpm_simulation_advance(simulation, mpm_scene_end_time(fixture.scene), NULL), MPM_OK);
    return simulation;
}

static char *write_snapshot(const struct mpm_simulation *simulation, const char *name)
{
    char *path = test_folder_path(fixture.folder, name);
    double *work = g_new(double, mpm_snapshot_work_size(mpm_simulation_particle_count(simulation)));
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(mpm_snapshot_write(path, fixture.scene, simulation, work, &error) == MPM_OK, "%s",
                  error.message);
    g_free(work);
    return path;
}

/* --------------------------------------------------------------- snapshots */

START_TEST(a_snapshot_reads_back_as_the_bits_of_the_simulation)
{
    struct mpm_simulation *simulation = simulate(7);
    char *path = write_snapshot(simulation, "one.hdf");
    struct test_snapshot snapshot = test_snapshot_read(path);
    ck_assert(snapshot.time == mpm_simulation_time(simulation));
    ck_assert_int_eq(snapshot.step, 7);
    ck_assert_uint_eq(snapshot.count, TEST_BLOCKS_PARTICLES);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const size_t size = snapshot.count * mpm_field_describe((enum mpm_field)field)->components;
        double *values = g_new(double, size);
        mpm_simulation_field(simulation, (enum mpm_field)field, values);
        ck_assert_mem_eq(values, snapshot.fields[field], size * sizeof *values);
        g_free(values);
    }
    test_snapshot_free(&snapshot);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

START_TEST(every_dataset_names_its_unit_its_meaning_and_its_components)
{
    struct mpm_simulation *simulation = simulate(1);
    char *path = write_snapshot(simulation, "one.hdf");
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const struct mpm_field_info *info = mpm_field_describe((enum mpm_field)field);
        char *object = g_strdup_printf("/mpm/particles/%s", info->name);
        char *unit = test_attribute_text(file, object, "unit");
        char *description = test_attribute_text(file, object, "description");
        char *components = test_attribute_text(file, object, "components");
        char expected[MPM_UNIT_SIZE];
        mpm_unit_text(fixture.scene, info->length, info->mass, info->time, expected);
        ck_assert_str_eq(unit, expected);
        ck_assert_str_eq(description, info->description);
        char **names = g_strsplit(components, ", ", -1);
        ck_assert_uint_eq(g_strv_length(names), info->components);
        g_strfreev(names);
        g_free(unit);
        g_free(description);
        g_free(components);
        g_free(object);
    }
    H5Fclose(file);
    mpm_simulation_free(simulation);
    g_free(path);
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
    char *text = test_file_read(fixture.scene_path);
    char *expected = g_compute_checksum_for_string(G_CHECKSUM_SHA256, text, -1);
    char *sha256 = test_attribute_text(file, "/mpm", "scene_sha256");
    ck_assert_str_eq(sha256, expected);
    H5Fclose(file);
    g_free(text);
    g_free(expected);
    g_free(sha256);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* Neither dates nor leftovers of memory: `ctime` and the like are 0 where none is kept. */
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
    struct mpm_simulation *simulation = simulate(2);
    char *path = write_snapshot(simulation, "one.hdf");
    struct test_snapshot snapshot = test_snapshot_read(path);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    for (int field = 0; field < MPM_FIELD_COUNT; field++) {
        const char *name = mpm_field_describe((enum mpm_field)field)->name;
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
    ck_assert(offsets[count - 1] == (double)snapshot.count);
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
    char *output = NULL;
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
    ck_assert_int_eq(atoi(words[0]), TEST_BLOCKS_PARTICLES);
    ck_assert_int_eq(atoi(words[1]), TEST_BLOCKS_PARTICLES);
    ck_assert_int_eq(atoi(words[2]), 4);
    ck_assert(g_ascii_strtod(words[3], NULL) == x);
    ck_assert(g_ascii_strtod(words[4], NULL) == shear);
    ck_assert(g_ascii_strtod(words[5], NULL) == snapshot.time);
    g_strfreev(words);
    g_free(output);
    test_snapshot_free(&snapshot);
    mpm_simulation_free(simulation);
    g_free(path);
}
END_TEST

/* ----------------------------------------------------------------- history */

START_TEST(history_rows_read_back_as_the_same_bits)
{
    const struct mpm_ledger ledger = {
        .time = 1.0 / 3.0,
        .step = 9007199254740991u, /* 2^53 - 1: the largest that a double still tells apart */
        .mass = 1e-300,
        .momentum = {-0.1, 2e17},
        .angular_momentum = nextafter(1.0, 2.0),
        .kinetic_energy = 4.9e-324,
        .strain_energy = 1.7976931348623157e308,
        .external_work = -5.0,
        .total_energy = 0.1 + 0.2,
        .j_min = 0.5,
        .j_max = 2.0,
    };
    const double expected[HISTORY_COLUMNS] = {
        ledger.time,          (double)ledger.step,     ledger.mass,           ledger.momentum[0],
        ledger.momentum[1],   ledger.angular_momentum, ledger.kinetic_energy, ledger.strain_energy,
        ledger.external_work, ledger.total_energy,     ledger.j_min,          ledger.j_max};
    struct mpm_history *history = NULL;
    ck_assert_int_eq(mpm_history_create(fixture.folder, fixture.scene, &history, NULL), MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledger, NULL), MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledger, NULL), MPM_OK); /* same step: no row */
    size_t rows = 0; /* read before the file is closed: rows reach the system at once */
    double(*values)[HISTORY_COLUMNS] = read_history(fixture.folder, &rows);
    ck_assert_uint_eq(rows, 1);
    ck_assert_mem_eq(values[0], expected, sizeof expected);
    g_free(values);
    mpm_history_free(history);
}
END_TEST

START_TEST(units_are_made_of_the_scenes_own)
{
    const struct {
        int length, mass, time;
        const char *named, *unnamed;
    } units[] = {
        {-1, 1, -2, "g mm^-1 ms^-2", "mass length^-1 time^-2"},
        {0, 0, 0, "1", "1"},
        {1, 0, 0, "mm", "length"},
        {1, 0, -1, "mm ms^-1", "length time^-1"},
        {2, 1, -2, "g mm^2 ms^-2", "mass length^2 time^-2"},
    };
    const struct mpm_scene unnamed = {.title = NULL};
    for (size_t i = 0; i < G_N_ELEMENTS(units); i++) {
        char text[MPM_UNIT_SIZE];
        mpm_unit_text(fixture.scene, units[i].length, units[i].mass, units[i].time, text);
        ck_assert_str_eq(text, units[i].named);
        mpm_unit_text(&unnamed, units[i].length, units[i].mass, units[i].time, text);
        ck_assert_str_eq(text, units[i].unnamed);
    }
}
END_TEST

/* --------------------------------------------------------------------- run */

/* Instants are k * interval, not sums of intervals: equal to the last bit. */
START_TEST(snapshots_land_on_their_instants_and_on_the_end)
{
    const double times[] = {0.0, 0.3, 2 * 0.3, 3 * 0.3, 1.0};
    run_well();
    json_t *files = NULL;
    json_t *list = read_series(&files);
    ck_assert_uint_eq(json_array_size(files), G_N_ELEMENTS(times));
    for (size_t i = 0; i < G_N_ELEMENTS(times); i++) {
        struct test_snapshot snapshot = read_listed(files, i);
        ck_assert(snapshot.time == times[i]);
        ck_assert_uint_eq(snapshot.count, TEST_BLOCKS_PARTICLES);
        test_snapshot_free(&snapshot);
    }
    json_decref(list);
}
END_TEST

/* 0.1 is not a binary fraction: 10 * 0.1 and 1 are one instant, not two. */
START_TEST(the_last_instant_is_the_end)
{
    read_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4}", "{history: 0.1, snapshots: 0.1}"));
    run_well();
    json_t *files = NULL;
    json_t *list = read_series(&files);
    ck_assert_uint_eq(json_array_size(files), 11);
    struct test_snapshot last = read_listed(files, 10);
    ck_assert(last.time == 1.0);
    test_snapshot_free(&last);
    json_decref(list);
}
END_TEST

START_TEST(history_has_the_first_step_at_or_after_each_interval)
{
    enum { INTERVALS = 10 };
    const double round_off = 1e-9; /* of an interval: as the solver itself allows */
    run_well();
    size_t rows = 0;
    double(*values)[HISTORY_COLUMNS] = read_history(fixture.output, &rows);
    ck_assert_uint_eq(rows, INTERVALS + 1);
    ck_assert(values[0][TIME_COLUMN] == 0.0 && values[0][STEP_COLUMN] == 0.0);
    ck_assert(values[rows - 1][TIME_COLUMN] == 1.0);
    for (size_t i = 0; i < rows; i++) {
        const double due = 0.1 * (double)i;
        ck_assert(values[i][TIME_COLUMN] >= due - 0.1 * round_off);
        ck_assert(values[i][TIME_COLUMN] < due + 0.1);
    }
    g_free(values);
}
END_TEST

START_TEST(without_intervals_the_first_and_the_last_state_are_written)
{
    read_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4}", "{}"));
    run_well();
    json_t *files = NULL;
    json_t *list = read_series(&files);
    size_t rows = 0;
    double(*values)[HISTORY_COLUMNS] = read_history(fixture.output, &rows);
    ck_assert_uint_eq(json_array_size(files), 2);
    ck_assert_uint_eq(rows, 2);
    ck_assert(values[1][TIME_COLUMN] == 1.0);
    g_free(values);
    json_decref(list);
}
END_TEST

START_TEST(a_number_of_steps_ends_the_run)
{
    read_scene(TEST_BLOCKS_WITH("{end: 1, courant: 0.4, steps: 5}", "{history: 0.1}"));
    run_well();
    json_t *record = read_json("run.json");
    const json_t *counters = json_object_get(record, "counters");
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "done");
    ck_assert_int_eq(json_integer_value(json_object_get(counters, "steps")), 5);
    ck_assert_int_eq(json_integer_value(json_object_get(counters, "particle_steps")),
                     5 * TEST_BLOCKS_PARTICLES);
    json_decref(record);
}
END_TEST

static void check_keys(const json_t *object, const char *const *keys, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ck_assert_msg(json_object_get(object, keys[i]) != NULL, "no key %s", keys[i]);
}

START_TEST(the_run_record_tells_outcome_cost_and_origin)
{
    static const char *const top[] = {"outcome",  "reason",  "exit_status",
                                      "counters", "kernels", "provenance"};
    static const char *const counted[] = {"steps", "particles", "particle_steps", "seconds",
                                          "bytes"};
    static const char *const timed[] = {"setup", "step", "output"};
    static const char *const sized[] = {"total", "per_particle"};
    static const char *const origin[] = {"scene",     "scene_sha256", "settings", "revision",
                                         "version",   "compiler",     "flags",    "libraries",
                                         "processor", "threads"};
    run_well();
    json_t *record = read_json("run.json");
    const json_t *counters = json_object_get(record, "counters");
    check_keys(record, top, G_N_ELEMENTS(top));
    check_keys(counters, counted, G_N_ELEMENTS(counted));
    check_keys(json_object_get(counters, "seconds"), timed, G_N_ELEMENTS(timed));
    check_keys(json_object_get(counters, "bytes"), sized, G_N_ELEMENTS(sized));
    check_keys(json_object_get(record, "provenance"), origin, G_N_ELEMENTS(origin));
    ck_assert_uint_eq(json_object_size(record), G_N_ELEMENTS(top));
    ck_assert_uint_eq(json_object_size(counters), G_N_ELEMENTS(counted));
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "done");
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), 0);
    json_decref(record);
}
END_TEST

START_TEST(a_failed_run_writes_its_last_good_state)
{
    read_scene(TEST_BLOCKS_UNSTABLE);
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(run(false, &error), MPM_RUN_FAILED);
    json_t *record = read_json("run.json");
    const json_int_t steps =
        json_integer_value(json_object_get(json_object_get(record, "counters"), "steps"));
    ck_assert_str_eq(json_string_value(json_object_get(record, "outcome")), "failed");
    ck_assert_str_eq(json_string_value(json_object_get(record, "reason")), error.message);
    ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")), MPM_RUN_FAILED);

    json_t *files = NULL;
    json_t *list = read_series(&files);
    struct test_snapshot last = read_listed(files, json_array_size(files) - 1);
    ck_assert_int_eq(last.step, steps);
    for (size_t i = 0; i < 2 * last.count; i++)
        ck_assert(isfinite(last.fields[MPM_FIELD_POSITION][i]));
    size_t rows = 0;
    double(*values)[HISTORY_COLUMNS] = read_history(fixture.output, &rows);
    ck_assert(values[rows - 1][STEP_COLUMN] == (double)steps);
    g_free(values);
    test_snapshot_free(&last);
    json_decref(list);
    json_decref(record);
}
END_TEST

START_TEST(a_run_without_a_folder_writes_nothing)
{
    const struct mpm_run_options options = {.threads = 1};
    ck_assert_int_eq(mpm_scene_run(fixture.scene, &options, NULL), MPM_OK);
    ck_assert(!test_file_exists(fixture.output));
}
END_TEST

/* ----------------------------------------------------------------- refusal */

START_TEST(bad_input_leaves_no_folder_behind)
{
    struct mpm_error error = {.status = MPM_OK};
    const struct mpm_run_options options = {.output = fixture.output, .threads = 0};
    ck_assert_int_eq(mpm_scene_run(fixture.scene, &options, &error), MPM_BAD_INPUT);
    read_scene(TEST_BLOCKS_WITH("{end: 1}", "{snapshots: 1.0e-9}"));
    ck_assert_int_eq(run(false, &error), MPM_BAD_INPUT);
    ck_assert(strstr(error.message, "output.snapshots") != NULL);
    ck_assert(!test_file_exists(fixture.output));
}
END_TEST

START_TEST(a_file_in_place_of_the_folder_is_refused)
{
    struct mpm_error error = {.status = MPM_OK};
    char *file = test_folder_write(fixture.folder, "results", "mine\n");
    for (int overwrite = 0; overwrite < 2; overwrite++)
        ck_assert_int_eq(run(overwrite == 1, &error), MPM_BAD_INPUT);
    char *text = test_file_read(file);
    ck_assert_str_eq(text, "mine\n");
    g_free(text);
    g_free(file);
}
END_TEST

START_TEST(a_folder_with_results_is_refused_unless_it_may_be_overwritten)
{
    static const char *const results[] = {"run.json",
                                          "history.csv",
                                          "particles-999999.hdf",
                                          "particles-1234567.hdf",
                                          "particles.hdf.series",
                                          "checkpoint.h5",
                                          "particles-000007.hdf.partial"};
    static const char stale[] = "stale\n";
    for (size_t i = 0; i < G_N_ELEMENTS(results); i++) {
        struct mpm_error error = {.status = MPM_OK};
        g_free(fixture.output);
        fixture.output = g_strdup_printf("%s/results-%zu", fixture.folder, i);
        ck_assert_int_eq(g_mkdir_with_parents(fixture.output, 0755), 0);
        char *path = test_folder_write(fixture.output, results[i], stale);
        ck_assert_int_eq(run(false, &error), MPM_BAD_INPUT);
        ck_assert(strstr(error.message, results[i]) != NULL);
        ck_assert_int_eq(run(true, &error), MPM_OK);
        gchar *text = NULL;
        ck_assert(!g_file_get_contents(path, &text, NULL, NULL) || strcmp(text, stale) != 0);
        g_free(text);
        g_free(path);
    }
}
END_TEST

START_TEST(overwriting_removes_no_file_of_the_user)
{
    static const char *const mine[] = {"notes.txt", "particles-best.hdf", "particles.hdf",
                                       "history.csv.bak"};
    struct mpm_error error = {.status = MPM_OK};
    run_well();
    for (size_t i = 0; i < G_N_ELEMENTS(mine); i++)
        g_free(test_folder_write(fixture.output, mine[i], "mine\n"));
    ck_assert_int_eq(run(true, &error), MPM_OK);
    for (size_t i = 0; i < G_N_ELEMENTS(mine); i++) {
        char *path = test_folder_path(fixture.output, mine[i]);
        ck_assert(test_file_exists(path));
        g_free(path);
    }
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_the_environments_failure)
{
    struct mpm_error error = {.status = MPM_OK};
    g_free(fixture.output);
    fixture.output = test_folder_path(fixture.scene_path, "below-a-file");
    ck_assert_int_eq(run(false, &error), MPM_ENVIRONMENT_FAILED);
    ck_assert(strstr(error.message, "below-a-file") != NULL);
}
END_TEST

/* --------------------------------------------------------------- full disk */

/* Files end at `bytes`, as on a disk that fills up; until lift_limit. */
static struct rlimit set_limit(rlim_t bytes)
{
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGXFSZ, &ignore, NULL);
    struct rlimit before, limited;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
    limited = before;
    limited.rlim_cur = bytes;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limited), 0);
    return before;
}

static void lift_limit(const struct rlimit *before)
{
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, before), 0);
}

/* Wherever in a snapshot the disk ends: no half file, and HDF5 comes out of it well. */
START_TEST(a_full_disk_leaves_no_half_snapshot)
{
    static const rlim_t limits[] = {2048, 8192, 20000};
    char *snapshot = test_folder_path(fixture.output, "particles-000000.hdf");
    char *partial = g_strconcat(snapshot, ".partial", NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(limits); i++) {
        struct mpm_error error = {.status = MPM_OK};
        const struct rlimit before = set_limit(limits[i]);
        const enum mpm_status status = run(true, &error);
        lift_limit(&before);
        ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
        ck_assert_msg(strstr(error.message, "particles-000000.hdf") != NULL &&
                          strstr(error.message, g_strerror(EFBIG)) != NULL &&
                          strstr(error.message, "step 0") != NULL &&
                          strstr(error.message, "last complete snapshot: none") != NULL,
                      "%s", error.message);
        ck_assert(!test_file_exists(snapshot));
        ck_assert(!test_file_exists(partial));
        json_t *record = read_json("run.json");
        ck_assert_int_eq(json_integer_value(json_object_get(record, "exit_status")),
                         MPM_ENVIRONMENT_FAILED);
        json_decref(record);
    }
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(run(true, &error), MPM_OK);
    g_free(partial);
    g_free(snapshot);
}
END_TEST

START_TEST(a_full_disk_leaves_whole_rows_in_the_history)
{
    const struct mpm_ledger ledgers[] = {{.step = 0}, {.step = 1}, {.step = 2, .mass = 1.0 / 3.0}};
    struct mpm_history *history = NULL;
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_int_eq(mpm_history_create(fixture.folder, fixture.scene, &history, NULL), MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledgers[0], NULL), MPM_OK);
    ck_assert_int_eq(mpm_history_write(history, &ledgers[1], NULL), MPM_OK);
    char *path = test_folder_path(fixture.folder, MPM_HISTORY_NAME);
    char *text = test_file_read(path);
    const struct rlimit before = set_limit(strlen(text) + 10);
    const enum mpm_status status = mpm_history_write(history, &ledgers[2], &error);
    lift_limit(&before);
    ck_assert_int_eq(status, MPM_ENVIRONMENT_FAILED);
    ck_assert(strstr(error.message, path) != NULL);
    char *left = test_file_read(path);
    ck_assert_str_eq(left, text);
    g_free(left);
    g_free(text);
    g_free(path);
    mpm_history_free(history);
}
END_TEST

START_TEST(the_binary_knows_what_it_is)
{
    const struct mpm_build_info *build = mpm_build_info();
    const char *const facts[] = {build->version, build->revision,  build->compiler,
                                 build->flags,   build->libraries, build->simd};
    for (size_t i = 0; i < G_N_ELEMENTS(facts); i++)
        ck_assert(facts[i] != NULL && facts[i][0] != '\0');
    ck_assert(strstr(build->libraries, "HDF5 ") != NULL);
    ck_assert(strstr(build->flags, "-ffp-contract=off") != NULL);
}
END_TEST

static void add_case(Suite *suite, const char *name, const TTest *const *tests, size_t count)
{
    TCase *test_case = tcase_create(name);
    tcase_add_checked_fixture(test_case, set_up, tear_down);
    for (size_t i = 0; i < count; i++)
        tcase_add_test(test_case, tests[i]);
    suite_add_tcase(suite, test_case);
}

Suite *suite_results(void)
{
    const TTest *const files[] = {
        a_snapshot_reads_back_as_the_bits_of_the_simulation,
        every_dataset_names_its_unit_its_meaning_and_its_components,
        a_snapshot_tells_where_it_comes_from,
        the_same_state_makes_the_same_bytes,
        vtk_sees_the_same_data_by_hard_links,
        vtk_reads_positions_stress_and_time,
        history_rows_read_back_as_the_same_bits,
        units_are_made_of_the_scenes_own,
        the_binary_knows_what_it_is,
    };
    const TTest *const runs[] = {
        snapshots_land_on_their_instants_and_on_the_end,
        the_last_instant_is_the_end,
        history_has_the_first_step_at_or_after_each_interval,
        without_intervals_the_first_and_the_last_state_are_written,
        a_number_of_steps_ends_the_run,
        the_run_record_tells_outcome_cost_and_origin,
        a_failed_run_writes_its_last_good_state,
        a_run_without_a_folder_writes_nothing,
    };
    const TTest *const refusals[] = {
        bad_input_leaves_no_folder_behind,
        a_file_in_place_of_the_folder_is_refused,
        a_folder_with_results_is_refused_unless_it_may_be_overwritten,
        overwriting_removes_no_file_of_the_user,
        a_folder_that_cannot_be_made_is_the_environments_failure,
        a_full_disk_leaves_no_half_snapshot,
        a_full_disk_leaves_whole_rows_in_the_history,
    };
    Suite *suite = suite_create("results");
    add_case(suite, "files", files, G_N_ELEMENTS(files));
    add_case(suite, "runs", runs, G_N_ELEMENTS(runs));
    add_case(suite, "refusals", refusals, G_N_ELEMENTS(refusals));
    return suite;
}
