/* The fields of a scalar at a node of the grid, and their images beyond planes of symmetry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_SCALAR_NODES_H
#define MPM_METHOD_SCALAR_NODES_H

#include "method/state.h"

/* Fields that a node may have: its own, one in each layer, one of each key. */
int mpm_scalar_fields(const struct mpm_state *state);

/* Field k < mpm_scalar_fields of a node of the grid, which bears conditions there: it is active,
 * has capacity, and is no image beyond a plane of symmetry. -1: none. */
int64_t mpm_scalar_field_at(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                            int64_t node, int k);

/* Sets the number of a field, and of its images. */
void mpm_scalar_set(const struct mpm_state *state, double *numbers, int64_t field, double number);

#endif
