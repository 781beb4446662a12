/* What holds and what loads the bodies of a sketch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/sketch.h"

#include "verification/common/record.h"
#include "verification/report/region_svg.h"

#include <math.h>
#include <string.h>

/* A line of the scene on the page. */
struct segment {
    double from[2], to[2]; /* pixels */
    double outward[2];     /* of length 1, away from the bodies */
    int normal;            /* axis that it is across */
};

/* A line, cut to what is seen and a little more; false: the region is none, or is not seen. */
static bool find_segment(const struct sketch *sketch, const json_t *region, struct segment *segment)
{
    const struct svg_view *const view = &sketch->view;
    double low[2], high[2];
    if (!json_is_object(json_object_get(region, "line")) || !region_box(region, low, high))
        return false;
    const double more = 12 / view->scale;
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmax(low[axis], view->low[axis] - more);
        high[axis] = fmin(high[axis], view->high[axis] + more);
        if (low[axis] > high[axis])
            return false;
    }
    segment->normal = high[0] - low[0] > high[1] - low[1] ? 1 : 0;
    const double side = low[segment->normal] < sketch->centre[segment->normal] ? -1 : 1;
    segment->from[0] = svg_x(view, low[0]);
    segment->from[1] = svg_y(view, low[1]);
    segment->to[0] = svg_x(view, high[0]);
    segment->to[1] = svg_y(view, high[1]);
    segment->outward[0] = segment->normal == 0 ? side : 0;
    segment->outward[1] = segment->normal == 1 ? -side : 0;
    return true;
}

static void mark_segment(struct sketch *sketch, const struct segment *segment, unsigned number,
                         double away)
{
    static const double shares[] = {0.5, 0.25, 0.75, 0.1, 0.9, 0.38, 0.62};
    double places[G_N_ELEMENTS(shares)][2];
    for (size_t i = 0; i < G_N_ELEMENTS(shares); i++)
        for (int axis = 0; axis < 2; axis++)
            places[i][axis] = segment->from[axis] +
                              shares[i] * (segment->to[axis] - segment->from[axis]) +
                              away * segment->outward[axis];
    sketch_mark(sketch, number, (const double(*)[2])places, G_N_ELEMENTS(places));
}

static double segment_length(const struct segment *segment)
{
    return hypot(segment->to[0] - segment->from[0], segment->to[1] - segment->from[1]);
}

static void point_on(const struct segment *segment, double share, double away, double point[2])
{
    for (int axis = 0; axis < 2; axis++)
        point[axis] = segment->from[axis] + share * (segment->to[axis] - segment->from[axis]) +
                      away * segment->outward[axis];
}

/* Short oblique lines behind it: nothing moves. */
static void add_hatches(struct sketch *sketch, const struct segment *segment)
{
    enum { APART = 8, LENGTH = 8 };
    const double length = segment_length(segment);
    const int count = (int)(length / APART) + 1;
    double a[2], b[2];
    for (int i = 0; i < count; i++) {
        const double share = (i + 0.5) / count;
        point_on(segment, share, 0, a);
        point_on(segment, share - (length > 0 ? LENGTH / length : 0), LENGTH, b);
        svg_line(sketch->svg, "hatch", a[0], a[1], b[0], b[1]);
    }
}

/* Small circles behind it: it slides along the line. */
static void add_rollers(struct sketch *sketch, const struct segment *segment)
{
    enum { APART = 18, RADIUS = 4 };
    const int count = (int)(segment_length(segment) / APART) + 1;
    double at[2];
    for (int i = 0; i < count; i++) {
        point_on(segment, (i + 0.5) / count, RADIUS + 1, at);
        g_string_append(sketch->svg, "<circle class=\"hatch\" cx=\"");
        svg_number(sketch->svg, at[0]);
        g_string_append(sketch->svg, "\" cy=\"");
        svg_number(sketch->svg, at[1]);
        g_string_append_printf(sketch->svg, "\" r=\"%d\"/>\n", RADIUS);
    }
}

