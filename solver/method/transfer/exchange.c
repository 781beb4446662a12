/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/exchange.h"

#include "base/strips.h"
#include "method/transfer/transfer.h"

void mpm_exchange_run(struct mpm_state *state, int workers, const struct mpm_exchange *exchange)
{
    state->exchange = exchange;
    mpm_strips_run(state->strip_count, workers, state->kernels.passes->exchange, state);
    state->exchange = NULL;
}

static void gather(const struct mpm_stencil *stencil, const double *nodes,
                   double value[MPM_EXCHANGE_COMPONENTS])
{
    for (int k = 0; k < stencil->count; k++) {
        const double *const node = nodes + MPM_NODE_VALUES * (int64_t)stencil->node[k].node;
        for (int i = 0; i < MPM_EXCHANGE_COMPONENTS; i++)
            value[i] += stencil->node[k].s * node[i];
    }
}

static void spread(const struct mpm_stencil *stencil, double mass,
                   const double value[MPM_EXCHANGE_COMPONENTS], double *nodes)
{
    const double first = mass * value[0], second = mass * value[1];
    for (int k = 0; k < stencil->count; k++) {
        double *const node = nodes + MPM_NODE_VALUES * (int64_t)stencil->node[k].node;
        node[0] += first * stencil->node[k].s;
        node[2] += second * stencil->node[k].s;
    }
}

void mpm_pass_exchange(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_exchange *const exchange = state->exchange;
    const struct mpm_particles *const particles = &state->particles;
    const int64_t zero = MPM_NODE_VALUES * state->node_zero;
    (void)worker;
    for (size_t p = state->strips[index].begin; p < state->strips[index].end; p++) {
        struct mpm_stencil room;
        double value[MPM_EXCHANGE_COMPONENTS] = {0.0};
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        if (exchange->from != NULL)
            gather(stencil, exchange->from + zero, value);
        for (size_t i = 0; exchange->from == NULL && i < exchange->components; i++)
            value[i] = ((double *)mpm_particle_array(particles, exchange->field, i))[p];
        if (exchange->to != NULL)
            spread(stencil, particles->mass[p], value, exchange->to + zero);
        for (size_t i = 0; exchange->to == NULL && i < exchange->components; i++)
            ((double *)mpm_particle_array(particles, exchange->field, i))[p] = value[i];
    }
}
