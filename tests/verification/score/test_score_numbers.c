/* Bundles of numbers: what is expected passes, what is outside of a band does not, and what is no
 * result is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/bundles.h"
#include "support/command.h"
#include "support/folder.h"

#include "verification/score/numbers.h"
#include "verification/suite/judge.h"

#include <glib.h>
#include <string.h>

static const char *const asked[] = {"D1", "D2", "D3", "D4", "D6", "D6b", "D6c", "D7",
                                    "E1", "E2", "E4", "G2", "R1", "T2b", "T2c"};
enum { ASKED = 15 };

/* Results with the expected numbers, but for one. */
static GString *rows_of(const struct bundle *bundle, size_t spoiled, double value)
{
    GString *text = g_string_new("number,value,unit\n"), *rows = g_string_new(NULL);
    for (size_t i = 0; i < bundle->criterion_count; i++) {
        const struct case_check *check = &bundle->criteria[i].check;
        g_string_append_printf(text, "%s,%.17g,%s\n", check->name,
                               i == spoiled ? value : check->band.expected, check->unit);
    }
    char *path = test_folder_write(test_bundles, "numbers.csv", text->str);
    struct mpm_error error = {.message = ""};
    ck_assert_msg(numbers_rows(bundle, path, rows, &error) == MPM_OK, "%s", error.message);
    g_free(path);
    g_string_free(text, TRUE);
    return rows;
}

START_TEST(expected_numbers_pass_and_prove_that_they_can_fail)
{
    struct bundle bundle;
    test_bundle_open(asked[_i], &bundle);
    GString *rows = rows_of(&bundle, SIZE_MAX, 0);
    const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
    for (size_t i = 0; i < bundle.criterion_count; i++) {
        const struct check_verdict judged =
            judge_check_with_proof(&bundle.criteria[i].check, &result);
        ck_assert_msg(judged.verdict.status == VERDICT_PASS, "%s: %g",
                      bundle.criteria[i].check.name, judged.value);
        ck_assert_uint_gt(judged.mutations, 0);
        ck_assert_uint_eq(judged.mutations, judged.mutations_red);
    }
    g_string_free(rows, TRUE);
    bundle_close(&bundle);
}
END_TEST

START_TEST(a_number_outside_of_its_band_alone_turns_red)
{
    struct bundle bundle;
    test_bundle_open(asked[_i], &bundle);
    for (size_t i = 0; i < bundle.criterion_count; i++) {
        const struct verdict_band *const band = &bundle.criteria[i].check.band;
        const double room = band->high - band->low;
        const double values[] = {0, band->low - 1e-6 * room, band->high + 1e-6 * room};
        for (size_t v = 0; v < G_N_ELEMENTS(values); v++) {
            GString *rows = rows_of(&bundle, i, values[v]);
            const struct job_result result = {JOB_RETURNED, 0, 0, 0, rows->str};
            for (size_t k = 0; k < bundle.criterion_count; k++)
                ck_assert_int_eq(
                    verdict_is_red(judge_check(&bundle.criteria[k].check, &result).verdict.status),
                    k == i);
            g_string_free(rows, TRUE);
        }
    }
    bundle_close(&bundle);
}
END_TEST

/* ------------------------------------------------------------------- the command */

#define GOOD "energy_drift,0.2,%\nleast_kinetic,1.3,%\n"

