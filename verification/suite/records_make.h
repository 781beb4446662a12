/* The records of a run that has just ended.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_RECORDS_MAKE_H
#define VERIFICATION_SUITE_RECORDS_MAKE_H

#include "verification/records/records.h"
#include "verification/suite/judge.h"
#include "verification/suite/plan.h"

struct record_context {
    const char *output; /* folder: the ends of logs are read from it */
    const char *command;
    const struct plan_selection *selection;
    enum mpm_kernels kernels; /* as selected */
    unsigned jobs;
    const char *started; /* UTC, ISO 8601 */
    double seconds;
    const char *incomplete; /* why programs of the plan have not ended; NULL: all have */
};

/* Builds the records of a finished run; results[i] belongs to plan->jobs[i]. */
struct records records_make(const struct plan *plan, const struct job_result *results,
                            const struct record_context *context);

/* One check as an object; a missing or non-finite value is null. */
json_t *record_check(const struct planned_job *job, const struct case_check *check,
                     const struct check_verdict *judged, double seconds);

/* The quantities of a finished run, as lines of measurements.jsonl. */
json_t *measurement_records(const struct plan *plan, const struct job_result *results);

#endif
