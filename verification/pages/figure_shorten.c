/* Gnuplot's SVG in fewer bytes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/figure_shorten.h"

#include <glib.h>
#include <stdlib.h>

/* -------------------------------------------------------------------- colours */

static gboolean write_colour(const GMatchInfo *match, GString *text, gpointer data)
{
    (void)data;
    char *quote = g_match_info_fetch(match, 1);
    g_string_append_printf(text, "=%s#", quote);
    for (int part = 2; part <= 4; part++) {
        char *number = g_match_info_fetch(match, part);
        g_string_append_printf(text, "%02x", (unsigned)strtoul(number, NULL, 10));
        g_free(number);
    }
    g_string_append(text, quote);
    g_free(quote);
    return FALSE;
}

/* 0 to 255 */
#define PART "(25[0-5]|2[0-4]\\d|1?\\d?\\d)"

/* Of attributes. */
static char *with_short_colours(const char *svg)
{
    GRegex *regex = g_regex_new("=(['\"])rgb\\( *" PART ", *" PART ", *" PART "\\)\\1",
                                G_REGEX_DEFAULT, G_REGEX_MATCH_DEFAULT, NULL);
    char *text =
        g_regex_replace_eval(regex, svg, -1, 0, G_REGEX_MATCH_DEFAULT, write_colour, NULL, NULL);
    g_regex_unref(regex);
    return text;
}

/* ---------------------------------------------------------------------- marks */

/* Of a line that is a mark: its parts as text. */
enum { KIND = 1, LEFT, TOP, SIZE, COLOUR };
static const char mark_line[] = "^\\s*<use xlink:href='#(\\w+)' transform='translate\\(([-\\d.]+),"
                                "([-\\d.]+)\\) scale\\(([\\d.]+)\\)' color='([^']+)'/>\\s*$";

/* The parts, or NULL for another line. g_strfreev. */
static char **mark_of(const GRegex *regex, const char *line)
{
    GMatchInfo *match = NULL;
    char **parts = NULL;
    if (g_regex_match(regex, line, G_REGEX_MATCH_DEFAULT, &match))
        parts = g_match_info_fetch_all(match);
    g_match_info_unref(match);
    if (parts != NULL && !(g_ascii_strtod(parts[SIZE], NULL) > 0))
        g_clear_pointer(&parts, g_strfreev);
    return parts;
}

static gboolean is_current(char **mark)
{
    return g_str_equal(mark[COLOUR], "currentColor");
}

/* currentColor is the colour of the group, and so stays out of groups of another colour. */
static gboolean is_alike(char **one, char **other)
{
    return one != NULL && other != NULL && g_str_equal(one[KIND], other[KIND]) &&
           g_str_equal(one[SIZE], other[SIZE]) && is_current(one) == is_current(other);
}

/* A place within a group that is scaled. */
static void add_place(GString *text, const char *name, const char *pixels, const char *size)
{
    char place[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(place, sizeof place, "%.3f",
                    g_ascii_strtod(pixels, NULL) / g_ascii_strtod(size, NULL));
    g_string_append_printf(text, " %s='%s'", name, place);
}

/* `colour` is that of the group. */
static void add_mark(GString *text, char **mark, const char *colour)
{
    g_string_append_printf(text, "<use xlink:href='#%s'", mark[KIND]);
    add_place(text, "x", mark[LEFT], mark[SIZE]);
    add_place(text, "y", mark[TOP], mark[SIZE]);
    if (g_strcmp0(mark[COLOUR], colour) != 0)
        g_string_append_printf(text, " color='%s'", mark[COLOUR]);
    g_string_append(text, "/>\n");
}

char *figure_shorten(const char *svg)
{
    char *coloured = with_short_colours(svg), **lines = g_strsplit(coloured, "\n", -1);
    GRegex *regex = g_regex_new(mark_line, G_REGEX_OPTIMIZE, G_REGEX_MATCH_DEFAULT, NULL);
    GString *text = g_string_new(NULL);
    char *colour = NULL;
    char **before = NULL, **mark = lines[0] == NULL ? NULL : mark_of(regex, lines[0]);
    for (char **line = lines; *line != NULL; line++) {
        char **after = line[1] == NULL ? NULL : mark_of(regex, line[1]);
        const gboolean goes_on = is_alike(before, mark), follows = is_alike(mark, after);
        if (follows && !goes_on) {
            g_string_append_printf(text, "<g color='%s' transform='scale(%s)'>\n", mark[COLOUR],
                                   mark[SIZE]);
            g_free(colour);
            colour = g_strdup(mark[COLOUR]);
        }
        if (goes_on || follows)
            add_mark(text, mark, colour);
        else
            g_string_append_printf(text, "%s%s", *line, line[1] == NULL ? "" : "\n");
        if (goes_on && !follows)
            g_string_append(text, "</g>\n");
        g_strfreev(before);
        before = mark;
        mark = after;
    }
    g_free(colour);
    g_strfreev(before);
    g_regex_unref(regex);
    g_strfreev(lines);
    g_free(coloured);
    return g_string_free(text, FALSE);
}
