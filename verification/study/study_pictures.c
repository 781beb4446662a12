/* The pictures of a study: error over the size of a cell, and over run time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/folders.h"
#include "verification/common/output.h"
#include "verification/pages/figure.h"
#include "verification/study/study_write.h"

#include <math.h>
#include <string.h>

enum over { OVER_CELL, OVER_TIME, OVERS };
static const char *const over_names[OVERS] = {"cell", "time"};

/* What is drawn, and its extent. */
struct drawing {
    GString *data; /* blocks: a name between quotes, then x and error of each level */
    GString *axes; /* settings of gnuplot: ranges, slopes */
    unsigned curves, points;
    double x[2], y[2]; /* least and largest */
};

static void add_point(struct drawing *drawing, double x, double y)
{
    g_string_append_printf(drawing->data, "%.9g %.9g\n", x, y);
    if (drawing->points++ == 0) {
        drawing->x[0] = drawing->x[1] = x;
        drawing->y[0] = drawing->y[1] = y;
    }
    drawing->x[0] = fmin(drawing->x[0], x);
    drawing->x[1] = fmax(drawing->x[1], x);
    drawing->y[0] = fmin(drawing->y[0], y);
    drawing->y[1] = fmax(drawing->y[1], y);
}

/* A name as the header of its block: quotes would end it. */
static void add_header(struct drawing *drawing, const char *variant)
{
    char *name = g_strdup(*variant == '\0' ? "the scene" : variant);
    g_strdelimit(name, "\"\\", '\'');
    g_string_append_printf(drawing->data, "%s\"%s\"\n", drawing->curves == 0 ? "" : "\n\n", name);
    drawing->curves++;
    g_free(name);
}

static struct drawing draw(const struct study_results *results, unsigned k, enum over over)
{
    struct drawing drawing = {.data = g_string_new(NULL)};
    for (size_t g = 0; g < results->groups; g++) {
        bool begun = false;
        for (unsigned i = 0; i < results->runs->len; i++) {
            const struct study_row *row = &results->rows[i];
            const double x = over == OVER_CELL ? row->run->cell : row->cpu_seconds;
            const double y = row->values[k].error;
            if (row->run->group != g || !(x > 0.0) || !(y > 0.0) || !isfinite(x) || !isfinite(y))
                continue;
            if (!begun)
                add_header(&drawing, row->run->variant);
            begun = true;
            add_point(&drawing, x, y);
        }
    }
    return drawing;
}

bool study_has_picture(const struct study_results *results, unsigned k)
{
    const struct drawing drawing = draw(results, k, OVER_CELL);
    g_string_free(drawing.data, TRUE);
    return drawing.points >= 2;
}

/* Triangles of slopes 1 and 2 below all curves, at the right; returns the lower end of y. */
static double add_slopes(struct drawing *drawing, GString *axes)
{
    const double width = fmin(2.0, sqrt(drawing->x[1] / drawing->x[0]));
    const double right = drawing->x[1], left = right / width;
    const double base = drawing->y[0] / (2.0 * width * width);
    if (!(width > 1.0))
        return drawing->y[0] / 2.0;
    g_string_append_printf(
        drawing->data, "\n\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\n%.9g %.9g\n", left, base,
        right, base, right, base * width * width, left, base, right, base * width);
    for (int slope = 1; slope <= 2; slope++)
        g_string_append_printf(axes,
                               "set label 'slope %d' at %.9g, %.9g left offset 0.4, 0 font ',11' "
                               "textcolor rgb '#606060'\n",
                               slope, right, base * pow(width, slope));
    return base / 1.5;
}

/* For gnuplot's enhanced texts: "ms^-2" is raised, a name stays as it is. */
static char *label(const char *what, const char *unit)
{
    char *text = strcmp(unit, "1") == 0 ? g_strdup(what) : g_strconcat(what, " / ", unit, NULL);
    GRegex *special = g_regex_new("[_{}@&~\\\\]", 0, 0, NULL);
    GRegex *power = g_regex_new("\\^(-?[0-9]+)", 0, 0, NULL);
    char *plain = g_regex_replace(special, text, -1, 0, "\\\\\\0", 0, NULL);
    char *raised = g_regex_replace(power, plain, -1, 0, "^{\\1}", 0, NULL);
    char *quoted = figure_quoted(raised);
    g_free(raised);
    g_free(plain);
    g_regex_unref(power);
    g_regex_unref(special);
    g_free(text);
    return quoted;
}

/* What the axis has labels at, as tenths of a power of ten: 1, 2, 5; all digits; all tenths. */
static bool has_label(int fineness, int tenths)
{
    const bool few = tenths == 10 || tenths == 20 || tenths == 50;
    return fineness == 0 ? few : fineness == 1 ? tenths % 10 == 0 : true;
}

