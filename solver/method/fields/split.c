/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fields/split.h"

#include "method/fields/fields.h"

/* What a pass leaves in its strip; a negative number: nothing yet. */
struct sums {
    double kinetic, wave;
    struct mpm_node_box box;
};

static bool is_empty(const struct mpm_node_box *box)
{
    return box->low[1] > box->high[1];
}

static void add_box(struct mpm_node_box *sum, const struct mpm_node_box *box)
{
    const bool first = is_empty(sum);
    for (int axis = 0; axis < 2 && !is_empty(box); axis++) {
        sum->low[axis] = first || box->low[axis] < sum->low[axis] ? box->low[axis] : sum->low[axis];
        sum->high[axis] =
            first || box->high[axis] > sum->high[axis] ? box->high[axis] : sum->high[axis];
    }
}

/* One pass over one piece of the strip. */
static void run_piece(struct mpm_state *state, int64_t index, int worker, mpm_pass *pass,
                      struct mpm_span piece, struct sums *sums)
{
    struct mpm_strip *const strip = &state->strips[index];
    if (pass == NULL || piece.begin == piece.end)
        return;
    strip->begin = piece.begin;
    strip->end = piece.end;
    strip->kinetic_energy = strip->wave_speed_squared = -1.0;
    strip->box = MPM_NO_BOX;
    pass(state, index, worker);
    if (strip->kinetic_energy >= 0.0)
        sums->kinetic = (sums->kinetic < 0.0 ? 0.0 : sums->kinetic) + strip->kinetic_energy;
    if (strip->wave_speed_squared > sums->wave)
        sums->wave = strip->wave_speed_squared;
    add_box(&sums->box, &strip->box);
}

/* Restores what no piece has computed anew. The kinetic energy of a step comes from one pass of
 * each set of kernels, but not always the same one: it adds up from pass to pass. */
static void finish_strip(struct mpm_strip *strip, const struct mpm_strip *before,
                         const struct sums *sums)
{
    const struct mpm_failure failure = strip->failure;
    *strip = *before;
    strip->failure = failure;
    if (sums->kinetic >= 0.0)
        strip->kinetic_energy += sums->kinetic;
    if (sums->wave >= 0.0)
        strip->wave_speed_squared = sums->wave;
    if (!is_empty(&sums->box))
        strip->box = sums->box;
}

static void run_split(struct mpm_state *state, int64_t index, int worker, mpm_pass *plain,
                      mpm_pass *general)
{
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_strip before = *strip;
    const struct mpm_span *const spans = mpm_field_spans(state, index);
    struct sums sums = {.kinetic = -1.0, .wave = -1.0, .box = MPM_NO_BOX};
    size_t place = before.begin;
    for (size_t k = 0; k < before.span_count; k++) {
        const struct mpm_span between = {place, spans[k].begin};
        run_piece(state, index, worker, plain, between, &sums);
        run_piece(state, index, worker, general, spans[k], &sums);
        place = spans[k].end;
    }
    run_piece(state, index, worker, plain, (struct mpm_span){place, before.end}, &sums);
    finish_strip(strip, &before, &sums);
}

#define SPLIT(name)                                                                                \
    static void name(void *context, int64_t index, int worker)                                     \
    {                                                                                              \
        struct mpm_state *const state = context;                                                   \
        run_split(state, index, worker, state->kernels.plain->name, state->kernels.general->name); \
    }

/* The first pass of a step begins the sum of the kinetic energy. */
static void to_grid(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    state->strips[index].kinetic_energy = 0.0;
    run_split(state, index, worker, state->kernels.plain->to_grid, state->kernels.general->to_grid);
}

SPLIT(stress_before)
SPLIT(to_particles)
SPLIT(finish)
SPLIT(project)

/* The whole strip: nothing is exchanged with nodes. */
static void recompute(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    state->kernels.plain->recompute(context, index, worker);
}

const struct mpm_passes mpm_split_passes = {
    .to_grid = to_grid,
    .stress_before = stress_before,
    .to_particles = to_particles,
    .finish = finish,
    .recompute = recompute,
    .project = project,
};
