/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_map.h"

#include "method/transfer/transfer.h"

#include <math.h>
#include <string.h>

/* Places in cells within so much of a grid line count for both sides of it. */
static const double CELL_SLACK = 1e-9;
/* Round-off of places, of the largest coordinate. */
static const double PLACE_SLACK = 1e-12;

/* ---------------------------------------------------------------------- layout */

void mpm_crack_map_layout(struct mpm_state *state, size_t capacity, struct mpm_arena *arena)
{
    struct mpm_crack_map *const map = MPM_TAKE(arena, struct mpm_crack_map, 1);
    const struct mpm_crack_map made = {
        .first = MPM_TAKE(arena, uint32_t, (size_t)(state->grid.columns * state->grid.rows)),
        .sites = MPM_TAKE(arena, struct mpm_crack_site, capacity),
        .capacity = capacity,
        .listed = mpm_bands_layout(state, arena),
    };
    if (map != NULL)
        *map = made;
    state->cracks.map = map;
}

/* Cells past the one that a domain ends in, up to the last node. */
static int64_t cells_past_end(const struct mpm_state *state)
{
    return state->family->point ? state->family->nodes_past_end - 1 : 0;
}

void mpm_crack_map_fill(struct mpm_state *state)
{
    const struct mpm_grid *const grid = &state->grid;
    struct mpm_crack_map *const map = state->cracks.map;
    double widest = 0.0, farthest = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        widest = fmax(widest, 2.0 * state->cracks.widest[axis] * grid->inverse_cell[axis]);
        farthest = fmax(farthest, fmax(fabs(grid->origin[axis]), fabs(mpm_grid_end(grid, axis))));
    }
    map->span = (int64_t)ceil(widest - CELL_SLACK) + 1 + cells_past_end(state);
    map->slack = PLACE_SLACK * farthest;
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

static inline int64_t within(int64_t index, int64_t count)
{
    return index < 0 ? 0 : index < count ? index : count - 1;
}

/* Of what lies between two places; `past`: so many cells more at the end. */
static inline struct mpm_cell_block block_between(const struct mpm_grid *grid, const double low[2],
                                                  const double high[2], int64_t past)
{
    const int64_t counts[2] = {grid->columns, grid->rows};
    struct mpm_cell_block block;
    for (int axis = 0; axis < 2; axis++) {
        const double scale = grid->inverse_cell[axis], origin = grid->origin[axis];
        const int64_t first = mpm_floor((low[axis] - origin) * scale - CELL_SLACK);
        const int64_t last = mpm_floor((high[axis] - origin) * scale + CELL_SLACK) + past;
        block.low[axis] = within(first + MPM_GHOST_ROWS, counts[axis]);
        block.high[axis] = within(last + MPM_GHOST_ROWS, counts[axis]);
    }
    return block;
}

/* The cells that a particle's nodes span: the first is left of and below all of them, by what may
 * be round-off. */
static struct mpm_cell_block block_of(const struct mpm_state *state, size_t p)
{
    const double *reach = state->cracks.widest;
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
    return block_between(&state->grid, low, high, cells_past_end(state));
}

