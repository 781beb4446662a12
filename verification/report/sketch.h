/* What the parts of a sketch share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_SKETCH_H
#define VERIFICATION_REPORT_SKETCH_H

#include "verification/pages/svg.h"

#include <jansson.h>
#include <stdbool.h>

struct sketch {
    const json_t *scene;
    struct svg_view view;
    GString *svg;
    GString *marks;     /* numbers, drawn last so that nothing covers them */
    double centre[2];   /* of all bodies */
    GPtrArray *entries; /* of the legend, each once */
    GArray *taken;      /* struct sketch_mark: where numbers are */
};

enum { SKETCH_MARK = 10 }; /* radius of the circle around a number */
struct sketch_mark {
    double x, y;
};

/* The number of what the legend states so; takes the text over. */
unsigned sketch_entry(struct sketch *sketch, char *text);

/* Draws a number at the first of the places (x, y in pixels) where no other one is. */
void sketch_mark(struct sketch *sketch, unsigned number, const double (*places)[2], size_t count);

/* An arrow that ends at a point, `dx`, `dy` from its beginning. */
void sketch_arrow(struct sketch *sketch, const char *class, double x, double y, double dx,
                  double dy);

/* "(1, 0) mm/ms": a vector of numbers or expressions with the unit, which may be "". */
char *sketch_vector(const json_t *vector, const char *unit);
/* A number or expression as text. */
char *sketch_value(const json_t *value);
/* Direction of a component: -1, 0 or 1; of an expression by its first sign, of `free` 0. */
int sketch_sign(const json_t *component);

/* Of a length, velocity or acceleration: "mm", "mm/ms", "mm/ms²"; "" in a scene without units.
 * g_free. */
char *sketch_unit(const struct sketch *sketch, const char *what);

/* sketch_frame.c: keeps the upper left corner free, before any number is drawn; lines of the grid
 * where cells are large enough to see; the extent of all bodies along an axis, below or to the left
 * of them, and how far away: more on a side where conditions have numbers; names of the coordinates
 * and the axis r = 0. */
void sketch_take_corner(struct sketch *sketch);
void sketch_grid(struct sketch *sketch);
void sketch_dimension(struct sketch *sketch, int axis, double low, double high);
double sketch_dimension_away(const struct sketch *sketch, int axis);
void sketch_axes(struct sketch *sketch);

/* sketch_conditions.c: velocities and symmetries of the grid, conditions of transport, loads. */
void sketch_conditions(struct sketch *sketch);
void sketch_loads(struct sketch *sketch);

#endif
