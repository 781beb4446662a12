/* The Pareto picture of a comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/comparison_plot.h"

#include "verification/measures/label_places.h"
#include "verification/suite/output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The inside of the picture in pixels, as reports/comparison.gp has it, and its letters. */
static const struct label_frame frame = {0.86 * 760, 0.71 * 520, 6.0};
enum { NAME_LETTER = 7, NUMBER_LETTER = 6, LINE = 13, NUMBERS_SHOWN = 3 };

struct point {
    double x, y;
    size_t row;
    bool front;
    unsigned order, shape; /* of the stress update and the functions, 0 if there is none */
};

struct axis {
    double low, high;
    bool logarithmic;
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

static void add_number(GString *text, const char *format, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append(text, g_ascii_formatd(digits, sizeof digits, format, value));
}

static void add_tic(GString *axes, double step, int power)
{
    if (abs(power) <= 3)
        add_number(axes, "%g", step * pow(10, power));
    else
        g_string_append_printf(axes, "%s10^{%d}", step > 3 ? "5·" : step > 1 ? "2·" : "", power);
}

/* Decades; over fewer than three of them 1, 2, 5. */
static void add_tics(GString *axes, char name, const struct axis *axis)
{
    static const double steps[] = {1, 2, 5};
    const double decades = log10(axis->high / axis->low);
    const int every = (int)ceil(decades / 8);
    bool first = true;
    g_string_append_printf(axes, "set %ctics (", name);
    for (int power = (int)floor(log10(axis->low)); power <= (int)log10(axis->high) + 1; power++)
        for (unsigned i = 0; i < (decades < 3 ? G_N_ELEMENTS(steps) : 1); i++) {
            const double value = steps[i] * pow(10, power);
            if (value < axis->low || value > axis->high || power % every != 0)
                continue;
            g_string_append(axes, first ? "'" : ", '");
            add_tic(axes, steps[i], power);
            g_string_append(axes, "' ");
            add_number(axes, "%.9g", value);
            first = false;
        }
    g_string_append(axes, ")\n");
}

static void add_range(GString *axes, char name, const struct axis *range)
{
    g_string_append_printf(axes, "set %crange [", name);
    add_number(axes, "%.9g", range->low);
    g_string_append_c(axes, ':');
    add_number(axes, "%.9g", range->high);
    g_string_append(axes, "]\n");
    if (!range->logarithmic)
        return;
    g_string_append_printf(axes, "set logscale %c\n", name);
    add_tics(axes, name, range);
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
                           front ? 12 : 10);
    add_number(axes, "%.5f", label->left / frame.width);
    g_string_append(axes, ", graph ");
    add_number(axes, "%.5f", (label->low + 0.5 * label->height) / frame.height);
    g_string_append_c(axes, '\n');
    g_free(quoted);
}

static void add_labels(GString *axes, const struct comparison_view *view, const GArray *points,
                       const struct axis *x, const struct axis *y)
{
    struct label_place *labels = g_new0(struct label_place, points->len + 1);
    GPtrArray *texts = g_ptr_array_new_with_free_func(g_free);
    for (unsigned i = 0; i < points->len; i++) {
        const struct point *point = &g_array_index(points, struct point, i);
        labels[i].x = frame.width * place_on(x, point->x);
        labels[i].y = frame.height * place_on(y, point->y);
    }
    for (unsigned i = 0; i < points->len; i++) {
        char *text = label_text(view, points, labels, i);
        g_ptr_array_add(texts, text);
        const bool front = g_array_index(points, struct point, i).front;
        labels[i].width = (double)strlen(text) * (front ? NAME_LETTER : NUMBER_LETTER);
        labels[i].height = LINE;
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

/* Names of the parts of a kind that are drawn, and their places, which have a colour or mark. */
static void add_names(GString *axes, const struct comparison_view *view, const GArray *points,
                      const char *kind)
{
    const json_t *parts = json_object_get(view->declared, "parts");
    const bool order = strcmp(kind, "order") == 0;
    GString *places = g_string_new(NULL);
    unsigned place = 0;
    g_string_append_printf(axes, "%ss = '", kind);
    for (size_t i = 0; i < json_array_size(parts); i++) {
        const json_t *part = json_array_get(parts, i);
        if (strcmp(record_text(part, "kind"), kind) != 0 || !is_drawn(points, order, ++place))
            continue;
        g_string_append_printf(axes, "%s ", record_text(part, "part"));
        g_string_append_printf(places, "%u ", place);
    }
    g_string_append_printf(axes, "'\n%s_places = '%s'\n", kind, places->str);
    g_string_free(places, TRUE);
}

char *comparison_plot_data(const struct comparison_view *view, size_t x, size_t y, GString *axes)
{
    GArray *points = points_of(view, x, y);
    GString *data = g_string_new(NULL);
    g_array_sort(points, compare_points);
    if (points->len >= 2) {
        const struct axis across = axis_of(points, false), up = axis_of(points, true);
        for (unsigned i = 0; i < points->len; i++) {
            const struct point *point = &g_array_index(points, struct point, i);
            add_number(data, "%.9g", point->x);
            g_string_append_c(data, ' ');
            add_number(data, "%.9g", point->y);
            g_string_append_printf(data, " %u %u %d\n", point->order, point->shape, point->front);
        }
        add_range(axes, 'x', &across);
        add_range(axes, 'y', &up);
        add_names(axes, view, points, "order");
        add_names(axes, view, points, "shape");
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
        "Every variant that counts as a point, numbered as in the table; those on the front are "
        "filled "
        "and named."});
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
