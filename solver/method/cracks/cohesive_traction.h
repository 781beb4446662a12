/* Cohesive tractions between the surfaces of cracks, in CRAMP's Task 3: forces
 *     -+ t(delta) A w_i
 * on the fields above and below each point of a crack, with the weights that move its surfaces
 * (crack_opening.h). Both sum to t A: momentum is conserved. They work t A . d delta/dt, which is
 * what the law integrates.
 *
 * A is the undeformed area that belongs to the point, from both segments beside it: the integral of
 * the point's linear function, times the thickness, or over r ds in axisymmetry. Toughness is work
 * per undeformed area therefore.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_COHESIVE_TRACTION_H
#define MPM_METHOD_COHESIVE_TRACTION_H

#include "method/state.h"

/* Keeps the largest openings, and adds the tractions of the openings at the start of the step to
 * the forces of the nodes. After mpm_crack_openings_begin; nothing without cohesive cracks. */
void mpm_cohesive_spread(struct mpm_state *state);

/* What the tractions of the step took from the nodes, by the mean velocity of the step: after the
 * momentum update. */
double mpm_cohesive_nodal_work(const struct mpm_state *state);

/* What is given back when all openings go to zero, and the rest of the tractions' work since t = 0.
 */
void mpm_cohesive_energies(const struct mpm_state *state, double *stored, double *dissipated);

/* Effective opening of a point, and the traction of the surface below on that above. */
double mpm_cohesive_effective(const struct mpm_state *state, size_t crack, size_t first,
                              size_t point);
void mpm_cohesive_traction_at(const struct mpm_state *state, size_t crack, size_t first,
                              size_t point, double traction[2]);

#endif
