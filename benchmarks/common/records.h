/* Records: bench.jsonl, the one file that the report and comparisons are made from. One JSON
 * object a line; "settings" holds what varies, as texts or numbers:
 *
 *     {"kind":"run","format":1,"tier","command","version","revision","compiler","flags",
 *      "libraries","processor","cores","memory_bytes","load","simd","rounds"}
 *     {"kind":"result","group","point","settings","quantity","unit","median","low","high",
 *      "rounds":[values]}
 *     {"kind":"value","group","point","settings","quantity","unit","value"}
 *     {"kind":"comparison","group","point","against","quantity","ratio","low","high","verdict"}
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_COMMON_RECORDS_H
#define BENCHMARKS_COMMON_RECORDS_H

#include "mpm.h"

#include "benchmarks/common/statistics.h"

#include <jansson.h>

#define BENCH_RECORDS_FILE "bench.jsonl"

struct bench_records {
    json_t *run;   /* object of kind "run" */
    json_t *lines; /* array of the other objects, in the order they were found */
};

/* What a line is about. */
struct bench_subject {
    const char *group, *point;
    json_t *settings; /* object, borrowed; NULL: {} */
};

/* Records with the facts of this machine and build. `rounds`: the most that a point gets.
 * "load" is the number of processes that ran or waited for a processor when the run began. */
struct bench_records bench_records_make(const char *tier, const char *command, size_t rounds);
void bench_records_clear(struct bench_records *records);

/* Each appends one line and returns it (borrowed). A number that is not finite is null. */
const json_t *bench_records_result(struct bench_records *records,
                                   const struct bench_subject *subject, const char *quantity,
                                   const char *unit, const double *rounds, size_t count);
const json_t *bench_records_value(struct bench_records *records,
                                  const struct bench_subject *subject, const char *quantity,
                                  const char *unit, double value);
const json_t *bench_records_comparison(struct bench_records *records,
                                       const struct bench_subject *subject, const char *against,
                                       const char *quantity, struct bench_interval ratio,
                                       enum bench_verdict verdict);

/* Writes <folder>/bench.jsonl whole or not at all. MPM_ENVIRONMENT_FAILED. */
enum mpm_status bench_records_write(const char *folder, const struct bench_records *records,
                                    struct mpm_error *error);

/* Reads it back; texts and numbers of a line by record_text and record_number of the suite.
 * MPM_BAD_INPUT names file and line. */
enum mpm_status bench_records_read(const char *folder, struct bench_records *records,
                                   struct mpm_error *error);

/* The first line of that kind, group, point and quantity (NULL: any); NULL if there is none. */
const json_t *bench_records_find(const struct bench_records *records, const char *kind,
                                 const char *group, const char *point, const char *quantity);

/* The rounds of a result as numbers; *count of them; g_free. */
double *bench_record_rounds(const json_t *line, size_t *count);

#endif
