/* One line for each case of a run, and how long the run has to go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_CONSOLE_CASES_H
#define VERIFICATION_SUITE_CONSOLE_CASES_H

#include "verification/suite/plan.h"

#include <jansson.h>

struct console_case {
    const char *name;
    size_t jobs, checks, red, skipped; /* jobs: still to end */
    double seconds;
};

struct console_cases {
    struct console_case *rows; /* in the order of the plan */
    size_t count, done;
    size_t *row_of;    /* by job */
    double *weight_of; /* by job: what it took in an earlier run, or an average */
    double weight, weight_done, weight_kept;
    gint64 start; /* microseconds */
};

struct console_cases *console_cases_make(const struct plan *plan);
void console_cases_free(struct console_cases *cases);

/* What programs took in an earlier run, by its measurements of cpu_seconds. */
void console_cases_expect(struct console_cases *cases, const struct plan *plan,
                          const json_t *measurements);

/* Time counts from now on: what has ended before was kept from an earlier run. */
void console_cases_start(struct console_cases *cases);

/* A job of the plan has ended; its case, if that was the last of it, or NULL. */
struct console_case *console_cases_finish(struct console_cases *cases, size_t job, double seconds);

/* "12 of 80 cases, 2:10 to go": the rest at the speed so far; g_free. */
char *console_cases_text(const struct console_cases *cases);

#endif
