/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast_block.h"

#include "method/fields/fields.h"
#include "method/transfer/extent.h"
#include "method/transfer/law_state.h"
#include "method/transfer/transfer.h"

static double place_of_axis(const struct mpm_shape_grid *grid)
{
    return mpm_shape_cells(-grid->origin[0] * grid->inverse_cell[0]);
}

static struct fast_scalar scalar_of(const struct mpm_state *state,
                                    const struct mpm_nodal_scalar *scalar, uint32_t body)
{
    return (struct fast_scalar){
        .nodes = {[FAST_CONTENT] = scalar->content,
                  [FAST_CAPACITY] = scalar->capacity,
                  [FAST_VALUE] = scalar->value,
                  [FAST_INFLOW] = scalar->inflow,
                  [FAST_RESULT] = scalar->result},
        .field = scalar->row->field,
        .weight = scalar->weight[body],
        .inverse_density =
            scalar->source == NULL ? 0.0 : 1.0 / state->bodies[body].material.density,
        .kept = mpm_scalar_takes_values(scalar) ? 0.0 : 1.0,
        .part = mpm_scalar_takes_values(scalar) ? 1.0 : state->time_step,
        .follows_mass = state->kernels.passes->with_scalar && scalar->uniform,
        .conduction = scalar->bodies[body],
    };
}

/* The one that a pass is for, or goes along with mechanics, or NULL. */
static const struct mpm_nodal_scalar *scalar_at_work(const struct mpm_state *state)
{
    const struct mpm_nodal_scalar *const conducted = state->transport.conducted;
    return conducted == NULL && state->kernels.passes->with_scalar ? state->transport.list
                                                                   : conducted;
}

void mpm_fast_constants(const struct mpm_state *state, uint32_t body, double part,
                        struct fast_constants *constants)
{
    const struct mpm_grid *const grid = &state->grid;
    const struct mpm_projection *const projection = state->projection;
    const struct mpm_nodal_scalar *const scalar = scalar_at_work(state);
    const bool midpoint = state->scene->position_update == MPM_MIDPOINT;
    *constants = (struct fast_constants){
        .axis = place_of_axis(&state->shape_grid),
        .truncated = state->shape_grid.truncated && !state->family->point,
        .columns = (double)grid->columns,
        .stride = grid->columns,
        .pitch = grid->columns * (int64_t)sizeof(mpm_vector),
        .node_zero = state->node_zero + mpm_layer_shift(state, state->bodies[body].layer),
        .mass = grid->mass,
        .sum = grid->sum,
        .read = projection != NULL ? (double *)projection->from : (double *)grid->motion,
        .gradient =
            projection != NULL && projection->to != NULL ? (void *)projection->to : grid->gradient,
        .time_step = state->time_step,
        .stress_step = part * state->time_step,
        .part = part,
        .back = midpoint ? 0.5 * state->time_step : 0.0,
        .deformation_terms = state->scene->deformation_terms,
        .material = state->bodies[body].material,
        .viscosity = &state->bodies[body].given->viscosity,
    };
    if (scalar != NULL)
        constants->scalar = scalar_of(state, scalar, body);
    constants->cut = constants->truncated ? constants->axis : -DBL_MAX;
    constants->cut_cell = floor(constants->cut);
    mpm_shape_reach(state->family, &state->shape_grid, state->bodies[body].half_size,
                    constants->half);
    for (int axis = 0; axis < 2; axis++) {
        const double ghost = mpm_ghost_reach(grid, axis);
        constants->origin[axis] = grid->origin[axis];
        constants->inverse_cell[axis] = grid->inverse_cell[axis];
        constants->edge_low[axis] = (double)state->shape_grid.edge_low[axis];
        constants->edge_high[axis] = (double)state->shape_grid.edge_high[axis];
        constants->cell[axis] = grid->cell[axis];
        constants->end[axis] = mpm_grid_end(grid, axis);
        constants->lowest_reach[axis] = constants->origin[axis] - ghost;
        constants->highest_reach[axis] = constants->end[axis] + ghost;
    }
}

static void find_stress(const struct mpm_state *state, size_t p)
{
    double stress[MPM_SYMMETRIC_SIZE], wave_speed_squared;
    mpm_particle_find_stress(state, p, stress, &wave_speed_squared);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        state->particles.stress[k][p] = stress[k];
}

void mpm_fast_update_particles(struct fast_sums *sums, double part,
                               const struct mpm_particles *particles, size_t first, size_t end,
                               const struct fast_deformations *next)
{
    const struct mpm_state *state = sums->state;
    struct mpm_state seen; /* with the copies of a tail as its particles */
    if (particles != &state->particles) {
        seen = *state;
        seen.particles = *particles;
        state = &seen;
    }
    for (size_t p = first; p < end; p++) {
        double f[MPM_GRADIENT_SIZE];
        if (next == NULL) {
            find_stress(state, p);
            continue;
        }
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
            f[i] = next->f[i][p - first];
        mpm_particle_take_deformation(state, p, part, f, sums->strip);
    }
}

