/* Which particles are near cracks? A map of the cells, made anew in each step along the cracks.
 *
 * The nodes of a particle span a block of cells. A cell that is listed names, for each crack, the
 * segments that meet the block of `span` by `span` cells from it on to the right and upwards:
 * particles ask at their block's first cell, and go on in steps of `span` where domains are wider.
 * Cost: in proportion to the length of the cracks, and a look at a strip's particles, a few
 * together, where its nodes come near one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CRACK_MAP_H
#define MPM_METHOD_CRACK_MAP_H

#include "method/state.h"

/* Columns low[0]..high[0] and rows low[1]..high[1] of cells; ghosts counted, as in mpm_grid_index.
 */
struct mpm_cell_block {
    int64_t low[2], high[2];
};

/* For each row of cells or nodes the columns between which some are marked; none: low > high. */
struct mpm_crack_bands {
    int64_t *low, *high;
};

/* What a listed cell says of one crack. */
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
    struct mpm_crack_bands listed; /* of the cells that are */
    struct mpm_crack_bands wanted; /* of the nodes that further fields are asked for at */
    struct mpm_crack_bands beside; /* of those with corners that have further velocity fields */
};

/* Takes the arrays of a map with room for so many sites. */
void mpm_crack_map_layout(struct mpm_state *state, size_t capacity, struct mpm_arena *arena);
/* Settles what does not change from step to step, the bodies' domains being known. */
void mpm_crack_map_fill(struct mpm_state *state);

/* Lists the cells near the cracks as they are, all bands being empty before. False: there is no
 * room. */
bool mpm_crack_map_draw(struct mpm_state *state);

/* Marks one cell or node. */
void mpm_crack_bands_mark(struct mpm_crack_bands *bands, int64_t column, int64_t row);

/* Work for one particle; `block`: the cells that its nodes span, from the first one on, which is
 * left of and below all of them, by what may be round-off. */
typedef void mpm_crack_visit(void *context, size_t p, const struct mpm_cell_block *block);

/* Visits all particles of the strip whose blocks may have marked cells, in their order. */
void mpm_crack_bands_visit(const struct mpm_state *state, const struct mpm_strip *strip,
                           const struct mpm_crack_bands *bands, mpm_crack_visit *visit,
                           void *context);

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
