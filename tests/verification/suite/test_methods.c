/* methods.yaml: variants that cases make of it, and what is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/cases/catalogue.h"
#include "verification/cases/methods.h"
#include "verification/records/records.h"
#include "verification/suite/plan.h"

#include <glib.h>
#include <string.h>

static const char METHODS[] =
    "format: 1\n"
    "methods:\n"
    "  - {name: classic_usl, group: base, title: first of <all>, settings: "
    "[\"method.shape=classic\", \"method.stress_update=usl\"]}\n"
    "  - {name: ugimp_usl, group: base, title: second, settings: [\"method.shape=ugimp\", "
    "\"method.stress_update=usl\"]}\n"
    "  - {name: ugimp_musl, group: base, title: third, settings: [\"method.shape=ugimp\", "
    "\"method.stress_update=musl\"]}\n"
    "  - {name: ugimp_hoop, group: axis, title: fourth, settings: "
    "[\"method.radius_update=hoop\"]}\n";

static const char SCENE[] =
    "format: 1\ntitle: least\ngeometry: plane_strain\nunits: {length: m, mass: kg, time: s}\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [2, 2]}\ntime: {end: 1}\n"
    "materials:\n  - {name: rubber, law: neo_hookean, density: 1, bulk: 1, shear: 1}\n"
    "bodies:\n  - {name: block, material: rubber, region: {rectangle: {from: [0, 0], to: [1, "
    "1]}}}\n";

static const char ASKS[] =
    "scene: scene.yaml\n"
    "methods: {names: [\"ugimp_*\", \"classic_usl\"], except: [\"*_hoop\"], full: [\"*_musl\"], "
    "tier: ci, timeout: 9, settings: [\"time.end=2\"], parameters: [{name: speed, value: 2}]}\n";

/* Case A of that program with `asks` after its program's line, and one check of all variants;
 * with methods.yaml unless NULL. */
static char *catalogue_with(const char *program, const char *methods, const char *asks)
{
    char *folder = test_folder_create();
    char *text = test_case_text("A", program);
    char **parts = g_strsplit(text, "parameters:\n", 2);
    char *added = g_strconcat(parts[0], asks, "parameters:\n", parts[1], NULL);
    char **checks = g_strsplit(added, "variants: [only]", 2);
    char *all = g_strjoinv("variants: [\"*\"]", checks);
    test_case_write(folder, "A", all);
    g_free(test_folder_write(folder, "T/A/scene.yaml", SCENE));
    if (methods != NULL)
        g_free(test_folder_write(folder, "methods.yaml", methods));
    g_free(all);
    g_strfreev(checks);
    g_free(added);
    g_strfreev(parts);
    g_free(text);
    return folder;
}

