/* mpm-verify study: what it measures, refuses, keeps and makes again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/cli/commands.h"
#include "verification/measures/quantities.h"

#include <glib.h>
#include <jansson.h>
#include <math.h>
#include <signal.h>
#include <string.h>

/* A bar that swings in its first mode with a small amplitude, one cell high: plane waves of speed
 * sqrt((K + 4/3 G)/rho). At its start it holds kinetic energy alone. */
static const char bar[] =
    "format: 1\n"
    "title: bar\n"
    "geometry: plane_strain\n"
    "units: {length: mm, mass: g, time: ms}\n"
    "grid: {origin: [0, 0], cell: [4, 4], cells: [9, 1]}\n"
    "time: {end: 4}\n"
    "method: {shape: ugimp}\n"
    "materials: [{name: m, law: neo_hookean, density: 1.0, bulk: 10, shear: 5}]\n"
    "bodies: [{name: bar, material: m, region: {rectangle: {from: [0, 0], to: [32, 4]}},\n"
    "          particles_per_cell: [2, 2], velocity: [\"0.001*sin(pi*x/64)\", 0]}]\n"
    "boundary:\n"
    "  - {region: {line: {from: [0, 0], to: [0, 4]}}, velocity: [0, free]}\n"
    "  - {region: {line: {from: [0, 0], to: [36, 0]}}, velocity: [free, 0]}\n"
    "  - {region: {line: {from: [0, 4], to: [36, 4]}}, velocity: [free, 0]}\n";

/* w = pi c / 64, c = sqrt(50/3) */
#define EXACT "0.001*sin(pi*x/64)*sin(pi*sqrt(50/3)/64*t)/(pi*sqrt(50/3)/64)"

struct place {
    char *folder, *scene, *output;
};

static struct place place_create(void)
{
    struct place place = {.folder = test_folder_create()};
    place.scene = test_folder_path(place.folder, "bar.yaml");
    place.output = test_folder_path(place.folder, "out");
    ck_assert(g_file_set_contents(place.scene, bar, -1, NULL));
    return place;
}

static void place_remove(struct place *place)
{
    g_free(place->scene);
    g_free(place->output);
    test_folder_remove(place->folder);
}

/* Runs mpm-verify with the suite's own programs; @ is the scene, % the output folder. */
static char *verify(const struct place *place, const char *line, int exit_status)
{
    char **argv = g_strsplit(line, " ", -1);
    for (char **argument = argv; *argument != NULL; argument++) {
        const char *own = strcmp(*argument, "@") == 0   ? place->scene
                          : strcmp(*argument, "%") == 0 ? place->output
                                                        : NULL;
        if (own != NULL) {
            g_free(*argument);
            *argument = g_strdup(own);
        }
    }
    FILE *out = tmpfile();
    ck_assert_ptr_nonnull(out);
    const struct suite_world world = {out, out, false, programs_all()};
    const int status = suite_command((int)g_strv_length(argv), argv, &world);
    const long length = ftell(out);
    char *said = g_malloc0((size_t)length + 1);
    rewind(out);
    ck_assert_uint_eq(fread(said, 1, (size_t)length, out), (size_t)length);
    ck_assert_int_eq(fclose(out), 0);
    ck_assert_msg(status == exit_status, "%s: %d: %s", line, status, said);
    g_strfreev(argv);
    return said;
}

/* study.csv without the column of times. */
static char *table_of(const struct place *place)
{
    char *text = test_folder_read(place->output, "study/study.csv");
    GRegex *times = g_regex_new(",[^,]*(,[^,]*,\"[^\"]*\")$", G_REGEX_MULTILINE, 0, NULL);
    char *rest = g_regex_replace(times, text, -1, 0, "\\1", 0, NULL);
    g_regex_unref(times);
    g_free(text);
    return rest;
}

static double order_in(const struct place *place)
{
    char *text = test_folder_read(place->output, "study/study.jsonl");
    const char *line = strstr(text, "\"kind\":\"order\"");
    ck_assert_ptr_nonnull(line);
    const char *order = strstr(line, ",\"order\":");
    ck_assert_ptr_nonnull(order);
    const double value = g_ascii_strtod(order + strlen(",\"order\":"), NULL);
    g_free(text);
    return value;
}

