/* The sections of the report, and what they share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_REPORT_REPORT_SECTIONS_H
#define BENCHMARKS_REPORT_REPORT_SECTIONS_H

#include "benchmarks/common/records.h"
#include "benchmarks/groups/variants.h"
#include "benchmarks/report/document.h"

/* What a section writes to. */
struct report {
    const struct bench_records *records;
    struct document *document;
    char *figures; /* folder of pictures and their data, made */
    char *scripts; /* folder of the scripts; NULL: not found */
    char *stamp;   /* version and revision */
    char *failure; /* the first figure that could not be drawn, and why; NULL: none */
};

/* Each adds its section, or a sentence if its group is missing. */
void report_front(struct report *report);
void report_throughput(struct report *report);
void report_limit(struct report *report);
void report_accuracy(struct report *report);
void report_overhead(struct report *report);
void report_scaling(struct report *report);

/* -------------------------------------------------------------------- lines */

/* Lines of that kind, group and quantity (NULL: any), in order; g_ptr_array_unref. */
GPtrArray *report_lines(const struct report *report, const char *kind, const char *group,
                        const char *quantity);

/* The comparison of a line's point in its quantity; NULL if it has none. */
const json_t *report_comparison(const struct report *report, const json_t *line);

/* A setting of a line; "" or NaN where it is missing. */
const char *report_setting(const json_t *line, const char *key);
double report_number(const json_t *line, const char *key);

/* Is there a line of the group? If not, a sentence states that. */
bool report_has(struct report *report, const char *group, const char *what);

/* -------------------------------------------------------------------- words */

/* "uGIMP", "plane strain", "MUSL": as texts name what scenes call otherwise; any other name
 * as it is. */
const char *report_word(const char *name);

/* "uGIMP, MUSL", with "APIC" behind it where that differs; g_free. */
char *report_variant_words(const struct bench_variant *variant);

/* "uGIMP, MUSL, plane strain" of a line's settings; g_free. */
char *report_variant(const json_t *line);

/* The name of a point in words: "uGIMP, MUSL, plane strain, 10⁵"; g_free. */
char *report_point(const struct report *report, const char *group, const char *point);

/* Three digits, or all of a larger number, of value / scale; g_free. */
char *report_digits(double value, double scale);

/* Cells: a result's median with its interval below, over `scale`. */
void report_cell_result(struct report *report, const json_t *line, double scale);

/* The ratio of a comparison (inverted: of the times instead of the rates) with interval and
 * verdict; "not resolved" in place of a ratio that is not; NULL: an empty cell. */
void report_cell_ratio(struct report *report, const json_t *comparison, bool inverted);

void report_cell(struct report *report, const char *text);

/* The point that a line names under `key` ("point", "against"; NULL line: an empty cell).
 * `about` is taken over. */
void report_cell_point(struct report *report, const json_t *line, const char *key, char *about);

/* ------------------------------------------------------------------ figures */

/* Writes `data` to figures/<name>.dat, draws figures/<name>.svg with the script <script>.gp
 * and adds it to the document; a picture that fails leaves a notice. `settings` are further
 * commands for gnuplot, or "". */
struct report_figure {
    const char *name, *script, *settings, *data, *title, *caption;
};
void report_add_figure(struct report *report, const struct report_figure *figure);

#endif
