/* Which particles are near cracks? A map of the cells, made anew in each step along the cracks.
 *
 * The nodes of a particle span a block of cells. A listed cell has, for each crack, the segments
 * that meet the block of `span` by `span` cells from it on to the right and upwards. So a particle
 * tests one cell, the first of its block; where its domain is wider than the span, every
 * `span`-th cell of the block.
 *
 *     span = 2
 *     . . . . . . . .       /  cells that the crack is in; listed
 *     . . . L / / B .       L  listed too: a block of 2 by 2 cells from here meets the crack
 *     . L / / L * B .       *  the first cell of a particle's block of 2 by 2 cells, B: it is
 *     . L L L . . . .          listed, so the particle is near the crack
 *
 *     listed.low, listed.high: the first and the last listed column of each row. Particles whose
 *     blocks lie outside of them are passed over, 32 at a time, and not even looked at for as many
 *     steps as none of them can have come near.
 *
 * Cost: in proportion to the length of the cracks, and a test of a strip's particles, a few
 * together, where its nodes come near one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_MAP_H
#define MPM_METHOD_CRACK_MAP_H

#include "method/transfer/nearby.h"

/* What a listed cell has of one crack. */
struct mpm_crack_site {
    int64_t cell;
    uint32_t crack;
    uint32_t next; /* site of the same cell, see `first` */
    struct mpm_crack_part part;
};

struct mpm_crack_map {
    int64_t span;
    double slack;    /* see mpm_crack_part_of */
    uint32_t *first; /* per cell: one more than its first site, or 0 */
    struct mpm_crack_site *sites;
    size_t count, capacity;
    struct mpm_bands listed; /* of the cells that are */
};

/* Takes the arrays of a map with room for so many sites. */
void mpm_crack_map_layout(struct mpm_state *state, size_t capacity, struct mpm_arena *arena);
/* Settles what does not change from step to step, the bodies' domains being known. */
void mpm_crack_map_fill(struct mpm_state *state);

/* Lists the cells near the cracks as they are. False: there is no room. */
bool mpm_crack_map_draw(struct mpm_state *state);

/* The site of a crack that answers for a block, or NULL: nothing of the crack is there. Blocks
 * wider than the span have theirs put together in `made`. */
const struct mpm_crack_site *mpm_crack_map_site(const struct mpm_state *state,
                                                const struct mpm_cell_block *block, uint32_t crack,
                                                struct mpm_crack_site *made);

/* The same for a box: a part that has all segments that meet it, or NULL. */
const struct mpm_crack_part *mpm_crack_map_part(const struct mpm_state *state,
                                                const struct mpm_crack_box *box, uint32_t crack,
                                                struct mpm_crack_site *made);

#endif
