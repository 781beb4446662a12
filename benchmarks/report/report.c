/* The report: the page, the summary and the figures of a folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/report/report.h"

#include "benchmarks/report/report_sections.h"
#include "mpm_file.h"
#include "verification/common/failure.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/resources.h"
#include "verification/common/result_path.h"
#include "verification/pages/html.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <string.h>

/* -------------------------------------------------------------------- footer */

/* The distinct values of a setting over all lines. */
static char *distinct(const struct bench_records *records, const char *key)
{
    GString *text = g_string_new(NULL);
    GHashTable *seen = g_hash_table_new(g_str_hash, g_str_equal);
    for (size_t i = 0; i < json_array_size(records->lines); i++) {
        const char *value = report_setting(json_array_get(records->lines, i), key);
        if (*value != '\0' && g_hash_table_add(seen, (char *)(uintptr_t)value))
            g_string_append_printf(text, "%s%s", text->len == 0 ? "" : ", ", value);
    }
    g_hash_table_destroy(seen);
    if (text->len == 0)
        g_string_append(text, "none recorded");
    return g_string_free(text, FALSE);
}

static char *machine_of(const json_t *run)
{
    return g_strdup_printf("%s; %.0f cores for this process, %.1f GB of memory",
                           record_text(run, "processor"), record_number(run, "cores"),
                           1e-9 * record_number(run, "memory_bytes"));
}

/* Pairs of name and text, NULL at the end; g_strfreev. */
static char **facts(const struct bench_records *records)
{
    static const char *const rows[][2] = {
        {"Compiler", "compiler"}, {"Flags", "flags"},         {"Revision", "revision"},
        {"Compiled for", "simd"}, {"Libraries", "libraries"}, {"Size", "tier"},
        {"Command", "command"},
    };
    const json_t *run = records->run;
    GPtrArray *texts = g_ptr_array_new();
    g_ptr_array_add(texts, g_strdup("Processor"));
    g_ptr_array_add(texts, machine_of(run));
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_ptr_array_add(texts, g_strdup(rows[i][0]));
        g_ptr_array_add(texts, g_strdup(record_text(run, rows[i][1])));
    }
    g_ptr_array_add(texts, g_strdup("Kernels"));
    g_ptr_array_add(texts, distinct(records, "kernels"));
    g_ptr_array_add(texts, g_strdup("Instructions used"));
    g_ptr_array_add(texts, distinct(records, "simd"));
    g_ptr_array_add(texts, g_strdup("Version"));
    g_ptr_array_add(texts, g_strdup_printf("Touchstone %s", record_text(run, "version")));
    g_ptr_array_add(texts, NULL);
    return (char **)g_ptr_array_free(texts, FALSE);
}

static GString *footer_of(char *const *texts)
{
    GString *html = g_string_new("<h2>Where these numbers come from</h2>\n<dl class=\"facts\">\n");
    for (size_t i = 0; texts[i] != NULL; i += 2)
        text_markup(html, "<dt>%s</dt><dd>%s</dd>\n", texts[i], texts[i + 1]);
    g_string_append(html, "</dl>\n");
    return html;
}

/* --------------------------------------------------------------------- files */

static const char how_measured[] =
    "Times are medians over rounds in which every point is visited once, with 95 % bootstrap "
    "intervals below them; for one thread they are processor time. A ratio is called a "
    "difference only if its interval excludes 1 and it is beyond 5 %; otherwise it reads "
    "\"not resolved\".";

static char *title_of(const struct bench_records *records)
{
    const json_t *line =
        bench_records_find(records, "result", "limit", NULL, "particle_steps_per_second");
    if (line == NULL)
        return g_strdup("Touchstone: benchmarks");
    char *rate = report_digits(record_number(line, "median"), 1e6);
    char *variant = report_variant(line);
    char *title =
        g_strdup_printf("%s million particle-steps a second on one core (%s)", rate, variant);
    g_free(rate);
    g_free(variant);
    return title;
}

static enum mpm_status write_page(const char *folder, const struct report *report,
                                  const struct report_style *style, struct mpm_error *error)
{
    char **texts = facts(report->records), *title = title_of(report->records);
    char *body = document_html(report->document), *links = document_links(report->document);
    GString *content = g_string_new(NULL), *navigation = g_string_new(NULL);
    text_markup(content, "<h1>%s</h1>\n<p class=\"lead\">%s</p>\n", title, how_measured);
    g_string_append(content, body);
    g_string_append_printf(navigation, "<strong>Touchstone</strong> benchmark report: %s", links);
    char *page = html_fill(style, title, navigation, content, footer_of(texts));
    const enum mpm_status status = output_write(folder, "index.html", page, error);
    g_free(page);
    g_free(body);
    g_free(links);
    g_free(title);
    g_strfreev(texts);
    return status;
}

static enum mpm_status write_summary(const char *folder, const struct report *report,
                                     struct mpm_error *error)
{
    char **texts = facts(report->records), *title = title_of(report->records);
    char *body = document_markdown(report->document);
    GString *markdown = g_string_new("# ");
    text_markdown(markdown, title);
    g_string_append(markdown, "\n\n");
    text_markdown(markdown, how_measured);
    g_string_append_printf(markdown, "\n\n%s## Where these numbers come from\n\n", body);
    for (size_t i = 0; texts[i] != NULL; i += 2) {
        g_string_append_printf(markdown, "- %s: ", texts[i]);
        text_markdown(markdown, texts[i + 1]);
        g_string_append_c(markdown, '\n');
    }
    const enum mpm_status status = output_write(folder, "summary.md", markdown->str, error);
    g_string_free(markdown, TRUE);
    g_free(body);
    g_free(title);
    g_strfreev(texts);
    return status;
}

static enum mpm_status write_all(const char *folder, struct report *report, struct mpm_error *error)
{
    struct report_style style;
    TRY(result_folder_check(report->figures, error));
    if (mpm_folder_make(report->figures) != 0)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be made: %s", report->figures,
                           g_strerror(errno));
    TRY(report_style_read(report->scripts, &style, error));
    report_front(report);
    report_throughput(report);
    report_limit(report);
    report_accuracy(report);
    report_overhead(report);
    report_scaling(report);
    enum mpm_status status = write_page(folder, report, &style, error);
    if (status == MPM_OK)
        status = write_summary(folder, report, error);
    if (status == MPM_OK && report->failure != NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s", report->failure);
    report_style_clear(&style);
    return status;
}

enum mpm_status bench_report_write(const char *folder, struct mpm_error *error)
{
    struct bench_records records;
    TRY(bench_records_read(folder, &records, error));
    struct report report = {
        .records = &records,
        .document = document_new(),
        .figures = g_build_filename(folder, "figures", NULL),
        .scripts = resources_reports("mpm-bench"),
        .stamp = g_strdup_printf("Touchstone %s, %s", record_text(records.run, "version"),
                                 record_text(records.run, "revision")),
    };
    const enum mpm_status status = write_all(folder, &report, error);
    document_free(report.document);
    g_free(report.figures);
    g_free(report.scripts);
    g_free(report.stamp);
    g_free(report.failure);
    bench_records_clear(&records);
    return status;
}
