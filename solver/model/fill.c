/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/fill.h"

#include "model/region_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Sites on the edge of a region are decided with this slack, in cells. */
static const double SITE_SLACK = 1e-9;

void mpm_body_half_size(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                        double half_size[2])
{
    for (int axis = 0; axis < 2; axis++)
        half_size[axis] = 0.5 * grid->cell[axis] / scene->bodies[body].particles_per_cell[axis];
}

static double site_slack(const struct mpm_grid *grid)
{
    return SITE_SLACK * fmin(grid->cell[0], grid->cell[1]);
}

/* Site indices first <= i < end along an axis whose centres may lie in [low, high]. */
static void site_range(const struct mpm_grid *grid, int axis, int per_cell, double low, double high,
                       int64_t range[2])
{
    const double scale = grid->inverse_cell[axis] * per_cell;
    const double sites = (double)(grid->cells[axis] * per_cell);
    const double first = floor((low - grid->origin[axis]) * scale) - 1.0;
    const double last = ceil((high - grid->origin[axis]) * scale) + 1.0;
    range[0] = (int64_t)fmax(first, 0.0);
    range[1] = (int64_t)fmin(last, sites - 1.0) + 1;
}

/* In axisymmetry there are sites at r > 0 only. */
static void leave_out_beyond_axis(struct mpm_site_row *row)
{
    int64_t end = row->end;
    while (row->first < end) {
        const int64_t column = row->first + (end - row->first) / 2;
        if (mpm_site_place(row, column) <= 0.0)
            row->first = column + 1;
        else
            end = column;
    }
}

/* A row of a body's lattice, and the body's stretches of it: see mpm_region_rows_find. */
typedef enum mpm_status (*row_visit)(void *context, size_t body, const struct mpm_site_row *row,
                                     const int64_t *breaks, size_t count);

static enum mpm_status visit_rows(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                  size_t body, struct mpm_region_rows *region, row_visit visit,
                                  void *context)
{
    const struct mpm_body_spec *const spec = &scene->bodies[body];
    int64_t columns[2], rows[2];
    site_range(grid, 0, spec->particles_per_cell[0], region->low[0], region->high[0], columns);
    site_range(grid, 1, spec->particles_per_cell[1], region->low[1], region->high[1], rows);
    struct mpm_site_row row = {.origin = grid->origin[0],
                               .step = grid->cell[0] / spec->particles_per_cell[0],
                               .first = columns[0],
                               .end = columns[1]};
    const double step = grid->cell[1] / spec->particles_per_cell[1];
    if (scene->geometry == MPM_AXISYMMETRIC)
        leave_out_beyond_axis(&row);
    for (int64_t k = rows[0]; k < rows[1]; k++) {
        row.y = grid->origin[1] + step * ((double)k + 0.5);
        MPM_TRY(visit(context, body, &row, region->breaks, mpm_region_rows_find(region, &row)));
    }
    return MPM_OK;
}

struct site_visit {
    enum mpm_status (*visit)(void *context, size_t body, const double site[2]);
    void *context;
};

static enum mpm_status visit_sites(void *context, size_t body, const struct mpm_site_row *row,
                                   const int64_t *breaks, size_t count)
{
    const struct site_visit *const site_visit = context;
    for (size_t k = 0; k < count; k += 2)
        for (int64_t column = breaks[k]; column < breaks[k + 1]; column++) {
            const double site[2] = {mpm_site_place(row, column), row->y};
            MPM_TRY(site_visit->visit(site_visit->context, body, site));
        }
    return MPM_OK;
}

enum mpm_status
mpm_body_sites(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
               enum mpm_status (*visit)(void *context, size_t body, const double site[2]),
               void *context, struct mpm_error *error)
{
    struct site_visit site_visit = {visit, context};
    struct mpm_region_rows rows;
    MPM_TRY(mpm_region_rows_open(&scene->bodies[body].region, site_slack(grid), &rows, error));
    const enum mpm_status status = visit_rows(scene, grid, body, &rows, visit_sites, &site_visit);
    mpm_region_rows_close(&rows);
    return status;
}

