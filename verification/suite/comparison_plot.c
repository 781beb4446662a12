/* The Pareto picture of a comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/comparison_plot.h"

#include "verification/suite/output.h"

#include <math.h>
#include <string.h>

struct point {
    double x, y;
    size_t row;
    bool front;
};

struct axis {
    double low, high;
    bool logarithmic;
};

static double drawn(const struct comparison_column *column, double value)
{
    return column->better == COMPARISON_ZERO ? fabs(value) : value;
}

/* The two columns as a table of their own: the front in the plane, exactly. */
static GArray *points_of(const struct comparison_view *view, size_t x, size_t y)
{
    GArray *points = g_array_new(FALSE, TRUE, sizeof(struct point));
    struct comparison_column columns[2] = {view->columns[x], view->columns[y]};
    struct comparison_cell *cells = g_new0(struct comparison_cell, 2 * view->table.row_count + 2);
    const struct comparison_table plane = {view->table.row_count, 2, view->names, columns, cells};
    for (int c = 0; c < 2; c++)
        columns[c].tolerance = columns[c].floor = 0.0;
    for (size_t row = 0; row < plane.row_count; row++) {
        const struct comparison_cell *in_x = comparison_cell(&view->table, row, x);
        const struct comparison_cell *in_y = comparison_cell(&view->table, row, y);
        if (in_x->state != COMPARISON_NUMBER || in_y->state != COMPARISON_NUMBER)
            continue;
        cells[2 * row] = *in_x;
        cells[2 * row + 1] = *in_y;
    }
    for (size_t row = 0; row < plane.row_count; row++) {
        if (cells[2 * row].state != COMPARISON_NUMBER)
            continue;
        const struct point point = {drawn(&columns[0], cells[2 * row].value),
                                    drawn(&columns[1], cells[2 * row + 1].value), row,
                                    comparison_on_front(&plane, row)};
        g_array_append_val(points, point);
    }
    g_free(cells);
    return points;
}

static int compare_points(const void *a, const void *b)
{
    const struct point *one = a, *other = b;
    if (one->x < other->x || one->x > other->x)
        return one->x < other->x ? -1 : 1;
    return (one->y > other->y) - (one->y < other->y);
}

/* Logarithmic over more than a decade of positive numbers, and a margin on either side. */
static struct axis axis_of(const GArray *points, bool vertical)
{
    struct axis axis = {HUGE_VAL, -HUGE_VAL, false};
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *point = &g_array_index(points, struct point, i);
        axis.low = fmin(axis.low, vertical ? point->y : point->x);
        axis.high = fmax(axis.high, vertical ? point->y : point->x);
    }
    axis.logarithmic = axis.low > 0 && axis.high > 10 * axis.low;
    if (axis.logarithmic) {
        const double margin = pow(axis.high / axis.low, 0.08);
        axis.low /= margin;
        axis.high *= margin;
    } else {
        const double span = axis.high - axis.low;
        const double margin = span > 0 ? 0.08 * span : fmax(0.1 * fabs(axis.high), 1e-12);
        axis.low -= margin;
        axis.high += margin;
    }
    return axis;
}

static double place_on(const struct axis *axis, double value)
{
    return axis->logarithmic ? log(value / axis->low) / log(axis->high / axis->low)
                             : (value - axis->low) / (axis->high - axis->low);
}

static double value_at(const struct axis *axis, double place)
{
    return axis->logarithmic ? axis->low * pow(axis->high / axis->low, place)
                             : axis->low + place * (axis->high - axis->low);
}

static void add_point(GString *data, double x, double y, const char *between, const char *end)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append(data, g_ascii_formatd(text, sizeof text, "%.9g", x));
    g_string_append(data, between);
    g_string_append(data, g_ascii_formatd(text, sizeof text, "%.9g", y));
    g_string_append(data, end);
}

/* Where a label stands, in parts of the axes. */
struct label {
    double left, right, low;
};

static bool overlaps(const struct label *one, const struct label *other)
{
    static const double line = 0.055; /* height of a line of text */
    return fabs(one->low - other->low) < line && one->left < other->right &&
           other->left < one->right;
}

/* To the side where there is room, above those that it would cover. */
static struct label label_at(const struct point *point, const char *name, const GArray *labels,
                             const struct axis *x, const struct axis *y, bool *to_left)
{
    static const double letter = 0.0125, step = 0.02;
    const double at = place_on(x, point->x), length = letter * (double)strlen(name) + step;
    struct label label = {at, at + length, place_on(y, point->y) + 0.025};
    *to_left = label.right > 1.0;
    if (*to_left)
        label = (struct label){at - length, at, label.low};
    for (unsigned i = 0; i < labels->len;) {
        const bool covers = overlaps(&label, &g_array_index(labels, struct label, i));
        label.low += covers ? step : 0.0;
        i = covers ? 0 : i + 1;
    }
    return label;
}

static void add_labels(GString *axes, const struct comparison_view *view, const GArray *points,
                       const struct axis *x, const struct axis *y)
{
    GArray *labels = g_array_new(FALSE, FALSE, sizeof(struct label));
    for (unsigned i = points->len; i-- > 0;) {
        const struct point *point = &g_array_index(points, struct point, i);
        if (!point->front)
            continue;
        bool to_left;
        const char *name = view->names[point->row];
        const struct label label = label_at(point, name, labels, x, y, &to_left);
        char *quoted = figure_quoted(name);
        g_string_append_printf(axes, "set label %s %s noenhanced offset %s,0 at ", quoted,
                               to_left ? "right" : "left", to_left ? "-0.9" : "0.9");
        add_point(axes, point->x, value_at(y, label.low), ",", "\n");
        g_free(quoted);
        g_array_append_val(labels, label);
    }
    g_array_unref(labels);
}

