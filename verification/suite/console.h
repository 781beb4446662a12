/* What a run prints while it runs and at its end: a table and a progress bar on a
 * terminal, plain lines in a pipe.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_CONSOLE_H
#define VERIFICATION_SUITE_CONSOLE_H

#include "verification/records/records.h"
#include "verification/suite/judge.h"
#include "verification/suite/plan.h"

#include <stdio.h>

struct console {
    FILE *out;
    bool terminal; /* progress bar and colours */
    const struct plan *plan;
    int name_width, value_width, band_width;
};

/* Fits the columns to the plan and prints the table's head. */
void console_begin(struct console *console, const struct plan *plan);

void console_progress(const struct console *console, size_t done, size_t total);
/* The lines of a job's checks. */
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
