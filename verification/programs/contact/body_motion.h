/* One body of a scene as a rigid body would be seen: mass, centre, velocity, moment of inertia and
 * spin, from its particles; and quantities of contact in the history, by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_CONTACT_BODY_MOTION_H
#define VERIFICATION_PROGRAMS_CONTACT_BODY_MOTION_H

#include "verification/programs/programs.h"

struct body_motion {
    /* of the moment */
    double mass, place[2], velocity[2];
    double inertia; /* sum m |x - place|^2 */
    double angular; /* sum m (x - place) cross (v - velocity); in axisymmetry both mean nothing */
    double extent[2][2]; /* smallest and largest coordinate of its particles, along each axis */
    /* its particles */
    size_t count, all_count;
    size_t *index;
    double *particle_mass;
    double *all; /* scratch: 2 a particle of the model */
    double *position, *speed;
};

/* Of body `body`, at t = 0. MPM_ENVIRONMENT_FAILED: memory. MPM_BAD_INPUT: it has no particles. */
enum mpm_status body_motion_open(const struct mpm_simulation *simulation, size_t body,
                                 struct body_motion *motion, struct mpm_error *error);
void body_motion_close(struct body_motion *motion);
void body_motion_read(struct body_motion *motion, const struct mpm_simulation *simulation);

/* The place of the history's quantity "contact_<fields>_<what>" among those of contact; fields are
 * "0_1". MPM_BAD_INPUT: there is none of that name. */
enum mpm_status contact_quantity_find(const struct mpm_scene *scene, const char *fields,
                                      const char *what, size_t *index, struct mpm_error *error);

#endif
