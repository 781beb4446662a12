/* The fast kernels of one shape family and one level of SIMD: this file is compiled for each
 * pair, with FAST_FAMILY (a name of method.shape), FAST_SHAPE (the same in capitals), FAST_LEVEL
 * (baseline, v3), and FAST_AFFINE where the family has kernels of APIC.
 *
 * A kernel is one of the bodies in fast_passes.h with constants: those that a loop over nodes or
 * vectors would look at each time. What a pass looks at once for a block is no instance of its own:
 * whether velocities and stresses are updated in the last pass, whether r moves with S or with T,
 * whether domains are kept. Laws are not part of the kernels: see fast_laws.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/fast/fast.h"
#include "method/fast/fast_laws.h"
#include "method/fast/fast_passes.h"

enum { BLOCK = MPM_BLOCK_VECTORS * MPM_VECTOR_SIZE, NO_UPDATE = -1 };

/* The stress update of a body; `kind`: a geometry, or MPM_FAST_RECOMPUTE. */
MPM_INLINE mpm_fast_update *update_of(const struct mpm_body *body, int kind)
{
    const struct mpm_material_law *const law =
        mpm_fast_body_has_vectors(body->given) ? body->material.law : NULL;
    const struct mpm_fast_law *row = FAST_NAME(laws);
    while (row->law != law)
        row++;
    /* cppcheck-suppress CastIntegerToAddressAtReturn ; a function, not an integer */
    return row->update[kind];
}

typedef void fast_work(const struct fast_spec *spec, const struct fast_block *block);

/* The block of whole vectors from `begin` on, or the last particles, fewer than a vector, as
 * copies. Returns how many particles it has. */
MPM_INLINE size_t begin_block(struct fast_block *block, const struct mpm_particles *particles,
                              size_t begin, size_t end, struct fast_tail *tail)
{
    const size_t whole = (end - begin) / MPM_VECTOR_SIZE * MPM_VECTOR_SIZE;
    const size_t count = whole == 0 ? end - begin : whole < BLOCK ? whole : BLOCK;
    block->first = whole == 0 ? 0 : begin;
    block->end = block->first + count;
    block->particles = whole == 0 ? &tail->particles : particles;
    if (whole == 0)
        mpm_fast_tail_fill(tail, particles, begin, count);
    if (block->sums->patches != NULL)
        fast_patches_take(block->sums->patches, begin, count);
    return count;
}

/* Particles of one body, block by block. Between two blocks there is one branch, as long as the
 * next one has whole vectors and neither has patches. */
MPM_INLINE void run_blocks(const struct fast_spec *spec, struct fast_block *block, size_t begin,
                           size_t end, fast_work *work)
{
    const struct mpm_particles *const particles = block->particles;
    struct fast_patches *const patches = block->sums->patches;
    struct fast_tail tail;
    size_t count = begin_block(block, particles, begin, end, &tail);
    for (;;) {
        work(spec, block);
        const size_t rest = end - begin - count;
        if ((patches == NULL) & (rest >= MPM_VECTOR_SIZE)) {
            begin += count;
            count = rest < BLOCK ? rest / MPM_VECTOR_SIZE * MPM_VECTOR_SIZE : BLOCK;
            block->first = begin;
            block->end = begin + count;
            continue;
        }
        if (patches != NULL)
            fast_patches_end(patches);
        if (block->particles == &tail.particles)
            mpm_fast_tail_write(&tail, particles, begin, count);
        if (rest == 0)
            break;
        begin += count;
        count = begin_block(block, particles, begin, end, &tail);
    }
    block->particles = particles;
}

/* A run of particles of one body, in pieces with and without patches. */
MPM_INLINE void run_pieces(const struct fast_spec *spec, const struct mpm_state *state,
                           int64_t index, const struct fast_traffic *traffic,
                           const struct mpm_span *run, struct fast_constants *k,
                           struct fast_block *block, fast_work *work)
{
    const bool in_pieces = traffic != NULL && state->strips[index].span_count > 0;
    struct fast_patches patches;
    struct fast_piece piece = {run->end, false};
    if (in_pieces)
        fast_patches_open(&patches, state, k, traffic);
    for (size_t begin = run->begin, next = 0; begin < run->end; begin = piece.end) {
        if (in_pieces) {
            piece = mpm_fast_piece_at(state, index, run, begin, &next);
            fast_patches_aim(&patches, piece.in_fields, k);
        }
        block->sums->patches = piece.in_fields ? &patches : NULL;
        run_blocks(spec, block, begin, piece.end, work);
    }
    if (in_pieces)
        fast_patches_aim(&patches, false, k);
    block->sums->patches = NULL;
}

