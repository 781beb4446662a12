/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/fill.h"

#include "model/region.h"

#include <stdio.h>

/* Sites on the edge of a region are decided with this slack, in cells. */
static const double SITE_SLACK = 1e-9;

void mpm_body_half_size(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                        double half_size[2])
{
    for (int axis = 0; axis < 2; axis++)
        half_size[axis] = 0.5 * grid->cell[axis] / scene->bodies[body].particles_per_cell[axis];
}

/* First and last site index along an axis whose centres may lie in [low, high]. */
static void site_range(const struct mpm_grid *grid, int axis, int per_cell, double low, double high,
                       int64_t range[2])
{
    const double scale = grid->inverse_cell[axis] * per_cell;
    const double sites = (double)(grid->cells[axis] * per_cell);
    const double first = floor((low - grid->origin[axis]) * scale) - 1.0;
    const double last = ceil((high - grid->origin[axis]) * scale) + 1.0;
    range[0] = (int64_t)fmax(first, 0.0);
    range[1] = (int64_t)fmin(last, sites - 1.0);
}

enum mpm_status
mpm_body_sites(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
               enum mpm_status (*visit)(void *context, size_t body, const double site[2]),
               void *context)
{
    const struct mpm_body_spec *const spec = &scene->bodies[body];
    const double slack = SITE_SLACK * fmin(grid->cell[0], grid->cell[1]);
    double low[2], high[2];
    mpm_region_bounds(&spec->region, low, high);
    int64_t columns[2], rows[2];
    site_range(grid, 0, spec->particles_per_cell[0], low[0], high[0], columns);
    site_range(grid, 1, spec->particles_per_cell[1], low[1], high[1], rows);
    const double step[2] = {grid->cell[0] / spec->particles_per_cell[0],
                            grid->cell[1] / spec->particles_per_cell[1]};
    for (int64_t row = rows[0]; row <= rows[1]; row++)
        for (int64_t column = columns[0]; column <= columns[1]; column++) {
            const double site[2] = {grid->origin[0] + step[0] * ((double)column + 0.5),
                                    grid->origin[1] + step[1] * ((double)row + 0.5)};
            if (scene->geometry == MPM_AXISYMMETRIC && site[0] <= 0.0)
                continue;
            if (mpm_region_contains(&spec->region, site, slack))
                MPM_TRY(visit(context, body, site));
        }
    return MPM_OK;
}

bool mpm_body_contains_site(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                            const double site[2])
{
    const double slack = SITE_SLACK * fmin(grid->cell[0], grid->cell[1]);
    if (scene->geometry == MPM_AXISYMMETRIC && site[0] <= 0.0)
        return false;
    return mpm_region_contains(&scene->bodies[body].region, site, slack);
}

struct counter {
    const struct mpm_scene *scene;
    double slack;
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

static enum mpm_status count_site(void *context, size_t body, const double site[2])
{
    struct counter *const counter = context;
    const struct mpm_scene *const scene = counter->scene;
    for (size_t other = 0; other < scene->body_count; other++)
        if (other != body &&
            mpm_region_contains(&scene->bodies[other].region, site, counter->slack))
            return overlap(counter, body, other, site);
    counter->sites++;
    return MPM_OK;
}

enum mpm_status mpm_bodies_count(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                 struct mpm_fill_counts *counts, struct mpm_error *error)
{
    *counts = (struct mpm_fill_counts){0};
    for (size_t body = 0; body < scene->body_count; body++) {
        struct counter counter = {
            .scene = scene,
            .slack = SITE_SLACK * fmin(grid->cell[0], grid->cell[1]),
            .error = error,
        };
        MPM_TRY(mpm_body_sites(scene, grid, body, count_site, &counter));
        if (counter.sites == 0) {
            char key[2 * MPM_NAME_SIZE];
            (void)snprintf(key, sizeof key, "bodies.%s.region", scene->bodies[body].name);
            return mpm_scene_error(error, scene, scene->bodies[body].line, key,
                                   "empty body: no particle site has its centre inside; allowed: "
                                   "a region that holds at least one of the sites of "
                                   "particles_per_cell");
        }
        if (scene->bodies[body].rigid)
            counts->rigid += counter.sites;
        else
            counts->deformable += counter.sites;
    }
    if (counts->rigid + counts->deformable > UINT32_MAX)
        return mpm_scene_error(error, scene, scene->line_grid, "bodies",
                               "%zu particles; allowed: up to 4294967295",
                               counts->rigid + counts->deformable);
    return MPM_OK;
}

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

void mpm_bodies_fill(const struct mpm_scene *scene, const struct mpm_grid *grid,
                     struct mpm_particles *particles, struct mpm_rigid_particles *rigid)
{
    struct filler filler = {.scene = scene, .particles = particles, .rigid = rigid};
    for (size_t body = 0; body < scene->body_count; body++) {
        mpm_body_half_size(scene, grid, body, filler.half_size);
        (void)mpm_body_sites(scene, grid, body, fill_site, &filler);
    }
}