size_t mpm_fast_run_end(const struct mpm_state *state, size_t begin, size_t end)
{
    const uint32_t *const body = state->particles.body;
    size_t p = begin + 1;
    if (state->deformable_bodies == 1)
        return end;
    while (p < end && body[p] == body[begin])
        p++;
    return p;
}

/* A place among a run's particles, moved up to the next whole vector. */
static size_t whole_vectors(const struct mpm_span *run, size_t place)
{
    const size_t rest = place > run->begin ? (place - run->begin) % MPM_VECTOR_SIZE : 0;
    const size_t end = rest == 0 ? place : place - rest + MPM_VECTOR_SIZE;
    return end < run->end ? end : run->end;
}

struct fast_piece mpm_fast_piece_at(const struct mpm_state *state, int64_t strip,
                                    const struct mpm_span *run, size_t begin, size_t *next)
{
    const struct mpm_span *const spans = mpm_field_spans(state, strip);
    for (; *next < state->strips[strip].span_count; (*next)++) {
        const struct mpm_span *const span = &spans[*next];
        const size_t low = span->begin < run->begin ? run->begin : span->begin;
        const size_t first = low - (low - run->begin) % MPM_VECTOR_SIZE;
        const size_t end = whole_vectors(run, span->end);
        if (end > begin)
            return first > begin ? (struct fast_piece){first < run->end ? first : run->end, false}
                                 : (struct fast_piece){end, true};
    }
    return (struct fast_piece){run->end, false};
}

/* -------------------------------------------------------------------- tails */

void mpm_fast_tail_fill(struct fast_tail *tail, const struct mpm_particles *particles, size_t first,
                        size_t count)
{
    union fast_tail_value *value = tail->values;
    size_t from[MPM_VECTOR_SIZE];
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        from[lane] = lane < count ? first + lane : first;
    tail->particles = (struct mpm_particles){.count = MPM_VECTOR_SIZE};
    for (size_t field = 0; field < particles->fields; field++)
        for (size_t k = 0; k < particles->components[field]; k++, value++) {
            const double *const number = mpm_particle_array(particles, field, k);
            const uint32_t *const index = mpm_particle_array(particles, field, k);
            if (mpm_particle_rows[field].info.integer)
                for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++)
                    value->index[lane] = index[from[lane]];
            else
                for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++)
                    value->number[lane] = number[from[lane]];
            if (k < mpm_particle_rows[field].info.components)
                mpm_particle_set_array(&tail->particles, field, k, value);
        }
    for (size_t lane = count; lane < MPM_VECTOR_SIZE; lane++)
        tail->particles.mass[lane] = 0.0;
}

void mpm_fast_tail_write(const struct fast_tail *tail, const struct mpm_particles *particles,
                         size_t first, size_t count)
{
    const union fast_tail_value *value = tail->values;
    for (size_t field = 0; field < particles->fields; field++)
        for (size_t k = 0; k < particles->components[field]; k++, value++)
            if (!mpm_particle_rows[field].info.integer)
                memcpy((double *)mpm_particle_array(particles, field, k) + first, value->number,
                       count * sizeof(double));
}

/* ----------------------------------------------------------------- failures */

void mpm_fast_report_velocity(struct mpm_strip *strip, const struct mpm_particles *particles,
                              size_t p)
{
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const double vx = particles->velocity[0][p + lane], vy = particles->velocity[1][p + lane];
        const double square = vx * vx + vy * vy;
        if (!(square <= DBL_MAX))
            mpm_strip_record(strip, MPM_NOT_FINITE, particles->id[p + lane], 0, square);
    }
}

void mpm_fast_report_stress(struct mpm_strip *strip, const struct mpm_particles *particles,
                            size_t p, const double j[MPM_VECTOR_SIZE],
                            const double wave_speed_squared[MPM_VECTOR_SIZE])
{
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        if (!(j[lane] > 0.0))
            mpm_strip_record(strip, MPM_INVERTED, particles->id[p + lane], 0, j[lane]);
        else if (!(wave_speed_squared[lane] <= DBL_MAX))
            mpm_strip_record(strip, MPM_NOT_FINITE, particles->id[p + lane], 0,
                             wave_speed_squared[lane]);
    }
}

void mpm_fast_report_position(const struct mpm_state *state, struct mpm_strip *strip,
                              const struct mpm_particles *particles, size_t p,
                              const double placement[6][MPM_VECTOR_SIZE])
{
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const struct mpm_placement place = {
            .position = {placement[0][lane], placement[1][lane]},
            .step = {placement[2][lane], placement[3][lane]},
            .reach = {placement[4][lane], placement[5][lane]},
        };
        (void)mpm_placement_check(state, &place, particles->id[p + lane], strip);
    }
}
