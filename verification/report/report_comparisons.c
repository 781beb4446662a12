/* The front page's part of the comparisons: variants down, problems across.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/measures/comparison/comparison_guide.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/pages/html.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"

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

/* Purpose, the variant to use, its number, and the advice in words. */
static void add_purpose(struct report_table *table, const struct problem *problem)
{
    const char *name = record_text(problem->entry, "case");
    const struct comparison_table *numbers = &problem->view.table;
    const size_t cost = comparison_view_cost(&problem->view);
    const size_t choice = comparison_choice(numbers, problem->leading, cost);
    char *href = g_strdup_printf("cases/%s/comparison.html", name);
    char *purpose = g_strdup_printf("%s: %s", name, record_text(problem->view.declared, "title"));
    char *guide = comparison_guide(numbers, problem->leading, cost);
    report_table_link(table, href, purpose);
    report_table_text(table, choice == COMPARISON_NONE ? "none" : problem->view.names[choice]);
    report_table_text(table, problem->view.columns[problem->leading].title);
    if (choice == COMPARISON_NONE) {
        report_table_text(table, "none");
    } else {
        const double value = comparison_cell(numbers, choice, problem->leading)->value;
        report_table_number(table, value,
                            text_quantity(value, problem->view.columns[problem->leading].unit));
    }
    report_table_text(table, guide);
    g_free(guide);
    g_free(purpose);
    g_free(href);
}

static void add_purposes(GString *html, struct report_site *site, const GArray *problems)
{
    static const struct report_column columns[] = {
        {"Purpose", NULL, CELLS_TEXT, false},    {"Variant", NULL, CELLS_TEXT, false},
        {"Decided by", NULL, CELLS_TEXT, false}, {"Its number", NULL, CELLS_NUMBER, false},
        {"Advice", NULL, CELLS_WIDE, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned p = 0; p < problems->len; p++)
        add_purpose(table, &g_array_index(problems, struct problem, p));
    report_site_table(site, table, "Which variant for which purpose", "purposes.csv", html);
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
        html,
        "<h3>Every variant on every problem</h3>\n<p class=\"about\" "
        "id=\"how\">The number that decides on each page, and its rank there; a heading "
        "sorts. –: that case does not run it at this size.</p>\n<div class=\"scroll tall matrix\" "
        "tabindex=\"0\" role=\"region\" aria-label=\"Every variant on every problem\"><table "
        "class=\"sortable\" aria-describedby=\"how\">\n<thead><tr><th scope=\"col\" "
        "aria-sort=\"ascending\">Variant</th>");
    for (unsigned p = 0; p < problems->len; p++)
        add_heading(html, &g_array_index(problems, struct problem, p));
    g_string_append(html, "</tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < names->len; i++) {
        char *place = g_strdup_printf("%u", i);
        text_markup(html, "<tr><th scope=\"row\" data-key=\"%s\">", place);
        html_name(html, names->pdata[i]);
        g_string_append(html, "</th>");
        for (unsigned p = 0; p < problems->len; p++)
            add_cell(html, &g_array_index(problems, struct problem, p), names->pdata[i]);
        g_string_append(html, "</tr>\n");
        g_free(place);
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
    g_ptr_array_unref(names);
}

/* The numbers of the table, all digits; empty where there is none. */
static char *matrix_csv(const GArray *problems)
{
    GPtrArray *names = names_of(problems);
    GString *csv = g_string_new("\"variant\"");
    for (unsigned p = 0; p < problems->len; p++) {
        const struct problem *problem = &g_array_index(problems, struct problem, p);
        const struct comparison_column *rule = &problem->view.columns[problem->leading];
        char *title = g_strdup_printf("%s: %s (%s)", record_text(problem->entry, "case"),
                                      rule->title, rule->unit);
        g_string_append_c(csv, ',');
        report_csv_text(csv, title);
        g_free(title);
    }
    for (unsigned i = 0; i < names->len; i++) {
        g_string_append(csv, "\r\n");
        report_csv_text(csv, names->pdata[i]);
        for (unsigned p = 0; p < problems->len; p++) {
            const struct problem *problem = &g_array_index(problems, struct problem, p);
            const size_t row = find_row(&problem->view, names->pdata[i]);
            char number[G_ASCII_DTOSTR_BUF_SIZE] = "";
            if (row != COMPARISON_NONE) {
                const struct comparison_cell *cell =
                    comparison_cell(&problem->view.table, row, problem->leading);
                if (cell->state == COMPARISON_NUMBER)
                    g_ascii_formatd(number, sizeof number, "%.17g", cell->value);
            }
            g_string_append_printf(csv, ",%s", number);
        }
    }
    g_string_append(csv, "\r\n");
    g_ptr_array_unref(names);
    return g_string_free(csv, FALSE);
}

void report_comparisons(GString *html, struct report_site *site)
{
    GArray *problems = problems_of(site->records);
    if (problems->len > 0) {
        g_string_append(html,
                        "<h2 id=\"comparisons\">Methods compared: which to use for what</h2>\n");
        add_purposes(html, site, problems);
        add_table(html, problems);
        g_string_append(html, "<p class=\"csv\"><a href=\"table-variants.csv\">table-variants.csv"
                              "</a></p>\n");
        report_site_file(site, "table-variants.csv", matrix_csv(problems));
    }
    g_array_unref(problems);
}
