/* Two runs of the suite against each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/compare.h"

#include "verification/measures/run_change.h"
#include "verification/suite/records.h"
#include "verification/suite/text.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { NAME_WIDTH = 44 };

struct comparison_runs {
    struct records before, after;
    GHashTable *checks_before, *checks_after; /* by "case/check/variant" */
    GHashTable *values_before;                /* by "case/quantity/variant" */
    GHashTable *judged;                       /* of those quantities, that have a check */
    double change;
    FILE *out;
    size_t worse, better, changed; /* checks and values */
};

/* -------------------------------------------------------------------- lookup */

static char *key_of(const json_t *line, const char *what)
{
    return g_strjoin("/", record_text(line, "case"), record_text(line, what),
                     record_text(line, "variant"), NULL);
}

static GHashTable *index_of(const json_t *lines, const char *what)
{
    GHashTable *table = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (size_t i = 0; i < json_array_size(lines); i++) {
        json_t *line = json_array_get(lines, i);
        g_hash_table_insert(table, key_of(line, what), line);
    }
    return table;
}

static const json_t *find(GHashTable *table, const json_t *line, const char *what)
{
    char *key = key_of(line, what);
    const json_t *found = g_hash_table_lookup(table, key);
    g_free(key);
    return found;
}

/* ------------------------------------------------------------------ printing */

static void print_heading(const struct comparison_runs *runs, bool *headed, const char *text)
{
    if (!*headed)
        fprintf(runs->out, "\n%s\n", text);
    *headed = true;
}

static void print_row(const struct comparison_runs *runs, enum run_change change, const char *name,
                      const char *text)
{
    static const char *const words[] = {"", "better", "worse", "changed"};
    fprintf(runs->out, "  %-8s %-*s %s\n", words[change], NAME_WIDTH, name, text);
}

static void count(struct comparison_runs *runs, enum run_change change)
{
    runs->worse += change == RUN_WORSE;
    runs->better += change == RUN_BETTER;
    runs->changed += change == RUN_OTHER;
}

static void print_check(struct comparison_runs *runs, enum run_change change, const json_t *check,
                        char *text)
{
    char *name = text_check_name(check);
    print_row(runs, change, name, text);
    count(runs, change);
    g_free(name);
    g_free(text);
}

static void print_runs(const struct comparison_runs *runs, const char *before, const char *after)
{
    static const char *const keys[] = {"revision", "compiler", "flags",     "processor",    "simd",
                                       "kernels",  "tier",     "case_glob", "variant_glob", "only"};
    fprintf(runs->out, "from %s\nto   %s\n", before, after);
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++) {
        const char *one = record_text(runs->before.run, keys[i]);
        const char *other = record_text(runs->after.run, keys[i]);
        if (strcmp(one, other) != 0)
            fprintf(runs->out, "  %-12s %s, then %s\n", keys[i], *one == '\0' ? "all" : one,
                    *other == '\0' ? "all" : other);
    }
}

/* -------------------------------------------------------------------- checks */

static void compare_statuses(struct comparison_runs *runs)
{
    bool headed = false;
    for (size_t i = 0; i < json_array_size(runs->after.checks); i++) {
        const json_t *after = json_array_get(runs->after.checks, i);
        const json_t *before = find(runs->checks_before, after, "check");
        if (before == NULL)
            continue;
        const enum run_change change =
            run_change_status(record_status(before), record_status(after));
        if (change == RUN_SAME)
            continue;
        print_heading(runs, &headed, "Statuses");
        const char *reason = record_text(after, "reason");
        print_check(runs, change, after,
                    g_strconcat(record_text(before, "status"), ", then ",
                                record_text(after, "status"), *reason == '\0' ? "" : ": ", reason,
                                NULL));
    }
}

/* A check that a run did not select has not vanished. */
static bool same_selection(const struct comparison_runs *runs)
{
    static const char *const keys[] = {"tier", "case_glob", "variant_glob", "only"};
    bool same = true;
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        same = same && strcmp(record_text(runs->before.run, keys[i]),
                              record_text(runs->after.run, keys[i])) == 0;
    return same;
}

