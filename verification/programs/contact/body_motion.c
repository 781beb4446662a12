/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/contact/body_motion.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2 };

static void pick(const struct body_motion *motion, const double *all, double *own)
{
    for (size_t k = 0; k < motion->count; k++)
        memcpy(&own[AXES * k], &all[AXES * motion->index[k]], AXES * sizeof *own);
}

/* Centre and mean velocity, weighted with mass. */
static void find_means(struct body_motion *motion)
{
    memset(motion->place, 0, sizeof motion->place);
    memset(motion->velocity, 0, sizeof motion->velocity);
    for (size_t k = 0; k < AXES * motion->count; k++) {
        const double part = motion->particle_mass[k / AXES] / motion->mass;
        motion->place[k % AXES] += part * motion->position[k];
        motion->velocity[k % AXES] += part * motion->speed[k];
    }
}

static void find_turning(struct body_motion *motion)
{
    motion->inertia = motion->angular = 0.0;
    for (int axis = 0; axis < AXES; axis++) {
        motion->extent[0][axis] = HUGE_VAL;
        motion->extent[1][axis] = -HUGE_VAL;
    }
    for (size_t k = 0; k < motion->count; k++) {
        const double *const x = &motion->position[AXES * k], *const v = &motion->speed[AXES * k];
        const double arm[AXES] = {x[0] - motion->place[0], x[1] - motion->place[1]};
        const double mass = motion->particle_mass[k];
        motion->inertia += mass * (arm[0] * arm[0] + arm[1] * arm[1]);
        motion->angular +=
            mass * (arm[0] * (v[1] - motion->velocity[1]) - arm[1] * (v[0] - motion->velocity[0]));
        for (int axis = 0; axis < AXES; axis++) {
            motion->extent[0][axis] = fmin(motion->extent[0][axis], x[axis]);
            motion->extent[1][axis] = fmax(motion->extent[1][axis], x[axis]);
        }
    }
}

void body_motion_read(struct body_motion *motion, const struct mpm_simulation *simulation)
{
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, motion->all);
    pick(motion, motion->all, motion->position);
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, motion->all);
    pick(motion, motion->all, motion->speed);
    find_means(motion);
    find_turning(motion);
}

/* Which particles are its own, and their masses. */
static void find_own(struct body_motion *motion, const struct mpm_simulation *simulation,
                     size_t body)
{
    mpm_simulation_field(simulation, MPM_FIELD_BODY, motion->all);
    for (size_t p = 0; p < motion->all_count; p++)
        if ((size_t)motion->all[p] == body)
            motion->index[motion->count++] = p;
    mpm_simulation_field(simulation, MPM_FIELD_MASS, motion->all);
    for (size_t k = 0; k < motion->count; k++)
        motion->mass += motion->particle_mass[k] = motion->all[motion->index[k]];
}

enum mpm_status body_motion_open(const struct mpm_simulation *simulation, size_t body,
                                 struct body_motion *motion, struct mpm_error *error)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    *motion = (struct body_motion){
        .all_count = n,
        .index = g_new(size_t, n),
        .particle_mass = g_new(double, n),
        .all = g_new(double, AXES *n),
        .position = g_new(double, AXES *n),
        .speed = g_new(double, AXES *n),
    };
    find_own(motion, simulation, body);
    if (motion->count == 0)
        return failure_set(error, MPM_BAD_INPUT, "body %zu has no particles", body);
    body_motion_read(motion, simulation);
    return MPM_OK;
}

void body_motion_close(struct body_motion *motion)
{
    g_free(motion->index);
    g_free(motion->particle_mass);
    g_free(motion->all);
    g_free(motion->position);
    g_free(motion->speed);
    *motion = (struct body_motion){0};
}

enum mpm_status contact_quantity_find(const struct mpm_scene *scene, const char *fields,
                                      const char *what, size_t *index, struct mpm_error *error)
{
    char *const name = g_strdup_printf("contact_%s_%s", fields, what);
    const size_t count = mpm_scene_contact_quantity_count(scene);
    for (*index = 0; *index < count; ++*index) {
        const struct mpm_quantity_info info = mpm_scene_contact_quantity(scene, *index);
        if (strcmp(info.name, name) == 0)
            break;
    }
    const enum mpm_status status =
        *index < count
            ? MPM_OK
            : failure_set(error, MPM_BAD_INPUT, "the history of the scene has no %s", name);
    g_free(name);
    return status;
}
