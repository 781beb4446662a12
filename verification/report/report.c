/* The report: all files of an output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/report.h"

#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/pages/report_style.h"
#include "verification/report/api_pages.h"
#include "verification/report/case_figure.h"
#include "verification/report/case_pictures.h"
#include "verification/report/comparison_plot.h"
#include "verification/report/comparison_view.h"
#include "verification/report/report_site.h"
#include "verification/report/report_stored.h"

#include <glib.h>

static enum mpm_status write_owned(const char *folder, const char *name, char *text,
                                   struct mpm_error *error)
{
    const enum mpm_status status = output_write(folder, name, text, error);
    g_free(text);
    return status;
}

/* Draws the figures of a case, then writes its page; a figure that failed is reported after
 * the page is written. */
static enum mpm_status write_case(const char *folder, const struct report_sources *sources,
                                  struct report_site *site, const json_t *entry,
                                  struct mpm_error *error)
{
    const json_t *figures = json_object_get(entry, "figures");
    const size_t count = json_array_size(figures);
    struct figure_result *results = g_new0(struct figure_result, count + 1);
    const struct figure_result *failed = NULL;
    size_t failed_index = 0;
    for (size_t i = 0; i < count; i++) {
        results[i] =
            figure_draw(folder, sources, site->records->run, entry, json_array_get(figures, i));
        if (results[i].state == FIGURE_FAILED && failed == NULL) {
            failed = &results[i];
            failed_index = i;
        }
    }
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    (void)mpm_folder_make(home); /* a failure is reported by the reading */
    GPtrArray *files;
    GString *scene = g_string_new(NULL);
    enum mpm_status status = case_data_files(home, &files, error);
    if (status == MPM_OK)
        status = case_pictures(home, entry, scene, error);
    if (status == MPM_OK)
        status = write_owned(home, "index.html",
                             report_case(site, entry, scene->str, results, files), error);
    g_string_free(scene, TRUE);
    if (status == MPM_OK && failed != NULL)
        status = failure_set(error, MPM_RUN_FAILED, "figure %s of case %s: %s",
                             record_text(json_array_get(figures, failed_index), "figure"),
                             record_text(entry, "case"), failed->reason);
    g_ptr_array_unref(files);
    g_free(home);
    g_free(results);
    return status;
}

/* The comparison of a case, if it declares one: picture, page, and the table as CSV. */
static enum mpm_status write_comparison(const char *folder, const struct report_sources *sources,
                                        const struct report_site *site, const json_t *entry,
                                        struct mpm_error *error)
{
    if (comparison_declared(entry) == NULL)
        return MPM_OK;
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    struct comparison_view view = comparison_view_make(site->records, entry);
    const struct figure_result picture =
        comparison_plot(&view, site->records->run, home, sources->reports);
    enum mpm_status status =
        write_owned(home, "comparison.html", comparison_page(site, entry, &view, &picture), error);
    if (status == MPM_OK)
        status = write_owned(home, "comparison.csv", comparison_csv(&view), error);
    if (status == MPM_OK && picture.state == FIGURE_FAILED)
        status = failure_set(error, MPM_RUN_FAILED, "picture of the comparison of %s: %s",
                             record_text(entry, "case"), picture.reason);
    comparison_view_clear(&view);
    g_free(home);
    return status;
}

static enum mpm_status write_cases(const char *folder, const struct report_sources *sources,
                                   struct report_site *site, struct mpm_error *error)
{
    const json_t *cases = json_object_get(site->records->run, "cases");
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        struct mpm_error own = {.status = MPM_OK};
        enum mpm_status drawn = write_case(folder, sources, site, entry, &own);
        if (drawn == MPM_OK)
            drawn = write_comparison(folder, sources, site, entry, &own);
        /* the first failure is the one to report, but a missing file comes before a figure */
        if (drawn > status)
            status = failure_set(error, drawn, "%s", own.message);
    }
    return status;
}

