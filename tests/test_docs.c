/* The documentation: its commands run, its links lead to files, man pages and help
 * name the same options, and no check is left without an explanation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/command.h"
#include "support/document.h"
#include "support/folder.h"
#include "support/skip.h"

#include "model/material.h"

#include <glib.h>
#include <string.h>

/* ------------------------------------------------------------------------ tutorial */

/* The command in a line of a tutorial; where the report of a score goes by itself is not ours. */
static struct test_command run_line(const char *line, const char *folder)
{
    char *report = g_strconcat(" --output ", folder, "/report", NULL);
    const bool scores = strstr(line, " score ") != NULL;
    struct test_command command = test_document_run(line, folder, scores ? report : "");
    g_free(report);
    return command;
}

START_TEST(the_tutorial_on_scores_does_what_it_says)
{
    char *python = g_find_program_in_path("python3");
    const bool able = g_getenv("MPM_BIN") != NULL && python != NULL;
    g_free(python);
    if (!able)
        TEST_SKIP("needs MPM_BIN and python3");
    char *folder = test_folder_create(), *text = test_file_read("docs/tutorial-score.md");
    char **lines = g_strsplit(text, "\n", -1), *said = g_strdup("");
    size_t commands = 0, results = 0;
    for (char **line = lines; *line != NULL; line++) {
        if (test_document_command(*line)) {
            struct test_command command = run_line(*line, folder);
            const bool fails =
                strstr(*line, "bar-T4.csv") != NULL && strstr(*line, "score ") != NULL;
            ck_assert_msg(command.exit_status == (fails && strstr(*line, "mpm-verify") != NULL),
                          "%s: %s%s", *line, command.output, command.errors);
            g_free(said);
            said = test_text_squeezed(command.output);
            test_command_free(&command);
            commands++;
        } else if (g_str_has_prefix(*line, "    pass ") || g_str_has_prefix(*line, "    fail ")) {
            char *result = test_text_squeezed(*line);
            ck_assert_msg(strstr(said, result) != NULL, "\"%s\" is not in: %s", result, said);
            g_free(result);
            results++;
        }
    }
    ck_assert_uint_eq(commands, 10);
    ck_assert_uint_eq(results, 7);
    g_free(said);
    g_strfreev(lines);
    g_free(text);
    test_folder_remove(folder);
}
END_TEST

/* The lines of a block that begins with "format: 1" go to the file that the text before names, as
 * in "Save it as `build/bar.yaml`". */
static void save_files(char *const *lines, const char *folder)
{
    char *name = NULL;
    GString *file = NULL;
    size_t files = 0;
    for (char *const *line = lines; *line != NULL; line++) {
        const char *as = strstr(*line, "as `build/");
        if (as != NULL) {
            g_free(name);
            name = g_strndup(as + strlen("as `build/"), strcspn(as + strlen("as `build/"), "`"));
        }
        if (name != NULL && strcmp(*line, "    format: 1") == 0)
            file = g_string_new(NULL);
        if (file != NULL && g_str_has_prefix(*line, "    ")) {
            g_string_append_printf(file, "%s\n", *line + 4);
        } else if (file != NULL) {
            char *path = test_folder_path(folder, name);
            ck_assert(g_file_set_contents(path, file->str, -1, NULL));
            g_free(path);
            g_string_free(file, TRUE);
            file = NULL;
            files++;
        }
    }
    ck_assert_uint_eq(files, 2);
    g_free(name);
}

/* A row of the table of files: "| `study.csv` | ..." */
static void assert_made(const char *row, const char *folder)
{
    char **parts = g_strsplit(row, "`", 3);
    char *name =
        test_text_replaced(g_strconcat("bar/study/", parts[1], NULL), "<measure>", "velocity_x_at");
    char *path = test_folder_path(folder, name);
    ck_assert_msg(g_file_test(path, G_FILE_TEST_EXISTS), "%s", path);
    g_free(path);
    g_free(name);
    g_strfreev(parts);
}

