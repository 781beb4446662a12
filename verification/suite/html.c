/* Pieces of HTML that the pages share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/html.h"

#include <math.h>
#include <string.h>

/* In the order of what a reader should see first. */
static const struct {
    enum verdict_status status;
    const char *mark, *class;
} looks[VERDICT_STATUS_COUNT] = {
    {VERDICT_FAIL, "✗", "bad"},         {VERDICT_ERROR, "!", "bad"},
    {VERDICT_TIMEOUT, "⧖", "bad"},      {VERDICT_UNEXPECTED_PASS, "⚑", "bad"},
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

void html_state(GString *html, const char *class, const char *mark, const char *word)
{
    text_markup(
        html,
        "<span class=\"state %s\"><span class=\"mark\" aria-hidden=\"true\">%s</span>%s</span>",
        class, mark, word);
}

void html_state_count(GString *html, const char *class, const char *mark, size_t count,
                      const char *word)
{
    text_markup(html, "<li class=\"%s\"><span aria-hidden=\"true\">%s</span> ", class, mark);
    g_string_append_printf(html, "<b>%zu</b>", count);
    text_markup(html, " %s</li>", word);
}

void html_status(GString *html, enum verdict_status status)
{
    const size_t look = look_of(status);
    html_state(html, looks[look].class, looks[look].mark, verdict_status_name(status));
}

static char *replace(char *text, const char *pattern, const char *replacement)
{
    GRegex *regex = g_regex_new(pattern, G_REGEX_DEFAULT, G_REGEX_MATCH_DEFAULT, NULL);
    char *result = g_regex_replace(regex, text, -1, 0, replacement, G_REGEX_MATCH_DEFAULT, NULL);
    g_regex_unref(regex);
    g_free(text);
    return result;
}

void html_numbers(GString *html, char *text)
{
    char *markup = g_markup_escape_text(text, -1);
    markup = replace(markup, "(?<=[0-9])e-0*([0-9]+)", " × 10<sup>−\\1</sup>");
    markup = replace(markup, "(?<=[0-9])e\\+0*([0-9]+)", " × 10<sup>\\1</sup>");
    g_string_append(html, markup);
    g_free(markup);
    g_free(text);
}

void html_name(GString *html, const char *name)
{
    char *markup = g_markup_escape_text(name, -1);
    markup = replace(markup, "[_/]", "\\0<wbr />");
    g_string_append(html, markup);
    g_free(markup);
}

void html_margin(GString *html, double margin)
{
    if (!isfinite(margin)) {
        g_string_append(html, "none");
        return;
    }
    char width[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(width, sizeof width, "%.0f", 100 * fmin(1, fabs(margin)));
    text_markup(html,
                "<span class=\"bar%s\" aria-hidden=\"true\"><i style=\"width:%s%%\"></i></span>",
                margin < 0 ? " out" : "", width);
    g_ascii_formatd(width, sizeof width, fabs(margin) < 10 ? "%.2f" : "%.3g", margin);
    text_markup(html, "%s", width);
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

char *html_fill(const struct report_style *style, const char *title, GString *navigation,
                GString *content, GString *footer)
{
    char *safe_title = g_markup_escape_text(title, -1);
    const struct {
        const char *place, *text;
    } fills[] = {{"title", safe_title},     {"style", style->css},
                 {"script", style->script}, {"navigation", navigation->str},
                 {"content", content->str}, {"footer", footer->str}};
    GString *page = g_string_new(NULL);
    /* one pass over the template, so that a text with {{...}} in it stays a text */
    for (const char *rest = style->page; *rest != '\0';) {
        const char *open = strstr(rest, "{{");
        const size_t length = open == NULL ? strlen(rest) : (size_t)(open - rest);
        g_string_append_len(page, rest, (gssize)length);
        rest += length;
        if (open == NULL)
            break;
        const char *close = strstr(open, "}}");
        for (size_t i = 0; close != NULL && i < G_N_ELEMENTS(fills); i++)
            if (strlen(fills[i].place) == (size_t)(close - open - 2) &&
                g_str_has_prefix(open + 2, fills[i].place))
                g_string_append(page, fills[i].text);
        rest = close == NULL ? rest + strlen(rest) : close + 2;
    }
    g_free(safe_title);
    g_string_free(footer, TRUE);
    g_string_free(navigation, TRUE);
    g_string_free(content, TRUE);
    return g_string_free(page, FALSE);
}
