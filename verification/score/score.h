/* Scores: a solver's results against a bundle, judged and reported like the suite's own runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_SCORE_H
#define VERIFICATION_SCORE_SCORE_H

#include "verification/score/bundle.h"
#include "verification/suite/console.h"

/* Appends a row of rows.h for each criterion: its agreement, or why there is none, and notes on
 * where each is worst and on what was not read. MPM_BAD_INPUT: a column is missing; an instant of
 * the bundle has no results; points are outside the body, or too few: none in one of four equal
 * parts along an axis. */
enum mpm_status score_rows(const struct bundle *bundle, const struct score_table *results,
                           GString *rows, struct mpm_error *error);

struct score_options {
    const char *bundle, *results, *name; /* of the solver: NULL takes that of the results */
    const char *output, *reports;
    const char *command; /* as typed */
};

/* Reads both, judges, writes checks.jsonl, measurements.jsonl and the report to `output`, which is
 * not touched before both are read. */
enum mpm_status score_run(const struct score_options *options, struct console *console,
                          struct record_counts *counts, struct mpm_error *error);

#endif
