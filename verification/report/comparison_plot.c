/* The Pareto picture of a comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/comparison_plot.h"

#include "mpm_file.h"
#include "verification/common/output.h"
#include "verification/common/text.h"
#include "verification/measures/comparison/axis_tics.h"
#include "verification/measures/comparison/label_places.h"
#include "verification/pages/figure.h"

#include <math.h>
#include <string.h>

enum { NAME_FONT = 12, NUMBER_FONT = 10, TIC_FONT = 14, NUMBERS_SHOWN = 3 };

/* The inside of the picture in pixels, as reports/comparison.gp has it, its letters, and what is
 * left for labels of tics: beyond both ends of x, and before y and its title. */
static const struct label_frame frame = {0.85 * 760, 0.71 * 520, 6.0};
static const struct axis_room room_across = {
    .length = 0.85 * 760, .along = true, .beyond = 0.02 * 760 - 1, .font = TIC_FONT};
static const struct axis_room room_up = {.length = 0.71 * 520, .across = 58, .font = TIC_FONT};
static const double LINE = 1.2; /* height of a line in sizes of its font */

struct point {
    double x, y;
    size_t row;
    bool front;
    unsigned order, shape; /* of the stress update and the functions, 0 if there is none */
};

static double drawn(const struct comparison_column *column, double value)
{
    return column->better == COMPARISON_ZERO ? fabs(value) : value;
}

/* 1 + place of the variant's part of that kind among the parts of it; 0 if it has none. */
static unsigned part_place(const struct comparison_view *view, const char *variant,
                           const char *kind)
{
    const json_t *parts = json_object_get(view->declared, "parts");
    const json_t *own = comparison_view_part(view, variant, kind);
    unsigned place = 0;
    for (size_t i = 0; own != NULL && i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        place += strcmp(record_text(part, "kind"), kind) == 0;
        if (part == own)
            break;
    }
    return place;
}

/* The rows that take part and have both numbers; the front is that of the whole table. */
static GArray *points_of(const struct comparison_view *view, size_t x, size_t y)
{
    GArray *points = g_array_new(FALSE, TRUE, sizeof(struct point));
    const struct comparison_table *table = &view->table;
    for (size_t row = 0; row < table->row_count; row++) {
        if (comparison_rank(table, row, x) == 0 || comparison_rank(table, row, y) == 0)
            continue;
        const char *name = view->names[row];
        const struct point point = {
            drawn(&table->columns[x], comparison_cell(table, row, x)->value),
            drawn(&table->columns[y], comparison_cell(table, row, y)->value),
            row,
            comparison_on_front(table, row),
            part_place(view, name, "order"),
            part_place(view, name, "shape")};
        g_array_append_val(points, point);
    }
    return points;
}

/* Those on the front first, so that their labels find room. */
static int compare_points(const void *a, const void *b)
{
    const struct point *one = a, *other = b;
    if (one->front != other->front)
        return one->front ? -1 : 1;
    return (one->row > other->row) - (one->row < other->row);
}

static struct axis_range range_of(const GArray *points, bool vertical)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *point = &g_array_index(points, struct point, i);
        low = fmin(low, vertical ? point->y : point->x);
        high = fmax(high, vertical ? point->y : point->x);
    }
    return axis_range_of(low, high);
}

static void add_number(GString *text, const char *format, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append(text, g_ascii_formatd(digits, sizeof digits, format, value));
}

static void add_tics(GString *axes, char name, const struct axis_range *range,
                     const struct axis_room *room)
{
    struct axis_tic tics[AXIS_TICS_MAX];
    const size_t count = axis_tics(range, room, tics);
    if (count == 0) {
        g_string_append_printf(axes, "unset %ctics\n", name);
        return;
    }
    g_string_append_printf(axes, "set %ctics (", name);
    for (size_t i = 0; i < count; i++) {
        g_string_append_printf(axes, "%s'%s' ", i == 0 ? "" : ", ", tics[i].text);
        add_number(axes, "%.15g", tics[i].value);
    }
    g_string_append(axes, ")\n");
}

