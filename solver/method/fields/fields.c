/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fields/fields.h"

#include <assert.h>
#include <string.h>

_Static_assert(4 * MPM_STENCIL_MAX <= 64, "a particle's keys are four bits a node");
_Static_assert(MPM_FIELD_KEYS < 16, "a key has four bits, and a bit of `asked`");

/* -------------------------------------------------------------------- bands */

struct mpm_bands mpm_bands_layout(const struct mpm_state *state, struct mpm_arena *arena)
{
    const size_t rows = (size_t)state->grid.rows;
    int64_t *const low = MPM_TAKE(arena, int64_t, rows);
    int64_t *const high = MPM_TAKE(arena, int64_t, rows);
    return (struct mpm_bands){low, high};
}

void mpm_bands_clear(const struct mpm_state *state, struct mpm_bands *bands)
{
    for (int64_t row = 0; row < state->grid.rows; row++) {
        bands->low[row] = state->grid.columns;
        bands->high[row] = -1;
    }
}

/* ----------------------------------------------------------------- creating */

static void make_room(struct mpm_state *state)
{
    const struct mpm_fields *const fields = &state->fields;
    const int64_t columns = state->grid.columns;
    const int64_t packed = fields->keys * (int64_t)fields->node_capacity;
    state->grid.field_rows = fields->layers * state->grid.rows + (packed + columns - 1) / columns;
}

int mpm_fields_claim(struct mpm_state *state, int keys, size_t nodes)
{
    struct mpm_fields *const fields = &state->fields;
    const int first = fields->keys + 1;
    fields->keys += keys;
    fields->node_capacity += nodes;
    assert(fields->keys <= MPM_FIELD_KEYS);
    make_room(state);
    return first;
}

int64_t mpm_fields_claim_layers(struct mpm_state *state, int64_t layers)
{
    const int64_t first = state->fields.layers + 1;
    state->fields.layers += layers;
    assert(state->fields.layers < MPM_LAYERS);
    make_room(state);
    return first;
}

static void layout_layers(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_fields *const fields = &state->fields;
    const size_t layers = 1 + (size_t)fields->layers, rows = layers * (size_t)state->grid.rows;
    fields->reached = (struct mpm_bands){state->row_low, state->row_high};
    if (layers == 1)
        return;
    fields->boxes = MPM_TAKE(arena, struct mpm_node_box, layers * (size_t)state->strip_count);
    fields->reached = mpm_bands_layout(state, arena);
    fields->before.low = MPM_TAKE(arena, int64_t, rows);
    fields->before.high = MPM_TAKE(arena, int64_t, rows);
}

void mpm_fields_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_fields *const fields = &state->fields;
    const size_t nodes = (size_t)mpm_layer_size(state);
    layout_layers(state, arena);
    if (fields->keys == 0)
        return;
    fields->uses = MPM_TAKE(arena, struct mpm_field_use, fields->use_capacity);
    fields->use_of = MPM_TAKE(arena, uint32_t, state->particles.count);
    fields->spans =
        MPM_TAKE(arena, struct mpm_span,
                 state->particles.count / MPM_FIELD_GAP + (size_t)state->strip_count + 1);
    fields->asked = MPM_TAKE(arena, uint16_t, nodes);
    fields->asked_at = mpm_bands_layout(state, arena);
    fields->beside = mpm_bands_layout(state, arena);
    fields->node_of = MPM_TAKE(arena, uint32_t, nodes);
    fields->nodes = MPM_TAKE(arena, struct mpm_field_node, fields->node_capacity);
    fields->list =
        MPM_TAKE(arena, struct mpm_additional_field, (size_t)fields->keys * fields->node_capacity);
}

/* ---------------------------------------------------------------- beginning */

static size_t uses_listed(const struct mpm_fields *fields)
{
    return fields->use_count < fields->use_capacity ? fields->use_count : fields->use_capacity;
}