#define STUDY "mpm-verify study @ --output % --jobs 2 "
/* Nine runs, of which the finest take longest. */
#define LONG                                                                                       \
    "--refine 1,2,4 --vary time.courant=0.1,0.2,0.3 --set time.end=40 --measure kinetic_energy"
enum { LONG_RUNS = 9 };
#define NORM "--refine 1,2,4 --measure displacement_x:l2=" EXACT

START_TEST(a_bar_converges_with_second_order_against_its_exact_solution)
{
    struct place place = place_create();
    g_free(verify(&place, STUDY NORM, 0));
    const double order = order_in(&place);
    ck_assert_msg(order > 1.7 && order < 2.3, "order %g", order);
    place_remove(&place);
}
END_TEST

START_TEST(a_wrong_reference_loses_the_order_and_an_interval_reports_it)
{
    struct place place = place_create();
    char *file = test_folder_path(place.folder, "study.yaml");
    char *text = g_strconcat("format: 1\nscene: bar.yaml\nrefine: [1, 2, 4]\nmeasures:\n"
                             "  - {quantity: displacement_x, take: l2, order: [1.7, 2.3],\n"
                             "     reference: \"1.1*" EXACT "\"}\n",
                             NULL);
    ck_assert(g_file_set_contents(file, text, -1, NULL));
    g_free(place.scene);
    place.scene = file;
    char *said = verify(&place, "mpm-verify study @ --output %", 1);
    ck_assert_ptr_nonnull(strstr(said, "NOT within 1.7 .. 2.3"));
    g_free(said);
    g_free(text);
    place_remove(&place);
}
END_TEST

START_TEST(a_study_whose_result_is_lost_goes_on_to_the_same_table)
{
    struct place place = place_create();
    g_free(verify(&place, STUDY "--refine 1,2,4 --measure kinetic_energy", 0));
    char *before = table_of(&place);
    char *results = test_folder_path(place.output, ".run/results");
    GDir *directory = g_dir_open(results, 0, NULL);
    ck_assert_ptr_nonnull(directory);
    char *lost = test_folder_path(results, g_dir_read_name(directory));
    g_dir_close(directory);
    ck_assert_int_eq(remove(lost), 0);
    char *said = verify(&place, "mpm-verify collect %", 1);
    ck_assert_ptr_nonnull(strstr(said, "This study is incomplete: of 3 runs, 0 failed and 1 are"));
    g_free(said);
    g_free(verify(&place, STUDY "--resume", 0));
    char *after = table_of(&place);
    ck_assert_str_eq(before, after);
    g_free(after);
    g_free(before);
    g_free(lost);
    g_free(results);
    place_remove(&place);
}
END_TEST

START_TEST(tables_are_of_the_scene_that_ran_whatever_it_has_become)
{
    struct place place = place_create();
    g_free(verify(&place, STUDY "--refine 1,2 --measure kinetic_energy", 0));
    char *before = table_of(&place), *changed = g_strdup(bar);
    strstr(changed, "cell: [4")[strlen("cell: [")] = '2';
    ck_assert(g_file_set_contents(place.scene, changed, -1, NULL));
    g_free(verify(&place, "mpm-verify collect %", 0));
    char *after = table_of(&place);
    ck_assert_str_eq(before, after);
    ck_assert_int_eq(remove(place.scene), 0);
    g_free(verify(&place, "mpm-verify collect %", 0));
    g_free(after);
    g_free(changed);
    g_free(before);
    place_remove(&place);
}
END_TEST

START_TEST(a_place_outside_of_the_body_is_the_reason_that_a_number_is_missing)
{
    struct place place = place_create();
    char *said = verify(&place, STUDY "--refine 1,2 --measure velocity_x:at@500,2", 0);
    ck_assert_ptr_nonnull(strstr(said, "\n- r2 done: velocity_x: is not finite, or its place"));
    g_free(said);
    place_remove(&place);
}
END_TEST

START_TEST(a_fixed_step_falls_with_the_cells_and_folders_may_have_blanks)
{
    struct place place = place_create();
    g_free(place.output);
    place.output = test_folder_path(place.folder, "it's an \"output\"");
    g_free(verify(&place, STUDY "--refine 1,2,4 --measure kinetic_energy --set time.step=0.05", 0));
    char *table = table_of(&place);
    /* 80, 160 and 320 steps with 32, 128 and 512 particles */
    ck_assert_ptr_nonnull(strstr(table, ",2560,\"\"\nr2,"));
    ck_assert_ptr_nonnull(strstr(table, ",20480,\"\"\nr4,"));
    ck_assert_ptr_nonnull(strstr(table, ",163840,\"\"\n"));
    g_free(table);
    char *picture = test_folder_read(place.output, "study/error-kinetic_energy_last-cell.svg");
    ck_assert_ptr_nonnull(strstr(picture, "slope 1"));
    g_free(picture);
    place_remove(&place);
}
END_TEST

