/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/region_svg.h"

#include "verification/common/record.h"
#include "verification/report/picture_file.h"

#include <math.h>
#include <string.h>

static void append_point(GString *svg, const struct svg_view *view, const char *command, double x,
                         double y)
{
    g_string_append(svg, command);
    svg_number(svg, svg_x(view, x));
    g_string_append_c(svg, ' ');
    svg_number(svg, svg_y(view, y));
}

static void append_circle(GString *svg, const struct svg_view *view, const double centre[2],
                          double radius)
{
    for (int side = 1; side >= -1; side -= 2) {
        if (side == 1)
            append_point(svg, view, "M", centre[0] - radius, centre[1]);
        g_string_append_c(svg, 'A');
        svg_number(svg, radius * view->scale);
        g_string_append_c(svg, ' ');
        svg_number(svg, radius * view->scale);
        append_point(svg, view, " 0 0 1 ", centre[0] + side * radius, centre[1]);
    }
    g_string_append_c(svg, 'z');
}

static void append_box(GString *svg, const struct svg_view *view, const double from[2],
                       const double to[2])
{
    append_point(svg, view, "M", from[0], from[1]);
    append_point(svg, view, "L", to[0], from[1]);
    append_point(svg, view, "L", to[0], to[1]);
    append_point(svg, view, "L", from[0], to[1]);
    g_string_append_c(svg, 'z');
}

static void append_polygon(GString *svg, const struct svg_view *view, const json_t *points)
{
    double point[2];
    for (size_t i = 0; i < json_array_size(points); i++)
        if (picture_point(json_array_get(points, i), point))
            append_point(svg, view, i == 0 ? "M" : "L", point[0], point[1]);
    g_string_append_c(svg, 'z');
}

void region_path(GString *svg, const struct svg_view *view, const json_t *region,
                 const char *attributes)
{
    static const char *const boxes[] = {"rectangle", "line"};
    double a[2], b[2], outer, inner;
    GString *path = g_string_new(NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(boxes); i++) {
        const json_t *const box = json_object_get(region, boxes[i]);
        if (picture_pair(box, "from", a) && picture_pair(box, "to", b))
            append_box(path, view, a, b);
    }
    const json_t *const disk = json_object_get(region, "disk");
    if (picture_pair(disk, "center", a) && picture_number(disk, "radius", &outer))
        append_circle(path, view, a, outer);
    const json_t *const ring = json_object_get(region, "annulus");
    if (picture_pair(ring, "center", a) && picture_number(ring, "outer", &outer) &&
        picture_number(ring, "inner", &inner)) {
        append_circle(path, view, a, outer);
        append_circle(path, view, a, inner);
    }
    const json_t *const polygon = json_object_get(json_object_get(region, "polygon"), "points");
    if (json_array_size(polygon) > 0)
        append_polygon(path, view, polygon);
    if (path->len > 0)
        g_string_append_printf(svg, "<path %s fill-rule=\"evenodd\" d=\"%s\"/>\n", attributes,
                               path->str);
    g_string_free(path, TRUE);
}

/* Dashes around a body of a few pixels would cover what is there now. */
static bool is_thin(const struct svg_view *view, const json_t *region)
{
    enum { LEAST = 10 /* pixels */ };
    double low[2], high[2];
    return region_box(region, low, high) &&
           fmin(high[0] - low[0], high[1] - low[1]) * view->scale < LEAST;
}

void region_outlines(GString *svg, const struct svg_view *view, const json_t *scene)
{
    const json_t *const bodies = json_object_get(scene, "bodies");
    const bool radial = region_is_radial(scene);
    if (radial)
        region_clip(svg, view);
    for (size_t i = 0; i < json_array_size(bodies); i++) {
        const json_t *const region = json_object_get(json_array_get(bodies, i), "region");
        if (!is_thin(view, region))
            region_path(svg, view, region,
                        radial ? "class=\"before\" clip-path=\"url(#seen)\"" : "class=\"before\"");
    }
}

/* ------------------------------------------------------------------------ boxes */

static void take(double low[2], double high[2], const double point[2], double reach)
{
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmin(low[axis], point[axis] - reach);
        high[axis] = fmax(high[axis], point[axis] + reach);
    }
}

bool region_box(const json_t *region, double low[2], double high[2])
{
    static const char *const boxes[] = {"rectangle", "line"};
    static const char *const rounds[][2] = {{"disk", "radius"}, {"annulus", "outer"}};
    double a[2], b[2], radius;
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    for (size_t i = 0; i < G_N_ELEMENTS(boxes); i++) {
        const json_t *const box = json_object_get(region, boxes[i]);
        if (picture_pair(box, "from", a) && picture_pair(box, "to", b)) {
            take(low, high, a, 0);
            take(low, high, b, 0);
        }
    }
    for (size_t i = 0; i < G_N_ELEMENTS(rounds); i++) {
        const json_t *const body = json_object_get(region, rounds[i][0]);
        if (picture_pair(body, "center", a) && picture_number(body, rounds[i][1], &radius))
            take(low, high, a, radius);
    }
    const json_t *const polygon = json_object_get(json_object_get(region, "polygon"), "points");
    for (size_t i = 0; i < json_array_size(polygon); i++)
        if (picture_point(json_array_get(polygon, i), a))
            take(low, high, a, 0);
    return low[0] <= high[0];
}

void region_bounds(const json_t *scene, double low[2], double high[2])
{
    const json_t *const bodies = json_object_get(scene, "bodies");
    double from[2], to[2];
    for (size_t i = 0; i < json_array_size(bodies); i++) {
        if (!region_box(json_object_get(json_array_get(bodies, i), "region"), from, to))
            continue;
        take(low, high, from, 0);
        take(low, high, to, 0);
    }
    if (region_is_radial(scene)) /* bodies are filled to the right of the axis alone */
        low[0] = fmax(low[0], 0);
}

bool region_is_radial(const json_t *scene)
{
    return strcmp(record_text(scene, "geometry"), "axisymmetric") == 0;
}

void region_clip(GString *svg, const struct svg_view *view)
{
    g_string_append(svg, "<clipPath id=\"seen\"><path d=\"M");
    svg_number(svg, svg_x(view, 0));
    g_string_append(svg, " 0h2000v2000h-2000z\"/></clipPath>\n");
}
