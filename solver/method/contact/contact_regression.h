/* Planes between the particles of two fields at a node: phi = c_0 + c_1 x + c_2 y, below 0 in the
 * first field and above it in the second one, with x and y in cells from the node; contact_normal.h
 * has the equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_REGRESSION_H
#define MPM_METHOD_CONTACT_REGRESSION_H

#include "method/contact/shared_nodes.h"

/* By linear regression; false: all particles are on one line. */
bool mpm_contact_linear_plane(const struct mpm_contact_sums *first,
                              const struct mpm_contact_sums *second, double c[3]);

/* Sets the gradient of phi; returns a length to compare it with. */
double mpm_contact_plane_normal(const struct mpm_grid *grid, const double c[3], double normal[2]);

/* By logistic regression (logistic_plane.h), of all pairs that have it, from the plane of linear
 * regression on. Fails where one has not converged after 200 steps. Cost: about 20 visits of the
 * particles near contact. */
enum mpm_status mpm_contact_logistic_find(struct mpm_state *state, int workers,
                                          struct mpm_error *error);

#endif
