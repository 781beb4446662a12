/* Planes of symmetry among a scene's boundaries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <math.h>

/* A plane is on a line of nodes within this distance, in cells: that of model/boundary.c. */
static const double NODE_SLACK = 1e-6;

/* The reflection of a node must be a node. */
static enum mpm_status check_place(const struct mpm_reading *reading, const char *path, int normal,
                                   double place)
{
    const struct mpm_scene *const scene = reading->scene;
    const char *const name = mpm_scene_coordinates(scene)[normal];
    const double index = (place - scene->origin[normal]) / scene->cell[normal];
    const double nearest = fmin(fmax(nearbyint(index), 0.0), (double)scene->cells[normal]);
    if (scene->geometry == MPM_AXISYMMETRIC && normal == 0 &&
        place <= NODE_SLACK * scene->cell[normal])
        return mpm_reading_fault(reading, path,
                                 "a plane of symmetry at r = %g; allowed: r above 0, since the "
                                 "axis needs no boundary",
                                 place);
    if (fabs(index - nearest) > NODE_SLACK)
        return mpm_reading_fault(reading, path,
                                 "a plane of symmetry between nodes or off the grid, got %s = %g, "
                                 "the nearest nodes are at %g; allowed: on a line of nodes, to "
                                 "1e-6 of a cell",
                                 name, place,
                                 scene->origin[normal] + nearest * scene->cell[normal]);
    return MPM_OK;
}

enum mpm_status mpm_build_symmetry(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_boundary *raw,
                                   struct mpm_boundary_spec *boundary)
{
    const struct mpm_region *const region = &boundary->region;
    const struct mpm_path key = mpm_path_join(path, "symmetry");
    const struct mpm_path line = mpm_path_join(path, "region.line");
    if (!raw->symmetry)
        return mpm_reading_fault(reading, key.text,
                                 "got false; allowed: true, or a velocity instead");
    if (region->kind != MPM_REGION_LINE)
        return mpm_reading_fault(reading, key.text,
                                 "a plane of symmetry with a region other than a line; allowed: "
                                 "region: {line: ...}");
    if (region->a[0] == region->b[0] && region->a[1] == region->b[1])
        return mpm_reading_fault(reading, line.text,
                                 "a plane of symmetry that is a single point, got (%g, %g); "
                                 "allowed: a line with a length",
                                 region->a[0], region->a[1]);
    boundary->symmetry = true;
    boundary->normal = region->a[0] == region->b[0] ? 0 : 1;
    MPM_TRY(check_place(reading, line.text, boundary->normal, region->a[boundary->normal]));
    return mpm_reading_copy(reading, "0", &boundary->velocity.text[boundary->normal]);
}
