/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study_catalogue.h"

#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/suite/output_folder.h"

#include <jansson.h>
#include <stdlib.h>

#define FAMILY "study"

char *study_folder(const char *output)
{
    return g_build_filename(output, "study", NULL);
}

char *study_file_path(const char *output)
{
    return g_build_filename(output, "study", "study.yaml", NULL);
}

char *study_scene_path(const char *output)
{
    return g_build_filename(output, "study", "scene.yaml", NULL);
}

char *study_catalogue(const char *output)
{
    return g_build_filename(output, "study", "catalogue", NULL);
}

/* ------------------------------------------------------------------------- a case */

static void add_parameter(json_t *list, const char *name, unsigned k, const char *value)
{
    char *key = k == 0 ? g_strdup(name) : g_strdup_printf("%s_%u", name, k);
    if (value != NULL)
        json_array_append_new(list, json_pack("{s:s,s:s}", "name", key, "value", value));
    g_free(key);
}

/* Only what the run has to know: a number, finest and richardson change no run. */
static void add_measure(json_t *list, const struct study_entry *entry, unsigned k)
{
    const bool file = entry->reference != NULL && g_str_has_suffix(entry->reference, ".csv");
    char *copy = g_strdup_printf("reference-%u.csv", k);
    char *at = entry->instant_text != NULL ? g_strdup(entry->instant_text)
               : entry->at_text[0] != NULL
                   ? g_strconcat(entry->at_text[0], " ", entry->at_text[1], NULL)
                   : NULL;
    add_parameter(list, "quantity", k, entry->quantity);
    add_parameter(list, "take", k, entry->take_text);
    add_parameter(list, "at", k, at);
    if (entry->against == AGAINST_EVALUATED)
        add_parameter(list, "reference", k, file ? copy : entry->reference);
    g_free(at);
    g_free(copy);
}

static json_t *parameters(const struct study *study, const char *home)
{
    json_t *list = json_array();
    char *count = g_strdup_printf("%u", study->measures_count);
    bool files = false;
    add_parameter(list, "measures", 0, count);
    add_parameter(list, "axisymmetric", 0, study->axisymmetric ? "1" : "0");
    for (unsigned k = 0; k < study->measures_count; k++) {
        const char *reference = study->measures[k].reference;
        add_measure(list, &study->measures[k], k + 1);
        files = files || (reference != NULL && g_str_has_suffix(reference, ".csv"));
    }
    char *folder = g_canonicalize_filename(home, NULL);
    if (files)
        add_parameter(list, "folder", 0, folder);
    g_free(folder);
    g_free(count);
    return list;
}

static json_t *case_json(const struct study *study, const struct study_run *run, const char *home)
{
    json_t *settings = json_array();
    for (char **setting = run->settings; *setting != NULL; setting++)
        json_array_append_new(settings, json_string(*setting));
    char *title = g_strdup_printf("%s%srefined by %" PRId64, run->variant,
                                  *run->variant == '\0' ? "" : ", ", run->level);
    json_t *variant = json_pack("{s:s,s:s,s:f,s:o}", "name", "run", "tier", "ci", "timeout",
                                study->timeout, "settings", settings);
    json_t *check = json_pack(
        "{s:s,s:s,s:[s],s:s,s:s,s:s,s:f,s:f,s:f,s:s,s:s}", "check", "completed", "title",
        "the run comes to its end", "variants", "run", "quantity", "completed", "unit", "1", "norm",
        "1 of a run that has come to its end", "expected", 1.0, "low", 0.5, "high", 1.5, "basis",
        "theory", "why", "the program reports 1 after the last step, and fails otherwise");
    json_t *file = json_pack(
        "{s:i,s:s,s:s,s:s,s:s,s:[s],s:s,s:s,s:o,s:[o],s:[o],s:s}", "format", 1, "family", FAMILY,
        "case", run->name, "title", title, "summary", study->title, "tags", "study", "program",
        "study", "scene", "scene.yaml", "parameters", parameters(study, home), "variants", variant,
        "checks", check, "no_bundle", "a run of a study is no case for other solvers");
    g_free(title);
    return file;
}

static enum mpm_status write_references(const struct study *study, const char *home,
                                        struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    for (unsigned k = 0; status == MPM_OK && k < study->measures_count; k++) {
        const char *reference = study->measures[k].reference;
        char *text = NULL;
        if (reference == NULL || !g_str_has_suffix(reference, ".csv"))
            continue;
        char *name = g_strdup_printf("reference-%u.csv", k + 1);
        status = input_text(reference, NULL, &text, NULL, error);
        if (status == MPM_OK)
            status = output_write(home, name, text, error);
        g_free(text);
        g_free(name);
    }
    return status;
}

static const char readme[] =
    "# A run of a convergence study\n\n"
    "The scene is that of the study. `mpm-verify study` has made this case; the study's tables and "
    "pictures are in the folder `study`.\n\n"
    "The only check is that the run comes to its end: with the reference of a study, its measures "
    "are judged over all its runs.\n";

static enum mpm_status write_case(const struct study *study, const struct study_run *run,
                                  const char *catalogue, struct mpm_error *error)
{
    char *home = g_build_filename(catalogue, FAMILY, run->name, NULL);
    json_t *file = case_json(study, run, home);
    char *text = json_dumps(file, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    enum mpm_status status = folder_make(home, error);
    if (status == MPM_OK)
        status = write_references(study, home, error);
    if (status == MPM_OK)
        status = output_write(home, "scene.yaml", study->scene_text, error);
    if (status == MPM_OK)
        status = output_write(home, "README.md", readme, error);
    if (status == MPM_OK)
        status = output_write(home, "case.yaml", text, error);
    free(text);
    json_decref(file);
    g_free(home);
    return status;
}

/* ------------------------------------------------------------------------ folders */

static enum mpm_status write_all(const struct study *study, const GArray *runs, const char *output,
                                 struct mpm_error *error)
{
    char *folder = study_folder(output), *catalogue = study_catalogue(output);
    char *text = study_text(study);
    enum mpm_status status = folder_make(folder, error);
    if (status == MPM_OK)
        status = output_write(folder, "study.yaml", text, error);
    if (status == MPM_OK)
        status = output_write(folder, "scene.yaml", study->scene_text, error);
    if (status == MPM_OK)
        status = folder_remove(catalogue, error);
    for (unsigned i = 0; status == MPM_OK && i < runs->len; i++)
        status = write_case(study, &g_array_index(runs, struct study_run, i), catalogue, error);
    g_free(text);
    g_free(catalogue);
    g_free(folder);
    return status;
}

enum mpm_status study_catalogue_write(const struct study *study, const char *output,
                                      struct mpm_error *error)
{
    struct output_folder taken;
    GArray *runs;
    TRY(study_runs(study, &runs, error));
    enum mpm_status status = output_open(output, &taken, error);
    if (status == MPM_OK) {
        status = write_all(study, runs, output, error);
        output_close(&taken);
    }
    g_array_unref(runs);
    return status;
}
