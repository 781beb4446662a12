/* One run of a manufactured solution on one level, and its errors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_MANUFACTURED_LEVEL_H
#define VERIFICATION_PROGRAMS_MANUFACTURED_LEVEL_H

#include "verification/exact/manufactured/manufactured.h"
#include "verification/measures/error_norms.h"
#include "verification/programs/programs.h"

enum manufactured_quantity {
    MANUFACTURED_DISPLACEMENT,
    MANUFACTURED_VELOCITY,
    MANUFACTURED_DEFORMATION, /* F - I, so that its size is that of strains */
    MANUFACTURED_STRESS,      /* Cauchy */
    MANUFACTURED_QUANTITIES,
};
/* What names of quantities end with: "_u", "_v", "_F", "_stress". */
extern const char *const manufactured_suffix[MANUFACTURED_QUANTITIES];

/* What is to be run. */
struct manufactured_level {
    unsigned refine;    /* grid.refine */
    unsigned particles; /* a side of each cell */
    unsigned steps;     /* to the end */
    unsigned looks; /* instants at which errors are measured, the last at the end; divides steps */
    double end;     /* time */
    double margin;  /* particles that start nearer than this to an edge are not measured */
    bool at_once;   /* start with all quantities of time 0, whatever the scheme requires */
    const char *series; /* of the fields at the end, or NULL */
};

/* What came of it. */
struct manufactured_outcome {
    bool finished; /* false: the guard ended the run, its message is a note of the variant */
    /* of the computed displacement u in the exact one e: sum m u.e / sum m e.e over particles and
     * looks */
    double amplitude;
    /* of the particles measured, weighted by mass, over all sampled times; NaN if not finished */
    struct error_norms norms[MANUFACTURED_QUANTITIES];
};

/* Starts the variant's scene with the field's velocities and deformation gradients, each at the
 * time that the scheme requires (mpm_scene_lags), drives it with the field's body force in `steps`
 * equal steps, and compares each quantity at each sampled time with the exact one of its own time.
 */
enum mpm_status manufactured_level_run(struct measurement *measurement,
                                       const struct manufactured_problem *problem,
                                       const struct manufactured_level *level,
                                       struct manufactured_outcome *outcome,
                                       struct mpm_error *error);

#endif
