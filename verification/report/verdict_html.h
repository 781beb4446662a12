/* Pages of a verification run: verdicts as HTML, and the frame of a page.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_VERDICT_HTML_H
#define VERIFICATION_REPORT_VERDICT_HTML_H

#include "verification/pages/html.h"
#include "verification/records/records.h"

/* A status as mark and word: "✓ pass". */
void html_status(GString *html, enum verdict_status status);

/* Place of a status in the order of what a reader should see first, from 0. */
unsigned html_status_rank(enum verdict_status status);

/* A class name of report.css for the colour of a status. */
const char *html_status_class(enum verdict_status status);

/* "✓ 12 pass  ✗ 1 fail": the statuses that occur. */
void html_counts(GString *html, const struct record_counts *counts);

/* The status of a case: the worst that occurs; known weaknesses beside it. */
void html_case_status(GString *html, const struct record_counts *counts);

/* The page of a verification run; takes navigation and content over. */
char *html_page(const struct records *records, const struct report_style *style, const char *title,
                GString *navigation, GString *content);

#endif