/* The cells between the nodes of a strip. */
static struct mpm_cell_block strip_block(const struct mpm_state *state,
                                         const struct mpm_strip *strip)
{
    const int64_t counts[2] = {state->grid.columns, state->grid.rows};
    struct mpm_cell_block block;
    for (int axis = 0; axis < 2; axis++) {
        block.low[axis] = within(strip->box.low[axis] + MPM_GHOST_ROWS, counts[axis]);
        block.high[axis] = within(strip->box.high[axis] + MPM_GHOST_ROWS, counts[axis]);
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

/* Particles that are tested together. */
enum { CHUNK = 32 };

struct chunk {
    size_t begin, count;
    double reach[2]; /* of its domains, at least */
};

static void find_reach(const struct mpm_state *state, struct chunk *chunk)
{
    static const int parts[2][2] = {{MPM_XX, MPM_XY}, {MPM_YX, MPM_YY}};
    const double *const widest = state->cracks.widest;
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
    const double past = (double)cells_past_end(state) + 2.0 * CELL_SLACK;
    if (columns->low > columns->high)
        return (struct interval){1.0, -1.0};
    const double first = (double)(columns->low - MPM_GHOST_ROWS) - past,
                 end = (double)(columns->high + 1 - MPM_GHOST_ROWS) + past;
    return (struct interval){grid->origin[0] + first * grid->cell[0] - chunk->reach[0],
                             grid->origin[0] + end * grid->cell[0] + chunk->reach[0]};
}

/* Columns of the rows that the chunk's own blocks are in. */
static struct columns columns_of_chunk(const struct mpm_state *state, const struct mpm_bands *bands,
                                       const struct chunk *chunk)
{
    const struct interval y = hull_of(state->particles.position[1] + chunk->begin, chunk->count);
    const double low[2] = {state->grid.origin[0], y.low - chunk->reach[1]},
                 high[2] = {state->grid.origin[0], y.high + chunk->reach[1]};
    const struct mpm_cell_block block =
        block_between(&state->grid, low, high, cells_past_end(state));
    return columns_of(bands, block.low[1], block.high[1]);
}

static void visit_chunk(const struct mpm_state *state, const struct mpm_bands *bands,
                        const struct chunk *chunk, mpm_crack_visit *visit, void *context)
{
    const double *const x = state->particles.position[0];
    const struct columns columns = columns_of_chunk(state, bands, chunk);
    const struct interval near = interval_of(state, &columns, chunk);
    for (size_t p = chunk->begin; p < chunk->begin + chunk->count; p++) {
        if (!contains(&near, x[p]))
            continue;
        const struct mpm_cell_block block = block_of(state, p);
        if (meet(bands, &block))
            visit(context, p, &block);
    }
}

void mpm_crack_bands_visit(const struct mpm_state *state, const struct mpm_strip *strip,
                           const struct mpm_bands *bands, mpm_crack_visit *visit, void *context)
{
    const double *const x = state->particles.position[0];
    const struct mpm_cell_block all = strip_block(state, strip);
    if (strip->begin == strip->end || !meet(bands, &all))
        return;
    const struct columns columns = columns_of(bands, all.low[1], all.high[1]);
    struct chunk chunk = {.begin = strip->begin};
    for (; chunk.begin < strip->end; chunk.begin += chunk.count) {
        const size_t rest = strip->end - chunk.begin;
        chunk.count = rest < CHUNK ? rest : CHUNK;
        find_reach(state, &chunk);
        const struct interval near = interval_of(state, &columns, &chunk);
        if (contains_any(&near, x + chunk.begin, chunk.count))
            visit_chunk(state, bands, &chunk, visit, context);
    }
}

/* --------------------------------------------------------------------- drawing */

static struct mpm_crack_site *find_site(const struct mpm_crack_map *map, int64_t cell,
                                        uint32_t crack)
{
    uint32_t next = map->first[cell];
    while (next != 0 && map->sites[next - 1].crack != crack)
        next = map->sites[next - 1].next;
    return next == 0 ? NULL : &map->sites[next - 1];
}

/* Segments come in their order. */
static bool list_cell(struct mpm_crack_map *map, int64_t cell, uint32_t crack, size_t segment)
{
    struct mpm_crack_site *const site = find_site(map, cell, crack);
    if (site != NULL) {
        site->part.end = segment + 1;
        return true;
    }
    if (map->count == map->capacity)
        return false;
    map->sites[map->count] = (struct mpm_crack_site){
        cell, crack, map->first[cell], {.first = segment, .end = segment + 1}};
    map->first[cell] = (uint32_t)++map->count;
    return true;
}

static bool list_segment(struct mpm_state *state, uint32_t crack, size_t k)
{
    const struct mpm_crack_chain *const chain = &state->cracks.chains[crack];
    struct mpm_crack_map *const map = state->cracks.map;
    const double low[2] = {fmin(chain->x[k], chain->x[k + 1]), fmin(chain->y[k], chain->y[k + 1])};
    const double high[2] = {fmax(chain->x[k], chain->x[k + 1]), fmax(chain->y[k], chain->y[k + 1])};
    const struct mpm_cell_block met = block_between(&state->grid, low, high, 0);
    const int64_t back = map->span - 1;
    for (int64_t row = within(met.low[1] - back, state->grid.rows); row <= met.high[1]; row++) {
        const int64_t first = within(met.low[0] - back, state->grid.columns);
        mpm_bands_mark(&map->listed, first, row);
        mpm_bands_mark(&map->listed, met.high[0], row);
        for (int64_t column = first; column <= met.high[0]; column++)
            if (!list_cell(map, row * state->grid.columns + column, crack, k))
                return false;
    }
    return true;
}

static void forget_sites(struct mpm_crack_map *map)
{
    for (size_t k = 0; k < map->count; k++)
        map->first[map->sites[k].cell] = 0;
    map->count = 0;
}

bool mpm_crack_map_draw(struct mpm_state *state)
{
    struct mpm_crack_map *const map = state->cracks.map;
    forget_sites(map);
    mpm_bands_clear(state, &map->listed);
    for (uint32_t crack = 0; crack < state->scene->crack_count; crack++)
        for (size_t k = 0; k + 1 < state->cracks.chains[crack].count; k++)
            if (!list_segment(state, crack, k))
                return false;
    for (size_t k = 0; k < map->count; k++) {
        struct mpm_crack_part *const part = &map->sites[k].part;
        *part = mpm_crack_part_of(&state->cracks.chains[map->sites[k].crack], part->first,
                                  part->end, map->slack);
    }
    return true;
}

/* --------------------------------------------------------------------- look-up */

static const struct mpm_crack_site *put_together(const struct mpm_state *state,
                                                 const struct mpm_cell_block *block, uint32_t crack,
                                                 struct mpm_crack_site *made)
{
    const struct mpm_crack_map *const map = state->cracks.map;
    size_t first = SIZE_MAX, end = 0;
    for (int64_t row = block->low[1]; row <= block->high[1]; row += map->span)
        for (int64_t column = block->low[0]; column <= block->high[0]; column += map->span) {
            const struct mpm_crack_site *const site =
                find_site(map, row * state->grid.columns + column, crack);
            if (site == NULL)
                continue;
            first = site->part.first < first ? site->part.first : first;
            end = site->part.end > end ? site->part.end : end;
        }
    if (end == 0)
        return NULL;
    *made = (struct mpm_crack_site){
        .crack = crack,
        .part = mpm_crack_part_of(&state->cracks.chains[crack], first, end, map->slack),
    };
    return made;
}

const struct mpm_crack_site *mpm_crack_map_site(const struct mpm_state *state,
                                                const struct mpm_cell_block *block, uint32_t crack,
                                                struct mpm_crack_site *made)
{
    const struct mpm_crack_map *const map = state->cracks.map;
    if (block->high[0] - block->low[0] < map->span && block->high[1] - block->low[1] < map->span)
        return find_site(map, block->low[1] * state->grid.columns + block->low[0], crack);
    return put_together(state, block, crack, made);
}

const struct mpm_crack_part *mpm_crack_map_part(const struct mpm_state *state,
                                                const struct mpm_crack_box *box, uint32_t crack,
                                                struct mpm_crack_site *made)
{
    const struct mpm_cell_block block = block_between(&state->grid, box->low, box->high, 0);
    const struct mpm_crack_site *const site = mpm_crack_map_site(state, &block, crack, made);
    return site == NULL ? NULL : &site->part;
}