START_TEST(methods_become_variants_of_their_names_in_the_order_of_the_table)
{
    static const struct {
        const char *name;
        enum tier tier;
        unsigned settings;
    } expected[] = {{"only", TIER_CI, 0},
                    {"classic_usl", TIER_CI, 3},
                    {"ugimp_usl", TIER_CI, 3},
                    {"ugimp_musl", TIER_FULL, 3}};
    char *folder = catalogue_with("pass", METHODS, ASKS);
    struct catalogue *catalogue;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(catalogue_read(folder, test_programs(), &catalogue, &error) == MPM_OK, "%s",
                  error.message);
    const struct case_file *file = catalogue->cases[0].file;
    ck_assert_uint_eq(file->variants_count, G_N_ELEMENTS(expected));
    for (unsigned i = 0; i < file->variants_count; i++) {
        const struct case_variant *variant = &file->variants[i];
        ck_assert_str_eq(variant->name, expected[i].name);
        ck_assert_int_eq(variant->tier, expected[i].tier);
        ck_assert_uint_eq(variant->settings_count, expected[i].settings);
        ck_assert_int_eq(variant->method != NULL, i > 0);
        ck_assert_uint_eq(variant->parameters_count, i > 0);
    }
    ck_assert_double_eq(file->variants[1].timeout, 9);
    ck_assert_str_eq(file->variants[1].settings[1], "method.stress_update=usl");
    ck_assert_str_eq(file->variants[1].settings[2], "time.end=2");
    catalogue_free(catalogue);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_method_runs_without_a_check_and_leaves_its_measurements)
{
    char *catalogue = catalogue_with("pass", METHODS, ASKS), *output = test_folder_create();
    char *path = test_folder_path(catalogue, "T/A/case.yaml"), *text = test_file_read(path);
    char **parts = g_strsplit(text, "variants: [\"*\"]", 2);
    char *one = g_strjoinv("variants: [classic_usl]", parts);
    g_free(test_folder_write(catalogue, "T/A/case.yaml", one));
    struct test_said said = test_verify_with(
        "mpm-verify run --variant *_usl --catalogue @ --output @", catalogue, output);
    struct records records;
    struct mpm_error error;
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    ck_assert_str_eq(test_last_line(said.out), "1 passed, 0 failed, 0 skipped");
    ck_assert_int_eq(records_read(output, &records, &error), MPM_OK);
    unsigned found = 0;
    for (size_t i = 0; i < json_array_size(records.measurements); i++) {
        const json_t *line = json_array_get(records.measurements, i);
        if (strcmp(record_text(line, "quantity"), "value") != 0)
            continue;
        ck_assert_str_eq(record_text(line, "variant"), found == 0 ? "classic_usl" : "ugimp_usl");
        ck_assert_str_eq(record_text(line, "unit"), "%");
        ck_assert_double_eq(record_number(line, "value"), 1);
        found++;
    }
    ck_assert_uint_eq(found, 2);
    records_clear(&records);
    test_said_free(&said);
    g_free(one);
    g_strfreev(parts);
    g_free(text);
    g_free(path);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(list_names_methods_as_variants_and_explain_gives_their_titles)
{
    char *catalogue = catalogue_with("pass", METHODS, ASKS);
    struct test_said said = test_verify_with("mpm-verify list --catalogue @", catalogue, NULL);
    ck_assert_msg(strstr(said.out, "only classic_usl ugimp_usl ugimp_musl (full)") != NULL, "%s",
                  said.out);
    test_said_free(&said);
    said =
        test_verify_with("mpm-verify explain --catalogue @ A/value/classic_usl", catalogue, NULL);
    ck_assert_msg(strstr(said.out, "method     first of <all>") != NULL, "%s%s", said.out,
                  said.err);
    test_said_free(&said);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(quantities_without_a_number_say_why)
{
    const struct {
        const char *program, *reason;
    } table[] = {{"spoil", "the program reported nan"}, {"undecided", "ended before breakdown"}};
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *catalogue = catalogue_with(table[i].program, METHODS, ""),
             *output = test_folder_create();
        struct test_said said =
            test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
        struct records records;
        struct mpm_error error;
        ck_assert_int_eq(records_read(output, &records, &error), MPM_OK);
        const json_t *line = json_array_get(records.measurements, 0);
        ck_assert_str_eq(record_text(line, "quantity"), "value");
        ck_assert(json_is_null(json_object_get(line, "value")));
        ck_assert_str_eq(record_text(line, "reason"), table[i].reason);
        records_clear(&records);
        test_said_free(&said);
        test_folder_remove(output);
        test_folder_remove(catalogue);
    }
}
END_TEST

/* The message that the catalogue refuses with; g_free. */
static char *refusal(const char *methods, const char *asks)
{
    char *folder = catalogue_with("pass", methods, asks);
    struct catalogue *catalogue;
    struct mpm_error error = {.message = "accepted"};
    const enum mpm_status status = catalogue_read(folder, test_programs(), &catalogue, &error);
    ck_assert_msg(status == MPM_BAD_INPUT, "%s: %s", asks, error.message);
    ck_assert_ptr_null(catalogue);
    test_folder_remove(folder);
    return g_strdup(error.message);
}

#define ASK(globs) "scene: scene.yaml\nmethods: {names: [" globs "], tier: ci, timeout: 1}\n"

START_TEST(a_case_that_asks_for_methods_that_are_not_is_refused)
{
    const struct {
        const char *methods, *asks, *message;
    } table[] = {
        {METHODS, ASK("\"*_usl\", cpdi_usl"),
         "case.yaml:9: methods: names: \"cpdi_usl\" matches no method of methods.yaml"},
        {NULL, ASK("\"*\""), "the catalogue has no methods.yaml"},
        {METHODS, "methods: {names: [\"*\"], tier: ci, timeout: 1}\n", "the case has none"},
        {METHODS, ASK("\"*\"], except: [nothing"),
         "except: \"nothing\" matches no method of names"},
        {METHODS, ASK("\"ugimp*\"], full: [\"classic*\""), "full: \"classic*\" matches no method"},
        {METHODS, ASK("\"*\"], settings: [speed"), "methods: setting \"speed\": allowed is PATH"},
        {METHODS, ASK("]"), "case.yaml:9"},
        {METHODS, "scene: scene.yaml\nmethods: {names: [\"*\"], tier: ci, timeout: 0}\n",
         "methods: timeout 0: allowed are seconds > 0"},
        {METHODS, "scene: scene.yaml\nmethods: {names: [\"*\"], tier: ci, timeout: soon}\n",
         "methods.timeout: not a number, got \"soon\""},
        {METHODS, "scene: scene.yaml\nmethods: {name: [\"*\"], tier: ci, timeout: 1}\n",
         "case.yaml:9: methods: unknown key \"name\"; allowed: names, except"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *message = refusal(table[i].methods, table[i].asks);
        ck_assert_msg(strstr(message, table[i].message) != NULL, "row %zu: %s", i, message);
        g_free(message);
    }
}
END_TEST

START_TEST(a_bad_table_of_methods_is_refused_with_its_line)
{
    const struct {
        const char *from, *to, *message;
    } table[] = {
        {"format: 1", "format: 2",
         "methods.yaml:1: format: out of range, got \"2\"; allowed: integer 1"},
        {"name: ugimp_usl", "name: classic_usl",
         "methods.yaml:4: methods.1: name \"classic_usl\" is taken by another method"},
        {"name: ugimp_usl", "name: ug/imp", "methods.1: name \"ug/imp\": allowed are 1 to 64"},
        {"method.radius_update=hoop", "hoop", "methods.3: setting \"hoop\": allowed is PATH=VALUE"},
        {"title: fourth, settings: [",
         "title: fourth, settings: [\"method.shape=ugimp\", "
         "\"method.stress_update=usl\"]}\n  - {name: x, group: g, "
         "title: t, settings: [",
         "\"ugimp_hoop\" has the settings of \"ugimp_usl\""},
        {"methods:", "parts:\n  - {part: ugimp, kind: shape, title: t}\nmethods:",
         "parts does not explain \"classic\""},
        {"group: axis", "grp: axis",
         "methods.yaml:6: methods.3: unknown key \"grp\"; allowed: name, group"},
        {"name: ugimp_musl", "name: only",
         "\"only\" is the name of a variant, too: name it in except"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char **parts = g_strsplit(METHODS, table[i].from, 2);
        ck_assert_msg(g_strv_length(parts) == 2, "row %zu changes nothing", i);
        char *methods = g_strjoinv(table[i].to, parts);
        char *message = refusal(methods, ASK("\"*\""));
        ck_assert_msg(strstr(message, table[i].message) != NULL, "row %zu: %s", i, message);
        g_free(message);
        g_free(methods);
        g_strfreev(parts);
    }
}
END_TEST

START_TEST(a_method_that_the_scene_refuses_ends_the_run_before_it_starts)
{
    char *catalogue = catalogue_with("pass", METHODS, ASK("\"*\"")), *output = test_folder_create();
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 2);
    ck_assert_msg(strstr(said.err, "case A: the scene refuses method ugimp_hoop: ") != NULL, "%s",
                  said.err);
    ck_assert_ptr_nonnull(strstr(said.err, "radius_update"));
    char *written = test_folder_path(output, "cases");
    ck_assert(!test_file_exists(written));
    g_free(written);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

Suite *suite_methods(void)
{
    Suite *suite = suite_create("methods");
    TCase *cases = tcase_create("methods");
    tcase_add_test(cases, methods_become_variants_of_their_names_in_the_order_of_the_table);
    tcase_add_test(cases, a_method_runs_without_a_check_and_leaves_its_measurements);
    tcase_add_test(cases, list_names_methods_as_variants_and_explain_gives_their_titles);
    tcase_add_test(cases, quantities_without_a_number_say_why);
    tcase_add_test(cases, a_case_that_asks_for_methods_that_are_not_is_refused);
    tcase_add_test(cases, a_bad_table_of_methods_is_refused_with_its_line);
    tcase_add_test(cases, a_method_that_the_scene_refuses_ends_the_run_before_it_starts);
    suite_add_tcase(suite, cases);
    return suite;
}