static int run_study(const char *scene, const char *output, const char *options)
{
    char *line = g_strdup_printf("mpm-verify study @ --output %% --jobs 1 %s", options);
    const struct place place = {.scene = (char *)(uintptr_t)scene,
                                .output = (char *)(uintptr_t)output};
    g_free(verify(&place, line, 0));
    g_free(line);
    return 0;
}

static int run_long_study(const char *scene, const char *output)
{
    return run_study(scene, output, LONG);
}

static size_t results_in(const struct place *place)
{
    char *path = test_folder_path(place->output, ".run/results");
    GDir *directory = g_dir_open(path, 0, NULL);
    size_t count = 0;
    while (directory != NULL && g_dir_read_name(directory) != NULL)
        count++;
    if (directory != NULL)
        g_dir_close(directory);
    g_free(path);
    return count;
}

START_TEST(a_study_that_is_killed_goes_on_to_the_same_table)
{
    struct place whole = place_create(), place = place_create();
    g_free(verify(&whole, "mpm-verify study @ --output % --jobs 2 " LONG, 0));
    const pid_t process = test_in_process(run_long_study, place.scene, place.output);
    for (int i = 0; i < 6000 && results_in(&place) < 2; i++)
        g_usleep(5000);
    ck_assert_int_eq(kill(process, SIGKILL), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGKILL);
    const size_t kept = results_in(&place);
    ck_assert_msg(kept >= 2 && kept < LONG_RUNS, "%zu results", kept);
    g_free(verify(&place, "mpm-verify study @ --output % --jobs 2 --resume", 0));
    char *expected = table_of(&whole), *found = table_of(&place);
    ck_assert_str_eq(expected, found);
    g_free(found);
    g_free(expected);
    place_remove(&place);
    place_remove(&whole);
}
END_TEST

/* One run of some seconds, with checkpoints. */
#define LASTING                                                                                    \
    "--refine 4 --set time.end=2000 --set output.history=20 "                                      \
    "--set output.checkpoint_seconds=0.01 --measure kinetic_energy:max"

static int run_lasting_study(const char *scene, const char *output)
{
    return run_study(scene, output, LASTING);
}

/* The folder of the run that is not finished, once it has two checkpoints. */
static char *unfinished_run(const struct place *place)
{
    char *folder = test_folder_path(place->output, ".run/unfinished"), *found = NULL;
    for (int i = 0; i < 6000 && found == NULL; i++) {
        GDir *directory = g_dir_open(folder, 0, NULL);
        const char *name = directory != NULL ? g_dir_read_name(directory) : NULL;
        char *run = name != NULL ? test_folder_path(folder, name) : NULL;
        char *path = run != NULL ? test_folder_path(run, "checkpoint-previous.h5") : NULL;
        if (path != NULL && test_file_exists(path))
            found = g_steal_pointer(&run);
        g_free(path);
        g_free(run);
        if (directory != NULL)
            g_dir_close(directory);
        g_usleep(5000);
    }
    ck_assert_ptr_nonnull(found);
    g_free(folder);
    return found;
}

/* A millionfold of what a run has written before its checkpoint can come from there alone. */
static void raise_first_energy(const char *run)
{
    char *text = test_folder_read(run, "history.csv"), *field = strstr(text, "\n0,0,");
    for (int column = 0; column < 6; column++)
        field = strchr(field + 1, ',');
    char *const exponent = strstr(field, "e-05");
    ck_assert(exponent != NULL && exponent < strchr(field + 1, ','));
    exponent[1] = '+';
    g_free(test_folder_write(run, "history.csv", text));
    g_free(text);
}

/* The state that the picture of the lasting run shows; json_decref. */
static json_t *state_shown(const struct place *place)
{
    char *path = test_folder_path(place->output, "cases/r4/picture-run.json");
    json_t *object = json_load_file(path, 0, NULL);
    ck_assert_ptr_nonnull(object);
    json_t *still = json_incref(json_object_get(object, "still"));
    const json_t *const frame = json_array_get(json_object_get(still, "frames"), 0);
    ck_assert_double_eq(json_number_value(json_object_get(frame, "time")), 2000);
    json_decref(object);
    g_free(path);
    return still;
}

