/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/particles.h"

#include <assert.h>

/* NOLINTBEGIN(bugprone-macro-parentheses): `several` is [n] or nothing. */
#define ROW(name, type, member, several, unit_of, needed, copied, unit, title, description)        \
    [MPM_PARTICLE_##name] = {                                                                      \
        .info = {title, sizeof(char several), sizeof(type) == sizeof(uint32_t),                    \
                 MPM_DIMENSION_##unit_of, description},                                            \
        .place = offsetof(struct mpm_particles, member),                                           \
        .size = sizeof(type),                                                                      \
        .present = (needed),                                                                       \
        .kept = (copied),                                                                          \
        .ones = (unit),                                                                            \
    },
const struct mpm_particle_row mpm_particle_rows[MPM_PARTICLE_FIELD_COUNT] = {
    MPM_PARTICLE_FIELDS(ROW)};
#undef ROW

#define ROW(name, type, member, several, ...)                                                      \
    _Static_assert(sizeof(char several) <= UINT8_MAX,                                              \
                   #member ": more components than mpm_particles.components counts");              \
    _Static_assert(sizeof(type) <= sizeof(double), #member ": the sort's scratch holds doubles");
MPM_PARTICLE_FIELDS(ROW)
#undef ROW
/* NOLINTEND(bugprone-macro-parentheses) */
_Static_assert(2 * sizeof(uint32_t) <= sizeof(double), "the sort needs room for two orders");

/* ------------------------------------------------------------------- layout */

enum { ALIGNMENT = 64 }; /* a cache line, as in an arena */

void mpm_particles_layout_field(struct mpm_particles *particles, size_t field, size_t components,
                                struct mpm_arena *arena)
{
    const struct mpm_particle_row *const row = &mpm_particle_rows[field];
    const size_t pointers = row->info.components;
    const size_t length = pointers == 1 ? components * particles->count : particles->count;
    assert(pointers == 1 || components <= pointers);
    particles->components[field] = (uint8_t)components;
    if (components > 0 && field >= particles->fields)
        particles->fields = (uint8_t)(field + 1);
    for (size_t k = 0; k < pointers; k++)
        mpm_particle_set_array(particles, field, k,
                               k < components ? mpm_arena_take(arena, length, row->size) : NULL);
}

void mpm_particles_layout(struct mpm_particles *particles, size_t count,
                          struct mpm_particle_needs needs, struct mpm_arena *arena)
{
    *particles = (struct mpm_particles){.count = count, .needs = needs};
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++) {
        const struct mpm_particle_row *const row = &mpm_particle_rows[field];
        if ((row->present & needs.uses) != 0)
            mpm_particles_layout_field(
                particles, field,
                row->present == MPM_USE_LAW_STATE ? needs.law_states : row->info.components, arena);
    }
}

void mpm_rigid_particles_layout(struct mpm_rigid_particles *rigid, size_t count,
                                struct mpm_arena *arena)
{
    struct mpm_particles set;
    mpm_particles_layout(&set, count, (struct mpm_particle_needs){.uses = MPM_USE_RIGID}, arena);
    rigid->count = count;
#define ROW(name, type, member, ...) memcpy(&rigid->member, &set.member, sizeof rigid->member);
    MPM_RIGID_PARTICLE_FIELDS(ROW)
#undef ROW
}

struct mpm_particles mpm_rigid_particles_set(const struct mpm_rigid_particles *rigid)
{
    struct mpm_particles set = {.count = rigid->count,
                                .needs = {.uses = MPM_USE_RIGID},
                                .fields = MPM_PARTICLE_FIELD_COUNT};
#define ROW(name, type, member, ...)                                                               \
    memcpy(&set.member, &rigid->member, sizeof set.member);                                        \
    set.components[MPM_PARTICLE_##name] =                                                          \
        (uint8_t)mpm_particle_rows[MPM_PARTICLE_##name].info.components;
    MPM_RIGID_PARTICLE_FIELDS(ROW)
#undef ROW
    return set;
}

/* ---------------------------------------------------------- the last good state */

size_t mpm_particles_kept_components(const struct mpm_particles *particles, size_t field)
{
    const bool kept = (mpm_particle_rows[field].kept & particles->needs.uses) != 0;
    return kept ? particles->components[field] : 0;
}

size_t mpm_particles_kept_distance(const struct mpm_particles *particles, size_t field)
{
    const size_t bytes = particles->count * mpm_particle_rows[field].size;
    return (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

size_t mpm_particles_kept_bytes(const struct mpm_particles *particles)
{
    size_t bytes = 0;
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++)
        bytes += mpm_particles_kept_components(particles, field) *
                 mpm_particles_kept_distance(particles, field);
    return bytes;
}

static void copy_kept(const struct mpm_particles *particles, unsigned char *kept, bool back)
{
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++)
        for (size_t k = 0; k < mpm_particles_kept_components(particles, field); k++) {
            void *const array = mpm_particle_array(particles, field, k);
            memcpy(back ? array : kept, back ? kept : array,
                   particles->count * mpm_particle_rows[field].size);
            kept += mpm_particles_kept_distance(particles, field);
        }
}

void mpm_particles_keep(const struct mpm_particles *particles, unsigned char *kept)
{
    copy_kept(particles, kept, false);
}

void mpm_particles_put_back(const struct mpm_particles *particles, unsigned char *kept)
{
    copy_kept(particles, kept, true);
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

/* Brings every lasting field into the order, by way of its copy if there are copies. */
static void apply_order(const struct mpm_particles *particles, const uint32_t *order,
                        unsigned char *kept)
{
    const size_t count = particles->count;
    for (size_t field = 0; field < MPM_PARTICLE_LASTING_COUNT; field++)
        for (size_t k = 0; k < particles->components[field]; k++) {
            const size_t size = mpm_particle_rows[field].size;
            const bool is_kept =
                kept != NULL && k < mpm_particles_kept_components(particles, field);
            void *const array = mpm_particle_array(particles, field, k);
            void *const copy = is_kept ? kept : (void *)particles->carried[0];
            gather(array, size, order, count, copy);
            memcpy(array, copy, count * size);
            if (is_kept)
                kept += mpm_particles_kept_distance(particles, field);
        }
}

void mpm_particles_sort(struct mpm_particles *particles, const struct mpm_grid *grid,
                        const double half_size[2], uint32_t *counts, unsigned char *kept)
{
    uint32_t *const order = mpm_particles_order(particles), *const by_column =
                                                                order + particles->count;
    for (size_t p = 0; p < particles->count; p++)
        order[p] = (uint32_t)p;
    /* least significant key first: columns, then rows */
    sort_axis(particles, grid, half_size, 0, order, by_column, counts);
    sort_axis(particles, grid, half_size, 1, by_column, order, counts);
    if (in_order(order, particles->count))
        mpm_particles_keep(particles, kept);
    else
        apply_order(particles, order, kept);
}

void mpm_particles_arrange(struct mpm_particles *particles, const uint32_t *order)
{
    apply_order(particles, order, NULL);
}
