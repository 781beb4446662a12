/* Pieces of HTML that the pages share; all append to a string.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_HTML_H
#define VERIFICATION_SUITE_HTML_H

#include "verification/suite/report.h"
#include "verification/suite/text.h"

/* A state as mark and word; `class` is that of report.css for its colour. */
void html_state(GString *html, const char *class, const char *mark, const char *word);

/* How many are in a state, as an entry of <ul class="counts">. */
void html_state_count(GString *html, const char *class, const char *mark, size_t count,
                      const char *word);

/* A status as mark and word: "✓ pass". */
void html_status(GString *html, enum verdict_status status);

/* Place of a status in the order of what a reader should see first, from 0. */
unsigned html_status_rank(enum verdict_status status);

/* A class name of report.css for the colour of a status. */
const char *html_status_class(enum verdict_status status);

/* A text with numbers (of text.h; taken over), powers of ten written out: 1.3 × 10⁻¹⁵. */
void html_numbers(GString *html, char *text);

/* A name that a narrow column may break after underscores and slashes. */
void html_name(GString *html, const char *name);

/* A margin as a bar and a number. */
void html_margin(GString *html, double margin);

/* "✓ 12 pass  ✗ 1 fail": the statuses that occur. */
void html_counts(GString *html, const struct record_counts *counts);

/* The status of a case: the worst that occurs; known weaknesses beside it. */
void html_case_status(GString *html, const struct record_counts *counts);

/* The template of `style` with its places filled; takes all three strings over. */
char *html_fill(const struct report_style *style, const char *title, GString *navigation,
                GString *content, GString *footer);

/* The page of a verification run; takes navigation and content over. */
char *html_page(const struct records *records, const struct report_style *style, const char *title,
                GString *navigation, GString *content);

#endif
