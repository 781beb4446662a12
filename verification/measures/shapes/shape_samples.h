/* Seeded random particle domains, on which shape functions are compared and summed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_SHAPE_SAMPLES_H
#define VERIFICATION_MEASURES_SHAPE_SAMPLES_H

#include "mpm.h"

/* Where a domain lies. Lengths are in cells, r from the axis, x from node (0, 0). */
enum shape_region {
    /* Anywhere over nodes 0 to 5, r >= 0.02, CPDI r >= 0.2 of the domain's reach in r. */
    SHAPE_REGION_NEAR,
    /* A domain edge, its centre or (CPDI) a corner within 1e-12 of a grid line, on either
     * side of it; classic: the centre, never nearer than 1e-12, where grad N jumps; B-splines:
     * a knot or an edge, every half cell. */
    SHAPE_REGION_BOUNDARY,
    /* Axisymmetry: the domain reaches r = 0 or just misses it, down to r_p = 0 for truncated
     * uGIMP, 0.01 cells for classic and B-splines, 0.01 of the half width for untruncated uGIMP and
     * 0.2 of the reach for CPDI (whose truncated domain shrinks with r_p, and with it the accuracy
     * of any difference of N over it). Planar: as near. */
    SHAPE_REGION_AXIS,
    /* Over node 1000, all sizes and positions such that they are exact in cells. */
    SHAPE_REGION_FAR,
    /* Over node 1000, anywhere: rounding the position alone moves G by eps 1000 (2 / l_p). */
    SHAPE_REGION_FAR_ANYWHERE,
    SHAPE_REGION_COUNT,
};

struct shape_sampler; /* GSL's mt19937 */

/* The same seed gives the same domains on every machine. NULL when out of memory. */
struct shape_sampler *shape_sampler_create(unsigned long seed);
void shape_sampler_free(struct shape_sampler *sampler);

/* Draws one domain: l_p from 0.05 to 1 and edges of the cell by 0.4 to 2.5 of each other,
 * each axis for itself; F = R(angle) [[a, c], [0, b]] with any angle, a and b from 0.6 to
 * 1.8, c up to 0.6 either way; an origin that puts r = 0 on column 0, 1 or 2; for B-splines,
 * four grids of five have edges, the last node less than five cells above the point. `kind` gives
 * shape, geometry and axis; all else of *query is set. */
void shape_sampler_draw(struct shape_sampler *sampler, const struct mpm_shape_query *kind,
                        enum shape_region region, struct mpm_shape_query *query);

#endif
