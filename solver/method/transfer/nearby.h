/* Which particles may have nodes in marked cells? What looks at the particles near a few nodes, and
 * no others, visits them by bands of cells (struct mpm_bands), strip by strip, some particles
 * together.
 *
 * Cost: a test of a strip's particles, 32 at a time, where its nodes come near a marked cell.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_NEARBY_H
#define MPM_METHOD_NEARBY_H

#include "method/fields/fields.h"

/* Places in cells within so much of a grid line count for both sides of it. */
#define MPM_CELL_SLACK 1e-9

/* Columns low[0]..high[0] and rows low[1]..high[1] of cells; ghosts counted, as in mpm_grid_index.
 */
struct mpm_cell_block {
    int64_t low[2], high[2];
};

static inline int64_t mpm_index_within(int64_t index, int64_t count)
{
    return index < 0 ? 0 : index < count ? index : count - 1;
}

/* Cells past the one that a domain ends in, up to the last node. */
static inline int64_t mpm_cells_past_end(const struct mpm_state *state)
{
    return state->family->point ? state->family->nodes_past_end - 1 : 0;
}

/* Of what lies between two places; `past`: so many cells more at the end. */
static inline struct mpm_cell_block mpm_block_between(const struct mpm_grid *grid,
                                                      const double low[2], const double high[2],
                                                      int64_t past)
{
    const int64_t counts[2] = {grid->columns, grid->rows};
    struct mpm_cell_block block;
    for (int axis = 0; axis < 2; axis++) {
        const double scale = grid->inverse_cell[axis], origin = grid->origin[axis];
        const int64_t first = mpm_floor((low[axis] - origin) * scale - MPM_CELL_SLACK);
        const int64_t last = mpm_floor((high[axis] - origin) * scale + MPM_CELL_SLACK) + past;
        block.low[axis] = mpm_index_within(first + MPM_GHOST_ROWS, counts[axis]);
        block.high[axis] = mpm_index_within(last + MPM_GHOST_ROWS, counts[axis]);
    }
    return block;
}

/* Takes memory for what is known of where particles are. */
void mpm_nearby_layout(struct mpm_state *state, struct mpm_arena *arena);
/* Particles have been sorted or put elsewhere. */
void mpm_nearby_forget(struct mpm_state *state);

/* Work for one particle; `block`: the cells that its nodes span, from the first one on, which is
 * left of and below all of them, by what may be round-off. */
typedef void mpm_nearby_work(void *context, size_t p, const struct mpm_cell_block *block);

/* Visits all particles of the strip whose blocks may have marked cells, in their order. */
void mpm_nearby_visit(const struct mpm_state *state, int64_t strip, const struct mpm_bands *bands,
                      mpm_nearby_work *visit, void *context);

#endif
