/* The output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/output_folder.h"

#include "mpm_file.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <string.h>

static const char marker[] = ".mpm-verify";
static const char *const top_names[] = {
    "checks.jsonl", "measurements.jsonl", "index.html",   "summary.md",
    "junit.xml",    "results.tap",        "cases",        "style",
    "limits.html",  "headroom.html",      "mutants.html", "glossary.html",
    "changes.json", "headroom.json",      "mutants.json", "table-*.csv"};
static const char *const style_names[] = {"style.gp",  "comparison.gp", "report.css",
                                          "page.html", "table.js",      "glossary.md"};
static const char *const case_globs[] = {"rows-*.jsonl",   "log-*.txt",  "data-*.dat",
                                         "figure-*.svg",   "index.html", "comparison.html",
                                         "comparison.csv", "checks.csv", "runs.csv"};

/* Earlier versions copied the scripts of figures and the style to `source` and `style`. */
static const char *const source_globs[] = {"*.gp", "*.dat", "*.csv"};

static enum mpm_status cannot_write(const char *path, struct mpm_error *error)
{
    return failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                       g_strerror(errno));
}

static enum mpm_status make_folder(const char *path, struct mpm_error *error)
{
    return mpm_folder_make(path) == 0 ? MPM_OK : cannot_write(path, error);
}

static bool any_matches(const char *const *globs, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (g_pattern_match_simple(globs[i], name))
            return true;
    return false;
}

/* Removes every file of `folder` that matches; goes on after failures. */
static enum mpm_status remove_files(const char *folder, const char *const *globs, size_t count,
                                    struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char **const names = mpm_folder_list(folder);
    if (names == NULL && errno != ENOENT)
        return mpm_file_unread(folder, errno, NULL, error);
    for (char **name = names; name != NULL && *name != NULL; name++) {
        char *path = g_build_filename(folder, *name, NULL);
        const enum mpm_path kind =
            any_matches(globs, count, *name) ? mpm_path_kind(path) : MPM_PATH_NONE;
        /* where the system does not say, removing it gives the reason */
        if ((kind == MPM_PATH_FILE || kind == MPM_PATH_UNKNOWN) && mpm_file_remove(path) != 0 &&
            errno != ENOENT)
            status = cannot_write(path, error);
        g_free(path);
    }
    mpm_folder_list_free(names);
    return status;
}

/* ------------------------------------------------------------------ old results */

static enum mpm_status refuse_foreign(const char *folder, struct mpm_error *error)
{
    if (mpm_path_exists(folder) && !mpm_path_is_folder(folder))
        return failure_set(error, MPM_BAD_INPUT, "%s: is a file; --output names a folder", folder);
    enum mpm_status status = MPM_OK;
    char *own = g_build_filename(folder, marker, NULL);
    for (size_t i = 0; i < G_N_ELEMENTS(top_names) && !mpm_path_exists(own); i++) {
        char *path = g_build_filename(folder, top_names[i], NULL);
        if (mpm_path_exists(path))
            status = failure_set(error, MPM_BAD_INPUT,
                                 "%s: was not written by mpm-verify and would be replaced; choose "
                                 "another --output",
                                 path);
        g_free(path);
    }
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
        status = cannot_write(path, error);
    g_free(path);
    return status;
}

void output_release(int lock)
{
    if (lock >= 0)
        (void)mpm_file_close(lock);
}

static enum mpm_status clean_case(const char *path, struct mpm_error *error)
{
    char *source = g_build_filename(path, "source", NULL);
    enum mpm_status status = remove_files(path, case_globs, G_N_ELEMENTS(case_globs), error);
    if (status == MPM_OK)
        status = remove_files(source, source_globs, G_N_ELEMENTS(source_globs), error);
    /* only if nothing else is in them */
    (void)mpm_folder_remove(source);
    (void)mpm_folder_remove(path);
    g_free(source);
    return status;
}

static enum mpm_status clean_style(const char *folder, struct mpm_error *error)
{
    char *style = g_build_filename(folder, "style", NULL);
    const enum mpm_status status =
        remove_files(style, style_names, G_N_ELEMENTS(style_names), error);
    (void)mpm_folder_remove(style);
    g_free(style);
    return status;
}

static enum mpm_status clean_cases(const char *folder, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char *cases = g_build_filename(folder, "cases", NULL);
    GPtrArray *paths = g_ptr_array_new_with_free_func(g_free);
    char **const names = mpm_folder_list(cases);
    if (names == NULL && errno != ENOENT)
        status = mpm_file_unread(cases, errno, NULL, error);
    for (char **name = names; name != NULL && *name != NULL; name++)
        g_ptr_array_add(paths, g_build_filename(cases, *name, NULL));
    mpm_folder_list_free(names);
    for (unsigned i = 0; status == MPM_OK && i < paths->len; i++)
        status = clean_case(paths->pdata[i], error);
    g_ptr_array_unref(paths);
    g_free(cases);
    return status;
}

/* --------------------------------------------------------------------- new run */

static enum mpm_status prepare_case(const char *folder, const struct catalogue_case *entry,
                                    struct mpm_error *error)
{
    char *home = g_build_filename(folder, "cases", entry->file->name, NULL);
    const enum mpm_status status = make_folder(home, error);
    g_free(home);
    return status;
}

static enum mpm_status fill(const char *folder, const struct plan *plan, struct mpm_error *error)
{
    /* a report must not outlive its results, so the old ones go before anything runs */
    TRY(remove_files(folder, top_names, G_N_ELEMENTS(top_names), error));
    TRY(clean_cases(folder, error));
    TRY(clean_style(folder, error));
    for (size_t i = 0; i < plan->job_count; i++)
        if (i == 0 || plan->jobs[i - 1].entry != plan->jobs[i].entry)
            TRY(prepare_case(folder, plan->jobs[i].entry, error));
    return MPM_OK;
}

enum mpm_status output_prepare(const char *folder, const struct plan *plan, int *lock,
                               struct mpm_error *error)
{
    *lock = -1;
    TRY(refuse_foreign(folder, error));
    TRY(make_folder(folder, error));
    enum mpm_status status = take(folder, lock, error);
    if (status == MPM_OK)
        status = fill(folder, plan, error);
    if (status != MPM_OK) {
        output_release(*lock);
        *lock = -1;
    }
    return status;
}
