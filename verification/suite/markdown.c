/* Markdown of the cases as HTML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/markdown.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

static void lower_headings(cmark_node *document)
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
            cmark_node_set_heading_level(node, MIN(6, cmark_node_get_heading_level(node) + 1));
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
    lower_headings(document);
    char *html =
        cmark_render_html(document, CMARK_OPT_DEFAULT, cmark_parser_get_syntax_extensions(parser));
    char *copy = g_strdup(html);
    free(html);
    cmark_node_free(document);
    cmark_parser_free(parser);
    return copy;
}
