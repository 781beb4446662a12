/* Headings of the case pages: the same everywhere, in one order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/command.h"
#include "support/folder.h"

#include <glib.h>
#include <string.h>

static const char *const after_criterion[] = {"What it shows", "For other solvers",
                                              "What is not so good", "Planted bugs",
                                              "Details of the scene"};

/* The place of a heading after the criterion's; the number of them if it is none. */
static size_t place_of_heading(const char *heading)
{
    size_t place = 0;
    while (place < G_N_ELEMENTS(after_criterion) && strcmp(after_criterion[place], heading) != 0)
        place++;
    return place;
}

static void assert_headings(const char *path)
{
    static const char *const first[] = {"Problem", "Source and reference", "Criterion"};
    char *text = test_file_read(path), **lines = g_strsplit(text, "\n", -1);
    size_t met = 0, next = 0;
    for (char **line = lines; *line != NULL; line++) {
        if (!g_str_has_prefix(*line, "## "))
            continue;
        if (met < G_N_ELEMENTS(first)) {
            const bool is_next = strcmp(*line + 3, first[met]) == 0;
            ck_assert_msg(is_next || met == 2, "%s: \"%s\" comes before \"%s\"", path, *line + 3,
                          first[met]);
            met += is_next ? 1 : 0;
            continue;
        }
        const size_t place = place_of_heading(*line + 3);
        ck_assert_msg(place >= next && place < G_N_ELEMENTS(after_criterion),
                      "%s: \"%s\" is none of the headings after the criterion, or not in order",
                      path, *line + 3);
        next = place + 1;
    }
    ck_assert_msg(met == G_N_ELEMENTS(first), "%s: no \"%s\"", path, first[MIN(met, 2)]);
    const char *const heading = "\n## Problem\n\n", *const problem = strstr(text, heading);
    ck_assert_msg(problem != NULL, "%s: no empty line after \"Problem\"", path);
    const char *const begin = problem + strlen(heading);
    char *question = g_strndup(begin, strcspn(begin, "?"));
    ck_assert_msg(strstr(question, "\n\n") == NULL, "%s: the problem begins with no question",
                  path);
    g_free(question);
    const char *const answer = strstr(problem, "\n\n**The answer.** ");
    ck_assert_msg(answer != NULL && answer < strstr(begin, "\n## "),
                  "%s: the problem has no answer, a paragraph with \"**The answer.**\"", path);
    g_strfreev(lines);
    g_free(text);
}

START_TEST(every_case_has_the_same_headings)
{
    struct test_command list =
        test_command_run("/bin/sh", "-c", "ls verification/catalogue/*/*/README.md", NULL);
    char **paths = g_strsplit(g_strstrip(list.output), "\n", -1);
    ck_assert_uint_gt(g_strv_length(paths), 90);
    for (char **path = paths; *path != NULL; path++)
        assert_headings(*path);
    g_strfreev(paths);
    test_command_free(&list);
}
END_TEST

Suite *suite_headings(void)
{
    Suite *suite = suite_create("headings");
    TCase *headings = tcase_create("headings");
    tcase_add_test(headings, every_case_has_the_same_headings);
    suite_add_tcase(suite, headings);
    return suite;
}
