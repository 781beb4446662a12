/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/nearby.h"

#include "method/transfer/transfer.h"

#include <math.h>
#include <string.h>

/* Particles that are tested together. */
enum { CHUNK = 32 };

/* ---------------------------------------------------------------------- layout */

static size_t hull_count(const struct mpm_state *state)
{
    return state->particles.count / CHUNK + (size_t)state->strip_count + 1;
}

void mpm_nearby_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    state->nearby = MPM_TAKE(arena, struct mpm_chunk_hull, hull_count(state));
}

/* ----------------------------------------------------------------------- bands */

/* May a block have marked cells? */
static bool meet(const struct mpm_bands *bands, const struct mpm_cell_block *block)
{
    for (int64_t row = block->low[1]; row <= block->high[1]; row++)
        if (bands->low[row] <= block->high[0] && bands->high[row] >= block->low[0])
            return true;
    return false;
}

/* ---------------------------------------------------------------------- blocks */

/* The cells that a particle's nodes span: the first is left of and below all of them, by what may
 * be round-off. */
static struct mpm_cell_block block_of(const struct mpm_state *state, size_t p)
{
    const double *reach = state->widest;
    struct mpm_placement placement;
    double low[2], high[2];
    if (state->family->convected) {
        placement = mpm_particle_placement(state, p);
        reach = placement.reach;
    }
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = state->particles.position[axis][p] - reach[axis];
        high[axis] = state->particles.position[axis][p] + reach[axis];
    }
    return mpm_block_between(&state->grid, low, high, mpm_cells_past_end(state));
}

/* The cells between the nodes of a strip. */
static struct mpm_cell_block strip_block(const struct mpm_state *state,
                                         const struct mpm_strip *strip)
{
    const int64_t counts[2] = {state->grid.columns, state->grid.rows};
    struct mpm_cell_block block;
    for (int axis = 0; axis < 2; axis++) {
        block.low[axis] = mpm_index_within(strip->box.low[axis] + MPM_GHOST_ROWS, counts[axis]);
        block.high[axis] = mpm_index_within(strip->box.high[axis] + MPM_GHOST_ROWS, counts[axis]);
    }
    return block;
}

/* -------------------------------------------------------------------- visiting */

/* Places along an axis. */
struct interval {
    double low, high;
};

static inline bool contains(const struct interval *interval, double place)
{
    return place >= interval->low && place <= interval->high;
}

/* By signs of products, and-ed together: compilers take several places at a time. */
static bool contains_any(const struct interval *interval, const double *places, size_t count)
{
    const double low = interval->low, high = interval->high;
    uint64_t outside = UINT64_MAX;
    for (size_t k = 0; k < count; k++) {
        const double product = (places[k] - low) * (high - places[k]);
        uint64_t bits;
        memcpy(&bits, &product, sizeof bits);
        outside &= bits;
    }
    return outside >> 63 == 0;
}

static struct interval hull_of(const double *places, size_t count)
{
    struct interval hull = {places[0], places[0]};
#pragma GCC unroll 8
    for (size_t k = 1; k < count; k++) {
        hull.low = places[k] < hull.low ? places[k] : hull.low;
        hull.high = places[k] > hull.high ? places[k] : hull.high;
    }
    return hull;
}

/* No less than the largest size, and not much more. */
static double largest_size(const double *values, size_t count)
{
    static const double usual = 1.5;
    static const struct interval above = {usual, 1e300}, below = {-1e300, -usual};
    if (!contains_any(&above, values, count) && !contains_any(&below, values, count))
        return usual;
    const struct interval hull = hull_of(values, count);
    return -hull.low > hull.high ? -hull.low : hull.high;
}

struct chunk {
    size_t begin, count;
    double reach[2]; /* of its domains, at least */
};

static void find_reach(const struct mpm_state *state, struct chunk *chunk)
{
    static const int parts[2][2] = {{MPM_XX, MPM_XY}, {MPM_YX, MPM_YY}};
    const double *const widest = state->widest;
    for (int axis = 0; axis < 2; axis++) {
        chunk->reach[axis] = widest[axis];
        if (!state->family->convected)
            continue;
        chunk->reach[axis] = 0.0;
        for (int k = 0; k < 2; k++) {
            const double *const part = state->particles.deformation[parts[axis][k]];
            chunk->reach[axis] += widest[k] * largest_size(part + chunk->begin, chunk->count);
        }
    }
}

/* Columns of the marked cells of some rows. */
struct columns {
    int64_t low, high;
};

static struct columns columns_of(const struct mpm_bands *bands, int64_t first, int64_t last)
{
    struct columns columns = {INT64_MAX, -1};
    for (int64_t row = first; row <= last; row++) {
        columns.low = bands->low[row] < columns.low ? bands->low[row] : columns.low;
        columns.high = bands->high[row] > columns.high ? bands->high[row] : columns.high;
    }
    return columns;
}

