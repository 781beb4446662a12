/* The table of particle fields: layout, sort, last good state, and the copies that fill the last
 * vector of the fast kernels, for every field and any number of state variables of laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast_block.h"
#include "model/particles.h"
#include "suites.h"

#include <glib.h>
#include <string.h>

/* -------------------------------------------------------------- sets of particles */

/* Rows of cells that no particle reaches are among them. */
static const struct mpm_grid GRID = {
    .origin = {-1.0, 2.0},
    .cell = {0.5, 0.25},
    .inverse_cell = {2.0, 4.0},
    .cells = {7, 40},
};
static const double HALF_SIZE[2] = {0.125, 0.0625};

static const uint8_t law_states[] = {0, 1, 7, MPM_LAW_STATES};
static const size_t counts[] = {1, 6, 1003};
static const unsigned extra_uses[] = {
    0,
    MPM_USE_APIC,
    MPM_USE_DOMAINS,
    MPM_USE_ORIGINS,
    MPM_USE_LAW_STATE,
    MPM_USE_LAW_STATE | MPM_USE_DOMAINS,
    MPM_USE_APIC | MPM_USE_DOMAINS | MPM_USE_ORIGINS | MPM_USE_LAW_STATE,
};
enum {
    STATES = G_N_ELEMENTS(law_states),
    USES = G_N_ELEMENTS(extra_uses),
    CASES = G_N_ELEMENTS(counts) * STATES * USES,
};

struct set {
    struct mpm_particles now;
    unsigned char *kept;
    struct mpm_arena arena;
};

static void lay_out(struct set *set, size_t count, struct mpm_particle_needs needs)
{
    mpm_particles_layout(&set->now, count, needs, &set->arena);
    set->kept = MPM_TAKE(&set->arena, unsigned char, mpm_particles_kept_bytes(&set->now));
}

static struct mpm_particle_needs needs_of(int index)
{
    return (struct mpm_particle_needs){
        .uses = MPM_USE_DEFORMABLE | extra_uses[index % USES],
        .law_states = law_states[index / USES % STATES],
    };
}

static struct set set_open(int index)
{
    struct set set = {0};
    const size_t count = counts[index / USES / STATES];
    lay_out(&set, count, needs_of(index));
    ck_assert_int_eq(mpm_arena_allocate(&set.arena, NULL), MPM_OK);
    lay_out(&set, count, needs_of(index));
    return set;
}

/* ------------------------------------------------------------------------- values */

/* Of the particle that was created as number `id`; no other component of a particle has it. */
static double value_of(uint32_t id, size_t field, size_t component)
{
    if (field == MPM_PARTICLE_ID)
        return id;
    if (field == MPM_PARTICLE_POSITION) { /* all over the grid, in no order */
        const double size = GRID.cell[component] * (double)GRID.cells[component];
        return GRID.origin[component] +
               size * ((id * (component == 0 ? 7919U : 104729U) % 4096U) / 4096.0);
    }
    return id * 1024.0 + (double)(field * 32 + component);
}

static double read_value(const struct mpm_particles *particles, size_t field, size_t k, size_t p)
{
    const void *const array = mpm_particle_array(particles, field, k);
    return mpm_particle_rows[field].info.integer ? ((const uint32_t *)array)[p]
                                                 : ((const double *)array)[p];
}

static void write_value(struct mpm_particles *particles, size_t field, size_t k, size_t p,
                        double value)
{
    void *const array = mpm_particle_array(particles, field, k);
    if (mpm_particle_rows[field].info.integer)
        ((uint32_t *)array)[p] = (uint32_t)value;
    else
        ((double *)array)[p] = value;
}

/* NOLINTBEGIN(bugprone-macro-parentheses): field and k are names that the loops declare. */
#define FOR_ARRAYS(particles, field, k)                                                            \
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++)                              \
        for (size_t k = 0; k < (particles)->components[field]; k++)
/* NOLINTEND(bugprone-macro-parentheses) */

static void fill(struct mpm_particles *particles)
{
    FOR_ARRAYS(particles, field, k)
    for (size_t p = 0; p < particles->count; p++)
        write_value(particles, field, k, p, value_of((uint32_t)p, field, k));
}

static void assert_values(const struct mpm_particles *particles, size_t fields,
                          const uint32_t ids[])
{
    FOR_ARRAYS(particles, field, k)
    for (size_t p = 0; field < fields && p < particles->count; p++)
        ck_assert_msg(read_value(particles, field, k, p) == value_of(ids[p], field, k),
                      "%s %zu of particle %u is %.17g, expected %.17g",
                      mpm_particle_rows[field].info.name, k, ids[p],
                      read_value(particles, field, k, p), value_of(ids[p], field, k));
}

static void sort(struct set *set)
{
    uint32_t scratch[64];
    ck_assert(GRID.cells[0] < 64 && GRID.cells[1] < 64);
    mpm_particles_sort(&set->now, &GRID, HALF_SIZE, scratch, set->kept);
}

