/* The catalogue: what is read, and what is refused with which message.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/command.h"
#include "support/folder.h"

#include "verification/cases/catalogue.h"
#include "verification/suite/plan.h"

#include <glib.h>
#include <string.h>

START_TEST(a_case_is_read_as_declared)
{
    char *folder = test_folder_create();
    test_case_write_quadrature(folder);
    struct catalogue *catalogue;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(catalogue_read(folder, test_programs(), &catalogue, &error) == MPM_OK, "%s",
                  error.message);
    ck_assert_uint_eq(catalogue->count, 1);
    const struct case_file *file = catalogue->cases[0].file;
    ck_assert_str_eq(file->name, "Q");
    ck_assert_uint_eq(file->variants_count, 3);
    ck_assert_int_eq(file->variants[2].tier, TIER_FULL);
    ck_assert_double_eq(file->variants[0].timeout, 20);
    ck_assert_double_eq(file->checks[1].band.fails_low, 0.99);
    ck_assert(file->checks[1].band.weakness);
    catalogue_free(catalogue);
    test_folder_remove(folder);
}
END_TEST

START_TEST(the_plan_owes_every_check_of_every_variant_of_the_size)
{
    const struct {
        struct plan_selection selection;
        size_t jobs, checks; /* 0: refused */
    } table[] = {
        {{.tier = TIER_CI}, 2, 2},
        {{.tier = TIER_FULL}, 3, 3},
        {{.tier = TIER_FULL, .case_globs = "Q", .variant_globs = "f*"}, 1, 1},
        {{.tier = TIER_FULL, .case_globs = "[P-R]", .variant_globs = "?????"}, 2, 2},
        {{.tier = TIER_CI, .variant_globs = "fine"}, 0, 0},
        {{.tier = TIER_FULL, .case_globs = "X"}, 0, 0},
        {{.tier = TIER_FULL, .case_globs = "Q,X"}, 0, 0},
        {{.tier = TIER_FULL, .variant_globs = "f*,X"}, 0, 0},
        {{.tier = TIER_FULL, .case_globs = "[X-Z]*,Q"}, 0, 0},
        {{.tier = TIER_FULL, .case_globs = "Q*,Q", .variant_globs = "f*,cubi?"}, 2, 2},
    };
    char *folder = test_folder_create();
    test_case_write_quadrature(folder);
    struct catalogue *catalogue;
    struct mpm_error error;
    ck_assert_int_eq(catalogue_read(folder, test_programs(), &catalogue, &error), MPM_OK);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct plan plan;
        const enum mpm_status status = plan_make(catalogue, &table[i].selection, &plan, &error);
        ck_assert_int_eq(status, table[i].checks == 0 ? MPM_BAD_INPUT : MPM_OK);
        ck_assert_uint_eq(plan.job_count, table[i].jobs);
        ck_assert_uint_eq(plan.check_count, table[i].checks);
        plan_clear(&plan);
    }
    catalogue_free(catalogue);
    test_folder_remove(folder);
}
END_TEST

/* The message that the catalogue refuses this text of case A with; g_free. */
static char *refusal(const char *text)
{
    char *folder = test_folder_create();
    test_case_write(folder, "A", text);
    struct catalogue *catalogue;
    struct mpm_error error = {.message = "accepted"};
    const enum mpm_status status = catalogue_read(folder, test_programs(), &catalogue, &error);
    ck_assert_msg(status == MPM_BAD_INPUT, "%s:\n%s", error.message, text);
    ck_assert_ptr_null(catalogue);
    test_folder_remove(folder);
    return g_strdup(error.message);
}