bool mpm_body_contains_site(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                            const double site[2])
{
    if (scene->geometry == MPM_AXISYMMETRIC && site[0] <= 0.0)
        return false;
    return mpm_region_contains(&scene->bodies[body].region, site, site_slack(grid));
}

/* ----------------------------------------------------------------- counting */

struct counter {
    const struct mpm_scene *scene;
    const struct mpm_grid *grid;
    struct mpm_region_rows *regions; /* of all bodies */
    size_t *near;                    /* bodies that may claim sites of the body at hand */
    size_t near_count;
    size_t sites;
    struct mpm_error *error;
};

/* Reported at the later of the two bodies, whichever has the finer lattice. */
static enum mpm_status overlap(const struct counter *counter, size_t body, size_t other,
                               const double site[2])
{
    const struct mpm_scene *const scene = counter->scene;
    const size_t later = body > other ? body : other, earlier = body > other ? other : body;
    char key[2 * MPM_NAME_SIZE];
    (void)snprintf(key, sizeof key, "bodies.%s.region", scene->bodies[later].name);
    return mpm_scene_error(counter->error, scene, scene->bodies[later].line, key,
                           "the site at (%g, %g) is also claimed by body '%s'; bodies may touch "
                           "but not overlap",
                           site[0], site[1], scene->bodies[earlier].name);
}

/* The first column that is in stretches of both, or `none`. */
static int64_t first_common(const int64_t *a, size_t a_count, const int64_t *b, size_t b_count,
                            int64_t none)
{
    for (size_t i = 0, j = 0; i < a_count && j < b_count;) {
        const int64_t low = a[i] > b[j] ? a[i] : b[j];
        if (low < a[i + 1] && low < b[j + 1])
            return low;
        if (a[i + 1] < b[j + 1])
            i += 2;
        else
            j += 2;
    }
    return none;
}

static enum mpm_status count_row(void *context, size_t body, const struct mpm_site_row *row,
                                 const int64_t *breaks, size_t count)
{
    struct counter *const counter = context;
    size_t claims = 0;
    int64_t first = row->end;
    for (size_t k = 0; k < counter->near_count; k++) {
        struct mpm_region_rows *const region = &counter->regions[counter->near[k]];
        const size_t others = mpm_region_rows_find(region, row);
        const int64_t column = first_common(breaks, count, region->breaks, others, row->end);
        if (column < first) {
            first = column;
            claims = counter->near[k];
        }
    }
    if (first < row->end) {
        const double site[2] = {mpm_site_place(row, first), row->y};
        return overlap(counter, body, claims, site);
    }
    for (size_t k = 0; k < count; k += 2)
        counter->sites += (size_t)(breaks[k + 1] - breaks[k]);
    return MPM_OK;
}

/* Bodies whose boxes meet, with room for the slack of both. */
static void list_near(struct counter *counter, size_t body)
{
    const double room = 4.0 * site_slack(counter->grid);
    const struct mpm_region_rows *const own = &counter->regions[body];
    counter->near_count = 0;
    for (size_t other = 0; other < counter->scene->body_count; other++) {
        const struct mpm_region_rows *const its = &counter->regions[other];
        if (other != body && its->low[0] <= own->high[0] + room &&
            own->low[0] <= its->high[0] + room && its->low[1] <= own->high[1] + room &&
            own->low[1] <= its->high[1] + room)
            counter->near[counter->near_count++] = other;
    }
}

static enum mpm_status count_body(struct counter *counter, size_t body,
                                  struct mpm_fill_counts *counts)
{
    const struct mpm_scene *const scene = counter->scene;
    counter->sites = 0;
    list_near(counter, body);
    MPM_TRY(visit_rows(scene, counter->grid, body, &counter->regions[body], count_row, counter));
    if (counter->sites == 0) {
        char key[2 * MPM_NAME_SIZE];
        (void)snprintf(key, sizeof key, "bodies.%s.region", scene->bodies[body].name);
        return mpm_scene_error(counter->error, scene, scene->bodies[body].line, key,
                               "empty body: no particle site has its centre inside; allowed: "
                               "a region that holds at least one of the sites of "
                               "particles_per_cell");
    }
    if (scene->bodies[body].rigid)
        counts->rigid += counter->sites;
    else
        counts->deformable += counter->sites;
    return MPM_OK;
}

