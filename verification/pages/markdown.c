/* Markdown of the cases as HTML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/markdown.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

static void keep_headings(cmark_node *document)
{
    cmark_node *first = cmark_node_first_child(document);
    if (first != NULL && cmark_node_get_type(first) == CMARK_NODE_HEADING &&
        cmark_node_get_heading_level(first) == 1) {
        cmark_node_unlink(first);
        cmark_node_free(first);
    }
    for (cmark_node *node = cmark_node_first_child(document); node != NULL;
         node = cmark_node_next(node))
        if (cmark_node_get_type(node) == CMARK_NODE_HEADING)
            cmark_node_set_heading_level(node, MAX(2, cmark_node_get_heading_level(node)));
}

static char *replace(char *text, const char *from, const char *to)
{
    char **parts = g_strsplit(text, from, -1);
    char *result = g_strjoinv(to, parts);
    g_strfreev(parts);
    g_free(text);
    return result;
}

/* Each table in a box that scrolls, with a name of its own for those who do not see it. */
static char *with_boxes(const char *html)
{
    char **parts = g_strsplit(html, "<table>", -1);
    const unsigned count = g_strv_length(parts); /* 0 for an empty text */
    GString *result = g_string_new(parts[0]);
    for (unsigned i = 1; i < count; i++)
        g_string_append_printf(result,
                               "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
                               "aria-label=\"Table %u of the text\"><table>%s",
                               i, parts[i]);
    g_strfreev(parts);
    return replace(g_string_free(result, FALSE), "</table>", "</table></div>");
}

char *markdown_html(const char *text)
{
    cmark_gfm_core_extensions_ensure_registered();
    cmark_parser *parser = cmark_parser_new(CMARK_OPT_VALIDATE_UTF8);
    cmark_syntax_extension *table = cmark_find_syntax_extension("table");
    if (table != NULL)
        cmark_parser_attach_syntax_extension(parser, table);
    cmark_parser_feed(parser, text, strlen(text));
    cmark_node *document = cmark_parser_finish(parser);
    keep_headings(document);
    char *html =
        cmark_render_html(document, CMARK_OPT_DEFAULT, cmark_parser_get_syntax_extensions(parser));
    /* a heading cell without a text heads nothing */
    char *copy = with_boxes(html);
    copy = replace(copy, "<th></th>", "<td></td>");
    free(html);
    cmark_node_free(document);
    cmark_parser_free(parser);
    return copy;
}
