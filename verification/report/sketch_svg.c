/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/sketch_svg.h"

#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/report/picture_file.h"
#include "verification/report/picture_svg.h"
#include "verification/report/region_svg.h"
#include "verification/report/sketch.h"

#include <math.h>
#include <string.h>

/* ---------------------------------------------------------------------- texts */

char *sketch_value(const json_t *value)
{
    if (json_is_number(value))
        return svg_value_text(json_number_value(value));
    return g_strdup(json_is_string(value) ? json_string_value(value) : "?");
}

char *sketch_vector(const json_t *vector, const char *unit)
{
    char *parts[2];
    for (size_t i = 0; i < 2; i++)
        parts[i] = sketch_value(json_array_get(vector, i));
    char *text =
        g_strdup_printf("(%s, %s)%s%s", parts[0], parts[1], *unit == '\0' ? "" : " ", unit);
    g_free(parts[0]);
    g_free(parts[1]);
    return text;
}

int sketch_sign(const json_t *component)
{
    const double number = json_number_value(component);
    const char *const text = json_string_value(component);
    if (json_is_number(component))
        return (number > 0) - (number < 0);
    return text == NULL || strcmp(text, "free") == 0 ? 0 : *text == '-' ? -1 : 1;
}

char *sketch_unit(const struct sketch *sketch, const char *what)
{
    const json_t *const units = json_object_get(sketch->scene, "units");
    const char *const length = record_text(units, "length"), *const time =
                                                                 record_text(units, "time");
    if (*length == '\0' || *time == '\0')
        return g_strdup("");
    return strcmp(what, "length") == 0     ? g_strdup(length)
           : strcmp(what, "velocity") == 0 ? g_strdup_printf("%s/%s", length, time)
                                           : g_strdup_printf("%s/%s²", length, time);
}

unsigned sketch_entry(struct sketch *sketch, char *text)
{
    for (unsigned i = 0; i < sketch->entries->len; i++)
        if (strcmp(sketch->entries->pdata[i], text) == 0) {
            g_free(text);
            return i + 1;
        }
    g_ptr_array_add(sketch->entries, text);
    return sketch->entries->len;
}

/* ---------------------------------------------------------------------- marks */

enum { WIDTH = 560, LEFT = 84, RIGHT = 56, TOP = 62 };

static bool is_free(const struct sketch *sketch, double x, double y)
{
    for (unsigned i = 0; i < sketch->taken->len; i++) {
        const struct sketch_mark *const mark = &g_array_index(sketch->taken, struct sketch_mark, i);
        if (hypot(mark->x - x, mark->y - y) < 2 * SKETCH_MARK + 2)
            return false;
    }
    return x > SKETCH_MARK && x < WIDTH - SKETCH_MARK && y > SKETCH_MARK;
}

void sketch_mark(struct sketch *sketch, unsigned number, const double (*places)[2], size_t count)
{
    size_t place = 0;
    while (place < count && !is_free(sketch, places[place][0], places[place][1]))
        place++;
    if (place == count)
        return; /* the legend states it still */
    const struct sketch_mark mark = {places[place][0], places[place][1]};
    g_array_append_val(sketch->taken, mark);
    g_string_append(sketch->marks, "<circle class=\"mark\" cx=\"");
    svg_number(sketch->marks, mark.x);
    g_string_append(sketch->marks, "\" cy=\"");
    svg_number(sketch->marks, mark.y);
    g_string_append_printf(sketch->marks, "\" r=\"%d\"/>\n", SKETCH_MARK);
    char *text = g_strdup_printf("%u", number);
    svg_text(sketch->marks, mark.x, mark.y + 4.5, "middle", "", text);
    g_free(text);
}