static void compare_presence(struct comparison_runs *runs)
{
    bool headed = false;
    size_t unselected = 0;
    const bool same = same_selection(runs);
    for (size_t i = 0; i < json_array_size(runs->after.checks); i++) {
        const json_t *after = json_array_get(runs->after.checks, i);
        if (find(runs->checks_before, after, "check") != NULL)
            continue;
        const bool red = verdict_is_red(record_status(after));
        print_heading(runs, &headed, "Checks that appeared or vanished");
        print_check(runs, red ? RUN_WORSE : RUN_OTHER, after,
                    g_strconcat("new: ", record_text(after, "status"), NULL));
    }
    for (size_t i = 0; i < json_array_size(runs->before.checks); i++) {
        const json_t *before = json_array_get(runs->before.checks, i);
        if (find(runs->checks_after, before, "check") != NULL)
            continue;
        if (same) {
            print_heading(runs, &headed, "Checks that appeared or vanished");
            print_check(runs, RUN_WORSE, before,
                        g_strconcat("gone: was ", record_text(before, "status"), NULL));
        }
        unselected += !same;
    }
    if (unselected > 0)
        fprintf(runs->out,
                "\n%zu checks of the first run are not in the second, which selected "
                "otherwise\n",
                unselected);
}

static char *values_text(const json_t *before, const json_t *after)
{
    const double one = record_number(before, "value"), other = record_number(after, "value");
    char *from = text_quantity(one, record_text(before, "unit"));
    char *to = text_quantity(other, record_text(after, "unit"));
    const double percent = 100.0 * (other / one - 1.0);
    char *part = isfinite(percent) ? g_strdup_printf(" (%+.3g %%)", percent) : g_strdup("");
    char *text = g_strconcat(from, ", then ", to, part, NULL);
    g_free(part);
    g_free(from);
    g_free(to);
    return text;
}

static void compare_values(struct comparison_runs *runs)
{
    bool headed = false;
    for (size_t i = 0; i < json_array_size(runs->after.checks); i++) {
        const json_t *after = json_array_get(runs->after.checks, i);
        const json_t *before = find(runs->checks_before, after, "check");
        if (before == NULL || !(run_change_relative(record_number(before, "value"),
                                                    record_number(after, "value")) > runs->change))
            continue;
        const double one = record_number(before, "margin"), other = record_number(after, "margin");
        const enum run_change margin = run_change_margin(one, other);
        char *values = values_text(before, after), *from = text_number(one),
             *to = text_number(other);
        print_heading(runs, &headed, "Values of checks, and their margins");
        print_check(runs, margin == RUN_SAME ? RUN_OTHER : margin, after,
                    g_strdup_printf("%s; margin %s, then %s", values, from, to));
        g_free(values);
        g_free(from);
        g_free(to);
    }
}

/* ----------------------------------------------------------- other quantities */

/* Times have noise, and a comparison of their own. */
static bool is_time(const json_t *line)
{
    return g_str_has_suffix(record_text(line, "quantity"), "seconds");
}

static void compare_measurements(struct comparison_runs *runs)
{
    bool headed = false;
    for (size_t i = 0; i < json_array_size(runs->after.measurements); i++) {
        const json_t *after = json_array_get(runs->after.measurements, i);
        const json_t *before = find(runs->values_before, after, "quantity");
        if (before == NULL || is_time(after) || find(runs->judged, after, "quantity") != NULL ||
            !(run_change_relative(record_number(before, "value"), record_number(after, "value")) >
              runs->change))
            continue;
        char *name = g_strdup_printf("%s/%s [%s]", record_text(after, "case"),
                                     record_text(after, "quantity"), record_text(after, "variant"));
        char *text = values_text(before, after);
        print_heading(runs, &headed, "Quantities without a check");
        print_row(runs, RUN_OTHER, name, text);
        count(runs, RUN_OTHER);
        g_free(text);
        g_free(name);
    }
}

