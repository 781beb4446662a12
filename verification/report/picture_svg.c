/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/picture_svg.h"

#include "verification/common/record.h"
#include "verification/common/text.h"
#include "verification/pages/colours.h"
#include "verification/pages/svg.h"
#include "verification/report/region_svg.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

enum { LEVELS = 64, FINE = 10 /* parts of a pixel */ };

struct colour_range {
    double low, high;
    bool diverging, below, above; /* are there values beyond its ends? */
};

/* A picture being drawn. */
struct drawing {
    const struct picture_file *file;
    const struct picture_states *states;
    struct svg_view view;
    struct colour_range range;
    GString *svg;
    bool small;    /* what is there now alone, not the bodies at the start */
    bool outlined; /* few enough particles to see the domains of each */
};

/* -------------------------------------------------------------------- colours */

static bool is_rigid(const struct picture_file *file, size_t body)
{
    const json_t *const bodies = json_object_get(file->scene, "bodies");
    return json_is_object(json_object_get(json_array_get(bodies, body), "rigid"));
}

/* The values of all frames that have a colour, sorted. */
static GArray *sorted_values(const struct picture_file *file, const struct picture_states *states)
{
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    for (size_t i = 0; i < states->frame_count; i++)
        for (size_t p = 0; p < states->count; p++)
            if (isfinite(states->frames[i].value[p]) && !is_rigid(file, states->body[p]))
                g_array_append_val(values, states->frames[i].value[p]);
    gsl_sort((double *)(void *)values->data, 1, values->len);
    return values;
}

/* From the least to the largest value, but for single ones far off: then from the hundredth part to
 * the last but one. A signed field with both signs is white at zero. */
static struct colour_range range_of(const struct picture_file *file,
                                    const struct picture_states *states)
{
    enum { PART = 100, FAR = 2 };
    GArray *values = sorted_values(file, states);
    struct colour_range range = {.high = 1};
    if (values->len > 0) {
        const double *const v = (const double *)values->data;
        const unsigned last = values->len - 1, few = values->len / PART;
        const double most = v[last] - v[0], usual = v[last - few] - v[few];
        range = (struct colour_range){.low = v[0], .high = v[last]};
        if (usual > 0 && most > FAR * usual) {
            range.low = v[few];
            range.high = v[last - few];
        }
        if (file->is_signed && range.low < 0 && range.high > 0 &&
            fmin(-range.low, range.high) > 0.1 * fmax(-range.low, range.high)) {
            range.high = fmax(-range.low, range.high);
            range.low = -range.high;
            range.diverging = true;
        }
        range.below = v[0] < range.low;
        range.above = v[last] > range.high;
    }
    g_array_unref(values);
    return range;
}

static bool is_uniform(const struct colour_range *range)
{
    return !(range->high - range->low > 1e-6 * fmax(fabs(range->high), fabs(range->low)));
}

static double place_of(const struct colour_range *range, double value)
{
    return is_uniform(range) ? 0.5 : (value - range->low) / (range->high - range->low);
}

/* ------------------------------------------------------------------ particles */

/* Centre and half the domain's two vectors as they are drawn. */
struct domain {
    double centre[2], a[2], b[2];
};

static struct domain domain_of(const struct drawing *drawing, const struct picture_frame *frame,
                               size_t p)
{
    const struct picture_states *const states = drawing->states;
    const double *const half = &states->half[2 * states->body[p]], *const g = &frame->g[4 * p];
    const double m = drawing->file->magnify;
    const double f[4] = {1 + m * g[0], m * g[1], m * g[2], 1 + m * g[3]};
    return (struct domain){
        .centre = {states->start[2 * p] + m * frame->u[2 * p],
                   states->start[2 * p + 1] + m * frame->u[2 * p + 1]},
        .a = {f[0] * half[0], f[2] * half[0]},
        .b = {f[1] * half[1], f[3] * half[1]},
    };
}

static long fine(double pixels)
{
    return lround(FINE * fmin(fmax(pixels, -1e5), 1e5));
}

