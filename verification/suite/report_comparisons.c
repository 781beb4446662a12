/* The front page's part of the comparisons: variants down, problems across.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison_guide.h"
#include "verification/measures/comparison_words.h"
#include "verification/suite/comparison_view.h"
#include "verification/suite/html.h"

#include <string.h>

struct problem {
    const json_t *entry;
    struct comparison_view view;
    size_t leading; /* the column that decides */
};

static void clear_problem(void *element)
{
    comparison_view_clear(&((struct problem *)element)->view);
}

static GArray *problems_of(const struct records *records)
{
    const json_t *cases = json_object_get(records->run, "cases");
    GArray *problems = g_array_new(FALSE, TRUE, sizeof(struct problem));
    g_array_set_clear_func(problems, clear_problem);
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        if (comparison_declared(entry) == NULL)
            continue;
        struct problem problem = {.entry = entry, .view = comparison_view_make(records, entry)};
        problem.leading = comparison_view_main(&problem.view);
        g_array_append_val(problems, problem);
    }
    return problems;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static size_t find_row(const struct comparison_view *view, const char *name)
{
    for (size_t row = 0; row < view->table.row_count; row++)
        if (strcmp(view->names[row], name) == 0)
            return row;
    return COMPARISON_NONE;
}

/* Every variant that has a row on a page, once. */
static GPtrArray *names_of(const GArray *problems)
{
    GPtrArray *names = g_ptr_array_new();
    for (unsigned p = 0; p < problems->len; p++) {
        const struct problem *problem = &g_array_index(problems, struct problem, p);
        for (size_t row = 0; row < problem->view.table.row_count; row++) {
            bool there = false;
            for (unsigned before = 0; before < p && !there; before++)
                there = find_row(&g_array_index(problems, struct problem, before).view,
                                 problem->view.names[row]) != COMPARISON_NONE;
            if (!there)
                g_ptr_array_add(names, (void *)problem->view.names[row]);
        }
    }
    g_ptr_array_sort(names, compare_names);
    return names;
}

/* --------------------------------------------------------------------- pieces */

static void add_page(GString *html, const struct problem *problem)
{
    const char *name = record_text(problem->entry, "case");
    char *guide = comparison_guide(&problem->view.table, problem->leading,
                                   comparison_view_cost(&problem->view));
    text_markup(html, "<li><a href=\"cases/%s/comparison.html\">%s: %s</a><span class=\"about\">",
                name, name, record_text(problem->view.declared, "title"));
    html_numbers(html, guide);
    g_string_append(html, "</span></li>\n");
}

static void add_heading(GString *html, const struct problem *problem)
{
    const struct comparison_column *rule = &problem->view.columns[problem->leading];
    const char *name = record_text(problem->entry, "case");
    const bool bare = strcmp(rule->unit, "1") == 0;
    text_markup(html,
                "<th scope=\"col\" class=\"n\" data-first=\"%s\">%s<span "
                "class=\"about\">%s%s%s</span></th>",
                rule->better == COMPARISON_HIGH ? "descending" : "ascending", name, rule->title,
                bare ? "" : ", ", bare ? "" : rule->unit);
}

static void add_missing(GString *html, const struct problem *problem, size_t row)
{
    const bool failed =
        row != COMPARISON_NONE &&
        comparison_cell(&problem->view.table, row, problem->leading)->state == COMPARISON_FAILED;
    text_markup(html, "<td class=\"n\" data-key=\"\"><span class=\"%s\">%s</span></td>",
                failed ? "bad" : "idle", failed ? "✗ no number" : "–");
}

/* The number that decides, with its rank; of a run that does not count what became of it. */
static void add_cell(GString *html, const struct problem *problem, const char *variant)
{
    const struct comparison_table *table = &problem->view.table;
    const size_t row = find_row(&problem->view, variant), column = problem->leading;
    if (row == COMPARISON_NONE || comparison_cell(table, row, column)->state != COMPARISON_NUMBER) {
        add_missing(html, problem, row);
        return;
    }
    const bool part = comparison_takes_part(table, row);
    comparison_cell_html(html, table, row, column, !part,
                         !part ? comparison_run_words(table, row)
                         : comparison_is_level(table, row, column)
                             ? g_strdup("★ best")
                             : comparison_rank_words(table, row, column));
}

static void add_table(GString *html, const GArray *problems)
{
    GPtrArray *names = names_of(problems);
    g_string_append(
        html, "<h3>Every variant on every problem</h3>\n<p class=\"about\" "
              "id=\"how\">The number that decides on each page, and its rank there; a heading "
              "sorts. –: that case does not run it at this size.</p>\n<div class=\"scroll short\" "
              "tabindex=\"0\" role=\"region\" aria-label=\"Every variant on every problem\"><table "
              "class=\"sortable\" aria-describedby=\"how\">\n<thead><tr><th scope=\"col\" "
              "aria-sort=\"ascending\">Variant</th>");
    for (unsigned p = 0; p < problems->len; p++)
        add_heading(html, &g_array_index(problems, struct problem, p));
    g_string_append(html, "</tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < names->len; i++) {
        char *place = g_strdup_printf("%u", i);
        text_markup(html, "<tr><th scope=\"row\" data-key=\"%s\">%s</th>", place,
                    (const char *)names->pdata[i]);
        for (unsigned p = 0; p < problems->len; p++)
            add_cell(html, &g_array_index(problems, struct problem, p), names->pdata[i]);
        g_string_append(html, "</tr>\n");
        g_free(place);
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
    g_ptr_array_unref(names);
}

void html_comparisons(GString *html, const struct records *records,
                      const struct report_style *style)
{
    GArray *problems = problems_of(records);
    if (problems->len > 0) {
        g_string_append(html,
                        "<h2 id=\"comparisons\">Methods compared: which to use for what</h2>\n"
                        "<ul class=\"pages\">\n");
        for (unsigned p = 0; p < problems->len; p++)
            add_page(html, &g_array_index(problems, struct problem, p));
        g_string_append(html, "</ul>\n");
        add_table(html, problems);
        g_string_append_printf(html, "<script>\n%s</script>\n", style->script);
    }
    g_array_unref(problems);
}