static void add_axis(GString *axes, char name, const struct axis_range *range,
                     const struct axis_room *room)
{
    g_string_append_printf(axes, "set %crange [", name);
    add_number(axes, "%.15g", range->low);
    g_string_append_c(axes, ':');
    add_number(axes, "%.15g", range->high);
    g_string_append(axes, "]\n");
    if (range->logarithmic)
        g_string_append_printf(axes, "set logscale %c\n", name);
    add_tics(axes, name, range, room);
}

/* -------------------------------------------------------------------- labels */

static bool same_place(const struct label_place *one, const struct label_place *other)
{
    return fabs(one->x - other->x) < 0.5 * frame.mark && fabs(one->y - other->y) < 0.5 * frame.mark;
}

/* The name on the front; else the numbers of all points of the place, at the first of them. */
static char *label_text(const struct comparison_view *view, const GArray *points,
                        const struct label_place *labels, unsigned own)
{
    const struct point *point = &g_array_index(points, struct point, own);
    if (point->front)
        return g_strdup(view->names[point->row]);
    GString *text = g_string_new(NULL);
    unsigned count = 0;
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *other = &g_array_index(points, struct point, i);
        if (other->front || !same_place(&labels[i], &labels[own]))
            continue;
        if (i < own) {
            g_string_truncate(text, 0);
            return g_string_free(text, FALSE);
        }
        if (count++ < NUMBERS_SHOWN)
            g_string_append_printf(text, "%s%zu", count > 1 ? "," : "", other->row + 1);
    }
    if (count > NUMBERS_SHOWN)
        g_string_append_printf(text, " +%u", count - NUMBERS_SHOWN);
    return g_string_free(text, FALSE);
}

static void add_label(GString *axes, const char *text, const struct label_place *label, bool front)
{
    char *quoted = figure_quoted(text);
    g_string_append_printf(axes, "set label %s left noenhanced font ',%d' at graph ", quoted,
                           front ? NAME_FONT : NUMBER_FONT);
    add_number(axes, "%.5f", label->left / frame.width);
    g_string_append(axes, ", graph ");
    add_number(axes, "%.5f", (label->low + 0.5 * label->height) / frame.height);
    g_string_append_c(axes, '\n');
    g_free(quoted);
}

static void add_labels(GString *axes, const struct comparison_view *view, const GArray *points,
                       const struct axis_range *x, const struct axis_range *y)
{
    struct label_place *labels = g_new0(struct label_place, points->len + 1);
    GPtrArray *texts = g_ptr_array_new_with_free_func(g_free);
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *point = &g_array_index(points, struct point, i);
        labels[i].x = frame.width * axis_place(x, point->x);
        labels[i].y = frame.height * axis_place(y, point->y);
    }
    for (unsigned i = 0; i < points->len; i++) {
        char *text = label_text(view, points, labels, i);
        g_ptr_array_add(texts, text);
        const double font = g_array_index(points, struct point, i).front ? NAME_FONT : NUMBER_FONT;
        labels[i].width = axis_text_width(text, font);
        labels[i].height = LINE * font;
    }
    label_places_find(labels, points->len, &frame);
    for (unsigned i = 0; i < points->len; i++)
        if (labels[i].placed)
            add_label(axes, texts->pdata[i], &labels[i],
                      g_array_index(points, struct point, i).front);
    g_ptr_array_unref(texts);
    g_free(labels);
}

static bool is_drawn(const GArray *points, bool order, unsigned place)
{
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *point = &g_array_index(points, struct point, i);
        if ((order ? point->order : point->shape) == place)
            return true;
    }
    return false;
}

/* name='...', a line. */
static void add_definition(GString *axes, const char *name, const char *value)
{
    char *quoted = figure_quoted(value);
    g_string_append_printf(axes, "%s = %s\n", name, quoted);
    g_free(quoted);
}