START_TEST(the_tutorial_on_studies_does_what_it_says)
{
    if (g_getenv("MPM_BIN") == NULL)
        TEST_SKIP("needs MPM_BIN");
    char *folder = test_folder_create(), *said = g_strdup("");
    char *text = test_text_replaced(test_file_read("docs/tutorial-study.md"), "\\\n", "");
    char **lines = g_strsplit(text, "\n", -1);
    size_t commands = 0, results = 0;
    save_files(lines, folder);
    for (char **line = lines; *line != NULL; line++) {
        if (test_document_command(*line)) {
            struct test_command command = run_line(*line, folder);
            ck_assert_msg(command.exit_status == 0, "%s: %s%s", *line, command.output,
                          command.errors);
            g_free(said);
            said = command.output;
            g_free(command.errors);
            commands++;
        } else if (g_str_has_prefix(*line, "    method.shape=")) {
            ck_assert_msg(strstr(said, *line + 4) != NULL, "\"%s\" is not in: %s", *line + 4, said);
            results++;
        } else if (g_str_has_prefix(*line, "| `") && results < 10) {
            assert_made(*line, folder);
            results++;
        }
    }
    ck_assert_uint_eq(commands, 3);
    ck_assert_uint_eq(results, 10);
    g_free(said);
    g_strfreev(lines);
    g_free(text);
    test_folder_remove(folder);
}
END_TEST

/* --------------------------------------------------------------------------- links */

static const char *const documents[] = {
    "README.md",
    "CONTRIBUTING.md",
    "docs/campaigns.md",
    "docs/heat.md",
    "docs/library.md",
    "docs/scenes.md",
    "docs/tutorial-case.md",
    "docs/tutorial-material.md",
    "docs/tutorial-score.md",
    "docs/tutorial-study.md",
    "docs/tutorial-variant.md",
    "docs/walkthroughs/README.md",
    "docs/walkthroughs/bar-on-wall.md",
    "docs/walkthroughs/basics.md",
    "docs/walkthroughs/edge-crack.md",
    "docs/walkthroughs/heated-cylinder.md",
    "docs/walkthroughs/rod-on-plate.md",
    "docs/walkthroughs/two-disks.md",
};

START_TEST(links_of_the_documents_lead_to_files)
{
    char *text = test_file_read(documents[_i]), *folder = g_path_get_dirname(documents[_i]);
    for (const char *at = text; (at = strstr(at, "](")) != NULL; at++) {
        char *target = g_strndup(at + 2, strcspn(at + 2, ")#"));
        char *path = g_build_filename(folder, target, NULL);
        if (*target != '\0' && strstr(target, "://") == NULL)
            ck_assert_msg(test_file_exists(path), "%s: %s", documents[_i], target);
        g_free(path);
        g_free(target);
    }
    g_free(folder);
    g_free(text);
}
END_TEST

/* ----------------------------------------------------------------------- man pages */

/* Adds every option "--word" of a text. */
static void add_options(GHashTable *options, const char *text)
{
    for (const char *at = text; (at = strstr(at, "--")) != NULL; at += 2) {
        const size_t length = strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-");
        if (length > 0 && (at == text || strchr(" [(\n,'\"", at[-1]) != NULL))
            g_hash_table_add(options, g_strndup(at, length + 2));
        at += length;
    }
}

static void assert_all_in(GHashTable *some, GHashTable *others, const char *program,
                          const char *where)
{
    GHashTableIter options;
    void *option;
    g_hash_table_iter_init(&options, some);
    while (g_hash_table_iter_next(&options, &option, NULL))
        ck_assert_msg(g_hash_table_contains(others, option), "%s: %s is not in both: %s", program,
                      (char *)option, where);
}

static char *help_of(const char *program, const char *command)
{
    struct test_command help = test_command_run(program, "help", command, NULL);
    ck_assert_int_eq(help.exit_status, 0);
    char *text = g_strdup(help.output);
    test_command_free(&help);
    return text;
}

