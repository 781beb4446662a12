/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/particles.h"

#include <string.h>

void mpm_particles_layout(struct mpm_particles *particles, size_t count,
                          struct mpm_particle_extras extras, struct mpm_arena *arena)
{
    *particles = (struct mpm_particles){
        .count = count,
        .kept = 4U + MPM_GRADIENT_SIZE + (extras.affine ? 4U : 0U) +
                (extras.stress ? MPM_SYMMETRIC_SIZE : 0U),
    };
    for (int axis = 0; axis < 2; axis++) {
        particles->position[axis] = MPM_TAKE(arena, double, count);
        particles->velocity[axis] = MPM_TAKE(arena, double, count);
    }
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        particles->deformation[k] = MPM_TAKE(arena, double, count);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        particles->stress[k] = MPM_TAKE(arena, double, count);
    particles->mass = MPM_TAKE(arena, double, count);
    for (int k = 0; extras.affine && k < 4; k++)
        particles->affine[k] = MPM_TAKE(arena, double, count);
    for (int k = 0; extras.domains && k < 4; k++)
        particles->domain[k] = MPM_TAKE(arena, double, count);
    for (int axis = 0; extras.origins && axis < 2; axis++)
        particles->origin[axis] = MPM_TAKE(arena, double, count);
    particles->id = MPM_TAKE(arena, uint32_t, count);
    particles->body = MPM_TAKE(arena, uint32_t, count);
    particles->scratch = MPM_TAKE(arena, double, count);
    particles->carried[0] = particles->scratch;
    particles->carried[1] = MPM_TAKE(arena, double, count);
    particles->order = (void *)particles->carried[1];
    particles->order_scratch = particles->order == NULL ? NULL : particles->order + count;
}

void mpm_rigid_particles_layout(struct mpm_rigid_particles *particles, size_t count,
                                struct mpm_arena *arena)
{
    *particles = (struct mpm_rigid_particles){.count = count};
    for (int axis = 0; axis < 2; axis++) {
        particles->position[axis] = MPM_TAKE(arena, double, count);
        particles->velocity[axis] = MPM_TAKE(arena, double, count);
    }
    particles->id = MPM_TAKE(arena, uint32_t, count);
    particles->body = MPM_TAKE(arena, uint32_t, count);
}

size_t mpm_particles_arrays(const struct mpm_particles *particles,
                            double *arrays[MPM_PARTICLE_ARRAYS])
{
    size_t n = 0;
    for (int axis = 0; axis < 2; axis++) {
        arrays[n++] = particles->position[axis];
        arrays[n++] = particles->velocity[axis];
    }
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        arrays[n++] = particles->deformation[k];
    for (int k = 0; particles->affine[0] != NULL && k < 4; k++)
        arrays[n++] = particles->affine[k];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        arrays[n++] = particles->stress[k];
    arrays[n++] = particles->mass;
    for (int k = 0; particles->domain[0] != NULL && k < 4; k++)
        arrays[n++] = particles->domain[k];
    for (int axis = 0; particles->origin[0] != NULL && axis < 2; axis++)
        arrays[n++] = particles->origin[axis];
    return n;
}

/* One stable counting sort of an order by the cell along one axis. */
static void sort_axis(const struct mpm_particles *particles, const struct mpm_grid *grid,
                      const double half_size[2], int axis, const uint32_t *from, uint32_t *to,
                      uint32_t *counts)
{
    const double *const position = particles->position[axis];
    const int64_t cells = grid->cells[axis];
    memset(counts, 0, (size_t)(cells + 1) * sizeof *counts);
    for (size_t p = 0; p < particles->count; p++)
        counts[mpm_particle_cell(grid, axis, position[p], half_size) + 1]++;
    for (int64_t c = 0; c < cells; c++)
        counts[c + 1] += counts[c];
    for (size_t k = 0; k < particles->count; k++)
        to[counts[mpm_particle_cell(grid, axis, position[from[k]], half_size)]++] = from[k];
}

static void gather_doubles(const struct mpm_particles *particles, const double *from, double *to)
{
    const uint32_t *const order = particles->order;
    for (size_t k = 0; k < particles->count; k++)
        to[k] = from[order[k]];
}

static void gather_indices(const struct mpm_particles *particles, uint32_t *array)
{
    uint32_t *const scratch = (void *)particles->scratch;
    for (size_t k = 0; k < particles->count; k++)
        scratch[k] = array[particles->order[k]];
    memcpy(array, scratch, particles->count * sizeof *array);
}

static bool in_order(const struct mpm_particles *particles)
{
    for (size_t k = 0; k < particles->count; k++)
        if (particles->order[k] != k)
            return false;
    return true;
}

void mpm_particles_sort(struct mpm_particles *particles, const struct mpm_grid *grid,
                        const double half_size[2], uint32_t *counts,
                        double *const kept[MPM_KEPT_ARRAYS])
{
    const size_t bytes = particles->count * sizeof(double);
    double *arrays[MPM_PARTICLE_ARRAYS];
    const size_t array_count = mpm_particles_arrays(particles, arrays);
    for (size_t p = 0; p < particles->count; p++)
        particles->order[p] = (uint32_t)p;
    /* least significant key first: columns, then rows */
    sort_axis(particles, grid, half_size, 0, particles->order, particles->order_scratch, counts);
    sort_axis(particles, grid, half_size, 1, particles->order_scratch, particles->order, counts);
    const bool sorted = in_order(particles);
    for (size_t a = 0; a < array_count; a++) {
        double *const copy = a < particles->kept ? kept[a] : particles->scratch;
        if (sorted && a < particles->kept) {
            memcpy(copy, arrays[a], bytes);
        } else if (!sorted) {
            gather_doubles(particles, arrays[a], copy);
            memcpy(arrays[a], copy, bytes);
        }
    }
    if (!sorted) {
        gather_indices(particles, particles->id);
        gather_indices(particles, particles->body);
    }
}
