/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/plot/plot.h"

#include "base/status.h"
#include "io/plot/snapshot_read.h"
#include "io/results/series.h"
#include "io/results/snapshot.h"
#include "mpm_file.h"
#include "mpm_gnuplot.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static const struct script {
    const char *name, *summary;
    const char *const *lines;
} scripts[] = {
#include "plots.inc"
};

/* ------------------------------------------------------------------- gnuplot */

/* A folder of gnuplot's own, its data, and the commands before the script. */
struct drawing {
    const struct mpm_plot_options *options;
    const char *script; /* one of the table */
    char *home;
    GString *settings;
    struct mpm_error *error;
};

/* In single quotes a text is itself, but for them; one in it becomes an apostrophe. */
static void set_text(const struct drawing *drawing, const char *name, const char *text)
{
    g_string_append_printf(drawing->settings, "%s = '", name);
    for (const char *at = text; *at != '\0'; at++)
        if (*at == '\'')
            g_string_append(drawing->settings, "’");
        else if ((unsigned char)*at >= ' ')
            g_string_append_c(drawing->settings, *at);
    g_string_append(drawing->settings, "'; ");
}

static void set_number(const struct drawing *drawing, const char *name, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append_printf(drawing->settings, "%s = %s; ", name,
                           g_ascii_formatd(digits, sizeof digits, "%.9e", value));
}

static enum mpm_status save(const struct drawing *drawing, const char *name, const char *text,
                            size_t length)
{
    char *const path = g_build_filename(drawing->home, name, NULL);
    const enum mpm_status status = mpm_file_save(path, text, length) == 0
                                       ? MPM_OK
                                       : mpm_file_failed(path, errno, drawing->error);
    g_free(path);
    return status;
}

static enum mpm_status save_script(const struct drawing *drawing)
{
    size_t k = 0;
    while (strcmp(scripts[k].name, drawing->script) != 0)
        k++;
    char *const text = g_strjoinv("", (char **)(uintptr_t)scripts[k].lines);
    const enum mpm_status status = save(drawing, "script.gp", text, strlen(text));
    g_free(text);
    return status;
}

/* A warning, of a missing font or an empty range, is a failure: the picture would be wrong. */
static enum mpm_status run_gnuplot(const struct drawing *drawing)
{
    char *said = NULL, *failure = NULL;
    enum mpm_status status = MPM_OK;
    const bool ran =
        mpm_gnuplot_run(drawing->home, drawing->settings->str, "script.gp", &said, &failure);
    if (said == NULL)
        status = mpm_error_set(drawing->error, MPM_ENVIRONMENT_FAILED,
                               "gnuplot cannot be run: %s (Debian: gnuplot-nox)", failure);
    else if (!ran || strstr(said, "warning:") != NULL)
        status = mpm_error_set(drawing->error, MPM_ENVIRONMENT_FAILED, "gnuplot failed: %.800s",
                               g_strstrip(said));
    g_free(said);
    g_free(failure);
    return status;
}

/* The picture, whole or not at all. */
static enum mpm_status take_picture(const struct drawing *drawing, const char *name, char **picture)
{
    char *const from = g_build_filename(drawing->home, "picture", NULL);
    char *const to = g_build_filename(drawing->options->output, name, NULL);
    size_t size = 0;
    char *const bytes = mpm_file_load(from, &size);
    enum mpm_status status = MPM_OK;
    if (bytes == NULL)
        status = mpm_file_unread(from, errno, NULL, drawing->error);
    else if (mpm_folder_make(drawing->options->output) != 0 || mpm_file_save(to, bytes, size) != 0)
        status = mpm_file_failed(to, errno, drawing->error);
    g_free(bytes);
    g_free(from);
    if (status == MPM_OK)
        *picture = to;
    else
        g_free(to);
    return status;
}

/* Makes the home of a drawing, lets `prepare` fill it, and draws. */
static enum mpm_status draw(struct drawing *drawing, const char *name,
                            enum mpm_status (*prepare)(const struct drawing *, const void *),
                            const void *what, char **picture)
{
    drawing->settings = g_string_new(NULL);
    enum mpm_status status = mpm_folder_make_temporary(&drawing->home, drawing->error);
    set_text(drawing, "output", "picture");
    set_text(drawing, "format", drawing->options->format);
    if (status == MPM_OK)
        status = prepare(drawing, what);
    if (status == MPM_OK)
        status = save_script(drawing);
    if (status == MPM_OK)
        status = run_gnuplot(drawing);
    if (status == MPM_OK)
        status = take_picture(drawing, name, picture);
    if (drawing->home != NULL)
        (void)mpm_folder_remove_all(drawing->home, NULL);
    g_string_free(drawing->settings, TRUE);
    g_free(drawing->home);
    return status;
}

