/* Pages of a verification run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/verdict_html.h"

/* In the order of what a reader should see first. */
static const struct {
    enum verdict_status status;
    const char *mark, *class;
} looks[VERDICT_STATUS_COUNT] = {
    {VERDICT_FAIL, "✗", "bad"},         {VERDICT_ERROR, "!", "bad"},
    {VERDICT_TIMEOUT, "◔", "bad"},      {VERDICT_UNEXPECTED_PASS, "⚑", "bad"},
    {VERDICT_INCONCLUSIVE, "?", "bad"}, {VERDICT_EXPECTED_FAIL, "◇", "known"},
    {VERDICT_PASS, "✓", "good"},        {VERDICT_SKIP, "–", "idle"},
};

static size_t look_of(enum verdict_status status)
{
    size_t i = 0;
    while (looks[i].status != status)
        i++;
    return i;
}

const char *html_status_class(enum verdict_status status)
{
    return looks[look_of(status)].class;
}

unsigned html_status_rank(enum verdict_status status)
{
    return (unsigned)look_of(status);
}

void html_status(GString *html, enum verdict_status status)
{
    const size_t look = look_of(status);
    html_state(html, looks[look].class, looks[look].mark, verdict_status_name(status));
}

void html_counts(GString *html, const struct record_counts *counts)
{
    g_string_append(html, "<ul class=\"counts\">");
    for (size_t i = 0; i < VERDICT_STATUS_COUNT; i++) {
        const size_t count = counts->of[looks[i].status];
        if (count == 0)
            continue;
        html_state_count(html, looks[i].class, looks[i].mark, count,
                         verdict_status_name(looks[i].status));
    }
    g_string_append(html, "</ul>\n");
}

static enum verdict_status worst_status(const struct record_counts *counts)
{
    for (size_t i = 0; i < VERDICT_STATUS_COUNT; i++)
        if (counts->of[looks[i].status] > 0)
            return looks[i].status;
    return VERDICT_SKIP;
}

void html_case_status(GString *html, const struct record_counts *counts)
{
    const enum verdict_status worst = worst_status(counts);
    const size_t known = counts->of[VERDICT_EXPECTED_FAIL];
    html_status(html, worst == VERDICT_EXPECTED_FAIL && counts->of[VERDICT_PASS] > 0 ? VERDICT_PASS
                                                                                     : worst);
    if (known > 0) {
        char *text = g_strdup_printf("%zu", known);
        text_markup(html, "<span class=\"about kept\">%s expected-fail</span>", text);
        g_free(text);
    }
}

static GString *provenance(const json_t *run)
{
    static const char *const rows[][2] = {
        {"Revision", "revision"},   {"Compiler", "compiler"},    {"Flags", "flags"},
        {"Libraries", "libraries"}, {"Pictures", "gnuplot"},     {"Instruction set", "simd"},
        {"Processor", "processor"}, {"Size of the run", "tier"}, {"Kernels", "kernels"},
        {"Command", "command"},     {"Started", "started"},
    };
    GString *html = g_string_new("<h2>Where these numbers come from</h2>\n<dl class=\"facts\">\n");
    text_markup(html, "<dt>Version</dt><dd>Touchstone %s</dd>\n", record_text(run, "version"));
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++)
        text_markup(html, "<dt>%s</dt><dd>%s</dd>\n", rows[i][0], record_text(run, rows[i][1]));
    char *seconds = text_seconds(record_number(run, "seconds"));
    char *jobs = g_strdup_printf("%.0f at a time on %.0f processors", record_number(run, "jobs"),
                                 record_number(run, "processors"));
    text_markup(html, "<dt>Duration</dt><dd>%s, %s</dd>\n</dl>\n", seconds, jobs);
    g_free(seconds);
    g_free(jobs);
    return html;
}

char *html_page(const struct records *records, const struct report_style *style, const char *title,
                GString *navigation, GString *content)
{
    return html_fill(style, title, navigation, content, provenance(records->run));
}
