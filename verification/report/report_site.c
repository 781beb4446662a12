/* The report's pages: links between them, and the files that they add.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/report_site.h"
#include "verification/report/verdict_html.h"

#include <string.h>

void report_site_file(struct report_site *site, const char *name, char *text)
{
    const struct report_file file = {g_strdup(name), text};
    g_array_append_val(site->files, file);
}

void report_site_table(struct report_site *site, struct report_table *table, const char *caption,
                       const char *csv, GString *html)
{
    char *file = g_strconcat("table-", csv, NULL);
    report_table_html(table, caption, file, html);
    report_site_file(site, file, report_table_csv(table));
    g_free(file);
    report_table_free(table);
}

void report_site_links(GString *html, const struct report_site *site, const char *root,
                       const char *here)
{
    static const struct {
        const char *file, *place, *title;
    } pages[] = {
        {"index.html", "", "Overview"},
        {"index.html", "#cases", "Cases"},
        {"index.html", "#comparisons", "Comparisons"},
        {"checks.html", "", "Checks"},
        {"decision.html", "", "Which method"},
        {"limits.html", "", "Limits"},
        {"headroom.html", "", "Headroom"},
        {"history.html", "", "History"},
        {"mutants.html", "", "Mutants"},
        {"../bench/index.html", "", "Benchmarks"},
        {"api/index.html", "", "API"},
        {"glossary.html", "", "Glossary"},
    };
    text_markup(html,
                "<nav aria-label=\"Report\"><a class=\"home\" href=\"%sindex.html\">"
                "<strong>Touchstone</strong></a><ul>",
                root);
    for (size_t i = 0; i < G_N_ELEMENTS(pages); i++) {
        const bool front = *pages[i].place != '\0';
        if ((g_str_has_prefix(pages[i].file, "..") && !site->benchmarks) ||
            (strcmp(pages[i].place, "#comparisons") == 0 && !site->compares) ||
            (strcmp(pages[i].file, "decision.html") == 0 && !site->compares) ||
            (strcmp(pages[i].file, "history.html") == 0 && site->history == NULL) ||
            (strcmp(pages[i].file, "mutants.html") == 0 && site->mutants == NULL) ||
            (strcmp(pages[i].file, "api/index.html") == 0 && !site->api))
            continue;
        text_markup(html, "<li><a href=\"%s%s%s\"", root, pages[i].file, pages[i].place);
        g_string_append(
            html, !front && g_strcmp0(here, pages[i].file) == 0 ? " aria-current=\"page\">" : ">");
        text_markup(html, "%s</a></li>", pages[i].title);
    }
    g_string_append(html, "</ul></nav>");
}

void report_site_page(struct report_site *site, const char *name, const char *title,
                      GString *content)
{
    GString *links = g_string_new(NULL);
    char *full = g_strconcat("Touchstone: ", title, NULL);
    report_site_links(links, site, "", name);
    report_site_file(site, name, html_page(site->records, site->style, full, links, content));
    g_free(full);
}