static GHashTable *options_of(const char *text)
{
    GHashTable *options = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    add_options(options, text);
    g_hash_table_remove(options, "--help");
    return options;
}

/* The commands that a program's help lists. */
static GPtrArray *commands_of(const char *help)
{
    GPtrArray *commands = g_ptr_array_new_with_free_func(g_free);
    char **lines = g_strsplit(strstr(help, "\nCommands:\n") + strlen("\nCommands:\n"), "\n", -1);
    for (char **line = lines; **line != '\0'; line++)
        if (g_str_has_prefix(*line, "  ") && (*line)[2] != ' ')
            g_ptr_array_add(commands, g_strndup(*line + 2, strcspn(*line + 2, " ")));
    g_strfreev(lines);
    return commands;
}

/* The synopsis of a command; g_free. */
static char *synopsis_of(const char *page, const char *program, const char *command)
{
    char *head = g_strdup_printf("\n.B %s %s\n", program, command);
    char *other = g_strdup_printf("\n.B %s %s ", program, command);
    const char *start = strstr(page, head) != NULL ? strstr(page, head) : strstr(page, other);
    ck_assert_msg(start != NULL, "%s: no synopsis of %s", program, command);
    const char *end = strstr(start, "\n.SH"), *next = strstr(start, "\n.br\n");
    g_free(other);
    g_free(head);
    return g_strndup(start, (size_t)((next != NULL && next < end ? next : end) - start));
}

static void check_command(const char *page, const char *program, const char *command,
                          GHashTable *all)
{
    char *entry = g_strdup_printf("\n.TP\n.B %s\n", command);
    char *synopsis = synopsis_of(page, program, command);
    char *help = strcmp(command, "help") == 0 ? g_strdup("") : help_of(program, command);
    char *start = strstr(help, "\nOptions:\n");
    char *end = start != NULL ? strstr(start, "\n  -h, --help") : NULL;
    char *listed = start != NULL ? g_strndup(start, (size_t)(end - start)) : g_strdup("");
    GHashTable *in_help = options_of(listed), *in_synopsis = options_of(synopsis);
    ck_assert_msg(strstr(page, entry) != NULL, "%s: %s", program, command);
    assert_all_in(in_help, in_synopsis, program, command);
    assert_all_in(in_synopsis, in_help, program, command);
    add_options(all, help);
    g_hash_table_unref(in_synopsis);
    g_hash_table_unref(in_help);
    g_free(listed);
    g_free(help);
    g_free(synopsis);
    g_free(entry);
}

START_TEST(man_pages_have_the_options_and_commands_of_the_help)
{
    static const char *const programs[][2] = {{"mpm", "docs/man/mpm.1"},
                                              {"mpm-verify", "docs/man/mpm-verify.1"},
                                              {"mpm-bench", "docs/man/mpm-bench.1"}};
    const char *const program = programs[_i][0];
    char *page = test_text_replaced(test_file_read(programs[_i][1]), "\\-", "-");
    char *help = help_of(program, NULL);
    GHashTable *in_help = options_of(help), *in_page = options_of(page);
    GPtrArray *commands = commands_of(help);
    ck_assert_uint_ge(commands->len, 5);
    for (unsigned c = 0; c < commands->len; c++)
        check_command(page, program, commands->pdata[c], in_help);
    g_hash_table_remove(in_help, "--help");
    assert_all_in(in_help, in_page, program, "man page");
    assert_all_in(in_page, in_help, program, "help");
    g_ptr_array_unref(commands);
    g_hash_table_unref(in_page);
    g_hash_table_unref(in_help);
    g_free(help);
    g_free(page);
}
END_TEST