static const struct results {
    const char *text;
    int status;
    const char *said; /* on the screen, or of the error */
} results[] = {
    {"number,value,unit\n" GOOD, 0, "2 passed, 0 failed, 0 skipped"},
    {"# mine\nvalue , number\n0.2,energy_drift\n\n1.3,least_kinetic\n", 0, "2 passed, 0 failed"},
    {"number,value,unit\n" GOOD "temperature,300,K\n", 0, "2 passed, 0 failed"},
    {"number,value,unit\nenergy_drift,0.5,%\nleast_kinetic,1.3,%\n", 1, "1 passed, 1 failed"},
    {"number,value,unit\nenergy_drift,0.2,%\n", 2, "has no number least_kinetic, in %"},
    {"number,value,unit\n" GOOD "energy_drift,0.3,%\n", 2, ":4: energy_drift is there twice"},
    {"number,value,unit\nenergy_drift,nan,%\n", 2, ":2: energy_drift: \"nan\" is not a finite"},
    {"number,value,unit\nenergy_drift,0.2 %,%\n", 2, "\"0.2 %\" is not a finite number"},
    {"number,value,unit\nenergy_drift,0.002,1\n", 2, "unit \"1\": allowed is \"%\""},
    {"number,value,unit\nenergy_drift,0.002\n", 2, ":2: has 2 cells, the line of names 3"},
    {"number,value,unit\nenergy_drift,1e-17,%\nleast_kinetic,1.3,%\n", 0, "2 passed, 0 failed"},
    {"\xEF\xBB\xBFnumber,value\r\nenergy_drift,0.2\r\nleast_kinetic,1.3\r\n", 0,
     "2 passed, 0 failed"},
    {"number,value,value\nenergy_drift,0.2,0.3\n", 2, ":1: column value is there twice"},
    {"energy_drift,0.2,%\n", 2,
     ":1: begins with \"energy_drift\": allowed is a line with the names"},
    {"# nothing\n", 2, "holds no line of names"},
};

START_TEST(the_command_scores_numbers_and_refuses_what_are_none)
{
    char *name = g_strdup_printf("report-%d", _i);
    char *home = test_folder_path(test_bundles, "E1"),
         *output = test_folder_path(test_bundles, name);
    char *path = test_folder_write(test_bundles, "mine.csv", results[_i].text);
    struct test_command command =
        test_command_run("mpm-verify", "score", home, path, "--output", output, NULL);
    const char *said = results[_i].status == 2 ? command.errors : command.output;
    ck_assert_msg(command.exit_status == results[_i].status, "%s%s", command.output,
                  command.errors);
    ck_assert_msg(strstr(said, results[_i].said) != NULL, "%s", said);
    ck_assert_int_eq(test_file_exists(output), results[_i].status != 2);
    test_command_free(&command);
    g_free(path);
    g_free(output);
    g_free(home);
    g_free(name);
}
END_TEST

START_TEST(a_nul_byte_hides_nothing_behind_it)
{
    static const char text[] = "number,value,unit\n" GOOD "\0energy_drift,9,%\n";
    char *home = test_folder_path(test_bundles, "E1"),
         *path = test_folder_path(test_bundles, "nul.csv");
    ck_assert(g_file_set_contents(path, text, sizeof text - 1, NULL));
    struct test_command command = test_command_run("mpm-verify", "score", home, path, NULL);
    ck_assert_int_eq(command.exit_status, 2);
    ck_assert_ptr_nonnull(strstr(command.errors, "nul.csv:4: holds a NUL byte"));
    test_command_free(&command);
    g_free(path);
    g_free(home);
}
END_TEST

START_TEST(a_page_says_what_a_number_is_and_what_was_not_read)
{
    char *home = test_folder_path(test_bundles, "E1"),
         *output = test_folder_path(test_bundles, "page");
    char *path = test_folder_write(test_bundles, "mine.csv", results[2].text);
    struct test_command command =
        test_command_run("mpm-verify", "score", home, path, "--output", output, NULL);
    char *page_path = g_build_filename(output, "cases/E1/index.html", NULL);
    char *page = test_file_read(page_path);
    ck_assert_ptr_nonnull(strstr(page, "least kinetic energy in the course of time"));
    ck_assert_ptr_nonnull(strstr(page, "not read: temperature"));
    test_command_free(&command);
    g_free(page);
    g_free(page_path);
    g_free(path);
    g_free(output);
    g_free(home);
}
END_TEST

/* ------------------------------------------------------------------- the bundle */

