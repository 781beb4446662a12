/* A document, rendered as HTML and as Markdown.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/document.h"

#include "verification/common/text.h"
#include "verification/pages/html.h"

#include <stdarg.h>

enum kind { HEADING_2, HEADING_3, PARAGRAPH, NOTICE, TABLE, FIGURE };

struct cell {
    char *text, *about;
};

struct block {
    enum kind kind;
    char *text;     /* heading, paragraph; caption of a table or figure */
    char *file;     /* of a figure */
    char *title;    /* of a figure */
    char **columns; /* of a table */
    GArray *cells;  /* of a table */
};

struct document {
    GArray *blocks;
};

static void clear_cell(void *item)
{
    struct cell *cell = item;
    g_free(cell->text);
    g_free(cell->about);
}

static void clear_block(void *item)
{
    struct block *block = item;
    g_free(block->text);
    g_free(block->file);
    g_free(block->title);
    g_strfreev(block->columns);
    if (block->cells != NULL)
        g_array_unref(block->cells);
}

struct document *document_new(void)
{
    struct document *document = g_new(struct document, 1);
    document->blocks = g_array_new(FALSE, TRUE, sizeof(struct block));
    g_array_set_clear_func(document->blocks, clear_block);
    return document;
}

void document_free(struct document *document)
{
    g_array_unref(document->blocks);
    g_free(document);
}

/* ------------------------------------------------------------------ building */

/* Takes the text over. */
static struct block *add(struct document *document, enum kind kind, char *text)
{
    const struct block block = {.kind = kind, .text = text};
    g_array_append_val(document->blocks, block);
    return &g_array_index(document->blocks, struct block, document->blocks->len - 1);
}

void document_heading(struct document *document, int level, const char *text)
{
    (void)add(document, level == 2 ? HEADING_2 : HEADING_3, g_strdup(text));
}

