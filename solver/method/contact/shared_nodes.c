/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/shared_nodes.h"

#include "method/grid/conditions.h"
#include "method/grid/grid_update.h"

/* ------------------------------------------------------------------- memory */

static bool needs_planes(const struct mpm_contact_spec *spec)
{
    for (size_t k = 0; k < spec->pair_count; k++)
        if (spec->pairs[k].normal == MPM_NORMAL_LOGISTIC)
            return true;
    return false;
}

void mpm_shared_nodes_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_body_contact *const contact = &state->contact;
    const struct mpm_contact_spec *const spec = mpm_contact_spec(state);
    const size_t all = (size_t)mpm_layer_size(state);
    if (spec->field_count == 0)
        return;
    /* lines of contact, four nodes wide, across the grid */
    const size_t lines = 16 * spec->field_count * (size_t)(state->grid.columns + state->grid.rows);
    contact->node_capacity = lines < all ? lines : all;
    const size_t cut = (size_t)state->fields.keys * state->fields.node_capacity;
    contact->field_capacity = 3 * contact->node_capacity + cut;
    contact->pair_capacity = 3 * contact->node_capacity + spec->field_count * cut;
    contact->nodes = MPM_TAKE(arena, struct mpm_contact_node, contact->node_capacity);
    contact->fields = MPM_TAKE(arena, struct mpm_contact_field, contact->field_capacity);
    contact->pairs = MPM_TAKE(arena, struct mpm_contact_pair, contact->pair_capacity);
    if (needs_planes(spec))
        contact->planes = MPM_TAKE(arena, struct mpm_logistic_plane, contact->pair_capacity);
    contact->node_of = MPM_TAKE(arena, uint32_t, all);
    contact->beside = mpm_bands_layout(state, arena);
    if (spec->field_count > spec->deformable_fields) {
        contact->rigid_at = MPM_TAKE(arena, uint8_t, all);
        contact->rigid_in = mpm_bands_layout(state, arena);
    }
}

/* ------------------------------------------------------------------ finding */

static enum mpm_status no_room(const struct mpm_state *state, struct mpm_error *error)
{
    return mpm_error_fail(
        error, MPM_CAUSE_CONTACT,
        "more nodes shared by bodies than there is room for: %zu nodes, %zu fields, "
        "%zu pairs",
        state->contact.node_capacity, state->contact.field_capacity, state->contact.pair_capacity);
}

/* Each side of a crack has a pair with each field of another body. */
static bool add_pairs_of(struct mpm_body_contact *contact, const struct mpm_contact_spec *spec,
                         uint32_t index, struct mpm_contact_node *node)
{
    const size_t *const of = spec->pairs[index].of;
    const uint32_t end = node->first_field + node->fields;
    for (uint32_t i = node->first_field; i < end; i++)
        for (uint32_t j = node->first_field; j < end && contact->fields[i].field == of[0]; j++) {
            if (contact->fields[j].field != of[1])
                continue;
            if (contact->pair_count == contact->pair_capacity)
                return false;
            contact->pairs[contact->pair_count++] = (struct mpm_contact_pair){
                .fields = {i, j},
                .spec = index,
                .of = {contact->fields[i].field, contact->fields[j].field},
                .keys = {contact->fields[i].key, contact->fields[j].key}};
            node->pairs++;
        }
    return true;
}

/* The pairs of the scene between fields that are at the node. */
static bool add_pairs(struct mpm_body_contact *contact, const struct mpm_contact_spec *spec,
                      struct mpm_contact_node *node)
{
    for (uint32_t k = 0; k < spec->pair_count; k++)
        if (!add_pairs_of(contact, spec, k, node))
            return false;
    return true;
}

static bool add_field(struct mpm_body_contact *contact, int64_t at, size_t field, int key,
                      struct mpm_contact_node *node)
{
    if (contact->field_count == contact->field_capacity)
        return false;
    contact->fields[contact->field_count++] =
        (struct mpm_contact_field){.node = at, .field = (uint8_t)field, .key = (uint8_t)key};
    node->fields++;
    return true;
}

