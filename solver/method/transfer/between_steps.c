/* Passes that are no part of a step: stress and domains of the F at hand, boxes of the strips.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"
#include "method/transfer/transfer.h"

void mpm_pass_recompute(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_particles *const particles = &state->particles;
    (void)worker;
    for (size_t p = state->strips[index].begin; p < state->strips[index].end; p++) {
        double stress[MPM_SYMMETRIC_SIZE], wave_speed_squared;
        mpm_particle_find_stress(state, p, stress, &wave_speed_squared);
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
            particles->stress[k][p] = stress[k];
        mpm_particle_set_domain(state, p);
    }
}

void mpm_pass_measure(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    struct mpm_extents extents;
    (void)worker;
    mpm_extents_begin(state, &extents);
    for (size_t p = strip->begin; p < strip->end; p++) {
        const struct mpm_placement placement = mpm_particle_placement(state, p);
        if (mpm_domain_check(state, &placement, state->particles.id[p], strip))
            mpm_extents_add(&extents, state->bodies[state->particles.body[p]].layer, &placement);
    }
    if (strip->failure.kind == MPM_NO_FAILURE)
        mpm_strip_set_boxes(state, strip, &extents);
}