/* Of the particles of a run: takes their hull out of the sums. */
MPM_INLINE void take_extent(struct fast_sums *sums, struct mpm_extent *extent)
{
    for (int axis = 0; axis < 2; axis++) {
        const double low = mpm_smallest_lane(sums->low[axis]);
        const double high = mpm_largest_lane(sums->high[axis]);
        extent->low[axis] = low < extent->low[axis] ? low : extent->low[axis];
        extent->high[axis] = high > extent->high[axis] ? high : extent->high[axis];
        sums->low[axis] = mpm_splat(DBL_MAX);
        sums->high[axis] = mpm_splat(-DBL_MAX);
    }
}

/* What a pass changes of particles: their stress, by a part of the step, and where they are. */
struct fast_change {
    double part;
    int kind;                    /* of the stress update; NO_UPDATE: none */
    struct mpm_extents *extents; /* where particles are after the pass; NULL: they do not move */
};

static const struct fast_change no_change = {0.0, NO_UPDATE, NULL};

/* traffic: what the pass does with nodes; NULL: nothing. */
MPM_INLINE void run_strip(const struct fast_spec *spec, struct mpm_state *state, int64_t index,
                          const struct fast_change *change, const struct fast_traffic *traffic,
                          struct fast_sums *sums, fast_work *work)
{
    struct mpm_strip *const strip = &state->strips[index];
    const mpm_vector zero = mpm_splat(0.0), most = mpm_splat(DBL_MAX);
    struct mpm_span run = {.end = strip->begin};
    *sums = (struct fast_sums){zero, zero, zero, {most, most}, {-most, -most}, state, strip, NULL};
    while (run.end < strip->end) {
        struct fast_constants k;
        struct fast_block block = {.k = &k,
                                   .particles = &state->particles,
                                   .sums = sums,
                                   .moves = !state->order->extrapolate,
                                   .hoop_radius = state->scene->radius_update == MPM_RADIUS_HOOP};
        run.begin = run.end;
        run.end = mpm_fast_run_end(state, run.begin, strip->end);
        const uint32_t body = state->particles.body[run.begin];
        mpm_fast_constants(state, body, change->part, &k);
        if (change->kind != NO_UPDATE)
            block.update = update_of(&state->bodies[body], change->kind);
        run_pieces(spec, state, index, traffic, &run, &k, &block, work);
        if (change->extents != NULL)
            take_extent(sums, &change->extents->of[state->bodies[body].layer]);
    }
}

static void recompute(void *state, int64_t strip, int worker)
{
    static const struct fast_spec spec = {.shape = FAST_SHAPE};
    static const struct fast_change change = {0.0, MPM_FAST_RECOMPUTE, NULL};
    struct fast_sums sums;
    (void)worker;
    run_strip(&spec, state, strip, &change, NULL, &sums, block_recompute);
}

/* --------------------------------------------------------------- the passes */

/* The strip's has what was found particle by particle. */
MPM_INLINE void set_wave(const struct fast_sums *sums)
{
    const double largest = mpm_largest_lane(sums->wave);
    if (largest > sums->strip->wave_speed_squared)
        sums->strip->wave_speed_squared = largest;
}

static const unsigned scalar_spreads = 1u << FAST_CONTENT | 1u << FAST_CAPACITY;

MPM_INLINE void pass_to_grid(const struct fast_spec *spec, struct mpm_state *state, int64_t strip)
{
    const struct fast_traffic traffic = {.adds = 1u << FAST_SUM,
                                         .adds_single = (spec->force ? 1u << FAST_MASS : 0) |
                                                        (spec->scalars ? scalar_spreads : 0)};
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_to_grid);
}

MPM_INLINE void pass_stress_before(const struct fast_spec *spec, struct mpm_state *state,
                                   int64_t strip)
{
    const struct fast_traffic traffic = {
        .reads = 1u << FAST_GRADIENT,
        .adds = 1u << FAST_SUM,
        .reads_single = spec->conducts ? 1u << FAST_VALUE : 0,
        .adds_single = spec->conducts ? 1u << FAST_INFLOW : 0,
    };
    const struct fast_change change = {state->order->before, (int)state->scene->geometry, NULL};
    struct fast_sums sums;
    state->strips[strip].wave_speed_squared = 0.0;
    run_strip(spec, state, strip, &change, &traffic, &sums, block_stress_before);
    if (spec->conducts)
        sums.strip->diffusivity = mpm_largest_lane(sums.diffusivity);
    set_wave(&sums);
}

MPM_INLINE void pass_project(const struct fast_spec *spec, struct mpm_state *state, int64_t strip)
{
    const struct mpm_projection *const projection = state->projection;
    const struct fast_traffic traffic = {
        .reads = projection->from != NULL ? 1u << FAST_READ : 0,
        .adds = projection->to != NULL ? 1u << FAST_GRADIENT : 0,
    };
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_project);
}