/* The sides of a crack that have mass at a node. */
static bool add_sides(struct mpm_state *state, size_t field, struct mpm_contact_node *node)
{
    const struct mpm_field_node *const cut = mpm_field_node_at(state, node->node);
    for (int i = 0; cut != NULL && i < cut->count; i++) {
        const int64_t at = mpm_fields_first(state) + cut->first + i;
        if (state->grid.mass[at] != 0.0 &&
            !add_field(&state->contact, at, field, state->fields.list[cut->first + (uint32_t)i].key,
                       node))
            return false;
        node->cut = true;
    }
    return true;
}

/* A field at the node, which may be in parts. */
static bool add_fields(struct mpm_state *state, size_t field, struct mpm_contact_node *node)
{
    struct mpm_body_contact *const contact = &state->contact;
    const int64_t own = node->node + contact->shift[field];
    if (field >= mpm_contact_spec(state)->deformable_fields)
        return add_field(contact, -1, field, 0, node);
    if (state->grid.mass[own] != 0.0 && !add_field(contact, own, field, 0, node))
        return false;
    return field != mpm_contact_spec(state)->cracked_field || add_sides(state, field, node);
}

static bool add_node(struct mpm_state *state, int64_t node, unsigned mask)
{
    struct mpm_body_contact *const contact = &state->contact;
    const struct mpm_contact_spec *const spec = mpm_contact_spec(state);
    struct mpm_contact_node made = {.node = node,
                                    .first_field = (uint32_t)contact->field_count,
                                    .first_pair = (uint32_t)contact->pair_count};
    for (size_t k = 0; k < spec->field_count; k++) {
        if ((mask >> k & 1u) != 0 && !add_fields(state, k, &made))
            return false;
    }
    if (!add_pairs(contact, spec, &made))
        return false;
    if (made.pairs == 0) { /* of two rigid bodies */
        contact->field_count = made.first_field;
        return true;
    }
    if (contact->node_count == contact->node_capacity)
        return false;
    contact->nodes[contact->node_count++] = made;
    contact->node_of[node] = (uint32_t)contact->node_count;
    return true;
}

/* The cells that the node is a corner of. */
static void mark_cells(struct mpm_bands *beside, int64_t column, int64_t row)
{
    for (int64_t k = row > 0 ? row - 1 : 0; k <= row; k++) {
        mpm_bands_mark(beside, column > 0 ? column - 1 : 0, k);
        mpm_bands_mark(beside, column, k);
    }
}

/* What the step before marked. */
static void forget_rigid(struct mpm_state *state)
{
    struct mpm_body_contact *const contact = &state->contact;
    for (int64_t row = 0; row < state->grid.rows; row++)
        for (int64_t column = contact->rigid_in.low[row]; column <= contact->rigid_in.high[row];
             column++)
            contact->rigid_at[row * state->grid.columns + column] = 0;
    mpm_bands_clear(state, &contact->rigid_in);
}

static void mark_rigid(struct mpm_state *state)
{
    struct mpm_body_contact *const contact = &state->contact;
    if (contact->rigid_at != NULL)
        forget_rigid(state);
    for (size_t p = 0; contact->rigid_at != NULL && p < state->rigid.count; p++) {
        const unsigned field = contact->field_of[state->rigid.body[p]];
        struct mpm_stencil stencil;
        if (field == MPM_CONTACT_FIELDS)
            continue;
        mpm_rigid_particle_stencil(state, p, &stencil);
        for (int k = 0; k < stencil.count; k++) {
            const int64_t node = state->node_zero + stencil.node[k].node;
            if (stencil.node[k].s == 0.0)
                continue;
            contact->rigid_at[node] |= (uint8_t)(1u << field);
            mpm_bands_mark(&contact->rigid_in, node % state->grid.columns,
                           node / state->grid.columns);
        }
    }
}

/* Has a side of a crack mass there? */
static bool has_sides(const struct mpm_state *state, int64_t node)
{
    const struct mpm_field_node *const cut = mpm_field_node_at(state, node);
    bool any = false;
    for (int i = 0; cut != NULL && i < cut->count; i++)
        any = any || state->grid.mass[mpm_fields_first(state) + cut->first + i] != 0.0;
    return any;
}

