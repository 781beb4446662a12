/* Pieces of HTML that the pages share; all append to a string.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_HTML_H
#define VERIFICATION_PAGES_HTML_H

#include "verification/common/text.h"
#include "verification/pages/report_style.h"

/* A state as mark and word; `class` is that of report.css for its colour. */
void html_state(GString *html, const char *class, const char *mark, const char *word);

/* How many are in a state, as an entry of <ul class="counts">. */
void html_state_count(GString *html, const char *class, const char *mark, size_t count,
                      const char *word);

/* A text with numbers (of text.h; taken over), powers of ten written out: 1.3 × 10⁻¹⁵. */
void html_numbers(GString *html, char *text);

/* A name that a narrow column may break after underscores, slashes, = and points between words. */
void html_name(GString *html, const char *name);

/* A margin as a bar and a number. */
void html_margin(GString *html, double margin);

/* The template of `style` with its places filled; takes all three strings over. */
char *html_fill(const struct report_style *style, const char *title, GString *navigation,
                GString *content, GString *footer);

#endif
