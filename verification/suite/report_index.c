/* The front page: verdict, counts, families and cases, worst margins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add_link(GString *html, const char *name, const char *place, const char *text)
{
    text_markup(html, "<a href=\"cases/%s/index.html%s\">%s</a>", name, place, text);
}

/* Name, status, value and band of a check: the first cells of its row. */
static void begin_row(GString *html, const json_t *check)
{
    char *name = text_check_name(check);
    g_string_append(html, "<tr><th scope=\"row\">");
    add_link(html, record_text(check, "case"), "#checks", name);
    g_string_append(html, "</th><td>");
    html_status(html, record_status(check));
    g_string_append(html, "</td><td class=\"n\">");
    html_numbers(html, text_value(check));
    g_string_append(html, "</td><td class=\"band\">");
    html_numbers(html, text_band(check));
    g_free(name);
}

static void add_verdict(GString *html, const struct records *records,
                        const struct record_counts *counts)
{
    char *verdict = text_verdict(counts);
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
    g_free(verdict);
    g_free(tried);
    g_free(red);
    if (strcmp(record_text(records->run, "tier"), "ci") == 0)
        g_string_append(html, "<p class=\"about\">Small size, as run on every change; <code>"
                              "mpm-verify run --tier full</code> runs all variants.</p>\n");
}

static void add_failures(GString *html, const struct records *records)
{
    g_string_append(html, "<h2>What does not hold</h2>\n<div class=\"scroll\"><table>\n"
                          "<caption>Every check that fails this run</caption>\n<thead><tr>"
                          "<th scope=\"col\">Check</th><th scope=\"col\">Status</th>"
                          "<th scope=\"col\" class=\"n\">Value</th><th scope=\"col\">Band</th>"
                          "<th scope=\"col\">Reason</th></tr></thead>\n<tbody>\n");
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (!verdict_is_red(record_status(check)))
            continue;
        begin_row(html, check);
        text_markup(html, "</td><td class=\"wide\">%s</td></tr>\n", record_text(check, "reason"));
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
}

static double case_seconds(const json_t *entry)
{
    const json_t *variants = json_object_get(entry, "variants");
    double seconds = 0;
    for (size_t i = 0; i < json_array_size(variants); i++)
        seconds += record_number(json_array_get(variants, i), "seconds");
    return seconds;
}

static void add_case(GString *html, const struct records *records, const json_t *entry)
{
    const char *name = record_text(entry, "case");
    const struct record_counts counts = records_count(records, NULL, name);
    const json_t *worst = records_worst(records, name);
    char *seconds = text_seconds(case_seconds(entry));
    char *checks = g_strdup_printf("%zu", counts.total);
    text_markup(html, "<tr><th scope=\"row\">%s</th><td class=\"wide\">", name);
    add_link(html, name, "", record_text(entry, "title"));
    text_markup(html, "<span class=\"about\">%s</span></td><td>", record_text(entry, "summary"));
    html_case_status(html, &counts);
    text_markup(html, "</td><td class=\"n\">%s</td><td>", checks);
    if (worst != NULL) {
        html_margin(html, record_number(worst, "margin"));
        text_markup(html, "<span class=\"about\">%s, %s</span>", record_text(worst, "check"),
                    record_text(worst, "variant"));
    }
    text_markup(html, "</td><td class=\"n\">%s</td></tr>\n", seconds);
    g_free(seconds);
    g_free(checks);
}

static void add_cases(GString *html, const struct records *records)
{
    const json_t *cases = json_object_get(records->run, "cases");
    g_string_append(html, "<h2>Families and cases</h2>\n<div class=\"scroll\"><table>\n"
                          "<caption>The worst status and the least margin of each case. A margin "
                          "is 1 in the middle of the band, 0 on its edge and negative "
                          "outside.</caption>\n<thead><tr><th scope=\"col\">Case</th>"
                          "<th scope=\"col\">Problem</th><th scope=\"col\">Status</th>"
                          "<th scope=\"col\" class=\"n\">Checks</th>"
                          "<th scope=\"col\">Worst margin</th>"
                          "<th scope=\"col\" class=\"n\">Time</th></tr></thead>\n");
    const char *family = NULL;
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        const char *own = record_text(entry, "family");
        if (family == NULL || strcmp(family, own) != 0) {
            const struct record_counts counts = records_count(records, own, NULL);
            char *checks = text_count(counts.total, "check");
            g_string_append(html, family == NULL ? "" : "</tbody>\n");
            text_markup(html,
                        "<tbody class=\"group\">\n<tr><th scope=\"rowgroup\" colspan=\"6\">"
                        "Family %s <span class=\"about\">%s</span></th></tr>\n",
                        own, checks);
            g_free(checks);
        }
        family = own;
        add_case(html, records, entry);
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
}

static int compare_margins(const void *a, const void *b)
{
    const json_t *one = *(json_t *const *)a, *other = *(json_t *const *)b;
    const double left = record_number(one, "margin"), right = record_number(other, "margin");
    return (left > right) - (left < right);
}

enum { CLOSEST_SHOWN = 6 };

static void add_closest(GString *html, const struct records *records)
{
    GPtrArray *checks = g_ptr_array_new();
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        json_t *check = json_array_get(records->checks, i);
        if (isfinite(record_number(check, "margin")))
            g_ptr_array_add(checks, check);
    }
    g_ptr_array_sort(checks, compare_margins);
    g_string_append(html, "<h2>Closest to their bands</h2>\n<div class=\"scroll\"><table>\n"
                          "<caption>The checks with the least margin</caption>\n<thead><tr>"
                          "<th scope=\"col\">Check</th><th scope=\"col\">Status</th>"
                          "<th scope=\"col\" class=\"n\">Value</th><th scope=\"col\">Band</th>"
                          "<th scope=\"col\">Margin</th></tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < MIN(checks->len, CLOSEST_SHOWN); i++) {
        const json_t *check = checks->pdata[i];
        begin_row(html, check);
        g_string_append(html, "</td><td>");
        html_margin(html, record_number(check, "margin"));
        g_string_append(html, "</td></tr>\n");
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
    g_ptr_array_unref(checks);
}

char *report_index(const struct records *records, const struct report_style *style)
{
    const struct record_counts counts = records_count(records, NULL, NULL);
    GString *html = g_string_new(NULL);
    GString *navigation = g_string_new("<strong>Touchstone</strong> verification report");
    add_verdict(html, records, &counts);
    if (counts.failed > 0)
        add_failures(html, records);
    html_comparisons(html, records, style);
    add_cases(html, records);
    add_closest(html, records);
    char *verdict = text_verdict(&counts);
    char *title = g_strconcat("Touchstone: ", verdict, NULL);
    char *page = html_page(records, style, title, navigation, html);
    g_free(verdict);
    g_free(title);
    return page;
}
