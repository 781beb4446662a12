/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_coupling.h"

#include "base/strips.h"
#include "method/transfer/law_state.h"
#include "method/transfer/transfer.h"
#include "mpm_transport.h"

/* sum S_ip v_i at the end of the step */
static double value_at_end(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                           const struct mpm_stencil *stencil)
{
    const double factor = mpm_scalar_takes_values(scalar) ? 1.0 : state->time_step;
    const double kept = mpm_scalar_takes_values(scalar) ? 0.0 : 1.0;
    double sum = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const int64_t node = state->node_zero + stencil->node[k].node;
        sum += stencil->node[k].s * (kept * scalar->value[node] + factor * scalar->result[node]);
    }
    return sum;
}

static void couple_strip(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        double value[MPM_SCALAR_COUNT] = {0.0};
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        for (size_t k = 0; k < state->transport.count; k++)
            value[state->transport.list[k].which] =
                value_at_end(state, &state->transport.list[k], stencil);
        if (particles->free_strain != NULL)
            particles->free_strain_step[p] =
                mpm_free_strain(state->bodies[particles->body[p]].given, value) -
                particles->free_strain[p];
        if (particles->law_temperature != NULL)
            particles->law_temperature_step[p] =
                value[MPM_TEMPERATURE] - particles->law_temperature[p];
    }
}

void mpm_transport_couple(struct mpm_state *state, int workers)
{
    mpm_transport_couple_nothing(state);
    if (!mpm_scene_couples(state->scene))
        return;
    mpm_strips_run(state->strip_count, workers, couple_strip, state);
    state->transport.couples = true;
}

void mpm_transport_couple_nothing(struct mpm_state *state)
{
    state->transport.couples = false;
    for (int64_t s = 0; s < state->strip_count; s++)
        state->strips[s].expansion_work = state->strips[s].deformation_heat = 0.0;
}

void mpm_transport_finish(struct mpm_state *state)
{
    if (!mpm_scene_couples(state->scene))
        return;
    for (int64_t s = 0; s < state->strip_count; s++) {
        state->transport.expansion.work += state->strips[s].expansion_work;
        state->transport.expansion.heat += state->strips[s].deformation_heat;
    }
}
