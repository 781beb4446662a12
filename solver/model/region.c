/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/region.h"

#include <math.h>

static bool polygon_contains(const struct mpm_region *region, double x, double y)
{
    bool inside = false;
    for (size_t k = 0, last = region->point_count - 1; k < region->point_count; last = k++) {
        const double *const a = region->points[k];
        const double *const b = region->points[last];
        if ((a[1] > y) == (b[1] > y))
            continue;
        if (x < mpm_polygon_crossing(a, b, y))
            inside = !inside;
    }
    return inside;
}

/* Sites on a rim are outside the smaller circle: disk and annulus fill a ring and its hole
 * without gap or overlap. */
static bool circle_contains(const double centre[2], double radius, const double point[2],
                            double slack)
{
    const double x = point[0] - centre[0], y = point[1] - centre[1];
    const double reach = radius - slack;
    return reach > 0.0 && x * x + y * y < reach * reach;
}

bool mpm_region_contains(const struct mpm_region *region, const double point[2], double slack)
{
    switch (region->kind) {
    case MPM_REGION_RECTANGLE:
        return point[0] - region->a[0] >= -slack && point[1] - region->a[1] >= -slack &&
               point[0] < region->b[0] - slack && point[1] < region->b[1] - slack;
    case MPM_REGION_DISK:
        return circle_contains(region->a, region->outer, point, slack);
    case MPM_REGION_ANNULUS:
        return circle_contains(region->a, region->outer, point, slack) &&
               !circle_contains(region->a, region->inner, point, slack);
    case MPM_REGION_POLYGON:
        return polygon_contains(region, point[0] + slack, point[1] + slack);
    case MPM_REGION_ALL:
        return true;
    case MPM_REGION_LINE:
        return false;
    }
    return false;
}

static void box(const double a[2], const double b[2], double low[2], double high[2])
{
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmin(a[axis], b[axis]);
        high[axis] = fmax(a[axis], b[axis]);
    }
}

bool mpm_region_touches(const struct mpm_region *region, const double point[2],
                        const double slack[2])
{
    double low[2], high[2];
    if (region->kind == MPM_REGION_ALL)
        return true;
    box(region->a, region->b, low, high);
    for (int axis = 0; axis < 2; axis++)
        if (point[axis] < low[axis] - slack[axis] || point[axis] > high[axis] + slack[axis])
            return false;
    return true;
}

void mpm_region_bounds(const struct mpm_region *region, double low[2], double high[2])
{
    switch (region->kind) {
    case MPM_REGION_RECTANGLE:
    case MPM_REGION_LINE:
        box(region->a, region->b, low, high);
        return;
    case MPM_REGION_DISK:
    case MPM_REGION_ANNULUS:
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = region->a[axis] - region->outer;
            high[axis] = region->a[axis] + region->outer;
        }
        return;
    case MPM_REGION_POLYGON:
        box(region->points[0], region->points[0], low, high);
        for (size_t k = 1; k < region->point_count; k++)
            for (int axis = 0; axis < 2; axis++) {
                low[axis] = fmin(low[axis], region->points[k][axis]);
                high[axis] = fmax(high[axis], region->points[k][axis]);
            }
        return;
    case MPM_REGION_ALL:
        low[0] = low[1] = -HUGE_VAL;
        high[0] = high[1] = HUGE_VAL;
        return;
    }
}
