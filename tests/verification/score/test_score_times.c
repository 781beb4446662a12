/* Results whose positions, velocities and stress are of other times than their row, and what
 * problem.md says of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/bundles.h"
#include "support/command.h"
#include "support/folder.h"

#include "verification/common/rows.h"
#include "verification/exact/waves/vibrating_bar.h"
#include "verification/score/readers.h"
#include "verification/score/results.h"
#include "verification/score/score.h"
#include "verification/suite/judge.h"

#include <glib.h>
#include <hdf5.h>
#include <math.h>
#include <string.h>

/* Half a step of E3, and its times between instants, ms. */
static const double HALF_STEP = 0.2, INTERVAL = 4.0;

/* A cubic polynomial through instants an eighth of a period apart, half a step from one:
 * s (1 - s) (1 + s) (2 - s)/24 (pi/4)^4 = 0.16 %, s = 0.05, twice that beyond the last instant. */
static const double INTERPOLATION = 0.25;

static const struct vibrating_bar bar = {16.0, 1.0, 1.0, 1e-4, VIBRATING_BAR_HELD};

static void copy_of_reference(const struct bundle *bundle, struct score_table *copy)
{
    struct mpm_error error;
    score_table_open(copy);
    ck_assert_int_eq(
        score_table_append(copy, &bundle->reference, bundle->format.geometry, "copy", &error),
        MPM_OK);
}

/* The agreement of each criterion. */
static void agreements(const struct bundle *bundle, const struct score_table *results,
                       double *values)
{
    struct mpm_error error = {.message = ""};
    GString *rows = g_string_new(NULL);
    ck_assert_msg(score_rows(bundle, results, rows, &error) == MPM_OK, "%s", error.message);
    const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
    for (size_t i = 0; i < bundle->criterion_count; i++)
        values[i] = judge_check(&bundle->criteria[i].check, &result).value;
    g_string_free(rows, TRUE);
}

/* Each quantity of E3 at a time of its own, as a leapfrog has it, or all its columns of times. */
static void stagger(struct score_table *table, bool stated)
{
    static const double shift[3] = {1.0, -1.0,
                                    1.0}; /* half steps of positions, velocities, stress */
    const enum score_column columns[3] = {SCORE_DISPLACEMENT_X, SCORE_VELOCITY_X, SCORE_STRESS_XX};
    for (int k = 0; k < 3; k++) {
        double *times =
            stated ? score_table_add(table, (enum score_column)(SCORE_POSITION_TIME + k)) : NULL;
        double *values = score_table_add(table, columns[k]);
        for (size_t p = 0; p < table->rows; p++) {
            const double time = score_table_value(table, SCORE_TIME, p) + shift[k] * HALF_STEP;
            const double start = score_table_value(table, SCORE_INITIAL_X, p);
            values[p] = k == 0   ? vibrating_bar_displacement(&bar, start, time)
                        : k == 1 ? vibrating_bar_velocity(&bar, start, time)
                                 : bar.modulus * vibrating_bar_strain(&bar, start, time);
            if (stated)
                times[p] = time;
        }
    }
}

START_TEST(a_leapfrog_agrees_where_it_states_its_times)
{
    struct bundle bundle;
    test_bundle_open("E3", &bundle);
    ck_assert_uint_eq(bundle.criterion_count, 3);
    for (int stated = 0; stated < 2; stated++) {
        struct score_table table;
        double values[3];
        copy_of_reference(&bundle, &table);
        stagger(&table, stated == 1);
        agreements(&bundle, &table, values);
        const double expected = stated == 1 ? 100.0 : 96.07;
        const double tolerance = stated == 1 ? INTERPOLATION : 0.05;
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(values[k], expected, tolerance);
        score_table_close(&table);
    }
    bundle_close(&bundle);
}
END_TEST

/* E3 as the field's standard code writes it with MUSL and a Courant number of 0.6: positions half a
 * step of 0.6 ms late, the frequency 0.5 % low on 16 cells; the start is the given velocity. */
