/* The regions of bodies and boundaries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "model/region.h"

#include <math.h>

static void read_pair(char *const texts[2], double pair[2])
{
    for (int i = 0; i < 2; i++)
        pair[i] = mpm_raw_double(texts[i]);
}

/* ------------------------------------------------------------------ shapes */

static enum mpm_status build_rectangle(const struct mpm_reading *reading, const char *path,
                                       const struct mpm_raw_rectangle *raw,
                                       struct mpm_region *region)
{
    region->kind = MPM_REGION_RECTANGLE;
    read_pair(raw->from, region->a);
    read_pair(raw->to, region->b);
    if (region->a[0] < region->b[0] && region->a[1] < region->b[1])
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "no area, got from [%s, %s] and to [%s, %s]; allowed: from below to "
                             "in both components",
                             raw->from[0], raw->from[1], raw->to[0], raw->to[1]);
}

static enum mpm_status build_annulus(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_raw_annulus *raw, struct mpm_region *region)
{
    region->kind = MPM_REGION_ANNULUS;
    read_pair(raw->center, region->a);
    region->inner = mpm_raw_double(raw->inner);
    region->outer = mpm_raw_double(raw->outer);
    if (region->inner < region->outer)
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "no area, got inner %s and outer %s; allowed: inner below outer",
                             raw->inner, raw->outer);
}

static void build_disk(const struct mpm_raw_disk *raw, struct mpm_region *region)
{
    region->kind = MPM_REGION_DISK;
    read_pair(raw->center, region->a);
    region->outer = mpm_raw_double(raw->radius);
}

/* Ends in ascending order; parallel to an axis. */
static enum mpm_status build_line(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_raw_line *raw, struct mpm_region *region)
{
    double from[2], to[2];
    region->kind = MPM_REGION_LINE;
    read_pair(raw->from, from);
    read_pair(raw->to, to);
    for (int i = 0; i < 2; i++) {
        region->a[i] = fmin(from[i], to[i]);
        region->b[i] = fmax(from[i], to[i]);
    }
    if (from[0] == to[0] || from[1] == to[1])
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "an oblique line, got from [%s, %s] and to [%s, %s]; allowed: "
                             "parallel to an axis",
                             raw->from[0], raw->from[1], raw->to[0], raw->to[1]);
}

/* ---------------------------------------------------------------- polygons */

/* Twice the signed area of a triangle: which side of ab is c on? */
static double side(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool between(double a, double b, double c)
{
    return fmin(a, b) <= c && c <= fmax(a, b);
}

/* Is c, known to be in line with ab, on the segment ab? */
static bool on_segment(const double a[2], const double b[2], const double c[2])
{
    return between(a[0], b[0], c[0]) && between(a[1], b[1], c[1]);
}

static bool boxes_apart(const double a[2], const double b[2], const double c[2], const double d[2])
{
    for (int i = 0; i < 2; i++)
        if (fmax(a[i], b[i]) < fmin(c[i], d[i]) || fmax(c[i], d[i]) < fmin(a[i], b[i]))
            return true;
    return false;
}

/* Do segments ab and cd cross or touch? */
static bool segments_meet(const double a[2], const double b[2], const double c[2],
                          const double d[2])
{
    if (boxes_apart(a, b, c, d))
        return false;
    const double ca = side(c, d, a), cb = side(c, d, b), ac = side(a, b, c), ad = side(a, b, d);
    if (((ca > 0.0 && cb < 0.0) || (ca < 0.0 && cb > 0.0)) &&
        ((ac > 0.0 && ad < 0.0) || (ac < 0.0 && ad > 0.0)))
        return true;
    return (ca == 0.0 && on_segment(c, d, a)) || (cb == 0.0 && on_segment(c, d, b)) ||
           (ac == 0.0 && on_segment(a, b, c)) || (ad == 0.0 && on_segment(a, b, d));
}

/* Neighbouring edges ab, bc may only share b: no fold back, no repeated corner. */
static bool edges_fold(const double a[2], const double b[2], const double c[2])
{
    const double along = (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]);
    const bool repeated = b[0] == c[0] && b[1] == c[1];
    return repeated || (side(a, b, c) == 0.0 && along > 0.0);
}

/* Edge i runs from corner i to the next. */
static bool edges_conflict(const struct mpm_region *region, size_t i, size_t j)
{
    double(*const p)[2] = region->points;
    const size_t n = region->point_count, after_i = (i + 1) % n, after_j = (j + 1) % n;
    if (after_i == j)
        return edges_fold(p[i], p[j], p[after_j]);
    if (after_j == i)
        return edges_fold(p[j], p[i], p[after_i]);
    return segments_meet(p[i], p[after_i], p[j], p[after_j]);
}

static enum mpm_status check_polygon(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_region *region)
{
    const size_t n = region->point_count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n; j++)
            if (edges_conflict(region, i, j))
                return mpm_reading_fault(reading, path,
                                         "edges cross, touch or have no length, the ones that "
                                         "start at points %zu and %zu; allowed: a simple polygon, "
                                         "its last point not the first again",
                                         i, j);
    double area = 0.0;
    for (size_t i = 2; i < n; i++)
        area += side(region->points[0], region->points[i - 1], region->points[i]);
    if (area != 0.0)
        return MPM_OK;
    return mpm_reading_fault(reading, path, "no area; allowed: a polygon with an inside");
}

