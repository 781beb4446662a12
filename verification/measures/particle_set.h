/* The particles of one body, tracked through a run: which they are, where they
 * started, and the fields of the moment.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_PARTICLE_SET_H
#define VERIFICATION_MEASURES_PARTICLE_SET_H

#include "mpm.h"

struct particle_set {
    size_t count;
    size_t *index; /* places in the fields of the simulation */
    double *start; /* initial positions, 2 a particle */
    double *relative_volume;
    double *stress;   /* 4 a particle */
    double *position; /* 2 a particle */
    /* scratch for the fields of all particles */
    double *all;
    size_t all_count;
};

/* The particles of body `body` of the scene, at t = 0. MPM_ENVIRONMENT_FAILED: memory. */
enum mpm_status particle_set_create(const struct mpm_simulation *simulation, size_t body,
                                    struct particle_set *set, struct mpm_error *error);
void particle_set_free(struct particle_set *set);

/* Reads J, stress and position of the moment. Cost: a few passes over all particles. */
void particle_set_read(struct particle_set *set, const struct mpm_simulation *simulation);

/* Moves the particles with start[0] < limit to the front; returns how many they are. The
 * order is kept otherwise. */
size_t particle_set_inner_first(struct particle_set *set, double limit);

#endif
