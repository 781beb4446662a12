/* What is around the bodies of a sketch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/sketch.h"

#include "verification/common/record.h"
#include "verification/report/picture_file.h"
#include "verification/report/region_svg.h"

#include <math.h>

enum { CORNER = 3 /* places that the names of the axes take */ };

void sketch_take_corner(struct sketch *sketch)
{
    for (int i = 0; i < CORNER; i++) {
        const struct sketch_mark mark = {14.0 + 20 * i, 24.0 + 10 * i};
        g_array_append_val(sketch->taken, mark);
    }
}

void sketch_grid(struct sketch *sketch)
{
    enum { LEAST = 5 };
    const json_t *const grid = json_object_get(sketch->scene, "grid");
    const struct svg_view *const view = &sketch->view;
    double origin[2], cell[2];
    if (!picture_pair(grid, "origin", origin) || !picture_pair(grid, "cell", cell))
        return;
    const double refine = record_number(grid, "refine");
    for (int axis = 0; axis < 2; axis++) {
        const double step = cell[axis] / refine;
        if (!(step * view->scale >= LEAST))
            continue;
        const double first =
            origin[axis] + step * ceil((view->low[axis] - origin[axis]) / step - 1e-9);
        const int most = (int)((view->high[axis] - view->low[axis]) / step) + 1;
        for (int i = 0; i <= most && first + i * step <= view->high[axis] + 1e-9 * step; i++) {
            const double at = first + i * step;
            const double x = svg_x(view, at), y = svg_y(view, at);
            if (axis == 0)
                svg_line(sketch->svg, "grid", x, view->top, x, view->top + svg_height(view));
            else
                svg_line(sketch->svg, "grid", view->left, y, view->left + svg_width(view), y);
        }
    }
}

/* An arrow along an axis between two places, its heads outside where they have no room inside. */
static void add_double_arrow(struct sketch *sketch, const double a[2], const double b[2])
{
    enum { LEAST = 26, OUTSIDE = 14 };
    const double length = hypot(b[0] - a[0], b[1] - a[1]);
    const double x = (b[0] - a[0]) / length, y = (b[1] - a[1]) / length;
    const double reach = length < LEAST ? -OUTSIDE : length / 2;
    sketch_arrow(sketch, "measure", a[0], a[1], -reach * x, -reach * y);
    sketch_arrow(sketch, "measure", b[0], b[1], reach * x, reach * y);
}

double sketch_dimension_away(const struct sketch *sketch, int axis)
{
    enum { NEAR = 28, FAR = 54 };
    const struct svg_view *const view = &sketch->view;
    for (unsigned i = CORNER; i < sketch->taken->len; i++) {
        const struct sketch_mark *const mark = &g_array_index(sketch->taken, struct sketch_mark, i);
        if (axis == 0 ? mark->y > view->top + svg_height(view) : mark->x < view->left)
            return FAR;
    }
    return NEAR;
}

void sketch_dimension(struct sketch *sketch, int axis, double low, double high)
{
    const struct svg_view *const view = &sketch->view;
    const double away = sketch_dimension_away(sketch, axis);
    char *value = svg_value_text((double)(float)(high - low));
    char *unit = sketch_unit(sketch, "length");
    char *text = g_strdup_printf("%s%s%s", value, *unit == '\0' ? "" : " ", unit);
    const double bottom = view->top + svg_height(view), y = bottom + away, x = view->left - away;
    if (axis == 0) {
        const double a[2] = {svg_x(view, low), y}, b[2] = {svg_x(view, high), y};
        add_double_arrow(sketch, a, b);
        svg_line(sketch->svg, "thin", a[0], bottom + 14, a[0], y + 5);
        svg_line(sketch->svg, "thin", b[0], bottom + 14, b[0], y + 5);
        svg_text(sketch->svg, (a[0] + b[0]) / 2, y + 17, "middle", "", text);
    } else {
        const double a[2] = {x, svg_y(view, low)}, b[2] = {x, svg_y(view, high)};
        add_double_arrow(sketch, a, b);
        svg_line(sketch->svg, "thin", x - 5, a[1], view->left - 14, a[1]);
        svg_line(sketch->svg, "thin", x - 5, b[1], view->left - 14, b[1]);
        svg_turned_text(sketch->svg, x - 7, (a[1] + b[1]) / 2, text);
    }
    g_free(text);
    g_free(unit);
    g_free(value);
}

void sketch_axes(struct sketch *sketch)
{
    const bool radial = region_is_radial(sketch->scene);
    const double x = 16, y = 44;
    sketch_arrow(sketch, "measure", x + 26, y, 26, 0);
    sketch_arrow(sketch, "measure", x, y - 26, 0, -26);
    svg_text(sketch->svg, x + 30, y + 4, "start", "", radial ? "r" : "x");
    svg_text(sketch->svg, x, y - 30, "middle", "", radial ? "z" : "y");
    if (radial && sketch->view.low[0] <= 0)
        svg_line(sketch->svg, "axis", svg_x(&sketch->view, 0), sketch->view.top - 14,
                 svg_x(&sketch->view, 0), sketch->view.top + svg_height(&sketch->view) + 14);
}
