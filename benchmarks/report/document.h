/* A document: headings, paragraphs, tables and figures, written once and rendered as HTML and
 * as Markdown. All texts are plain: each rendering escapes what it takes as its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_REPORT_DOCUMENT_H
#define BENCHMARKS_REPORT_DOCUMENT_H

#include <glib.h>
#include <stdbool.h>

struct document;

struct document *document_new(void);
void document_free(struct document *document);

/* A heading of that level, 2 or 3. */
void document_heading(struct document *document, int level, const char *text);

/* A paragraph; a notice stands out (something is missing). Printed from the format. */
void document_paragraph(struct document *document, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void document_notice(struct document *document, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A table with these columns, NULL at the end; '>' before a name puts it to the right, for
 * numbers. */
void document_table(struct document *document, const char *caption, const char *const *columns);

/* The next cell of the table opened last, rows of as many cells as columns: a text and, in
 * small below it, what is to be known about it. Both are taken over; `about` may be NULL. */
void document_cell(struct document *document, char *text, char *about);

/* A picture beside the page: file name, and what it shows. */
void document_figure(struct document *document, const char *file, const char *title,
                     const char *caption);

/* The renderings; g_free. `links` are the headings of level 2 as a list of links. */
char *document_html(const struct document *document);
char *document_links(const struct document *document);
char *document_markdown(const struct document *document);

#endif