/* Arrows that push or pull at the line. */
static void add_arrows(struct sketch *sketch, const struct segment *segment, const char *class,
                       double dx, double dy)
{
    enum { APART = 34, LENGTH = 22, MOST = 9 };
    const int count = (int)fmin(segment_length(segment) / APART + 1, MOST);
    const double size = hypot(dx, dy);
    double at[2];
    if (!(size > 0))
        return;
    const double x = LENGTH * dx / size, y = LENGTH * dy / size;
    const bool out = x * segment->outward[0] + y * segment->outward[1] >= 0;
    for (int i = 0; i < count; i++) {
        point_on(segment, (i + 0.5) / count, 3, at);
        sketch_arrow(sketch, class, at[0] + (out ? x : 0), at[1] + (out ? y : 0), x, y);
    }
}

/* ------------------------------------------------------------------ velocities */

static bool is_free(const json_t *component)
{
    return g_strcmp0(json_string_value(component), "free") == 0;
}

static bool is_zero(const json_t *component)
{
    return json_is_number(component) && !(fabs(json_number_value(component)) > 0);
}

/* "fixed", "fixed in x", or the velocity. */
static char *velocity_text(const struct sketch *sketch, const json_t *velocity)
{
    const bool radial = region_is_radial(sketch->scene);
    const json_t *const x = json_array_get(velocity, 0), *const y = json_array_get(velocity, 1);
    if (is_zero(x) && is_zero(y))
        return g_strdup("fixed");
    if (is_zero(x) && is_free(y))
        return g_strdup(radial ? "fixed in r" : "fixed in x");
    if (is_free(x) && is_zero(y))
        return g_strdup(radial ? "fixed in z" : "fixed in y");
    char *unit = sketch_unit(sketch, "velocity"), *vector = sketch_vector(velocity, unit);
    char *text = g_strdup_printf("moves with velocity %s", vector);
    g_free(vector);
    g_free(unit);
    return text;
}

/* All nodes, or a rectangle of them, as far as it is near to the bodies; takes the text over. */
static void add_area(struct sketch *sketch, const json_t *region, char *what)
{
    enum { NEAR = 22 /* pixels */ };
    const struct svg_view *const view = &sketch->view;
    double low[2], high[2];
    if (!region_box(region, low, high)) {
        (void)sketch_entry(sketch, g_strdup_printf("all nodes: %s", what));
        g_free(what);
        return;
    }
    const unsigned number = sketch_entry(sketch, what);
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmax(low[axis], view->low[axis] - NEAR / view->scale);
        high[axis] = fmin(high[axis], view->high[axis] + NEAR / view->scale);
    }
    const double x = svg_x(view, low[0]), y = svg_y(view, high[1]);
    const double width = svg_x(view, high[0]) - x, height = svg_y(view, low[1]) - y;
    if (!(width > 0 && height > 0))
        return;
    g_string_append(sketch->svg, "<rect class=\"area\" x=\"");
    svg_number(sketch->svg, x);
    g_string_append(sketch->svg, "\" y=\"");
    svg_number(sketch->svg, y);
    g_string_append(sketch->svg, "\" width=\"");
    svg_number(sketch->svg, width);
    g_string_append(sketch->svg, "\" height=\"");
    svg_number(sketch->svg, height);
    g_string_append(sketch->svg, "\"/>\n");
    const double places[][2] = {{x - 14, y + height / 2},
                                {x + width + 14, y + height / 2},
                                {x + width / 2, y - 14},
                                {x + width / 2, y + height + 14},
                                {x + width / 2, y + height / 2}};
    sketch_mark(sketch, number, places, G_N_ELEMENTS(places));
}