START_TEST(a_bundle_of_numbers_that_was_changed_is_refused_with_the_reason)
{
    static const struct {
        const char *from, *to, *message;
    } table[] = {
        {"\"numbers\"", "\"words\"", "results: allowed is fields or numbers"},
        {"\"numbers\"", "\"fields\"", "end, instants: allowed is"},
        {"\"basis\": \"literature\"", "\"basis\": \"hearsay\"", "criteria: basis: allowed is"},
        {"\"unit\": \"%\"", "\"units\": \"%\"", "criteria: allowed is quantity and unit"},
        {"\"quantity\"", "\"amount\"", "criteria: allowed is quantity and unit"},
        {"\"low\": 0.2", "\"low\": -0.2", "criterion least_kinetic: the band holds zero"},
        {"\"least_kinetic\"", "\"energy_drift\"", "criterion: allowed is each name once"},
    };
    char *home = test_folder_path(test_bundles, "E1");
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *folder = test_folder_create(), *path = test_folder_path(home, "problem.json");
        char *text = test_file_read(path), **parts = g_strsplit(text, table[i].from, 2);
        ck_assert_msg(g_strv_length(parts) == 2, "row %zu", i);
        char *changed = g_strconcat(parts[0], table[i].to, parts[1], NULL);
        g_free(test_folder_write(folder, "problem.json", changed));
        g_free(test_folder_write(folder, "problem.md", "words"));
        struct bundle bundle;
        struct mpm_error error = {.message = "accepted"};
        ck_assert_int_eq(bundle_read(folder, &bundle, &error), MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, table[i].message) != NULL, "row %zu: %s", i,
                      error.message);
        g_free(changed);
        g_strfreev(parts);
        g_free(text);
        g_free(path);
        test_folder_remove(folder);
    }
    g_free(home);
}
END_TEST

/* Other codes have other laws of the same names. */
START_TEST(every_law_of_a_bundle_is_stated_as_a_formula)
{
    struct bundle bundle;
    test_bundle_open(asked[_i], &bundle);
    const json_t *problem = json_object_get(bundle.json, "problem");
    const json_t *laws = json_object_get(bundle.json, "laws");
    const json_t *materials = json_object_get(problem, "materials");
    ck_assert(bundle.numbers && json_array_size(materials) > 0);
    for (size_t i = 0; i < json_array_size(materials); i++) {
        const char *law = json_string_value(json_object_get(json_array_get(materials, i), "law"));
        ck_assert_msg(json_object_get(laws, law) != NULL, "%s: %s", asked[_i], law);
    }
    const json_t *cracks = json_object_get(problem, "cracks");
    for (size_t i = 0; i < json_array_size(cracks); i++) {
        const json_t *cohesive = json_object_get(json_array_get(cracks, i), "cohesive");
        const char *law = json_string_value(json_object_get(cohesive, "law"));
        ck_assert_msg(law == NULL || json_object_get(laws, law) != NULL, "%s: %s", asked[_i], law);
    }
    bundle_close(&bundle);
}
END_TEST

START_TEST(tables_that_numbers_are_told_from_lie_beside_them)
{
    char *copy_path = g_build_filename(test_bundles, "D2", "particles_plane_strain.csv", NULL);
    char *copy = test_file_read(copy_path);
    char *own = test_file_read("reference_data/dcb_double_cantilever/particles_plane_strain.csv");
    ck_assert_str_eq(copy, own);
    g_free(own);
    g_free(copy);
    g_free(copy_path);
}
END_TEST

Suite *suite_score_numbers(void)
{
    Suite *suite = suite_create("score_numbers");
    TCase *numbers = tcase_create("numbers");
    tcase_add_unchecked_fixture(numbers, test_bundles_export, test_bundles_remove);
    tcase_add_loop_test(numbers, expected_numbers_pass_and_prove_that_they_can_fail, 0, ASKED);
    tcase_add_loop_test(numbers, a_number_outside_of_its_band_alone_turns_red, 0, ASKED);
    tcase_add_loop_test(numbers, the_command_scores_numbers_and_refuses_what_are_none, 0,
                        (int)G_N_ELEMENTS(results));
    tcase_add_test(numbers, a_nul_byte_hides_nothing_behind_it);
    tcase_add_test(numbers, a_page_says_what_a_number_is_and_what_was_not_read);
    tcase_add_test(numbers, a_bundle_of_numbers_that_was_changed_is_refused_with_the_reason);
    tcase_add_loop_test(numbers, every_law_of_a_bundle_is_stated_as_a_formula, 0, ASKED);
    tcase_add_test(numbers, tables_that_numbers_are_told_from_lie_beside_them);
    suite_add_tcase(suite, numbers);
    return suite;
}
