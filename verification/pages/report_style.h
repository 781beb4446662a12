/* The style of a report: what its pages are filled into.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_REPORT_STYLE_H
#define VERIFICATION_PAGES_REPORT_STYLE_H

#include "verification/common/failure.h"

#include <jansson.h>

struct report_style {
    char *page; /* page.html, with {{title}}, {{style}}, ... */
    char *css;
    char *script;      /* of sortable tables */
    char *filter;      /* of the fields above long ones */
    char *glossary;    /* Markdown */
    json_t *equations; /* TeX to MathML, for markdown_html() */
};

/* Reads it from `reports`, the folder that resources_reports() finds: a folder of results has no
 * say in it, since a page holds a script. MPM_ENVIRONMENT_FAILED: NULL, or a file is not there. */
enum mpm_status report_style_read(const char *reports, struct report_style *style,
                                  struct mpm_error *error);
void report_style_clear(struct report_style *style);

#endif
