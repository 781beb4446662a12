/* Reading scenes in tests.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/scene_files.h"

#include "support/folder.h"
#include "support/marks.h"

#include <glib.h>
#include <string.h>

const char *const TEST_LEAST_SCENE =
    "format: 1\ngeometry: plane_strain\ngrid: {cell: [1, 1], cells: [4, 4]}\ntime: {end: 1}\n"
    "materials:\n  - {name: rubber, law: neo_hookean, density: 1, bulk: 100, shear: 50}\n"
    "bodies:\n  - {name: block, material: rubber, region: {rectangle: {from: [1, 1], to: [3, "
    "3]}}}\n";

struct mpm_scene *test_scene_read(const char *path, const char *setting)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status =
        mpm_scene_read(path, &setting, setting != NULL ? 1 : 0, &scene, &error);
    ck_assert_msg(status == MPM_OK, "%s: %s", path, error.message);
    return scene;
}

struct mpm_scene *test_scene_read_text(const char *text)
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", text);
    struct mpm_scene *scene = test_scene_read(path, NULL);
    g_free(path);
    test_folder_remove(folder);
    return scene;
}

char *test_scene_refusal(const char *path)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = mpm_scene_read(path, NULL, 0, &scene, &error);
    ck_assert_msg(status == MPM_BAD_INPUT, "%s gave status %d: %s", path, (int)status,
                  error.message);
    ck_assert_int_eq(error.status, MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    return g_strdup(error.message);
}

char *test_scene_refusal_of_text(const char *text)
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", text);
    char *message = test_scene_refusal(path);
    g_free(path);
    test_folder_remove(folder);
    return message;
}

void test_contains(const char *message, const char *part)
{
    ck_assert_msg(strstr(message, part) != NULL, "got: %s\nwithout: %s", message, part);
}
