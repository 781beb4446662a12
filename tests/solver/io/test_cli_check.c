/* mpm check: threads and limits of stability.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/blocks.h"
#include "support/command.h"
#include "support/folder.h"

#include <glib.h>
#include <string.h>

static struct {
    char *folder, *scene;
} fixture;

static void set_up(void)
{
    fixture.folder = test_folder_create();
    fixture.scene = test_folder_write(fixture.folder, "blocks.yaml", TEST_BLOCKS);
}

static void tear_down(void)
{
    g_free(fixture.scene);
    test_folder_remove(fixture.folder);
}

static char *checked_with_threads(const char *threads)
{
    char *const before = g_strdup(g_getenv("OMP_NUM_THREADS"));
    (void)g_setenv("OMP_NUM_THREADS", threads, TRUE);
    struct test_command command =
        test_command_run("mpm", "check", fixture.scene, "--set", "grid.refine=4", NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    char *const line = g_strdup(strstr(command.output, "\nthreads"));
    test_command_free(&command);
    g_unsetenv("OMP_NUM_THREADS");
    if (before != NULL)
        (void)g_setenv("OMP_NUM_THREADS", before, TRUE);
    g_free(before);
    return line;
}

START_TEST(the_environment_gives_the_number_of_threads)
{
    static const char *const pairs[][2] = {{"5,2", "5"}, {" 5 ,2", "5"}, {"1024", "1024"}};
    for (size_t k = 0; k < G_N_ELEMENTS(pairs); k++) {
        char *const given = checked_with_threads(pairs[k][0]);
        char *const meant = checked_with_threads(pairs[k][1]);
        ck_assert_msg(g_strcmp0(given, meant) == 0, "'%s': %s", pairs[k][0], given);
        g_free(given);
        g_free(meant);
    }
}
END_TEST

/* Classic USL: G1 found large motions unbounded at 0.1 already, the least Courant number tried. */
static const struct {
    const char *method, *courant, *words; /* words: NULL if there is no warning */
} rows[] = {
    {"method={shape: classic, stress_update: usl}", "time.courant=0.4",
     "warning    Courant number 0.4: none from 0.1 on has been found at which this method kept "
     "motions at 0.3 of the wave speed bounded (case G1): large strains may feed its energy"},
    {"method={shape: classic, stress_update: usl}", "time.courant=0.1", NULL},
    {"method={shape: bspline2, stress_update: usavg, extrapolate: false}", "time.courant=0.9",
     NULL},
    {"method={shape: bspline3, stress_update: usavg, extrapolate: false}", "time.courant=1", NULL},
};

START_TEST(a_warning_of_the_courant_number_can_be_satisfied)
{
    struct test_command command = test_command_run(
        "mpm", "check", fixture.scene, "--set", rows[_i].method, "--set", rows[_i].courant, NULL);
    ck_assert_int_eq(command.exit_status, MPM_OK);
    const char *const found =
        strstr(command.output, rows[_i].words != NULL ? rows[_i].words : "warning");
    ck_assert_msg((found != NULL) == (rows[_i].words != NULL), "%s", command.output);
    test_command_free(&command);
}
END_TEST

Suite *suite_cli_check(void)
{
    Suite *suite = suite_create("cli_check");
    TCase *check = tcase_create("check");
    tcase_add_checked_fixture(check, set_up, tear_down);
    tcase_add_test(check, the_environment_gives_the_number_of_threads);
    tcase_add_loop_test(check, a_warning_of_the_courant_number_can_be_satisfied, 0,
                        G_N_ELEMENTS(rows));
    suite_add_tcase(suite, check);
    return suite;
}