static const struct {
    const char *from, *to; /* a change to the good text */
    const char *message;   /* part of the refusal */
} refusals[] = {
    {"format: 1", "format: 2", "case.yaml:1: format: out of range, got \"2\"; allowed: integer 1"},
    {"format: 1", "format: one",
     "case.yaml:1: format: not an integer, got \"one\"; allowed: integer 1"},
    {"format: 1\n", "", "case.yaml:1: format: missing, the key is required"},
    {"family: T", "family: U", "must be the folder's: T/A"},
    {"case: A", "case: B", "must be the folder's: T/A"},
    {"case: A", "case: ../A", "case.yaml:3: case"},
    {"tags: [small]", "tog: [small]",
     "case.yaml:6: unknown key \"tog\"; allowed: format, family, case"},
    {"tags: [small]", "title: again", "case.yaml:6: key \"title\" repeated, first on line 4"},
    {"tags: [small]", "tags: &all [small]", "case.yaml:6: an anchor (&name)"},
    {"tags: [small]", "tags: !!seq [small]", "case.yaml:6: a tag (!name)"},
    {"tags: [small]", "tags: [sm\xffll]", "case.yaml:6: not a text: byte"},
    {"tags: [small]", "tags: [\"sm\\0ll\"]", "case.yaml:6: a null character in a text"},
    {"tags: [small]", "tags:\n\t- small",
     "case.yaml:7: not YAML: found character that cannot start"},
    {"tags: [small]", "tags: [~]", "case.yaml:6: tags.0: no text, got \"~\""},
    {"tags: [small]", "tags: small", "case.yaml:6: tags: not a list, got \"small\""},
    {"why: it is <one> & only\n", "why: w\n---\nformat: 1\n",
     "case.yaml:25: a second YAML document"},
    {"format: 1", "format: 0x1", "case.yaml:1: format: not an integer, got \"0x1\""},
    {"low: 0.5", "low: \"0.5\"", "case.yaml:20: checks.0.low: not a number, got \"0.5\""},
    {"program: pass", "program: pss", "case.yaml:7: program: \"pss\": allowed are quadrature"},
    {"program: pass", "program: pass\nscene: none.yaml",
     "case.yaml:8: scene: \"none.yaml\": no such"},
    {"{name: speed, value: 1}", "{name: speed, value: 1}\n  - {name: speed, value: 2}",
     "parameter \"speed\" is given twice"},
    {"tier: ci", "tier: fast", "case.yaml:11: variants.0.tier: unknown choice, got \"fast\""},
    {"timeout: 0.5", "timeout: 0", "case.yaml:11: variants.0: timeout 0: allowed are seconds > 0"},
    {"timeout: 0.5", "timeout: 5 s", "case.yaml:11: variants.0.timeout: not a number, got \"5 s\""},
    {"timeout: 0.5", "timeout: 1, settings: [\"a=1\"]", "has no scene"},
    {"tier: ci, timeout: 0.5}", "tier: ci, timeout: 1}\n  - {name: only, tier: ci, timeout: 1}",
     "case.yaml:12: variants.1: name \"only\" is taken"},
    {"name: only", "name: on/ly", "allowed are 1 to 64 letters"},
    {"variants: [only]", "variants: [\"nly*\"]",
     "case.yaml:13: checks.0: \"nly*\" matches no variant"},
    {"variants: [only]", "variants: []", "case.yaml:15: checks.0.variants: empty"},
    {"low: 0.5", "low: 0", "case.yaml:13: checks.0: check \"value\": the band holds zero"},
    {"low: 0.5", "low: -1", "holds zero"},
    {"low: 0.5", "low: 3", "low must be less than high"},
    {"low: 0.5", "low: nan", "case.yaml:20: checks.0.low: not a number, got \"nan\""},
    {"high: 2", "high: .inf", "not a number, got \".inf\""},
    {"high: 2", "high: 2 %", "not a number, got \"2 %\""},
    {"high: 2", "high: 0x2", "not a number, got \"0x2\""},
    {"expected: 1", "expected: 9", "expected must lie"},
    {"expected: 1", "expected: [1]", "case.yaml:19: checks.0.expected: not a single value"},
    {"basis: theory", "basis: hope", "case.yaml:22: checks.0.basis: unknown choice"},
    {"basis: theory", "basis: independent calculation", "calculation: is missing"},
    {"program: ", "calculation: c\nprogram: ", "no band has the basis"},
    {"basis: theory", "basis: theory\n    outcome: fail", "needs both"},
    {"basis: theory", "basis: theory\n    fails_low: 3\n    fails_high: 4", "needs both"},
    {"basis: theory", "basis: theory\n    outcome: fail\n    fails_low: -1\n    fails_high: 0.1",
     "weakness holds zero"},
    {"basis: theory", "basis: theory\n    initial: 1", "initial value"},
    {"    unit: \"%\"\n", "", "checks.0.unit: missing, the key is required"},
    {"checks:\n",
     "checks:\n  - {check: value, title: t, variants: [\"*\"], quantity: q, unit: m, norm: n, "
     "expected: 1, low: 0.5, high: 2, basis: measured, why: w}\n",
     "case.yaml:14: checks.1: check \"value\" is declared twice for variant \"only\""},
    {"why: it is <one> & only\n",
     "why: w\nfigures:\n  - {name: f, script: no.gp, title: t, caption: c, reference: r}\n",
     "case.yaml:25: figures.0: script \"no.gp\": no such file"},
    {"why: it is <one> & only\n",
     "why: w\nfigures:\n  - {name: f, script: ../x.gp, title: t, caption: c, reference: r}\n",
     "allowed is a file *.gp beside case.yaml"},
    {"title: the value", "title: [the", "case.yaml:"},
#define BUNDLE(to, within)                                                                         \
    "why: w\nbundle:\n  {reference: r, about: a, from: [0, 0], to: [" to                           \
    "], points: [2, 1], end: 1, instants: 1, criteria: [{criterion: c, title: t, columns: [x], "   \
    "norm: l2, within: " within ", why: w}]}\n"
    {"why: it is <one> & only\n", BUNDLE("1, 1", "5"),
     "case.yaml:24: bundle: states the case's scene"},
    {"why: it is <one> & only\n", BUNDLE("1", "5"),
     "case.yaml:25: bundle.to: not a pair of values, got a list of 1"},
    {"why: it is <one> & only\n", BUNDLE("1, 1], polar: [maybe", "5"),
     "case.yaml:25: bundle.polar: not a single value"},
    {"why: it is <one> & only\n", BUNDLE("1, 1], polar: maybe, linear: [", "5"),
     "case.yaml:25: bundle.polar: not a boolean, got \"maybe\"; allowed: true | false"},
    {"why: it is <one> & only\n", BUNDLE("1, q", "5"), "bundle.to.1: not a number, got \"q\""},
    {"why: it is <one> & only\n", BUNDLE("1, 1", "5 %"),
     "bundle.criteria.0.within: not a number, got \"5 %\""},
    {"why: it is <one> & only\n", BUNDLE("1, 1", "5") "no_bundle: n\n",
     "case.yaml:26: no_bundle: there is a bundle"},
#define NUMBER(low)                                                                                \
    "{number: n, title: t, quantity: q, unit: m, expected: 1, low: " low                           \
    ", high: 2, basis: theory, why: w}"
#define NUMBERS(file, numbers)                                                                     \
    "why: w\nbundle_of_numbers:\n  {about: a, files: [" file "], list: [" numbers "]}\n"
    {"why: it is <one> & only\n", NUMBERS("f", NUMBER("0.5")),
     "case.yaml:24: bundle_of_numbers: states the case's scene"},
    {"why: it is <one> & only\n", NUMBERS("/f", NUMBER("0.5")),
     "file \"/f\": allowed is one within reference_data"},
    {"why: it is <one> & only\n", NUMBERS("a..b.csv", NUMBER("0.5")),
     "case.yaml:24: bundle_of_numbers: states the case's scene"},
    {"why: it is <one> & only\n", NUMBERS("a/../../f", NUMBER("0.5")),
     "file \"a/../../f\": allowed is one within reference_data"},
    {"why: it is <one> & only\n", NUMBERS("f", NUMBER("q")),
     "bundle_of_numbers.list.0.low: not a number, got \"q\""},
    {"why: it is <one> & only\n", NUMBERS("f", NUMBER("-0.5")),
     "bundle_of_numbers.list.0: number \"n\": the band holds zero"},
    {"why: it is <one> & only\n", NUMBERS("f", NUMBER("0.5") ", " NUMBER("0.5")),
     "bundle_of_numbers.list.1: number \"n\" is there twice"},
    {"why: it is <one> & only\n", NUMBERS("f", NUMBER("0.5")) "no_bundle: n\n",
     "bundle_of_numbers: there is a no_bundle as well"},
};