void sketch_arrow(struct sketch *sketch, const char *class, double x, double y, double dx,
                  double dy)
{
    const double length = hypot(dx, dy), along = 7, across = 3.5;
    if (!(length > 0))
        return;
    const double ux = dx / length, uy = dy / length;
    svg_line(sketch->svg, class, x - dx, y - dy, x - 4 * ux, y - 4 * uy);
    g_string_append_printf(sketch->svg, "<path class=\"%s head\" d=\"M", class);
    svg_number(sketch->svg, x);
    g_string_append_c(sketch->svg, ' ');
    svg_number(sketch->svg, y);
    for (int side = 1; side >= -1; side -= 2) {
        g_string_append_c(sketch->svg, 'L');
        svg_number(sketch->svg, x - along * ux + side * across * uy);
        g_string_append_c(sketch->svg, ' ');
        svg_number(sketch->svg, y - along * uy - side * across * ux);
    }
    g_string_append(sketch->svg, "z\"/>\n");
}

/* ---------------------------------------------------------------------- bodies */

static char *region_text(const json_t *region, const char *unit)
{
    double low[2], high[2];
    const char *const gap = *unit == '\0' ? "" : " ";
    const json_t *const disk = json_object_get(region, "disk"), *const ring = json_object_get(
                                                                    region, "annulus");
    if (!region_box(region, low, high))
        return g_strdup("");
    const double width = high[0] - low[0], height = high[1] - low[1];
    char *centre = sketch_vector(json_object_get(json_is_object(disk) ? disk : ring, "center"), "");
    char *text =
        json_is_object(disk)
            ? g_strdup_printf("disk of radius %g%s%s about %s", width / 2, gap, unit, centre)
        : json_is_object(ring)
            ? g_strdup_printf("ring of radii %g and %g%s%s about %s", record_number(ring, "inner"),
                              width / 2, gap, unit, centre)
            : g_strdup_printf("%s, %g by %g%s%s",
                              json_is_object(json_object_get(region, "polygon")) ? "polygon"
                                                                                 : "rectangle",
                              width, height, gap, unit);
    g_free(centre);
    return text;
}

static const json_t *material_of(const json_t *scene, const char *name, size_t *index)
{
    const json_t *const materials = json_object_get(scene, "materials");
    for (*index = 0; *index < json_array_size(materials); (*index)++)
        if (strcmp(record_text(json_array_get(materials, *index), "name"), name) == 0)
            return json_array_get(materials, *index);
    return NULL;
}

static const json_t *body_velocity(const json_t *body)
{
    const json_t *const rigid = json_object_get(body, "rigid");
    return json_object_get(json_is_object(rigid) ? rigid : body, "velocity");
}

static char *body_text(const struct sketch *sketch, const json_t *body)
{
    const json_t *const velocity = body_velocity(body);
    const bool rigid = json_is_object(json_object_get(body, "rigid"));
    const char *const material = record_text(body, "material");
    size_t index;
    char *length = sketch_unit(sketch, "length"), *speed = sketch_unit(sketch, "velocity");
    char *shape = region_text(json_object_get(body, "region"), length);
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "%s: ", record_text(body, "name"));
    if (rigid)
        g_string_append(text, "rigid");
    else
        g_string_append_printf(text, "%s, law %s", material,
                               record_text(material_of(sketch->scene, material, &index), "law"));
    g_string_append_printf(text, "; %s", shape);
    const bool moves = rigid || sketch_sign(json_array_get(velocity, 0)) != 0 ||
                       sketch_sign(json_array_get(velocity, 1)) != 0;
    if (json_array_size(velocity) == 2 && moves) {
        char *vector = sketch_vector(velocity, speed);
        g_string_append_printf(text, "; %s %s", rigid ? "velocity" : "velocity at the start",
                               vector);
        g_free(vector);
    }
    g_free(shape);
    g_free(length);
    g_free(speed);
    return g_string_free(text, FALSE);
}