/* -------------------------------------------------------------------------- tests */

START_TEST(particles_have_the_fields_that_are_needed_and_memory_for_no_other)
{
    enum { CACHE_LINE = 64 };
    struct set set = set_open(_i);
    const struct mpm_particle_needs needs = needs_of(_i);
    size_t pointers = 0, bytes = 0;
    for (size_t field = 0; field < MPM_PARTICLE_FIELD_COUNT; field++) {
        const struct mpm_particle_row *const row = &mpm_particle_rows[field];
        const bool one_array = field == MPM_PARTICLE_LAW_STATE;
        const size_t all = one_array ? needs.law_states : row->info.components;
        const size_t components = (row->present & needs.uses) != 0 ? all : 0;
        const size_t kept = (row->kept & needs.uses) != 0 ? all : 0;
        ck_assert_uint_eq(set.now.components[field], components);
        for (size_t k = 0; k < row->info.components; k++)
            ck_assert((mpm_particle_array(&set.now, field, k) != NULL) == (k < components));
        const size_t array = (set.now.count * row->size + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
        const size_t together =
            (components * set.now.count * row->size + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
        pointers += row->info.components;
        bytes += (one_array ? together : components * array) + kept * array;
    }
    ck_assert_uint_eq(pointers + MPM_LAW_STATES - 1, MPM_PARTICLE_ARRAYS);
    ck_assert_uint_ge(set.arena.capacity, bytes);
    ck_assert_uint_le(set.arena.capacity, bytes + CACHE_LINE);
    mpm_arena_free(&set.arena);
}
END_TEST

/* With a law that has state, stress is among it. */
static bool is_kept(const struct mpm_particle_needs *needs, size_t field)
{
    const bool state = (needs->uses & MPM_USE_LAW_STATE) != 0;
    const bool expected[MPM_PARTICLE_FIELD_COUNT] = {
        [MPM_PARTICLE_POSITION] = true,
        [MPM_PARTICLE_VELOCITY] = true,
        [MPM_PARTICLE_DEFORMATION_GRADIENT] = true,
        [MPM_PARTICLE_STRESS] = state,
        [MPM_PARTICLE_AFFINE] = true,
        [MPM_PARTICLE_LAW_STATE] = true,
    };
    return expected[field];
}

/* Twice: the second time all are in order. What steps change is spoilt in between. */
START_TEST(the_last_good_state_keeps_what_changes_and_cannot_be_computed)
{
    struct set set = set_open(_i);
    const struct mpm_particle_needs needs = needs_of(_i);
    fill(&set.now);
    for (int time = 0; time < 2; time++) {
        sort(&set);
        FOR_ARRAYS(&set.now, field, k)
        for (size_t p = 0; p < set.now.count; p++)
            if (is_kept(&needs, field))
                write_value(&set.now, field, k, p, -1.0);
        mpm_particles_put_back(&set.now, set.kept);
        assert_values(&set.now, MPM_PARTICLE_LASTING_COUNT, set.now.id);
    }
    mpm_arena_free(&set.arena);
}
END_TEST

/* What the caller changes is not in the copy, what is not kept is left alone. */
START_TEST(the_last_good_state_leaves_all_else_alone)
{
    struct set set = set_open(_i);
    const struct mpm_particle_needs needs = needs_of(_i);
    fill(&set.now);
    mpm_particles_keep(&set.now, set.kept);
    FOR_ARRAYS(&set.now, field, k)
    for (size_t p = 0; p < set.now.count; p++)
        write_value(&set.now, field, k, p, 77.0);
    mpm_particles_put_back(&set.now, set.kept);
    FOR_ARRAYS(&set.now, field, k)
    for (size_t p = 0; p < set.now.count; p++)
        ck_assert(read_value(&set.now, field, k, p) ==
                  (is_kept(&needs, field) ? value_of((uint32_t)p, field, k) : 77.0));
    mpm_arena_free(&set.arena);
}
END_TEST

/* Twice: the second time all are in order. */
START_TEST(every_field_stays_with_its_particle_in_the_sort)
{
    struct set set = set_open(_i);
    struct mpm_particles *const now = &set.now;
    fill(now);
    for (int time = 0; time < 2; time++) {
        int64_t last = -1;
        sort(&set);
        for (size_t p = 0; p < now->count; p++) {
            const int64_t cell =
                mpm_particle_cell(&GRID, 1, now->position[1][p], HALF_SIZE) * GRID.cells[0] +
                mpm_particle_cell(&GRID, 0, now->position[0][p], HALF_SIZE);
            ck_assert_msg(cell > last || (cell == last && now->id[p - 1] < now->id[p]),
                          "particle %u of cell %lld comes after cell %lld", now->id[p],
                          (long long)cell, (long long)last);
            last = cell;
        }
        assert_values(now, MPM_PARTICLE_LASTING_COUNT, now->id);
    }
    mpm_arena_free(&set.arena);
}
END_TEST

/* Copies of particles of `from`, beginning at `first`; those beyond `count` are the first one. */
static void assert_tail(const struct fast_tail *tail, const struct mpm_particles *from,
                        size_t first, size_t count)
{
    FOR_ARRAYS(from, field, k)
    for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const bool is_free = lane >= count;
        const double value = read_value(&tail->particles, field, k, lane);
        const double copied = read_value(from, field, k, first + (is_free ? 0 : lane));
        const double expected = is_free && field == MPM_PARTICLE_MASS ? 0.0 : copied;
        ck_assert_msg(value == expected, "%s %zu in lane %zu is %.17g, expected %.17g",
                      mpm_particle_rows[field].info.name, k, lane, value, expected);
    }
}

START_TEST(the_last_vector_has_every_field_and_gives_back_its_own_particles_alone)
{
    struct set set = set_open(_i);
    struct mpm_particles *const now = &set.now;
    fill(now);
    for (size_t count = 1; count < MPM_VECTOR_SIZE && count <= now->count; count++) {
        const size_t first = now->count - count;
        struct fast_tail tail;
        mpm_fast_tail_fill(&tail, now, first, count);
        assert_tail(&tail, now, first, count);
        FOR_ARRAYS(now, field, k)
        for (size_t lane = 0; lane < MPM_VECTOR_SIZE; lane++)
            if (!mpm_particle_rows[field].info.integer)
                write_value(&tail.particles, field, k, lane, -1.0 - (double)lane);
        mpm_fast_tail_write(&tail, now, first, count);
        FOR_ARRAYS(now, field, k)
        for (size_t p = 0; p < now->count; p++) {
            const bool given = p >= first && !mpm_particle_rows[field].info.integer;
            ck_assert(read_value(now, field, k, p) ==
                      (given ? -1.0 - (double)(p - first) : value_of((uint32_t)p, field, k)));
        }
        fill(now);
    }
    mpm_arena_free(&set.arena);
}
END_TEST

/* Kernels use members by name, everything else the table: both are the same arrays. */
START_TEST(members_are_the_arrays_of_the_table)
{
    struct set set = set_open(CASES - 1);
    const struct mpm_particles *const now = &set.now;
#define MPM_ROW(name, type, member, ...)                                                           \
    for (size_t k = 0; k < mpm_particle_rows[MPM_PARTICLE_##name].info.components; k++)            \
        ck_assert(((type *const *)(const void *)&now->member)[k] ==                                \
                  (type *)mpm_particle_array(now, MPM_PARTICLE_##name, k));
    MPM_PARTICLE_FIELDS(MPM_ROW)
#undef MPM_ROW
    mpm_arena_free(&set.arena);
}
END_TEST

START_TEST(rigid_particles_have_places_velocities_and_names)
{
    struct mpm_rigid_particles rigid;
    struct mpm_arena arena = {.base = NULL};
    mpm_rigid_particles_layout(&rigid, 3, &arena);
    ck_assert_int_eq(mpm_arena_allocate(&arena, NULL), MPM_OK);
    mpm_rigid_particles_layout(&rigid, 3, &arena);
    const struct mpm_particles set = mpm_rigid_particles_set(&rigid);
    const uint8_t expected[MPM_PARTICLE_FIELD_COUNT] = {
        [MPM_PARTICLE_ID] = 1,
        [MPM_PARTICLE_BODY] = 1,
        [MPM_PARTICLE_POSITION] = 2,
        [MPM_PARTICLE_VELOCITY] = 2,
    };
    ck_assert_mem_eq(set.components, expected, sizeof expected);
    ck_assert_ptr_eq(set.velocity[1], rigid.velocity[1]);
    ck_assert_ptr_nonnull(rigid.velocity[1]);
    mpm_arena_free(&arena);
}
END_TEST

Suite *suite_particles(void)
{
    Suite *suite = suite_create("particles");
    TCase *table = tcase_create("table");
    tcase_add_loop_test(table, particles_have_the_fields_that_are_needed_and_memory_for_no_other, 0,
                        CASES);
    tcase_add_loop_test(table, the_last_good_state_keeps_what_changes_and_cannot_be_computed, 0,
                        CASES);
    tcase_add_loop_test(table, every_field_stays_with_its_particle_in_the_sort, 0, CASES);
    tcase_add_loop_test(table, the_last_good_state_leaves_all_else_alone, 0, CASES);
    tcase_add_loop_test(
        table, the_last_vector_has_every_field_and_gives_back_its_own_particles_alone, 0, CASES);
    tcase_add_test(table, members_are_the_arrays_of_the_table);
    tcase_add_test(table, rigid_particles_have_places_velocities_and_names);
    suite_add_tcase(suite, table);
    return suite;
}