/* In parts of a pixel, so that the corners of neighbours meet. */
static void add_domain(const struct drawing *drawing, const struct domain *d, GString *path)
{
    static const int signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    long at[2] = {0, 0};
    for (int corner = 0; corner < 4; corner++) {
        const double x = d->centre[0] + signs[corner][0] * d->a[0] + signs[corner][1] * d->b[0];
        const double y = d->centre[1] + signs[corner][0] * d->a[1] + signs[corner][1] * d->b[1];
        const long to[2] = {fine(svg_x(&drawing->view, x) - drawing->view.left),
                            fine(svg_y(&drawing->view, y) - drawing->view.top)};
        g_string_append_printf(path, "%s%ld %ld",
                               corner == 0   ? "M"
                               : corner == 1 ? "l"
                                             : " ",
                               to[0] - at[0], to[1] - at[1]);
        at[0] = to[0];
        at[1] = to[1];
    }
    g_string_append_c(path, 'z');
}

/* One path for each level of colour; those without a colour, of rigid bodies, come first. */
static void add_particles(const struct drawing *drawing, const struct picture_frame *frame)
{
    GString *paths[LEVELS + 1];
    for (int level = 0; level <= LEVELS; level++)
        paths[level] = g_string_new(NULL);
    for (size_t p = 0; p < drawing->states->count; p++) {
        const struct domain domain = domain_of(drawing, frame, p);
        int level = LEVELS;
        if (isfinite(frame->value[p]) && !is_rigid(drawing->file, drawing->states->body[p]))
            level =
                (int)fmin(fmax(LEVELS * place_of(&drawing->range, frame->value[p]), 0), LEVELS - 1);
        add_domain(drawing, &domain, paths[level]);
    }
    for (int i = 0; i <= LEVELS; i++) {
        const int level = i == 0 ? LEVELS : i - 1;
        char colour[COLOUR_SIZE] = "#8b9199";
        if (level < LEVELS)
            colour_at((level + 0.5) / LEVELS, drawing->range.diverging, colour);
        if (paths[level]->len > 0)
            g_string_append_printf(drawing->svg, "<path fill=\"%s\"%s%s%s d=\"%s\"/>\n", colour,
                                   drawing->outlined ? "" : " stroke=\"",
                                   drawing->outlined ? "" : colour, drawing->outlined ? "" : "\"",
                                   paths[level]->str);
        g_string_free(paths[level], TRUE);
    }
}

static void add_crack(const struct drawing *drawing, const json_t *crack, const char *class)
{
    const size_t count = json_array_size(crack) / 2;
    if (count < 2)
        return;
    g_string_append_printf(drawing->svg, "<path class=\"%s\" d=\"", class);
    for (size_t i = 0; i < count; i++) {
        const double x = json_number_value(json_array_get(crack, 2 * i)),
                     y = json_number_value(json_array_get(crack, 2 * i + 1));
        g_string_append_printf(drawing->svg, "%s%ld %ld", i == 0 ? "M" : "L",
                               fine(svg_x(&drawing->view, x) - drawing->view.left),
                               fine(svg_y(&drawing->view, y) - drawing->view.top));
    }
    g_string_append(drawing->svg, "\"/>\n");
}

/* Cracks may reach beyond the bodies. */
static void add_clip(const struct drawing *drawing)
{
    g_string_append_printf(
        drawing->svg, "<clipPath id=\"view\"><rect width=\"%ld\" height=\"%ld\"/></clipPath>\n",
        fine(svg_width(&drawing->view)), fine(svg_height(&drawing->view)));
}

static void add_frame(const struct drawing *drawing, const struct picture_frame *frame)
{
    g_string_append(drawing->svg, "<g transform=\"translate(");
    svg_number(drawing->svg, drawing->view.left);
    g_string_append_c(drawing->svg, ' ');
    svg_number(drawing->svg, drawing->view.top);
    g_string_append_printf(drawing->svg, ") scale(%g)\" clip-path=\"url(#view)\" class=\"%s\">\n",
                           1.0 / FINE, drawing->outlined ? "outlined" : "plain");
    add_particles(drawing, frame);
    /* displacements that are drawn larger leave the points of cracks behind */
    for (size_t i = 0; drawing->file->magnify <= 1 && i < json_array_size(frame->cracks); i++) {
        add_crack(drawing, json_array_get(frame->cracks, i), "halo");
        add_crack(drawing, json_array_get(frame->cracks, i), "crack");
    }
    g_string_append(drawing->svg, "</g>\n");
}

