/* Sections: the target rows, throughput, and what of the machine's limit is used.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/report_sections.h"
#include "verification/common/record.h"

#include <math.h>
#include <string.h>

static const char rate[] = "particle_steps_per_second";
static const double MILLION = 1e6;

/* The line of the same point with another quantity, NULL if there is none. */
static const json_t *sibling(const struct report *report, const json_t *line, const char *kind,
                             const char *quantity)
{
    return bench_records_find(report->records, kind, record_text(line, "group"),
                              record_text(line, "point"), quantity);
}

static void cell_value(struct report *report, const json_t *line, double scale)
{
    document_cell(
        report->document,
        line == NULL ? g_strdup("none") : report_digits(record_number(line, "value"), scale), NULL);
}

static char *size_of(const json_t *line)
{
    char *number = report_digits(report_number(line, "particles"), 1);
    char *text =
        g_strdup_printf("%s particles, %s kernels", number, report_setting(line, "kernels"));
    g_free(number);
    return text;
}

/* ---------------------------------------------------------------------- front */

static void front_row(struct report *report, const json_t *line)
{
    document_cell(report->document, report_variant(line), size_of(line));
    report_cell_result(report, line, MILLION);
    report_cell_result(report, sibling(report, line, "result", "particle_steps_per_gflop"), 1e3);
    cell_value(report, sibling(report, line, "value", "bytes_per_particle"), 1);
}

void report_front(struct report *report)
{
    static const char *const columns[] = {"Variant", ">Rate", ">Per GFLOP", ">Bytes", NULL};
    document_heading(report->document, 2, "One core");
    if (!report_has(report, "limit", "The headline table"))
        return;
    GPtrArray *lines = report_lines(report, "result", "limit", rate);
    document_table(report->document,
                   "Neo-Hookean block, one thread; heat alone is without mechanics. Rate: million "
                   "particle-steps a second. Per GFLOP: "
                   "thousand particle-steps for each GFLOP that multiply-adds reach on the same "
                   "core in the same rounds, which depends less on how busy the machine is. "
                   "Bytes: all memory, a particle.",
                   columns);
    for (unsigned i = 0; i < lines->len; i++)
        front_row(report, lines->pdata[i]);
    g_ptr_array_unref(lines);
}

/* ----------------------------------------------------------------- throughput */

/* The variants come first: points that are compared with nothing and nothing with them. */
static bool is_variant(const struct report *report, const json_t *line)
{
    return *report_setting(line, "shape") != '\0' && report_comparison(report, line) == NULL &&
           strchr(record_text(line, "point"), ',') == NULL;
}

static const json_t *find_variant(const struct report *report, const GPtrArray *lines,
                                  const struct bench_variant *variant, const char *geometry)
{
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i];
        if (is_variant(report, line) &&
            strcmp(report_setting(line, "shape"), variant->shape) == 0 &&
            strcmp(report_setting(line, "stress_update"), variant->stress_update) == 0 &&
            strcmp(report_setting(line, "geometry"), geometry) == 0)
            return line;
    }
    return NULL;
}

static const char *const geometries[] = {"plane_strain", "axisymmetric"};

/* Median, low and high in millions; '-' is what the script takes for no value. */
static void bar_data(GString *data, const json_t *line)
{
    static const char *const keys[] = {"median", "low", "high"};
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++) {
        char number[G_ASCII_DTOSTR_BUF_SIZE] = "-";
        if (line != NULL && isfinite(record_number(line, keys[i])))
            g_ascii_formatd(number, sizeof number, "%.6g", record_number(line, keys[i]) / MILLION);
        g_string_append_printf(data, " %s", number);
    }
}

static void add_bars(struct report *report, const GPtrArray *lines)
{
    char settings[] = "shown='   '"; /* places of the geometries that have bars */
    GString *data = g_string_new("# shape order, plane strain: median low high, axisymmetric: "
                                 "median low high; million particle-steps/s\n");
    for (size_t v = 0; v < bench_variants_plain(); v++) {
        const struct bench_variant variant = bench_variant(v);
        g_string_append_printf(data, "\"%s\" \"%s\"", report_word(variant.shape),
                               report_word(variant.stress_update));
        for (size_t g = 0; g < G_N_ELEMENTS(geometries); g++) {
            const json_t *line = find_variant(report, lines, &variant, geometries[g]);
            bar_data(data, line);
            if (line != NULL) /* no bars at all would be a warning */
                settings[strlen("shown='") + 2 * g] = (char)('0' + g);
        }
        g_string_append_c(data, '\n');
    }
    report_add_figure(report,
                      &(struct report_figure){"throughput", "throughput", settings, data->str,
                                              "Throughput of every variant",
                                              "Million particle-steps a second, one thread; the "
                                              "lines on the bars are 95 % intervals."});
    g_string_free(data, TRUE);
}