/* Powers of ten alone are too few labels on a short axis: the first list with three of them. */
static void add_tics(GString *axes, char axis, double low, double high)
{
    GString *tics = g_string_new(NULL);
    unsigned count = 0;
    for (int fineness = 0; high < 1000.0 * low && count < 3 && fineness < 3; fineness++) {
        count = 0;
        g_string_printf(tics, "set %ctics (", axis);
        for (int power = (int)floor(log10(low)); power <= (int)floor(log10(high)); power++)
            for (int tenths = 10; tenths < 100; tenths++) {
                const double value = tenths * pow(10.0, power - 1);
                if (has_label(fineness, tenths) && value >= low && value <= high)
                    g_string_append_printf(tics, "%s'%.2g' %.9g", count++ == 0 ? "" : ", ", value,
                                           value);
            }
        g_string_append(tics, ")\n");
    }
    g_string_append(axes, tics->str);
    g_string_free(tics, TRUE);
}

static char *across_label(const struct study *study, enum over over)
{
    const bool named = study->length_unit != NULL && *study->length_unit != '\0';
    return over == OVER_CELL ? label("size of a cell", named ? study->length_unit : "length")
                             : label("processor time", "s");
}

/* Pixels, without the legend and of a line of it. */
enum { BARE_HEIGHT = 440, LEGEND_HEIGHT = 22 };

static enum mpm_status plot(const struct study_results *results, unsigned k, enum over over,
                            const char *folder, const char *reports, const char *stamp,
                            const struct drawing *drawing, struct mpm_error *error)
{
    const struct study_entry *entry = &results->study->measures[k];
    char *what = g_strconcat("error of ", entry->name, NULL);
    char *across = across_label(results->study, over), *up = label(what, entry->unit);
    char *name = g_strdup_printf("data-%s-%s.dat", entry->name, over_names[over]);
    char *path = g_build_filename(folder, name, NULL), *whole = g_canonicalize_filename(path, NULL);
    char *quoted = figure_quoted(whole), *quoted_stamp = figure_quoted(stamp);
    char *picture = g_strdup_printf("error-%s-%s.svg", entry->name, over_names[over]);
    char *style = g_build_filename(reports, "style.gp", NULL);
    char *script = g_build_filename(reports, "study.gp", NULL);
    char *settings = g_strdup_printf("name='study'; data=%s; variants=''; stamp=%s; across=%s; "
                                     "up=%s; curves=%u; slopes=%d; height=%u",
                                     quoted, quoted_stamp, across, up, drawing->curves,
                                     strstr(drawing->axes->str, "set label") != NULL,
                                     BARE_HEIGHT + LEGEND_HEIGHT * drawing->curves);
    char *const owned[] = {what,   across,       up,      name,  path,   whole,
                           quoted, quoted_stamp, picture, style, script, settings};
    const struct figure_result result = figure_plot(&(struct figure_plot){
        .script = script,
        .style = style,
        .axes = drawing->axes->str,
        .settings = settings,
        .folder = folder,
        .output = picture,
        .title = what,
        .description = "A curve for each variant, a point for each level, on logarithmic axes."});
    for (size_t i = 0; i < G_N_ELEMENTS(owned); i++)
        g_free(owned[i]);
    return result.state == FIGURE_DRAWN
               ? MPM_OK
               : failure_set(error, MPM_ENVIRONMENT_FAILED, "%s", result.reason);
}

static enum mpm_status picture(const struct study_results *results, unsigned k, enum over over,
                               const char *folder, const char *reports, const char *stamp,
                               struct mpm_error *error)
{
    const char *name = results->study->measures[k].name;
    struct drawing drawing = draw(results, k, over);
    GString *axes = g_string_new(NULL);
    drawing.axes = axes;
    char *file = g_strdup_printf("data-%s-%s.dat", name, over_names[over]);
    enum mpm_status status = MPM_OK;
    if (drawing.points >= 2) {
        const double low = over == OVER_CELL ? add_slopes(&drawing, axes) : drawing.y[0] / 2.0;
        const double x[2] = {drawing.x[0] / 1.2, drawing.x[1] * 1.2};
        const double high = drawing.y[1] * 2.0;
        g_string_append_printf(axes, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", x[0], x[1],
                               low, high);
        add_tics(axes, 'x', x[0], x[1]);
        add_tics(axes, 'y', low, high);
        status = output_write(folder, file, drawing.data->str, error);
        if (status == MPM_OK)
            status = plot(results, k, over, folder, reports, stamp, &drawing, error);
    }
    g_free(file);
    g_string_free(axes, TRUE);
    g_string_free(drawing.data, TRUE);
    return status;
}

/* Those of an earlier study into the folder. */
static enum mpm_status remove_old(const char *folder, struct mpm_error *error)
{
    GPtrArray *names;
    TRY(folder_names(folder, &names, error));
    enum mpm_status status = MPM_OK;
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        char *path = g_build_filename(folder, names->pdata[i], NULL);
        if (g_str_has_suffix(path, ".svg") || g_str_has_suffix(path, ".dat"))
            status = folder_remove(path, error);
        g_free(path);
    }
    g_ptr_array_unref(names);
    return status;
}

enum mpm_status study_pictures(const struct study_results *results, const char *folder,
                               const char *reports, const char *stamp, struct mpm_error *error)
{
    TRY(remove_old(folder, error));
    for (unsigned k = 0; k < results->study->measures_count; k++)
        for (int over = 0; over < OVERS; over++)
            TRY(picture(results, k, (enum over)over, folder, reports, stamp, error));
    return MPM_OK;
}
