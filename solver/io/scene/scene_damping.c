/* Damping, and when a run is at rest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "method/transfer/transfers.h"

static enum mpm_status build_rate(const struct mpm_reading *reading, const char *path,
                                  const char *raw, char **text)
{
    const struct mpm_region everywhere = {.kind = MPM_REGION_ALL};
    double place[2], rate;
    if (raw == NULL)
        return MPM_OK;
    mpm_region_sample(reading->scene, &everywhere, place);
    MPM_TRY(mpm_build_expression(reading, path, raw, true, place, text, &rate));
    if (!(rate >= 0.0))
        return mpm_reading_fault(reading, path, "a negative rate, got %g; allowed: at least 0",
                                 rate);
    mpm_drop_constant(text, 0.0);
    return MPM_OK;
}

static enum mpm_status build_pic(const struct mpm_reading *reading)
{
    const char *const path = "damping.pic";
    const char *const raw = reading->raw->damping->pic;
    static const double nowhere[2] = {0.0, 0.0};
    struct mpm_scene *const scene = reading->scene;
    double beta;
    if (raw == NULL)
        return MPM_OK;
    MPM_TRY(mpm_build_expression(reading, path, raw, true, nowhere, &scene->damping.pic, &beta));
    if (!(beta >= 0.0 && beta <= 1.0))
        return mpm_reading_fault(reading, path, "out of range, got %g; allowed: from 0 to 1", beta);
    if (scene->transfer != MPM_TRANSFER_FLIP)
        return mpm_reading_fault(reading, path,
                                 "PIC damping with a method.transfer other than flip, which takes "
                                 "no part of a particle's velocity over; allowed: kind: flip");
    if (scene->flip_fraction < 1.0)
        return mpm_reading_fault(reading, path,
                                 "both damping.pic and a method.transfer that keeps %g of FLIP, "
                                 "which do the same to velocities; allowed: one of them",
                                 scene->flip_fraction);
    mpm_drop_constant(&scene->damping.pic, 1.0);
    return MPM_OK;
}

/* Where alpha_g acts, once it is read. */
static enum mpm_status build_grid_form(const struct mpm_reading *reading)
{
    const char *const path = "damping.grid_form";
    const struct mpm_raw_damping *const raw = reading->raw->damping;
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_transfer *const transfer = mpm_transfer_of(scene->transfer);
    scene->damping.grid_form = (enum mpm_grid_damping)raw->grid_form;
    if (scene->damping.grid_form == MPM_GRID_DAMPING_NODES)
        return MPM_OK;
    if (raw->grid == NULL && raw->thermostat == NULL)
        return mpm_reading_fault(reading, path,
                                 "without damping.grid and damping.thermostat, which it is of");
    if (transfer->no_grid_drag != NULL)
        return mpm_reading_fault(reading, path,
                                 "damping at the particles with transfer %s, which %s; allowed: "
                                 "with flip, pic and xpic, or grid_form: nodes",
                                 transfer->name, transfer->no_grid_drag);
    if (scene->radius_update == MPM_RADIUS_HOOP)
        return mpm_reading_fault(reading, path,
                                 "damping at the particles with radius_update: hoop, which moves r "
                                 "with the nodes alone; allowed: radius_update: shape, or "
                                 "grid_form: nodes");
    return MPM_OK;
}

static void build_thermostat(const struct mpm_raw_thermostat *raw, struct mpm_damping_spec *damping)
{
    if (raw == NULL)
        return;
    damping->thermostat = true;
    damping->gain = mpm_raw_double(raw->gain);
    damping->target = mpm_raw_double(raw->target);
    damping->scale = mpm_raw_double(raw->scale);
}

static enum mpm_status build_rest(const struct mpm_reading *reading)
{
    const struct mpm_raw_rest *const raw = reading->raw->time->rest;
    struct mpm_scene *const scene = reading->scene;
    if (raw == NULL)
        return MPM_OK;
    scene->rest = (struct mpm_rest_spec){
        .asked = true,
        .residual = mpm_raw_double(raw->residual),
        .kinetic_energy = raw->kinetic_energy == NULL ? 1.0 /* nothing moves */
                                                      : mpm_raw_double(raw->kinetic_energy),
        .after = mpm_raw_double(raw->after),
        .steps = raw->steps,
        .patience = raw->patience,
    };
    if (scene->rest.after >= scene->end)
        return mpm_reading_fault(reading, "time.rest.after",
                                 "rest is tested from %g on, and the run ends at %g; allowed: "
                                 "below time.end",
                                 scene->rest.after, scene->end);
    return MPM_OK;
}

enum mpm_status mpm_build_damping(const struct mpm_reading *reading)
{
    const struct mpm_raw_damping *const raw = reading->raw->damping;
    struct mpm_damping_spec *const damping = &reading->scene->damping;
    reading->scene->line_damping = mpm_reading_line(reading, "damping");
    MPM_TRY(build_rate(reading, "damping.grid", raw->grid, &damping->grid));
    MPM_TRY(build_rate(reading, "damping.particle", raw->particle, &damping->particle));
    MPM_TRY(build_pic(reading));
    build_thermostat(raw->thermostat, damping);
    MPM_TRY(build_grid_form(reading));
    return build_rest(reading);
}
