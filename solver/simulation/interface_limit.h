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

/* The largest ratio of D_t to D_n, or of D_n to D_t, of the scene's interfaces whose normals follow
 * the particles' stairs: an error of the normal takes a part of an opening for sliding, which makes
 * energy in bodies that turn. *pair: whose it is. 0: none. */
#define MPM_UNEVEN_MAX 10.0
double mpm_interface_unevenness(const struct mpm_scene *scene, size_t *pair);

#endif
