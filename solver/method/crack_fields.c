/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/crack_fields.h"

#include "base/strips.h"
#include "method/extent.h"
#include "method/transfer.h"

#include <math.h>
#include <string.h>

_Static_assert(2 * MPM_STENCIL_MAX <= 32, "a particle's fields are two bits a node");

/* ------------------------------------------------------------ the particles */

/* The box that a particle and all its nodes lie in. */
static struct mpm_crack_box box_of(const struct mpm_state *state, size_t p)
{
    const double *reach = state->cracks.reach[state->particles.body[p]];
    double wide[2];
    if (state->family->convected) {
        const struct mpm_placement placement = mpm_particle_placement(state, p);
        for (int axis = 0; axis < 2; axis++)
            wide[axis] =
                placement.reach[axis] + state->family->nodes_past_end * state->grid.cell[axis];
        reach = wide;
    }
    const double x = state->particles.position[0][p], y = state->particles.position[1][p];
    return (struct mpm_crack_box){{x - reach[0], y - reach[1]}, {x + reach[0], y + reach[1]}};
}

/* Is a node that the strip's particles reach near a crack? So many cells from it a node may have
 * further fields. */
enum { NODES_APART = 4 };
static bool is_strip_near(const struct mpm_state *state, const struct mpm_strip *strip)
{
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_crack_box box = {
        .low = {grid->origin[0] + grid->cell[0] * (double)(strip->column_low - NODES_APART),
                grid->origin[1] + grid->cell[1] * (double)(strip->row_low - NODES_APART)},
        .high = {grid->origin[0] + grid->cell[0] * (double)(strip->column_high + NODES_APART),
                 grid->origin[1] + grid->cell[1] * (double)(strip->row_high + NODES_APART)},
    };
    for (size_t k = 0; k < state->scene->crack_count; k++) {
        if (mpm_crack_chain_meets(&state->cracks.chains[k], &box))
            return true;
    }
    return false;
}

/* May one of its nodes have further fields? Such a node is one of a particle whose box meets a
 * crack: this one's does, with half the widest box around it. Of domains that F has stretched
 * (CPDI) the widest is taken to be this one. */
static bool is_near(const struct mpm_state *state, size_t p)
{
    struct mpm_crack_box box = box_of(state, p);
    for (int axis = 0; axis < 2; axis++) {
        const double own = 0.5 * (box.high[axis] - box.low[axis]);
        const double half = fmax(own, state->cracks.widest[axis]);
        box.low[axis] -= half;
        box.high[axis] += half;
    }
    for (size_t k = 0; k < state->scene->crack_count; k++)
        if (mpm_crack_chain_meets(&state->cracks.chains[k], &box))
            return true;
    return false;
}

struct mpm_crack_range mpm_crack_range_of(const struct mpm_state *state, size_t p, size_t crack)
{
    const struct mpm_crack_box box = box_of(state, p);
    return mpm_crack_chain_near(&state->cracks.chains[crack], &box);
}

