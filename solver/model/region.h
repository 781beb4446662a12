/* Regions of the plane: what bodies fill and where boundary conditions hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_REGION_H
#define MPM_MODEL_REGION_H

#include "model/scene.h"

/* Is a lattice site inside? Lower and left edges of rectangles count as inside, upper
 * and right ones as outside, so that bodies side by side never claim one site; `slack`
 * (a small fraction of a cell) keeps round-off from deciding. */
bool mpm_region_contains(const struct mpm_region *region, const double point[2], double slack);

/* The x at which an edge of a polygon from b to a crosses the height y; b[1] != a[1]. A point is
 * inside if it has an odd number of crossings beyond it. */
static inline double mpm_polygon_crossing(const double a[2], const double b[2], double y)
{
    return a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
}

/* Is a node on it (to `slack` along each axis)? For lines (parallel to an axis or not),
 * rectangles and `all`. */
bool mpm_region_touches(const struct mpm_region *region, const double point[2],
                        const double slack[2]);

/* Smallest box around the region; for `all` the box is infinite. */
void mpm_region_bounds(const struct mpm_region *region, double low[2], double high[2]);

#endif
