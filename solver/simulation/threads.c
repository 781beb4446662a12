/* How many threads a run uses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"
#include "simulation/simulation.h"

#include <stdio.h>

/* Steps of 2300 particles take two threads 0.9 of the time of one, those of 4600 0.75, of 12800
 * 0.65 and of 10^5 0.54, for 1.7 times the processor time with the fewest and 1.05 with the most.
 */
enum { PARTICLES_PER_THREAD = 4096 };

int mpm_threads_choose(const struct mpm_state *state, int allowed, char reason[MPM_REASON_SIZE])
{
    const size_t particles = state->particles.count;
    size_t strips = 0;
    for (int64_t s = 0; s < state->strip_count; s++)
        strips += state->strips[s].begin < state->strips[s].end;
    /* every second strip is worked on at a time */
    const size_t by_strips = strips < 2 ? 1 : (strips + 1) / 2;
    const size_t by_particles = particles / PARTICLES_PER_THREAD + 1;
    char unused[MPM_REASON_SIZE];
    char *const text = reason == NULL ? unused : reason;
    if (by_strips >= (size_t)allowed && by_particles >= (size_t)allowed) {
        (void)snprintf(text, MPM_REASON_SIZE, "as many as are allowed");
        return allowed;
    }
    if (by_particles <= by_strips) {
        (void)snprintf(text, MPM_REASON_SIZE,
                       "of %d allowed: %zu particles, one more thread for each %d", allowed,
                       particles, PARTICLES_PER_THREAD);
        return (int)by_particles;
    }
    (void)snprintf(text, MPM_REASON_SIZE,
                   "of %d allowed: strips of %d rows of cells with particles: %zu, every second "
                   "one is worked on at a time",
                   allowed, MPM_STRIP_ROWS, strips);
    return (int)by_strips;
}

int mpm_simulation_threads(const struct mpm_simulation *simulation)
{
    return simulation->state.workers;
}
