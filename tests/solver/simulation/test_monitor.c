/* A monitor sees each simulation from its making to its end, and a scene can be had as a tree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/soft_block.h"

#include "mpm_yaml.h"

#include <glib.h>
#include <math.h>
#include <string.h>

struct seen {
    unsigned moments[MPM_AT_END + 1];
    double time; /* of the last one */
    const struct mpm_scene *scene;
};

static void look(void *context, enum mpm_moment moment, const struct mpm_simulation *simulation)
{
    struct seen *const seen = context;
    seen->moments[moment]++;
    seen->time = mpm_simulation_time(simulation);
    seen->scene = mpm_simulation_scene(simulation);
}

/* A scene in a file of its own folder. */
static struct mpm_scene *read_scene(char **folder, const char *const *settings, size_t count)
{
    struct mpm_scene *scene;
    struct mpm_error error = {.message = ""};
    *folder = test_folder_create();
    char *path = test_folder_write(*folder, "scene.yaml", TEST_SOFT_BLOCK(""));
    ck_assert_msg(mpm_scene_read(path, settings, count, &scene, &error) == MPM_OK, "%s",
                  error.message);
    g_free(path);
    return scene;
}

START_TEST(a_monitor_sees_start_each_step_and_end)
{
    char *folder;
    struct mpm_scene *scene = read_scene(&folder, NULL, 0);
    struct seen seen = {.time = -1};
    const struct mpm_monitor monitor = {look, &seen};
    const struct mpm_simulation_options options = {.threads = 1, .monitor = &monitor};
    struct mpm_simulation *simulation;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_OK);
    ck_assert_uint_eq(seen.moments[MPM_AT_START], 1);
    ck_assert_double_eq(seen.time, 0);
    ck_assert_ptr_eq(seen.scene, scene);
    for (unsigned step = 1; step <= 40; step++) {
        ck_assert_int_eq(mpm_simulation_advance(simulation, HUGE_VAL, &error), MPM_OK);
        ck_assert_uint_eq(seen.moments[MPM_AFTER_STEP], step);
        ck_assert_double_eq(seen.time, mpm_simulation_time(simulation));
    }
    ck_assert_uint_eq(seen.moments[MPM_AT_END], 0);
    mpm_simulation_free(simulation);
    ck_assert_uint_eq(seen.moments[MPM_AT_END], 1);
    mpm_scene_free(scene);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_plan_and_a_step_that_is_refused_are_not_seen)
{
    char *folder;
    struct mpm_scene *scene = read_scene(&folder, NULL, 0);
    struct seen seen = {.time = -1};
    const struct mpm_monitor monitor = {look, &seen};
    struct mpm_simulation_options options = {.threads = 1, .monitor = &monitor};
    struct mpm_simulation *simulation;
    struct mpm_plan plan;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_plan(scene, &options, &plan, &error), MPM_OK);
    options.threads = 0;
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_BAD_INPUT);
    ck_assert_double_eq(seen.time, -1);
    options.threads = 1;
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, &error), MPM_OK);
    ck_assert_int_eq(mpm_simulation_advance(simulation, 0, &error), MPM_BAD_INPUT);
    ck_assert_uint_eq(seen.moments[MPM_AFTER_STEP], 0);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    test_folder_remove(folder);
}
END_TEST

START_TEST(the_tree_of_a_scene_has_its_settings_and_defaults)
{
    static const char *const settings[] = {"grid.cells=[20, 15]"};
    static const struct {
        const char *path, *text;
    } table[] = {{"grid.cells.0", "20"}, {"grid.refine", "1"}, {"bodies.0.name", "block"}};
    char *folder;
    struct mpm_scene *scene = read_scene(&folder, settings, 1);
    struct mpm_tree_node *root;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(mpm_scene_tree(scene, &root, &error) == MPM_OK, "%s", error.message);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct mpm_tree_node *const node = mpm_tree_find(root, table[i].path, NULL);
        ck_assert_msg(node != NULL && strcmp(node->text, table[i].text) == 0, "%s", table[i].path);
    }
    mpm_tree_free(root);
    g_free(test_folder_write(folder, "scene.yaml", "format: 1\n"));
    ck_assert_int_eq(mpm_scene_tree(scene, &root, &error), MPM_BAD_INPUT);
    ck_assert_ptr_null(root);
    ck_assert_msg(strstr(error.message, "missing") != NULL, "%s", error.message);
    ck_assert_int_eq(mpm_scene_tree(scene, &root, NULL), MPM_BAD_INPUT);
    mpm_scene_free(scene);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_monitor(void)
{
    Suite *suite = suite_create("monitor");
    TCase *seen = tcase_create("seen");
    tcase_add_test(seen, a_monitor_sees_start_each_step_and_end);
    tcase_add_test(seen, a_plan_and_a_step_that_is_refused_are_not_seen);
    tcase_add_test(seen, the_tree_of_a_scene_has_its_settings_and_defaults);
    suite_add_tcase(suite, seen);
    return suite;
}