START_TEST(a_bad_case_is_refused_with_file_line_and_reason)
{
    char *good = test_case_text("A", "pass");
    for (size_t i = 0; i < G_N_ELEMENTS(refusals); i++) {
        char **parts = g_strsplit(good, refusals[i].from, 2);
        ck_assert_msg(g_strv_length(parts) == 2, "row %zu changes nothing", i);
        char *text = g_strconcat(parts[0], refusals[i].to, parts[1], NULL);
        char *message = refusal(text);
        ck_assert_msg(strstr(message, refusals[i].message) != NULL, "row %zu: %s", i, message);
        g_free(message);
        g_free(text);
        g_strfreev(parts);
    }
    g_free(good);
    char *message = refusal("");
    ck_assert_ptr_nonnull(strstr(message, "case.yaml:1: empty; allowed: a YAML document"));
    g_free(message);
}
END_TEST

START_TEST(a_folder_without_cases_or_without_a_readme_is_refused)
{
    char *folder = test_folder_create();
    struct catalogue *catalogue;
    struct mpm_error error;
    ck_assert_int_eq(catalogue_read(folder, test_programs(), &catalogue, &error), MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "holds no case"));
    char *text = test_case_text("A", "pass");
    test_case_write(folder, "A", text);
    g_free(test_folder_write(folder, "T/A/README.md", ""));
    ck_assert_int_eq(catalogue_read(folder, test_programs(), &catalogue, &error), MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "README.md"));
    char *none = test_folder_path(folder, "none");
    ck_assert_int_eq(catalogue_read(none, test_programs(), &catalogue, &error), MPM_BAD_INPUT);
    g_free(none);
    g_free(text);
    test_folder_remove(folder);
}
END_TEST

