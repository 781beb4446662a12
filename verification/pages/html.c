/* Pieces of HTML that the pages share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/html.h"

#include <math.h>
#include <string.h>

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
    markup = replace(markup, "[_/=]|\\.(?=[a-z])", "\\0<wbr />");
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
                "<span class=\"kept\"><span class=\"bar%s\" aria-hidden=\"true\"><i "
                "style=\"width:%s%%\"></i></span>",
                margin < 0 ? " out" : "", width);
    g_ascii_formatd(width, sizeof width, fabs(margin) < 10 ? "%.2f" : "%.3g", margin);
    text_markup(html, "%s</span>", width);
}

char *html_fill(const struct report_style *style, const char *title, GString *navigation,
                GString *content, GString *footer)
{
    char *safe_title = g_markup_escape_text(title, -1);
    const struct {
        const char *place, *text;
    } fills[] = {{"title", safe_title},           {"style", style->css},
                 {"script", style->script},       {"filter", style->filter},
                 {"navigation", navigation->str}, {"content", content->str},
                 {"footer", footer->str}};
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
