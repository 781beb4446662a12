/* Filling bodies: rows of sites are read by their ends, and give the sites that a test of each one
 * gives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/scene_files.h"

#include "model/fill.h"
#include "model/region_rows.h"

#include <glib.h>
#include <math.h>

/* ------------------------------------------------------------------ regions */

enum { POINTS_MAX = 40, COLUMNS = 37, ROWS = 29 };
static const double SLACK = 1e-9;

/* Half of all numbers are multiples of a quarter: on sites, or on the edges of cells. */
static double draw(GRand *random, double low, double high)
{
    const double number = g_rand_double_range(random, low, high);
    return g_rand_boolean(random) ? number : 0.25 * round(4.0 * number);
}

/* A polygon without crossings: a star of spikes, or the teeth of a comb. */
static void draw_polygon(GRand *random, struct mpm_region *region, double points[][2])
{
    const bool comb = g_rand_boolean(random);
    const int count = comb ? 2 * g_rand_int_range(random, 2, POINTS_MAX / 2 + 1)
                           : g_rand_int_range(random, 3, POINTS_MAX + 1);
    const double low = draw(random, 0.0, 10.0), high = low + 0.25 + draw(random, 0.0, 25.0);
    for (int k = 0; k < count; k++) {
        const double angle = 2.0 * G_PI * (k + g_rand_double_range(random, 0.0, 0.9)) / count;
        const double radius = g_rand_double_range(random, 1.0, 18.0);
        points[k][0] = comb ? 1.0 + 30.0 * k / count : 18.0 + radius * cos(angle);
        points[k][1] = comb ? (k % 2 == 0 ? low : high) : 14.0 + radius * sin(angle);
    }
    if (comb) { /* closed below */
        points[0][1] = points[count - 1][1] = low - 0.5;
    }
    region->points = points;
    region->point_count = (size_t)count;
}

static struct mpm_region draw_region(GRand *random, enum mpm_region_kind kind, double points[][2])
{
    struct mpm_region region = {.kind = kind};
    if (kind == MPM_REGION_POLYGON)
        draw_polygon(random, &region, points);
    for (int axis = 0; axis < 2; axis++) {
        region.a[axis] = draw(random, -2.0, 30.0);
        region.b[axis] = region.a[axis] + 0.25 + fabs(draw(random, 0.0, 20.0));
    }
    region.inner = 0.25 + fabs(draw(random, 0.0, 8.0));
    region.outer = region.inner + 0.25 + fabs(draw(random, 0.0, 8.0));
    return region;
}

static size_t check_row(struct mpm_region_rows *rows, const struct mpm_site_row *row)
{
    const size_t count = mpm_region_rows_find(rows, row);
    size_t inside = 0, k = 0;
    ck_assert_uint_eq(count % 2, 0);
    for (int64_t column = row->first; column < row->end; column++) {
        const double point[2] = {mpm_site_place(row, column), row->y};
        while (k < count && rows->breaks[k] <= column)
            k++;
        const bool expected = mpm_region_contains(rows->region, point, rows->slack);
        ck_assert_msg((k % 2 == 1) == expected, "kind %d, (%.17g, %.17g): %s",
                      (int)rows->region->kind, point[0], point[1],
                      expected ? "inside, but left out" : "outside, but taken");
        inside += expected;
    }
    for (k = 0; k < count; k++)
        ck_assert(rows->breaks[k] >= row->first && rows->breaks[k] <= row->end);
    return inside;
}

static const enum mpm_region_kind kinds[] = {MPM_REGION_RECTANGLE, MPM_REGION_DISK,
                                             MPM_REGION_ANNULUS, MPM_REGION_POLYGON};

