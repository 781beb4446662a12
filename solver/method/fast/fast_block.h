/* Fast kernels: a strip in blocks of particles, and what a strip sums up. Functions
 * here are compiled once; vectors stay out of their arguments.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_BLOCK_H
#define MPM_METHOD_FAST_BLOCK_H

#include "method/fast/fast_constants.h"

#include <float.h>

/* Vectors that go through the stages of a pass together. */
enum { MPM_BLOCK_VECTORS = 4 };

struct fast_patches;

struct fast_sums {
    mpm_vector kinetic, wave, diffusivity;
    mpm_vector low[2], high[2]; /* hull of the domains */
    const struct mpm_state *state;
    struct mpm_strip *strip;
    /* of particles with additional fields in their stencils: fast_patches.h; else NULL */
    struct fast_patches *patches;
};

/* All that is known of one block of particles of one body. */
struct fast_block {
    const struct fast_constants *k;
    const struct mpm_particles *particles;
    size_t first; /* particle, */
    size_t end;   /* the vectors after it stop there */
    struct fast_sums *sums;
    mpm_fast_update *update; /* of their law; NULL in passes without a stress update */
    bool moves;              /* velocities are updated in the last pass */
    bool hoop_radius;        /* r moves with r_p sum T v_r */
};

/* NOLINTBEGIN(bugprone-macro-parentheses): p and v are names that the loop declares. */
#define FOR_VECTORS(block, p, v)                                                                   \
    for (size_t p = (block)->first, v = 0; p < (block)->end; p += MPM_VECTOR_SIZE, v++)
/* NOLINTEND(bugprone-macro-parentheses) */

MPM_INLINE void load_deformation(const struct mpm_particles *particles, size_t p,
                                 mpm_vector f[MPM_GRADIENT_SIZE])
{
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        f[i] = mpm_load(particles->deformation[i] + p);
}

MPM_INLINE mpm_vector determinant_vector(const mpm_vector f[MPM_GRADIENT_SIZE])
{
    return (f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX]) * f[MPM_ZZ];
}

/* Constants of the particles of `body`; `part` of the time step for the stress update. */
void mpm_fast_constants(const struct mpm_state *state, uint32_t body, double part,
                        struct fast_constants *constants);

/* F of a block's particles at the end of an update. */
struct fast_deformations {
    double f[MPM_GRADIENT_SIZE][MPM_BLOCK_VECTORS * MPM_VECTOR_SIZE];
};
/* Gives particles first..end - 1 that F and its stress, `part` of the time step later; without it
 * (NULL) the stress of the F at hand. They may be the copies of a tail. */
void mpm_fast_update_particles(struct fast_sums *sums, double part,
                               const struct mpm_particles *particles, size_t first, size_t end,
                               const struct fast_deformations *next);

/* The end of the run of particles of one body that begins at `begin`. */
size_t mpm_fast_run_end(const struct mpm_state *state, size_t begin, size_t end);

/* Of a run: particles up to `end`, all of them in spans with packed fields or none; whole vectors
 * of the run, as without fields. */
struct fast_piece {
    size_t end;
    bool in_fields;
};
/* The piece from `begin` on; *next: the first span of the strip to look at, at first 0. */
struct fast_piece mpm_fast_piece_at(const struct mpm_state *state, int64_t strip,
                                    const struct mpm_span *run, size_t begin, size_t *next);

/* The last particles of a run, fewer than a vector: copies that fill one, its free
 * places taken by the first one again with mass zero, which adds nothing. */
union fast_tail_value {
    double number[MPM_VECTOR_SIZE];
    uint32_t index[MPM_VECTOR_SIZE];
};
struct fast_tail {
    struct mpm_particles particles;
    union fast_tail_value values[MPM_PARTICLE_ARRAYS];
};
void mpm_fast_tail_fill(struct fast_tail *tail, const struct mpm_particles *particles, size_t first,
                        size_t count);
void mpm_fast_tail_write(const struct fast_tail *tail, const struct mpm_particles *particles,
                         size_t first, size_t count);

/* Four particles of which some failed: finds and records it. */
void mpm_fast_report_velocity(struct mpm_strip *strip, const struct mpm_particles *particles,
                              size_t p);
void mpm_fast_report_stress(struct mpm_strip *strip, const struct mpm_particles *particles,
                            size_t p, const double j[MPM_VECTOR_SIZE],
                            const double wave_speed_squared[MPM_VECTOR_SIZE]);
/* position, step and reach along both axes */
void mpm_fast_report_position(const struct mpm_state *state, struct mpm_strip *strip,
                              const struct mpm_particles *particles, size_t p,
                              const double placement[6][MPM_VECTOR_SIZE]);

#endif
