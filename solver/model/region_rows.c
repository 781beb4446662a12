/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/region_rows.h"

#include <math.h>
#include <stdlib.h>

struct mpm_polygon_edge {
    double low, high; /* the y at which a row crosses it: low <= y < high */
    const double *a, *b;
};

/* ------------------------------------------------------------------- breaks */

/* An end of a stretch: which columns of a row are before it? None after one that is not. */
struct row_end {
    double guess;  /* the x at which it is, but for slack and, unless of a polygon, round-off */
    double middle; /* an x inside the region, if the row meets it */
    bool right;    /* the region's right end, or its left one */
    const struct mpm_region *region; /* a rectangle or disk; NULL: an edge of a polygon */
    double slack;
};

static bool is_before(const struct row_end *end, const struct mpm_site_row *row, int64_t column)
{
    const double point[2] = {mpm_site_place(row, column), row->y};
    if (end->region == NULL)
        return point[0] + end->slack < end->guess;
    if (end->right)
        return point[0] < end->middle || mpm_region_contains(end->region, point, end->slack);
    return point[0] < end->middle && !mpm_region_contains(end->region, point, end->slack);
}

/* The first column that is not before the end: next to the guess, or else by bisection of all. */
static int64_t find_break(const struct row_end *end, const struct mpm_site_row *row)
{
    int64_t low = row->first, high = row->end; /* the answer is in low..high */
    const double guess = floor((end->guess - row->origin) / row->step);
    const double near = fmin(fmax(guess, (double)row->first), (double)row->end);
    const int64_t probes[2] = {(int64_t)near - 1, (int64_t)near + 2};
    for (int k = 0; k < 2; k++)
        if (probes[k] > low && probes[k] < high) {
            if (is_before(end, row, probes[k]))
                low = probes[k] + 1;
            else
                high = probes[k];
        }
    while (low < high) {
        const int64_t column = low + (high - low) / 2;
        if (is_before(end, row, column))
            low = column + 1;
        else
            high = column;
    }
    return low;
}

/* A convex region has one stretch in a row, perhaps an empty one. */
static void find_stretch(const struct mpm_region *region, double slack,
                         const struct mpm_site_row *row, int64_t stretch[2])
{
    struct row_end end = {.region = region, .slack = slack};
    double guess[2] = {region->a[0], region->b[0]};
    end.middle = 0.5 * (guess[0] + guess[1]);
    if (region->kind == MPM_REGION_DISK) {
        const double y = row->y - region->a[1];
        const double half = sqrt(fmax(0.0, region->outer * region->outer - y * y));
        end.middle = region->a[0];
        guess[0] = region->a[0] - half;
        guess[1] = region->a[0] + half;
    }
    for (int side = 0; side < 2; side++) {
        end.right = side == 1;
        end.guess = guess[side];
        stretch[side] = find_break(&end, row);
    }
}

/* Without its hole. */
static size_t find_annulus(const struct mpm_region_rows *rows, const struct mpm_site_row *row)
{
    struct mpm_region disk = *rows->region;
    int64_t hole[2], *const breaks = rows->breaks;
    disk.kind = MPM_REGION_DISK;
    find_stretch(&disk, rows->slack, row, breaks);
    disk.outer = disk.inner;
    find_stretch(&disk, rows->slack, row, hole);
    if (hole[0] >= hole[1])
        return 2;
    breaks[3] = breaks[1];
    breaks[1] = hole[0];
    breaks[2] = hole[1];
    return 4;
}

/* ----------------------------------------------------------------- polygons */

static int by_lower_end(const void *left, const void *right)
{
    const struct mpm_polygon_edge *const a = left, *const b = right;
    return (a->low > b->low) - (a->low < b->low);
}

