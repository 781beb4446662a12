/* Markdown of the cases as HTML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_MARKDOWN_H
#define VERIFICATION_PAGES_MARKDOWN_H

#include <jansson.h>

/* Renders Markdown (with tables) for a page that has its own first heading: a leading
 * heading of level 1 is dropped, others go to level 2. Tables are in boxes that scroll. Raw HTML
 * and unsafe links are left out. TeX in a block ```math or between $` and `$ becomes the MathML
 * that `equations` (reports/equations.json; may be NULL) has for it, and stays as code if it has
 * none. g_free. */
char *markdown_html(const char *text, const json_t *equations);

#endif