/* Where the body moves to at the start, if its velocity is the same everywhere. */
static void add_velocity(struct sketch *sketch, const json_t *body, double x, double y)
{
    enum { LENGTH = 34 };
    const json_t *const velocity = body_velocity(body);
    double v[2];
    const double size = picture_point(velocity, v) ? hypot(v[0], v[1]) : 0;
    if (size > 0)
        sketch_arrow(sketch, "moves", x + (LENGTH + 14) * v[0] / size,
                     y - (LENGTH + 14) * v[1] / size, LENGTH * v[0] / size, -LENGTH * v[1] / size);
}

/* Inside the body, off its middle, where arrows and cracks often are; beside one that is small. */
static void mark_body(struct sketch *sketch, unsigned number, const double centre[2],
                      const double low[2], const double high[2])
{
    const double x = centre[0], y = centre[1];
    const double wide = sketch->view.scale * (high[0] - low[0]) / 2,
                 tall = sketch->view.scale * (high[1] - low[1]) / 2;
    const bool fits = wide > SKETCH_MARK && tall > SKETCH_MARK;
    const double down = fits ? fmax(tall - 2 * SKETCH_MARK, 0) * 0.6 : tall + SKETCH_MARK + 4,
                 aside = fits ? fmax(wide - 2 * SKETCH_MARK, 0) * 0.6 : wide + SKETCH_MARK + 4;
    const double places[][2] = {{x, y + down},         {x - aside, y},        {x + aside, y},
                                {x, y - down},         {x - 24, y + down},    {x + 24, y + down},
                                {x - aside, y - down}, {x + aside, y + down}, {x, y}};
    sketch_mark(sketch, number, places, G_N_ELEMENTS(places));
}

static void add_body(struct sketch *sketch, const json_t *body)
{
    static const char *const colours[] = {"#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d55e00"};
    const json_t *const region = json_object_get(body, "region");
    double low[2], high[2];
    size_t material = 0;
    char attributes[96] = "class=\"body\" clip-path=\"url(#seen)\" fill=\"url(#rigid)\"";
    if (!region_box(region, low, high))
        return;
    if (region_is_radial(sketch->scene))
        low[0] = fmax(low[0], 0);
    if (!json_is_object(json_object_get(body, "rigid"))) {
        (void)material_of(sketch->scene, record_text(body, "material"), &material);
        g_snprintf(attributes, sizeof attributes,
                   "class=\"body solid\" clip-path=\"url(#seen)\" fill=\"%s\"",
                   colours[material % G_N_ELEMENTS(colours)]);
    }
    region_path(sketch->svg, &sketch->view, region, attributes);
    const unsigned number = sketch_entry(sketch, body_text(sketch, body));
    double centre[2] = {svg_x(&sketch->view, (low[0] + high[0]) / 2),
                        svg_y(&sketch->view, (low[1] + high[1]) / 2)};
    if (json_is_object(json_object_get(region, "annulus"))) /* its middle is empty */
        centre[0] +=
            sketch->view.scale * ((high[0] - low[0]) / 4 +
                                  record_number(json_object_get(region, "annulus"), "inner") / 2);
    add_velocity(sketch, body, centre[0], centre[1]);
    mark_body(sketch, number, centre, low, high);
}

/* ---------------------------------------------------------------------- cracks */

