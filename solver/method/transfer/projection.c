/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/projection.h"

#include "base/strips.h"
#include "method/transfer/transfer.h"

void mpm_projection_run(struct mpm_state *state, int workers,
                        const struct mpm_projection *projection)
{
    state->projection = *projection;
    mpm_strips_run(state->strip_count, workers, state->kernels.passes->project, state);
}

static void gather(const struct mpm_state *state, const struct mpm_stencil *stencil,
                   double value[MPM_NODE_VALUES])
{
    const struct mpm_projection *const projection = &state->projection;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        for (size_t i = 0; i < projection->components; i++)
            value[i] += stencil->node[k].s * projection->from[MPM_NODE_VALUES * node + (int64_t)i];
    }
}

static void spread(const struct mpm_state *state, const struct mpm_stencil *stencil,
                   const double value[MPM_NODE_VALUES])
{
    const struct mpm_projection *const projection = &state->projection;
    const int64_t distance = projection->pairs ? 2 : 1;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        for (size_t i = 0; i < projection->components; i++)
            projection->to[MPM_NODE_VALUES * node + distance * (int64_t)i] +=
                value[i] * stencil->node[k].s;
    }
}

void mpm_pass_project(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_projection *const projection = &state->projection;
    const struct mpm_strip *const strip = &state->strips[index];
    const bool filters = projection->from != NULL && projection->to != NULL;
    double *array[MPM_NODE_VALUES] = {NULL};
    (void)worker;
    for (size_t i = 0; i < projection->components && !filters; i++)
        array[i] = mpm_particle_array(&state->particles, projection->field, i);
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        double value[MPM_NODE_VALUES] = {0.0};
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        if (projection->from != NULL)
            gather(state, stencil, value);
        for (size_t i = 0; projection->from == NULL && i < projection->components; i++)
            value[i] = array[i][p];
        for (size_t i = 0; projection->to != NULL && i < projection->components; i++)
            value[i] *= state->particles.mass[p];
        if (projection->to != NULL)
            spread(state, stencil, value);
        for (size_t i = 0; projection->to == NULL && i < projection->components; i++)
            array[i][p] = value[i];
    }
}
