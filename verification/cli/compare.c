/* Two runs of the suite against each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/compare.h"

#include "verification/common/text.h"
#include "verification/records/changes.h"
#include "verification/records/check_text.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { NAME_WIDTH = 44 };

struct comparison_runs {
    struct records before, after;
    FILE *out;
};

/* ------------------------------------------------------------------ printing */

static void print_row(const struct comparison_runs *runs, const char *change, const char *name,
                      const char *text)
{
    fprintf(runs->out, "  %-8s %-*s %s\n", change, NAME_WIDTH, name, text);
}

static void print_changes(const struct comparison_runs *runs, const struct changes *changes)
{
    const char *section = "";
    for (size_t i = 0; i < json_array_size(changes->lines); i++) {
        const json_t *line = json_array_get(changes->lines, i);
        if (strcmp(section, record_text(line, "section")) != 0)
            fprintf(runs->out, "\n%s\n", record_text(line, "section"));
        section = record_text(line, "section");
        print_row(runs, record_text(line, "change"), record_text(line, "name"),
                  record_text(line, "text"));
    }
    if (changes->unselected > 0)
        fprintf(runs->out,
                "\n%zu checks of the first run are not in the second, which selected "
                "otherwise\n",
                changes->unselected);
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

static void print_worst(const struct comparison_runs *runs)
{
    const json_t *const worst[] = {records_worst(&runs->before, NULL),
                                   records_worst(&runs->after, NULL)};
    GString *const rows[] = {g_string_new(NULL), g_string_new(NULL)};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        char *const name = worst[i] == NULL ? NULL : text_check_name(worst[i]);
        char *const margin = text_number(record_number(worst[i], "margin"));
        if (name != NULL)
            g_string_printf(rows[i], "%-*s %s", NAME_WIDTH, name, margin);
        else
            g_string_assign(rows[i], "no check has a margin");
        g_free(margin);
        g_free(name);
    }
    if (!g_string_equal(rows[0], rows[1]))
        fprintf(runs->out, "\nWorst margins\n  %-8s %s\n  %-8s %s\n", "before", rows[0]->str,
                "after", rows[1]->str);
    g_string_free(rows[0], TRUE);
    g_string_free(rows[1], TRUE);
}

/* ----------------------------------------------------------------------- time */

/* Shorter than this, the start of a process is part of it. */
static const double shortest = 0.2;

struct times {
    GArray *before, *after; /* double */
    GPtrArray *lines;       /* of the second run */
};

static void print_slow(const struct comparison_runs *runs, const struct run_noise *noise,
                       const struct times *times)
{
    const double *before = (const double *)(const void *)times->before->data;
    const double *after = (const double *)(const void *)times->after->data;
    size_t shown = 0;
    for (unsigned i = 0; i < times->lines->len; i++) {
        if (run_change_time(noise, before[i], after[i]) == RUN_SAME)
            continue;
        if (shown++ == 0)
            fprintf(runs->out,
                    "\nProcessor time of %u programs: %.3g times as long in the middle; beyond "
                    "the noise, a factor of %.3g about that, are\n",
                    times->lines->len, noise->middle, noise->factor);
        const json_t *line = times->lines->pdata[i];
        char *name =
            g_strdup_printf("%s [%s]", record_text(line, "case"), record_text(line, "variant"));
        fprintf(runs->out, "  %-8s %-*s %.3g s, then %.3g s\n",
                after[i] > before[i] ? "slower" : "faster", NAME_WIDTH, name, before[i], after[i]);
        g_free(name);
    }
}

static void compare_times(const struct comparison_runs *runs)
{
    GHashTable *index = record_index(runs->before.measurements, "quantity");
    struct times times = {g_array_new(FALSE, FALSE, sizeof(double)),
                          g_array_new(FALSE, FALSE, sizeof(double)), g_ptr_array_new()};
    for (size_t i = 0; i < json_array_size(runs->after.measurements); i++) {
        json_t *after = json_array_get(runs->after.measurements, i);
        const double one = record_number(record_find(index, after, "quantity"), "value");
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
    print_slow(runs, &noise, &times);
    g_free(work);
    g_hash_table_unref(index);
    g_array_unref(times.before);
    g_array_unref(times.after);
    g_ptr_array_unref(times.lines);
}

/* ------------------------------------------------------------------------ all */

enum mpm_status suite_compare(const char *before, const char *after, double change, FILE *out,
                              bool *worse, struct mpm_error *error)
{
    struct comparison_runs runs = {.out = out};
    *worse = false;
    TRY(records_read(before, &runs.before, error));
    const enum mpm_status status = records_read(after, &runs.after, error);
    if (status == MPM_OK) {
        struct changes changes = changes_gather(&runs.before, &runs.after, change);
        print_runs(&runs, before, after);
        print_changes(&runs, &changes);
        print_worst(&runs);
        if (runs.before.measurements != NULL && runs.after.measurements != NULL)
            compare_times(&runs);
        fprintf(out, "\n%zu worse, %zu better, %zu changed otherwise\n", changes.worse,
                changes.better, changes.other);
        *worse = changes.worse > 0;
        changes_clear(&changes);
        records_clear(&runs.after);
    }
    records_clear(&runs.before);
    return status;
}