/* No line is cut by a terminal of the usual width. */
START_TEST(help_has_lines_of_80_characters)
{
    static const char *const programs[] = {"mpm", "mpm-verify", "mpm-bench"};
    char *help = help_of(programs[_i], NULL);
    GPtrArray *commands = commands_of(help);
    for (unsigned c = 0; c <= commands->len; c++) {
        const char *command = c < commands->len ? commands->pdata[c] : "help";
        char *text = strcmp(command, "help") == 0 ? g_strdup(help) : help_of(programs[_i], command);
        char **lines = g_strsplit(text, "\n", -1);
        for (char **line = lines; *line != NULL; line++)
            ck_assert_msg(g_utf8_strlen(*line, -1) <= 80, "%s %s: %s", programs[_i], command,
                          *line);
        g_strfreev(lines);
        g_free(text);
    }
    g_ptr_array_unref(commands);
    g_free(help);
}
END_TEST

/* ---------------------------------------------------------------------- hosted CI */

static const char records[] =
    "{\"kind\":\"run\"}\n"
    "{\"kind\":\"check\",\"family\":\"R\",\"case\":\"R1\",\"check\":\"j\",\"variant\":\"a\","
    "\"quantity\":\"J\",\"value\":2.5,\"low\":0,\"high\":1,\"status\":\"fail\",\"reason\":\"\","
    "\"title\":\"50 %\\nof it\"}\n"
    "{\"kind\":\"check\",\"family\":\"R\",\"case\":\"R1\",\"check\":\"k\",\"variant\":\"a\","
    "\"quantity\":\"K\",\"value\":null,\"low\":0,\"high\":1,\"status\":\"timeout\","
    "\"reason\":\"::late\",\"title\":\"k\"}\n"
    "{\"kind\":\"check\",\"status\":\"pass\"}\n{\"kind\":\"check\",\"status\":\"expected-fail\"}\n";

START_TEST(checks_that_fail_are_annotated_at_their_cases)
{
    char *const folder = test_folder_create();
    g_free(test_folder_write(folder, "checks.jsonl", records));
    struct test_command command = test_command_run(".ci/annotate", folder, NULL);
    ck_assert_str_eq(command.output,
                     "::error file=verification/catalogue/R/R1/case.yaml,title=R1/j a%3A fail::"
                     "J: 2.5 is not within 0 to 1 (50 %25%0Aof it)\n"
                     "::error file=verification/catalogue/R/R1/case.yaml,title=R1/k a%3A timeout::"
                     "K: ::late (k)\n");
    test_command_free(&command);
    command = test_command_run(".ci/annotate", folder, "1", NULL);
    ck_assert_ptr_nonnull(strstr(command.output, "::error title=more::1 more checks failed"));
    test_command_free(&command);
    test_folder_remove(folder);
}
END_TEST

/* ---------------------------------------------------------------------------- laws */

START_TEST(the_document_on_scenes_has_a_row_for_each_law)
{
    const struct mpm_material_law *law;
    char *text = test_file_read("docs/scenes.md");
    for (size_t k = 0; (law = mpm_material_law_at(k)) != NULL; k++) {
        GString *row = g_string_new(NULL);
        g_string_printf(row, "\n| `%s` | ", law->name);
        for (size_t i = 0; i < law->parameter_count; i++)
            g_string_append_printf(row, "%s`%s`", i > 0 ? ", " : "",
                                   mpm_parameter_key(law->parameters[i].which));
        g_string_append(row, " | ");
        ck_assert_msg(strstr(text, row->str) != NULL, "no row%s", row->str);
        g_string_free(row, TRUE);
    }
    g_free(text);
}
END_TEST

/* ------------------------------------------------------------------------- explain */

