/* The page of limits: every known weakness, gathered, and where methods break.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/html.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"

#include "verification/common/text.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/records/check_text.h"

#include <string.h>

static void add_case_link(struct report_table *table, const json_t *check)
{
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(check, "case"));
    report_table_link(table, href, record_text(check, "case"));
    g_free(href);
}

/* Known weaknesses, declared ones that are cured included. */
static bool is_weakness(const json_t *check)
{
    return json_is_number(json_object_get(check, "fails_low"));
}

static void add_weakness(struct report_table *table, const json_t *check)
{
    char *wanted = text_range(record_number(check, "low"), record_number(check, "high"),
                              record_text(check, "unit"));
    GString *what = g_string_new(NULL);
    add_case_link(table, check);
    report_table_name(table, record_text(check, "variant"));
    text_markup(what, "%s<details class=\"about\"><summary>why</summary>%s</details>",
                record_text(check, "title"), record_text(check, "why"));
    report_table_markup(table, record_text(check, "title"), what);
    report_table_status(table, record_status(check));
    report_table_number(table, record_number(check, "value"), text_value(check));
    report_table_text(table, wanted);
    g_free(wanted);
}

static size_t add_weaknesses(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Case", NULL, CELLS_TEXT, false},
        {"Variant", NULL, CELLS_TEXT, false},
        {"What falls short", NULL, CELLS_WIDE, false},
        {"Status", NULL, CELLS_TEXT, false},
        {"Value", NULL, CELLS_NUMBER, false},
        {"A good method", NULL, CELLS_BAND, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(site->records->checks); i++)
        if (is_weakness(json_array_get(site->records->checks, i)))
            add_weakness(table, json_array_get(site->records->checks, i));
    const size_t rows = report_table_rows(table);
    report_table_sort(table);
    g_string_append(html, "<h2 id=\"weaknesses\">Known weaknesses</h2>\n<p class=\"about\">Each is "
                          "a check that is expected to fail, with a band of its own for how "
                          "badly: it turns red when the weakness grows, and when it goes "
                          "away.</p>\n");
    report_site_table(site, table, "Checks that are expected to fail", "weaknesses.csv", html);
    return rows;
}

/* ------------------------------------------------------------------- breaking */

/* One line for each variant that a comparison does not count, with what became of it. */
static void add_outside(struct report_table *table, const json_t *entry,
                        const struct comparison_view *view)
{
    const char *name = record_text(entry, "case");
    for (size_t row = 0; row < view->table.row_count; row++) {
        if (comparison_takes_part(&view->table, row))
            continue;
        char *href = g_strdup_printf("cases/%s/comparison.html#table", name);
        char *words = comparison_run_words(&view->table, row);
        report_table_link(table, href, name);
        report_table_name(table, view->names[row]);
        report_table_text(table, record_text(view->declared, "title"));
        report_table_text(table, words);
        g_free(words);
        g_free(href);
    }
}

static size_t add_breaking(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Case", NULL, CELLS_TEXT, false},
        {"Variant", NULL, CELLS_TEXT, false},
        {"Problem", NULL, CELLS_WIDE, false},
        {"What became of it", NULL, CELLS_TEXT, false},
    };
    const json_t *cases = json_object_get(site->records->run, "cases");
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        if (comparison_declared(entry) == NULL)
            continue;
        struct comparison_view view = comparison_view_make(site->records, entry);
        add_outside(table, entry, &view);
        comparison_view_clear(&view);
    }
    const size_t rows = report_table_rows(table);
    report_table_sort(table);
    g_string_append(html,
                    "<h2 id=\"breaking\">Where methods break</h2>\n<p class=\"about\">Runs "
                    "that did not reach their end or left the limits that the case sets for "
                    "a run to count; the comparison of the case states by how much and beside "
                    "which others.</p>\n");
    report_site_table(site, table, "Runs that do not count", "breaking.csv", html);
    return rows;
}

/* ------------------------------------------------------------------- stability */

/* Every number that a case tagged `stability` is judged by. */
static void add_stability(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Case", NULL, CELLS_TEXT, false},  {"Variant", NULL, CELLS_TEXT, false},
        {"Limit", NULL, CELLS_WIDE, false}, {"Value", NULL, CELLS_NUMBER, false},
        {"Band", NULL, CELLS_BAND, false},  {"Status", NULL, CELLS_TEXT, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(site->records->checks); i++) {
        const json_t *check = json_array_get(site->records->checks, i);
        if (!record_has_tag(records_case(site->records, record_text(check, "case")), "stability"))
            continue;
        char *band = text_band(check);
        add_case_link(table, check);
        report_table_name(table, record_text(check, "variant"));
        report_table_text(table, record_text(check, "title"));
        report_table_number(table, record_number(check, "value"), text_value(check));
        report_table_text(table, band);
        report_table_status(table, record_status(check));
        g_free(band);
    }
    report_table_sort(table);
    g_string_append(html, "<h2 id=\"stability\">Stability and extremes</h2>\n<p "
                          "class=\"about\">Largest stable Courant numbers, fractions of a long run "
                          "that are survived, the smallest and largest values that a method "
                          "takes: all checks of cases tagged <code>stability</code>.</p>\n");
    report_site_table(site, table, "Limits of stability", "stability.csv", html);
}

void report_limits_page(struct report_site *site)
{
    GString *html = g_string_new(NULL), *body = g_string_new(NULL);
    const size_t weaknesses = add_weaknesses(body, site), broken = add_breaking(body, site);
    add_stability(body, site);
    g_string_append(html, "<h1>Limits and stability</h1>\n<p class=\"lead\">Where methods fall "
                          "short, break or go unstable, gathered from all cases of this "
                          "run.</p>\n<ul class=\"counts\">");
    html_state_count(html, "known", "◇", weaknesses, "known weaknesses");
    html_state_count(html, "idle", "–", broken, "runs that do not count");
    g_string_append(html, "</ul>\n");
    g_string_append(html, body->str);
    g_string_free(body, TRUE);
    report_site_page(site, "limits.html", "Limits and stability", html);
}