/* The particle's fields at its nodes as far as one crack has a say. */
static uint32_t code_of(const struct mpm_state *state, size_t p, size_t crack,
                        struct mpm_crack_range range, const struct mpm_stencil *stencil)
{
    const double particle[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    uint32_t code = 0;
    for (int k = 0; k < stencil->count; k++) {
        double place[2];
        mpm_grid_position(&state->grid, state->node_zero + stencil->node[k].node, place);
        code |= (uint32_t)mpm_crack_chain_side(&state->cracks.chains[crack], range, particle, place,
                                               NULL)
                << (2 * k);
    }
    return code;
}

/* The nodes that are hidden by both. */
static bool contradict(uint32_t one, uint32_t other)
{
    const uint32_t low = 0x55555555u;
    return ((one | one >> 1) & (other | other >> 1) & low) != 0;
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

/* Strips of one colour have no node in common: the bits of a node are set by one worker. */
static void find_codes(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const size_t count = strip->end - strip->begin;
    (void)worker;
    strip->span_count = 0;
    memset(state->cracks.code + strip->begin, 0, count * sizeof *state->cracks.code);
    memset(state->cracks.near + strip->begin, 0, count * sizeof *state->cracks.near);
    if (!is_strip_near(state, strip))
        return;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil stencil = {.count = 0};
        uint32_t code = 0;
        if (!is_near(state, p))
            continue;
        state->cracks.near[p] = 1;
        for (size_t crack = 0; crack < state->scene->crack_count; crack++) {
            const struct mpm_crack_range range = mpm_crack_range_of(state, p, crack);
            if (range.first == range.end)
                continue;
            if (stencil.count == 0)
                mpm_particle_stencil(state, p, &stencil);
            const uint32_t one = code_of(state, p, crack, range, &stencil);
            if (contradict(code, one))
                mpm_strip_record(strip, MPM_TWO_CRACKS, state->particles.id[p], 0, 0.0);
            code |= one;
        }
        state->cracks.code[p] = code;
        if (code != 0)
            add_to_spans(state, index, p);
        for (int k = 0; k < stencil.count && code >> 2 * k != 0; k++)
            state->cracks.wanted[state->node_zero + stencil.node[k].node] |=
                (uint8_t)(1u << (code >> 2 * k & 3u));
    }
}

/* ---------------------------------------------------------------- the nodes */

/* Boxes of active rows may be wider than what cracks reach: only nodes that are asked for count. */
static bool asks_for_more(uint8_t wanted)
{
    return (wanted & ~(1u << MPM_CRACK_SAME_SIDE)) != 0;
}

static bool add_node(struct mpm_state *state, int64_t node)
{
    struct mpm_cracks *const cracks = &state->cracks;
    const int64_t first = state->grid.columns * state->grid.rows;
    struct mpm_crack_node made = {.field = {node, -1, -1}, .crack = SIZE_MAX};
    if (cracks->node_count == cracks->node_capacity)
        return false;
    for (int side = MPM_CRACK_ABOVE; side <= MPM_CRACK_BELOW; side++)
        if ((cracks->wanted[node] & (1u << side)) != 0) {
            cracks->homes[cracks->field_count] = node;
            made.field[side] = first + cracks->field_count++;
        }
    cracks->nodes[cracks->node_count++] = made;
    cracks->node_of[node] = (uint32_t)cracks->node_count;
    return true;
}

static bool list_nodes(struct mpm_state *state)
{
    const struct mpm_cracks *const cracks = &state->cracks;
    for (int64_t row = state->first_row; row <= state->last_row; row++)
        for (int64_t column = state->row_low[row]; column <= state->row_high[row]; column++) {
            const int64_t node = row * state->grid.columns + column;
            if (asks_for_more(cracks->wanted[node]) && !add_node(state, node))
                return false;
            cracks->wanted[node] = 0;
        }
    return true;
}

static void forget_nodes(struct mpm_cracks *cracks)
{
    for (size_t k = 0; k < cracks->node_count; k++)
        cracks->node_of[cracks->nodes[k].field[0]] = 0;
    cracks->node_count = 0;
    cracks->field_count = 0;
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

enum mpm_status mpm_cracks_find_fields(struct mpm_state *state, int workers,
                                       struct mpm_error *error)
{
    struct mpm_cracks *const cracks = &state->cracks;
    if (cracks->point_count == 0)
        return MPM_OK;
    for (size_t k = 0; k < state->scene->crack_count; k++)
        mpm_crack_chain_bound(&cracks->chains[k]);
    forget_nodes(cracks);
    mpm_strips_run(state->strip_count, workers, find_codes, state);
    if (!list_nodes(state))
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "cracks have grown to more than the %zu nodes that there is room for",
                             cracks->node_capacity);
    set_rows(state);
    return MPM_OK;
}

/* ----------------------------------------------------------------- stencils */

static inline int64_t diverted(const struct mpm_state *state, int64_t offset, uint32_t side)
{
    const struct mpm_crack_node *const node = mpm_crack_node_at(state, state->node_zero + offset);
    return node->field[side] - state->node_zero;
}

void mpm_crack_divert(const struct mpm_state *state, uint32_t code, struct mpm_stencil *stencil)
{
    const bool hides = state->scene->crack_method == MPM_CRACKS_VISIBILITY;
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

void mpm_crack_divert_edge(const struct mpm_state *state, size_t p,
                           struct mpm_edge_weights *weights)
{
    struct mpm_stencil plain;
    const uint32_t code = state->cracks.code[p];
    if (code == 0)
        return;
    state->cracks.code[p] = 0; /* its nodes as they are */
    mpm_particle_stencil(state, p, &plain);
    state->cracks.code[p] = code;
    for (int i = 0; i < weights->count; i++)
        for (int k = 0; k < plain.count; k++)
            if (plain.node[k].node == weights->entry[i].node && (code >> 2 * k & 3u) != 0) {
                weights->entry[i].node = diverted(state, plain.node[k].node, code >> 2 * k & 3u);
                break;
            }
}
