/* Colour maps of fields, made in the perceptual space Oklab: equal steps of a value look equal, and
 * lightness alone orders them, so that readers with any colour vision, or a printer, see the same.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_COLOURS_H
#define VERIFICATION_PAGES_COLOURS_H

#include <stdbool.h>

enum { COLOUR_SIZE = 8 };

/* The colour "#rrggbb" at a place from 0 to 1. Diverging: from blue over nearly white, at 1/2, to
 * brown; else from dark violet over green to light yellow. */
void colour_at(double place, bool diverging, char text[COLOUR_SIZE]);

#endif
