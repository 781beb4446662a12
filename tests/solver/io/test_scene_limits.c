/* Limits of scenes, files that are none, damaged ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/scene_files.h"
#include "support/skip.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ------------------------------------------------------------------- limits */

START_TEST(a_name_may_have_64_characters_of_any_length_in_bytes)
{
    GString *text = g_string_new(TEST_LEAST_SCENE);
    GString *name = g_string_new("");
    for (int i = 0; i < 64; i++)
        g_string_append(name, "é");
    g_string_append_printf(
        text,
        "  - {name: %s, material: rubber, region: {disk: {center: [3.5, 3.5], radius: .5}}}\n",
        name->str);
    struct mpm_scene *scene = test_scene_read_text(text->str);
    ck_assert_str_eq(mpm_scene_body_name(scene, 1), name->str);
    mpm_scene_free(scene);
    g_string_free(text, TRUE);
    g_string_free(name, TRUE);
}
END_TEST

static char *nested_title(int lists)
{
    GString *text = g_string_new(TEST_LEAST_SCENE);
    g_string_append(text, "title: ");
    for (int i = 0; i < lists; i++)
        g_string_append_c(text, '[');
    for (int i = 0; i < lists; i++)
        g_string_append_c(text, ']');
    g_string_append_c(text, '\n');
    return g_string_free(text, FALSE);
}

START_TEST(nesting_of_64_levels_is_the_deepest)
{
    static const struct {
        int lists; /* the scene itself is one level more */
        const char *message;
    } cases[] = {{63, "title: not a single value"},
                 {64, "nested too deeply; allowed: 64 levels"},
                 {100000, "nested too deeply; allowed: 64 levels"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = nested_title(cases[i].lists);
        char *message = test_scene_refusal_of_text(text);
        test_contains(message, cases[i].message);
        g_free(message);
        g_free(text);
    }
}
END_TEST

/* A good scene filled up with comments to the size. */
static char *padded_scene(size_t size)
{
    char *text = g_malloc(size + 1);
    memset(text, '#', size);
    memcpy(text, TEST_LEAST_SCENE, strlen(TEST_LEAST_SCENE));
    for (size_t i = strlen(TEST_LEAST_SCENE) + 1000; i < size; i += 1000)
        text[i] = '\n';
    text[size] = '\0';
    return text;
}

START_TEST(a_file_of_16_mib_is_the_biggest)
{
    const size_t biggest = (size_t)16 * 1024 * 1024;
    char *text = padded_scene(biggest);
    mpm_scene_free(test_scene_read_text(text));
    g_free(text);
    text = padded_scene(biggest + 1);
    char *message = test_scene_refusal_of_text(text);
    test_contains(message, "the file is too big; allowed: a readable scene file of up to 16 MiB");
    g_free(message);
    g_free(text);
}
END_TEST

/* 46336 + 4 ghost rows + 1 = 46341 > sqrt(2^31); two columns fewer are within. */
START_TEST(a_grid_of_two_to_the_31_nodes_is_the_biggest)
{
    char *settings[] = {"grid.cells=[46336, 46333]", "grid.cells=[46336, 46336]"};
    mpm_scene_free(test_scene_read(TEST_MINIMAL_SCENE, settings[0]));
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const setting[] = {settings[1]};
    ck_assert_int_eq(mpm_scene_read(TEST_MINIMAL_SCENE, setting, 1, &scene, &error), MPM_BAD_INPUT);
    test_contains(error.message, "too many nodes, got 46341 x 46341");
}
END_TEST

START_TEST(a_byte_order_mark_at_the_start_is_passed_over)
{
    char *text = g_strconcat("\xef\xbb\xbf", TEST_LEAST_SCENE, "time: 1\n", NULL);
    char *message = test_scene_refusal_of_text(text);
    test_contains(message, "key \"time\" repeated");
    text[strlen(text) - strlen("time: 1\n")] = '\0';
    mpm_scene_free(test_scene_read_text(text));
    g_free(message);
    g_free(text);
}
END_TEST

/* -------------------------------------------------------------------- files */

START_TEST(a_scene_that_is_no_readable_file_is_refused)
{
    char *folder = test_folder_create();
    char *path = test_folder_path(folder, "missing.yaml");
    char *message = test_scene_refusal(path);
    test_contains(message, "missing.yaml: No such file or directory");
    g_free(message);
    message = test_scene_refusal(folder);
    test_contains(message, "is a folder");
    g_free(message);
    ck_assert_int_eq(mkfifo(path, 0600), 0); /* nobody writes to it: reading must not wait */
    message = test_scene_refusal(path);
    test_contains(message, "is not a regular file");
    g_free(message);
    message = test_scene_refusal("");
    g_free(message);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_scene_that_may_not_be_read_is_refused)
{
    if (geteuid() == 0)
        TEST_SKIP("root may read every file");
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "secret.yaml", TEST_LEAST_SCENE);
    ck_assert_int_eq(g_chmod(path, 0), 0);
    char *message = test_scene_refusal(path);
    test_contains(message, "Permission denied");
    g_free(message);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

START_TEST(an_empty_file_is_refused)
{
    char *message = test_scene_refusal_of_text("");
    test_contains(message, "empty; allowed: a YAML document");
    g_free(message);
}
END_TEST

START_TEST(a_long_path_leaves_room_for_the_message)
{
    char path[3000];
    memset(path, 'p', sizeof path);
    memcpy(path + sizeof path - 12, "/scene.yaml", 12);
    char *message = test_scene_refusal(path);
    test_contains(message, "pp/scene.yaml: ");
    test_contains(message, "allowed: a readable scene file");
    g_free(message);
}
END_TEST

/* ------------------------------------------------------------------- damage */

static enum mpm_status read_damaged(const char *path, const char *text, size_t length)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert(g_file_set_contents(path, text, (gssize)length, NULL));
    const enum mpm_status status = mpm_scene_read(path, NULL, 0, &scene, &error);
    ck_assert_msg((status == MPM_OK) == (scene != NULL), "%.*s", (int)length, text);
    ck_assert_msg(status == MPM_OK || status == MPM_BAD_INPUT, "%s", error.message);
    ck_assert((status == MPM_OK) == (error.message[0] == '\0'));
    mpm_scene_free(scene);
    return status;
}

