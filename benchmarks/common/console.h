/* What mpm-bench shows while it runs: a plain table; on a terminal, a progress line below.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_CONSOLE_H
#define BENCHMARKS_COMMON_CONSOLE_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

struct bench_console {
    FILE *out;
    bool terminal; /* out is one */
};

struct bench_records;

/* Prints a line if other programs used the machine when the run began. */
void bench_console_load(struct bench_console *console, const struct bench_records *records);

/* The heading of a group. */
void bench_console_group(struct bench_console *console, const char *title, const char *description);

/* A row for a line of bench.jsonl: point, quantity, value with interval or verdict. */
void bench_console_line(struct bench_console *console, const json_t *line);

/* "12 of 40: WHAT", overwritten by what comes next; nothing if not on a terminal. */
void bench_console_progress(struct bench_console *console, size_t done, size_t total,
                            const char *what);

/* Where the results are. */
void bench_console_end(struct bench_console *console, const char *folder);

#endif