/* What machines read; the pages of the site and their tables are made. */
static enum mpm_status make_site(const char *folder, struct report_site *site,
                                 struct mpm_error *error)
{
    static void (*const pages[])(struct report_site *) = {
        report_front_page,   report_checks_page,  report_limits_page,   report_headroom_page,
        report_history_page, report_mutants_page, report_decision_page, report_glossary_page,
    };
    TRY(write_owned(folder, "junit.xml", report_junit(site->records), error));
    TRY(write_owned(folder, "results.tap", report_tap(site->records), error));
    TRY(write_owned(folder, "summary.md", report_markdown(site->records), error));
    for (size_t i = 0; i < G_N_ELEMENTS(pages); i++)
        pages[i](site);
    return MPM_OK;
}

static enum mpm_status write_files(const char *folder, const struct report_site *site,
                                   struct mpm_error *error)
{
    for (unsigned i = 0; i < site->files->len; i++) {
        const struct report_file *file = &g_array_index(site->files, struct report_file, i);
        TRY(output_write(folder, file->name, file->text, error));
    }
    return MPM_OK;
}

/* The benchmarks' report lies beside this one where make puts both. */
static bool has_benchmarks(const char *folder)
{
    char *path = g_build_filename(folder, "..", "bench", "index.html", NULL);
    const bool there = mpm_path_exists(path);
    g_free(path);
    return there;
}

static bool any_comparison(const json_t *cases)
{
    for (size_t i = 0; i < json_array_size(cases); i++)
        if (comparison_declared(json_array_get(cases, i)) != NULL)
            return true;
    return false;
}

static void clear_file(void *element)
{
    struct report_file *file = element;
    g_free(file->name);
    g_free(file->text);
}

static enum mpm_status render(const char *folder, const char *place,
                              const struct report_sources *sources, const struct records *records,
                              const struct report_stored *stored, struct mpm_error *error)
{
    struct report_style style;
    bool api;
    TRY(api_pages_find(folder, false, &api, error));
    TRY(report_style_read(sources->reports, &style, error));
    struct report_site site = {
        .records = records,
        .style = &style,
        .changes = stored->changes,
        .mutants = stored->mutants,
        .headroom = stored->headroom,
        .history = stored->history,
        .benchmarks = has_benchmarks(place),
        .api = api,
        .folder = folder,
        .compares = any_comparison(json_object_get(records->run, "cases")),
        .files = g_array_new(FALSE, TRUE, sizeof(struct report_file)),
    };
    struct mpm_error own = {.status = MPM_OK};
    g_array_set_clear_func(site.files, clear_file);
    enum mpm_status status = make_site(folder, &site, error);
    /* a figure that cannot be drawn keeps no page from being written */
    const enum mpm_status drawn = write_cases(folder, sources, &site, &own);
    if (status == MPM_OK)
        status = write_files(folder, &site, error);
    if (status == MPM_OK && drawn != MPM_OK)
        status = failure_set(error, drawn, "%s", own.message);
    g_array_unref(site.files);
    report_style_clear(&style);
    return status;
}

enum mpm_status report_check(const char *folder, struct mpm_error *error)
{
    struct records records;
    TRY(records_read(folder, &records, error));
    const enum mpm_status status = case_folders_check(folder, records.run, error);
    records_clear(&records);
    return status;
}

enum mpm_status report_status(enum mpm_status rendered)
{
    return rendered == MPM_RUN_FAILED ? MPM_ENVIRONMENT_FAILED : rendered;
}

enum mpm_status report_render(const char *folder, const char *place,
                              const struct report_sources *sources, struct mpm_error *error)
{
    struct records records;
    struct report_stored stored;
    TRY(records_read(folder, &records, error));
    enum mpm_status status = case_folders_check(folder, records.run, error);
    if (status == MPM_OK)
        status = report_stored_read(folder, &stored, error);
    if (status == MPM_OK) {
        status = render(folder, place, sources, &records, &stored, error);
        report_stored_clear(&stored);
    }
    records_clear(&records);
    return status;
}