/* ----------------------------------------------------------------------- view */

static void widen(double low[2], double high[2], double x, double y)
{
    const double at[2] = {x, y};
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmin(low[axis], at[axis]);
        high[axis] = fmax(high[axis], at[axis]);
    }
}

/* All domains of all frames, and a margin. */
static void find_bounds(const struct drawing *drawing, double low[2], double high[2])
{
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    for (size_t i = 0; i < drawing->states->frame_count; i++)
        for (size_t p = 0; p < drawing->states->count; p++) {
            const struct domain d = domain_of(drawing, &drawing->states->frames[i], p);
            const double x = fabs(d.a[0]) + fabs(d.b[0]), y = fabs(d.a[1]) + fabs(d.b[1]);
            widen(low, high, d.centre[0] - x, d.centre[1] - y);
            widen(low, high, d.centre[0] + x, d.centre[1] + y);
        }
    if (!drawing->small)
        region_bounds(drawing->file->scene, low, high);
    const double size = fmax(high[0] - low[0], high[1] - low[1]);
    const double margin = size > 0 ? 0.03 * size : 1;
    for (int axis = 0; axis < 2; axis++) {
        low[axis] -= margin;
        high[axis] += margin;
    }
    if (region_is_radial(drawing->file->scene))
        low[0] = fmax(low[0], -0.2 * margin);
}

void picture_axis_names(const json_t *scene, char *names[2])
{
    const bool radial = region_is_radial(scene);
    const char *const unit = record_text(json_object_get(scene, "units"), "length");
    for (int axis = 0; axis < 2; axis++)
        names[axis] = g_strdup_printf("%c%s%s", (radial ? "rz" : "xy")[axis],
                                      *unit == '\0' ? "" : " / ", unit);
}

/* ----------------------------------------------------------------- colour bar */

static char *field_name(const struct picture_file *file)
{
    return g_strdup_printf("%s%s%s", file->title, strcmp(file->unit, "1") == 0 ? "" : " / ",
                           strcmp(file->unit, "1") == 0 ? "" : file->unit);
}

static void add_end(GString *svg, double x, double y, double reach, double height,
                    const char *colour)
{
    g_string_append(svg, "<path d=\"M");
    svg_number(svg, x);
    g_string_append_c(svg, ' ');
    svg_number(svg, y);
    g_string_append_printf(svg, "l%.1f %.1fL", reach, height / 2);
    svg_number(svg, x);
    g_string_append_c(svg, ' ');
    svg_number(svg, y + height);
    g_string_append_printf(svg, "z\" fill=\"%s\"/>\n", colour);
}

/* Between numbers, so that they have room: as many as fit, at most 8. */
static double bar_step(const struct colour_range *range, double width)
{
    enum { MOST = 8, LETTER = 8, GAP = 14 };
    const double largest = fmax(fabs(range->low), fabs(range->high));
    double step = 0;
    bool fits = false;
    for (int most = MOST; most > 0 && !fits; most--) {
        step = svg_step(range->high - range->low, most);
        char *low = svg_tic_text(step * ceil(range->low / step), step, largest);
        char *high = svg_tic_text(step * floor(range->high / step), step, largest);
        const glong letters = MAX(g_utf8_strlen(low, -1), g_utf8_strlen(high, -1));
        fits = width * step / (range->high - range->low) > (double)letters * LETTER + GAP;
        g_free(high);
        g_free(low);
    }
    return step;
}