static void write_late(struct score_table *table, double slow, double late, bool stated)
{
    struct vibrating_bar own = bar;
    own.density /= (1.0 - slow) * (1.0 - slow);
    own.amplitude /= 1.0 - slow;
    double *times = stated ? score_table_add(table, SCORE_POSITION_TIME) : NULL;
    double *displacement = score_table_add(table, SCORE_DISPLACEMENT_X);
    double *velocity = score_table_add(table, SCORE_VELOCITY_X);
    double *stress = score_table_add(table, SCORE_STRESS_XX);
    for (size_t p = 0; p < table->rows; p++) {
        const double time = score_table_value(table, SCORE_TIME, p);
        const double start = score_table_value(table, SCORE_INITIAL_X, p);
        displacement[p] = vibrating_bar_displacement(&own, start, time - late);
        velocity[p] = vibrating_bar_velocity(&own, start, time);
        stress[p] = own.modulus * vibrating_bar_strain(&own, start, time);
        if (stated)
            times[p] = time - late;
    }
}

START_TEST(a_good_method_passes_e3_by_its_time_level_and_a_slow_one_fails)
{
    static const struct {
        double slow, late;   /* of the frequency; ms */
        double displacement; /* %, to 0.3: a quarter of the cubic's error and the digits */
        bool stated, passes;
    } rows[] = {
        {0.005, 0.0, 96.0, false, true}, /* what 16 cells cost */
        {0.005, 0.2, 92.3, false, true}, /* half a step at Courant number 0.4: allowed for */
        {0.005, 0.3, 90.4, false, false}, {0.005, 0.3, 96.0, true, true},
        {0.005, 0.4, 88.5, false, false}, {0.005, 0.4, 96.0, true, true},
        {0.03, 0.0, 75.9, false, false},  {0.03, 0.3, 70.9, false, false},
        {0.03, 0.3, 76.2, true, false}, /* no time level makes up for a low frequency */
        {0.03, -0.6, 84.8, false, false}, {0.03, -0.6, 75.3, true, false},
    };
    struct bundle bundle;
    test_bundle_open("E3", &bundle);
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        struct score_table table;
        double values[3];
        bool passes = true;
        copy_of_reference(&bundle, &table);
        write_late(&table, rows[k].slow, rows[k].late, rows[k].stated);
        agreements(&bundle, &table, values);
        for (size_t i = 0; i < bundle.criterion_count; i++)
            passes = passes && values[i] >= bundle.criteria[i].check.band.low &&
                     values[i] <= bundle.criteria[i].check.band.high;
        ck_assert_msg(fabs(values[0] - rows[k].displacement) < 0.3, "%zu: %g", k, values[0]);
        ck_assert_msg(passes == rows[k].passes, "%zu: %g, %g, %g", k, values[0], values[1],
                      values[2]);
        score_table_close(&table);
    }
    bundle_close(&bundle);
}
END_TEST

/* What a good method of second order has at the resolution that the bundle names, with a Courant
 * number of 0.4: half a step, and errors that add up with it or not, from `why` of the criterion.
 */
static const struct {
    const char *bundle, *criterion;
    double half_step, along, beside; /* unit of time; % */
} sums[] = {
    {"C2", "stress", 0.05, 0, 12},
    {"C2", "velocity", 0.05, 0.5, 0},
    {"D5", "velocity", 0.005, 0.1, 0},
    {"E3", "displacement", 0.2, 3.6, 0},
    {"E3", "velocity", 0.2, 3.6, 0},
    {"E3", "stress", 0.2, 3.6, 4.9},
    {"H1", "temperature", 0.028, 0.4, 0},
    {"H2", "temperature", 1e-4, 0.13, 0},
    {"H5", "temperature", 1e-4, 1.8, 0},
    {"M1", "displacement", 5.4e-5, 0.5, 0},
    {"M1", "velocity", 5.4e-5, 0.5, 0},
    {"M1", "stress", 5.4e-5, 0.5, 4.9},
    {"M2", "displacement", 2.2e-5, 0.14, 0},
    {"M2", "velocity", 2.2e-5, 0.5, 0},
    {"M2", "stress", 2.2e-5, 0, 8.6},
    {"M3", "displacement", 5.4e-3, 1.1, 0},
    {"M3", "velocity", 5.4e-3, 1.1, 0},
    {"M3", "stress", 5.4e-3, 0, 7.4},
    {"M4", "displacement", 4e-5, 0.5, 0},
    {"M4", "velocity", 4e-5, 0.5, 0},
    {"M4", "stress", 4e-5, 0.5, 4.9},
    {"P3", "displacement", 0.014, 0.6, 0},
    {"P3", "stress", 0.014, 0, 12},
    {"R1b", "volume", 3e-4, 1, 0},
    {"R1b", "stress", 3e-4, 2.1, 0},
    {"R1b", "displacement", 3e-4, 0.5, 0},
    {"W1", "stress", 0.2, 0, 13},
    {"W1", "level", 0.2, 0.6, 0},
    {"W2", "displacement", 0.043, 0.75, 0},
    {"W2", "velocity", 0.043, 0.75, 0},
};

