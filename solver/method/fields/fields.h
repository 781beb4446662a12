/* Additional velocity fields of nodes, whatever they are for.
 *
 * Ordinarily particles share one velocity field: a node has one mass, momentum and force. A client
 * (cracks: CRAMP, section 2.1; contact between bodies: N&G 3.3) may give some particles
 * a field of their own. An additional field is a further node: it has the place and the weights of
 * its parent node, a node of the grid, and memory of its own in rows behind those of the grid.
 * Whatever works on stencils or on rows of nodes works on it without knowing:
 *
 *     rows   0 .. rows - 1                    the grid: every node's own field
 *            rows .. rows (1 + layers) - 1    layers: each a whole copy of the grid
 *            from there on                    packed fields, of the nodes that need them
 *
 *            grid                     layer 1                 packed
 *            . . . . . .              . . . . . .             a b a b b a
 *            . . P . . .   parent P   . . P'. . .   layers    b a . . . .   a, b: fields with the
 *            . . . . . .              . . . . . .                           keys a and b
 *
 * There are two ways to have one:
 *
 * Layers, for a body that moves in a field of its own everywhere. mpm_fields_claim_layers makes
 * room, mpm_body's `layer` is the one it moves in, 0 the grid itself: mpm_layer_shift is the
 * distance from a node to its copy. Both sets of kernels spread to the layer and read from it: fast
 * kernels stay fast. The active nodes of a layer, and of the grid, are those that particles of its
 * own bodies reach (grid/active_nodes.h), or fewer, where its client has found the others without
 * mass; conditions, mirrors and planes of symmetry treat its nodes as their parents. Packed fields
 * are not for particles of such a body: bodies with cracks stay in the grid.
 *
 * Keys, for particles that leave their node's own field here and there. A key is the owner: the
 * side of a crack, or a body, or a material; cracks have the first two. In each step a client looks
 * at particles by strips, in their order (mpm_strips_run), and names keys for nodes of their plain
 * stencils (mpm_field_ask), and keeps those that have some (mpm_field_keep); has rows made for them
 * (mpm_fields_settle), which puts the fields into the stencils that mpm_particle_stencil returns in
 * this step. Fast kernels take listed particles in spans of a strip, with copies of their nodes
 * (fast_patches.h). A particle has one field at a node: clients that meet at one node treat a
 * particle together, and a pair of their keys is a key of its own. Limits: MPM_FIELD_KEYS keys in a
 * scene, as many additional fields of a node, and the capacities of mpm_fields. A client that has
 * more to keep for a field has an array of its own, by the field's place in `list`
 * (crack_fields.h).
 *
 * A new client claims its keys or layers when the simulation is created, and requests fields in
 * `begin` of step.c; passes, loads, conditions and sums over nodes stay as they are. Fields
 * exchange momentum by mpm_exchange (contact/exchange.h), which knows two fields, a normal and a
 * law. tests/solver/method/test_fields.c has such clients: bodies that pass through each other.
 *
 * Scenes without clients run none of this and have no memory for it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FIELDS_H
#define MPM_METHOD_FIELDS_H

#include "base/arena.h"
#include "method/state.h"

/* ------------------------------------------------------------------ creating */

/* Claims `keys` more keys, for fields of up to `nodes` more nodes. Returns the first of them.
 * Before the grid's memory is taken. */
int mpm_fields_claim(struct mpm_state *state, int keys, size_t nodes);
/* Claims so many more layers. Returns the first of them, from 1 on. */
int64_t mpm_fields_claim_layers(struct mpm_state *state, int64_t layers);
/* Takes the memory of claimed keys, for fields.use_capacity particles. */
void mpm_fields_layout(struct mpm_state *state, struct mpm_arena *arena);

/* ------------------------------------------------------------------ a step */

/* Forgets the fields of the last step. After mpm_grid_find_active. */
void mpm_fields_begin(struct mpm_state *state);

/* Requests the field of `key` at node k of a particle's plain stencil, which is at that column and
 * row. Strips of one colour have no row of nodes in common: one worker sets the bits of a node. */
void mpm_field_ask(const struct mpm_state *state, struct mpm_field_use *use, int k,
                   const int64_t place[2], int key);

/* Requests it at a node of the grid for no particle: of one worker, once the particles are listed.
 */
