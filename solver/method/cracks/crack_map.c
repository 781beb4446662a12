/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_map.h"

#include "method/transfer/transfer.h"

#include <math.h>
#include <string.h>

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

void mpm_crack_map_fill(struct mpm_state *state)
{
    const struct mpm_grid *const grid = &state->grid;
    struct mpm_crack_map *const map = state->cracks.map;
    double widest = 0.0, farthest = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        widest = fmax(widest, 2.0 * state->widest[axis] * grid->inverse_cell[axis]);
        farthest = fmax(farthest, fmax(fabs(grid->origin[axis]), fabs(mpm_grid_end(grid, axis))));
    }
    map->span = (int64_t)ceil(widest - MPM_CELL_SLACK) + 1 + mpm_cells_past_end(state);
    map->slack = PLACE_SLACK * farthest;
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
    const struct mpm_cell_block met = mpm_block_between(&state->grid, low, high, 0);
    const int64_t back = map->span - 1;
    for (int64_t row = mpm_index_within(met.low[1] - back, state->grid.rows); row <= met.high[1];
         row++) {
        const int64_t first = mpm_index_within(met.low[0] - back, state->grid.columns);
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

/* Cells side by side have the same segments: the parts found last, by the first of these. */
static void find_parts(struct mpm_state *state)
{
    enum { KEPT = 8 };
    const struct mpm_crack_map *const map = state->cracks.map;
    const struct mpm_crack_site *last[KEPT] = {NULL};
    for (size_t k = 0; k < map->count; k++) {
        struct mpm_crack_site *const site = &map->sites[k];
        const struct mpm_crack_site **const kept = &last[site->part.first % KEPT];
        if (*kept != NULL && (*kept)->crack == site->crack &&
            (*kept)->part.first == site->part.first && (*kept)->part.end == site->part.end)
            site->part = (*kept)->part;
        else
            site->part = mpm_crack_part_of(&state->cracks.chains[site->crack], site->part.first,
                                           site->part.end, map->slack);
        *kept = site;
    }
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
    find_parts(state);
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
    const struct mpm_cell_block block = mpm_block_between(&state->grid, box->low, box->high, 0);
    const struct mpm_crack_site *const site = mpm_crack_map_site(state, &block, crack, made);
    return site == NULL ? NULL : &site->part;
}
