/* Which nodes of the grid and of its layers are active in a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_ACTIVE_NODES_H
#define MPM_METHOD_ACTIVE_NODES_H

#include "method/state.h"

/* From the strips' boxes: which columns of which rows of nodes are active. In scenes with layers
 * those of a layer, the grid itself among them, are where its own particles reach; and, beyond a
 * plane of symmetry, images of such nodes that particles of any layer reach, since all fields of a
 * node get what mirrored particles would give together. All other nodes of layers have mass zero.
 * Cost: a look at all rows. */
void mpm_grid_find_active(struct mpm_state *state);

#endif
