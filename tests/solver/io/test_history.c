/* Rows of history.csv, units, and what the binary knows of itself.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/history.h"
#include "io/units.h"
#include "suites.h"
#include "support/results.h"

#include <glib.h>
#include <math.h>
#include <string.h>

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
    const double expected[TEST_HISTORY_COLUMNS] = {
        ledger.time,          (double)ledger.step,     ledger.mass,           ledger.momentum[0],
        ledger.momentum[1],   ledger.angular_momentum, ledger.kinetic_energy, ledger.strain_energy,
        ledger.external_work, ledger.total_energy,     ledger.j_min,          ledger.j_max};
    struct mpm_history *history = NULL;
    (void)mpm_history_create(test_results.folder, test_results.scene, &history, NULL);
    for (int k = 0; k < 2; k++) /* the second time: no row */
        ck_assert_int_eq(mpm_history_write(history, &ledger, NULL, NULL), MPM_OK);
    size_t rows = 0; /* read before the file is closed: rows reach the system at once */
    double(*values)[TEST_HISTORY_COLUMNS] = test_results_history(test_results.folder, &rows);
    ck_assert(rows == 1 && values != NULL);
    for (int k = 0; k < TEST_HISTORY_COLUMNS; k++)
        ck_assert_double_eq(values[0][k], expected[k]);
    g_free(values);
    mpm_history_free(history);
}
END_TEST

START_TEST(units_are_made_of_the_scenes_own)
{
    const struct {
        struct mpm_dimension dimension;
        const char *named, *unnamed;
    } units[] = {
        {MPM_DIMENSION_STRESS, "g mm^-1 ms^-2", "mass length^-1 time^-2"},
        {MPM_DIMENSION_NONE, "1", "1"},
        {MPM_DIMENSION_LENGTH, "mm", "length"},
        {MPM_DIMENSION_VELOCITY, "mm ms^-1", "length time^-1"},
        {{.length = 2, .temperature = -1}, "mm^2 K^-1", "length^2 temperature^-1"},
    };
    const struct mpm_scene unnamed = {.title = NULL};
    for (size_t i = 0; i < G_N_ELEMENTS(units); i++) {
        char text[MPM_UNIT_SIZE];
        mpm_unit_text(test_results.scene, units[i].dimension, text);
        ck_assert_str_eq(text, units[i].named);
        mpm_unit_text(&unnamed, units[i].dimension, text);
        ck_assert_str_eq(text, units[i].unnamed);
    }
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

Suite *suite_history(void)
{
    Suite *suite = suite_create("history");
    TCase *test_case = tcase_create("files");
    tcase_add_checked_fixture(test_case, test_results_set_up, test_results_tear_down);
    tcase_add_test(test_case, history_rows_read_back_as_the_same_bits);
    tcase_add_test(test_case, units_are_made_of_the_scenes_own);
    tcase_add_test(test_case, the_binary_knows_what_it_is);
    suite_add_tcase(suite, test_case);
    return suite;
}
