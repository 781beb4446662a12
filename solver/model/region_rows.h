/* Which sites of a row of the lattice are inside a region: stretches of columns, found without
 * looking at each site.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_REGION_ROWS_H
#define MPM_MODEL_REGION_ROWS_H

#include "base/status.h"
#include "model/region.h"

/* Columns first <= c < end of a row at height y; column c is at x = origin + step (c + 0.5). */
struct mpm_site_row {
    double origin, step, y;
    int64_t first, end;
};

static inline double mpm_site_place(const struct mpm_site_row *row, int64_t column)
{
    return row->origin + row->step * ((double)column + 0.5);
}

/* A region that is read row by row. `breaks` has the columns at which a row goes in and out of the
 * region in turn: columns breaks[0] <= c < breaks[1], breaks[2] <= c < breaks[3] and so on are
 * inside, by mpm_region_contains and to the last bit. */
struct mpm_region_rows {
    const struct mpm_region *region;
    double slack;
    double low[2], high[2]; /* the smallest box around the region */
    int64_t *breaks;
    struct mpm_polygon_edge *edges; /* polygons only: by their lower end */
    size_t edge_count, edges_begun;
    size_t *crossed; /* edges that the last row crosses, in the order of its breaks */
    size_t crossed_count;
    double last_y;
};

/* For rectangles, disks, annuli and polygons. MPM_ENVIRONMENT_FAILED: no memory. */
enum mpm_status mpm_region_rows_open(const struct mpm_region *region, double slack,
                                     struct mpm_region_rows *rows, struct mpm_error *error);
void mpm_region_rows_close(struct mpm_region_rows *rows);

/* Sets rows->breaks and returns their number, which is even. Cost: O(log columns) for each time
 * that the row crosses the region's outline, if rows come in rising order of y; a row below the
 * last one starts a polygon anew. */
size_t mpm_region_rows_find(struct mpm_region_rows *rows, const struct mpm_site_row *row);

#endif
