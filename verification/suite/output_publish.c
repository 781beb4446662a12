/* The list of the report's files is written first; after that every step may be cut short and is
 * done again from the list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/output_publish.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/output.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <string.h>

static const char list_name[] = "publish";

static const char *const top_names[] = {
    "checks.jsonl", "measurements.jsonl", "index.html",    "summary.md",   "junit.xml",
    "results.tap",  "limits.html",        "headroom.html", "mutants.html", "glossary.html",
    "history.html", "decision.html",      "checks.html",   "changes.json", "headroom.json",
    "mutants.json", "history.json",       "table-*.csv"};
static const char *const folder_names_ours[] = {"cases", "style", "api"};
static const char *const style_names[] = {"style.gp",  "comparison.gp", "report.css",
                                          "page.html", "table.js",      "glossary.md",
                                          "filter.js", "equations.json"};
static const char *const case_names[] = {"rows-*.jsonl", "log-*.txt",       "data-*.dat",
                                         "figure-*.svg", "picture-*.json",  "picture-*.svg",
                                         "index.html",   "comparison.html", "comparison.csv",
                                         "checks.csv",   "runs.csv"};
static const char *const api_names[] = {"*.html", "*.css", "*.png"};
static const char *const source_names[] = {"*.gp", "*.dat", "*.csv"};

static bool any_matches(const char *const *globs, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (g_pattern_match_simple(globs[i], name))
            return true;
    return false;
}

enum mpm_status output_find_ours(const char *folder, char **found, struct mpm_error *error)
{
    GPtrArray *names;
    *found = NULL;
    TRY(folder_names(folder, &names, error));
    for (unsigned i = 0; *found == NULL && i < names->len; i++)
        if (any_matches(top_names, G_N_ELEMENTS(top_names), names->pdata[i]) ||
            any_matches(folder_names_ours, G_N_ELEMENTS(folder_names_ours), names->pdata[i]))
            *found = g_build_filename(folder, names->pdata[i], NULL);
    g_ptr_array_unref(names);
    return MPM_OK;
}

/* ---------------------------------------------------------------- new files in */

/* What programs wrote may not be on the disk yet. */
static enum mpm_status sync_file(const char *path, struct mpm_error *error)
{
    const int file = mpm_file_open(path, O_RDONLY);
    const int failed = file < 0 || mpm_file_sync(file) != 0;
    const enum mpm_status status = failed ? mpm_file_failed(path, errno, error) : MPM_OK;
    if (file >= 0)
        (void)mpm_file_close(file);
    return status;
}

/* Paths of all files below a folder, from it on; all are on the disk afterwards. What a program
 * left half-written goes with the stage. */
static enum mpm_status add_files(const char *root, const char *below, GPtrArray *paths,
                                 struct mpm_error *error)
{
    char *folder = g_build_filename(root, below, NULL);
    GPtrArray *names;
    enum mpm_status status = folder_names(folder, &names, error);
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        char *path = *below == '\0' ? g_strdup(names->pdata[i])
                                    : g_build_filename(below, names->pdata[i], NULL);
        char *whole = g_build_filename(root, path, NULL);
        enum mpm_path kind;
        status = input_kind(whole, &kind, error);
        if (status == MPM_OK && kind == MPM_PATH_FOLDER) {
            status = add_files(root, path, paths, error);
        } else if (status == MPM_OK && !g_str_has_suffix(path, MPM_PARTIAL_SUFFIX)) {
            status = sync_file(whole, error);
            g_ptr_array_add(paths, g_strdup(path));
        }
        g_free(whole);
        g_free(path);
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    g_free(folder);
    return status;
}

static enum mpm_status move_in(const struct output_folder *output, const char *path,
                               struct mpm_error *error)
{
    char *from = g_build_filename(output->stage, path, NULL);
    char *to = g_build_filename(output->folder, path, NULL);
    char *home = g_path_get_dirname(to);
    enum mpm_status status = folder_make(home, error);
    /* moved before: the publication was cut short */
    const int failed = status == MPM_OK ? mpm_path_rename(from, to) : 0;
    const int reason = errno;
    if (failed != 0 && !(reason == ENOENT && mpm_path_exists(to)))
        status = mpm_file_failed(to, reason, error);
    g_free(home);
    g_free(to);
    g_free(from);
    return status;
}

