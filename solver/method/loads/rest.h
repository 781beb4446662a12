/* How far a step's forces are from balance, for scenes with `time.rest`.
 *
 * Forces are those that the momentum update uses and those of contact, damping left out; a
 * component that a condition holds has a reaction and counts as balanced. All sums are of |f_x| +
 * |f_y|. Nothing is done for other scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_REST_H
#define MPM_METHOD_REST_H

#include "method/state.h"

/* Sums the internal forces of all nodes: before body forces are added to them. Cost of either:
 * a pass over the active nodes. */
void mpm_rest_measure_internal(struct mpm_state *state);

/* Sums what is left of all forces at the components that are free: after contact has changed the
 * velocities of the momentum update. */
void mpm_rest_measure_unbalanced(struct mpm_state *state);

#endif
