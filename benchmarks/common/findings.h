/* Findings: what a group found goes to the records and to the console.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_FINDINGS_H
#define BENCHMARKS_COMMON_FINDINGS_H

#include "benchmarks/common/bench.h"

/* A repeated measurement: one value for each round. */
void bench_result(struct bench_context *context, const struct bench_subject *subject,
                  const char *quantity, const char *unit, const double *rounds, size_t count);

/* The same, recorded but not shown: details such as the phases of a step. */
void bench_detail(struct bench_context *context, const struct bench_subject *subject,
                  const char *quantity, const char *unit, const double *rounds, size_t count);

/* A deterministic figure. */
void bench_value(struct bench_context *context, const struct bench_subject *subject,
                 const char *quantity, const char *unit, double value);

/* Paired by round: the values of `subject` over those of the point `against`. */
void bench_comparison(struct bench_context *context, const struct bench_subject *subject,
                      const char *against, const char *quantity, enum bench_sense sense,
                      const double *rounds, const double *against_rounds, size_t count);

#endif