/* ---------------------------------------------------------------- old files out */

struct leftovers {
    const char *folder;
    GHashTable *kept; /* paths of the new report */
    struct mpm_error *error;
    enum mpm_status status;
};

static void remove_matching(struct leftovers *leftovers, const char *below,
                            const char *const *globs, size_t count)
{
    char *folder = g_build_filename(leftovers->folder, below, NULL);
    GPtrArray *names = NULL;
    if (leftovers->status == MPM_OK)
        leftovers->status = folder_names(folder, &names, leftovers->error);
    for (unsigned i = 0; leftovers->status == MPM_OK && i < names->len; i++) {
        char *path = *below == '\0' ? g_strdup(names->pdata[i])
                                    : g_build_filename(below, names->pdata[i], NULL);
        char *whole = g_build_filename(leftovers->folder, path, NULL);
        if (any_matches(globs, count, names->pdata[i]) &&
            !g_hash_table_contains(leftovers->kept, path) &&
            mpm_path_kind(whole) != MPM_PATH_FOLDER)
            leftovers->status = folder_remove(whole, leftovers->error);
        g_free(whole);
        g_free(path);
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    (void)mpm_folder_remove(folder); /* only if nothing is left in it */
    g_free(folder);
}

static enum mpm_status remove_leftovers(const struct output_folder *output, char *const *kept,
                                        struct mpm_error *error)
{
    struct leftovers leftovers = {output->folder, g_hash_table_new(g_str_hash, g_str_equal), error,
                                  MPM_OK};
    char *cases = g_build_filename(output->folder, "cases", NULL);
    GPtrArray *names;
    leftovers.status = folder_names(cases, &names, error);
    for (; *kept != NULL; kept++)
        g_hash_table_add(leftovers.kept, *kept);
    remove_matching(&leftovers, "", top_names, G_N_ELEMENTS(top_names));
    remove_matching(&leftovers, "style", style_names, G_N_ELEMENTS(style_names));
    remove_matching(&leftovers, "api", api_names, G_N_ELEMENTS(api_names));
    for (unsigned i = 0; names != NULL && i < names->len; i++) {
        char *below = g_build_filename("cases", names->pdata[i], NULL);
        char *source = g_build_filename(below, "source", NULL);
        remove_matching(&leftovers, source, source_names, G_N_ELEMENTS(source_names));
        remove_matching(&leftovers, below, case_names, G_N_ELEMENTS(case_names));
        g_free(source);
        g_free(below);
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    g_free(cases);
    g_hash_table_unref(leftovers.kept);
    return leftovers.status;
}

/* --------------------------------------------------------------------- both */

static enum mpm_status carry_out(const struct output_folder *output, char *const *paths,
                                 struct mpm_error *error)
{
    for (char *const *path = paths; *path != NULL; path++)
        TRY(move_in(output, *path, error));
    TRY(remove_leftovers(output, paths, error));
    TRY(folder_remove(output->stage, error));
    char *list = g_build_filename(output->state, list_name, NULL);
    const enum mpm_status status = folder_remove(list, error);
    g_free(list);
    return status;
}

enum mpm_status output_recover(const struct output_folder *output, struct mpm_error *error)
{
    char *list = g_build_filename(output->state, list_name, NULL), *text = NULL;
    enum mpm_path kind;
    enum mpm_status status = input_kind(list, &kind, error);
    if (status == MPM_OK && kind != MPM_PATH_NONE)
        status = input_text(list, NULL, &text, NULL, error);
    if (text != NULL) {
        char **paths = g_strsplit(g_strchomp(text), "\n", -1);
        status = carry_out(output, paths, error);
        g_strfreev(paths);
    }
    g_free(text);
    g_free(list);
    return status;
}

enum mpm_status output_publish(const struct output_folder *output, struct mpm_error *error)
{
    GPtrArray *paths = g_ptr_array_new_with_free_func(g_free);
    enum mpm_status status = add_files(output->stage, "", paths, error);
    g_ptr_array_add(paths, NULL);
    char *text = g_strjoinv("\n", (char **)paths->pdata);
    if (status == MPM_OK)
        status = output_write(output->state, list_name, text, error);
    if (status == MPM_OK)
        status = carry_out(output, (char *const *)paths->pdata, error);
    g_free(text);
    g_ptr_array_unref(paths);
    return status;
}
