/* The general part of a scene: grid, time, method, output.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "method/shape/shape.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

/* -------------------------------------------------------------------- grid */

static const int64_t NODES_MAX = INT64_C(1) << 31;
enum { GHOST_ROWS = 2 }; /* at each side */

/* Positions must tell places 1e-6 of a cell apart, with 1e-16 for the round-off of one. */
static const double CELLS_FROM_ORIGIN_MAX = 1e9;

static enum mpm_status check_node_count(const struct mpm_reading *reading)
{
    const struct mpm_scene *scene = reading->scene;
    const int64_t margin = 1 + 2 * GHOST_ROWS;
    const int64_t columns = scene->cells[0] + margin, rows = scene->cells[1] + margin;
    if (columns <= NODES_MAX && rows <= NODES_MAX / columns)
        return MPM_OK;
    return mpm_reading_fault(reading, "grid.cells",
                             "too many nodes, got %" PRId64 " x %" PRId64
                             " with ghost rows and refine; allowed: up to 2^31 = %" PRId64,
                             columns, rows, NODES_MAX);
}

static enum mpm_status check_resolution(const struct mpm_reading *reading)
{
    const struct mpm_scene *scene = reading->scene;
    for (int i = 0; i < 2; i++) {
        const double far = fabs(scene->origin[i]) + (double)scene->cells[i] * scene->cell[i];
        if (far > CELLS_FROM_ORIGIN_MAX * scene->cell[i])
            return mpm_reading_fault(reading, "grid.origin",
                                     "the grid reaches %g cells away from 0, where numbers cannot "
                                     "resolve it; allowed: up to %g",
                                     far / scene->cell[i], CELLS_FROM_ORIGIN_MAX);
    }
    return MPM_OK;
}

/* Near the axis the condition v_r = 0 needs nodes on it. */
static enum mpm_status check_axis_nodes(const struct mpm_reading *reading)
{
    const struct mpm_scene *scene = reading->scene;
    if (scene->geometry != MPM_AXISYMMETRIC)
        return MPM_OK;
    const double first = scene->origin[0] / scene->cell[0]; /* in cells */
    if (first + (double)scene->cells[0] <= 0.0)
        return mpm_reading_fault(reading, "grid.origin",
                                 "no part of the grid has r > 0, it ends at r = %g",
                                 scene->origin[0] + (double)scene->cells[0] * scene->cell[0]);
    if (first < 2.0 && fabs(first - nearbyint(first)) > 1e-9)
        return mpm_reading_fault(reading, "grid.origin",
                                 "no node on r = 0, got origin r = %g with cells of %g; allowed: "
                                 "a whole number of cells from the axis, or two or more",
                                 scene->origin[0], scene->cell[0]);
    return MPM_OK;
}

static enum mpm_status build_grid(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_grid *raw = reading->raw->grid;
    for (int i = 0; i < 2; i++) {
        scene->origin[i] = mpm_raw_double(raw->origin[i]);
        scene->cell[i] = mpm_raw_double(raw->cell[i]) / (double)raw->refine;
        scene->cells[i] = raw->cells[i] * raw->refine; /* below 2^51 by their ranges */
    }
    scene->line_grid = mpm_reading_line(reading, "grid");
    MPM_TRY(check_node_count(reading));
    MPM_TRY(check_resolution(reading));
    return check_axis_nodes(reading);
}

/* -------------------------------------------------------------------- time */

static enum mpm_status check_time(const struct mpm_reading *reading)
{
    const struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_time *raw = reading->raw->time;
    if (raw->step != NULL && mpm_reading_given(reading, "time.courant"))
        return mpm_reading_fault(reading, "time.step",
                                 "both step and courant given, got step %s and courant %s; "
                                 "allowed: one of them",
                                 raw->step, raw->courant);
    if (raw->step == NULL && scene->courant > 1.0 && !scene->allow_unstable)
        return mpm_reading_fault(reading, "time.courant",
                                 "out of range, got %s; allowed: above 0, up to 1 (beyond only "
                                 "with allow_unstable: true)",
                                 raw->courant);
    if (raw->step != NULL && scene->end / scene->step > 1e15)
        return mpm_reading_fault(reading, "time.step",
                                 "too small, got %s: time could not reach end = %s; allowed: at "
                                 "least 1e-15 of end",
                                 raw->step, raw->end);
    return MPM_OK;
}

