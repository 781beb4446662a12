/* Markdown of the cases as HTML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_MARKDOWN_H
#define VERIFICATION_PAGES_MARKDOWN_H

/* Renders Markdown (with tables) for a page that has its own first heading: a leading
 * heading of level 1 is dropped, others go to level 2. Tables are in boxes that scroll. Raw HTML
 * and unsafe links are left out. g_free. */
char *markdown_html(const char *text);

#endif