MPM_INLINE void pass_spread_scalar(const struct fast_spec *spec, struct mpm_state *state,
                                   int64_t strip)
{
    const struct fast_traffic traffic = {.adds_single = scalar_spreads};
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_spread_scalar);
}

MPM_INLINE void pass_conduct(const struct fast_spec *spec, struct mpm_state *state, int64_t strip)
{
    const struct fast_traffic traffic = {.reads_single = 1u << FAST_VALUE,
                                         .adds_single = 1u << FAST_INFLOW};
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_conduct);
    sums.strip->diffusivity = mpm_largest_lane(sums.diffusivity);
}

MPM_INLINE void pass_update_scalar(const struct fast_spec *spec, struct mpm_state *state,
                                   int64_t strip)
{
    const struct fast_traffic traffic = {.reads_single = 1u << FAST_RESULT,
                                         .adds_single = spec->spreads ? 1u << FAST_CONTENT : 0};
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_update_scalar);
}

MPM_INLINE void pass_filter(const struct fast_spec *spec, struct mpm_state *state, int64_t strip)
{
    const struct fast_traffic traffic = {.reads_single = 1u << FAST_VALUE,
                                         .adds_single = 1u << FAST_RESULT};
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_filter);
}

MPM_INLINE void pass_to_particles(const struct fast_spec *spec, struct mpm_state *state,
                                  int64_t strip)
{
    const struct fast_traffic traffic = {
        .reads = 1u << FAST_READ,
        .adds = 1u << FAST_GRADIENT,
        .reads_single = spec->conducts ? 1u << FAST_VALUE : 0,
        .adds_single = spec->conducts ? 1u << FAST_INFLOW : 0,
    };
    struct fast_sums sums;
    run_strip(spec, state, strip, &no_change, &traffic, &sums, block_to_particles);
    sums.strip->kinetic_energy = mpm_sum_of_lanes(sums.kinetic);
    if (spec->conducts)
        sums.strip->diffusivity = mpm_largest_lane(sums.diffusivity);
}

MPM_INLINE void pass_finish(const struct fast_spec *spec, struct mpm_state *state, int64_t strip)
{
    const bool updates = state->order->after > 0.0;
    const struct fast_traffic traffic = {
        .reads =
            (updates ? 1u << FAST_GRADIENT : 0) | (state->order->extrapolate ? 0 : 1u << FAST_READ),
        .reads_single = spec->scalars ? 1u << FAST_RESULT : 0,
    };
    struct fast_sums sums;
    struct mpm_extents extents;
    const struct fast_change change = {state->order->after,
                                       updates ? (int)state->scene->geometry : NO_UPDATE, &extents};
    mpm_extents_begin(state, &extents);
    if (updates)
        state->strips[strip].wave_speed_squared = 0.0;
    run_strip(spec, state, strip, &change, &traffic, &sums, block_finish);
    if (!state->order->extrapolate)
        sums.strip->kinetic_energy = mpm_sum_of_lanes(sums.kinetic);
    if (updates)
        set_wave(&sums);
    if (sums.strip->failure.kind == MPM_NO_FAILURE)
        mpm_strip_set_boxes(state, sums.strip, &extents);
}

/* ------------------------------------------------------------- the instances */

#define KERNEL(body, name, ...)                                                                    \
    static void name(void *state, int64_t strip, int worker)                                       \
    {                                                                                              \
        static const struct fast_spec spec = {.shape = FAST_SHAPE, __VA_ARGS__};                   \
        (void)worker;                                                                              \
        body(&spec, state, strip);                                                                 \
    }

