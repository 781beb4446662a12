/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/series.h"

#include "io/results/crack_lines.h"
#include "io/results/file_write.h"
#include "io/results/snapshot.h"

#include <glib.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

struct mpm_series {
    const char *folder;
    const struct mpm_scene *scene;
    double *work;
    size_t work_size;
    json_t *list;  /* what particles.hdf.series says */
    json_t *files; /* the array in it */
    char *last_name;
    double last_time;
    uint64_t last_step;
};

enum mpm_status mpm_series_create(const char *folder, const struct mpm_scene *scene,
                                  size_t particle_count, struct mpm_series **series,
                                  struct mpm_error *error)
{
    struct mpm_series *created = g_new0(struct mpm_series, 1);
    *series = NULL;
    created->folder = folder;
    created->scene = scene;
    created->work_size = mpm_snapshot_work_size(scene, particle_count);
    created->work = calloc(created->work_size, sizeof *created->work);
    created->list = json_pack("{s:s, s:[]}", "file-series-version", "1.0", "files");
    created->files = json_object_get(created->list, "files");
    if (created->work == NULL || created->files == NULL) {
        const size_t bytes = mpm_series_bytes(created);
        mpm_series_free(created);
        return mpm_error_memory(error, bytes, "writing snapshots");
    }
    *series = created;
    return MPM_OK;
}

void mpm_series_free(struct mpm_series *series)
{
    if (series == NULL)
        return;
    free(series->work);
    json_decref(series->list);
    g_free(series->last_name);
    g_free(series);
}

size_t mpm_series_bytes(const struct mpm_series *series)
{
    return series->work_size * sizeof *series->work;
}

const char *mpm_series_last(const struct mpm_series *series, double *time)
{
    *time = series->last_time;
    return series->last_name;
}

static enum mpm_status snapshot_write(const struct mpm_series *series, const char *name,
                                      const struct mpm_simulation *simulation,
                                      struct mpm_error *error)
{
    char *path = g_build_filename(series->folder, name, NULL);
    const enum mpm_status status =
        mpm_snapshot_write(path, series->scene, simulation, series->work, error);
    g_free(path);
    return status;
}

/* Adds a snapshot, of which the name is g_free'd. */
static void append(struct mpm_series *series, char *name, double time)
{
    g_free(series->last_name);
    series->last_name = name;
    series->last_time = time;
    (void)json_array_append_new(series->files, json_pack("{s:s, s:f}", "name", name, "time", time));
}

static char *name_of(size_t number)
{
    return g_strdup_printf(MPM_SERIES_PREFIX "%0*zu" MPM_SERIES_SUFFIX, MPM_SERIES_DIGITS, number);
}

void mpm_series_visit(struct mpm_series *series, struct mpm_piece_visitor *visitor)
{
    static const uint64_t most = 100000000;
    const size_t known = json_array_size(series->files);
    uint64_t count = known;
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, &count, 1, "snapshots.count", -1);
    mpm_piece_visit(visitor, MPM_PIECE_UINT64, &series->last_step, 1, "snapshots.last_step", -1);
    double *const times = count <= most ? calloc(count + 1, sizeof *times) : NULL;
    if (times == NULL) {
        mpm_piece_refuse(visitor, "snapshots.count");
        return;
    }
    for (size_t k = 0; k < known; k++)
        times[k] = json_real_value(json_object_get(json_array_get(series->files, k), "time"));
    mpm_piece_visit(visitor, MPM_PIECE_DOUBLE, times, count, "snapshots.time", -1);
    for (size_t k = known; k < count && visitor->status == MPM_OK; k++)
        append(series, name_of(k), times[k]);
    free(times);
}

size_t mpm_series_count(const struct mpm_series *series)
{
    return json_array_size(series->files);
}

enum mpm_status mpm_series_write_list(const struct mpm_series *series, struct mpm_error *error)
{
    return mpm_file_write_json(series->folder, MPM_SERIES_LIST, series->list, 1, error);
}

bool mpm_series_number(const char *name, const char *prefix, const char *suffix, uint64_t *number)
{
    if (!g_str_has_prefix(name, prefix))
        return false;
    const char *const start = name + strlen(prefix);
    const size_t digits = strspn(start, "0123456789");
    *number = g_ascii_strtoull(start, NULL, 10);
    return digits > 0 && strcmp(start + digits, suffix) == 0;
}

/* The list of the cracks' files names one for each snapshot, at the same times. */
static enum mpm_status write_crack_list(const struct mpm_series *series, struct mpm_error *error)
{
    json_t *const list = json_pack("{s:s, s:[]}", "file-series-version", "1.0", "files");
    for (size_t k = 0; k < json_array_size(series->files); k++) {
        char *const name = mpm_crack_lines_name(k);
        json_t *const time = json_object_get(json_array_get(series->files, k), "time");
        (void)json_array_append_new(json_object_get(list, "files"),
                                    json_pack("{s:s, s:O}", "name", name, "time", time));
        g_free(name);
    }
    const enum mpm_status status =
        mpm_file_write_json(series->folder, MPM_CRACKS_LIST, list, 1, error);
    json_decref(list);
    return status;
}

static enum mpm_status write_cracks(const struct mpm_series *series,
                                    const struct mpm_simulation *simulation,
                                    struct mpm_error *error)
{
    if (series->scene->crack_count == 0)
        return MPM_OK;
    MPM_TRY(mpm_crack_lines_write(series->folder, json_array_size(series->files) - 1, series->scene,
                                  simulation, error));
    return write_crack_list(series, error);
}

enum mpm_status mpm_series_write(struct mpm_series *series, const struct mpm_simulation *simulation,
                                 struct mpm_error *error)
{
    const double time = mpm_simulation_time(simulation);
    const uint64_t step = mpm_simulation_step(simulation);
    if (series->last_name != NULL && series->last_step == step)
        return MPM_OK;
    char *name = name_of(json_array_size(series->files));
    const enum mpm_status status = snapshot_write(series, name, simulation, error);
    if (status != MPM_OK) {
        g_free(name);
        return status;
    }
    append(series, name, time);
    series->last_step = step;
    MPM_TRY(mpm_series_write_list(series, error));
    return write_cracks(series, simulation, error);
}
