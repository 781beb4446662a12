/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast_block.h"

#include "method/transfer/extent.h"

static double place_of_axis(const struct mpm_shape_grid *grid)
{
    return mpm_shape_cells(-grid->origin[0] * grid->inverse_cell[0]);
}

void mpm_fast_constants(const struct mpm_state *state, uint32_t body, double part,
                        struct fast_constants *constants)
{
    const struct mpm_grid *const grid = &state->grid;
    const bool midpoint = state->scene->position_update == MPM_MIDPOINT;
    *constants = (struct fast_constants){
        .axis = place_of_axis(&state->shape_grid),
        .truncated = state->shape_grid.truncated && !state->family->point,
        .columns = (double)grid->columns,
        .stride = grid->columns,
        .pitch = grid->columns * (int64_t)sizeof(mpm_vector),
        .node_zero = state->node_zero + state->bodies[body].shift,
        .mass = grid->mass,
        .sum = grid->sum,
        .motion = grid->motion,
        .gradient = grid->gradient,
        .time_step = state->time_step,
        .stress_step = part * state->time_step,
        .back = midpoint ? 0.5 * state->time_step : 0.0,
        .deformation_terms = state->scene->deformation_terms,
        .material = state->bodies[body].material,
    };
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
        constants->longest_step[axis] = grid->cell[axis];
        constants->lowest[axis] = grid->origin[axis];
        constants->highest[axis] =
            grid->origin[axis] + (double)grid->cells[axis] * grid->cell[axis];
        constants->lowest_reach[axis] = constants->lowest[axis] - ghost;
        constants->highest_reach[axis] = constants->highest[axis] + ghost;
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

/* -------------------------------------------------------------------- tails */

/* In the order of arrays_of. */
static void view_values(struct fast_tail *tail, const struct mpm_particles *particles)
{
    struct mpm_particles *const view = &tail->particles;
    size_t n = 0;
    for (int axis = 0; axis < 2; axis++) {
        view->position[axis] = tail->values[n++];
        view->velocity[axis] = tail->values[n++];
    }
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        view->deformation[k] = tail->values[n++];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        view->stress[k] = tail->values[n++];
    view->mass = tail->values[n++];
    for (int k = 0; k < 4; k++)
        view->domain[k] = particles->domain[0] != NULL ? tail->values[n++] : NULL;
    for (int axis = 0; axis < 2; axis++)
        view->origin[axis] = particles->origin[0] != NULL ? tail->values[n++] : NULL;
    for (int axis = 0; axis < 2; axis++)
        view->carried[axis] = tail->values[n++];
    view->id = tail->id;
}

/* All arrays that a pass may touch. */
static size_t arrays_of(const struct mpm_particles *particles,
                        double *arrays[MPM_PARTICLE_ARRAYS + 2])
{
    size_t n = mpm_particles_arrays(particles, arrays);
    for (int axis = 0; axis < 2; axis++)
        arrays[n++] = particles->carried[axis];
    return n;
}

void mpm_fast_tail_fill(struct fast_tail *tail, const struct mpm_particles *particles, size_t first,
                        size_t count)
{
    double *arrays[MPM_PARTICLE_ARRAYS + 2];
    const size_t array_count = arrays_of(particles, arrays);
    tail->particles = (struct mpm_particles){.count = MPM_VECTOR_SIZE};
    view_values(tail, particles);
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const size_t from = lane < count ? first + lane : first;
        for (size_t a = 0; a < array_count; a++)
            tail->values[a][lane] = arrays[a][from];
        tail->id[lane] = particles->id[from];
        if (lane >= count)
            tail->particles.mass[lane] = 0.0;
    }
}

void mpm_fast_tail_write(const struct fast_tail *tail, const struct mpm_particles *particles,
                         size_t first, size_t count)
{
    double *arrays[MPM_PARTICLE_ARRAYS + 2];
    const size_t array_count = arrays_of(particles, arrays);
    for (size_t a = 0; a < array_count; a++)
        memcpy(arrays[a] + first, tail->values[a], count * sizeof(double));
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