static void add_boundary(struct sketch *sketch, const json_t *boundary)
{
    enum { AWAY = 24 };
    const json_t *const region = json_object_get(boundary, "region"), *const velocity =
                                                                          json_object_get(
                                                                              boundary, "velocity");
    const bool symmetric = json_is_true(json_object_get(boundary, "symmetry"));
    struct segment segment;
    const bool drawn = find_segment(sketch, region, &segment);
    char *what = symmetric ? g_strdup("plane of symmetry") : velocity_text(sketch, velocity);
    if (!drawn) {
        add_area(sketch, region, what);
        return;
    }
    const unsigned number = sketch_entry(sketch, what);
    svg_line(sketch->svg, symmetric ? "axis" : "held", segment.from[0], segment.from[1],
             segment.to[0], segment.to[1]);
    const json_t *const across = json_array_get(velocity, (size_t)segment.normal);
    const json_t *const along = json_array_get(velocity, (size_t)(1 - segment.normal));
    if (symmetric || (is_zero(across) && is_free(along)))
        add_rollers(sketch, &segment);
    else if (is_zero(across) && is_zero(along))
        add_hatches(sketch, &segment);
    else
        add_arrows(sketch, &segment, "moves", sketch_sign(json_array_get(velocity, 0)),
                   -sketch_sign(json_array_get(velocity, 1)));
    mark_segment(sketch, &segment, number, AWAY);
}

/* ------------------------------------------------------------------ transport */

static void add_condition(struct sketch *sketch, const char *scalar, const json_t *condition)
{
    enum { AWAY = 24 };
    const json_t *const region = json_object_get(condition, "region");
    struct segment segment;
    char *value = sketch_value(json_object_get(condition, "value"));
    char *text =
        g_strdup_printf("%s %s %s", scalar, value,
                        strcmp(scalar, "temperature") == 0
                            ? record_text(json_object_get(sketch->scene, "units"), "temperature")
                            : "");
    g_free(value);
    if (find_segment(sketch, region, &segment)) {
        svg_line(sketch->svg, "heat", segment.from[0], segment.from[1], segment.to[0],
                 segment.to[1]);
        mark_segment(sketch, &segment, sketch_entry(sketch, text), AWAY);
        return;
    }
    (void)sketch_entry(sketch, g_strdup_printf("nodes held at %s", text));
    g_free(text);
}

/* ------------------------------------------------------------------------ edges */

static const json_t *body_of(const struct sketch *sketch, const char *name)
{
    const json_t *const bodies = json_object_get(sketch->scene, "bodies");
    for (size_t i = 0; i < json_array_size(bodies); i++)
        if (strcmp(record_text(json_array_get(bodies, i), "name"), name) == 0)
            return json_array_get(bodies, i);
    return NULL;
}

static const char *const edge_names[] = {"bottom", "right", "top", "left"};

/* The edge of the box around a body; of round ones the point farthest out. */
static bool find_edge(const struct sketch *sketch, const json_t *region, size_t edge,
                      struct segment *segment)
{
    double low[2], high[2];
    if (!region_box(region, low, high))
        return false;
    const bool round = json_is_object(json_object_get(region, "disk")) ||
                       json_is_object(json_object_get(region, "annulus"));
    const int normal = edge % 2 == 0 ? 1 : 0;
    const bool upper = edge == 1 || edge == 2;
    double a[2] = {low[0], low[1]}, b[2] = {high[0], high[1]};
    a[normal] = b[normal] = upper ? high[normal] : low[normal];
    if (round)
        a[1 - normal] = b[1 - normal] = (low[1 - normal] + high[1 - normal]) / 2;
    *segment = (struct segment){
        .from = {svg_x(&sketch->view, a[0]), svg_y(&sketch->view, a[1])},
        .to = {svg_x(&sketch->view, b[0]), svg_y(&sketch->view, b[1])},
        .normal = normal,
    };
    segment->outward[0] = normal == 0 ? (upper ? 1 : -1) : 0;
    segment->outward[1] = normal == 1 ? (upper ? -1 : 1) : 0;
    return true;
}

