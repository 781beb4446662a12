/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/projection.h"

#include "base/strips.h"
#include "method/transfer/transfer.h"

#include <assert.h>

void mpm_projection_run(struct mpm_state *state, int workers,
                        const struct mpm_projection *projection)
{
    assert(projection->components <= MPM_PROJECTION_COMPONENTS);
    state->projection = projection;
    mpm_strips_run(state->strip_count, workers, state->kernels.passes->project, state);
    state->projection = NULL;
}

static void gather(const struct mpm_stencil *stencil, const double *nodes,
                   double value[MPM_PROJECTION_COMPONENTS])
{
    for (int k = 0; k < stencil->count; k++) {
        const double *const node = nodes + MPM_NODE_VALUES * (int64_t)stencil->node[k].node;
        for (int i = 0; i < MPM_PROJECTION_COMPONENTS; i++)
            value[i] += stencil->node[k].s * node[i];
    }
}

static void spread(const struct mpm_stencil *stencil, double mass,
                   const double value[MPM_PROJECTION_COMPONENTS], double *nodes)
{
    const double first = mass * value[0], second = mass * value[1];
    for (int k = 0; k < stencil->count; k++) {
        double *const node = nodes + MPM_NODE_VALUES * (int64_t)stencil->node[k].node;
        node[0] += first * stencil->node[k].s;
        node[2] += second * stencil->node[k].s;
    }
}

void mpm_pass_project(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_projection *const projection = state->projection;
    const struct mpm_particles *const particles = &state->particles;
    const int64_t zero = MPM_NODE_VALUES * state->node_zero;
    (void)worker;
    for (size_t p = state->strips[index].begin; p < state->strips[index].end; p++) {
        struct mpm_stencil room;
        double value[MPM_PROJECTION_COMPONENTS] = {0.0};
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        if (projection->from != NULL)
            gather(stencil, projection->from + zero, value);
        for (size_t i = 0; projection->from == NULL && i < projection->components; i++)
            value[i] = ((double *)mpm_particle_array(particles, projection->field, i))[p];
        if (projection->to != NULL)
            spread(stencil, particles->mass[p], value, projection->to + zero);
        for (size_t i = 0; projection->to == NULL && i < projection->components; i++)
            ((double *)mpm_particle_array(particles, projection->field, i))[p] = value[i];
    }
}
