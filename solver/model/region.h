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

/* Is a node on it (to `slack` along each axis)? For lines (parallel to an axis or not),
 * rectangles and `all`. */
bool mpm_region_touches(const struct mpm_region *region, const double point[2],
                        const double slack[2]);

/* Smallest box around the region; for `all` the box is infinite. */
void mpm_region_bounds(const struct mpm_region *region, double low[2], double high[2]);

#endif
