/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/crack_fields.h"

#include "base/strips.h"
#include "method/cracks/crack_map.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"

#include <string.h>

bool mpm_cracks_have_contact(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        if (mpm_crack_has_contact(scene, k))
            return true;
    return false;
}

bool mpm_cracks_have_conductance(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->crack_count; k++)
        for (size_t which = 0; which < MPM_SCALAR_COUNT; which++)
            if (scene->cracks[k].surfaces[which].law == MPM_SURFACE_CONDUCTANCE)
                return true;
    return false;
}

/* ------------------------------------------------------------ the particles */

/* What finding the fields of a particle works on. */
struct search {
    struct mpm_state *state;
    int64_t strip;
    bool segments; /* are crossed segments needed? For contact and conductance alone */
};

/* A particle with the segments that lines to nodes on another side cross. */
struct found {
    struct mpm_field_use use;
    struct mpm_crack_crossing crossing[MPM_STENCIL_MAX];
    bool contradicts; /* a line crosses two cracks */
};

/* Column and row of a node of the block, or near it: without a division. */
static void place_in_block(const struct mpm_state *state, const struct mpm_cell_block *block,
                           int64_t node, int64_t place[2])
{
    const int64_t columns = state->grid.columns;
    place[0] = node - block->low[1] * columns;
    place[1] = block->low[1];
    for (; place[0] >= columns; place[0] -= columns)
        place[1]++;
}