static enum mpm_status build_time(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_time *raw = reading->raw->time;
    scene->end = mpm_raw_double(raw->end);
    scene->courant = mpm_raw_double(raw->courant);
    scene->step = mpm_raw_double(raw->step);
    scene->steps = raw->steps;
    scene->allow_unstable = raw->allow_unstable;
    scene->line_time = mpm_reading_line(reading, "time");
    return check_time(reading);
}

/* ---------------------------------------------------------- method, output */

static enum mpm_status check_axis(const struct mpm_reading *reading)
{
    const struct mpm_scene *scene = reading->scene;
    const bool axis_nodes = mpm_reading_given(reading, "method.axis_nodes");
    if (scene->radius_update == MPM_RADIUS_HOOP && scene->axis != MPM_TRUNCATED)
        return mpm_reading_fault(reading, "method.radius_update",
                                 "hoop must not be combined with axis: %s; allowed: hoop with "
                                 "truncated, or shape",
                                 scene->axis == MPM_PLANAR ? "planar" : "untruncated");
    if (axis_nodes && scene->axis != MPM_PLANAR)
        return mpm_reading_fault(reading, "method.axis_nodes",
                                 "needs axis: planar; without, truncated functions have no nodes "
                                 "at r < 0 and untruncated ones hold them at v_r = 0");
    if (axis_nodes && mpm_shape_family(scene->shape)->point)
        return mpm_reading_fault(reading, "method.axis_nodes",
                                 "the functions of points, %s, reach no node at r < 0; allowed: "
                                 "with ugimp and cpdi",
                                 mpm_shape_family(scene->shape)->name);
    return MPM_OK;
}

static enum mpm_status build_method(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_method *raw = reading->raw->method;
    scene->shape = (enum mpm_shape)raw->shape;
    scene->axis = (enum mpm_axis)raw->axis;
    scene->axis_nodes = (enum mpm_axis_nodes)raw->axis_nodes;
    scene->position_update = (enum mpm_position_update)raw->position_update;
    scene->radius_update = (enum mpm_radius_update)raw->radius_update;
    scene->deformation_terms = (int)raw->deformation_terms;
    MPM_TRY(check_axis(reading));
    return mpm_build_transfer(reading);
}

static enum mpm_status build_output(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_output *raw = reading->raw->output;
    const double snapshots_max = 1e6; /* their files are numbered with six digits */
    if (raw == NULL)
        return MPM_OK;
    scene->history_interval = mpm_raw_double(raw->history);
    scene->snapshot_interval = mpm_raw_double(raw->snapshots);
    scene->checkpoint_interval = mpm_raw_double(raw->checkpoint);
    scene->checkpoint_seconds = mpm_raw_double(raw->checkpoint_seconds);
    scene->fringe = mpm_raw_double(raw->fringe);
    scene->energy_balance = raw->energy_balance;
    scene->derived = raw->derived;
    if (raw->snapshots != NULL && scene->end / scene->snapshot_interval >= snapshots_max)
        return mpm_reading_fault(reading, "output.snapshots",
                                 "too many snapshots, got an interval of %s up to end = %g; "
                                 "allowed: fewer than %.0f",
                                 raw->snapshots, scene->end, snapshots_max);
    return mpm_build_probes(reading);
}

enum mpm_status mpm_build_general(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_raw_scene *raw = reading->raw;
    MPM_TRY(mpm_reading_copy(reading, raw->title, &scene->title));
    scene->geometry = (enum mpm_geometry)raw->geometry;
    (void)snprintf(scene->units_length, MPM_NAME_SIZE, "%s", raw->units->length);
    (void)snprintf(scene->units_mass, MPM_NAME_SIZE, "%s", raw->units->mass);
    (void)snprintf(scene->units_time, MPM_NAME_SIZE, "%s", raw->units->time);
    (void)snprintf(scene->units_temperature, MPM_NAME_SIZE, "%s", raw->units->temperature);
    scene->thickness = mpm_raw_double(raw->thickness);
    MPM_TRY(mpm_reading_note(reading, build_grid(reading)));
    MPM_TRY(mpm_reading_note(reading, build_time(reading)));
    MPM_TRY(mpm_reading_note(reading, build_method(reading)));
    return build_output(reading);
}