/* The bar, its ends pointed where values lie beyond, and its numbers. */
static void add_bar(const struct drawing *drawing, double left, double top, double width)
{
    enum { HEIGHT = 12, POINT = 9 };
    GString *svg = drawing->svg;
    const struct colour_range *const range = &drawing->range;
    char colour[COLOUR_SIZE];
    for (int level = 0; level < LEVELS; level++) {
        colour_at((level + 0.5) / LEVELS, range->diverging, colour);
        g_string_append(svg, "<rect x=\"");
        svg_number(svg, left + width * level / LEVELS);
        g_string_append_printf(svg,
                               "\" y=\"%.1f\" width=\"%.1f\" height=\"%d\" fill=\"%s\" "
                               "shape-rendering=\"crispEdges\"/>\n",
                               top, width / LEVELS + 0.4, HEIGHT, colour);
    }
    colour_at(0, range->diverging, colour);
    if (range->below)
        add_end(svg, left, top, -POINT, HEIGHT, colour);
    colour_at(1, range->diverging, colour);
    if (range->above)
        add_end(svg, left + width, top, POINT, HEIGHT, colour);
    const double step = bar_step(range, width);
    for (double k = ceil(range->low / step - 1e-6); k * step <= range->high + 1e-6 * step; k++) {
        char *text = svg_tic_text(k * step, step, fmax(fabs(range->low), fabs(range->high)));
        const double x = left + width * place_of(range, k * step);
        svg_line(svg, "line", x, top + HEIGHT, x, top + HEIGHT + 4);
        svg_text(svg, x, top + HEIGHT + 17, "middle", "", text);
        g_free(text);
    }
}

static void add_key(const struct drawing *drawing, double left, double width)
{
    char *name = field_name(drawing->file);
    if (is_uniform(&drawing->range)) {
        char *value = svg_value_text(drawing->range.high);
        char *text = g_strdup_printf("%s: %s everywhere", name, value);
        svg_text(drawing->svg, left, 20, "start", "", text);
        g_free(text);
        g_free(value);
    } else {
        svg_text(drawing->svg, left, 20, "start", "", name);
        add_bar(drawing, left + 18, 32, width - 36);
    }
    g_free(name);
}

/* --------------------------------------------------------------------- whole */

enum { WIDTH = 560, LEFT = 76, RIGHT = 22, TOP = 84, BOTTOM = 46, TALLEST = 400 };
enum { TOP_PLAIN = 38 /* without a colour bar */ };

static const char look[] =
    ".plain{stroke-width:6}.outlined{stroke:#000;stroke-opacity:.35;stroke-width:4}"
    ".halo{fill:none;stroke:#fff;stroke-opacity:1;stroke-width:42}"
    ".crack{fill:none;stroke:#000;stroke-opacity:1;stroke-width:18}"
    ".before{fill:none;stroke:currentColor;stroke-width:1;stroke-dasharray:5 4}"
    ".axis{stroke:currentColor;stroke-dasharray:12 4 2 4;stroke-width:1.2}";

/* Are the domains so large that their outlines leave most of them to see? */
static bool has_large_domains(const struct drawing *drawing)
{
    enum { LEAST = 5 /* pixels */ };
    for (size_t i = 0; i < 2 * drawing->file->body_count; i++)
        if (2 * drawing->states->half[i] * drawing->view.scale < LEAST)
            return false;
    return true;
}

static void begin(struct drawing *drawing, const char *title, const char *description,
                  const char *style)
{
    enum { OUTLINED_MAX = 1500 };
    double low[2], high[2];
    drawing->svg = g_string_new(NULL);
    drawing->range = range_of(drawing->file, drawing->states);
    find_bounds(drawing, low, high);
    const double top = is_uniform(&drawing->range) ? TOP_PLAIN : TOP;
    drawing->view = svg_view_of(low, high, LEFT, top, WIDTH - LEFT - RIGHT, TALLEST);
    drawing->outlined = drawing->states->count <= OUTLINED_MAX && has_large_domains(drawing);
    svg_begin(drawing->svg, WIDTH, top + svg_height(&drawing->view) + BOTTOM, "plot", title,
              description, style);
    add_clip(drawing);
    add_key(drawing, LEFT, WIDTH - LEFT - RIGHT);
}