static enum mpm_status count_bodies(struct counter *counter, struct mpm_fill_counts *counts)
{
    const struct mpm_scene *const scene = counter->scene;
    if (counter->regions == NULL || counter->near == NULL)
        return mpm_error_memory(counter->error, scene->body_count * sizeof *counter->regions,
                                "the outlines of the bodies");
    for (size_t body = 0; body < scene->body_count; body++)
        MPM_TRY(mpm_region_rows_open(&scene->bodies[body].region, site_slack(counter->grid),
                                     &counter->regions[body], counter->error));
    for (size_t body = 0; body < scene->body_count; body++)
        MPM_TRY(count_body(counter, body, counts));
    if (counts->rigid + counts->deformable > UINT32_MAX)
        return mpm_scene_error(counter->error, scene, scene->line_grid, "bodies",
                               "%zu particles; allowed: up to 4294967295",
                               counts->rigid + counts->deformable);
    return MPM_OK;
}

enum mpm_status mpm_bodies_count(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                 struct mpm_fill_counts *counts, struct mpm_error *error)
{
    struct counter counter = {
        .scene = scene,
        .grid = grid,
        .regions = calloc(scene->body_count, sizeof *counter.regions),
        .near = calloc(scene->body_count, sizeof *counter.near),
        .error = error,
    };
    *counts = (struct mpm_fill_counts){0};
    const enum mpm_status status = count_bodies(&counter, counts);
    for (size_t body = 0; counter.regions != NULL && body < scene->body_count; body++)
        mpm_region_rows_close(&counter.regions[body]);
    free(counter.regions);
    free(counter.near);
    return status;
}

/* ------------------------------------------------------------------ filling */

struct filler {
    const struct mpm_scene *scene;
    struct mpm_particles *particles;
    struct mpm_rigid_particles *rigid;
    double half_size[2];
    size_t deformable_count, rigid_count;
    uint32_t id;
};

static enum mpm_status fill_rigid(struct filler *filler, size_t body, const double site[2])
{
    struct mpm_rigid_particles *const rigid = filler->rigid;
    const size_t p = filler->rigid_count++;
    rigid->position[0][p] = site[0];
    rigid->position[1][p] = site[1];
    rigid->id[p] = filler->id++;
    rigid->body[p] = (uint32_t)body;
    return MPM_OK;
}

static enum mpm_status fill_site(void *context, size_t body, const double site[2])
{
    struct filler *const filler = context;
    const struct mpm_body_spec *const spec = &filler->scene->bodies[body];
    if (spec->rigid)
        return fill_rigid(filler, body, site);
    struct mpm_particles *const particles = filler->particles;
    const size_t p = filler->deformable_count++;
    particles->position[0][p] = site[0];
    particles->position[1][p] = site[1];
    particles->deformation[MPM_XX][p] = 1.0;
    particles->deformation[MPM_YY][p] = 1.0;
    particles->deformation[MPM_ZZ][p] = 1.0;
    /* mass per radian, rho A <r>, in axisymmetry (N&G check list, 1): sites keep clear
     * of the axis, so that <r> is r */
    const double depth =
        filler->scene->geometry == MPM_AXISYMMETRIC ? site[0] : filler->scene->thickness;
    particles->mass[p] = filler->scene->materials[spec->material].density *
                         (4.0 * filler->half_size[0] * filler->half_size[1]) * depth;
    particles->id[p] = filler->id++;
    particles->body[p] = (uint32_t)body;
    return MPM_OK;
}

enum mpm_status mpm_bodies_fill(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                struct mpm_particles *particles, struct mpm_rigid_particles *rigid,
                                struct mpm_error *error)
{
    struct filler filler = {.scene = scene, .particles = particles, .rigid = rigid};
    for (size_t body = 0; body < scene->body_count; body++) {
        mpm_body_half_size(scene, grid, body, filler.half_size);
        MPM_TRY(mpm_body_sites(scene, grid, body, fill_site, &filler, error));
    }
    return MPM_OK;
}
