/* The results of a solver.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/results.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/rows.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

typedef enum mpm_status read_function(const char *path, const struct score_format *format,
                                      struct score_table *table, struct mpm_error *error);

static read_function read_pvd;

/* In the order in which a folder is searched. Kinds of the same rank are read together. */
static const struct kind {
    const char *suffix;
    unsigned rank;
    read_function *read;
} kinds[] = {
    {".pvd", 0, read_pvd},         {".hdf", 1, score_read_hdf5},    {".h5", 1, score_read_hdf5},
    {".hdf5", 1, score_read_hdf5}, {".vtu", 2, score_read_vtk_xml}, {".vtp", 2, score_read_vtk_xml},
    {".vtk", 2, score_read_vtk},   {".csv", 3, score_read_csv},
};

static const struct kind *kind_of(const char *path)
{
    for (size_t i = 0; i < G_N_ELEMENTS(kinds); i++)
        if (g_str_has_suffix(path, kinds[i].suffix))
            return &kinds[i];
    return NULL;
}

/* One file, appended; a time that is known from elsewhere replaces its own. */
static enum mpm_status add_file(const char *path, double time, const struct score_format *format,
                                struct score_table *table, struct mpm_error *error)
{
    const struct kind *kind = kind_of(path);
    if (kind == NULL)
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: allowed are .csv, .hdf, .h5, .hdf5, .vtk, .vtu, .vtp and .pvd",
                           path);
    struct score_table own;
    score_table_open(&own);
    enum mpm_status status = kind->read(path, format, &own, error);
    if (status == MPM_OK && isfinite(time))
        status = score_take_time(path, time, &own, error);
    if (status == MPM_OK)
        status = score_table_append(table, &own, format->geometry, path, error);
    score_table_close(&own);
    return status;
}

/* ------------------------------------------------------------------------ .pvd */

struct collection {
    const char *path, *folder;
    const struct score_format *format;
    struct score_table *table;
    struct mpm_error *error;
    enum mpm_status status;
};

static void start_data_set(GMarkupParseContext *context, const char *element, const char **names,
                           const char **values, void *data, GError **failure)
{
    struct collection *collection = data;
    const char *file = NULL, *step = NULL;
    double time = (double)NAN;
    int line, column;
    if (strcmp(element, "DataSet") != 0)
        return;
    for (size_t i = 0; names[i] != NULL; i++) {
        if (strcmp(names[i], "file") == 0)
            file = values[i];
        if (strcmp(names[i], "timestep") == 0)
            step = values[i];
    }
    if (file == NULL || step == NULL || !row_number(step, &time) || !isfinite(time) ||
        g_str_has_suffix(file, ".pvd")) {
        g_markup_parse_context_get_position(context, &line, &column);
        collection->status = failure_set(
            collection->error, MPM_BAD_INPUT,
            "%s:%d: a DataSet needs the file (.vtu, .vtp, .vtk) and its time as timestep",
            collection->path, line);
    } else {
        char *path = g_build_filename(collection->folder, file, NULL);
        collection->status =
            add_file(path, time, collection->format, collection->table, collection->error);
        g_free(path);
    }
    if (collection->status != MPM_OK)
        g_set_error(failure, G_MARKUP_ERROR, G_MARKUP_ERROR_INVALID_CONTENT, "refused");
}

static enum mpm_status read_pvd(const char *path, const struct score_format *format,
                                struct score_table *table, struct mpm_error *error)
{
    static const GMarkupParser parser = {start_data_set, NULL, NULL, NULL, NULL};
    char *text, *folder = g_path_get_dirname(path);
    size_t length;
    struct collection collection = {path, folder, format, table, error, MPM_OK};
    enum mpm_status status = input_text(path, NULL, &text, &length, error);
    if (status != MPM_OK) {
        g_free(folder);
        return status;
    }
    GError *failure = NULL;
    GMarkupParseContext *context = g_markup_parse_context_new(&parser, 0, &collection, NULL);
    if (!g_markup_parse_context_parse(context, text, (gssize)length, &failure) ||
        !g_markup_parse_context_end_parse(context, &failure)) {
        status = collection.status;
        if (status == MPM_OK)
            status = failure_set(error, MPM_BAD_INPUT, "%s: %s", path, failure->message);
        g_error_free(failure);
    } else if (table->rows == 0) {
        status = failure_set(error, MPM_BAD_INPUT, "%s: names no DataSet", path);
    }
    g_markup_parse_context_free(context);
    g_free(text);
    g_free(folder);
    return status;
}

/* -------------------------------------------------------------------- a folder */

