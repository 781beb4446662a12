/* The report of mpm-bench: index.html, summary.md and figures, from bench.jsonl alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_REPORT_REPORT_H
#define BENCHMARKS_REPORT_REPORT_H

#include "mpm.h"

/* Renders index.html, summary.md and figures/ of `folder` from its bench.jsonl; the same
 * lines give the same bytes. A sentence names groups that are missing. MPM_BAD_INPUT:
 * no such results, or a line that is none (file and line). MPM_ENVIRONMENT_FAILED: gnuplot
 * is missing or a figure failed (all that can be rendered has been), or a file cannot be
 * written. */
enum mpm_status bench_report_write(const char *folder, struct mpm_error *error);

#endif
