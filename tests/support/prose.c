/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/prose.h"

#include "support/folder.h"

#include "solver/mpm_expression.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char NUMBER[] = "(?<![\\w.])\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?(?!\\w)( %)?";

struct page {
    char *prose; /* without code and targets of links */
    char *shown; /* output, comparisons, quotes, and the scene */
};

bool test_number_rounds(const char *written, double value)
{
    const char *const point = strchr(written, '.'), *const power = strchr(written, 'e');
    const size_t length = strspn(written, "0123456789.");
    int decimals = point == NULL ? 0 : (int)(written + length - point) - 1;
    if (point == NULL && length > 3) /* 5190 has three digits */
        for (const char *digit = written + length - 1; *digit == '0'; digit--)
            decimals--;
    const double unit =
        pow(10.0, (power == NULL ? 0 : (int)strtol(power + 1, NULL, 10)) - decimals);
    return fabs(fabs(value) - strtod(written, NULL)) <= 0.5 * unit * (1.0 + 1e-9);
}

static char *without(char *text, const char *pattern)
{
    GRegex *regex = g_regex_new(pattern, 0, 0, NULL);
    char *rest = g_regex_replace_literal(regex, text, -1, 0, " ", 0, NULL);
    g_regex_unref(regex);
    g_free(text);
    return rest;
}

static struct page page_read(const char *folder, const char *name)
{
    char *path = g_strdup_printf("%s/%s.md", folder, name), *text = test_file_read(path);
    char *scene = g_strdup_printf("%s/%s.yaml", folder, name);
    GString *prose = g_string_new(NULL), *shown = g_string_new(NULL);
    char **lines = g_strsplit(text, "\n", -1);
    bool quoted = false, compared = false;
    for (char **line = lines; *line != NULL; line++) {
        if (g_str_has_prefix(*line, "## "))
            compared = strcmp(*line, "## Compared with theory") == 0;
        const bool fence = g_str_has_prefix(*line, "```");
        quoted = quoted != fence;
        const bool is_shown = quoted || fence || g_str_has_prefix(*line, "    ") ||
                              (compared && g_str_has_prefix(*line, "| "));
        g_string_append_printf(is_shown ? shown : prose, "%s\n", *line);
    }
    char *of_scene = test_file_read(scene);
    g_string_append(shown, of_scene);
    g_strfreev(lines);
    g_free(of_scene);
    g_free(scene);
    g_free(text);
    g_free(path);
    return (struct page){without(without(g_string_free(prose, FALSE), "`[^`]*`"), "\\]\\([^)]*\\)"),
                         g_string_free(shown, FALSE)};
}

static void page_clear(struct page *page)
{
    g_free(page->prose);
    g_free(page->shown);
}

/* The numbers of a text; with `percent` those alone that " %" follows, as it does in them. */
static char **numbers(const char *text, bool percent)
{
    GRegex *regex = g_regex_new(NUMBER, 0, 0, NULL);
    GMatchInfo *match = NULL;
    GPtrArray *found = g_ptr_array_new();
    for (g_regex_match(regex, text, 0, &match); g_match_info_matches(match);
         g_match_info_next(match, NULL)) {
        char *number = g_match_info_fetch(match, 0);
        if (percent && !g_str_has_suffix(number, " %"))
            g_free(number);
        else
            g_ptr_array_add(found, number);
    }
    g_match_info_free(match);
    g_regex_unref(regex);
    g_ptr_array_add(found, NULL);
    return (char **)g_ptr_array_free(found, FALSE);
}

static bool is_shown(const struct page *page, const char *number, bool exactly)
{
    char **candidates = numbers(page->shown, g_str_has_suffix(number, " %"));
    bool found = false;
    for (char **candidate = candidates; *candidate != NULL && !found; candidate++) {
        const double value = strtod(*candidate, NULL);
        found = exactly ? value == strtod(number, NULL) : test_number_rounds(number, value);
    }
    g_strfreev(candidates);
    return found;
}

/* NULL, or why the claim does not give its number. */
static char *judge_claim(const char *folder, const struct test_prose_claim *claim)
{
    static const char *const names[2] = {"x", "y"};
    if (claim->from == NULL)
        return claim->in != NULL ? NULL : g_strdup("literature has no name");
    struct page page = page_read(folder, claim->in != NULL ? claim->in : claim->page);
    char **parts = numbers(claim->from, false), *fault = NULL;
    for (char **part = parts; *part != NULL && fault == NULL; part++)
        if (strchr(*part, '.') != NULL && !is_shown(&page, *part, true))
            fault = g_strdup_printf("%s of %s is shown nowhere", *part, claim->from);
    struct mpm_expression *expression = NULL;
    struct mpm_error error;
    if (fault == NULL &&
        mpm_expression_create(claim->from, names, false, 1, &expression, &error) != MPM_OK)
        fault = g_strdup(error.message);
    if (fault == NULL) {
        const double value = mpm_expression_value(expression, 0, (const double[2]){0.0, 0.0}, 0.0);
        if (!test_number_rounds(claim->number, value))
            fault = g_strdup_printf("%s is %.6g", claim->from, value);
    }
    mpm_expression_free(expression);
    g_strfreev(parts);
    page_clear(&page);
    return fault;
}

static char *judge_number(const struct page *page, const char *folder, const char *name,
                          const char *number, const struct test_prose_claim *claims, unsigned count)
{
    for (unsigned k = 0; k < count; k++) {
        if (strcmp(claims[k].page, name) != 0 || strcmp(claims[k].number, number) != 0)
            continue;
        char *why = judge_claim(folder, &claims[k]);
        char *fault = why == NULL ? NULL : g_strdup_printf("%s: %s: %s", name, number, why);
        g_free(why);
        return fault;
    }
    const bool judged = strchr(number, '.') != NULL || g_str_has_suffix(number, " %");
    return !judged || is_shown(page, number, false)
               ? NULL
               : g_strdup_printf("%s: %s comes from no output, scene or claim", name, number);
}

char *test_prose_judge(const char *folder, const char *name, const struct test_prose_claim *claims,
                       unsigned count)
{
    struct page page = page_read(folder, name);
    char **written = numbers(page.prose, false), *fault = NULL;
    for (char **number = written; *number != NULL && fault == NULL; number++)
        fault = judge_number(&page, folder, name, *number, claims, count);
    for (unsigned k = 0; k < count && fault == NULL; k++)
        if (strcmp(claims[k].page, name) == 0 &&
            !g_strv_contains((const char *const *)written, claims[k].number))
            fault = g_strdup_printf("%s: the claim %s is not in the prose", name, claims[k].number);
    g_strfreev(written);
    page_clear(&page);
    return fault;
}
