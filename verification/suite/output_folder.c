/* The output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/output_folder.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/suite/output_publish.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <string.h>

static const char marker[] = ".mpm-verify";

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
        (void)mpm_file_close(output->lock);
    g_free(output->folder);
    g_free(output->state);
    g_free(output->results);
    g_free(output->stage);
    *output = (struct output_folder){.lock = -1};
}

/* ------------------------------------------------------------------------ open */

static enum mpm_status refuse_foreign(const char *folder, struct mpm_error *error)
{
    enum mpm_path kind;
    TRY(input_kind(folder, &kind, error));
    if (kind != MPM_PATH_NONE && kind != MPM_PATH_FOLDER)
        return failure_set(error, MPM_BAD_INPUT, "%s: is a file; --output names a folder", folder);
    char *own = g_build_filename(folder, marker, NULL);
    char *stranger = NULL;
    enum mpm_status status = input_kind(own, &kind, error);
    if (status == MPM_OK && kind == MPM_PATH_NONE)
        status = output_find_ours(folder, &stranger, error);
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
    enum mpm_status status = MPM_OK;
    *lock = mpm_file_open(path, O_CREAT | O_RDWR);
    const bool locked = *lock >= 0 && mpm_file_lock(*lock) == 0;
    if (!locked && *lock >= 0 && (errno == EAGAIN || errno == EACCES))
        status =
            failure_set(error, MPM_BAD_INPUT, "%s: another run is writing to this folder", folder);
    else if (!locked || mpm_file_cut(*lock, 0) != 0 ||
             mpm_file_write(*lock, text, strlen(text)) != 0)
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

static enum mpm_status prepare_case(const char *stage, const struct catalogue_case *entry,
                                    struct mpm_error *error)
{
    char *home = g_build_filename(stage, "cases", entry->file->name, NULL);
    const enum mpm_status status = folder_make(home, error);
    g_free(home);
    return status;
}

enum mpm_status output_stage(const struct output_folder *output, const struct plan *plan,
                             struct mpm_error *error)
{
    TRY(folder_remove(output->stage, error));
    TRY(folder_make(output->stage, error));
    for (size_t i = 0; i < plan->job_count; i++)
        if (i == 0 || plan->jobs[i - 1].entry != plan->jobs[i].entry)
            TRY(prepare_case(output->stage, plan->jobs[i].entry, error));
    return MPM_OK;
}

enum mpm_status output_report(const struct output_folder *output,
                              const struct report_sources *sources, struct mpm_error *error)
{
    const enum mpm_status rendered = report_render(output->stage, output->folder, sources, error);
    if (rendered == MPM_OK || rendered == MPM_RUN_FAILED)
        TRY(output_publish(output, error));
    return report_status(rendered);
}
