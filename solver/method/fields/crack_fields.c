/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fields/crack_fields.h"

#include "base/strips.h"
#include "method/cracks/crack_map.h"
#include "method/transfer/transfer.h"

#include <stdatomic.h>
#include <string.h>

_Static_assert(2 * MPM_STENCIL_MAX <= 32, "a particle's fields are two bits a node");

/* ------------------------------------------------------------ the particles */

/* What finding the fields of a particle works on. */
struct search {
    struct mpm_state *state;
    int64_t strip;
};

struct lattice_place {
    int64_t column, row;
};

/* Of a node of the block, or near it: without a division. */
static struct lattice_place place_in_block(const struct mpm_state *state,
                                           const struct mpm_cell_block *block, int64_t node)
{
    const int64_t columns = state->grid.columns;
    struct lattice_place place = {node - block->low[1] * columns, block->low[1]};
    for (; place.column >= columns; place.column -= columns)
        place.row++;
    return place;
}

/* Bits of `wanted` from here on: the axes across which a crack that asks for this side lies on a
 * plane of symmetry. */
static inline int plane_bits(enum mpm_crack_side side)
{
    return 1 + 2 * (int)side;
}

/* Strips of one colour have no row of nodes in common: the bits of a node are set by one worker. */
static void ask_for_field(const struct mpm_state *state, int64_t node,
                          const struct lattice_place *place, size_t crack, enum mpm_crack_side side)
{
    const struct mpm_cracks *const cracks = &state->cracks;
    /* a crack lies on a plane as a whole, or not at all */
    const unsigned planes = cracks->held[mpm_crack_first_point(state, crack)];
    cracks->wanted[node] |= (uint8_t)(1u << side | planes << plane_bits(side));
    mpm_crack_bands_mark(&cracks->map->wanted, place->column, place->row);
}

/* The particle's fields at its nodes as far as one crack has a say. */
static uint32_t code_of(const struct mpm_state *state, const struct mpm_crack_site *site,
                        const struct mpm_cell_block *block, const double particle[2],
                        struct mpm_crack_kept *made)
{
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[site->crack];
    const double from = mpm_crack_part_distance(&site->part, particle);
    uint32_t code = 0;
    for (int k = 0; k < made->stencil.count; k++) {
        const int64_t node = state->node_zero + made->stencil.node[k].node;
        const struct lattice_place at = place_in_block(state, block, node);
        const double place[2] = {
            grid->origin[0] + grid->cell[0] * (double)(at.column - MPM_GHOST_ROWS),
            grid->origin[1] + grid->cell[1] * (double)(at.row - MPM_GHOST_ROWS)};
        size_t segment = 0;
        if (mpm_crack_part_is_beside(&site->part, from,
                                     mpm_crack_part_distance(&site->part, place)))
            continue;
        const enum mpm_crack_side side =
            mpm_crack_part_side(chain, &site->part, particle, place, &segment);
        if (side == MPM_CRACK_SAME_SIDE)
            continue;
        code |= (uint32_t)side << (2 * k);
        made->crossing[k] = (struct mpm_crack_crossing){site->crack, (uint32_t)segment};
        ask_for_field(state, node, &at, site->crack, side);
    }
    return code;
}

/* May the part pass between the corners of the block? */
static bool may_pass(const struct mpm_state *state, const struct mpm_crack_part *part,
                     const struct mpm_cell_block *block)
{
    const struct mpm_grid *const grid = &state->grid;
    double middle[2], reach = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        const double low = (double)(block->low[axis] - MPM_GHOST_ROWS),
                     high = (double)(block->high[axis] + 1 - MPM_GHOST_ROWS);
        middle[axis] = grid->origin[axis] + 0.5 * (low + high) * grid->cell[axis];
        reach += 0.5 * (high - low) * grid->cell[axis] * fabs(part->normal[axis]);
    }
    return fabs(mpm_crack_part_distance(part, middle)) <= reach + part->thickness;
}

/* Both bits of each node that both codes hide. */
static uint32_t hidden_by_both(uint32_t one, uint32_t other)
{
    const uint32_t low = 0x55555555u;
    return 3u * ((one | one >> 1) & (other | other >> 1) & low);
}

static void add_to_spans(const struct mpm_state *state, int64_t index, size_t p)
{
    struct mpm_strip *const strip = &state->strips[index];
    struct mpm_crack_span *const spans = mpm_crack_spans(state, index);
    if (strip->span_count > 0 && p - spans[strip->span_count - 1].end < MPM_CRACK_GAP)
        spans[strip->span_count - 1].end = p + 1;
    else
        spans[strip->span_count++] = (struct mpm_crack_span){p, p + 1};
}

