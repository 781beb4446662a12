/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/cracks/crack_watch.h"

#include <math.h>
#include <stdlib.h>

static void find_points(const struct mpm_simulation *simulation, struct crack_watch *watch)
{
    const size_t all = mpm_simulation_crack_point_count(simulation);
    for (size_t k = 0; k < all; k++) {
        const bool own = mpm_simulation_crack_point(simulation, k).crack == watch->crack;
        if (own && watch->point_count == 0)
            watch->first = k;
        watch->point_count += own;
    }
}

static void read_points(const struct mpm_simulation *simulation, struct crack_watch *watch)
{
    for (size_t k = 0; k < watch->point_count; k++) {
        const struct mpm_crack_point point =
            mpm_simulation_crack_point(simulation, watch->first + k);
        watch->points[k][0] = point.position[0];
        watch->points[k][1] = point.position[1];
    }
}

enum mpm_status crack_watch_create(const struct mpm_simulation *simulation, size_t crack,
                                   double reach, double spacing, struct crack_watch *watch,
                                   struct mpm_error *error)
{
    const size_t count = mpm_simulation_particle_count(simulation);
    *watch = (struct crack_watch){.crack = crack, .widest = -HUGE_VAL};
    find_points(simulation, watch);
    if (watch->point_count < 2)
        return failure_set(error, MPM_BAD_INPUT, "the scene has no crack number %zu", crack);
    double *const position = malloc(2 * count * sizeof *position);
    watch->points = malloc(watch->point_count * sizeof *watch->points);
    bool good = position != NULL && watch->points != NULL;
    if (good) {
        read_points(simulation, watch);
        mpm_simulation_field(simulation, MPM_FIELD_POSITION, position);
        good = crack_faces_create(position, count, (const double(*)[2])watch->points,
                                  watch->point_count, reach, spacing, &watch->faces);
    }
    free(position);
    if (!good)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for a crack's faces");
    if (watch->faces.station_count == 0)
        return failure_set(error, MPM_BAD_INPUT, "crack %zu has no particles on both sides", crack);
    return MPM_OK;
}

void crack_watch_free(struct crack_watch *watch)
{
    free(watch->points);
    crack_faces_free(&watch->faces);
}

void crack_watch_look(struct crack_watch *watch, const struct mpm_simulation *simulation,
                      const double *position, const double *gradient)
{
    read_points(simulation, watch);
    watch->now = crack_faces_gap(&watch->faces, position, gradient,
                                 (const double(*)[2])watch->points, watch->point_count);
    watch->widest = fmax(watch->widest, watch->now.widest);
    watch->overlap = fmax(watch->overlap, -watch->now.narrowest);
    watch->depth = fmax(watch->depth, watch->now.depth);
    if (watch->now.crossed > watch->crossed)
        watch->crossed = watch->now.crossed;
}
