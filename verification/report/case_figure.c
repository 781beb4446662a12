/* The figures of a case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/case_figure.h"

#include "mpm_file.h"
#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/names.h"
#include "verification/common/result_path.h"

#include <glib.h>
#include <string.h>

/* ------------------------------------------------------------------- the data */

enum mpm_status case_data_files(const char *home, GPtrArray **files, struct mpm_error *error)
{
    GPtrArray *names = NULL;
    /* a folder may have result lines alone */
    const enum mpm_status status = folder_names(home, &names, error);
    *files = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; names != NULL && i < names->len; i++) {
        const char *const name = names->pdata[i];
        if ((g_pattern_match_simple("data-*.dat", name) &&
             !g_pattern_match_simple("data-comparison*", name)) ||
            g_pattern_match_simple("rows-*.jsonl", name) ||
            g_pattern_match_simple("picture-*.json", name))
            g_ptr_array_add(*files, g_strdup(name));
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    return status;
}

static void fail(struct figure_result *result, const char *reason)
{
    result->state = FIGURE_FAILED;
    g_strlcpy(result->reason, reason, sizeof result->reason);
}

/* A reason in the result unless a program left something in the folder of the case. */
static void require_data(const char *home, struct figure_result *result)
{
    struct mpm_error error = {.status = MPM_OK};
    GPtrArray *files;
    if (case_data_files(home, &files, &error) != MPM_OK)
        fail(result, error.message);
    else if (files->len == 0)
        g_strlcpy(result->reason, "this folder holds the result lines alone, not the figure's data",
                  sizeof result->reason);
    g_ptr_array_unref(files);
}

/* The names go into links and pictures, so they are such as a run writes. */
static enum mpm_status check_data(const char *home, struct mpm_error *error)
{
    GPtrArray *files;
    enum mpm_status status = case_data_files(home, &files, error);
    for (unsigned i = 0; status == MPM_OK && i < files->len; i++) {
        const char *name = files->pdata[i];
        char *path = g_build_filename(home, name, NULL);
        char *plain = g_strndup(name, (gsize)(strrchr(name, '.') - name));
        status = name_is_plain(plain)
                     ? result_file_check(path, error)
                     : failure_set(error, MPM_BAD_INPUT,
                                   "%s: is no name of a run's file: allowed are letters, digits, "
                                   "'_' and '-' before the suffix",
                                   path);
        g_free(plain);
        g_free(path);
    }
    g_ptr_array_unref(files);
    return status;
}

enum mpm_status case_folders_check(const char *folder, const json_t *run, struct mpm_error *error)
{
    const json_t *cases = json_object_get(run, "cases");
    char *home = g_build_filename(folder, "cases", NULL);
    enum mpm_status status = result_folder_check(home, error);
    for (size_t i = 0; status == MPM_OK && i < json_array_size(cases); i++) {
        char *own = g_build_filename(home, record_text(json_array_get(cases, i), "case"), NULL);
        status = result_folder_check(own, error);
        if (status == MPM_OK)
            status = check_data(own, error);
        g_free(own);
    }
    g_free(home);
    return status;
}

static bool finished(const json_t *variant)
{
    return strcmp(record_text(variant, "outcome"), "returned") == 0;
}

/* The names, separated by blanks, of the variants that `globs` select; "" with a reason
 * if a glob selects none of this run's or one that did not finish. */
static char *variants_needed(const json_t *entry, const json_t *globs, char *reason, size_t size)
{
    GString *names = g_string_new(NULL);
    const json_t *variants = json_object_get(entry, "variants");
    bool whole = true;
    for (size_t g = 0; g < json_array_size(globs); g++) {
        const char *glob = json_string_value(json_array_get(globs, g));
        size_t matched = 0;
        for (size_t v = 0; glob != NULL && v < json_array_size(variants); v++) {
            const json_t *variant = json_array_get(variants, v);
            const char *name = record_text(variant, "variant");
            if (!glob_matches(glob, name))
                continue;
            matched++;
            if (!finished(variant)) {
                g_snprintf(reason, size, "variant %s did not finish: %s", name,
                           record_text(variant, "outcome"));
                whole = false;
            }
            g_string_append_printf(names, "%s%s", names->len == 0 ? "" : " ", name);
        }
        if (matched == 0 && whole) {
            g_snprintf(reason, size, "it needs variant %s, which this run did not select", glob);
            whole = false;
        }
    }
    if (!whole)
        g_string_truncate(names, 0);
    return g_string_free(names, FALSE);
}

/* ------------------------------------------------------------------ the script */

