/* What a run prints while it runs and at its end: a line for each case and what failed, or a table
 * of all checks; with a progress bar on a terminal.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_CONSOLE_H
#define VERIFICATION_SUITE_CONSOLE_H

#include "verification/records/records.h"
#include "verification/suite/console_cases.h"
#include "verification/suite/judge.h"
#include "verification/suite/plan.h"

#include <stdio.h>

struct console {
    FILE *out;
    bool terminal; /* progress bar and colours */
    bool verbose;  /* a line for each check */
    const struct plan *plan;
    struct console_cases *cases;
    int name_width, value_width, band_width;
};

/* Fits the columns to the plan and prints the table's head, if there is one. */
void console_begin(struct console *console, const struct plan *plan);
/* What the programs took in an earlier run; what ended before is kept, and time counts from now. */
void console_expect(const struct console *console, const json_t *measurements);
void console_start(const struct console *console);
/* Frees what console_begin made; nothing was begun: does nothing. */
void console_clear(struct console *console);

void console_progress(const struct console *console, size_t done, size_t total);
/* The lines of a job's checks, or of those that failed; then that of the case, if all of it has
 * ended. */
void console_finished(const struct console *console, size_t job, const struct job_result *result);
/* A line of its own. */
void console_say(const struct console *console, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* States which quantities were measured that no case checks or compares (unchecked.h), if any. */
void console_unchecked(const struct console *console, const GPtrArray *quantities);

/* Failures, expected failures, where the report is (`output` NULL: there is none whole),
 * and the last line `N passed, N failed, N skipped`. */
void console_end(struct console *console, const struct records *records, const char *output);

#endif
