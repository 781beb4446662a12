/* One step of the material point method.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_STEP_H
#define MPM_METHOD_STEP_H

#include "method/state.h"

/* Seconds spent in each phase. */
enum mpm_phase {
    MPM_PHASE_TO_GRID,
    MPM_PHASE_GRID,
    MPM_PHASE_TO_PARTICLES,
    MPM_PHASE_STRESS,
    MPM_PHASE_SORT,
    MPM_PHASE_TRANSPORT,
    MPM_PHASE_COUNT,
};
extern const char *const mpm_phase_names[MPM_PHASE_COUNT];

/* Advances the state by state->time_step. MPM_RUN_FAILED: state->failure states why, or
 * the error does if two rigid bodies contradict each other; the state is then of no
 * use. */
enum mpm_status mpm_step_advance(struct mpm_state *state, double seconds[MPM_PHASE_COUNT],
                                 struct mpm_error *error);

enum { MPM_STEPS_BETWEEN_SORTS = 32 };

/* Puts the particles in cell order and gives every strip its share; also after any
 * change of positions from outside. Leaves a copy of what cannot be recomputed in `saved`. */
void mpm_step_sort(struct mpm_state *state, unsigned char *saved, double seconds[MPM_PHASE_COUNT]);

/* Failures that strips have recorded, in state->failure; MPM_RUN_FAILED if there is one. */
enum mpm_status mpm_step_collect(struct mpm_state *state);

/* Is it time to sort? Every 32 steps; and when strips of one colour touch each other's
 * nodes. The answer depends on the state only. */
bool mpm_step_wants_sort(const struct mpm_state *state);

/* After positions and F were put back: all that follows from them. */
void mpm_step_recompute(struct mpm_state *state);

#endif