/* ----------------------------------------------------------------- particles */

struct limits {
    double low, high;
};

static void widen(struct limits *limits, double value)
{
    if (isfinite(value)) {
        limits->low = fmin(limits->low, value);
        limits->high = fmax(limits->high, value);
    }
}

/* With a margin; a range of one value, or of none, gets a width. */
static void set_limits(const struct drawing *drawing, const char *low, const char *high,
                       struct limits limits, double margin)
{
    if (!(limits.low <= limits.high))
        limits = (struct limits){0.0, 0.0};
    const double width = limits.high - limits.low;
    const double more =
        width > 1e-9 * fabs(limits.high) ? margin * width : fmax(1e-3 * fabs(limits.high), 1e-12);
    set_number(drawing, low, limits.low - more);
    set_number(drawing, high, limits.high + more);
}

static void append_point(GString *data, const double corner[2], double value)
{
    char digits[3][G_ASCII_DTOSTR_BUF_SIZE];
    const double numbers[3] = {corner[0], corner[1], value};
    for (int n = 0; n < 3; n++)
        (void)g_ascii_formatd(digits[n], sizeof digits[n], "%.7g", numbers[n]);
    g_string_append_printf(data, "%s %s %s\n", digits[0], digits[1], digits[2]);
}

/* Two rows of two corners, and a row of undefined points, across which gnuplot draws nothing: all
 * domains are one surface, since a surface for each makes pictures 2.5 times as large. */
static void append_domain(GString *data, double corners[4][2], double value)
{
    static const int order[4] = {0, 1, 3, 2};
    for (int k = 0; k < 4; k++) {
        append_point(data, corners[order[k]], value);
        if (k % 2 == 1)
            g_string_append_c(data, '\n');
    }
    g_string_append(data, "nan nan nan\nnan nan nan\n\n");
}

/* One line with breaks: lines of equally many points would be a mesh to gnuplot. */
static void append_outline(GString *data, double corners[4][2])
{
    for (int k = 0; k <= 4; k++)
        append_point(data, corners[k % 4], 0.0);
    g_string_append(data, "nan nan nan\n");
}

static enum mpm_status prepare_particles(const struct drawing *drawing, const void *what)
{
    const struct mpm_picture *const picture = what;
    struct limits range[3] = {{HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}};
    GString *const data = g_string_new(NULL), *const outlines = g_string_new(NULL);
    for (size_t p = 0; p < picture->count; p++) {
        append_domain(data, picture->corners[p], picture->values[p]);
        append_outline(outlines, picture->corners[p]);
        widen(&range[2], picture->values[p]);
        for (int k = 0; k < 8; k++)
            widen(&range[k % 2], picture->corners[p][k / 2][k % 2]);
    }
    char *const title =
        g_strdup_printf("%s, time %.6g %s", picture->title, picture->time, picture->unit_time);
    set_text(drawing, "title_text", title);
    set_text(drawing, "label_text", drawing->options->field);
    set_text(drawing, "unit", picture->unit);
    set_text(drawing, "length", picture->unit_length);
    set_text(drawing, "axes", picture->axisymmetric ? "r z" : "x y");
    set_limits(drawing, "left", "right", range[0], 0.05);
    set_limits(drawing, "bottom", "top", range[1], 0.05);
    set_limits(drawing, "low", "high", range[2], 0.0);
    enum mpm_status status = save(drawing, "particles.dat", data->str, data->len);
    if (status == MPM_OK)
        status = save(drawing, "outlines.dat", outlines->str, outlines->len);
    g_string_free(outlines, TRUE);
    g_string_free(data, TRUE);
    g_free(title);
    return status;
}