START_TEST(a_run_of_a_study_with_checkpoints_goes_on_from_them)
{
    struct place whole = place_create(), place = place_create();
    g_free(verify(&whole, STUDY LASTING, 0));
    const pid_t process = test_in_process(run_lasting_study, place.scene, place.output);
    char *run = unfinished_run(&place);
    ck_assert_int_eq(kill(process, SIGKILL), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGKILL);
    if (_i == 1)
        raise_first_energy(run);
    g_free(verify(&place, STUDY "--resume", 0));
    ck_assert(!test_file_exists(run));
    char *expected = table_of(&whole), *found = table_of(&place);
    ck_assert_msg((strcmp(expected, found) == 0) == (_i == 0), "%s", found);
    ck_assert((strstr(found, ",3.") == NULL) == (_i == 1));
    json_t *one = state_shown(&whole), *other = state_shown(&place);
    ck_assert(json_equal(one, other));
    json_decref(other);
    json_decref(one);
    g_free(found);
    g_free(expected);
    g_free(run);
    place_remove(&place);
    place_remove(&whole);
}
END_TEST

START_TEST(a_study_goes_on_with_other_settings_to_the_table_of_these)
{
    struct place whole = place_create(), place = place_create();
    g_free(verify(&whole, STUDY "--refine 1,2 --measure kinetic_energy --set time.courant=0.2", 0));
    g_free(verify(&place, STUDY "--refine 1,2 --measure kinetic_energy", 0));
    char *before = table_of(&place);
    g_free(verify(
        &place, STUDY "--refine 1,2 --measure kinetic_energy --set time.courant=0.2 --resume", 0));
    char *expected = table_of(&whole), *found = table_of(&place);
    ck_assert_str_ne(before, found);
    ck_assert_str_eq(expected, found);
    g_free(found);
    g_free(expected);
    g_free(before);
    place_remove(&place);
    place_remove(&whole);
}
END_TEST

START_TEST(a_run_that_fails_is_in_the_table_with_its_cause)
{
    struct place place = place_create();
    char *said =
        verify(&place,
               STUDY "--refine 1,2 --measure kinetic_energy --set time.allow_unstable=true "
                     "--set time.end=400 --vary time.courant=0.4,5",
               1);
    ck_assert(g_regex_match_simple("courant=5 +\\| 2 +\\| 2 +\\| failed +\\|", said, 0, 0));
    ck_assert(g_regex_match_simple("^- 5-r2 failed: [a-z]", said, G_REGEX_MULTILINE, 0));
    ck_assert_ptr_nonnull(strstr(said, "This study is incomplete: of 4 runs, 2 failed and 0 are"));
    g_free(said);
    place_remove(&place);
}
END_TEST

static const struct {
    const char *line, *message;
} refused[] = {
    {"--measure kinetic_energy", "refine: is empty or missing"},
    {"--refine 4,2 --measure kinetic_energy", "refine: 2: allowed are whole numbers"},
    {"--refine 0 --measure kinetic_energy", "allowed are whole numbers from 1"},
    {"--refine 1,2", "measures: 0 are given"},
    {"--refine 1 --measure nonsense", "the scene has no quantity \"nonsense\": allowed are time"},
    {"--refine 1 --measure stress_xx", "take \"\": allowed are last"},
    {"--refine 1 --measure stress_xx:most", "take \"most\": allowed are last"},
    {"--refine 1 --measure stress_xx:l2", "is a norm of the error: allowed is a reference"},
    {"--refine 1 --measure stress_xx:l2=x+", "reference \"x+\""},
    {"--refine 1 --measure stress_xx:at@3", "allowed is a place and no time"},
    {"--refine 1 --measure kinetic_energy:at@99", "time 99: allowed are 0 to time.end"},
    {"--refine 1 --measure kinetic_energy --vary method.shap=cpdi", "shap"},
    {"--refine 1 --measure kinetic_energy --vary method.shape", "allowed is PATH=VALUE"},
    {"--refine 1 --measure kinetic_energy --vary grid.refine=2", "grid.refine is what refine"},
    {"--refine 1 --measure kinetic_energy --set time.steps=3", "time.steps"},
    {"--refine 1 --measure kinetic_energy --timeout 0", "timeout \"0\": allowed are seconds"},
    {"--refine 1 --measure kinetic_energy --resume", "no study was begun here"},
    {"--refine 1 --measure kinetic_energy --launcher cloud",
     "--launcher \"cloud\"; allowed: local, slurm"},
};