static void add_variants(struct report *report, const GPtrArray *lines)
{
    static const char *const columns[] = {"Variant", ">Plane strain", ">Axisymmetric", NULL};
    document_heading(report->document, 3, "Every variant");
    document_table(report->document, "Million particle-steps a second, one thread.", columns);
    for (size_t v = 0; v < bench_variants_plain(); v++) {
        const struct bench_variant variant = bench_variant(v);
        document_cell(report->document, report_variant_words(&variant), NULL);
        for (size_t g = 0; g < G_N_ELEMENTS(geometries); g++)
            report_cell_result(report, find_variant(report, lines, &variant, geometries[g]),
                               MILLION);
    }
    add_bars(report, lines);
}

void report_throughput(struct report *report)
{
    static const char *const columns[] = {"Point", ">Rate", ">Rate ratio", "Against", NULL};
    document_heading(report->document, 2, "Throughput");
    if (!report_has(report, "throughput", "Throughput"))
        return;
    GPtrArray *lines = report_lines(report, "result", "throughput", rate);
    bool variants = false, others = false;
    for (unsigned i = 0; i < lines->len; i++) {
        variants = variants || is_variant(report, lines->pdata[i]);
        others = others || !is_variant(report, lines->pdata[i]);
    }
    if (variants)
        add_variants(report, lines);
    if (others) {
        document_heading(report->document, 3, "Sizes, laws, kernels, heat");
        document_table(report->document, "One thread; rate: million particle-steps a second.",
                       columns);
    }
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i], *comparison = report_comparison(report, line);
        if (is_variant(report, line))
            continue;
        report_cell_point(report, line, "point", size_of(line));
        report_cell_result(report, line, MILLION);
        report_cell_ratio(report, comparison, false);
        report_cell_point(report, comparison, "against", NULL);
    }
    g_ptr_array_unref(lines);
}

/* ---------------------------------------------------------------------- limit */

/* A phase that a variant does not have still costs its two looks at the clock. */
static void cell_phase(struct report *report, const json_t *line)
{
    if (line != NULL && record_number(line, "median") < 0.01)
        report_cell(report, "0");
    else
        report_cell_result(report, line, 1);
}

static void add_phases(struct report *report, const GPtrArray *lines)
{
    static const char *const phases[] = {"particles_to_grid", "grid", "grid_to_particles",
                                         "stress_and_position", "sort"};
    static const char *const columns[] = {
        "Variant", ">Particles to grid", ">Grid", ">Grid to particles", ">Stress, moves", ">Sort",
        NULL};
    bool any = false;
    for (unsigned i = 0; i < lines->len; i++)
        any = any || sibling(report, lines->pdata[i], "result", "phase_grid") != NULL;
    if (!any)
        return;
    document_heading(report->document, 3, "Phases of a step");
    document_table(report->document, "Nanoseconds a particle-step, by the wall clock.", columns);
    for (unsigned i = 0; i < lines->len; i++) {
        document_cell(report->document, report_variant(lines->pdata[i]), NULL);
        for (size_t p = 0; p < G_N_ELEMENTS(phases); p++) {
            char *quantity = g_strconcat("phase_", phases[p], NULL);
            cell_phase(report, sibling(report, lines->pdata[i], "result", quantity));
            g_free(quantity);
        }
    }
}

static void add_probe(struct report *report, const char *quantity, const char *what)
{
    const json_t *line = bench_records_find(report->records, "result", "limit", NULL, quantity);
    document_cell(report->document, g_strdup(what), NULL);
    report_cell_result(report, line, 1);
    report_cell(report, record_text(line, "unit"));
}

void report_limit(struct report *report)
{
    static const char *const machine[] = {"Limit of one core", ">Rate", "Unit", NULL};
    static const char *const columns[] = {"Variant", ">Operations/particle-step",
                                          ">Of memory bandwidth, %", NULL};
    document_heading(report->document, 2, "Machine limit");
    if (!report_has(report, "limit", "The machine's limit"))
        return;
    document_table(report->document, "Measured in the rounds of the rows below.", machine);
    add_probe(report, "arithmetic", "Multiply-add");
    add_probe(report, "bandwidth", "Memory, triad");
    GPtrArray *lines = report_lines(report, "result", "limit", rate);
    document_table(
        report->document,
        "How many floating-point operations (two to a multiply-add) the core could have done in "
        "the time of a particle-step, and what part of its bandwidth the state of the particles "
        "takes, read once and written once.",
        columns);
    for (unsigned i = 0; i < lines->len; i++) {
        const json_t *line = lines->pdata[i];
        const json_t *ratio = sibling(report, line, "result", "particle_steps_per_gflop");
        char *number = report_digits(1e9, record_number(ratio, "median"));
        document_cell(report->document, report_variant(line), NULL);
        document_cell(report->document, number, NULL);
        report_cell_result(report, sibling(report, line, "result", "fraction_of_bandwidth"), 0.01);
    }
    add_phases(report, lines);
    g_ptr_array_unref(lines);
}