START_TEST(rows_of_sites_hold_what_a_look_at_each_site_finds)
{
    enum { REGIONS = 400 };
    static const double steps[] = {1.0, 0.5, 1.0 / 3.0, 1.7};
    GRand *const random = g_rand_new_with_seed(8000);
    size_t inside = 0;
    for (int k = 0; k < REGIONS; k++) {
        double points[POINTS_MAX][2];
        const struct mpm_region region = draw_region(random, kinds[_i], points);
        const double step = steps[k % (int)G_N_ELEMENTS(steps)];
        const double far = k % 5 == 0 ? 1e6 : 0.0; /* sites left of the range */
        struct mpm_region_rows rows;
        struct mpm_site_row row = {
            .origin = -step * far, .step = step, .first = (int64_t)far, .end = (int64_t)far};
        row.end += g_rand_int_range(random, 0, COLUMNS);
        ck_assert_int_eq(mpm_region_rows_open(&region, SLACK, &rows, NULL), MPM_OK);
        for (int pass = 0; pass < 2; pass++) /* a second time from the start */
            for (int y = 0; y < ROWS; y++) {
                row.y = step * (y + 0.5);
                inside += check_row(&rows, &row);
            }
        mpm_region_rows_close(&rows);
    }
    ck_assert_uint_gt(inside, 10 * REGIONS);
    g_rand_free(random);
}
END_TEST

/* ------------------------------------------------------------------- bodies */

static enum mpm_status count_site(void *context, size_t body, const double site[2])
{
    (void)body;
    (void)site;
    (*(size_t *)context)++;
    return MPM_OK;
}

static const char scene_text[] =
    "format: 1\ngeometry: %s\ngrid: {origin: [-2, 0], cell: [1, 1], cells: [24, 20]}\n"
    "time: {end: 1}\nmaterials:\n"
    "  - {name: rubber, law: neo_hookean, density: 1, bulk: 100, shear: 50}\nbodies:\n"
    "  - {name: ring, material: rubber, region: {annulus: {center: [6, 6], inner: 3, outer: 5}}}\n"
    "  - {name: hole, material: rubber, region: {disk: {center: [6, 6], radius: 3}},\n"
    "     particles_per_cell: [3, 1]}\n"
    "  - {name: bar, rigid: {velocity: [0, free]}, particles_per_cell: [1, 2],\n"
    "     region: {rectangle: {from: [-1, 12], to: [20, 13.5]}}}\n"
    "  - {name: kite, material: rubber,\n"
    "     region: {polygon: {points: [[15, 1], [20, 6], [15, 11], [13, 6]]}}}\n";

START_TEST(counted_particles_are_those_that_fill_the_bodies)
{
    static const char *const geometries[] = {"plane_strain", "axisymmetric"};
    char *text = g_strdup_printf(scene_text, geometries[_i]);
    struct mpm_scene *scene = test_scene_read_text(text);
    const struct mpm_grid grid = mpm_grid_describe(scene);
    struct mpm_fill_counts counts;
    size_t visited = 0;
    ck_assert_int_eq(mpm_bodies_count(scene, &grid, &counts, NULL), MPM_OK);
    for (size_t body = 0; body < scene->body_count; body++)
        ck_assert_int_eq(mpm_body_sites(scene, &grid, body, count_site, &visited, NULL), MPM_OK);
    ck_assert_uint_eq(counts.deformable + counts.rigid, visited);
    /* 21 columns of 3 rows; one column of them left of the axis */
    ck_assert_uint_eq(counts.rigid, _i == 0 ? 63 : 60);
    mpm_scene_free(scene);
    g_free(text);
}
END_TEST

Suite *suite_fill(void)
{
    Suite *suite = suite_create("fill");
    TCase *rows = tcase_create("rows");
    tcase_add_loop_test(rows, rows_of_sites_hold_what_a_look_at_each_site_finds, 0,
                        (int)G_N_ELEMENTS(kinds));
    suite_add_tcase(suite, rows);
    TCase *bodies = tcase_create("bodies");
    tcase_add_loop_test(bodies, counted_particles_are_those_that_fill_the_bodies, 0, 2);
    suite_add_tcase(suite, bodies);
    return suite;
}