/* Names of the parts of a kind that are drawn, and their places, which have a colour or mark. */
static void add_names(GString *axes, const struct comparison_view *view, const GArray *points,
                      bool order)
{
    const json_t *parts = json_object_get(view->declared, "parts");
    const char *kind = order ? "order" : "shape";
    GString *places = g_string_new(NULL), *names = g_string_new(NULL);
    unsigned place = 0;
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        if (strcmp(record_text(part, "kind"), kind) != 0 || !is_drawn(points, order, ++place))
            continue;
        g_string_append_printf(names, "%s ", record_text(part, "part"));
        g_string_append_printf(places, "%u ", place);
    }
    add_definition(axes, order ? "orders" : "shapes", names->str);
    add_definition(axes, order ? "order_places" : "shape_places", places->str);
    g_string_free(names, TRUE);
    g_string_free(places, TRUE);
}

char *comparison_plot_data(const struct comparison_view *view, size_t x, size_t y, GString *axes)
{
    GArray *points = points_of(view, x, y);
    GString *data = g_string_new(NULL);
    g_array_sort(points, compare_points);
    if (points->len >= 2) {
        const struct axis_range across = range_of(points, false), up = range_of(points, true);
        for (unsigned i = 0; i < points->len; i++) {
            const struct point *point = &g_array_index(points, struct point, i);
            add_number(data, "%.15g", point->x);
            g_string_append_c(data, ' ');
            add_number(data, "%.15g", point->y);
            g_string_append_printf(data, " %u %u %d\n", point->order, point->shape, point->front);
        }
        add_axis(axes, 'x', &across, &room_across);
        add_axis(axes, 'y', &up, &room_up);
        add_names(axes, view, points, true);
        add_names(axes, view, points, false);
        add_labels(axes, view, points, &across, &up);
    }
    g_array_unref(points);
    return g_string_free(data, FALSE);
}

/* ------------------------------------------------------------------- drawing */

static const char data_name[] = "data-comparison.dat";

static char *label_with(const struct comparison_column *column, const char *title)
{
    const bool bare = strcmp(column->unit, "1") == 0;
    return g_strconcat(column->better == COMPARISON_ZERO ? "|" : "", title,
                       column->better == COMPARISON_ZERO ? "|" : "", bare ? "" : " (",
                       bare ? "" : column->unit, bare ? "" : ")",
                       column->better == COMPARISON_HIGH ? ", more is better" : "", NULL);
}

/* Title, unit and direction; a title that is longer than its axis is cut, and the table has it
 * whole. */
static char *label_of(const struct comparison_column *column, double length)
{
    char *text = label_with(column, column->title);
    for (glong letters = g_utf8_strlen(column->title, -1);
         letters > 0 && axis_text_width(text, TIC_FONT) > length; letters--) {
        char *begin = g_utf8_substring(column->title, 0, letters - 1);
        char *title = g_strconcat(begin, "…", NULL);
        g_free(text);
        text = label_with(column, title);
        g_free(title);
        g_free(begin);
    }
    char *quoted = figure_quoted(text);
    g_free(text);
    return quoted;
}

static struct figure_result draw(const struct comparison_view *view, const json_t *run,
                                 const char *home, const char *reports, const char *axes, size_t x,
                                 size_t y)
{
    char *style = g_build_filename(reports, "style.gp", NULL);
    char *script = g_build_filename(reports, "comparison.gp", NULL);
    char *path = g_build_filename(home, data_name, NULL);
    char *data = g_canonicalize_filename(path, NULL), *quoted_data = figure_quoted(data);
    char *stamp = g_strdup_printf("Touchstone %s, %s", record_text(run, "version"),
                                  record_text(run, "revision"));
    char *quoted_stamp = figure_quoted(stamp);
    char *across = label_of(&view->columns[x], room_across.length),
         *up = label_of(&view->columns[y], room_up.length);
    char *settings =
        g_strdup_printf("name='comparison'; data=%s; variants=''; stamp=%s; across=%s; up=%s",
                        quoted_data, quoted_stamp, across, up);
    char *const owned[] = {style, script,       path,   data, quoted_data,
                           stamp, quoted_stamp, across, up,   settings};
    const struct figure_result result = figure_plot(&(struct figure_plot){
        .script = script,
        .style = style,
        .axes = axes,
        .settings = settings,
        .folder = home,
        .output = "figure-comparison.svg",
        .title = record_text(view->declared, "title"),
        .description = "Every variant that counts as a point, numbered as in the table; those on "
                       "the front are filled and named."});
    for (size_t i = 0; i < G_N_ELEMENTS(owned); i++)
        g_free(owned[i]);
    return result;
}