static void list_edges(struct mpm_region_rows *rows)
{
    const struct mpm_region *const region = rows->region;
    for (size_t k = 0, last = region->point_count - 1; k < region->point_count; last = k++) {
        const double *const a = region->points[k], *const b = region->points[last];
        if (a[1] != b[1])
            rows->edges[rows->edge_count++] = (struct mpm_polygon_edge){
                .low = fmin(a[1], b[1]), .high = fmax(a[1], b[1]), .a = a, .b = b};
    }
    qsort(rows->edges, rows->edge_count, sizeof *rows->edges, by_lower_end);
}

static void choose_crossed(struct mpm_region_rows *rows, double y)
{
    if (y < rows->last_y)
        rows->edges_begun = rows->crossed_count = 0;
    rows->last_y = y;
    for (; rows->edges_begun < rows->edge_count && rows->edges[rows->edges_begun].low <= y;
         rows->edges_begun++)
        rows->crossed[rows->crossed_count++] = rows->edges_begun;
    size_t kept = 0;
    for (size_t k = 0; k < rows->crossed_count; k++)
        if (y < rows->edges[rows->crossed[k]].high)
            rows->crossed[kept++] = rows->crossed[k];
    rows->crossed_count = kept;
}

/* Edges of a simple polygon keep their order from row to row, so that sorting them takes few
 * exchanges. */
static size_t find_polygon(struct mpm_region_rows *rows, const struct mpm_site_row *row)
{
    const double y = row->y + rows->slack;
    choose_crossed(rows, y);
    for (size_t k = 0; k < rows->crossed_count; k++) {
        const size_t crossed = rows->crossed[k];
        const struct mpm_polygon_edge *const edge = &rows->edges[crossed];
        const struct row_end end = {.guess = mpm_polygon_crossing(edge->a, edge->b, y),
                                    .slack = rows->slack};
        const int64_t column = find_break(&end, row);
        size_t place = k;
        for (; place > 0 && rows->breaks[place - 1] > column; place--) {
            rows->breaks[place] = rows->breaks[place - 1];
            rows->crossed[place] = rows->crossed[place - 1];
        }
        rows->breaks[place] = column;
        rows->crossed[place] = crossed;
    }
    return rows->crossed_count;
}

/* ------------------------------------------------------------------ regions */

enum mpm_status mpm_region_rows_open(const struct mpm_region *region, double slack,
                                     struct mpm_region_rows *rows, struct mpm_error *error)
{
    enum { BREAKS_OF_ANNULUS = 4 };
    const size_t edges = region->kind == MPM_REGION_POLYGON ? region->point_count : 0;
    *rows = (struct mpm_region_rows){.region = region, .slack = slack, .last_y = -HUGE_VAL};
    mpm_region_bounds(region, rows->low, rows->high);
    rows->breaks = calloc(edges + BREAKS_OF_ANNULUS, sizeof *rows->breaks);
    rows->edges = calloc(edges + 1, sizeof *rows->edges);
    rows->crossed = calloc(edges + 1, sizeof *rows->crossed);
    if (rows->breaks == NULL || rows->edges == NULL || rows->crossed == NULL) {
        mpm_region_rows_close(rows);
        return mpm_error_memory(error, (edges + 1) * sizeof *rows->edges, "the outline of a body");
    }
    if (edges > 0)
        list_edges(rows);
    return MPM_OK;
}

void mpm_region_rows_close(struct mpm_region_rows *rows)
{
    free(rows->breaks);
    free(rows->edges);
    free(rows->crossed);
    *rows = (struct mpm_region_rows){0};
}

size_t mpm_region_rows_find(struct mpm_region_rows *rows, const struct mpm_site_row *row)
{
    switch (rows->region->kind) {
    case MPM_REGION_RECTANGLE:
    case MPM_REGION_DISK:
        find_stretch(rows->region, rows->slack, row, rows->breaks);
        return 2;
    case MPM_REGION_ANNULUS:
        return find_annulus(rows, row);
    case MPM_REGION_POLYGON:
        return find_polygon(rows, row);
    case MPM_REGION_ALL:
    case MPM_REGION_LINE:
        break; /* no body has one of these */
    }
    return 0;
}
