/* The plan: which jobs (case x variant) a run consists of, and which checks it owes,
 * from the declarations alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_PLAN_H
#define VERIFICATION_SUITE_PLAN_H

#include "verification/suite/catalogue.h"

struct planned_job {
    const struct catalogue_case *entry;
    const struct case_variant *variant;
};

struct planned_check {
    size_t job;
    const struct case_check *check;
};

struct plan {
    struct planned_job *jobs;
    size_t job_count;
    struct planned_check *checks; /* in the order of jobs */
    size_t check_count;
};

struct plan_selection {
    enum tier tier;
    const char *case_glob, *variant_glob; /* NULL selects all */
};

/* MPM_BAD_INPUT if the selection holds no check. Release with plan_clear. */
enum mpm_status plan_make(const struct catalogue *catalogue, const struct plan_selection *selection,
                          struct plan *plan, struct mpm_error *error);
/* Reads the scene of each job that a method was made into: MPM_BAD_INPUT names case, method
 * and what the scene says against it, before anything runs. */
enum mpm_status plan_check_methods(const struct plan *plan, struct mpm_error *error);

void plan_clear(struct plan *plan);

#endif