/* Where particles are kept depends on which strip is first; what is found there does not. */
static void keep(const struct search *search, const struct mpm_crack_kept *made)
{
    struct mpm_cracks *const cracks = &search->state->cracks;
    const size_t place = atomic_fetch_add_explicit(&cracks->kept_count, 1, memory_order_relaxed);
    if (place >= cracks->kept_capacity)
        return;
    struct mpm_crack_kept *const kept = &cracks->kept[place];
    kept->particle = made->particle;
    kept->code = made->code;
    kept->stencil.count = made->stencil.count;
    memcpy(kept->stencil.node, made->stencil.node,
           (size_t)made->stencil.count * sizeof *made->stencil.node);
    memcpy(kept->crossing, made->crossing, (size_t)made->stencil.count * sizeof *made->crossing);
    cracks->kept_of[made->particle] = (uint32_t)place + 1;
    add_to_spans(search->state, search->strip, made->particle);
}

static void find_code(void *context, size_t p, const struct mpm_cell_block *block)
{
    const struct search *const search = context;
    const struct mpm_state *const state = search->state;
    const double particle[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    struct mpm_crack_kept made;
    made.particle = (uint32_t)p;
    made.code = 0;
    made.stencil.count = 0;
    for (uint32_t crack = 0; crack < state->scene->crack_count; crack++) {
        struct mpm_crack_site together;
        const struct mpm_crack_site *const site =
            mpm_crack_map_site(state, block, crack, &together);
        if (site == NULL || !may_pass(state, &site->part, block))
            continue;
        if (made.stencil.count == 0)
            mpm_particle_plain_stencil(state, p, &made.stencil);
        const uint32_t code = code_of(state, site, block, particle, &made);
        const uint32_t both = hidden_by_both(made.code, code);
        if (both != 0)
            mpm_strip_record(&state->strips[search->strip], MPM_TWO_CRACKS, state->particles.id[p],
                             0, 0.0);
        /* the step is over before it is refused: above one and below the other is no field */
        made.code |= code & ~both;
    }
    if (made.code != 0)
        keep(search, &made);
}

static void find_codes(void *context, int64_t index, int worker)
{
    const struct search search = {context, index};
    struct mpm_strip *const strip = &search.state->strips[index];
    (void)worker;
    strip->span_count = 0;
    mpm_crack_bands_visit(search.state, strip, &search.state->cracks.map->listed, find_code,
                          (void *)&search);
}

/* ---------------------------------------------------------------- the nodes */

/* The cells that the node is a corner of: blocks of particles that reach it have one of them. */
static void mark_cells(struct mpm_state *state, int64_t node)
{
    const int64_t row = node / state->grid.columns, column = node % state->grid.columns;
    for (int64_t k = row > 0 ? row - 1 : 0; k <= row; k++) {
        mpm_crack_bands_mark(&state->cracks.map->beside, column > 0 ? column - 1 : 0, k);
        mpm_crack_bands_mark(&state->cracks.map->beside, column, k);
    }
}

static bool add_node(struct mpm_state *state, int64_t node)
{
    struct mpm_cracks *const cracks = &state->cracks;
    const int64_t first = state->grid.columns * state->grid.rows;
    struct mpm_crack_node made = {.field = {node, -1, -1}};
    if (cracks->node_count == cracks->node_capacity)
        return false;
    for (int side = MPM_CRACK_ABOVE; side <= MPM_CRACK_BELOW; side++)
        if ((cracks->wanted[node] & (1u << side)) != 0) {
            cracks->homes[cracks->field_count] = node;
            made.field[side] = first + cracks->field_count++;
            made.face[side].crack = MPM_NO_CRACK;
            made.on_plane[side] =
                (unsigned)cracks->wanted[node] >> plane_bits((enum mpm_crack_side)side) & 3u;
        }
    cracks->nodes[cracks->node_count++] = made;
    mark_cells(state, node);
    cracks->node_of[node] = (uint32_t)cracks->node_count;
    return true;
}

/* In the order of the grid. */
static bool list_nodes(struct mpm_state *state)
{
    const struct mpm_cracks *const cracks = &state->cracks;
    const struct mpm_crack_bands *const wanted = &cracks->map->wanted;
    for (int64_t row = 0; row < state->grid.rows; row++)
        for (int64_t column = wanted->low[row]; column <= wanted->high[row]; column++) {
            const int64_t node = row * state->grid.columns + column;
            if (cracks->wanted[node] != 0 && !add_node(state, node))
                return false;
            cracks->wanted[node] = 0;
        }
    return true;
}

static void forget(struct mpm_cracks *cracks)
{
    for (size_t k = 0; k < cracks->node_count; k++)
        cracks->node_of[cracks->nodes[k].field[0]] = 0;
    for (size_t k = 0; k < cracks->kept_count && k < cracks->kept_capacity; k++)
        cracks->kept_of[cracks->kept[k].particle] = 0;
    cracks->node_count = 0;
    cracks->field_count = 0;
    cracks->kept_count = 0;
}

static void set_rows(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    const int64_t columns = state->grid.columns;
    cracks->rows = (cracks->field_count + columns - 1) / columns;
    for (int64_t k = 0; k < cracks->rows; k++) {
        const int64_t left = cracks->field_count - k * columns;
        state->row_low[state->grid.rows + k] = 0;
        state->row_high[state->grid.rows + k] = (left < columns ? left : columns) - 1;
    }
}

/* ----------------------------------------------------------------- stencils */

static inline int64_t diverted(const struct mpm_state *state, int64_t offset, uint32_t side)
{
    const struct mpm_crack_node *const node = mpm_crack_node_at(state, state->node_zero + offset);
    return node->field[side] - state->node_zero;
}

/* Tells the particle's nodes which crack is before its field. The first and the last one do not
 * depend on the order of the particles. */
static void name_cracks(const struct mpm_state *state, const struct mpm_crack_kept *kept)
{
    uint32_t code = kept->code;
    for (int k = 0; code != 0; k++, code >>= 2) {
        if ((code & 3u) == 0)
            continue;
        struct mpm_crack_node *const node =
            mpm_crack_node_at(state, state->node_zero + kept->stencil.node[k].node);
        struct mpm_crack_face *const face = &node->face[code & 3u];
        const uint32_t crack = kept->crossing[k].crack;
        face->last = face->crack == MPM_NO_CRACK || crack > face->last ? crack : face->last;
        face->crack = crack < face->crack ? crack : face->crack;
    }
}

/* Puts the particle's fields into its stencil. */
static void divert(const struct mpm_state *state, struct mpm_crack_kept *kept)
{
    const bool hides = state->scene->crack_method == MPM_CRACKS_VISIBILITY;
    struct mpm_stencil *const stencil = &kept->stencil;
    uint32_t code = kept->code;
    int count = 0;
    for (int k = 0; k < stencil->count; k++, code >>= 2) {
        struct mpm_stencil_node entry = stencil->node[k];
        if ((code & 3u) != 0 && hides)
            continue;
        if ((code & 3u) != 0)
            entry.node = diverted(state, entry.node, code & 3u);
        stencil->node[count++] = entry;
    }
    stencil->count = count;
}

/* What this step has asked for is not to reach the next one. */
static enum mpm_status no_room(struct mpm_state *state, const char *what, size_t capacity,
                               struct mpm_error *error)
{
    memset(state->cracks.wanted, 0, (size_t)(state->grid.columns * state->grid.rows));
    return mpm_error_fail(
        error, MPM_CAUSE_CRACK,
        "there are more %s near cracks than the %zu that there is room for: cracks "
        "have grown or stretched, or bodies are compressed there",
        what, capacity);
}

enum mpm_status mpm_cracks_find_fields(struct mpm_state *state, int workers,
                                       struct mpm_error *error)
{
    struct mpm_cracks *const cracks = &state->cracks;
    if (cracks->point_count == 0)
        return MPM_OK;
    forget(cracks);
    if (!mpm_crack_map_draw(state)) /* clears all bands */
        return no_room(state, "cells", cracks->map->capacity, error);
    mpm_strips_run(state->strip_count, workers, find_codes, state);
    if (cracks->kept_count > cracks->kept_capacity)
        return no_room(state, "particles", cracks->kept_capacity, error);
    if (!list_nodes(state))
        return no_room(state, "nodes", cracks->node_capacity, error);
    set_rows(state);
    for (size_t k = 0; k < cracks->kept_count; k++) {
        name_cracks(state, &cracks->kept[k]);
        divert(state, &cracks->kept[k]);
    }
    return MPM_OK;
}

/* -------------------------------------------------------------------- edges */

/* The plain stencil has the same nodes in the same order. */
void mpm_crack_divert_edge(const struct mpm_state *state, size_t p,
                           struct mpm_edge_weights *weights)
{
    struct mpm_stencil plain;
    const struct mpm_crack_kept *const kept = mpm_crack_kept_of(state, p);
    if (kept == NULL)
        return;
    mpm_particle_plain_stencil(state, p, &plain);
    for (int i = 0; i < weights->count; i++)
        for (int k = 0; k < plain.count; k++)
            if (plain.node[k].node == weights->entry[i].node && (kept->code >> 2 * k & 3u) != 0) {
                weights->entry[i].node =
                    diverted(state, plain.node[k].node, kept->code >> 2 * k & 3u);
                break;
            }
}
