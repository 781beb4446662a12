/* The output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/output_folder.h"

#include "verification/common/folders.h"
#include "verification/report/report.h"
#include "verification/suite/output_publish.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <string.h>
#include <unistd.h>

static const char marker[] = ".mpm-verify";
static const char *const style_names[] = {"style.gp",  "comparison.gp", "report.css",
                                          "page.html", "table.js",      "glossary.md"};
static const char *const source_globs[] = {"*.gp", "*.dat", "*.csv"};

struct output_folder output_names(const char *folder)
{
    char *state = g_build_filename(folder, ".run", NULL);
    return (struct output_folder){
        .folder = g_strdup(folder),
        .state = state,
        .results = g_build_filename(state, "results", NULL),
        .stage = g_build_filename(state, "report", NULL),
        .lock = -1,
    };
}

void output_close(struct output_folder *output)
{
    if (output->lock >= 0)
        close(output->lock);
    g_free(output->folder);
    g_free(output->state);
    g_free(output->results);
    g_free(output->stage);
    *output = (struct output_folder){.lock = -1};
}

/* ------------------------------------------------------------------------ open */

static enum mpm_status refuse_foreign(const char *folder, struct mpm_error *error)
{
    if (g_file_test(folder, G_FILE_TEST_EXISTS) && !g_file_test(folder, G_FILE_TEST_IS_DIR))
        return failure_set(error, MPM_BAD_INPUT, "%s: is a file; --output names a folder", folder);
    enum mpm_status status = MPM_OK;
    char *own = g_build_filename(folder, marker, NULL);
    char *stranger = g_file_test(own, G_FILE_TEST_EXISTS) ? NULL : output_find_ours(folder);
    if (stranger != NULL)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: was not written by mpm-verify and would be replaced; choose "
                             "another --output",
                             stranger);
    g_free(stranger);
    g_free(own);
    return status;
}

/* Takes the marker, and with it the folder, for this process alone: two runs at a time
 * would remove each other's files. */
static enum mpm_status take(const char *folder, int *lock, struct mpm_error *error)
{
    static const char text[] = "Output of mpm-verify: the next run replaces its files.\n";
    char *path = g_build_filename(folder, marker, NULL);
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    enum mpm_status status = MPM_OK;
    *lock = open(path, O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    const bool locked = *lock >= 0 && fcntl(*lock, F_SETLK, &whole) == 0;
    if (!locked && *lock >= 0 && (errno == EAGAIN || errno == EACCES))
        status =
            failure_set(error, MPM_BAD_INPUT, "%s: another run is writing to this folder", folder);
    else if (!locked || ftruncate(*lock, 0) != 0 || write(*lock, text, strlen(text)) < 0)
        status = folder_failed(path, error);
    g_free(path);
    return status;
}

enum mpm_status output_open(const char *folder, struct output_folder *output,
                            struct mpm_error *error)
{
    *output = output_names(folder);
    enum mpm_status status = refuse_foreign(folder, error);
    if (status == MPM_OK)
        status = folder_make(folder, error);
    if (status == MPM_OK)
        status = take(folder, &output->lock, error);
    if (status == MPM_OK)
        status = output_recover(output, error);
    if (status == MPM_OK)
        status = folder_make(output->results, error);
    if (status != MPM_OK)
        output_close(output);
    return status;
}

/* ----------------------------------------------------------------------- stage */

static enum mpm_status copy_file(const char *path, const char *folder, struct mpm_error *error)
{
    char *text = NULL, *name = g_path_get_basename(path);
    size_t length = 0;
    enum mpm_status status = MPM_OK;
    char *copy = g_build_filename(folder, name, NULL);
    if (!g_file_get_contents(path, &text, &length, NULL))
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be read", path);
    else if (!g_file_set_contents(copy, text, (gssize)length, NULL))
        status = folder_failed(copy, error);
    g_free(copy);
    g_free(text);
    g_free(name);
    return status;
}

static bool is_source(const char *name)
{
    for (size_t i = 0; i < G_N_ELEMENTS(source_globs); i++)
        if (g_pattern_match_simple(source_globs[i], name))
            return true;
    return false;
}

static enum mpm_status prepare_case(const char *stage, const struct catalogue_case *entry,
                                    struct mpm_error *error)
{
    char *source = g_build_filename(stage, "cases", entry->file->name, "source", NULL);
    enum mpm_status status = folder_make(source, error);
    GPtrArray *names = folder_names(entry->folder);
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        char *path = g_build_filename(entry->folder, names->pdata[i], NULL);
        if (is_source(names->pdata[i]) && g_file_test(path, G_FILE_TEST_IS_REGULAR))
            status = copy_file(path, source, error);
        g_free(path);
    }
    g_ptr_array_unref(names);
    g_free(source);
    return status;
}

static enum mpm_status prepare_style(const char *stage, const char *reports,
                                     struct mpm_error *error)
{
    char *style = g_build_filename(stage, "style", NULL);
    enum mpm_status status = folder_make(style, error);
    for (size_t i = 0; status == MPM_OK && i < G_N_ELEMENTS(style_names); i++) {
        char *path = g_build_filename(reports, style_names[i], NULL);
        status = copy_file(path, style, error);
        g_free(path);
    }
    g_free(style);
    return status;
}

enum mpm_status output_stage(const struct output_folder *output, const char *reports,
                             const struct plan *plan, struct mpm_error *error)
{
    TRY(folder_remove(output->stage, error));
    TRY(prepare_style(output->stage, reports, error));
    for (size_t i = 0; i < plan->job_count; i++)
        if (i == 0 || plan->jobs[i - 1].entry != plan->jobs[i].entry)
            TRY(prepare_case(output->stage, plan->jobs[i].entry, error));
    return MPM_OK;
}

enum mpm_status output_report(const struct output_folder *output, const char *reports,
                              struct mpm_error *error)
{
    const enum mpm_status rendered = report_render(output->stage, output->folder, reports, error);
    if (rendered == MPM_OK || rendered == MPM_RUN_FAILED)
        TRY(output_publish(output, error));
    return report_status(rendered);
}
