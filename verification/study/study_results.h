/* What a study has found, from the records of its runs alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_STUDY_STUDY_RESULTS_H
#define VERIFICATION_STUDY_STUDY_RESULTS_H

#include "verification/records/records.h"
#include "verification/study/study.h"

enum study_state { STUDY_DONE, STUDY_FAILED, STUDY_MISSING };
const char *study_state_name(enum study_state state);

struct study_value {
    double value, reference; /* NaN: none */
    double error;            /* magnitude; NaN: none */
    double order;            /* of this level and the one before; NaN: none */
};

struct study_row {
    const struct study_run *run;
    enum study_state state;
    char *reason; /* of one that is not done, or has no number for a measure; NULL: none */
    double cpu_seconds, particle_steps;
    struct study_value *values; /* of each measure */
};

/* A measure over the levels of a variant. */
struct study_order {
    double order;      /* NaN: none, see `reason` */
    double half_width; /* of its interval of 95 % confidence (orders.h); of differences: how far the
                          order of the three levels before is from it; NaN: not known */
    size_t levels;     /* that it is made of */
    double limit;      /* Richardson's; NaN: none */
    double index;      /* grid-convergence index of the finest level, without unit; NaN: none */
    const char *kind;  /* asymptotic, ...: order_class_name; "" of differences */
    const char *reason;
    bool judged, holds; /* the study states an interval; the order lies in it */
};

struct study_results {
    const struct study *study;
    GArray *runs;               /* struct study_run */
    struct study_row *rows;     /* of each run */
    size_t groups;              /* variants */
    struct study_order *orders; /* groups * measures */
    size_t failed, missing, out_of_order;
};

/* MPM_BAD_INPUT as study_runs. The study has to outlive the results. */
enum mpm_status study_results_make(const struct study *study, const struct records *records,
                                   struct study_results *results, struct mpm_error *error);
void study_results_clear(struct study_results *results);

#endif
