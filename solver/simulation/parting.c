/* Particles that part: neighbours of the undeformed body of which no node is reached by both. The
 * body is no body there any more, though no law has let it break: numerical fracture.
 *
 * Neighbours are those of the rows and columns in which a body is filled. Scenes with cracks have
 * no such pairs: a crack that opens parts neighbours too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/transfer.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdlib.h>

/* A place among the rows and columns of a body. */
struct place {
    uint32_t body, id;
    int64_t row, column;
};

bool mpm_scene_counts_parted(const struct mpm_scene *scene)
{
    return mpm_scene_is_plastic(scene) && scene->crack_count == 0;
}

void mpm_parting_layout(struct mpm_simulation *simulation, size_t count, struct mpm_arena *arena)
{
    struct mpm_parting *const parting = &simulation->parting;
    if (!mpm_scene_counts_parted(simulation->scene))
        return;
    parting->pairs = mpm_arena_take(arena, 2 * count, sizeof *parting->pairs);
    parting->box = mpm_arena_take(arena, count, sizeof *parting->box);
}

/* By body, row and column. */
static int compare(const void *left, const void *right)
{
    const struct place *const a = left, *const b = right;
    if (a->body != b->body)
        return a->body < b->body ? -1 : 1;
    if (a->row != b->row)
        return a->row < b->row ? -1 : 1;
    return (a->column > b->column) - (a->column < b->column);
}

static struct place place_of(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    const double *const half = state->bodies[particles->body[p]].half_size;
    const double *const origin = state->scene->origin;
    return (struct place){
        .body = particles->body[p],
        .id = particles->id[p],
        .row = (int64_t)floor((particles->position[1][p] - origin[1]) / (2.0 * half[1])),
        .column = (int64_t)floor((particles->position[0][p] - origin[0]) / (2.0 * half[0])),
    };
}

static void add_pair(struct mpm_parting *parting, const struct place *list, size_t count,
                     const struct place *one, int64_t row, int64_t column)
{
    const struct place key = {one->body, 0, one->row + row, one->column + column};
    const struct place *const other = bsearch(&key, list, count, sizeof key, compare);
    if (other == NULL)
        return;
    parting->pairs[parting->count][0] = one->id;
    parting->pairs[parting->count][1] = other->id;
    parting->count++;
}

enum mpm_status mpm_parting_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    const size_t count = state->particles.count;
    if (!mpm_scene_counts_parted(simulation->scene))
        return MPM_OK;
    struct place *const list = malloc((count + 1) * sizeof *list);
    if (list == NULL)
        return mpm_error_memory(error, count * sizeof *list, "pairs of neighbours");
    for (size_t p = 0; p < count; p++)
        list[p] = place_of(state, p);
    qsort(list, count, sizeof *list, compare);
    for (size_t k = 0; k < count; k++) {
        add_pair(&simulation->parting, list, count, &list[k], 0, 1);
        add_pair(&simulation->parting, list, count, &list[k], 1, 0);
    }
    free(list);
    return MPM_OK;
}

/* The rows and columns of nodes that the particle reaches: first and last. */
static void find_box(const struct mpm_state *state, size_t p, int32_t box[4])
{
    struct mpm_stencil stencil;
    mpm_particle_plain_stencil(state, p, &stencil);
    box[0] = box[2] = INT32_MAX;
    box[1] = box[3] = INT32_MIN;
    for (int k = 0; k < stencil.count; k++) {
        const int64_t node = state->node_zero + stencil.node[k].node;
        const int32_t place[2] = {(int32_t)(node % state->grid.columns),
                                  (int32_t)(node / state->grid.columns)};
        for (int axis = 0; axis < 2; axis++) {
            int32_t *const range = &box[2 * axis];
            range[0] = place[axis] < range[0] ? place[axis] : range[0];
            range[1] = place[axis] > range[1] ? place[axis] : range[1];
        }
    }
}

static bool meet(const int32_t a[4], const int32_t b[4])
{
    return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3];
}

uint64_t mpm_parting_count(const struct mpm_simulation *simulation)
{
    const struct mpm_parting *const parting = &simulation->parting;
    const struct mpm_state *const state = &simulation->state;
    uint64_t parted = 0;
    for (size_t p = 0; parting->count > 0 && p < state->particles.count; p++)
        find_box(state, p, parting->box[state->particles.id[p]]);
    for (size_t k = 0; k < parting->count; k++)
        parted += !meet(parting->box[parting->pairs[k][0]], parting->box[parting->pairs[k][1]]);
    return parted;
}