/* Cut anywhere, or with one character replaced by a sign of YAML: read or refused. */
START_TEST(a_damaged_scene_is_read_or_refused)
{
    static const char signs[] = "{}[]:,-#&*!|>'\"%@ \n0";
    char *folder = test_folder_create();
    char *path = test_folder_path(folder, "scene.yaml");
    char *text = test_file_read("tests/scenes/good/compressed_disk.yaml");
    const size_t length = strlen(text);
    int refused = 0;
    for (size_t i = 0; i < length; i += 7) {
        refused += read_damaged(path, text, i) != MPM_OK;
        const char kept = text[i];
        text[i] = signs[(i / 7) % (sizeof signs - 1)];
        refused += read_damaged(path, text, length) != MPM_OK;
        text[i] = kept;
    }
    ck_assert_int_gt(refused, 100);
    g_free(text);
    g_free(path);
    test_folder_remove(folder);
}
END_TEST

Suite *suite_scene_limits(void)
{
    Suite *suite = suite_create("scene limits");
    TCase *limits = tcase_create("limits");
    tcase_add_test(limits, a_name_may_have_64_characters_of_any_length_in_bytes);
    tcase_add_test(limits, nesting_of_64_levels_is_the_deepest);
    tcase_add_test(limits, a_byte_order_mark_at_the_start_is_passed_over);
    tcase_add_test(limits, a_file_of_16_mib_is_the_biggest);
    tcase_add_test(limits, a_grid_of_two_to_the_31_nodes_is_the_biggest);
    suite_add_tcase(suite, limits);
    TCase *files = tcase_create("files");
    tcase_add_test(files, a_scene_that_is_no_readable_file_is_refused);
    tcase_add_test(files, a_scene_that_may_not_be_read_is_refused);
    tcase_add_test(files, an_empty_file_is_refused);
    tcase_add_test(files, a_long_path_leaves_room_for_the_message);
    tcase_add_test(files, a_damaged_scene_is_read_or_refused);
    suite_add_tcase(suite, files);
    return suite;
}
