/* The pages of the report beside those of cases, and the files that they add.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_REPORT_SITE_H
#define VERIFICATION_REPORT_REPORT_SITE_H

#include "verification/pages/report_style.h"
#include "verification/report/report.h"
#include "verification/report/report_table.h"

/* What a page is made from, and where it puts its files. */
struct report_site {
    const struct records *records;
    const struct report_style *style;
    const char *folder;     /* of the results */
    const json_t *changes;  /* since a baseline; NULL if none is stored */
    const json_t *mutants;  /* NULL if none are stored */
    const json_t *headroom; /* other builds' runs; NULL if none are stored */
    const json_t *history;  /* earlier runs; NULL if none are stored */
    bool benchmarks;        /* ../bench/index.html is there */
    bool api;               /* api/index.html is there */
    bool compares;          /* a case declares a comparison */
    GArray *files;          /* struct report_file; written when all are made */
};

struct report_file {
    char *name, *text;
};

/* Takes the text over. */
void report_site_file(struct report_site *site, const char *name, char *text);

/* The table as a part of a page, with its CSV as the file table-<csv>; frees it. */
void report_site_table(struct report_site *site, struct report_table *table, const char *caption,
                       const char *csv, GString *html);

/* A page of the site's top folder: takes the content over. */
void report_site_page(struct report_site *site, const char *name, const char *title,
                      GString *content);

/* The links to all pages; `root` leads to the top folder ("" or "../../"), `here` is the file name
 * of this page or NULL. */
void report_site_links(GString *html, const struct report_site *site, const char *root,
                       const char *here);

/* Each page with its tables. */
void report_limits_page(struct report_site *site);
void report_headroom_page(struct report_site *site);
void report_mutants_page(struct report_site *site);
void report_checks_page(struct report_site *site);
void report_history_page(struct report_site *site);
void report_decision_page(struct report_site *site);
void report_glossary_page(struct report_site *site);
void report_front_page(struct report_site *site);

/* Parts of the front page. */
void report_search(GString *html);
void report_coverage(GString *html, struct report_site *site);
void report_changes(GString *html, struct report_site *site);
/* The pages of comparisons in one: purposes with the variant for each, and a table of
 * all variants by the number that decides; nothing if no case declares one. */
void report_comparisons(GString *html, struct report_site *site);

#endif
