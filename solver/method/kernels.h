/* The two sets of kernels: which passes over the particles a step consists of, and which
 * set a scene gets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_KERNELS_H
#define MPM_METHOD_KERNELS_H

#include "model/scene.h"

/* One pass over the particles of a strip; see mpm_strips_run. */
typedef void mpm_pass(void *state, int64_t strip, int worker);

/* The passes of one step, in their order; NULL: nothing to do there. */
struct mpm_passes {
    mpm_pass *to_grid;       /* Task 1; with the stress at hand also Task 3 */
    mpm_pass *stress_before; /* Tasks 2 and 3 of USF and USAVG */
    mpm_pass *to_particles;  /* Task 5, velocities; with (31) for MUSL and USAVG */
    mpm_pass *finish;        /* Task 6 of USL, MUSL and USAVG; positions */
    mpm_pass *recompute;     /* not part of a step: stress and domain of the F at hand */
    mpm_pass *exchange;      /* of any values, see method/transfer/exchange.h */
};

struct mpm_state;

/* What a simulation was created with. */
struct mpm_kernel_choice {
    const struct mpm_passes *passes;
    /* Of scenes with cracks whose passes are mpm_split_passes; else NULL. */
    const struct mpm_passes *plain, *general;
    mpm_pass *gather_rows; /* makes masses whole where to_grid leaves them in pieces; or NULL */
    mpm_pass *start_rows;  /* Task 2, velocities of the nodes from what to_grid leaves there */
    /* What transfers other than FLIP do to nodes and particles before to_particles, in this
     * order; NULL: nothing. `smooth` works on all of the grid. */
    void (*smooth)(struct mpm_state *state, int workers);
    mpm_pass *flip_rows, *flip_particles;
    const char *name;   /* "fast" or "reference" */
    const char *reason; /* why this set */
    const char *simd;   /* the instructions it uses */
};

/* Looks the passes up for a scene. MPM_BAD_INPUT: a level of SIMD was asked for that build
 * or machine do not have, or no set of kernels at all. */
enum mpm_status mpm_kernels_choose(const struct mpm_scene *scene,
                                   const struct mpm_simulation_options *options,
                                   struct mpm_kernel_choice *choice, struct mpm_error *error);

#endif
