/* Gnuplot's SVG in fewer bytes: the same picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_FIGURE_SHORTEN_H
#define VERIFICATION_PAGES_FIGURE_SHORTEN_H

/* Colours as #rrggbb; marks of the same kind and size that follow each other are one group, which
 * states the size, and the colour of the first, once. Numbers move by 0.0005 of the size at
 * most, some thousandths of a pixel. g_free. */
char *figure_shorten(const char *svg);

#endif
