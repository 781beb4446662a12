/* The front page: verdict, counts, families and cases, worst margins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/html.h"
#include "verification/records/check_text.h"
#include "verification/report/case_pictures.h"
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Name, status, value and band of a check: the first cells of its row. */
static void begin_row(struct report_table *table, const json_t *check)
{
    char *name = text_check_name(check), *band = text_band(check);
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(check, "case"));
    report_table_link(table, href, name);
    report_table_status(table, record_status(check));
    report_table_number(table, record_number(check, "value"), text_value(check));
    report_table_text(table, band);
    g_free(href);
    g_free(band);
    g_free(name);
}

static void add_verdict(GString *html, const struct records *records,
                        const struct record_counts *counts)
{
    char *verdict = text_verdict(counts), *incomplete = records_incomplete(records);
    if (incomplete != NULL)
        text_markup(html, "<p class=\"verdict bad\">%s</p>\n", incomplete);
    text_markup(html, "<h1 class=\"verdict %s\">%s</h1>\n", counts->failed > 0 ? "bad" : "good",
                verdict);
    html_counts(html, counts);
    char *tried = g_strdup_printf("%zu", counts->mutations);
    char *red = g_strdup_printf("%zu", counts->mutations_red);
    text_markup(html,
                "<p>Proof that the checks can fail, made on this run: %s of %s spoiled results "
                "(not a number, a missing row, zero, a value beyond the band, a crash and others) "
                "turned their check red.</p>\n",
                red, tried);
    g_free(incomplete);
    g_free(verdict);
    g_free(tried);
    g_free(red);
    if (strcmp(record_text(records->run, "tier"), "ci") == 0)
        g_string_append(html, "<p class=\"about\">Small size, as run on every change; <code>"
                              "mpm-verify run --tier full</code> runs all variants.</p>\n");
}

static void add_failures(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Check", NULL, CELLS_TEXT, false},   {"Status", NULL, CELLS_TEXT, false},
        {"Value", NULL, CELLS_NUMBER, false}, {"Band", NULL, CELLS_BAND, false},
        {"Reason", NULL, CELLS_WIDE, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(site->records->checks); i++) {
        const json_t *check = json_array_get(site->records->checks, i);
        if (!verdict_is_red(record_status(check)))
            continue;
        begin_row(table, check);
        report_table_text(table, record_text(check, "reason"));
    }
    g_string_append(html, "<h2 id=\"failures\">What does not hold</h2>\n");
    report_site_table(site, table, "Every check that fails this run", "failures.csv", html);
}

/* ------------------------------------------------------------------------ cases */

static double case_seconds(const json_t *entry)
{
    const json_t *variants = json_object_get(entry, "variants");
    double seconds = 0;
    for (size_t i = 0; i < json_array_size(variants); i++)
        seconds += record_number(json_array_get(variants, i), "seconds");
    return seconds;
}

static void add_margin(struct report_table *table, const json_t *check, bool named)
{
    GString *markup = g_string_new(NULL);
    if (check != NULL)
        html_margin(markup, record_number(check, "margin"));
    if (check != NULL && named)
        text_markup(markup, "<span class=\"about\">%s, %s</span>", record_text(check, "check"),
                    record_text(check, "variant"));
    report_table_value(table, record_number(check, "margin"), markup);
}

static void add_case(struct report_table *table, const struct records *records, const json_t *entry)
{
    const char *name = record_text(entry, "case");
    const struct record_counts counts = records_count(records, NULL, name);
    char *href = g_strdup_printf("cases/%s/index.html", name);
    GString *problem = g_string_new(NULL), *status = g_string_new(NULL);
    text_markup(problem, "%s<span class=\"about\">%s</span>", record_text(entry, "title"),
                record_text(entry, "summary"));
    html_case_status(status, &counts);
    report_table_link(table, href, name);
    report_table_markup(table, record_text(entry, "title"), problem);
    report_table_markup(table, counts.failed > 0 ? "fail" : "pass", status);
    report_table_number(table, (double)counts.total, g_strdup_printf("%zu", counts.total));
    add_margin(table, records_worst(records, name), true);
    report_table_number(table, case_seconds(entry), text_seconds(case_seconds(entry)));
    g_free(href);
}

static void add_cases(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Case", NULL, CELLS_TEXT, false},         {"Problem", NULL, CELLS_WIDE, false},
        {"Status", NULL, CELLS_TEXT, false},       {"Checks", NULL, CELLS_NUMBER, true},
        {"Worst margin", NULL, CELLS_TEXT, false}, {"Time", NULL, CELLS_NUMBER, true},
    };
    const json_t *cases = json_object_get(site->records->run, "cases");
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(cases); i++)
        add_case(table, site->records, json_array_get(cases, i));
    g_string_append(html, "<h2 id=\"cases\">Cases</h2>\n<p class=\"about\">The worst status and "
                          "the least margin of each. A margin is 1 in the middle of the band, 0 on "
                          "its edge and negative outside.</p>\n");
    report_site_table(site, table, "Every case of this run", "cases.csv", html);
}

static int compare_margins(const void *a, const void *b)
{
    const json_t *one = *(json_t *const *)a, *other = *(json_t *const *)b;
    const double left = record_number(one, "margin"), right = record_number(other, "margin");
    return (left > right) - (left < right);
}

enum { CLOSEST_SHOWN = 6 };

static void add_closest(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Check", NULL, CELLS_TEXT, false},   {"Status", NULL, CELLS_TEXT, false},
        {"Value", NULL, CELLS_NUMBER, false}, {"Band", NULL, CELLS_BAND, false},
        {"Margin", NULL, CELLS_TEXT, false},
    };
    GPtrArray *checks = g_ptr_array_new();
    for (size_t i = 0; i < json_array_size(site->records->checks); i++) {
        json_t *check = json_array_get(site->records->checks, i);
        if (isfinite(record_number(check, "margin")))
            g_ptr_array_add(checks, check);
    }
    g_ptr_array_sort(checks, compare_margins);
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (unsigned i = 0; i < MIN(checks->len, CLOSEST_SHOWN); i++) {
        begin_row(table, checks->pdata[i]);
        add_margin(table, checks->pdata[i], false);
    }
    g_string_append(html, "<h2 id=\"margins\">Worst margins</h2>\n");
    report_site_table(site, table, "The checks closest to an end of their band", "margins.csv",
                      html);
    g_ptr_array_unref(checks);
}

void report_front_page(struct report_site *site)
{
    const struct record_counts counts = records_count(site->records, NULL, NULL);
    GString *html = g_string_new(NULL);
    case_pictures_strip(html, site->records, site->folder);
    add_verdict(html, site->records, &counts);
    report_search(html);
    if (counts.failed > 0)
        add_failures(html, site);
    add_closest(html, site);
    report_changes(html, site);
    report_comparisons(html, site);
    report_coverage(html, site);
    add_cases(html, site);
    char *verdict = text_verdict(&counts);
    report_site_page(site, "index.html", verdict, html);
    g_free(verdict);
}