/* The error of a method with the sum, as %; the late reading is in proportion. */
static double sum_error(size_t k, const json_t *criterion)
{
    double by, agreement;
    ck_assert_int_eq(json_unpack((json_t *)criterion, "{s: {s: F, s: F}}", "late", "by", &by,
                                 "agreement", &agreement),
                     0);
    return hypot(fabs(100.0 - agreement) * sums[k].half_step / by + sums[k].along, sums[k].beside);
}

/* Every criterion that depends on time is in the table, so that a new one gets its sum too. */
START_TEST(half_a_step_and_the_errors_of_a_good_method_fit_into_every_band)
{
    size_t timed = 0;
    GDir *folder = g_dir_open(test_bundles, 0, NULL);
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder)) {
        char *path = g_build_filename(test_bundles, name, "problem.json", NULL);
        json_t *problem = json_load_file(path, 0, NULL);
        size_t i;
        const json_t *criterion;
        json_array_foreach(json_object_get(problem, "criteria"), i, criterion)
        {
            if (json_object_get(criterion, "late") == NULL)
                continue;
            const char *id = json_string_value(json_object_get(criterion, "criterion"));
            size_t k = 0;
            while (k < G_N_ELEMENTS(sums) &&
                   (strcmp(sums[k].bundle, name) != 0 || strcmp(sums[k].criterion, id) != 0))
                k++;
            ck_assert_msg(k < G_N_ELEMENTS(sums), "%s/%s is not in the table", name, id);
            const double band = 100.0 - json_number_value(json_object_get(criterion, "low"));
            ck_assert_msg(sum_error(k, criterion) < band, "%s/%s: %g of %g", name, id,
                          sum_error(k, criterion), band);
            timed++;
        }
        json_decref(problem);
        g_free(path);
    }
    g_dir_close(folder);
    ck_assert_uint_eq(timed, G_N_ELEMENTS(sums));
}
END_TEST

/* At rest they mean nothing; else the time of the row changes nothing. */
START_TEST(the_time_of_the_row_may_be_stated_too)
{
    static const char *const bundles[] = {"D5", "M1", "R1b", "T4", "W2"};
    struct bundle bundle;
    struct score_table table;
    double values[8];
    test_bundle_open(bundles[_i], &bundle);
    copy_of_reference(&bundle, &table);
    for (int c = SCORE_POSITION_TIME; c <= SCORE_STRESS_TIME; c++) {
        double *times = score_table_add(&table, (enum score_column)c);
        for (size_t p = 0; p < table.rows; p++)
            times[p] = bundle.rest ? 7.0 : score_table_value(&table, SCORE_TIME, p);
    }
    agreements(&bundle, &table, values);
    for (size_t i = 0; i < bundle.criterion_count; i++)
        ck_assert_double_eq_tol(values[i], 100.0, 1e-6);
    score_table_close(&table);
    bundle_close(&bundle);
}
END_TEST

START_TEST(times_that_nothing_is_known_of_are_refused)
{
    static const struct {
        const char *bundle, *message;
        double shift;
    } refused[] = {
        {"E3", "time_of_velocities 5.001 at time 4 ms: allowed is 1 either side", 1.001},
        {"W1", "time_of_velocities, but this reference jumps", 0.0},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(refused); k++) {
        struct bundle bundle;
        struct score_table table;
        struct mpm_error error = {.message = ""};
        GString *rows = g_string_new(NULL);
        test_bundle_open(refused[k].bundle, &bundle);
        copy_of_reference(&bundle, &table);
        double *times = score_table_add(&table, SCORE_VELOCITY_TIME);
        for (size_t p = 0; p < table.rows; p++)
            times[p] = score_table_value(&table, SCORE_TIME, p) + refused[k].shift;
        ck_assert_int_eq(score_rows(&bundle, &table, rows, &error), MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, refused[k].message) != NULL, "%s", error.message);
        g_string_free(rows, TRUE);
        score_table_close(&table);
        bundle_close(&bundle);
    }
}
END_TEST

