/* Words of messages: the name that a misspelt one is nearest to, and lines of a width; and lines of
 * progress on a terminal.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_WORDS_H
#define MPM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* How many letters have to be added, left out, replaced or swapped with their neighbour to make
 * one word of the other; upper and lower case are one. Words longer than 64 bytes are far from all
 * others (SIZE_MAX). O(product of both lengths). */
size_t mpm_words_distance(const char *one, const char *other);

/* The nearest of some names: begin with the word alone, offer each name, and take `best`, NULL
 * where none is near enough: at most one letter in three wrong, and never all of them. The first of
 * several equally near ones counts; the names must stay where they are. */
struct mpm_nearest {
    const char *word, *best;
    size_t distance;
};
void mpm_nearest_offer(struct mpm_nearest *nearest, const char *name);
enum { MPM_HINT_SIZE = 96 };
/* "; did you mean NAME?", or "" where nothing is near enough. */
const char *mpm_nearest_hint(const struct mpm_nearest *nearest, char hint[MPM_HINT_SIZE]);

/* Writes words in lines of up to `width` characters, the first of which begins at `column`, the
 * others after `indent` blanks; a line break in the text is one in the lines. Ends with a line
 * break. A word that is longer than a line has one of its own. */
void mpm_words_wrap(FILE *out, const char *text, size_t column, size_t indent, size_t width);

/* Writes over the line of the terminal `out`: a bar of up to 30 characters, unless the fraction is
 * below 0, and the text. All of it fits into the terminal's columns, since what is longer goes on
 * in the next line, where nothing writes over it: the bar becomes shorter or is left out, then the
 * text is cut. */
void mpm_progress_draw(FILE *out, double fraction, const char *text);
/* Takes such a line off. */
void mpm_progress_clear(FILE *out);
/* Unless NO_COLOR has a value or TERM is dumb. */
bool mpm_terminal_has_colours(void);

#endif