static enum mpm_status build_polygon(const struct mpm_reading *reading, const char *path,
                                     const struct mpm_raw_polygon *raw, struct mpm_region *region)
{
    region->kind = MPM_REGION_POLYGON;
    MPM_TRY(mpm_reading_allocate(reading, raw->points_count, sizeof region->points[0],
                                 "a polygon's points", &region->points));
    region->point_count = raw->points_count;
    for (size_t i = 0; i < region->point_count; i++)
        read_pair(raw->points[i], region->points[i]);
    return check_polygon(reading, mpm_path_join(path, "points").text, region);
}

/* ----------------------------------------------------------------- regions */

/* All that a region has is shapes. */
static enum mpm_status check_one_shape(const struct mpm_reading *reading, const char *path,
                                       const char *list)
{
    const struct mpm_key *const entry = mpm_key_find(&mpm_scene_root, list);
    const size_t count = mpm_tree_find(reading->root, path, NULL)->count;
    char allowed[MPM_ALLOWED_SIZE];
    if (count == 1)
        return MPM_OK;
    return mpm_reading_fault(reading, path, "%zu shapes given; allowed: exactly one of %s", count,
                             mpm_key_children(mpm_key_find(entry, "region"), allowed));
}

/* A body must lie inside the grid; what it has at r <= 0 does not count in axisymmetry. */
static enum mpm_status check_inside_grid(const struct mpm_reading *reading, const char *path,
                                         const struct mpm_region *region)
{
    const struct mpm_scene *scene = reading->scene;
    double low[2], high[2];
    mpm_region_bounds(region, low, high);
    if (scene->geometry == MPM_AXISYMMETRIC && high[0] <= 0.0)
        return mpm_reading_fault(
            reading, path, "no part has r > 0, it ends at r = %g; allowed: r above 0", high[0]);
    if (scene->geometry == MPM_AXISYMMETRIC)
        low[0] = fmax(low[0], 0.0);
    for (int i = 0; i < 2; i++) {
        const double first = scene->origin[i];
        const double last = first + (double)scene->cells[i] * scene->cell[i];
        const double slack = 1e-9 * scene->cell[i];
        if (low[i] < first - slack || high[i] > last + slack)
            return mpm_reading_fault(reading, path,
                                     "outside the grid, %s from %g to %g; allowed: %g to %g",
                                     mpm_scene_coordinates(scene)[i], low[i], high[i], first, last);
    }
    return MPM_OK;
}

static enum mpm_status build_body_shape(const struct mpm_reading *reading, const char *path,
                                        const struct mpm_raw_body_region *raw,
                                        struct mpm_region *region)
{
    if (raw->rectangle != NULL)
        return build_rectangle(reading, mpm_path_join(path, "rectangle").text, raw->rectangle,
                               region);
    if (raw->annulus != NULL)
        return build_annulus(reading, mpm_path_join(path, "annulus").text, raw->annulus, region);
    if (raw->polygon != NULL)
        return build_polygon(reading, mpm_path_join(path, "polygon").text, raw->polygon, region);
    build_disk(raw->disk, region);
    return MPM_OK;
}

enum mpm_status mpm_build_body_region(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_body_region *raw,
                                      struct mpm_region *region)
{
    MPM_TRY(check_one_shape(reading, path, "bodies"));
    MPM_TRY(build_body_shape(reading, path, raw, region));
    return check_inside_grid(reading, path, region);
}

enum mpm_status mpm_build_boundary_region(const struct mpm_reading *reading, const char *path,
                                          const struct mpm_raw_boundary_region *raw,
                                          struct mpm_region *region)
{
    MPM_TRY(check_one_shape(reading, path, "boundary"));
    if (raw->line != NULL)
        return build_line(reading, mpm_path_join(path, "line").text, raw->line, region);
    if (raw->rectangle != NULL)
        return build_rectangle(reading, mpm_path_join(path, "rectangle").text, raw->rectangle,
                               region);
    if (!raw->all)
        return mpm_reading_fault(reading, mpm_path_join(path, "all").text,
                                 "got false; allowed: true");
    region->kind = MPM_REGION_ALL;
    return MPM_OK;
}

/* ------------------------------------------------------------------ sample */

/* Somewhere between, at no simple fraction. */
static double off_centre(double low, double high)
{
    const double fraction = 0.4142135623730951;
    return low + fraction * (high - low);
}

void mpm_region_sample(const struct mpm_scene *scene, const struct mpm_region *region,
                       double place[2])
{
    if (region->kind == MPM_REGION_POLYGON) { /* on its first edge: the box may be outside */
        for (int i = 0; i < 2; i++)
            place[i] = off_centre(region->points[0][i], region->points[1][i]);
    } else if (region->kind == MPM_REGION_ANNULUS) { /* in its right part, at no simple angle */
        const double radius = off_centre(region->inner, region->outer);
        place[0] = region->a[0] + radius * 0.96;
        place[1] = region->a[1] + radius * 0.28;
    } else {
        double low[2], high[2];
        mpm_region_bounds(region, low, high);
        for (int i = 0; i < 2; i++) {
            const double first = scene->origin[i];
            const double last = first + (double)scene->cells[i] * scene->cell[i];
            place[i] = off_centre(fmax(low[i], first), fmin(high[i], last));
        }
    }
    if (scene->geometry == MPM_AXISYMMETRIC && place[0] <= 0.0)
        place[0] = off_centre(0.0, scene->cell[0]);
}
