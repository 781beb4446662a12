/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/grid_drag.h"

#include "base/strips.h"
#include "method/grid/grid_update.h"
#include "method/loads/damping_rate.h"
#include "method/transfer/transfer.h"

#include <string.h>

void mpm_grid_drag_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_damping *const damping = &state->damping;
    const size_t nodes = (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
    if (damping->grid_form != MPM_GRID_DAMPING_NODES)
        for (int axis = 0; axis < 2; axis++)
            damping->grid_drag[axis] = MPM_TAKE(arena, double, state->particles.count);
    if (damping->grid_form == MPM_GRID_DAMPING_PARTICLES)
        damping->node_drag = mpm_arena_take(arena, nodes, sizeof *damping->node_drag);
}

void mpm_row_grid_drag(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_damping *const damping = &state->damping;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const bool varying = mpm_rate_is_varying(damping->grid);
    struct mpm_row_sums *const sums = &state->row_sums[row];
    sums->refused = -1;
    sums->dissipated = 0.0; /* by the particles */
    for (int64_t node = span.first; node < span.end; node++) {
        const double place_rate =
            varying && state->grid.mass[node] != 0.0 ? mpm_rate_of_node(state, node, worker) : 0.0;
        const double rate = damping->grid_rate + place_rate;
        if (!(place_rate >= 0.0 && mpm_rate_is_allowed(rate, state->time_step))) {
            sums->refused = node;
            sums->rate = rate;
            return;
        }
        for (int axis = 0; axis < 2; axis++)
            damping->node_drag[node][axis] = rate * state->grid.start[node][axis];
    }
}

/* alpha_g(t, x_p) with the uniform part; 0, with a record, if it is not allowed */
static double rate_at_particle(const struct mpm_state *state, size_t p, int worker,
                               struct mpm_strip *strip)
{
    const double place[2] = {state->particles.position[0][p], state->particles.position[1][p]};
    const double place_rate = mpm_rate_value(state->damping.grid, state, place, worker);
    const double rate = state->damping.grid_rate + place_rate;
    if (place_rate >= 0.0 && mpm_rate_is_allowed(rate, state->time_step))
        return rate;
    mpm_strip_record(strip, MPM_RATE_REFUSED, state->particles.id[p], 1, rate);
    return 0.0;
}

static inline void add_drag(struct mpm_state *state, int64_t index, int worker, bool by_node,
                            bool varying)
{
    const struct mpm_damping *const damping = &state->damping;
    const struct mpm_particles *const particles = &state->particles;
    double(*const nodes)[2] = by_node ? damping->node_drag : state->grid.start;
    struct mpm_strip *const strip = &state->strips[index];
    double power = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        double q[2];
        mpm_particle_gather(state, p, nodes, q);
        const double rate = by_node   ? 1.0
                            : varying ? rate_at_particle(state, p, worker, strip)
                                      : damping->grid_rate;
        for (int axis = 0; axis < 2; axis++) {
            damping->grid_drag[axis][p] = rate * q[axis];
            state->particles.drag[axis][p] += rate * q[axis];
            power += particles->mass[p] * rate * q[axis] * particles->velocity[axis][p];
        }
    }
    strip->dissipated += 0.5 * state->time_step * power;
}

static void pass_by_node(void *context, int64_t index, int worker)
{
    add_drag(context, index, worker, true, false);
}

static void pass_by_uniform_rate(void *context, int64_t index, int worker)
{
    add_drag(context, index, worker, false, false);
}

static void pass_by_rate(void *context, int64_t index, int worker)
{
    add_drag(context, index, worker, false, true);
}

void mpm_grid_drag_find(struct mpm_state *state)
{
    const struct mpm_damping *const damping = &state->damping;
    mpm_pass *const pass = damping->node_drag != NULL           ? pass_by_node
                           : mpm_rate_is_varying(damping->grid) ? pass_by_rate
                                                                : pass_by_uniform_rate;
    if (damping->grid_drag[0] != NULL)
        mpm_strips_run(state->strip_count, state->workers, pass, state); /* strips share nothing */
}