static void add_crack(struct sketch *sketch, const json_t *crack)
{
    const json_t *const points = json_object_get(crack, "points");
    double last[2] = {0, 0};
    GString *path = g_string_new(NULL);
    for (size_t i = 0; i < json_array_size(points); i++) {
        double point[2];
        if (!picture_point(json_array_get(points, i), point))
            continue;
        last[0] = svg_x(&sketch->view, point[0]);
        last[1] = svg_y(&sketch->view, point[1]);
        g_string_append(path, path->len == 0 ? "M" : "L");
        svg_number(path, last[0]);
        g_string_append_c(path, ' ');
        svg_number(path, last[1]);
    }
    g_string_append_printf(
        sketch->svg, "<path class=\"fissure\" clip-path=\"url(#near)\" d=\"%s\"/>\n", path->str);
    g_string_free(path, TRUE);
    const json_t *const law = json_object_get(crack, "cohesive");
    const char *const contact = record_text(crack, "contact");
    char *text = g_strdup_printf("crack%s%s%s%s", *contact == '\0' ? "" : ", contact ", contact,
                                 json_is_object(law) ? ", cohesive law " : "",
                                 json_is_object(law) ? record_text(law, "law") : "");
    last[0] = fmin(fmax(last[0], sketch->view.left), sketch->view.left + svg_width(&sketch->view));
    last[1] = fmin(fmax(last[1], sketch->view.top), sketch->view.top + svg_height(&sketch->view));
    const double places[][2] = {{last[0] + 16, last[1] - 14},
                                {last[0] + 16, last[1] + 14},
                                {last[0] - 16, last[1] - 14},
                                {last[0] - 16, last[1] + 14},
                                {last[0] + 40, last[1] - 14}};
    sketch_mark(sketch, sketch_entry(sketch, text), places, G_N_ELEMENTS(places));
}

/* ----------------------------------------------------------------------- whole */

static const char look[] =
    ".body{stroke:currentColor;stroke-width:1.2}.solid{fill-opacity:.4}"
    ".grid{stroke:currentColor;stroke-width:.5;opacity:.22}"
    ".axis{stroke:currentColor;stroke-dasharray:12 4 2 4;stroke-width:1.2;fill:none}"
    ".measure{stroke:currentColor;fill:none;stroke-width:1}"
    ".moves{stroke:#0072b2;fill:none;stroke-width:2.2}.load{stroke:#c04a00;fill:none;stroke-width:"
    "1.8}"
    ".heat{stroke:#a8326e;fill:none;stroke-width:1.8}"
    ".held{stroke:currentColor;fill:none;stroke-width:2}"
    ".hatch{stroke:currentColor;fill:none;stroke-width:.9}"
    ".area{fill:url(#rigid);fill-opacity:.6;stroke:currentColor;stroke-dasharray:4 3}"
    ".head{stroke:none}.measure.head,.held.head{fill:currentColor}.moves.head{fill:#0072b2}"
    ".load.head{fill:#c04a00}.heat.head{fill:#a8326e}"
    ".fissure{stroke:#b3261e;fill:none;stroke-width:3}"
    ".mark{fill:#fff;stroke:currentColor;stroke-width:1}"
    "@media(prefers-color-scheme:dark){.mark{fill:#15181c}.moves{stroke:#6fc1f0}"
    ".moves.head{fill:#6fc1f0}.load{stroke:#ff9457}.load.head{fill:#ff9457}"
    ".heat{stroke:#f08cc0}.heat.head{fill:#f08cc0}.fissure{stroke:#ff7a70}.head{stroke:none}}";

static void find_view(struct sketch *sketch, double low[2], double high[2])
{
    enum { TALLEST = 380, THIN = 50, LOWER = 24 };
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    region_bounds(sketch->scene, low, high);
    if (!(low[0] < high[0] && low[1] < high[1])) {
        low[0] = low[1] = 0;
        high[0] = high[1] = 1;
    }
    for (int axis = 0; axis < 2; axis++)
        sketch->centre[axis] = (low[axis] + high[axis]) / 2;
    sketch->view = svg_view_of(low, high, LEFT, TOP, WIDTH - LEFT - RIGHT, TALLEST);
    if (svg_height(&sketch->view) < THIN)
        sketch->view.top += LOWER; /* its height is stated beside the names of the axes else */
}