void mpm_field_ask_at(struct mpm_state *state, int64_t node, int key);

/* Lists a particle of the strip for which fields were requested, in ascending order within the
 * strip. Returns its place in `uses`, or SIZE_MAX: there is no room, which mpm_fields_settle
 * reports. Places depend on which strip is first; what is found there does not. */
size_t mpm_field_keep(struct mpm_state *state, int64_t strip, const struct mpm_field_use *use);

/* What the step's fields have no room for. */
enum mpm_fields_lack { MPM_FIELDS_LACK_NOTHING, MPM_FIELDS_LACK_USES, MPM_FIELDS_LACK_NODES };

/* Lists the nodes that have several fields and gives these their rows; puts them into the stencils
 * that are listed. If there is no room all requests are dropped. */
enum mpm_fields_lack mpm_fields_settle(struct mpm_state *state);

/* Puts the particle's fields into the nodes of one of its edges, `plain` being its plain stencil.
 */
void mpm_fields_divert_edge(const struct mpm_state *state, size_t p,
                            const struct mpm_stencil *plain, struct mpm_edge_weights *weights);

/* ------------------------------------------------------------------ looking */

/* Nodes of the grid, and of each layer. */
static inline int64_t mpm_layer_size(const struct mpm_state *state)
{
    return state->grid.columns * state->grid.rows;
}

/* From a node of the grid to its copy. */
static inline int64_t mpm_layer_shift(const struct mpm_state *state, int64_t layer)
{
    return layer * mpm_layer_size(state);
}

/* The first packed field; behind all nodes that have a place in the grid or in a layer. */
static inline int64_t mpm_fields_first(const struct mpm_state *state)
{
    return mpm_layer_shift(state, 1 + state->fields.layers);
}

/* The node of the grid that a node is, or is a field of. */
static inline int64_t mpm_field_parent(const struct mpm_state *state, int64_t node)
{
    if (node < mpm_layer_size(state))
        return node;
    const int64_t first = mpm_fields_first(state);
    return node < first ? node % mpm_layer_size(state)
                        : state->fields.nodes[state->fields.list[node - first].node].node;
}

/* The entry of a node of the grid that has packed fields, or NULL. */
static inline struct mpm_field_node *mpm_field_node_at(const struct mpm_state *state, int64_t node)
{
    if (state->fields.node_of == NULL || state->fields.node_of[node] == 0)
        return NULL;
    return &state->fields.nodes[state->fields.node_of[node] - 1];
}

/* The field of a node with that key, or -1; key 0 is its own. */
static inline int64_t mpm_field_of(const struct mpm_state *state, const struct mpm_field_node *node,
                                   int key)
{
    const struct mpm_additional_field *const list = state->fields.list + node->first;
    if (key == 0)
        return node->node;
    for (int i = 0; i < node->count; i++)
        if (list[i].key == key)
            return mpm_fields_first(state) + node->first + i;
    return -1;
}

/* The entry of a particle with additional fields, or NULL. */
static inline struct mpm_field_use *mpm_field_use_of(const struct mpm_state *state, size_t p)
{
    if (state->fields.use_of == NULL || state->fields.use_of[p] == 0)
        return NULL;
    return &state->fields.uses[state->fields.use_of[p] - 1];
}

/* Where the step's spans of a strip are: those with listed particles, and with the
 * particles between them where those are fewer than MPM_FIELD_GAP. A span costs the fast kernels
 * some ten instructions a pass, a particle in it some hundred. */
enum { MPM_FIELD_GAP = 8 };
static inline struct mpm_span *mpm_field_spans(const struct mpm_state *state, int64_t strip)
{
    return state->fields.spans + strip + state->strips[strip].begin / MPM_FIELD_GAP;
}

/* ------------------------------------------------------------------ bands */

static inline void mpm_bands_mark(struct mpm_bands *bands, int64_t column, int64_t row)
{
    bands->low[row] = column < bands->low[row] ? column : bands->low[row];
    bands->high[row] = column > bands->high[row] ? column : bands->high[row];
}
void mpm_bands_clear(const struct mpm_state *state, struct mpm_bands *bands);
/* Takes the memory of bands over the grid's rows. */
struct mpm_bands mpm_bands_layout(const struct mpm_state *state, struct mpm_arena *arena);

#endif