void mpm_fields_begin(struct mpm_state *state)
{
    struct mpm_fields *const fields = &state->fields;
    const size_t uses = uses_listed(fields);
    fields->rows = fields->layers * state->grid.rows;
    if (fields->keys == 0)
        return;
    for (size_t k = 0; k < fields->node_count; k++)
        fields->node_of[fields->nodes[k].node] = 0;
    for (size_t k = 0; k < uses; k++)
        fields->use_of[fields->uses[k].particle] = 0;
    for (int64_t s = 0; s < state->strip_count; s++)
        state->strips[s].span_count = 0;
    fields->node_count = fields->nodes_inside = 0;
    fields->count = fields->inside = 0;
    fields->use_count = 0;
    mpm_bands_clear(state, &fields->asked_at);
    mpm_bands_clear(state, &fields->beside);
}

/* ----------------------------------------------------------------- requests */

void mpm_field_ask(const struct mpm_state *state, struct mpm_field_use *use, int k,
                   const int64_t place[2], int key)
{
    const struct mpm_fields *const fields = &state->fields;
    struct mpm_bands asked_at = fields->asked_at;
    assert(key > 0 && key <= fields->keys);
    use->keys |= (uint64_t)key << (4 * k);
    fields->asked[place[1] * state->grid.columns + place[0]] |= (uint16_t)(1u << key);
    mpm_bands_mark(&asked_at, place[0], place[1]);
}

void mpm_field_ask_at(struct mpm_state *state, int64_t node, int key)
{
    state->fields.asked[node] |= (uint16_t)(1u << key);
    mpm_bands_mark(&state->fields.asked_at, node % state->grid.columns, node / state->grid.columns);
}

static void add_to_spans(const struct mpm_state *state, int64_t index, size_t p)
{
    struct mpm_strip *const strip = &state->strips[index];
    struct mpm_span *const spans = mpm_field_spans(state, index);
    if (strip->span_count > 0 && p - spans[strip->span_count - 1].end < MPM_FIELD_GAP)
        spans[strip->span_count - 1].end = p + 1;
    else
        spans[strip->span_count++] = (struct mpm_span){p, p + 1};
}

size_t mpm_field_keep(struct mpm_state *state, int64_t strip, const struct mpm_field_use *use)
{
    struct mpm_fields *const fields = &state->fields;
    const size_t place = atomic_fetch_add_explicit(&fields->use_count, 1, memory_order_relaxed);
    if (place >= fields->use_capacity)
        return SIZE_MAX;
    struct mpm_field_use *const listed = &fields->uses[place];
    listed->particle = use->particle;
    listed->keys = use->keys;
    listed->stencil.count = use->stencil.count;
    memcpy(listed->stencil.node, use->stencil.node,
           (size_t)use->stencil.count * sizeof *use->stencil.node);
    fields->use_of[use->particle] = (uint32_t)place + 1;
    add_to_spans(state, strip, use->particle);
    return place;
}

/* ----------------------------------------------------------------- settling */

/* The cells that the node is a corner of: blocks of particles that reach it have one of them. */
static void mark_cells(struct mpm_state *state, int64_t column, int64_t row)
{
    for (int64_t k = row > 0 ? row - 1 : 0; k <= row; k++) {
        mpm_bands_mark(&state->fields.beside, column > 0 ? column - 1 : 0, k);
        mpm_bands_mark(&state->fields.beside, column, k);
    }
}

static bool add_node(struct mpm_state *state, int64_t node)
{
    struct mpm_fields *const fields = &state->fields;
    struct mpm_field_node made = {.node = node, .first = (uint32_t)fields->count};
    mpm_grid_position(&state->grid, node, made.position);
    if (fields->node_count == fields->node_capacity)
        return false;
    for (int key = 1; key <= fields->keys; key++)
        if ((fields->asked[node] & (1u << key)) != 0) {
            fields->list[fields->count++] = (struct mpm_additional_field){
                .node = (uint32_t)fields->node_count, .key = (uint8_t)key};
            made.count++;
        }
    fields->nodes[fields->node_count++] = made;
    fields->node_of[node] = (uint32_t)fields->node_count;
    return true;
}