START_TEST(files_state_times_by_columns_and_attributes)
{
    char *folder = test_folder_create(), *results = test_folder_path(folder, "mpm");
    struct test_command command =
        test_command_run("mpm", "run", "verification/catalogue/E/E3/scene.yaml", "--quiet", "--set",
                         "time.end=4", "--output", results, NULL);
    ck_assert_msg(command.exit_status == 0, "%s", command.errors);
    test_command_free(&command);
    char *snapshot = test_folder_path(results, "particles-000000.hdf");
    const double time = -HALF_STEP;
    const hid_t file = H5Fopen(snapshot, H5F_ACC_RDWR, H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate_by_name(file, "/mpm", "time_of_velocities", H5T_NATIVE_DOUBLE,
                                              space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    ck_assert_int_ge(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &time), 0);
    ck_assert(H5Aclose(attribute) >= 0 && H5Sclose(space) >= 0 && H5Fclose(file) >= 0);
    char *csv = test_folder_write(folder, "one.csv",
                                  "time,initial_x,velocity_x,time_of_velocities [ms]\n"
                                  "4,1,2,3.8\n");
    const struct score_format format = {MPM_PLANE_STRAIN, {"mm", "g", "ms", ""}, 0};
    struct mpm_error error = {.message = ""};
    const char *const paths[] = {snapshot, csv};
    const double expected[] = {-HALF_STEP, INTERVAL - HALF_STEP};
    for (int k = 0; k < 2; k++) {
        struct score_table table;
        ck_assert_msg(results_read(paths[k], &format, &table, &error) == MPM_OK, "%s",
                      error.message);
        ck_assert(score_table_has(&table, SCORE_VELOCITY_TIME));
        ck_assert(!score_table_has(&table, SCORE_STRESS_TIME));
        ck_assert_double_eq(score_table_value(&table, SCORE_VELOCITY_TIME, table.rows - 1),
                            expected[k]);
        score_table_close(&table);
    }
    g_free(csv);
    g_free(snapshot);
    g_free(results);
    test_folder_remove(folder);
}
END_TEST

/* A part of problem.md that is there, or is not. */
START_TEST(problems_say_what_to_convert)
{
    static const struct {
        const char *bundle, *part;
        bool there;
    } parts[] = {
        {"E3", "Read 0.2 ms late: 96.07 %.", true},
        {"E3", "**Time levels**", true},
        {"E3", "per radian", false},
        {"T4", "**Stress** is Cauchy's, tension positive", true},
        {"T4", "**Time levels**", false},
        {"T4", " late: ", false},
        {"H2", "**Time levels**", false},
        {"H2", "**Temperatures**", true},
        {"W2", "full revolution over 2 pi. Fields are the same.", true},
        {"R1", "full revolution over 2 pi. Ratios are the same.", true},
        {"R1", "**Particles as VTK**", false},
        {"E1", "**Energies** of a leapfrog", true},
        {"E1", "per radian", false},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(parts); k++) {
        char *path = g_build_filename(test_bundles, parts[k].bundle, "problem.md", NULL);
        char *text = test_file_read(path), *end = strstr(text, "\n---\n");
        ck_assert_ptr_nonnull(end);
        *end = '\0'; /* what follows is the case's own text */
        ck_assert_ptr_nonnull(strstr(text, "\n## From what codes commonly write\n"));
        ck_assert_msg((strstr(text, parts[k].part) != NULL) == parts[k].there, "%s: %s",
                      parts[k].bundle, parts[k].part);
        g_free(text);
        g_free(path);
    }
}
END_TEST

Suite *suite_score_times(void)
{
    Suite *suite = suite_create("score_times");
    TCase *times = tcase_create("times");
    tcase_add_unchecked_fixture(times, test_bundles_export, test_bundles_remove);
    tcase_add_test(times, a_leapfrog_agrees_where_it_states_its_times);
    tcase_add_test(times, a_good_method_passes_e3_by_its_time_level_and_a_slow_one_fails);
    tcase_add_test(times, half_a_step_and_the_errors_of_a_good_method_fit_into_every_band);
    tcase_add_loop_test(times, the_time_of_the_row_may_be_stated_too, 0, 5);
    tcase_add_test(times, times_that_nothing_is_known_of_are_refused);
    tcase_add_test(times, files_state_times_by_columns_and_attributes);
    tcase_add_test(times, problems_say_what_to_convert);
    suite_add_tcase(suite, times);
    return suite;
}