/* The number of the snapshot to draw, of those that are there: the last one, or the one wanted. */
static enum mpm_status find_snapshot(const struct mpm_plot_options *options, char **name,
                                     struct mpm_error *error)
{
    char **const names = mpm_folder_list(options->folder);
    if (names == NULL)
        return mpm_file_unread(options->folder, errno, "a folder of results", error);
    *name = NULL;
    uint64_t last = 0, number = 0;
    for (size_t k = 0; names[k] != NULL; k++) {
        if (!mpm_series_number(names[k], MPM_SERIES_PREFIX, MPM_SERIES_SUFFIX, &number))
            continue;
        char *const text = g_strdup_printf("%" G_GUINT64_FORMAT, (guint64)number);
        const bool wanted = options->snapshot != NULL ? strcmp(options->snapshot, text) == 0
                                                      : *name == NULL || number > last;
        g_free(text);
        if (!wanted)
            continue;
        last = number;
        g_free(*name);
        *name = g_strdup(names[k]);
    }
    mpm_folder_list_free(names);
    if (*name != NULL)
        return MPM_OK;
    return options->snapshot == NULL
               ? mpm_error_set(error, MPM_BAD_INPUT,
                               "%s: no snapshots there; allowed: a folder that 'mpm run' has "
                               "written",
                               options->folder)
               : mpm_error_set(error, MPM_BAD_INPUT,
                               "--snapshot %.32s: %s has none of that number; allowed: 0, 1, ...",
                               options->snapshot, options->folder);
}

static enum mpm_status draw_particles(const struct mpm_plot_options *options, char **picture,
                                      struct mpm_error *error)
{
    char *name = NULL;
    struct mpm_picture read;
    struct drawing drawing = {.options = options, .script = "particles", .error = error};
    MPM_TRY(find_snapshot(options, &name, error));
    char *const path = g_build_filename(options->folder, name, NULL);
    enum mpm_status status = mpm_picture_read(path, options->field, &read, error);
    if (status == MPM_OK && name != NULL) {
        const char *const digits = name + strlen(MPM_SERIES_PREFIX);
        char *const file = g_strdup_printf("plot-%s-%.*s.%s", options->field,
                                           (int)(strlen(digits) - strlen(MPM_SERIES_SUFFIX)),
                                           digits, options->format);
        status = draw(&drawing, file, prepare_particles, &read, picture);
        g_free(file);
    }
    mpm_picture_free(&read);
    g_free(path);
    g_free(name);
    return status;
}

/* ------------------------------------------------------------------- history */

/* Those of the energies that the history has: names and, from the second line, their unit. */
static const char *const energies[] = {
    "total_energy",        "kinetic_energy",      "strain_energy", "external_work",
    "damping_dissipation", "plastic_dissipation", "thermal_energy"};

static char *unit_at(char **units, guint column)
{
    if (units == NULL || column >= g_strv_length(units))
        return g_strdup("");
    const char *const unit = units[column];
    return g_strdup(column == 0 && unit[0] == '#' ? unit + 1 + strspn(unit + 1, " ") : unit);
}

static void set_columns(const struct drawing *drawing, char **names, char **units)
{
    GString *const columns = g_string_new(NULL);
    char *energy = NULL;
    for (size_t k = 0; k < G_N_ELEMENTS(energies); k++)
        for (guint c = 0; names[c] != NULL; c++)
            if (strcmp(names[c], energies[k]) == 0) {
                g_string_append_printf(columns, "%s%s", columns->len > 0 ? " " : "", names[c]);
                if (energy == NULL)
                    energy = unit_at(units, c);
            }
    char *const time = unit_at(units, 0);
    set_text(drawing, "columns", columns->str);
    set_text(drawing, "energy", energy != NULL ? energy : "");
    set_text(drawing, "time", time);
    set_text(drawing, "title_text", "History");
    g_free(energy);
    g_free(time);
    g_string_free(columns, TRUE);
}

