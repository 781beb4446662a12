/* What a field's file gives, and the list of fields: the inner side of manufactured.h.
 *
 * A new field is one file, field_<name>.c, and one line of the list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_MANUFACTURED_FIELD_H
#define VERIFICATION_EXACT_MANUFACTURED_FIELD_H

#include "verification/exact/manufactured/jet.h"
#include "verification/exact/manufactured/manufactured.h"

#define MANUFACTURED_PI 3.14159265358979323846
enum { MANUFACTURED_SWINGS = 2 };

struct manufactured_field {
    const char *name;
    struct manufactured_parameter parameter[MANUFACTURED_PARAMETERS]; /* to a name of NULL */
    /* Sets domain, edges, period, end, and the field's own constants from parameters and material;
     * all are zero before. */
    void (*prepare)(struct manufactured_problem *problem);
    /* Functions of time alone, which all places have in common: found once for many of them. */
    void (*swing)(const struct manufactured_problem *problem, struct jet time,
                  struct jet swing[MANUFACTURED_SWINGS]);
    /* u of the particle that started at `place`, from them; 0 at t = 0. */
    void (*displacement)(const struct manufactured_problem *problem, const struct jet place[2],
                         const struct jet swing[MANUFACTURED_SWINGS], struct jet u[2]);
};

/* Fills the error with one line; returns MPM_BAD_INPUT. */
enum mpm_status manufactured_refuse(struct mpm_error *error, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* field_<name>.c each; the number in the catalogue's family M */
#define MANUFACTURED_FIELDS(FIELD)                                                                 \
    FIELD(axis_aligned)   /* M1 */                                                                 \
    FIELD(expanding_ring) /* M2 */                                                                 \
    FIELD(vortex)         /* M3 */                                                                 \
    FIELD(cylinder)       /* M4 */                                                                 \
    FIELD(bar)            /* the tutorial's */

/* Fields and what evaluates them are compiled for each level of instructions; results are the same
 * bits. MANUFACTURED_OF_LEVEL(name) is a name in the level that a file is compiled for. */
#ifndef MANUFACTURED_LEVEL
#define MANUFACTURED_LEVEL baseline
#endif
#define MANUFACTURED_JOIN(name, level) manufactured_##name##_##level
#define MANUFACTURED_NAME(name, level) MANUFACTURED_JOIN(name, level)
#define MANUFACTURED_OF_LEVEL(name)    MANUFACTURED_NAME(name, MANUFACTURED_LEVEL)

struct manufactured_kernels {
    const struct manufactured_field *const *fields; /* in the order of the list */
    void (*evaluate)(const struct manufactured_problem *problem, const double place[2], double time,
                     struct manufactured_state *state);
    void (*load)(void *load, double time, size_t count, const uint32_t id[],
                 double *const force[2]);
};
extern const struct manufactured_kernels manufactured_kernels_baseline, manufactured_kernels_v3;

/* The levels that this build and this machine have, the widest first; NULL past the last. */
const struct manufactured_kernels *manufactured_kernels_at(size_t index);

#endif
