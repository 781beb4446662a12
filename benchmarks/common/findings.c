/* Findings: to the records and to the console.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/findings.h"

void bench_detail(struct bench_context *context, const struct bench_subject *subject,
                  const char *quantity, const char *unit, const double *rounds, size_t count)
{
    (void)bench_records_result(context->records, subject, quantity, unit, rounds, count);
}

void bench_result(struct bench_context *context, const struct bench_subject *subject,
                  const char *quantity, const char *unit, const double *rounds, size_t count)
{
    bench_console_line(context->console, bench_records_result(context->records, subject, quantity,
                                                              unit, rounds, count));
}

void bench_value(struct bench_context *context, const struct bench_subject *subject,
                 const char *quantity, const char *unit, double value)
{
    bench_console_line(context->console,
                       bench_records_value(context->records, subject, quantity, unit, value));
}

void bench_comparison(struct bench_context *context, const struct bench_subject *subject,
                      const char *against, const char *quantity, enum bench_sense sense,
                      const double *rounds, const double *against_rounds, size_t count)
{
    const struct bench_interval ratio = bench_ratio_paired(rounds, against_rounds, count);
    bench_console_line(context->console,
                       bench_records_comparison(context->records, subject, against, quantity, ratio,
                                                bench_verdict_of(ratio, count, sense)));
}