static void add_surroundings(struct drawing *drawing)
{
    char *names[2];
    picture_axis_names(drawing->file->scene, names);
    svg_axes(drawing->svg, &drawing->view, names);
    for (int axis = 0; axis < 2; axis++)
        g_free(names[axis]);
}

static char *time_text(const struct picture_file *file, double time)
{
    const char *const unit = record_text(json_object_get(file->scene, "units"), "time");
    char *value = svg_value_text(time);
    char *text = g_strdup_printf("t = %s%s%s", value, *unit == '\0' ? "" : " ", unit);
    g_free(value);
    return text;
}

/* In the upper right corner, above the view. */
static void add_time(const struct drawing *drawing, double time)
{
    char *text = time_text(drawing->file, time);
    svg_text(drawing->svg, WIDTH - RIGHT, 20, "end", "soft", text);
    g_free(text);
}

char *picture_still_svg(const struct picture_file *file, const char *title, const char *description)
{
    struct drawing drawing = {.file = file, .states = &file->still};
    begin(&drawing, title, description, look);
    const struct picture_frame *const last = &file->still.frames[file->still.frame_count - 1];
    add_time(&drawing, last->time);
    add_frame(&drawing, last);
    region_outlines(drawing.svg, &drawing.view, drawing.file->scene);
    add_surroundings(&drawing);
    svg_end(drawing.svg);
    return g_string_free(drawing.svg, FALSE);
}

/* ---------------------------------------------------------------------- motion */

/* Each frame is seen for its share of a cycle, the last one longer. */
static char *motion_style(size_t frames)
{
    enum { HOLD = 4 };
    const double slots = (double)(frames + HOLD), seconds = 0.25 * slots;
    return g_strdup_printf(
        "%s.f{visibility:hidden;animation:%.2fs step-end infinite f}.f.last{animation-name:l}"
        "@keyframes f{0%%{visibility:visible}%.3f%%,to{visibility:hidden}}"
        "@keyframes l{0%%{visibility:visible}%.3f%%,to{visibility:hidden}}"
        "@media(prefers-reduced-motion:reduce){.f{animation:none}.f.last{visibility:visible}}",
        look, seconds, 100 / slots, 100 * (1 + HOLD) / slots - 0.001);
}

char *picture_motion_svg(const struct picture_file *file, const char *title,
                         const char *description)
{
    struct drawing drawing = {.file = file, .states = &file->motion};
    const size_t frames = file->motion.frame_count;
    if (frames == 0)
        return NULL;
    char *style = motion_style(frames);
    begin(&drawing, title, description, style);
    for (size_t i = 0; i < frames; i++) {
        g_string_append_printf(drawing.svg, "<g class=\"f%s\" style=\"animation-delay:%.2fs\">\n",
                               i + 1 == frames ? " last" : "", 0.25 * (double)i);
        add_time(&drawing, file->motion.frames[i].time);
        add_frame(&drawing, &file->motion.frames[i]);
        g_string_append(drawing.svg, "</g>\n");
    }
    region_outlines(drawing.svg, &drawing.view, drawing.file->scene);
    add_surroundings(&drawing);
    svg_end(drawing.svg);
    g_free(style);
    return g_string_free(drawing.svg, FALSE);
}

/* ----------------------------------------------------------------------- small */

char *picture_small_svg(const struct picture_file *file, const char *title)
{
    enum { SMALL_WIDTH = 240, SMALL_HEIGHT = 150 };
    struct drawing drawing = {
        .file = file, .states = &file->still, .svg = g_string_new(NULL), .small = true};
    double low[2], high[2];
    drawing.range = range_of(file, drawing.states);
    find_bounds(&drawing, low, high);
    drawing.view = svg_view_of(low, high, 0, 0, SMALL_WIDTH, SMALL_HEIGHT);
    drawing.view.top = 0.5 * (SMALL_HEIGHT - svg_height(&drawing.view));
    svg_begin(drawing.svg, SMALL_WIDTH, SMALL_HEIGHT, "free", title, "", look);
    add_clip(&drawing);
    add_frame(&drawing, &file->still.frames[file->still.frame_count - 1]);
    svg_end(drawing.svg);
    return g_string_free(drawing.svg, FALSE);
}
