/* What the tests of results share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/results.h"

#include "io/results/history.h"
#include "support/blocks.h"
#include "support/folder.h"
#include "support/marks.h"

#include <glib.h>
#include <string.h>

struct test_results test_results;

void test_results_scene(const char *text)
{
    struct mpm_error error = {.status = MPM_OK};
    mpm_scene_free(test_results.scene);
    g_free(test_results.scene_path);
    test_results.scene_path = test_folder_write(test_results.folder, "blocks.yaml", text);
    ck_assert_msg(mpm_scene_read(test_results.scene_path, NULL, 0, &test_results.scene, &error) ==
                      MPM_OK,
                  "%s", error.message);
}

void test_results_set_up(void)
{
    test_results.folder = test_folder_create();
    test_results.output = test_folder_path(test_results.folder, "results");
    test_results_scene(TEST_BLOCKS);
}

void test_results_tear_down(void)
{
    mpm_scene_free(test_results.scene);
    g_free(test_results.scene_path);
    g_free(test_results.output);
    test_folder_remove(test_results.folder);
    memset(&test_results, 0, sizeof test_results);
}

enum mpm_status test_results_run(bool overwrite, struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = test_results.output, .simulation = {.threads = 1}, .overwrite = overwrite};
    return mpm_scene_run(test_results.scene, &options, error);
}

void test_results_run_well(void)
{
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(test_results_run(false, &error) == MPM_OK, "%s", error.message);
}

json_t *test_results_json(const char *name)
{
    char *path = test_folder_path(test_results.output, name);
    json_error_t error;
    json_t *root = json_load_file(path, 0, &error);
    ck_assert_msg(root != NULL, "%s: %s", path, error.text);
    g_free(path);
    return root;
}

json_t *test_results_series(json_t **files)
{
    json_t *list = test_results_json("particles.hdf.series");
    ck_assert_str_eq(json_string_value(json_object_get(list, "file-series-version")), "1.0");
    *files = json_object_get(list, "files");
    ck_assert(json_is_array(*files) && json_array_size(*files) > 0);
    return list;
}

struct test_snapshot test_results_listed(const json_t *files, size_t index)
{
    const json_t *entry = json_array_get(files, index);
    char *path =
        test_folder_path(test_results.output, json_string_value(json_object_get(entry, "name")));
    struct test_snapshot snapshot = test_snapshot_read(path);
    ck_assert(snapshot.time == json_real_value(json_object_get(entry, "time")));
    g_free(path);
    return snapshot;
}

double (*test_results_history(const char *folder, size_t *rows))[TEST_HISTORY_COLUMNS]
{
    char *path = test_folder_path(folder, MPM_HISTORY_NAME);
    char *text = test_file_read(path);
    ck_assert(g_str_has_suffix(text, "\n"));
    char **lines = g_strsplit(text, "\n", -1);
    const size_t count = g_strv_length(lines) - 1; /* nothing after the last newline */
    ck_assert_str_eq(lines[0], "time,step,mass,momentum_x,momentum_y,angular_momentum,"
                               "kinetic_energy,strain_energy,external_work,total_energy,"
                               "j_min,j_max");
    ck_assert_str_eq(lines[1], "# ms,1,g,g mm ms^-1,g mm ms^-1,g mm^2 ms^-1,g mm^2 ms^-2,"
                               "g mm^2 ms^-2,g mm^2 ms^-2,g mm^2 ms^-2,1,1");
    double(*values)[TEST_HISTORY_COLUMNS] = g_malloc0(sizeof *values * count);
    for (size_t line = 1; line < count; line++) {
        char **cells = g_strsplit(lines[line], ",", -1);
        ck_assert_uint_eq(g_strv_length(cells), TEST_HISTORY_COLUMNS);
        for (size_t i = 0; line > 1 && i < TEST_HISTORY_COLUMNS; i++) {
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