/* The particle's fields at its nodes as far as one crack has a say. */
static void add_sides(const struct search *search, const struct mpm_crack_site *site,
                      const struct mpm_cell_block *block, const double particle[2],
                      struct found *found)
{
    const struct mpm_state *const state = search->state;
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_crack_chain *const chain = &state->cracks.chains[site->crack];
    const double from = mpm_crack_part_distance(&site->part, particle);
    const uint64_t before = found->use.keys;
    for (int k = 0; k < found->use.stencil.count; k++) {
        int64_t at[2];
        place_in_block(state, block, state->node_zero + found->use.stencil.node[k].node, at);
        const double place[2] = {grid->origin[0] + grid->cell[0] * (double)(at[0] - MPM_GHOST_ROWS),
                                 grid->origin[1] +
                                     grid->cell[1] * (double)(at[1] - MPM_GHOST_ROWS)};
        size_t segment = 0;
        if (mpm_crack_part_is_beside(&site->part, from,
                                     mpm_crack_part_distance(&site->part, place)))
            continue;
        const enum mpm_crack_side side = mpm_crack_part_side(chain, &site->part, particle, place,
                                                             search->segments ? &segment : NULL);
        if (side == MPM_CRACK_SAME_SIDE)
            continue;
        if ((before >> 4 * k & 15u) != 0) {
            found->contradicts = true;
            continue;
        }
        found->crossing[k] = (struct mpm_crack_crossing){site->crack, (uint32_t)segment};
        mpm_field_ask(state, &found->use, k, at, (int)side);
    }
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

static void find_sides(void *context, size_t p, const struct mpm_cell_block *block)
{
    const struct search *const search = context;
    struct mpm_state *const state = search->state;
    const double particle[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    struct found found;
    if (!mpm_cracks_cut(state, p))
        return;
    found.use.particle = (uint32_t)p;
    found.use.keys = 0;
    found.use.stencil.count = 0;
    found.contradicts = false;
    for (uint32_t crack = 0; crack < state->scene->crack_count; crack++) {
        struct mpm_crack_site together;
        const struct mpm_crack_site *const site =
            mpm_crack_map_site(state, block, crack, &together);
        if (site == NULL || !may_pass(state, &site->part, block))
            continue;
        if (found.use.stencil.count == 0)
            mpm_particle_plain_stencil(state, p, &found.use.stencil);
        add_sides(search, site, block, particle, &found);
    }
    if (found.contradicts)
        mpm_strip_record(&state->strips[search->strip], MPM_TWO_CRACKS, state->particles.id[p], 0,
                         0.0);
    if (found.use.keys == 0)
        return;
    const size_t place = mpm_field_keep(state, search->strip, &found.use);
    if (place != SIZE_MAX)
        memcpy(state->cracks.crossings[place], found.crossing,
               (size_t)found.use.stencil.count * sizeof *found.crossing);
}

static void find_in_strip(void *context, int64_t index, int worker)
{
    struct search search = {.state = context, .strip = index};
    (void)worker;
    search.segments = mpm_cracks_have_contact(search.state->scene) ||
                      mpm_cracks_have_conductance(search.state->scene);
    mpm_nearby_visit(search.state, index, &search.state->cracks.map->listed, find_sides, &search);
}

/* --------------------------------------------------------------- the fields */

void mpm_crack_fields_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    const struct mpm_fields *const fields = &state->fields;
    struct mpm_cracks *const cracks = &state->cracks;
    cracks->crossings = mpm_arena_take(arena, fields->use_capacity, sizeof *cracks->crossings);
    cracks->sums = MPM_TAKE(arena, struct mpm_crack_sums, fields->node_capacity);
    cracks->fields =
        MPM_TAKE(arena, struct mpm_crack_field, (size_t)fields->keys * fields->node_capacity);
}

struct mpm_crack_node mpm_crack_node_of(const struct mpm_state *state, size_t place)
{
    const struct mpm_field_node *const node = &state->fields.nodes[place];
    struct mpm_crack_node made = {.field = {node->node, -1, -1},
                                  .held = {node->held, 0, 0},
                                  .sums = {&state->cracks.sums[place], NULL, NULL},
                                  .face = {NULL, NULL, NULL}};
    for (size_t i = node->first; i < (size_t)node->first + node->count; i++) {
        const struct mpm_additional_field *const field = &state->fields.list[i];
        made.field[field->key] = mpm_fields_first(state) + (int64_t)i;
        made.held[field->key] = field->held;
        made.sums[field->key] = &state->cracks.fields[i].sums;
        made.face[field->key] = &state->cracks.fields[i].face;
    }
    return made;
}

static void clear_fields(struct mpm_state *state)
{
    struct mpm_cracks *const cracks = &state->cracks;
    memset(cracks->sums, 0, state->fields.node_count * sizeof *cracks->sums);
    memset(cracks->fields, 0, (size_t)state->fields.count * sizeof *cracks->fields);
    for (int64_t k = 0; k < state->fields.count; k++)
        cracks->fields[k].face.crack = MPM_NO_CRACK;
}

/* Names the crack before each of the particle's additional fields. The first and the last one do
 * not depend on the order of the particles. The first point of a crack is on a plane of symmetry
 * only if all are. */
static void name_cracks(struct mpm_state *state, size_t place)
{
    const struct mpm_field_use *const use = &state->fields.uses[place];
    const int64_t first = mpm_fields_first(state) - state->node_zero;
    uint64_t keys = use->keys;
    for (int k = 0; keys != 0; k++, keys >>= 4) {
        if ((keys & 15u) == 0)
            continue;
        const int64_t field = use->stencil.node[k].node - first;
        const uint32_t crack = state->cracks.crossings[place][k].crack;
        struct mpm_crack_face *const face = &state->cracks.fields[field].face;
        face->last = face->crack == MPM_NO_CRACK || crack > face->last ? crack : face->last;
        face->crack = crack < face->crack ? crack : face->crack;
        state->fields.list[field].free |= state->cracks.held[mpm_crack_first_point(state, crack)];
        state->fields.list[field].passes |= state->cracks.passes[crack];
    }
}

/* A field of a node beyond a plane of symmetry that its crack passes is added to that of the node
 * inside, which must have one: a domain that is sheared may reach the one with a lower corner and
 * not the other. */
static void ask_originals(struct mpm_state *state, size_t place)
{
    const struct mpm_field_use *const use = &state->fields.uses[place];
    uint64_t keys = use->keys;
    for (int k = 0; keys != 0; k++, keys >>= 4) {
        double sign[2];
        const int64_t node = state->node_zero + use->stencil.node[k].node;
        if ((keys & 15u) == 0 || state->cracks.passes[state->cracks.crossings[place][k].crack] == 0)
            continue;
        const int64_t original = mpm_symmetry_original(state, node, sign);
        if (original != node && mpm_node_is_reached(state, original))
            mpm_field_ask_at(state, original, (int)(keys & 15u));
    }
}

/* Fields inside have the names of their images. */
static void name_original(struct mpm_state *state, int axis, const struct mpm_field_node *inside,
                          const struct mpm_field_node *beyond, const void *context)
{
    (void)context;
    for (size_t i = 0; beyond != NULL && i < beyond->count; i++) {
        const size_t from = beyond->first + i;
        const struct mpm_additional_field *const image = &state->fields.list[from];
        const int64_t field = mpm_field_of(state, inside, image->key) - mpm_fields_first(state);
        if ((image->passes >> axis & 1) == 0 || field < 0)
            continue;
        const struct mpm_crack_face *const other = &state->cracks.fields[from].face;
        struct mpm_crack_face *const face = &state->cracks.fields[field].face;
        face->last =
            face->crack == MPM_NO_CRACK || other->last > face->last ? other->last : face->last;
        face->crack = other->crack < face->crack ? other->crack : face->crack;
        state->fields.list[field].free |= image->free;
        state->fields.list[field].passes |= image->passes;
    }
}

/* Takes the nodes that the particle does not see out of its stencil. */
static void hide(struct mpm_field_use *use)
{
    struct mpm_stencil *const stencil = &use->stencil;
    uint64_t keys = use->keys;
    int count = 0;
    for (int k = 0; k < stencil->count; k++, keys >>= 4)
        if ((keys & 15u) == 0)
            stencil->node[count++] = stencil->node[k];
    stencil->count = count;
}

static enum mpm_status no_room(const char *what, size_t capacity, struct mpm_error *error)
{
    return mpm_error_fail(
        error, MPM_CAUSE_CRACK,
        "there are more %s near cracks than the %zu that there is room for: cracks "
        "have grown or stretched, or bodies are compressed there",
        what, capacity);
}

enum mpm_status mpm_cracks_find_fields(struct mpm_state *state, int workers,
                                       struct mpm_error *error)
{
    const struct mpm_fields *const fields = &state->fields;
    if (state->cracks.point_count == 0)
        return MPM_OK;
    if (!mpm_crack_map_draw(state))
        return no_room("cells", state->cracks.map->capacity, error);
    mpm_strips_run(state->strip_count, workers, find_in_strip, state);
    for (size_t k = 0; state->symmetries.passed && k < fields->use_count; k++)
        if (k < fields->use_capacity)
            ask_originals(state, k);
    const enum mpm_fields_lack lack = mpm_fields_settle(state);
    if (lack == MPM_FIELDS_LACK_USES)
        return no_room("particles", fields->use_capacity, error);
    if (lack == MPM_FIELDS_LACK_NODES)
        return no_room("nodes", fields->node_capacity, error);
    clear_fields(state);
    const size_t uses = fields->use_count;
    for (size_t k = 0; k < uses; k++) {
        name_cracks(state, k);
        if (state->scene->crack_method == MPM_CRACKS_VISIBILITY)
            hide(&fields->uses[k]);
    }
    mpm_symmetries_visit(state, name_original, NULL);
    return MPM_OK;
}