static unsigned fields_at(const struct mpm_state *state, int64_t node)
{
    const struct mpm_body_contact *const contact = &state->contact;
    const size_t deformable = mpm_contact_spec(state)->deformable_fields;
    unsigned mask = contact->rigid_at == NULL ? 0u : contact->rigid_at[node];
    for (size_t k = 0; k < deformable; k++)
        mask |= (unsigned)(state->grid.mass[node + contact->shift[k]] != 0.0) << k;
    if (mpm_contact_spec(state)->cracked_field != MPM_NO_FIELD)
        mask |= (unsigned)has_sides(state, node) << mpm_contact_spec(state)->cracked_field;
    return mask;
}

/* The active columns of a row of the grid or of a layer become those between which some have mass:
 * nothing is to be done for the others. */
static void narrow(struct mpm_state *state, int64_t row)
{
    const double *const mass = state->grid.mass + row * state->grid.columns;
    int64_t low = state->row_low[row], high = state->row_high[row];
    while (low <= high && mass[low] == 0.0)
        low++;
    while (high > low && mass[high] == 0.0)
        high--;
    state->row_low[row] = low <= high ? low : state->grid.columns;
    state->row_high[row] = low <= high ? high : -1;
}

/* From the second of the columns where fields begin to the last but one of those where they end:
 * what is outside has one field at the most. */
struct overlap {
    int64_t first[2], end[2];
};

static void add_span(struct overlap *overlap, const struct mpm_row_span *span)
{
    if (span->first >= span->end)
        return;
    const bool begins = span->first<overlap->first[0], ends = span->end> overlap->end[0];
    overlap->first[1] = begins                            ? overlap->first[0]
                        : span->first < overlap->first[1] ? span->first
                                                          : overlap->first[1];
    overlap->end[1] = ends                          ? overlap->end[0]
                      : span->end > overlap->end[1] ? span->end
                                                    : overlap->end[1];
    overlap->first[0] = begins ? span->first : overlap->first[0];
    overlap->end[0] = ends ? span->end : overlap->end[0];
}

/* The columns of a row where several fields may be: those of layers and of rigid bodies. Fields of
 * cracks count with the grid's. */
static struct mpm_row_span shared_span(struct mpm_state *state, int64_t row)
{
    const struct mpm_body_contact *const contact = &state->contact;
    const int64_t columns = state->grid.columns;
    const bool cut = mpm_contact_spec(state)->cracked_field != MPM_NO_FIELD;
    struct overlap overlap = {{columns, columns}, {0, 0}};
    for (int64_t layer = 0; layer <= state->fields.layers; layer++) {
        const int64_t place = row + layer * state->grid.rows;
        if (layer > 0 || !cut)
            narrow(state, place);
        const struct mpm_row_span span = {state->row_low[place], state->row_high[place] + 1};
        add_span(&overlap, &span);
    }
    for (int k = 0; k < 2 && contact->rigid_at != NULL; k++) { /* of several bodies, perhaps */
        const struct mpm_row_span span = {contact->rigid_in.low[row],
                                          contact->rigid_in.high[row] + 1};
        add_span(&overlap, &span);
    }
    const int64_t low = state->fields.reached.low[row], end = state->fields.reached.high[row] + 1;
    return (struct mpm_row_span){overlap.first[1] > low ? overlap.first[1] : low,
                                 overlap.end[1] < end ? overlap.end[1] : end};
}

enum mpm_status mpm_shared_nodes_find(struct mpm_state *state, struct mpm_error *error)
{
    struct mpm_body_contact *const contact = &state->contact;
    for (size_t k = 0; k < contact->node_count; k++)
        contact->node_of[contact->nodes[k].node] = 0;
    contact->node_count = contact->field_count = contact->pair_count = 0;
    mpm_bands_clear(state, &contact->beside);
    mark_rigid(state);
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        const struct mpm_row_span near = shared_span(state, row);
        for (int64_t column = near.first; column < near.end; column++) {
            const int64_t node = row * state->grid.columns + column;
            const unsigned mask = fields_at(state, node);
            if ((mask & (mask - 1u)) == 0)
                continue;
            if (!add_node(state, node, mask))
                return no_room(state, error);
            if (contact->node_of[node] != 0)
                mark_cells(&contact->beside, column, row);
        }
    }
    return MPM_OK;
}
