/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/particles.h"

#include <assert.h>

#define EXPONENTS(length, mass, time) length, mass, time
#define ROW(name, type, member, several, exponents, present, kept, ones, title, description)       \
    [MPM_PARTICLE_##name] = {                                                                      \
        {title, sizeof(((struct mpm_particles *)0)->member) / sizeof(type *),                      \
         _Generic((type)0, uint32_t                                                                \
                  : true, double                                                                   \
                  : false),                                                                        \
         EXPONENTS exponents, description},                                                        \
        offsetof(struct mpm_particles, member),                                                    \
        sizeof(type),                                                                              \
        present,                                                                                   \
        kept,                                                                                      \
        ones,                                                                                      \
    },
const struct mpm_particle_row mpm_particle_rows[MPM_PARTICLE_FIELD_COUNT] = {
    MPM_PARTICLE_FIELDS(ROW)};
#undef ROW

#define ROW(name, type, member, ...)                                                               \
    _Static_assert(sizeof(((struct mpm_particles *)0)->member) / sizeof(type *) <= UINT8_MAX,      \
                   #member ": more components than mpm_particles.components counts");              \
    _Static_assert(sizeof(type) <= sizeof(double), #member ": the sort's scratch holds doubles");
MPM_PARTICLE_FIELDS(ROW)
#undef ROW
_Static_assert(2 * sizeof(uint32_t) <= sizeof(double), "the sort needs room for two orders");

/* ------------------------------------------------------------------- layout */

static void take_arrays(struct mpm_particles *particles, bool kept, struct mpm_arena *arena)
{
    const struct mpm_particle_needs needs = particles->needs;
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++) {
        const struct mpm_particle_row *const row = &mpm_particle_rows[field];
        if (((kept ? row->kept : row->present) & needs.uses) == 0)
            continue;
        const size_t components =
            row->present == MPM_USE_LAW_STATE ? needs.law_states : row->info.components;
        assert(components <= row->info.components);
        particles->components[field] = (uint8_t)components;
        for (size_t k = 0; k < components; k++)
            mpm_particle_set_array(particles, field, k,
                                   mpm_arena_take(arena, particles->count, row->size));
    }
}

void mpm_particles_layout(struct mpm_particles *particles, size_t count,
                          struct mpm_particle_needs needs, struct mpm_arena *arena)
{
    *particles = (struct mpm_particles){.count = count, .needs = needs};
    take_arrays(particles, false, arena);
}

void mpm_particles_layout_kept(struct mpm_particles *kept, const struct mpm_particles *particles,
                               struct mpm_arena *arena)
{
    *kept = (struct mpm_particles){.count = particles->count, .needs = particles->needs};
    take_arrays(kept, true, arena);
}

void mpm_particles_copy(const struct mpm_particles *from, struct mpm_particles *to)
{
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++)
        for (size_t k = 0; k < from->components[field] && k < to->components[field]; k++)
            memcpy(mpm_particle_array(to, field, k), mpm_particle_array(from, field, k),
                   from->count * mpm_particle_rows[field].size);
}

/* --------------------------------------------------------------------- sort */

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

static void gather(const void *from, size_t size, const uint32_t *order, size_t count, void *to)
{
    const double *const numbers = from;
    const uint32_t *const indices = from;
    for (size_t k = 0; size == sizeof *numbers && k < count; k++)
        ((double *)to)[k] = numbers[order[k]];
    for (size_t k = 0; size == sizeof *indices && k < count; k++)
        ((uint32_t *)to)[k] = indices[order[k]];
}

static bool in_order(const uint32_t *order, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (order[k] != k)
            return false;
    return true;
}

/* Brings every lasting field into the order, and leaves copies in `kept`. */
static void apply_order(struct mpm_particles *particles, const uint32_t *order,
                        struct mpm_particles *kept)
{
    const size_t count = particles->count;
    const bool sorted = in_order(order, count);
    for (size_t field = 0; field < MPM_PARTICLE_LASTING_COUNT; field++)
        for (size_t k = 0; k < particles->components[field]; k++) {
            const size_t size = mpm_particle_rows[field].size;
            const bool is_kept = k < kept->components[field];
            void *const array = mpm_particle_array(particles, field, k);
            void *const copy = is_kept ? mpm_particle_array(kept, field, k) : particles->carried[0];
            if (sorted && is_kept) {
                memcpy(copy, array, count * size);
            } else if (!sorted) {
                gather(array, size, order, count, copy);
                memcpy(array, copy, count * size);
            }
        }
}

void mpm_particles_sort(struct mpm_particles *particles, const struct mpm_grid *grid,
                        const double half_size[2], uint32_t *counts, struct mpm_particles *kept)
{
    uint32_t *const order = mpm_particles_order(particles), *const by_column =
                                                                order + particles->count;
    for (size_t p = 0; p < particles->count; p++)
        order[p] = (uint32_t)p;
    /* least significant key first: columns, then rows */
    sort_axis(particles, grid, half_size, 0, order, by_column, counts);
    sort_axis(particles, grid, half_size, 1, by_column, order, counts);
    apply_order(particles, order, kept);
}
