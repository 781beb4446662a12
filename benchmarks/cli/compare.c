/* Two runs of mpm-bench against each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/cli/compare.h"

#include "benchmarks/common/records.h"
#include "verification/common/failure.h"
#include "verification/common/record.h"
#include "verification/common/text.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { POINT_WIDTH = 48, QUANTITY_WIDTH = 30 };

struct counts {
    size_t compared, faster, slower, changed, only_one, without_ratio;
};

/* ------------------------------------------------------------------ the runs */

static void print_fact(FILE *out, const struct bench_records *a, const struct bench_records *b,
                       const char *key)
{
    const char *in_a = record_text(a->run, key), *in_b = record_text(b->run, key);
    if (strcmp(in_a, in_b) == 0)
        fprintf(out, "  %-10s %s\n", key, in_a);
    else
        fprintf(out, "  %-10s A: %s\n  %-10s B: %s\n", key, in_a, "", in_b);
}

static bool is_same(const struct bench_records *a, const struct bench_records *b, const char *key)
{
    return json_equal(json_object_get(a->run, key), json_object_get(b->run, key)) != 0;
}

static void print_runs(FILE *out, const struct bench_records *a, const struct bench_records *b)
{
    static const char *const facts[] = {"revision", "processor", "compiler",
                                        "flags",    "simd",      "tier"};
    for (size_t i = 0; i < G_N_ELEMENTS(facts); i++)
        print_fact(out, a, b, facts[i]);
    const bool machine = is_same(a, b, "processor") && is_same(a, b, "cores");
    fprintf(out, "  %s machine, %s revision\n", machine ? "same" : "another",
            is_same(a, b, "revision") ? "same" : "another");
}

/* ------------------------------------------------------------------- a point */

static void print_row(FILE *out, const json_t *line, const char *text)
{
    fprintf(out, "  %-*s %-*s %s\n", POINT_WIDTH, record_text(line, "point"), QUANTITY_WIDTH,
            record_text(line, "quantity"), text);
}

/* Rates are in something a second, or a part of a limit; all else costs. */
static enum bench_sense sense_of(const json_t *line)
{
    const char *unit = record_text(line, "unit");
    const bool cost = strcmp(unit, "s") == 0 || strcmp(unit, "ns") == 0 || strcmp(unit, "B") == 0;
    return cost ? BENCH_COST : BENCH_RATE;
}

static bool all_positive(const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!(values[i] > 0) || !isfinite(values[i]))
            return false;
    return count > 0;
}

static void compare_rounds(const json_t *a, const json_t *b, FILE *out, struct counts *counts)
{
    size_t count_a, count_b;
    double *rounds_a = bench_record_rounds(a, &count_a),
           *rounds_b = bench_record_rounds(b, &count_b);
    if (!all_positive(rounds_a, count_a) || !all_positive(rounds_b, count_b)) {
        counts->without_ratio++;
        print_row(out, b, "a round without a positive number: no ratio");
    } else {
        const struct bench_interval ratio =
            bench_ratio_unpaired(rounds_b, count_b, rounds_a, count_a);
        const enum bench_verdict verdict =
            bench_verdict_of(ratio, MIN(count_a, count_b), sense_of(a));
        char *middle = text_number(ratio.median), *range = text_range(ratio.low, ratio.high, "");
        char *text = g_strdup_printf("%s  (%s)  %s", middle, range, bench_verdict_name(verdict));
        counts->compared++;
        counts->faster += verdict == BENCH_FASTER;
        counts->slower += verdict == BENCH_SLOWER;
        if (verdict != BENCH_NOT_RESOLVED)
            print_row(out, b, text);
        g_free(text);
        g_free(middle);
        g_free(range);
    }
    g_free(rounds_a);
    g_free(rounds_b);
}

/* Where there is no number in A, or zero, there is no ratio. */
static char *change_text(double in_a, double in_b)
{
    if (!isfinite(in_a) || !isfinite(in_b))
        return g_strdup("no number in one of the two");
    if (fabs(in_a) > 0)
        return g_strdup_printf("%+.2f %%", 100 * (in_b / in_a - 1));
    return g_strdup("from nothing, no ratio");
}

/* Deterministic figures have no noise: any change is shown. */
static void compare_values(const json_t *a, const json_t *b, FILE *out, struct counts *counts)
{
    const double in_a = record_number(a, "value"), in_b = record_number(b, "value");
    counts->compared++;
    if (json_equal(json_object_get(a, "value"), json_object_get(b, "value")) != 0)
        return;
    char *text_a = text_quantity(in_a, record_text(a, "unit"));
    char *text_b = text_quantity(in_b, record_text(b, "unit"));
    char *change = change_text(in_a, in_b);
    char *text = g_strdup_printf("%s to %s  (%s)", text_a, text_b, change);
    counts->changed++;
    print_row(out, b, text);
    g_free(text);
    g_free(change);
    g_free(text_a);
    g_free(text_b);
}

/* -------------------------------------------------------------------- lines */

static bool is_measured(const json_t *line)
{
    return strcmp(record_text(line, "kind"), "comparison") != 0;
}

static const json_t *same_line(const struct bench_records *records, const json_t *line)
{
    return bench_records_find(records, record_text(line, "kind"), record_text(line, "group"),
                              record_text(line, "point"), record_text(line, "quantity"));
}

static void compare_lines(const struct bench_records *a, const struct bench_records *b, FILE *out,
                          struct counts *counts)
{
    for (size_t i = 0; i < json_array_size(b->lines); i++) {
        const json_t *in_b = json_array_get(b->lines, i), *in_a = same_line(a, in_b);
        if (!is_measured(in_b))
            continue;
        if (in_a == NULL)
            counts->only_one++;
        else if (strcmp(record_text(in_b, "kind"), "result") == 0)
            compare_rounds(in_a, in_b, out, counts);
        else
            compare_values(in_a, in_b, out, counts);
    }
    for (size_t i = 0; i < json_array_size(a->lines); i++) {
        const json_t *in_a = json_array_get(a->lines, i);
        counts->only_one += is_measured(in_a) && same_line(b, in_a) == NULL;
    }
}

static void print_counts(FILE *out, const struct counts *counts)
{
    fprintf(out,
            "%zu compared: %zu faster, %zu slower, %zu figures changed; the others are not "
            "resolved or the same\n",
            counts->compared, counts->faster, counts->slower, counts->changed);
    if (counts->only_one > 0)
        fprintf(out, "%zu are in one of the two only\n", counts->only_one);
    if (counts->without_ratio > 0)
        fprintf(out, "%zu have a round without a positive number and are not compared\n",
                counts->without_ratio);
}

enum mpm_status bench_compare(const char *folder_a, const char *folder_b, FILE *out,
                              struct mpm_error *error)
{
    struct bench_records a, b;
    struct counts counts = {0};
    TRY(bench_records_read(folder_a, &a, error));
    const enum mpm_status status = bench_records_read(folder_b, &b, error);
    if (status == MPM_OK) {
        fprintf(out, "B (%s) over A (%s)\n", folder_b, folder_a);
        print_runs(out, &a, &b);
        compare_lines(&a, &b, out, &counts);
        print_counts(out, &counts);
        bench_records_clear(&b);
    }
    bench_records_clear(&a);
    return status;
}
