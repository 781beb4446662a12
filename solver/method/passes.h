/* Types of the passes that a step consists of, and of the set that a scene has.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_PASSES_H
#define MPM_METHOD_PASSES_H

#include <stdbool.h>
#include <stdint.h>

/* One pass over the particles of a strip; see mpm_strips_run. */
typedef void mpm_pass(void *state, int64_t strip, int worker);

/* Defines a pass that is `body(state, strip, ...)`, one of several with other constants. */
#define MPM_PASS(name, body, ...)                                                                  \
    void name(void *state, int64_t strip, int worker)                                              \
    {                                                                                              \
        (void)worker;                                                                              \
        (body)(state, strip, __VA_ARGS__);                                                         \
    }

/* Passes over a scalar that is conducted: see method/transport/transport_passes.h. */
struct mpm_scalar_passes {
    mpm_pass *spread;             /* content and capacity of the nodes */
    mpm_pass *conduct;            /* their inflow, by sources and conduction */
    mpm_pass *conduct_undeformed; /* the same, where F = 1 */
    mpm_pass *update;             /* values of the particles, */
    mpm_pass *update_and_spread;  /* and with them the content of the next step */
    mpm_pass *filter;
};

/* The passes of one step, in their order; NULL: nothing to do there. */
struct mpm_passes {
    mpm_pass *to_grid;       /* Task 1; with the stress at hand also Task 3 */
    mpm_pass *stress_before; /* Tasks 2 and 3 of USF and USAVG */
    mpm_pass *to_particles;  /* Task 5, velocities; with (31) for MUSL and USAVG */
    mpm_pass *finish;        /* Task 6 of USL, MUSL and USAVG; positions */
    mpm_pass *recompute;     /* not part of a step: stress and domain of the F at hand */
    mpm_pass *project;       /* of any values: see method/transfer/projection.h */
    const struct mpm_scalar_passes *scalar; /* those of the fast kernels */
    /* The only scalar goes along: to_grid spreads it, finish updates it, and the first one between
     * them conducts, where there is one. */
    bool with_scalar;
};

struct mpm_state;

/* What a simulation was created with. */
struct mpm_kernel_choice {
    const struct mpm_passes *passes;
    mpm_pass *gather_rows; /* makes masses whole where to_grid leaves them in pieces; or NULL */
    mpm_pass *start_rows;  /* Task 2, velocities of the nodes from what to_grid leaves there */
    /* What transfers other than FLIP do to nodes and particles before to_particles, in this
     * order; NULL: nothing. `smooth` works on all of the grid. */
    void (*smooth)(struct mpm_state *state, int workers);
    mpm_pass *flip_rows, *flip_particles;
    const struct mpm_scalar_passes *scalar;
    const char *name;   /* "fast" or "reference" */
    const char *reason; /* why this set */
    const char *simd;   /* the instructions it uses */
};

#endif
