/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/exchange.h"

#include "base/strips.h"
#include "method/transfer/transfer.h"

void mpm_exchange_run(struct mpm_state *state, int workers, const struct mpm_exchange *exchange)
{
    state->exchange = *exchange;
    mpm_strips_run(state->strip_count, workers, state->kernels.passes->exchange, state);
}

static void gather(const struct mpm_state *state, const struct mpm_stencil *stencil,
                   double value[MPM_NODE_VALUES])
{
    const struct mpm_exchange *const exchange = &state->exchange;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        for (size_t i = 0; i < exchange->components; i++)
            value[i] += stencil->node[k].s * exchange->from[MPM_NODE_VALUES * node + (int64_t)i];
    }
}

static void spread(const struct mpm_state *state, const struct mpm_stencil *stencil,
                   const double value[MPM_NODE_VALUES])
{
    const struct mpm_exchange *const exchange = &state->exchange;
    const int64_t distance = exchange->pairs ? 2 : 1;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        for (size_t i = 0; i < exchange->components; i++)
            exchange->to[MPM_NODE_VALUES * node + distance * (int64_t)i] +=
                value[i] * stencil->node[k].s;
    }
}

void mpm_pass_exchange(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_exchange *const exchange = &state->exchange;
    const struct mpm_strip *const strip = &state->strips[index];
    const bool filters = exchange->from != NULL && exchange->to != NULL;
    double *array[MPM_NODE_VALUES] = {NULL};
    (void)worker;
    for (size_t i = 0; i < exchange->components && !filters; i++)
        array[i] = mpm_particle_array(&state->particles, exchange->field, i);
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        double value[MPM_NODE_VALUES] = {0.0};
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        if (exchange->from != NULL)
            gather(state, stencil, value);
        for (size_t i = 0; exchange->from == NULL && i < exchange->components; i++)
            value[i] = array[i][p];
        for (size_t i = 0; exchange->to != NULL && i < exchange->components; i++)
            value[i] *= state->particles.mass[p];
        if (exchange->to != NULL)
            spread(state, stencil, value);
        for (size_t i = 0; exchange->to == NULL && i < exchange->components; i++)
            array[i][p] = value[i];
    }
}