static struct figure_result without_data(const char *reason)
{
    struct figure_result result = {.state = FIGURE_WITHOUT_DATA};
    g_strlcpy(result.reason, reason, sizeof result.reason);
    return result;
}

struct figure_result comparison_plot(const struct comparison_view *view, const json_t *run,
                                     const char *home, const char *reports)
{
    const size_t x = comparison_view_column(view, record_text(view->declared, "pareto_x"));
    const size_t y = comparison_view_column(view, record_text(view->declared, "pareto_y"));
    if (x == COMPARISON_NONE || y == COMPARISON_NONE)
        return without_data("");
    GString *axes = g_string_new(NULL);
    char *data = comparison_plot_data(view, x, y, axes);
    struct figure_result result = without_data("fewer than two variants have both numbers");
    struct mpm_error error;
    if (*data != '\0' && output_write(home, data_name, data, &error) == MPM_OK) {
        result = draw(view, run, home, reports, axes->str, x, y);
    } else if (*data != '\0') {
        result.state = FIGURE_FAILED;
        g_strlcpy(result.reason, error.message, sizeof result.reason);
    }
    g_free(data);
    g_string_free(axes, TRUE);
    return result;
}

/* --------------------------------------------------------------------- marks */

enum { PICTURE_WIDTH = 760, PICTURE_HEIGHT = 520, MARK_RADIUS = 9 };
/* What comparison.gp leaves at the left and at the top. */
static const double LEFT = 0.13, TOP = 0.15;

static void add_mark(GString *html, const struct comparison_view *view, const struct point *point,
                     const struct label_place *place, size_t x, size_t y)
{
    char across[G_ASCII_DTOSTR_BUF_SIZE], up[G_ASCII_DTOSTR_BUF_SIZE];
    char *first = text_quantity(point->x, view->columns[x].unit);
    char *second = text_quantity(point->y, view->columns[y].unit);
    g_ascii_formatd(across, sizeof across, "%.1f", LEFT * PICTURE_WIDTH + place->x);
    g_ascii_formatd(up, sizeof up, "%.1f", TOP * PICTURE_HEIGHT + frame.height - place->y);
    g_string_append_printf(html, "<circle r=\"%d\" cx=\"%s\" cy=\"%s\">", MARK_RADIUS, across, up);
    text_markup(html, "<title>%zu: %s. %s: %s. %s: %s</title></circle>", point->row + 1,
                view->names[point->row], view->columns[x].title, first, view->columns[y].title,
                second);
    g_free(second);
    g_free(first);
}

void comparison_plot_marks(const struct comparison_view *view, GString *html)
{
    const size_t x = comparison_view_column(view, record_text(view->declared, "pareto_x"));
    const size_t y = comparison_view_column(view, record_text(view->declared, "pareto_y"));
    if (x == COMPARISON_NONE || y == COMPARISON_NONE)
        return;
    GArray *points = points_of(view, x, y);
    const struct axis_range across = range_of(points, false), up = range_of(points, true);
    g_array_sort(points, compare_points);
    g_string_append_printf(html, "<svg class=\"marks\" viewBox=\"0 0 %d %d\" aria-hidden=\"true\">",
                           PICTURE_WIDTH, PICTURE_HEIGHT);
    for (unsigned i = points->len; i > 0; i--) { /* those on the front on top */
        const struct point *point = &g_array_index(points, struct point, i - 1);
        const struct label_place place = {.x = frame.width * axis_place(&across, point->x),
                                          .y = frame.height * axis_place(&up, point->y)};
        add_mark(html, view, point, &place, x, y);
    }
    g_string_append(html, "</svg>");
    g_array_unref(points);
}
