/* The front page's part on what changed since a baseline.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/report/report_site.h"

#include <string.h>

static const struct {
    const char *change, *mark, *class;
} looks[] = {{"worse", "▼", "bad"}, {"better", "▲", "good"}, {"changed", "◆", "idle"}};

static void add_change(struct report_table *table, const json_t *line)
{
    size_t look = 0;
    while (look + 1 < G_N_ELEMENTS(looks) &&
           strcmp(looks[look].change, record_text(line, "change")) != 0)
        look++;
    char *href = g_strdup_printf("cases/%s/index.html#checks", record_text(line, "case"));
    if (strncmp(record_text(line, "text"), "gone", 4) == 0) /* its page may be gone as well */
        report_table_text(table, record_text(line, "name"));
    else
        report_table_link(table, href, record_text(line, "name"));
    report_table_state(table, looks[look].class, looks[look].mark, looks[look].change);
    report_table_text(table, record_text(line, "section"));
    report_table_text(table, record_text(line, "text"));
    g_free(href);
}

static void add_table(GString *html, struct report_site *site, const json_t *lines)
{
    static const struct report_column columns[] = {
        {"Check or quantity", NULL, CELLS_TEXT, false},
        {"Change", NULL, CELLS_TEXT, false},
        {"Of what", NULL, CELLS_TEXT, false},
        {"From, to", NULL, CELLS_WIDE, false},
    };
    struct report_table *table = report_table_new(columns, G_N_ELEMENTS(columns));
    for (size_t i = 0; i < json_array_size(lines); i++)
        add_change(table, json_array_get(lines, i));
    report_site_table(site, table, "What changed since the baseline", "changes.csv", html);
}

void report_changes(GString *html, struct report_site *site)
{
    g_string_append(html, "<h2 id=\"changes\">Changes since a baseline</h2>\n");
    if (site->changes == NULL) {
        g_string_append(html,
                        "<p class=\"about\">None is stored with this report; <code>mpm-verify "
                        "report DIR --baseline OLD</code> compares with an earlier "
                        "run.</p>\n");
        return;
    }
    const json_t *before = json_object_get(site->changes, "before");
    const json_t *lines = json_object_get(site->changes, "lines");
    char *counts = g_strdup_printf(
        "%.0f worse, %.0f better, %.0f changed otherwise", record_number(site->changes, "worse"),
        record_number(site->changes, "better"), record_number(site->changes, "other"));
    text_markup(html,
                "<p><strong>%s</strong> since revision %s (%s, %s, size %s). Values count from a "
                "change of 0.1 %% on; times are left to <code>mpm-verify compare</code>.</p>\n",
                counts, record_text(before, "revision"), record_text(before, "compiler"),
                record_text(before, "started"), record_text(before, "tier"));
    if (json_array_size(lines) > 0)
        add_table(html, site, lines);
    g_free(counts);
}
