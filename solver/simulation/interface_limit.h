/* How stiff the interfaces of a scene are for its step.
 *
 * A straight interface on a line of nodes has h t of area at each of them, and both sides half a
 * cell of mass, rho h^2 t/2: with the D of interface_law.h
 *     kappa = 2 D dt^2/h (1/rho_1 + 1/rho_2),
 * h being the smaller side of a cell, and nothing of a rigid body. Above 1 the interface is
 * integrated implicitly. The jump has the round-off of places, eps x: far above 1 the energy that
 * it stores of that, kappa m (eps x/dt)^2, is no longer nothing beside m c^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SIMULATION_INTERFACE_LIMIT_H
#define MPM_SIMULATION_INTERFACE_LIMIT_H

#include "simulation/simulation.h"

/* The largest kappa of the scene's interfaces in the first step; *pair: whose it is. 0: none. */
double mpm_interface_kappa(const struct mpm_simulation *simulation, size_t *pair);

/* Refuses interfaces with kappa above MPM_KAPPA_MAX, at which what round-off stores is 1e-16 of
 * m c^2 for bodies of 100 cells. */
#define MPM_KAPPA_MAX 1e12
enum mpm_status mpm_interface_check(const struct mpm_simulation *simulation,
                                    struct mpm_error *error);

/* The ratio of D_t to D_n, or of D_n to D_t, of an interface whose normal follows the particles'
 * stairs; 0 of other pairs.
 *
 * With the jump u_n along the normal and u_t along the surface the interface holds the energy
 * A (D_n u_n^2 + D_t u_t^2)/2. A normal that turns by dtheta against the bodies changes it by
 * A (D_t - D_n) u_n u_t dtheta, which nobody works. Stairs turn with the bodies, but their normal
 * on the grid goes to and fro by up to 8 degrees (case C10) as they pass its nodes: where D_t is
 * far from D_n, interfaces make energy in bodies that turn, at any time step. */
double mpm_pair_unevenness(const struct mpm_pair_spec *pair);

/* The largest of the scene's interfaces; *pair: whose it is. 0: none. Scenes with more than this
 * are refused, unless ratio_limit allows it; then the run warns. */
#define MPM_UNEVEN_MAX 10.0
double mpm_interface_unevenness(const struct mpm_scene *scene, size_t *pair);

#endif