START_TEST(the_catalogue_of_this_tree_is_sound)
{
    struct test_command list = test_command_run("mpm-verify", "list", NULL);
    ck_assert_msg(list.exit_status == 0, "%s", list.errors);
    ck_assert_ptr_nonnull(strstr(list.output, "R1b"));
    test_command_free(&list);
}
END_TEST

/* Whoever reads the page of one case finds the same in any other at the same place. */
START_TEST(every_text_of_a_case_has_the_same_headings)
{
    static const char *const headings[] = {"\n## Problem\n", "\n## Source and reference\n",
                                           "\n## Criterion\n"};
    struct catalogue *own = NULL;
    struct mpm_error error = {.status = MPM_OK};
    ck_assert_msg(catalogue_read("verification/catalogue", programs_all(), &own, &error) == MPM_OK,
                  "%s", error.message);
    for (size_t i = 0; i < own->count; i++) {
        const char *rest = strstr(own->cases[i].readme, "\n## ");
        for (size_t k = 0; k < G_N_ELEMENTS(headings); k++) {
            const char *found = rest == NULL ? NULL : strstr(rest, headings[k]);
            ck_assert_msg(found != NULL && (k > 0 || found == rest), "%s: no%s in its place",
                          own->cases[i].file->name, headings[k]);
            rest = found;
        }
    }
    catalogue_free(own);
}
END_TEST

START_TEST(the_programs_of_the_suite_have_names_of_their_own)
{
    const struct program_table table = programs_all();
    for (size_t i = 0; i < table.count; i++) {
        ck_assert_ptr_eq(programs_find(table, table.programs[i]->name), table.programs[i]);
        ck_assert_uint_gt(strlen(table.programs[i]->summary), 0);
    }
    ck_assert_ptr_null(programs_find(table, "no such program"));
}
END_TEST

Suite *suite_catalogue(void)
{
    Suite *suite = suite_create("catalogue");
    TCase *cases = tcase_create("cases");
    tcase_add_test(cases, a_case_is_read_as_declared);
    tcase_add_test(cases, the_plan_owes_every_check_of_every_variant_of_the_size);
    tcase_add_test(cases, a_bad_case_is_refused_with_file_line_and_reason);
    tcase_add_test(cases, a_folder_without_cases_or_without_a_readme_is_refused);
    tcase_add_test(cases, the_catalogue_of_this_tree_is_sound);
    tcase_add_test(cases, every_text_of_a_case_has_the_same_headings);
    tcase_add_test(cases, the_programs_of_the_suite_have_names_of_their_own);
    suite_add_tcase(suite, cases);
    return suite;
}