/* The folder of the case in the catalogue, whose scripts alone are run. */
static char *case_folder(const char *catalogue, const json_t *entry)
{
    return g_build_filename(catalogue, record_text(entry, "family"), record_text(entry, "case"),
                            NULL);
}

/* The path of the script, and in the result's note whether it is the one that the run had; NULL
 * with a reason if the catalogue does not have it. */
static char *find_script(const char *home, const json_t *entry, const json_t *figure,
                         struct figure_result *result)
{
    const char *recorded = record_text(figure, "script_sha256");
    struct mpm_error error = {.status = MPM_OK};
    char *path = g_build_filename(home, record_text(figure, "script"), NULL), *text = NULL;
    size_t length = 0;
    if (mpm_path_kind(home) == MPM_PATH_NONE)
        g_snprintf(result->reason, sizeof result->reason,
                   "case %s is not in the catalogue, whose scripts draw figures",
                   record_text(entry, "case"));
    else if (input_text(path, NULL, &text, &length, &error) == MPM_ENVIRONMENT_FAILED)
        fail(result, error.message);
    else if (text == NULL)
        g_snprintf(result->reason, sizeof result->reason,
                   "its script %s is not in the catalogue's folder of case %s",
                   record_text(figure, "script"), record_text(entry, "case"));
    if (text == NULL) {
        g_free(path);
        return NULL;
    }
    char *own = g_compute_checksum_for_data(G_CHECKSUM_SHA256, (const guchar *)text, length);
    result->note = *recorded == '\0' ? "The run did not record which script it had; the "
                                       "catalogue's has drawn this."
                   : strcmp(own, recorded) != 0
                       ? "The script in the catalogue is another one than the run had."
                       : NULL;
    g_free(own);
    g_free(text);
    return path;
}

/* -------------------------------------------------------------------- drawing */

/* Absolute paths: the script runs elsewhere. */
static char *settings_of(const char *home, const char *source, const json_t *run,
                         const json_t *figure, const char *variants)
{
    char *stamp = g_strdup_printf("Touchstone %s, %s", record_text(run, "version"),
                                  record_text(run, "revision"));
    char *data_path = g_canonicalize_filename(home, NULL),
         *source_path = g_canonicalize_filename(source, NULL);
    char *texts[] = {figure_quoted(record_text(figure, "figure")), figure_quoted(data_path),
                     figure_quoted(source_path), figure_quoted(variants), figure_quoted(stamp)};
    char *settings = g_strdup_printf("name=%s; data=%s; source=%s; variants=%s; stamp=%s", texts[0],
                                     texts[1], texts[2], texts[3], texts[4]);
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_free(source_path);
    g_free(data_path);
    g_free(stamp);
    return settings;
}

static void draw(const struct report_sources *sources, const char *home, const char *settings,
                 const char *script, const json_t *figure, struct figure_result *result)
{
    char *style = g_build_filename(sources->reports, "style.gp", NULL);
    char *file = g_strdup_printf("figure-%s.svg", record_text(figure, "figure"));
    char *description = g_strdup_printf("%s Reference: %s", record_text(figure, "caption"),
                                        record_text(figure, "reference"));
    const char *note = result->note;
    *result = figure_plot(&(struct figure_plot){.script = script,
                                                .style = style,
                                                .settings = settings,
                                                .folder = home,
                                                .output = file,
                                                .title = record_text(figure, "title"),
                                                .description = description});
    result->note = note;
    g_free(description);
    g_free(file);
    g_free(style);
}

struct figure_result figure_draw(const char *folder, const struct report_sources *sources,
                                 const json_t *run, const json_t *entry, const json_t *figure)
{
    struct figure_result result = {.state = FIGURE_WITHOUT_DATA};
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    char *source = sources->catalogue == NULL ? NULL : case_folder(sources->catalogue, entry);
    char *script = NULL;
    char *variants = variants_needed(entry, json_object_get(figure, "needs"), result.reason,
                                     sizeof result.reason);
    if (result.reason[0] == '\0')
        require_data(home, &result);
    if (result.reason[0] == '\0' && source == NULL)
        g_strlcpy(result.reason, "no catalogue is found, whose scripts draw figures",
                  sizeof result.reason);
    if (result.reason[0] == '\0')
        script = find_script(source, entry, figure, &result);
    if (script != NULL) {
        char *settings = settings_of(home, source, run, figure, variants);
        draw(sources, home, settings, script, figure, &result);
        g_free(settings);
    }
    g_free(script);
    g_free(variants);
    g_free(source);
    g_free(home);
    return result;
}
