/* The report: all files of an output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/report.h"

#include "verification/suite/comparison_plot.h"
#include "verification/suite/output.h"

#include <glib.h>
#include <glib/gstdio.h>

/* From the folder itself, or else from `reports`. */
static enum mpm_status read_style_file(const char *folder, const char *reports, const char *name,
                                       char **text, struct mpm_error *error)
{
    char *own = g_build_filename(folder, "style", name, NULL);
    char *shared = g_build_filename(reports == NULL ? "" : reports, name, NULL);
    const bool read =
        g_file_get_contents(own, text, NULL, NULL) || g_file_get_contents(shared, text, NULL, NULL);
    const enum mpm_status status =
        read ? MPM_OK
             : failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: neither this nor %s can be read",
                           own, shared);
    g_free(own);
    g_free(shared);
    return status;
}

enum mpm_status report_style_read(const char *folder, const char *reports,
                                  struct report_style *style, struct mpm_error *error)
{
    *style = (struct report_style){.page = NULL};
    enum mpm_status status = read_style_file(folder, reports, "page.html", &style->page, error);
    if (status == MPM_OK)
        status = read_style_file(folder, reports, "report.css", &style->css, error);
    if (status == MPM_OK)
        status = read_style_file(folder, reports, "table.js", &style->script, error);
    if (status != MPM_OK)
        report_style_clear(style);
    return status;
}

void report_style_clear(struct report_style *style)
{
    g_free(style->page);
    g_free(style->css);
    g_free(style->script);
    *style = (struct report_style){.page = NULL};
}

static enum mpm_status write_owned(const char *folder, const char *name, char *text,
                                   struct mpm_error *error)
{
    const enum mpm_status status = output_write(folder, name, text, error);
    g_free(text);
    return status;
}

/* Draws the figures of a case, then writes its page; a figure that failed is told after
 * the page is written. */
static enum mpm_status write_case(const char *folder, const struct records *records,
                                  const json_t *entry, const struct report_style *style,
                                  struct mpm_error *error)
{
    const json_t *figures = json_object_get(entry, "figures");
    const size_t count = json_array_size(figures);
    struct figure_result *results = g_new0(struct figure_result, count + 1);
    const struct figure_result *failed = NULL;
    size_t failed_index = 0;
    for (size_t i = 0; i < count; i++) {
        results[i] = figure_draw(folder, records->run, entry, json_array_get(figures, i));
        if (results[i].state == FIGURE_FAILED && failed == NULL) {
            failed = &results[i];
            failed_index = i;
        }
    }
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    g_mkdir_with_parents(home, 0777); /* a failure is told by the writing */
    enum mpm_status status =
        write_owned(home, "index.html", report_case(records, entry, results, style), error);
    if (status == MPM_OK && failed != NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "figure %s of case %s: %s",
                             record_text(json_array_get(figures, failed_index), "figure"),
                             record_text(entry, "case"), failed->reason);
    g_free(home);
    g_free(results);
    return status;
}

/* The comparison of a case, if it declares one: picture, page, and the table as CSV. */
static enum mpm_status write_comparison(const char *folder, const char *reports,
                                        const struct records *records, const json_t *entry,
                                        const struct report_style *style, struct mpm_error *error)
{
    if (comparison_declared(entry) == NULL)
        return MPM_OK;
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    struct comparison_view view = comparison_view_make(records, entry);
    const struct figure_result picture =
        comparison_plot(&view, records->run, folder, home, reports);
    enum mpm_status status = write_owned(
        home, "comparison.html", comparison_page(records, entry, &view, &picture, style), error);
    if (status == MPM_OK)
        status = write_owned(home, "comparison.csv", comparison_csv(&view), error);
    if (status == MPM_OK && picture.state == FIGURE_FAILED)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "picture of the comparison of %s: %s",
                             record_text(entry, "case"), picture.reason);
    comparison_view_clear(&view);
    g_free(home);
    return status;
}

static enum mpm_status write_texts(const char *folder, const struct records *records,
                                   const struct report_style *style, struct mpm_error *error)
{
    TRY(write_owned(folder, "junit.xml", report_junit(records), error));
    TRY(write_owned(folder, "results.tap", report_tap(records), error));
    TRY(write_owned(folder, "summary.md", report_markdown(records), error));
    return write_owned(folder, "index.html", report_index(records, style), error);
}

enum mpm_status report_render(const char *folder, const char *reports, struct mpm_error *error)
{
    struct records records;
    struct report_style style;
    TRY(records_read(folder, &records, error));
    enum mpm_status status = report_style_read(folder, reports, &style, error);
    if (status == MPM_OK) {
        status = write_texts(folder, &records, &style, error);
        const json_t *cases = json_object_get(records.run, "cases");
        for (size_t i = 0; i < json_array_size(cases); i++) {
            struct mpm_error own = {.status = MPM_OK};
            enum mpm_status drawn =
                write_case(folder, &records, json_array_get(cases, i), &style, &own);
            if (drawn == MPM_OK)
                drawn = write_comparison(folder, reports, &records, json_array_get(cases, i),
                                         &style, &own);
            /* the first failure is the one to tell */
            if (drawn != MPM_OK && status == MPM_OK)
                status = failure_set(error, drawn, "%s", own.message);
        }
        report_style_clear(&style);
    }
    records_clear(&records);
    return status;
}