START_TEST(bad_input_is_refused_with_a_line_and_nothing_is_written)
{
    struct place place = place_create();
    char *line = g_strconcat(STUDY, refused[_i].line, NULL);
    char *said = verify(&place, line, 2);
    ck_assert_msg(strstr(said, refused[_i].message) != NULL, "%s", said);
    ck_assert_ptr_eq(strchr(said, '\n'), said + strlen(said) - 1);
    ck_assert(!g_file_test(place.output, G_FILE_TEST_EXISTS));
    g_free(said);
    g_free(line);
    place_remove(&place);
}
END_TEST

/* ------------------------------------------------------------------- quantities */

START_TEST(a_plane_is_exact_for_a_linear_field_and_refuses_places_outside)
{
    double places[24], values[12], weight[12];
    for (size_t p = 0; p < 12; p++) {
        places[2 * p] = (double)(p % 4);
        places[2 * p + 1] = floor((double)p / 4.0);
        values[p] = 1.0 + 2.0 * places[2 * p] - 3.0 * places[2 * p + 1];
        weight[p] = 1.0;
    }
    const double inside[2] = {1.3, 0.6}, outside[2] = {30.0, 0.0};
    ck_assert_double_eq_tol(plane_at(12, places, weight, values, inside), 1.8, 1e-12);
    ck_assert(isnan(plane_at(12, places, weight, values, outside)));
    ck_assert(isnan(plane_at(5, places, weight, values, inside)));
}
END_TEST

START_TEST(numbers_of_a_curve_are_those_of_the_curve_through_its_rows)
{
    static const double time[] = {0, 1, 3}, values[] = {0, 2, -2};
    ck_assert_double_eq(curve_at(3, time, values, 2.0), 0.0);
    ck_assert(isnan(curve_at(3, time, values, 3.5)));
    ck_assert_double_eq(curve_take(TAKE_MAX, 3, time, values), 2.0);
    ck_assert_double_eq(curve_take(TAKE_MIN, 3, time, values), -2.0);
    ck_assert_double_eq_tol(curve_take(TAKE_MEAN, 3, time, values), 1.0 / 3.0, 1e-15);
    ck_assert_double_eq_tol(curve_take(TAKE_L1, 3, time, values), 5.0 / 3.0, 1e-15);
    ck_assert_double_eq_tol(curve_take(TAKE_L2, 3, time, values), sqrt(10.0 / 3.0), 1e-15);
    ck_assert_double_eq(curve_take(TAKE_LAST, 3, time, values), -2.0);
}
END_TEST

Suite *suite_study(void)
{
    Suite *suite = suite_create("study");
    TCase *tests = tcase_create("study");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, a_bar_converges_with_second_order_against_its_exact_solution);
    tcase_add_test(tests, a_wrong_reference_loses_the_order_and_an_interval_reports_it);
    tcase_add_test(tests, a_study_whose_result_is_lost_goes_on_to_the_same_table);
    tcase_add_test(tests, tables_are_of_the_scene_that_ran_whatever_it_has_become);
    tcase_add_test(tests, a_place_outside_of_the_body_is_the_reason_that_a_number_is_missing);
    tcase_add_test(tests, a_fixed_step_falls_with_the_cells_and_folders_may_have_blanks);
    tcase_add_test(tests, a_study_that_is_killed_goes_on_to_the_same_table);
    tcase_add_loop_test(tests, a_run_of_a_study_with_checkpoints_goes_on_from_them, 0, 2);
    tcase_add_test(tests, a_study_goes_on_with_other_settings_to_the_table_of_these);
    tcase_add_test(tests, a_run_that_fails_is_in_the_table_with_its_cause);
    tcase_add_loop_test(tests, bad_input_is_refused_with_a_line_and_nothing_is_written, 0,
                        G_N_ELEMENTS(refused));
    tcase_add_test(tests, a_plane_is_exact_for_a_linear_field_and_refuses_places_outside);
    tcase_add_test(tests, numbers_of_a_curve_are_those_of_the_curve_through_its_rows);
    suite_add_tcase(suite, tests);
    return suite;
}
