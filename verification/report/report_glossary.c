/* The page of words and symbols: a text of the style's folder, and what the run itself explains.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/markdown.h"
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <string.h>

/* What the parts of methods' names mean, from the first comparison that declares them. */
static void add_parts(GString *html, struct report_site *site)
{
    static const struct report_column columns[] = {
        {"Part", NULL, CELLS_TEXT, false},
        {"Kind", NULL, CELLS_TEXT, false},
        {"Meaning", NULL, CELLS_WIDE, false},
    };
    const json_t *cases = json_object_get(site->records->run, "cases"), *parts = NULL;
    for (size_t i = 0; json_array_size(parts) == 0 && i < json_array_size(cases); i++)
        parts = json_object_get(json_object_get(json_array_get(cases, i), "comparison"), "parts");
    if (json_array_size(parts) == 0)
        return;
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        char *shown = g_strdelimit(g_strdup(record_text(part, "part")), "?", 'N');
        report_table_text(table, shown);
        report_table_text(table, record_text(part, "kind"));
        report_table_text(table, record_text(part, "title"));
        g_free(shown);
    }
    g_string_append(html, "<h2 id=\"parts\">Parts of methods’ names</h2>\n");
    report_site_table(site, table, "Parts of the names of variants, between underscores",
                      "parts.csv", html);
}

static void add_statuses(GString *html)
{
    static const struct {
        enum verdict_status status;
        const char *meaning;
    } rows[] = {
        {VERDICT_PASS, "the value is in its band"},
        {VERDICT_EXPECTED_FAIL, "a known weakness shows itself as declared: the value is in the "
                                "band of the weakness; counts as passed"},
        {VERDICT_FAIL, "the value is outside its band"},
        {VERDICT_UNEXPECTED_PASS, "a known weakness is gone: the declaration must change"},
        {VERDICT_INCONCLUSIVE, "the value could not be determined; counts as failed"},
        {VERDICT_ERROR, "no value: a crash, a missing or spoiled result"},
        {VERDICT_TIMEOUT, "the program did not end in its time"},
        {VERDICT_SKIP, "not run, with the reason"},
    };
    g_string_append(html, "<h2 id=\"statuses\">Statuses</h2>\n<dl class=\"words\">\n");
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_string_append(html, "<dt>");
        html_status(html, rows[i].status);
        text_markup(html, "</dt><dd>%s</dd>\n", rows[i].meaning);
    }
    g_string_append(html, "</dl>\n");
}

/* Headings of level 2 get their text in small letters as the place that links name. */
static char *with_places(char *html)
{
    GString *result = g_string_new(NULL);
    static const char open[] = "<h2>";
    const char *rest = html;
    for (const char *at; (at = strstr(rest, open)) != NULL;) {
        const char *text = at + strlen(open);
        char *place = g_ascii_strdown(text, (gssize)strcspn(text, "<"));
        g_string_append_len(result, rest, at - rest);
        g_string_append_printf(result, "<h2 id=\"%s\">", g_strdelimit(place, " ", '-'));
        g_free(place);
        rest = text;
    }
    g_string_append(result, rest);
    g_free(html);
    return g_string_free(result, FALSE);
}

void report_glossary_page(struct report_site *site)
{
    GString *html = g_string_new("<h1>Words and symbols</h1>\n");
    char *text = with_places(markdown_html(site->style->glossary, site->style->equations));
    add_statuses(html);
    g_string_append_printf(html, "<section class=\"readme\">\n%s</section>\n", text);
    add_parts(html, site);
    g_free(text);
    report_site_page(site, "glossary.html", "Words and symbols", html);
}
