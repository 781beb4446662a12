/* Markdown of the cases as HTML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/markdown.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <glib.h>
#include <stdbool.h>
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

/* --------------------------------------------------------------------- equations */

/* The MathML of a TeX text; NULL if the table has none. */
static const char *mathml_of(const json_t *equations, const char *kind, const char *tex)
{
    char *key = g_strstrip(g_strdup(tex == NULL ? "" : tex));
    const char *found = json_string_value(json_object_get(json_object_get(equations, kind), key));
    g_free(key);
    return found;
}

/* A displayed equation has a box that scrolls where it is wider than the page. */
static void put_in_place(cmark_node *code, cmark_node_type type, const char *mathml)
{
    const bool block = type == CMARK_NODE_CUSTOM_BLOCK;
    cmark_node *math = cmark_node_new(type);
    char *markup = g_strconcat(block ? "<div class=\"scroll\" tabindex=\"0\" role=\"group\" "
                                       "aria-label=\"Equation\">"
                                     : "",
                               mathml, block ? "</div>" : "", NULL);
    cmark_node_set_on_enter(math, markup);
    g_free(markup);
    cmark_node_replace(code, math);
    cmark_node_free(code);
}

/* Whether the texts on both sides of a code have its dollar signs; takes them off. */
static bool take_dollars(cmark_node *code)
{
    cmark_node *before = cmark_node_previous(code), *after = cmark_node_next(code);
    const char *left = before == NULL ? NULL : cmark_node_get_literal(before);
    const char *right = after == NULL ? NULL : cmark_node_get_literal(after);
    if (left == NULL || right == NULL || !g_str_has_suffix(left, "$") || *right != '$')
        return false;
    char *cut = g_strndup(left, strlen(left) - 1), *rest = g_strdup(right + 1);
    cmark_node_set_literal(before, cut);
    cmark_node_set_literal(after, rest);
    g_free(rest);
    g_free(cut);
    return true;
}

static void set_equations(cmark_node *document, const json_t *equations)
{
    cmark_iter *walk = cmark_iter_new(document);
    GPtrArray *codes = g_ptr_array_new(); /* a tree that is walked does not change */
    while (cmark_iter_next(walk) != CMARK_EVENT_DONE) {
        cmark_node *node = cmark_iter_get_node(walk);
        const cmark_node_type type = cmark_node_get_type(node);
        if (type == CMARK_NODE_CODE ||
            (type == CMARK_NODE_CODE_BLOCK && strcmp(cmark_node_get_fence_info(node), "math") == 0))
            g_ptr_array_add(codes, node);
    }
    cmark_iter_free(walk);
    for (unsigned i = 0; i < codes->len; i++) {
        cmark_node *code = codes->pdata[i];
        const bool inside = cmark_node_get_type(code) == CMARK_NODE_CODE;
        const char *mathml =
            mathml_of(equations, inside ? "inline" : "display", cmark_node_get_literal(code));
        const bool marked = !inside || take_dollars(code);
        if (mathml != NULL && marked)
            put_in_place(code, inside ? CMARK_NODE_CUSTOM_INLINE : CMARK_NODE_CUSTOM_BLOCK, mathml);
    }
    g_ptr_array_unref(codes);
}

char *markdown_html(const char *text, const json_t *equations)
{
    cmark_gfm_core_extensions_ensure_registered();
    cmark_parser *parser = cmark_parser_new(CMARK_OPT_VALIDATE_UTF8);
    cmark_syntax_extension *table = cmark_find_syntax_extension("table");
    if (table != NULL)
        cmark_parser_attach_syntax_extension(parser, table);
    cmark_parser_feed(parser, text, strlen(text));
    cmark_node *document = cmark_parser_finish(parser);
    keep_headings(document);
    set_equations(document, equations);
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
