/* Where the particles of a strip are after a step: may they be there, and which nodes will
 * they reach?
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EXTENT_H
#define MPM_METHOD_EXTENT_H

#include "method/state.h"

#include <float.h>

/* The hull of the domains of a strip's particles. */
struct mpm_extent {
    double low[2], high[2];
};
#define MPM_NO_EXTENT ((struct mpm_extent){{DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX}})

/* One particle's domain and the way it went in the step. */
struct mpm_placement {
    double position[2], step[2];
    double reach[2]; /* of the domain from its centre */
};

/* How far beyond the grid a domain may reach: the ghost rows, less a little, so that round-off
 * takes no corner onto the line where they end. */
static inline double mpm_ghost_reach(const struct mpm_grid *grid, int axis)
{
    return MPM_GHOST_ROWS * grid->cell[axis] * (1.0 - 1e-9);
}

/* Notes a failure, unless one of a particle with a smaller id is known. */
void mpm_strip_record(struct mpm_strip *strip, enum mpm_failure_kind kind, uint32_t particle,
                      int axis, double value);

/* A particle that left the grid has no cell; one that outran a cell has no meaning; a domain
 * beyond the ghost rows has no nodes. Each is recorded. */
bool mpm_placement_check(const struct mpm_state *state, const struct mpm_placement *placement,
                         uint32_t particle, struct mpm_strip *strip);
/* The same without the way. */
bool mpm_domain_check(const struct mpm_state *state, const struct mpm_placement *placement,
                      uint32_t particle, struct mpm_strip *strip);
/* One extent for each layer of nodes, the grid's own first: fields.h. */
struct mpm_extents {
    struct mpm_extent of[MPM_LAYERS];
};
void mpm_extents_begin(const struct mpm_state *state, struct mpm_extents *extents);
void mpm_extents_add(struct mpm_extents *extents, int64_t layer,
                     const struct mpm_placement *placement);

/* Sets the box of the nodes that a strip's particles reach, and in scenes with layers that of each
 * layer. */
void mpm_strip_set_boxes(const struct mpm_state *state, struct mpm_strip *strip,
                         const struct mpm_extents *extents);

#endif