/* A traction or flux on an edge of a body: `value` a vector, or a number into the body. */
static void add_edge_load(struct sketch *sketch, const char *what, const char *class,
                          const json_t *load)
{
    enum { AWAY = 38 };
    const json_t *const body = body_of(sketch, record_text(load, "body")), *const value =
                                                                               json_object_get(
                                                                                   load, "value");
    const char *const edge = record_text(load, "edge"), *const frame = record_text(load, "frame");
    const bool local = strcmp(frame, "edge") == 0;
    char *vector = json_is_array(value) ? sketch_vector(value, "") : sketch_value(value);
    const unsigned number = sketch_entry(
        sketch, g_strdup_printf("%s %s%s", what, vector, local ? ", normal and tangential" : ""));
    g_free(vector);
    for (size_t e = 0; e < G_N_ELEMENTS(edge_names); e++) {
        struct segment segment;
        if ((strcmp(edge, "all") != 0 && strcmp(edge, edge_names[e]) != 0) ||
            !find_edge(sketch, json_object_get(body, "region"), e, &segment))
            continue;
        const int first =
            json_is_array(value) ? sketch_sign(json_array_get(value, 0)) : -sketch_sign(value);
        const int second = json_is_array(value) ? sketch_sign(json_array_get(value, 1)) : 0;
        if (local || !json_is_array(value))
            add_arrows(sketch, &segment, class,
                       first * segment.outward[0] + second * segment.outward[1],
                       first * segment.outward[1] - second * segment.outward[0]);
        else
            add_arrows(sketch, &segment, class, first, -second);
        mark_segment(sketch, &segment, number, AWAY);
    }
}

static void add_scalar(struct sketch *sketch, const char *name)
{
    const json_t *const scalar = json_object_get(json_object_get(sketch->scene, "transport"), name);
    const json_t *const conditions = json_object_get(scalar, "conditions"), *const fluxes =
                                                                                json_object_get(
                                                                                    scalar,
                                                                                    "fluxes");
    char *what = g_strdup_printf("flux of %s", strcmp(name, "temperature") == 0 ? "heat" : name);
    for (size_t i = 0; i < json_array_size(conditions); i++)
        add_condition(sketch, name, json_array_get(conditions, i));
    for (size_t i = 0; i < json_array_size(fluxes); i++)
        add_edge_load(sketch, what, "heat", json_array_get(fluxes, i));
    g_free(what);
}

void sketch_conditions(struct sketch *sketch)
{
    const json_t *const boundaries = json_object_get(sketch->scene, "boundary");
    for (size_t i = 0; i < json_array_size(boundaries); i++)
        add_boundary(sketch, json_array_get(boundaries, i));
    add_scalar(sketch, "temperature");
    add_scalar(sketch, "concentration");
}

/* ------------------------------------------------------------------------ loads */

static void add_body_force(struct sketch *sketch, const json_t *force)
{
    enum { LENGTH = 30, RIGHT = 540, TOP = 12 };
    const int x = sketch_sign(json_array_get(force, 0)), y = sketch_sign(json_array_get(force, 1));
    if (x == 0 && y == 0)
        return;
    char *unit = sketch_unit(sketch, "acceleration"), *vector = sketch_vector(force, unit);
    const unsigned number = sketch_entry(sketch, g_strdup_printf("body force per mass %s", vector));
    const double size = hypot(x, y), dx = LENGTH * x / size, dy = -LENGTH * y / size;
    const double at[2] = {RIGHT - LENGTH / 2.0, TOP + LENGTH / 2.0};
    sketch_arrow(sketch, "load", at[0] + dx / 2, at[1] + dy / 2, dx, dy);
    const double places[][2] = {{at[0] - 30, at[1]}, {at[0] - 54, at[1]}};
    sketch_mark(sketch, number, places, G_N_ELEMENTS(places));
    g_free(vector);
    g_free(unit);
}

void sketch_loads(struct sketch *sketch)
{
    const json_t *const loads = json_object_get(sketch->scene, "loads");
    static const struct {
        const char *key, *what;
    } lists[] = {{"tractions", "traction"}, {"particle_forces", "force on the edge's particles"}};
    for (size_t k = 0; k < G_N_ELEMENTS(lists); k++) {
        const json_t *const list = json_object_get(loads, lists[k].key);
        for (size_t i = 0; i < json_array_size(list); i++)
            add_edge_load(sketch, lists[k].what, "load", json_array_get(list, i));
    }
    add_body_force(sketch, json_object_get(loads, "body_force"));
}