static void add_range(GString *axes, char name, const struct axis *range)
{
    g_string_append_printf(axes, "set %crange [", name);
    add_point(axes, range->low, range->high, ":", "]\n");
    if (range->logarithmic)
        g_string_append_printf(axes, "set logscale %c\nset format %c '%%.0e'\n", name, name);
}

char *comparison_plot_data(const struct comparison_view *view, size_t x, size_t y, GString *axes)
{
    GArray *points = points_of(view, x, y);
    GString *data = g_string_new(NULL);
    g_array_sort(points, compare_points);
    if (points->len >= 2) {
        const struct axis across = axis_of(points, false), up = axis_of(points, true);
        for (int front = 0; front < 2; front++) {
            for (unsigned i = 0; i < points->len; i++) {
                const struct point *point = &g_array_index(points, struct point, i);
                if (front == 1 && !point->front)
                    continue;
                add_point(data, point->x, point->y, " ", "\n");
            }
            g_string_append(data, "\n\n");
        }
        add_range(axes, 'x', &across);
        add_range(axes, 'y', &up);
        add_labels(axes, view, points, &across, &up);
    }
    g_array_unref(points);
    return g_string_free(data, FALSE);
}

/* ------------------------------------------------------------------- drawing */

/* Path of a style file: in the run's folder, or else in `reports`; NULL if in neither. */
static char *style_path(const char *folder, const char *reports, const char *name)
{
    char *own = g_build_filename(folder, "style", name, NULL);
    char *path = NULL;
    if (g_file_test(own, G_FILE_TEST_IS_REGULAR))
        path = g_build_filename("..", "..", "style", name, NULL);
    else if (reports != NULL)
        path = g_canonicalize_filename(reports, NULL);
    if (path != NULL && !g_file_test(own, G_FILE_TEST_IS_REGULAR)) {
        char *file = g_build_filename(path, name, NULL);
        g_free(path);
        path = file;
    }
    g_free(own);
    return path;
}

static char *label_of(const struct comparison_column *column)
{
    const bool bare = strcmp(column->unit, "1") == 0;
    char *text = g_strconcat(column->better == COMPARISON_ZERO ? "|" : "", column->title,
                             column->better == COMPARISON_ZERO ? "|" : "", bare ? "" : " (",
                             bare ? "" : column->unit, bare ? "" : ")",
                             column->better == COMPARISON_HIGH ? ", more is better" : "", NULL);
    char *quoted = figure_quoted(text);
    g_free(text);
    return quoted;
}

static struct figure_result draw(const struct comparison_view *view, const json_t *run,
                                 const char *home, const char *style, const char *script, size_t x,
                                 size_t y)
{
    char *quoted_style = figure_quoted(style);
    char *stamp = g_strdup_printf("Touchstone %s, %s", record_text(run, "version"),
                                  record_text(run, "revision"));
    char *quoted_stamp = figure_quoted(stamp);
    char *across = label_of(&view->columns[x]), *up = label_of(&view->columns[y]);
    char *settings =
        g_strdup_printf("style=%s; output='figure-comparison.svg'; name='comparison'; "
                        "data='data-comparison.dat'; axes='data-comparison-axes.dat'; variants=''; "
                        "stamp=%s; across=%s; up=%s",
                        quoted_style, quoted_stamp, across, up);
    const struct figure_result result = figure_plot(&(struct figure_plot){
        home, script, settings, "figure-comparison.svg", record_text(view->declared, "title"),
        "Every variant as a point; the front, which no other variant beats in both, is joined and "
        "labelled."});
    g_free(settings);
    g_free(up);
    g_free(across);
    g_free(quoted_stamp);
    g_free(stamp);
    g_free(quoted_style);
    return result;
}

static struct figure_result without_data(const char *reason)
{
    struct figure_result result = {.state = FIGURE_WITHOUT_DATA};
    g_strlcpy(result.reason, reason, sizeof result.reason);
    return result;
}

struct figure_result comparison_plot(const struct comparison_view *view, const json_t *run,
                                     const char *folder, const char *home, const char *reports)
{
    const size_t x = comparison_view_column(view, record_text(view->declared, "pareto_x"));
    const size_t y = comparison_view_column(view, record_text(view->declared, "pareto_y"));
    if (x == COMPARISON_NONE || y == COMPARISON_NONE)
        return without_data("");
    GString *axes = g_string_new(NULL);
    char *data = comparison_plot_data(view, x, y, axes);
    char *style = style_path(folder, reports, "style.gp");
    char *script = style_path(folder, reports, "comparison.gp");
    struct figure_result result = without_data("fewer than two variants have both numbers");
    struct mpm_error error;
    if (style == NULL || script == NULL) {
        result = without_data("the pictures' style is not in this folder");
    } else if (*data != '\0') {
        if (output_write(home, "data-comparison.dat", data, &error) == MPM_OK &&
            output_write(home, "data-comparison-axes.dat", axes->str, &error) == MPM_OK) {
            result = draw(view, run, home, style, script, x, y);
        } else {
            result.state = FIGURE_FAILED;
            g_strlcpy(result.reason, error.message, sizeof result.reason);
        }
    }
    g_free(style);
    g_free(script);
    g_free(data);
    g_string_free(axes, TRUE);
    return result;
}
