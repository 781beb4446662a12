/* The history of a run: values of earlier runs and benchmarks, from oldest to newest, read from
 * their folders. reports/README.md has the format.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_RECORDS_HISTORY_H
#define VERIFICATION_RECORDS_HISTORY_H

#include "verification/common/record_shape.h"
#include "verification/records/records.h"

/* Fields of history.json. */
extern const struct record_field history_fields[];

/* Reads the folders, in their order, and gives the object of history.json. A folder holds
 * checks.jsonl, bench.jsonl or both, or has folders verify and bench that do. `own` is the folder
 * of the run itself: benchmarks beside it are its own. MPM_BAD_INPUT: a folder with neither, or
 * results that are not as described. */
enum mpm_status history_gather(const char *own, const char *const *folders, json_t **history,
                               struct mpm_error *error);

/* The numbers of one key over all runs, the run's own number last; NaN where there is none. `what`
 * is "values" or "benchmarks". `numbers` has room for history_length(). */
size_t history_length(const json_t *history);
void history_series(const json_t *history, const char *what, const char *key, double own,
                    double *numbers);

#endif