START_TEST(every_check_of_the_catalogue_is_explained_whole)
{
    static const char *const labels[] = {"  quantity   ", "  expected   ", "  band       ",
                                         "  why        ", "  evidence   ", "  reproduce  "};
    struct test_command explain = test_command_run("mpm-verify", "explain", "*", NULL);
    ck_assert_msg(explain.exit_status == 0, "%s", explain.errors);
    char **lines = g_strsplit(explain.output, "\n", -1);
    size_t checks = 0, cases = 0, problems = 0, references = 0, criteria = 0,
           full[G_N_ELEMENTS(labels)] = {0};
    for (char **line = lines; *line != NULL; line++) {
        cases += g_str_has_prefix(*line, "# ") ? 1 : 0;
        problems += g_str_has_prefix(*line, "## Problem") ? 1 : 0;
        references += g_regex_match_simple("^## .*([Rr]eference|[Ss]ource)", *line, 0, 0) ? 1 : 0;
        criteria += g_regex_match_simple("^## .*[Cc]riteri", *line, 0, 0) ? 1 : 0;
        /* "CASE/CHECK: title" before its quantity */
        for (size_t i = 0; i < G_N_ELEMENTS(labels); i++)
            if (g_str_has_prefix(*line, labels[i])) {
                ck_assert_msg(strlen(*line) > strlen(labels[i]), "%s", *line);
                full[i]++;
            }
        if (g_regex_match_simple("^[A-Za-z0-9_-]+/[A-Za-z0-9_/-]+: .", *line, 0, 0))
            checks++;
    }
    ck_assert_uint_gt(checks, 400);
    for (size_t i = 0; i < G_N_ELEMENTS(labels); i++)
        ck_assert_msg(full[i] == checks, "\"%s\" %zu times for %zu checks", labels[i], full[i],
                      checks);
    ck_assert_uint_gt(cases, 30);
    ck_assert_uint_ge(problems, cases);
    ck_assert_uint_ge(references, cases);
    ck_assert_uint_ge(criteria, cases);
    g_strfreev(lines);
    test_command_free(&explain);
}
END_TEST

/* The longest one of all: 24 lines of 80 characters, but for the command to be pasted. */
START_TEST(a_check_is_explained_in_a_screen)
{
    enum { SCREEN = 24 };
    struct test_command explain = test_command_run("mpm-verify", "explain", "*/*", NULL);
    ck_assert_msg(explain.exit_status == 0, "%s", explain.errors);
    char **blocks = g_strsplit(explain.output, "\n\n", -1);
    size_t long_ones = 0;
    for (char **block = blocks; *block != NULL; block++) {
        char **lines = g_strsplit(g_strchomp(*block), "\n", -1);
        for (char **line = lines; *line != NULL; line++)
            ck_assert_msg(g_utf8_strlen(*line, -1) <= 80 || strstr(*line, "  reproduce  ") != NULL,
                          "%s", *line);
        long_ones += g_strv_length(lines) > SCREEN;
        g_strfreev(lines);
    }
    ck_assert_uint_gt(g_strv_length(blocks), 400);
    ck_assert_uint_eq(long_ones, 0);
    g_strfreev(blocks);
    test_command_free(&explain);
}
END_TEST

Suite *suite_docs(void)
{
    Suite *suite = suite_create("docs");
    TCase *docs = tcase_create("docs");
    tcase_add_test(docs, checks_that_fail_are_annotated_at_their_cases);
    tcase_add_test(docs, the_document_on_scenes_has_a_row_for_each_law);
    tcase_add_test(docs, the_tutorial_on_scores_does_what_it_says);
    tcase_add_test(docs, the_tutorial_on_studies_does_what_it_says);
    tcase_add_loop_test(docs, links_of_the_documents_lead_to_files, 0,
                        (int)G_N_ELEMENTS(documents));
    tcase_add_loop_test(docs, man_pages_have_the_options_and_commands_of_the_help, 0, 3);
    tcase_add_loop_test(docs, help_has_lines_of_80_characters, 0, 3);
    tcase_add_test(docs, a_check_is_explained_in_a_screen);
    tcase_add_test(docs, every_check_of_the_catalogue_is_explained_whole);
    tcase_set_timeout(docs, 120);
    suite_add_tcase(suite, docs);
    return suite;
}