/* Where along x must a particle of the chunk be for its block to have some of the columns? */
static struct interval interval_of(const struct mpm_state *state, const struct columns *columns,
                                   const struct chunk *chunk)
{
    const struct mpm_grid *const grid = &state->grid;
    const double past = (double)mpm_cells_past_end(state) + 2.0 * MPM_CELL_SLACK;
    if (columns->low > columns->high)
        return (struct interval){1.0, -1.0};
    const double first = (double)(columns->low - MPM_GHOST_ROWS) - past,
                 end = (double)(columns->high + 1 - MPM_GHOST_ROWS) + past;
    return (struct interval){grid->origin[0] + first * grid->cell[0] - chunk->reach[0],
                             grid->origin[0] + end * grid->cell[0] + chunk->reach[0]};
}

/* Columns of the rows that the chunk's own blocks are in. */
static struct columns columns_of_chunk(const struct mpm_state *state, const struct mpm_bands *bands,
                                       const struct chunk *chunk, const struct mpm_chunk_hull *hull)
{
    const double low[2] = {state->grid.origin[0], hull->low[1] - chunk->reach[1]},
                 high[2] = {state->grid.origin[0], hull->high[1] + chunk->reach[1]};
    const struct mpm_cell_block block =
        mpm_block_between(&state->grid, low, high, mpm_cells_past_end(state));
    return columns_of(bands, block.low[1], block.high[1]);
}

static void visit_chunk(const struct mpm_state *state, const struct mpm_bands *bands,
                        const struct chunk *chunk, const struct mpm_chunk_hull *hull,
                        mpm_nearby_work *visit, void *context)
{
    const double *const x = state->particles.position[0];
    const struct columns columns = columns_of_chunk(state, bands, chunk, hull);
    const struct interval near = interval_of(state, &columns, chunk);
    for (size_t p = chunk->begin; p < chunk->begin + chunk->count; p++) {
        if (!contains(&near, x[p]))
            continue;
        const struct mpm_cell_block block = block_of(state, p);
        if (meet(bands, &block))
            visit(context, p, &block);
    }
}

/* A step moves no particle by more than a cell (mpm_placement_check). */
static bool may_have_come(const struct mpm_state *state, const struct mpm_chunk_hull *hull,
                          const struct interval *near)
{
    const double moved = state->grid.cell[0] * (double)(state->steps_since_sort - hull->step);
    return hull->low[0] - moved <= near->high && hull->high[0] + moved >= near->low;
}

static bool has_come(const struct mpm_state *state, const struct chunk *chunk,
                     const struct interval *near, struct mpm_chunk_hull *hull)
{
    double *const *const position = state->particles.position;
    if (hull->step != state->steps_since_sort) {
        const struct interval x = hull_of(position[0] + chunk->begin, chunk->count);
        *hull = (struct mpm_chunk_hull){{x.low, 1.0}, {x.high, -1.0}, state->steps_since_sort};
    }
    if (!may_have_come(state, hull, near))
        return false;
    if (hull->low[1] > hull->high[1]) {
        const struct interval y = hull_of(position[1] + chunk->begin, chunk->count);
        hull->low[1] = y.low;
        hull->high[1] = y.high;
    }
    return true;
}

void mpm_nearby_forget(struct mpm_state *state)
{
    for (size_t k = 0; state->nearby != NULL && k < hull_count(state); k++)
        state->nearby[k] =
            (struct mpm_chunk_hull){{-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}, -1};
}

void mpm_nearby_visit(const struct mpm_state *state, int64_t index, const struct mpm_bands *bands,
                      mpm_nearby_work *visit, void *context)
{
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_cell_block all = strip_block(state, strip);
    if (strip->begin == strip->end || !meet(bands, &all))
        return;
    const struct columns columns = columns_of(bands, all.low[1], all.high[1]);
    struct mpm_chunk_hull *hull = state->nearby + (size_t)index + strip->begin / CHUNK;
    struct chunk chunk = {.begin = strip->begin};
    find_reach(state, &chunk);
    struct interval near = interval_of(state, &columns, &chunk);
    for (; chunk.begin < strip->end; chunk.begin += chunk.count, hull++) {
        const size_t rest = strip->end - chunk.begin;
        chunk.count = rest < CHUNK ? rest : CHUNK;
        if (state->family->convected) {
            find_reach(state, &chunk);
            near = interval_of(state, &columns, &chunk);
        }
        if (may_have_come(state, hull, &near) && has_come(state, &chunk, &near, hull))
            visit_chunk(state, bands, &chunk, hull, visit, context);
    }
}
