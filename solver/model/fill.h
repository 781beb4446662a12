/* Filling bodies: the lattice sites of each cell whose centre lies in a body's region
 * become its particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_FILL_H
#define MPM_MODEL_FILL_H

#include "model/particles.h"

/* Calls visit for every site of a body, row by row, x fastest. In axisymmetry sites
 * with r <= 0 are left out. Stops at the first status that is not MPM_OK.
 * MPM_ENVIRONMENT_FAILED: no memory for the body's outline. */
enum mpm_status
mpm_body_sites(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
               enum mpm_status (*visit)(void *context, size_t body, const double site[2]),
               void *context, struct mpm_error *error);

/* Would a site at this place be one of the body's? In axisymmetry there is none at r <= 0. */
bool mpm_body_contains_site(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                            const double site[2]);

struct mpm_fill_counts {
    size_t deformable, rigid; /* particles */
};

/* Counts the particles. MPM_BAD_INPUT: an empty body, a site claimed by two bodies,
 * more than 2^32 - 1 particles. MPM_ENVIRONMENT_FAILED: no memory for the bodies' outlines.
 * Cost: that of the rows of each body, whatever their length; see mpm_region_rows_find. */
enum mpm_status mpm_bodies_count(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                 struct mpm_fill_counts *counts, struct mpm_error *error);

/* Fills positions, mass, id, body; F = I; everything else stays 0. The arrays must
 * have the sizes that mpm_bodies_count gave. MPM_ENVIRONMENT_FAILED: as above. */
enum mpm_status mpm_bodies_fill(const struct mpm_scene *scene, const struct mpm_grid *grid,
                                struct mpm_particles *particles, struct mpm_rigid_particles *rigid,
                                struct mpm_error *error);

/* Half edges of a body's undeformed particle domain, l_p cell / 2. */
void mpm_body_half_size(const struct mpm_scene *scene, const struct mpm_grid *grid, size_t body,
                        double half_size[2]);

#endif