static void print_worst(const struct comparison_runs *runs)
{
    const struct records *both[] = {&runs->before, &runs->after};
    fprintf(runs->out, "\nWorst margins\n");
    for (size_t i = 0; i < G_N_ELEMENTS(both); i++) {
        const json_t *worst = records_worst(both[i], NULL);
        char *name = worst == NULL ? g_strdup("none") : text_check_name(worst);
        char *margin = text_number(record_number(worst, "margin"));
        print_row(runs, RUN_SAME, name, margin);
        g_free(margin);
        g_free(name);
    }
}

/* ----------------------------------------------------------------------- time */

/* Shorter than this, the start of a process is part of it. */
static const double shortest = 0.2;

struct times {
    GArray *before, *after; /* double */
    GPtrArray *lines;       /* of the second run */
};

static void compare_times(const struct comparison_runs *runs)
{
    struct times times = {g_array_new(FALSE, FALSE, sizeof(double)),
                          g_array_new(FALSE, FALSE, sizeof(double)), g_ptr_array_new()};
    for (size_t i = 0; i < json_array_size(runs->after.measurements); i++) {
        json_t *after = json_array_get(runs->after.measurements, i);
        const double one = record_number(find(runs->values_before, after, "quantity"), "value");
        const double other = record_number(after, "value");
        if (strcmp(record_text(after, "quantity"), "cpu_seconds") != 0 || !(one > shortest) ||
            !(other > shortest))
            continue;
        g_array_append_val(times.before, one);
        g_array_append_val(times.after, other);
        g_ptr_array_add(times.lines, after);
    }
    const double *before = (const double *)(const void *)times.before->data;
    const double *after = (const double *)(const void *)times.after->data;
    double *work = g_new0(double, times.lines->len + 1);
    const struct run_noise noise = run_change_noise(before, after, times.lines->len, work);
    fprintf(runs->out,
            "\nProcessor time of %u programs: %.3g times as long in the middle; beyond "
            "the noise, a factor of %.3g about that, are\n",
            times.lines->len, noise.middle, noise.factor);
    size_t shown = 0;
    for (unsigned i = 0; i < times.lines->len; i++) {
        if (run_change_time(&noise, before[i], after[i]) == RUN_SAME)
            continue;
        const json_t *line = times.lines->pdata[i];
        char *name =
            g_strdup_printf("%s [%s]", record_text(line, "case"), record_text(line, "variant"));
        fprintf(runs->out, "  %-8s %-*s %.3g s, then %.3g s\n",
                after[i] > before[i] ? "slower" : "faster", NAME_WIDTH, name, before[i], after[i]);
        g_free(name);
        shown++;
    }
    if (shown == 0)
        fprintf(runs->out, "  none\n");
    g_free(work);
    g_array_unref(times.before);
    g_array_unref(times.after);
    g_ptr_array_unref(times.lines);
}

/* ------------------------------------------------------------------------ all */

static void compare_all(struct comparison_runs *runs)
{
    runs->checks_before = index_of(runs->before.checks, "check");
    runs->checks_after = index_of(runs->after.checks, "check");
    runs->values_before = index_of(runs->before.measurements, "quantity");
    runs->judged = index_of(runs->after.checks, "quantity");
    compare_statuses(runs);
    compare_presence(runs);
    compare_values(runs);
    compare_measurements(runs);
    print_worst(runs);
    if (runs->before.measurements != NULL && runs->after.measurements != NULL)
        compare_times(runs);
    fprintf(runs->out, "\n%zu worse, %zu better, %zu changed otherwise\n", runs->worse,
            runs->better, runs->changed);
    g_hash_table_unref(runs->checks_before);
    g_hash_table_unref(runs->checks_after);
    g_hash_table_unref(runs->values_before);
    g_hash_table_unref(runs->judged);
}

enum mpm_status suite_compare(const char *before, const char *after, double change, FILE *out,
                              bool *worse, struct mpm_error *error)
{
    struct comparison_runs runs = {.change = change, .out = out};
    *worse = false;
    TRY(records_read(before, &runs.before, error));
    const enum mpm_status status = records_read(after, &runs.after, error);
    if (status == MPM_OK) {
        print_runs(&runs, before, after);
        compare_all(&runs);
        *worse = runs.worse > 0;
        records_clear(&runs.after);
    }
    records_clear(&runs.before);
    return status;
}
