/* Ranges of axes and their tics, such that no two labels of tics overlap and none leaves the
 * picture, whatever the numbers. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_AXIS_TICS_H
#define VERIFICATION_MEASURES_AXIS_TICS_H

#include <stdbool.h>
#include <stddef.h>

struct axis_range {
    double low, high;
    bool logarithmic;
};

/* Logarithmic over more than a decade of positive numbers, with a margin on either side. Numbers
 * from low to high that differ by less than a millionth are one, in the middle. Both are finite. */
struct axis_range axis_range_of(double low, double high);

/* Place of a number, 0 at the low end and 1 at the high one. */
double axis_place(const struct axis_range *range, double value);

/* Room for labels in pixels: an axis of that length; labels along it (of x) are beside each other
 * and may reach that far beyond its ends; labels across it (of y) are on top of each other and may
 * be that long. */
struct axis_room {
    double length;
    bool along;
    double beyond; /* of labels along: before the low end and after the high one */
    double across; /* of labels across */
    double font;   /* size of the letters */
};

enum { AXIS_TICS_MAX = 64, AXIS_TIC_TEXT = 40 };
struct axis_tic {
    double value;
    double width;             /* of the label, at most */
    char text[AXIS_TIC_TEXT]; /* in gnuplot's enhanced notation */
};

/* Round numbers in rising order, as many as have room, at most AXIS_TICS_MAX; 0 where numbers need
 * more digits than there is room for. */
size_t axis_tics(const struct axis_range *range, const struct axis_room *room,
                 struct axis_tic tics[AXIS_TICS_MAX]);

/* Width of a text in pixels with letters of that size, in the widest of the usual fonts without
 * serifs: an upper bound for all. What is in braces after ^ is written smaller. */
double axis_text_width(const char *text, double font);

#endif
