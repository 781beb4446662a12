/* The points of a crack's chain at t = 0: those of the scene, with others between them.
 *
 * Each segment of the scene is cut into equal parts no longer than the crack's spacing. A crack
 * whose opening is tracked and that begins (ends) outside of all deformable bodies has a mouth:
 * the first (last) place on the chain that is in one, edges included. The mouth is a point of the
 * chain as well: unless there is one within 1e-6 of a part, its segment is cut there first.
 * Cohesive cracks are not cut: they must have a point on the edge, which is then the mouth.
 *
 * A body that lies along the chain for less than 1/32 of the shorter cell side may be missed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SIMULATION_CRACK_POINTS_H
#define MPM_SIMULATION_CRACK_POINTS_H

#include "model/scene.h"

/* How many there are; their coordinates, unless x is NULL. */
size_t mpm_crack_points_place(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                              double *x, double *y);

/* The mouths' points, where that of the chain's first point is `first`, seen from its first point
 * and from its last; SIZE_MAX: none. */
void mpm_crack_points_mouths(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                             size_t first, size_t mouths[2]);

/* Is one of the places around it in a deformable body? Edges count, whichever side they are on. */
bool mpm_crack_point_is_in_a_body(const struct mpm_scene *scene, const double place[2]);

#endif
