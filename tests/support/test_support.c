/* The test helpers: nearness, folders, commands, combinations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/soft_block.h"

#include <glib.h>

START_TEST(nearness_has_two_sides_and_refuses_nan)
{
    const double tolerance = 0.125;
    ck_assert(test_is_near(1.125, 1.0, tolerance));
    ck_assert(test_is_near(0.875, 1.0, tolerance));
    ck_assert(!test_is_near(1.1251, 1.0, tolerance));
    ck_assert(!test_is_near(0.8749, 1.0, tolerance));
    ck_assert(!test_is_near((double)NAN, 1.0, tolerance));
    ck_assert(!test_is_near(1.0, (double)NAN, tolerance));
    ck_assert(!test_is_near(1.0, 2.0, (double)NAN));
    ck_assert(!test_is_near((double)INFINITY, 1.0, tolerance));
    ck_assert_near(1.0, 1.0, 0.0);
}
END_TEST

START_TEST(a_folder_goes_with_all_that_it_holds)
{
    char *folder = test_folder_create();
    char *inner = test_folder_path(folder, "inner");
    ck_assert_int_eq(g_mkdir_with_parents(inner, 0755), 0);
    char *file = test_folder_write(inner, "note.txt", "text\n");
    char *text = test_file_read(file);
    ck_assert_str_eq(text, "text\n");

    char *kept = g_strdup(folder);
    test_folder_remove(folder);
    ck_assert(!test_file_exists(file));
    ck_assert(!test_file_exists(kept));
    g_free(inner);
    g_free(file);
    g_free(text);
    g_free(kept);
}
END_TEST

START_TEST(a_command_gives_its_output_errors_and_exit_status)
{
    struct test_command command =
        test_command_run("/bin/sh", "-c", "echo out; echo err >&2; exit 3", NULL);
    ck_assert_int_eq(command.exit_status, 3);
    ck_assert_str_eq(command.output, "out\n");
    ck_assert_str_eq(command.errors, "err\n");
    test_command_free(&command);
}
END_TEST

START_TEST(a_command_ended_by_a_signal_says_so)
{
    struct test_command command = test_command_run("/bin/sh", "-c", "kill -9 $$", NULL);
    ck_assert_int_eq(command.exit_status, 128 + 9);
    test_command_free(&command);
}
END_TEST

START_TEST(a_combination_is_what_its_scene_has)
{
    struct settings settings = test_combination_settings(_i);
    struct test_run run = test_run_open(TEST_SOFT_BLOCK(""), settings.texts, 1);
    ck_assert_int_eq(run.scene->shape, _i % TEST_SHAPES);
    ck_assert_int_eq(run.scene->geometry, _i / TEST_SHAPES % TEST_GEOMETRIES);
    ck_assert_int_eq(run.scene->stress_update, _i / TEST_SHAPES / TEST_GEOMETRIES % TEST_ORDERS);
    const struct test_combination c = test_combination(_i);
    ck_assert(c.axisymmetric == (run.scene->geometry == MPM_AXISYMMETRIC));
    ck_assert(c.amplifies_round_off ==
              (run.scene->shape == MPM_CLASSIC && run.scene->stress_update == MPM_USL));
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

Suite *suite_support(void)
{
    Suite *suite = suite_create("support");
    TCase *tests = tcase_create("support");
    tcase_add_test(tests, nearness_has_two_sides_and_refuses_nan);
    tcase_add_test(tests, a_folder_goes_with_all_that_it_holds);
    tcase_add_test(tests, a_command_gives_its_output_errors_and_exit_status);
    tcase_add_test(tests, a_command_ended_by_a_signal_says_so);
    tcase_add_loop_test(tests, a_combination_is_what_its_scene_has, 0, 2 * TEST_COMBINATIONS);
    suite_add_tcase(suite, tests);
    return suite;
}
