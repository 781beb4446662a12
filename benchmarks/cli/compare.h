/* Two runs of mpm-bench against each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_CLI_COMPARE_H
#define BENCHMARKS_CLI_COMPARE_H

#include "mpm.h"

#include <stdio.h>

/* Prints what differs between the points that both folders have, B over A: results by the
 * ratio of their medians, called only beyond noise and 5 %; values by their ratio. The
 * machines and revisions are shown and whether they are the same. MPM_BAD_INPUT: a folder
 * without a bench.jsonl. */
enum mpm_status bench_compare(const char *folder_a, const char *folder_b, FILE *out,
                              struct mpm_error *error);

#endif