/* In the order of the grid; images are those beyond planes of symmetry that a crack passes. */
static bool list_nodes(struct mpm_state *state, bool images)
{
    const struct mpm_fields *const fields = &state->fields;
    for (int64_t row = 0; row < state->grid.rows; row++)
        for (int64_t column = fields->asked_at.low[row]; column <= fields->asked_at.high[row];
             column++) {
            const int64_t node = row * state->grid.columns + column;
            const int64_t place[2] = {column, row};
            if (fields->asked[node] == 0 ||
                (state->symmetries.passed &&
                 mpm_symmetries_have_beyond(&state->symmetries, place) != images))
                continue;
            if (!add_node(state, node))
                return false;
            mark_cells(state, column, row);
            fields->asked[node] = 0;
        }
    return true;
}

static void set_rows(struct mpm_state *state)
{
    struct mpm_fields *const fields = &state->fields;
    const int64_t columns = state->grid.columns;
    const int64_t rows = (fields->count + columns - 1) / columns;
    const int64_t first = (1 + fields->layers) * state->grid.rows;
    for (int64_t k = 0; k < rows; k++) {
        const int64_t left = fields->count - k * columns;
        state->row_low[first + k] = 0;
        state->row_high[first + k] = (left < columns ? left : columns) - 1;
    }
    fields->rows += rows;
}

/* The field of a key at a node of a plain stencil; such an offset again. */
static inline int64_t diverted(const struct mpm_state *state, int64_t offset, int key)
{
    const struct mpm_field_node *const node = mpm_field_node_at(state, state->node_zero + offset);
    return mpm_field_of(state, node, key) - state->node_zero;
}

static void divert(const struct mpm_state *state, struct mpm_field_use *use)
{
    const int64_t zero = state->node_zero;
    uint64_t keys = use->keys;
    use->detours = 0;
    use->first = -1;
    for (int k = 0; keys != 0; k++, keys >>= 4) {
        int64_t *const node = &use->stencil.node[k].node;
        if ((keys & 15u) == 0)
            continue;
        const int64_t field = diverted(state, *node, (int)(keys & 15u));
        use->detour[use->detours++] =
            (struct mpm_field_detour){(uint32_t)(zero + *node), (uint32_t)(zero + field)};
        *node = field;
    }
}

/* Requests of this step must not reach the next one. */
static enum mpm_fields_lack drop(struct mpm_state *state, enum mpm_fields_lack lack)
{
    memset(state->fields.asked, 0, (size_t)mpm_layer_size(state) * sizeof *state->fields.asked);
    return lack;
}

enum mpm_fields_lack mpm_fields_settle(struct mpm_state *state)
{
    struct mpm_fields *const fields = &state->fields;
    if (fields->use_count > fields->use_capacity)
        return drop(state, MPM_FIELDS_LACK_USES);
    if (!list_nodes(state, false))
        return drop(state, MPM_FIELDS_LACK_NODES);
    fields->nodes_inside = fields->node_count;
    fields->inside = fields->count;
    if (state->symmetries.passed && !list_nodes(state, true))
        return drop(state, MPM_FIELDS_LACK_NODES);
    set_rows(state);
    for (size_t k = 0; k < fields->use_count; k++)
        divert(state, &fields->uses[k]);
    return MPM_FIELDS_LACK_NOTHING;
}

/* -------------------------------------------------------------------- edges */

/* The plain stencil has the same nodes in the same order. */
void mpm_fields_divert_edge(const struct mpm_state *state, size_t p,
                            const struct mpm_stencil *plain, struct mpm_edge_weights *weights)
{
    const struct mpm_field_use *const use = mpm_field_use_of(state, p);
    if (use == NULL)
        return;
    for (int i = 0; i < weights->count; i++)
        for (int k = 0; k < plain->count; k++) {
            const int key = (int)(use->keys >> 4 * k & 15u);
            if (plain->node[k].node == weights->entry[i].node && key != 0) {
                weights->entry[i].node = diverted(state, plain->node[k].node, key);
                break;
            }
        }
}