/* What all passes of mechanics are in. */
#define MECHANICS(plane, ...)                                                                      \
    KERNEL(pass_to_grid, plane##_momentum_force, .momentum = true, .force = true, __VA_ARGS__)     \
    KERNEL(pass_to_grid, plane##_momentum, .momentum = true, __VA_ARGS__)                          \
    KERNEL(pass_finish, plane##_finish, .finish = true, __VA_ARGS__)

/* Those that conduct, where a scalar goes along. */
#define GATHERING(plane, ...)                                                                      \
    KERNEL(pass_stress_before, plane##_stress_force, .force = true, __VA_ARGS__)                   \
    KERNEL(pass_to_particles, plane##_extrapolate, __VA_ARGS__)

/* Of APIC, where they spread momentum or read velocities. */
#ifdef FAST_AFFINE
#define AFFINE_KERNELS(plane, ...)                                                                 \
    MECHANICS(plane##_affine, .affine = true, __VA_ARGS__)                                         \
    KERNEL(pass_to_particles, plane##_affine_extrapolate, .affine = true, __VA_ARGS__)
#else
#define AFFINE_KERNELS(plane, ...)
#endif

#define ALONE .scalars = true, .alone = true

#define KERNELS(plane, ...)                                                                        \
    MECHANICS(plane, __VA_ARGS__)                                                                  \
    GATHERING(plane, __VA_ARGS__)                                                                  \
    MECHANICS(plane##_scalar, .scalars = true, __VA_ARGS__)                                        \
    GATHERING(plane##_scalar, .scalars = true, .conducts = true, __VA_ARGS__)                      \
    AFFINE_KERNELS(plane, __VA_ARGS__)                                                             \
    KERNEL(pass_project, plane##_project, __VA_ARGS__)                                             \
    KERNEL(pass_spread_scalar, plane##_spread, ALONE, __VA_ARGS__)                                 \
    KERNEL(pass_conduct, plane##_conduct, ALONE, .conducts = true, __VA_ARGS__)                    \
    KERNEL(pass_conduct, plane##_conduct_undeformed, ALONE, .conducts = true, .undeformed = true,  \
           __VA_ARGS__)                                                                            \
    KERNEL(pass_update_scalar, plane##_update, ALONE, __VA_ARGS__)                                 \
    KERNEL(pass_update_scalar, plane##_update_and_spread, ALONE, .spreads = true, __VA_ARGS__)     \
    KERNEL(pass_filter, plane##_filter, ALONE, __VA_ARGS__)                                        \
    static const struct mpm_scalar_passes plane##_passes = {                                       \
        plane##_spread, plane##_conduct,           plane##_conduct_undeformed,                     \
        plane##_update, plane##_update_and_spread, plane##_filter};

#define STEP(plane, last, first, before, back, with_scalar)                                        \
    {                                                                                              \
        first, before, back, last, recompute, plane##_project, &plane##_passes, with_scalar        \
    }

/* own: the kernels of mechanics. The second one of USAVG between the first and the last does not
 * conduct. */
#define ORDERS(plane, own, with_scalar)                                                            \
    {                                                                                              \
        [MPM_USL] = STEP(plane, own##_finish, own##_momentum_force, NULL, NULL, with_scalar),      \
        [MPM_MUSL] =                                                                               \
            STEP(plane, own##_finish, own##_momentum_force, NULL, own##_extrapolate, with_scalar), \
        [MPM_USF] =                                                                                \
            STEP(plane, own##_finish, own##_momentum, own##_stress_force, NULL, with_scalar),      \
        [MPM_USAVG] = STEP(plane, own##_finish, own##_momentum, own##_stress_force,                \
                           plane##_extrapolate, with_scalar),                                      \
        [MPM_USAVG_ONCE] =                                                                         \
            STEP(plane, own##_finish, own##_momentum, own##_stress_force, NULL, with_scalar),      \
    }

#define AFFINE_ORDERS(plane)                                                                       \
    {                                                                                              \
        [MPM_USL] =                                                                                \
            STEP(plane, plane##_affine_finish, plane##_affine_momentum_force, NULL, NULL, false),  \
        [MPM_MUSL] = STEP(plane, plane##_finish, plane##_affine_momentum_force, NULL,              \
                          plane##_affine_extrapolate, false),                                      \
        [MPM_USF] = STEP(plane, plane##_affine_finish, plane##_affine_momentum,                    \
                         plane##_stress_force, NULL, false),                                       \
        [MPM_USAVG] = STEP(plane, plane##_finish, plane##_affine_momentum, plane##_stress_force,   \
                           plane##_affine_extrapolate, false),                                     \
        [MPM_USAVG_ONCE] = STEP(plane, plane##_affine_finish, plane##_affine_momentum,             \
                                plane##_stress_force, NULL, false),                                \
    }

KERNELS(planar, .axisymmetric = false)
KERNELS(axisymmetric, .axisymmetric = true)

mpm_fast_family FAST_NAME(FAST_FAMILY) = {
    [MPM_FAST_WITHOUT_SCALAR] = {[MPM_FAST_PLANAR] = ORDERS(planar, planar, false),
                                 [MPM_FAST_AXISYMMETRIC] = ORDERS(axisymmetric, axisymmetric,
                                                                  false)},
    [MPM_FAST_WITH_SCALAR] = {[MPM_FAST_PLANAR] = ORDERS(planar, planar_scalar, true),
                              [MPM_FAST_AXISYMMETRIC] = ORDERS(axisymmetric, axisymmetric_scalar,
                                                               true)},
#ifdef FAST_AFFINE
    [MPM_FAST_AFFINE] = {[MPM_FAST_PLANAR] = AFFINE_ORDERS(planar),
                         [MPM_FAST_AXISYMMETRIC] = AFFINE_ORDERS(axisymmetric)},
#endif
};