static void add_legend(const struct sketch *sketch, GString *legend)
{
    const json_t *const grid = json_object_get(sketch->scene, "grid"), *const units =
                                                                           json_object_get(
                                                                               sketch->scene,
                                                                               "units");
    const double refine = record_number(grid, "refine");
    g_string_append(legend, "<ul class=\"about\">");
    for (unsigned i = 0; i < sketch->entries->len; i++) {
        char *number = g_strdup_printf("%u", i + 1);
        text_markup(legend, "<li><b>%s</b> %s</li>", number,
                    (const char *)sketch->entries->pdata[i]);
        g_free(number);
    }
    char *cells[2];
    for (size_t i = 0; i < 2; i++)
        cells[i] = svg_value_text(
            (double)(float)(json_number_value(json_array_get(json_object_get(grid, "cell"), i)) /
                            refine));
    static const char *const names[][2] = {{"plane_strain", "Plane strain"},
                                           {"plane_stress", "Plane stress"},
                                           {"axisymmetric", "Axisymmetric"}};
    const char *geometry = record_text(sketch->scene, "geometry");
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        if (strcmp(geometry, names[i][0]) == 0)
            geometry = names[i][1];
    text_markup(legend, "<li>%s; cells of %s by %s %s</li></ul>", geometry, cells[0], cells[1],
                record_text(units, "length"));
    g_free(cells[0]);
    g_free(cells[1]);
}

static void add_parts(struct sketch *sketch)
{
    const json_t *const bodies = json_object_get(sketch->scene, "bodies"), *const cracks =
                                                                               json_object_get(
                                                                                   sketch->scene,
                                                                                   "cracks");
    for (size_t i = 0; i < json_array_size(bodies); i++)
        add_body(sketch, json_array_get(bodies, i));
    sketch_grid(sketch);
    for (size_t i = 0; i < json_array_size(cracks); i++)
        add_crack(sketch, json_array_get(cracks, i));
    sketch_conditions(sketch);
    sketch_loads(sketch);
}

/* The head of the picture, once it is known how far it reaches down. */
static void begin(GString *svg, const struct sketch *sketch, const char *title)
{
    enum { BELOW = 30, NEAR = 12 /* cracks are cut there */ };
    const struct svg_view *const view = &sketch->view;
    svg_begin(svg, WIDTH, view->top + svg_height(view) + sketch_dimension_away(sketch, 0) + BELOW,
              "free", title, "What the numbers are is in the list below.", look);
    if (region_is_radial(sketch->scene))
        region_clip(svg, view);
    g_string_append_printf(svg,
                           "<clipPath id=\"near\"><rect x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" "
                           "height=\"%.0f\"/></clipPath>\n",
                           view->left - NEAR, view->top - NEAR, svg_width(view) + 2 * NEAR,
                           svg_height(view) + 2 * NEAR);
    g_string_append(svg, "<defs><pattern id=\"rigid\" width=\"7\" height=\"7\" "
                         "patternUnits=\"userSpaceOnUse\"><path d=\"M0 7L7 0\" class=\"hatch\"/>"
                         "</pattern></defs>\n");
}

char *sketch_svg(const json_t *scene, const char *title, GString *legend)
{
    double low[2], high[2];
    struct sketch sketch = {.scene = scene,
                            .svg = g_string_new(NULL),
                            .marks = g_string_new(NULL),
                            .entries = g_ptr_array_new_with_free_func(g_free),
                            .taken = g_array_new(FALSE, FALSE, sizeof(struct sketch_mark))};
    find_view(&sketch, low, high);
    sketch_take_corner(&sketch);
    add_parts(&sketch);
    for (int axis = 0; axis < 2; axis++)
        sketch_dimension(&sketch, axis, low[axis], high[axis]);
    sketch_axes(&sketch);
    GString *whole = g_string_new(NULL);
    begin(whole, &sketch, title);
    g_string_append(whole, sketch.svg->str);
    g_string_append(whole, sketch.marks->str);
    svg_end(whole);
    add_legend(&sketch, legend);
    g_string_free(sketch.svg, TRUE);
    g_string_free(sketch.marks, TRUE);
    g_ptr_array_unref(sketch.entries);
    g_array_unref(sketch.taken);
    return g_string_free(whole, FALSE);
}
