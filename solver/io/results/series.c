/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/series.h"

#include "io/results/file_write.h"
#include "io/results/snapshot.h"

#include <glib.h>
#include <jansson.h>
#include <stdlib.h>

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

enum mpm_status mpm_series_write(struct mpm_series *series, const struct mpm_simulation *simulation,
                                 struct mpm_error *error)
{
    const double time = mpm_simulation_time(simulation);
    const uint64_t step = mpm_simulation_step(simulation);
    if (series->last_name != NULL && series->last_step == step)
        return MPM_OK;
    char *name = g_strdup_printf(MPM_SERIES_PREFIX "%0*zu" MPM_SERIES_SUFFIX, MPM_SERIES_DIGITS,
                                 json_array_size(series->files));
    const enum mpm_status status = snapshot_write(series, name, simulation, error);
    if (status != MPM_OK) {
        g_free(name);
        return status;
    }
    g_free(series->last_name);
    series->last_name = name;
    series->last_time = time;
    series->last_step = step;
    (void)json_array_append_new(series->files, json_pack("{s:s, s:f}", "name", name, "time", time));
    return mpm_file_write_json(series->folder, MPM_SERIES_LIST, series->list, 1, error);
}
