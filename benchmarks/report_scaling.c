/* Section: scaling with threads, size, particles per cell and empty grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report_sections.h"

#include "verification/suite/records.h"

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
    {"threads", "scaling", "threads", " thread", "label='threads'; logarithmic=0", "Threads",
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

/* Lines of one study in blocks: of threads, one block for each number of particles. */
static char *data_of(const struct study *study, const GPtrArray *lines)
{
    GString *data = g_string_new(NULL);
    const bool by_size = strcmp(study->key, "threads") == 0;
    for (unsigned i = 0; i < lines->len; i++) {
        const double size = report_number(lines->pdata[i], "particles");
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
        if (strcmp(study->group, "scaling") == 0) /* the others stand in a table above */
            add_table(report, lines);
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