static enum mpm_status prepare_history(const struct drawing *drawing, const void *path)
{
    size_t size = 0;
    char *const text = mpm_file_load(path, &size);
    if (text == NULL)
        return mpm_file_unread(path, errno, "the history of a run", drawing->error);
    char **const lines = g_strsplit(text, "\n", 3);
    char **const names = g_strsplit(lines[0] != NULL ? lines[0] : "", ",", -1);
    const bool has_units = lines[0] != NULL && lines[1] != NULL && lines[1][0] == '#';
    char **const units = has_units ? g_strsplit(lines[1], ",", -1) : NULL;
    const bool sound = names[0] != NULL && strcmp(names[0], "time") == 0 &&
                       g_strv_contains((const char *const *)names, "total_energy") &&
                       g_strv_contains((const char *const *)names, "j_min") &&
                       g_strv_contains((const char *const *)names, "j_max");
    enum mpm_status status =
        sound ? save(drawing, "history.csv", text, size)
              : mpm_error_set(drawing->error, MPM_BAD_INPUT,
                              "%s: not the history of a run; allowed: a file of 'mpm run'",
                              (const char *)path);
    if (status == MPM_OK)
        set_columns(drawing, names, units);
    g_strfreev(names);
    g_strfreev(units);
    g_strfreev(lines);
    g_free(text);
    return status;
}

static enum mpm_status draw_history(const struct mpm_plot_options *options, char **picture,
                                    struct mpm_error *error)
{
    struct drawing drawing = {.options = options, .script = "history", .error = error};
    char *const path = g_build_filename(options->folder, "history.csv", NULL);
    char *const file = g_strdup_printf("plot-history.%s", options->format);
    const enum mpm_status status = draw(&drawing, file, prepare_history, path, picture);
    g_free(file);
    g_free(path);
    return status;
}

/* ---------------------------------------------------------------------- both */

/* A field that snapshots may have; NULL: it is computed here anyway. */
static const struct mpm_field_info *own_field(enum mpm_field field)
{
    const struct mpm_field_info *const info = mpm_field_describe(field);
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        if (strcmp(info->name, mpm_derived_fields[k].name) == 0)
            return NULL;
    return info;
}

char *mpm_plot_fields(void)
{
    GString *const list = g_string_new(NULL);
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        g_string_append_printf(list, "%-22s %s\n", mpm_derived_fields[k].name,
                               mpm_derived_fields[k].description);
    for (int k = 0; k < MPM_FIELD_COUNT; k++) {
        const struct mpm_field_info *const info = own_field((enum mpm_field)k);
        if (info == NULL)
            continue;
        char *const name = g_strconcat(info->name, info->components > 1 ? ".COMPONENT" : "", NULL);
        g_string_append_printf(list, "%-22s %s\n", name, info->description);
        g_free(name);
    }
    return g_string_free(list, FALSE);
}

/* Components by the names of both kinds of coordinates. */
static void add_all_names(GString *list)
{
    for (size_t k = 0; k < mpm_derived_field_count; k++)
        g_string_append_printf(list, "%s\n", mpm_derived_fields[k].name);
    for (int k = 0; k < MPM_FIELD_COUNT; k++) {
        const struct mpm_field_info *const info = own_field((enum mpm_field)k);
        if (info != NULL && info->components == 1)
            g_string_append_printf(list, "%s\n", info->name);
        if (info == NULL || info->components == 1)
            continue;
        mpm_component_names(info->name, mpm_snapshot_components(MPM_PLANE_STRAIN, info->components),
                            list);
        mpm_component_names(info->name, mpm_snapshot_components(MPM_AXISYMMETRIC, info->components),
                            list);
    }
}

enum mpm_status mpm_plot_names(const struct mpm_plot_options *options, char **names,
                               struct mpm_error *error)
{
    char *name = NULL;
    GString *const list = g_string_new(NULL);
    enum mpm_status status = MPM_OK;
    if (options->folder == NULL) {
        add_all_names(list);
    } else if ((status = find_snapshot(options, &name, error)) == MPM_OK) {
        char *const path = g_build_filename(options->folder, name, NULL);
        status = mpm_picture_names(path, list, error);
        g_free(path);
        g_free(name);
    }
    *names = g_string_free(list, status != MPM_OK);
    return status;
}

enum mpm_status mpm_plot(const struct mpm_plot_options *options, char *pictures[MPM_PLOT_COUNT],
                         struct mpm_error *error)
{
    if (strcmp(options->format, "svg") != 0 && strcmp(options->format, "png") != 0)
        return mpm_error_set(error, MPM_BAD_INPUT, "--format %.32s: allowed: svg, png",
                             options->format);
    MPM_TRY(draw_particles(options, &pictures[MPM_PLOT_PARTICLES], error));
    return draw_history(options, &pictures[MPM_PLOT_HISTORY], error);
}
