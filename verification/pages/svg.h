/* Pictures as SVG, written by the report itself: text that follows the reader's light or dark
 * ground, and axes with the same scale along both.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PAGES_SVG_H
#define VERIFICATION_PAGES_SVG_H

#include <glib.h>

/* What a reader sees of a plane: `scale` pixels for a length of 1, upwards. */
struct svg_view {
    double low[2], high[2]; /* the part shown */
    double scale;
    double left, top; /* pixels: its upper left corner */
};

/* The part from low to high, as large as fits into width by height; a margin of so many pixels is
 * left around it. It is in the middle of the width. A part that is tiny beside its coordinates is
 * made wider, so that tics have different numbers. */
struct svg_view svg_view_of(const double low[2], const double high[2], double left, double top,
                            double width, double height);
double svg_x(const struct svg_view *view, double x);
double svg_y(const struct svg_view *view, double y);
double svg_width(const struct svg_view *view);
double svg_height(const struct svg_view *view);

/* Begins and ends a picture of that size; `kind` is the class of the whole: "plot" with axes, which
 * have titles, "free" without any; `style` is more CSS. Elements between use the classes soft
 * (text), line, thin. */
void svg_begin(GString *svg, double width, double height, const char *kind, const char *title,
               const char *description, const char *style);
void svg_end(GString *svg);

/* A text at a point; anchor: start, middle, end. `class` may be "". */
void svg_text(GString *svg, double x, double y, const char *anchor, const char *class,
              const char *text);

/* The same turned by a right angle, its middle at the point. */
void svg_turned_text(GString *svg, double x, double y, const char *text);

/* A straight line of a class. */
void svg_line(GString *svg, const char *class, double x1, double y1, double x2, double y2);

/* Appends a number with a decimal at most, as coordinates need. */
void svg_number(GString *svg, double value);

/* Tics, numbers and names ("x / mm") of both axes around the view, that of the second one turned,
 * 60 pixels to the left. */
void svg_axes(GString *svg, const struct svg_view *view, char *const names[2]);

/* 1, 2 or 5 times a power of ten, of which about `most` at the most are in a range; and a multiple
 * of it as text (g_free) with the digits that tell it from the next, `largest` being the largest of
 * them. */
double svg_step(double range, double most);
char *svg_tic_text(double value, double step, double largest);

/* A number as labels have it, with four digits, powers of ten written out; g_free. */
char *svg_value_text(double value);

#endif
