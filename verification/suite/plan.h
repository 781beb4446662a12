/* The plan: which jobs (case x variant) a run consists of, and which checks it owes,
 * from the declarations alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_PLAN_H
#define VERIFICATION_SUITE_PLAN_H

#include "verification/cases/catalogue.h"

#include <glib.h>

struct planned_job {
    const struct catalogue_case *entry;
    const struct case_variant *variant;
    char *unfinished; /* folder for what a later process may go on from; NULL: none */
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
    const char *case_globs, *variant_globs; /* joined by commas; NULL selects all */
    const char *only_file;                  /* that `only` was read from */
    GHashTable *only;                       /* texts CASE/VARIANT; NULL selects all */
};

/* The pairs CASE/VARIANT of a file, one a line; empty lines are passed over. MPM_BAD_INPUT if it
 * cannot be read or has none. Release with g_hash_table_unref. */
enum mpm_status plan_read_only(const char *path, GHashTable **only, struct mpm_error *error);

/* MPM_BAD_INPUT with the nearest name if a pattern of a list joined by commas (NULL: none) matches
 * no case, or no variant of the cases. */
enum mpm_status plan_check_globs(const struct catalogue *catalogue, const char *case_globs,
                                 const char *variant_globs, struct mpm_error *error);

/* MPM_BAD_INPUT if the selection holds no check. Release with plan_clear. */
enum mpm_status plan_make(const struct catalogue *catalogue, const struct plan_selection *selection,
                          struct plan *plan, struct mpm_error *error);
/* Reads the scene of each job that a method was made into: MPM_BAD_INPUT names case, method
 * and the scene's objection to it, before anything runs. */
enum mpm_status plan_check_methods(const struct plan *plan, struct mpm_error *error);

void plan_clear(struct plan *plan);

#endif
