/* Section: scaling with threads, size, particles per cell and empty grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/report_sections.h"

#include "verification/common/record.h"
#include "verification/common/text.h"

#include <math.h>
#include <string.h>

static const char rate[] = "particle_steps_per_second";
static const double MILLION = 1e6;

/* What is varied, where its lines are, and how it is drawn. */
static const struct study {
    const char *name, *group;
    const char *key;   /* setting that varies */
    const char *where; /* in the name of its points, or "" */
    const char *settings, *title, *caption;
} studies[] = {
    {"threads", "scaling", "threads", " thread", "label='threads'; logarithmic=2", "Threads",
     "Rate by the wall clock against threads, one line for each number of particles; lines "
     "through the points are 95 % intervals."},
    {"sizes", "throughput", "particles", "10^", "label='particles'; logarithmic=1",
     "Number of particles", "Rate of one thread, plane strain, uGIMP, MUSL."},
    {"particles_per_cell", "scaling", "particles_per_cell", "",
     "label='particles per cell'; logarithmic=0", "Particles per cell",
     "Rate of one thread for about the same number of particles."},
    {"empty_grid", "scaling", "grid_over_body", "",
     "label='cells of the grid / cells of the body'; logarithmic=1", "Empty grid",
     "Rate of one thread while the grid around the same body grows."},
};

static bool belongs(const struct study *study, const json_t *line)
{
    return isfinite(report_number(line, study->key)) &&
           strstr(record_text(line, "point"), study->where) != NULL;
}

static void data_row(GString *data, const struct study *study, const json_t *line)
{
    char text[4][G_ASCII_DTOSTR_BUF_SIZE];
    const double numbers[] = {
        report_number(line, study->key), record_number(line, "median") / MILLION,
        record_number(line, "low") / MILLION, record_number(line, "high") / MILLION};
    for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++)
        g_string_append_printf(data, "%s%s", i == 0 ? "" : " ",
                               g_ascii_formatd(text[i], sizeof text[i], "%.6g", numbers[i]));
    g_string_append_c(data, '\n');
}

static int by_key(const void *a, const void *b, void *key)
{
    const json_t *one = *(json_t *const *)a, *other = *(json_t *const *)b;
    const double left = report_number(one, key), right = report_number(other, key);
    return (left > right) - (left < right);
}

/* Runs side by side are no point of a curve. */
static bool is_pair(const json_t *line)
{
    return isfinite(report_number(line, "runs"));
}

/* Lines of one study in blocks: of threads, one block for each number of particles. */
static char *data_of(const struct study *study, const GPtrArray *lines)
{
    GString *data = g_string_new(NULL);
    const bool by_size = strcmp(study->key, "threads") == 0;
    for (unsigned i = 0; i < lines->len; i++) {
        const double size = report_number(lines->pdata[i], "particles");
        if (is_pair(lines->pdata[i]))
            continue;
        const bool starts =
            i == 0 ||
            (by_size && !(fabs(size - report_number(lines->pdata[i - 1], "particles")) < 1));
        if (starts) {
            char *number = report_digits(size, 1);
            g_string_append_printf(data, "%s\"%s\"\n", i == 0 ? "" : "\n\n",
                                   by_size ? number : "measured");
            g_free(number);
        }
        data_row(data, study, lines->pdata[i]);
    }
    return g_string_free(data, FALSE);
}

static void add_table(struct report *report, const GPtrArray *lines)
{
    const char *const columns[] = {"Point", ">Rate", ">Rate ratio", "Against", NULL};
    document_table(
        report->document,
        "The same in numbers: million particle-steps a second; ratios are paired by round.",
        columns);
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i], *comparison = report_comparison(report, line);
        report_cell_point(report, line, "point", NULL);
        report_cell_result(report, line, MILLION);
        report_cell_ratio(report, comparison, false);
        report_cell_point(report, comparison, "against", NULL);
    }
}

/* The same number of particles by as many threads as `pair` has runs; NULL: none. */
static const json_t *threads_beside(const GPtrArray *lines, const json_t *pair)
{
    const double runs = report_number(pair, "runs"), size = report_number(pair, "particles");
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i];
        if (!is_pair(line) && fabs(report_number(line, "threads") - runs) < 1 &&
            fabs(report_number(line, "particles") - size) < 1)
            return line;
    }
    return NULL;
}

/* "1.9 (1.85 .. 1.95)"; g_free. */
static char *times(struct report *report, const json_t *line)
{
    const json_t *comparison = report_comparison(report, line);
    char *ratio = text_number(record_number(comparison, "ratio"));
    char *range =
        text_range(record_number(comparison, "low"), record_number(comparison, "high"), "1");
    char *text = g_strdup_printf("%s (%s)", ratio, range);
    g_free(ratio);
    g_free(range);
    return text;
}

/* Threads are held against what the machine gives to runs that have nothing in common. */
static void add_limits(struct report *report, const GPtrArray *lines)
{
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *pair = lines->pdata[i];
        const json_t *threads = is_pair(pair) ? threads_beside(lines, pair) : NULL;
        if (threads == NULL)
            continue;
        char *size = report_digits(report_number(pair, "particles"), 1);
        char *by_threads = times(report, threads), *by_runs = times(report, pair);
        document_paragraph(
            report->document,
            "%s particles: %.0f threads of one run come to %s times one thread; %.0f separate runs "
            "of one thread each, side by side, to %s times one alone. Separate runs share the "
            "machine and wait for nothing: what they fall short by is the machine's doing. They "
            "hold more data than one run, so that its threads may come to more than they do where "
            "caches and memory are the limit.",
            size, report_number(threads, "threads"), by_threads, report_number(pair, "runs"),
            by_runs);
        g_free(size);
        g_free(by_threads);
        g_free(by_runs);
    }
}

/* More threads than there is work for change nothing. */
static void add_unused(struct report *report, const GPtrArray *lines)
{
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i];
        const double used = report_number(line, "threads_used");
        const double allowed = report_number(line, "threads");
        if (used < allowed)
            document_paragraph(report->document,
                               "%s: there is work for %.0f of the %.0f threads, and the run used "
                               "no more.",
                               record_text(line, "point"), used, allowed);
    }
}

static void add_study(struct report *report, const struct study *study)
{
    GPtrArray *lines = report_lines(report, "result", study->group, rate);
    for (unsigned i = lines->len; i-- > 0;)
        if (!belongs(study, lines->pdata[i]))
            g_ptr_array_remove_index(lines, i);
    if (lines->len > 1) {
        if (strcmp(study->key, "threads") != 0)
            g_ptr_array_sort_with_data(lines, (GCompareDataFunc)(void (*)(void))by_key,
                                       (void *)(uintptr_t)study->key);
        char *data = data_of(study, lines);
        document_heading(report->document, 3, study->title);
        report_add_figure(report, &(struct report_figure){study->name, "scaling", study->settings,
                                                          data, study->title, study->caption});
        if (strcmp(study->group, "scaling") == 0) /* the others are in a table above */
            add_table(report, lines);
        add_unused(report, lines);
        add_limits(report, lines);
        g_free(data);
    }
    g_ptr_array_unref(lines);
}

void report_scaling(struct report *report)
{
    document_heading(report->document, 2, "Scaling");
    (void)report_has(report, "scaling", "Scaling");
    for (size_t i = 0; i < G_N_ELEMENTS(studies); i++)
        add_study(report, &studies[i]);
}