/* The files of the first kind that the folder has, by name. */
static enum mpm_status files_of(const char *folder, GPtrArray **files, struct mpm_error *error)
{
    GPtrArray *paths = g_ptr_array_new_with_free_func(g_free), *names;
    unsigned rank = (unsigned)G_N_ELEMENTS(kinds);
    const enum mpm_status status = input_names(folder, &names, error);
    *files = paths;
    for (guint i = 0; status == MPM_OK && i < names->len; i++) {
        const char *const name = names->pdata[i];
        const struct kind *kind = kind_of(name);
        if (kind == NULL || *name == '.' || kind->rank > rank)
            continue;
        if (kind->rank < rank)
            g_ptr_array_set_size(paths, 0);
        rank = kind->rank;
        g_ptr_array_add(paths, g_build_filename(folder, name, NULL));
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    return status;
}

static enum mpm_status add_files(const char *path, const struct score_format *format,
                                 struct score_table *table, struct mpm_error *error)
{
    enum mpm_path kind;
    TRY(input_kind(path, &kind, error));
    if (kind == MPM_PATH_NONE)
        return failure_set(error, MPM_BAD_INPUT, "%s: no such file or folder", path);
    if (kind != MPM_PATH_FOLDER)
        return add_file(path, (double)NAN, format, table, error);
    GPtrArray *paths;
    enum mpm_status status = files_of(path, &paths, error);
    for (guint i = 0; status == MPM_OK && i < paths->len; i++)
        status = add_file(paths->pdata[i], (double)NAN, format, table, error);
    if (status == MPM_OK && paths->len == 0)
        status =
            failure_set(error, MPM_BAD_INPUT,
                        "%s: holds no file .csv, .hdf, .h5, .hdf5, .vtk, .vtu, .vtp or .pvd", path);
    g_ptr_array_unref(paths);
    return status;
}

/* ------------------------------------------------------- what follows from others */

static enum mpm_status keep_body(const char *path, struct score_table *table, int body,
                                 struct mpm_error *error)
{
    if (!score_table_has(table, SCORE_BODY))
        return MPM_OK;
    size_t kept = 0;
    for (size_t p = 0; p < table->rows; p++) {
        if (fabs(score_table_value(table, SCORE_BODY, p) - body) >= 0.5)
            continue;
        for (int c = 0; c < SCORE_COLUMNS; c++)
            if (table->column[c] != NULL)
                g_array_index(table->column[c], double, kept) =
                    g_array_index(table->column[c], double, p);
        kept++;
    }
    if (kept == 0)
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: none of the %zu rows is of body %d, which the problem requires",
                           path, table->rows, body);
    table->rows = kept;
    for (int c = 0; c < SCORE_COLUMNS; c++)
        if (table->column[c] != NULL)
            g_array_set_size(table->column[c], (guint)kept);
    return MPM_OK;
}

/* Doubles tell whole numbers apart up to 2^53, which is a little more. */
static const double ID_MAX = 9e15;

static const struct axis {
    enum score_column initial, current, displacement;
} axes[] = {{SCORE_INITIAL_X, SCORE_X, SCORE_DISPLACEMENT_X},
            {SCORE_INITIAL_Y, SCORE_Y, SCORE_DISPLACEMENT_Y}};

/* Whether the ids are of the same points at all instants: whole numbers, once each at time 0. Fills
 * ids, rows (of table->rows) and start, the rows at time 0 by id. */
static enum mpm_status find_start(const char *path, const struct score_table *table, gint64 *ids,
                                  size_t *rows, GHashTable *start, struct mpm_error *error)
{
    for (size_t p = 0; p < table->rows; p++) {
        const double id = score_table_value(table, SCORE_ID, p);
        if (!(fabs(id) < ID_MAX) || floor(id) < id)
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: point %zu has id %g: allowed are whole numbers below %g", path,
                               p, id, ID_MAX);
        ids[p] = (gint64)id;
        rows[p] = p;
        if (!(fabs(score_table_value(table, SCORE_TIME, p)) > 0) &&
            !g_hash_table_insert(start, &ids[p], &rows[p]))
            return failure_set(error, MPM_BAD_INPUT,
                               "%s: two points have id %g at time 0: allowed is one", path, id);
    }
    return MPM_OK;
}

/* Adds where the points with each id are at time 0; nothing if one has no such row. */
static enum mpm_status trace_back(const char *path, struct score_table *table,
                                  const struct axis *axis, struct mpm_error *error)
{
    GHashTable *start = g_hash_table_new(g_int64_hash, g_int64_equal);
    gint64 *ids = g_new(gint64, table->rows + 1);
    size_t *rows = g_new(size_t, table->rows + 1);
    const enum mpm_status status = find_start(path, table, ids, rows, start, error);
    bool complete = status == MPM_OK;
    for (size_t p = 0; complete && p < table->rows; p++)
        complete = g_hash_table_contains(start, &ids[p]);
    if (complete) {
        double *initial = score_table_add(table, axis->initial);
        for (size_t p = 0; p < table->rows; p++) {
            const size_t *row = g_hash_table_lookup(start, &ids[p]);
            initial[p] = score_table_value(table, axis->current, *row);
        }
    }
    g_hash_table_unref(start);
    g_free(ids);
    g_free(rows);
    return status;
}

/* `sign` times one column added to another. */
static void derive(struct score_table *table, enum score_column wanted, enum score_column one,
                   double sign, enum score_column other)
{
    if (score_table_has(table, wanted) || !score_table_has(table, one) ||
        !score_table_has(table, other))
        return;
    double *values = score_table_add(table, wanted);
    for (size_t p = 0; p < table->rows; p++)
        values[p] = score_table_value(table, one, p) + sign * score_table_value(table, other, p);
}

static enum mpm_status complete(const char *path, struct score_table *table,
                                struct mpm_error *error)
{
    for (size_t a = 0; a < G_N_ELEMENTS(axes); a++) {
        const struct axis *axis = &axes[a];
        derive(table, axis->initial, axis->current, -1, axis->displacement);
        if (!score_table_has(table, axis->initial) && score_table_has(table, axis->current) &&
            score_table_has(table, SCORE_ID) && score_table_has(table, SCORE_TIME))
            TRY(trace_back(path, table, axis, error));
        derive(table, axis->displacement, axis->current, -1, axis->initial);
    }
    return MPM_OK;
}

enum mpm_status results_read(const char *path, const struct score_format *format,
                             struct score_table *table, struct mpm_error *error)
{
    score_table_open(table);
    enum mpm_status status = add_files(path, format, table, error);
    if (status == MPM_OK)
        status = keep_body(path, table, format->body, error);
    if (status == MPM_OK)
        status = complete(path, table, error);
    if (status != MPM_OK)
        score_table_close(table);
    return status;
}
