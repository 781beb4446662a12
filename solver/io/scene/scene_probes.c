/* Probes and lines of a scene's output.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <stdio.h>
#include <string.h>

/* Fields are where particles are, and those stay in the grid. */
static enum mpm_status check_place(const struct mpm_reading *reading, const char *path,
                                   const double place[2])
{
    const struct mpm_scene *const scene = reading->scene;
    for (int k = 0; k < 2; k++) {
        const double low = scene->origin[k];
        const double high = low + (double)scene->cells[k] * scene->cell[k];
        if (!(place[k] >= low && place[k] <= high))
            return mpm_reading_fault(reading, path,
                                     "outside the grid, got %s = %g; allowed: from %g to %g",
                                     mpm_scene_coordinates(scene)[k], place[k], low, high);
    }
    return MPM_OK;
}

static enum mpm_status check_name(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_probe_spec *own)
{
    if (strpbrk(own->name, ",\"") != NULL)
        return mpm_reading_fault(reading, path,
                                 "the name has a comma or a quote; allowed: others, "
                                 "for a column of probes.csv");
    for (const struct mpm_probe_spec *other = reading->scene->probes; other != own; other++)
        if (strcmp(other->name, own->name) == 0)
            return mpm_reading_fault(
                reading, path, "another probe or line is named \"%s\"; allowed: one of a name",
                own->name);
    return MPM_OK;
}

static enum mpm_status build_one(const struct mpm_reading *reading, const char *path,
                                 const char *name, char *const from[2], char *const to[2],
                                 int64_t points)
{
    struct mpm_scene *const scene = reading->scene;
    struct mpm_probe_spec *const made = &scene->probes[scene->probe_count++];
    (void)snprintf(made->name, sizeof made->name, "%s", name);
    made->points = points;
    for (int k = 0; k < 2; k++) {
        made->from[k] = mpm_raw_double(from[k]);
        made->to[k] = mpm_raw_double(to[k]);
    }
    MPM_TRY(check_name(reading, path, made));
    MPM_TRY(check_place(reading, path, made->from));
    return check_place(reading, path, made->to);
}

enum mpm_status mpm_build_probes(const struct mpm_reading *reading)
{
    const struct mpm_raw_output *const raw = reading->raw->output;
    const size_t count = (size_t)raw->probes_count + raw->lines_count;
    if (count == 0)
        return MPM_OK;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *reading->scene->probes, "probes",
                                 &reading->scene->probes));
    for (size_t i = 0; i < raw->probes_count; i++) {
        const struct mpm_raw_probe *const one = &raw->probes[i];
        MPM_TRY(build_one(reading, mpm_path_entry("output.probes", i).text, one->name, one->at,
                          one->at, 1));
    }
    for (size_t i = 0; i < raw->lines_count; i++) {
        const struct mpm_raw_probe_line *const one = &raw->lines[i];
        MPM_TRY(build_one(reading, mpm_path_entry("output.lines", i).text, one->name, one->from,
                          one->to, one->points));
    }
    return MPM_OK;
}