void document_paragraph(struct document *document, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)add(document, PARAGRAPH, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

void document_notice(struct document *document, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)add(document, NOTICE, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

void document_table(struct document *document, const char *caption, const char *const *columns)
{
    struct block *block = add(document, TABLE, g_strdup(caption));
    block->columns = g_strdupv((char **)(uintptr_t)columns);
    block->cells = g_array_new(FALSE, TRUE, sizeof(struct cell));
    g_array_set_clear_func(block->cells, clear_cell);
}

void document_cell(struct document *document, char *text, char *about)
{
    const struct cell cell = {text, about};
    struct block *block = &g_array_index(document->blocks, struct block, document->blocks->len - 1);
    g_array_append_val(block->cells, cell);
}

void document_figure(struct document *document, const char *file, const char *title,
                     const char *caption)
{
    struct block *block = add(document, FIGURE, g_strdup(caption));
    block->file = g_strdup(file);
    block->title = g_strdup(title);
}

/* --------------------------------------------------------------------- tables */

static bool is_number(const char *column)
{
    return *column == '>';
}

static const char *name_of(const char *column)
{
    return is_number(column) ? column + 1 : column;
}

/* At least 1. */
static unsigned column_count(const struct block *block)
{
    const unsigned count = g_strv_length(block->columns);
    return count == 0 ? 1 : count;
}

static void html_cell(GString *html, const struct cell *cell, const char *column, bool first)
{
    g_string_append(html, first ? "<th scope=\"row\"" : "<td");
    g_string_append(html, is_number(column) ? " class=\"n\">" : ">");
    html_numbers(html, g_strdup(cell->text));
    if (cell->about != NULL) {
        g_string_append(html, "<span class=\"about\">");
        html_numbers(html, g_strdup(cell->about));
        g_string_append(html, "</span>");
    }
    g_string_append(html, first ? "</th>" : "</td>");
}

static void html_table(GString *html, const struct block *block)
{
    const unsigned columns = column_count(block);
    /* above the table, not in it: a caption would scroll away with a wide one */
    text_markup(html, "<p class=\"about\">%s</p>\n", block->text);
    g_string_append(html, "<div class=\"scroll\"><table>\n<thead><tr>");
    for (unsigned c = 0; c < columns; c++) {
        g_string_append(html, is_number(block->columns[c]) ? "<th scope=\"col\" class=\"n\">"
                                                           : "<th scope=\"col\">");
        text_markup(html, "%s</th>", name_of(block->columns[c]));
    }
    g_string_append(html, "</tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < block->cells->len; i++) {
        const unsigned column = i % columns;
        g_string_append(html, column == 0 ? "<tr>" : "");
        html_cell(html, &g_array_index(block->cells, struct cell, i), block->columns[column],
                  column == 0);
        g_string_append(html, column == columns - 1 ? "</tr>\n" : "");
    }
    g_string_append(html, "</tbody>\n</table></div>\n");
}

static void markdown_table(GString *markdown, const struct block *block)
{
    const unsigned columns = column_count(block);
    text_markdown(markdown, block->text);
    g_string_append(markdown, "\n\n");
    for (unsigned c = 0; c < columns; c++) {
        g_string_append(markdown, "| ");
        text_markdown(markdown, name_of(block->columns[c]));
        g_string_append_c(markdown, ' ');
    }
    g_string_append(markdown, "|\n");
    for (unsigned c = 0; c < columns; c++)
        g_string_append(markdown, is_number(block->columns[c]) ? "|--:" : "|---");
    g_string_append(markdown, "|\n");
    for (unsigned i = 0; i < block->cells->len; i++) {
        const struct cell *cell = &g_array_index(block->cells, struct cell, i);
        g_string_append(markdown, "| ");
        text_markdown(markdown, cell->text);
        if (cell->about != NULL) {
            g_string_append(markdown, *cell->text == '\0' ? "" : ", ");
            text_markdown(markdown, cell->about);
        }
        g_string_append(markdown, i % columns == columns - 1 ? " |\n" : " ");
    }
    g_string_append_c(markdown, '\n');
}

/* ----------------------------------------------------------------- renderings */

static void html_figure(GString *html, const struct block *block)
{
    text_markup(html,
                "<figure><img src=\"%s\" alt=\"%s\" loading=\"lazy\" /><figcaption>"
                "<strong>%s</strong><span class=\"about\">%s</span></figcaption></figure>\n",
                block->file, block->title, block->title, block->text);
}

static void html_block(GString *html, const struct block *block)
{
    char *anchor = g_strdelimit(g_ascii_strdown(block->text, -1), " ", '-');
    switch (block->kind) {
    case HEADING_2:
        text_markup(html, "<h2 id=\"%s\">%s</h2>\n", anchor, block->text);
        break;
    case HEADING_3:
        text_markup(html, "<h3>%s</h3>\n", block->text);
        break;
    case PARAGRAPH:
        text_markup(html, "<p class=\"lead\">%s</p>\n", block->text);
        break;
    case NOTICE:
        text_markup(html, "<p class=\"notice quiet\">%s</p>\n", block->text);
        break;
    case TABLE:
        html_table(html, block);
        break;
    case FIGURE:
        html_figure(html, block);
        break;
    }
    g_free(anchor);
}

static void markdown_block(GString *markdown, const struct block *block)
{
    static const char *const before[] = {
        [HEADING_2] = "## ", [HEADING_3] = "### ", [PARAGRAPH] = "", [NOTICE] = ""};
    if (block->kind == TABLE) {
        markdown_table(markdown, block);
    } else if (block->kind != FIGURE) { /* a summary has no pictures */
        g_string_append(markdown, before[block->kind]);
        text_markdown(markdown, block->text);
        g_string_append(markdown, "\n\n");
    }
}

static char *render(const struct document *document,
                    void (*add_block)(GString *text, const struct block *block))
{
    GString *text = g_string_new(NULL);
    for (unsigned i = 0; i < document->blocks->len; i++)
        add_block(text, &g_array_index(document->blocks, struct block, i));
    return g_string_free(text, FALSE);
}

char *document_html(const struct document *document)
{
    return render(document, html_block);
}

char *document_markdown(const struct document *document)
{
    return render(document, markdown_block);
}

static void add_link(GString *html, const struct block *block)
{
    if (block->kind != HEADING_2)
        return;
    char *anchor = g_strdelimit(g_ascii_strdown(block->text, -1), " ", '-');
    text_markup(html, "%s<a href=\"#%s\">%s</a>", html->len == 0 ? "" : " · ", anchor, block->text);
    g_free(anchor);
}

char *document_links(const struct document *document)
{
    return render(document, add_link);
}
