/* A study's file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/yaml_read.h"
#include "verification/study/study.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#define PAIR(key, type, member) YAML_KEY(key, PAIR, false, type, member, YAML_KIND(number))

static const struct mpm_key vary_keys[] = {YAML_TEXT("path", study_vary, path),
                                           YAML_TEXTS("values", study_vary, values, 1), YAML_END};

static const struct mpm_key measure_keys[] = {
    YAML_OPTIONAL_TEXT("measure", study_entry, name),
    YAML_TEXT("quantity", study_entry, quantity),
    YAML_OPTIONAL_TEXT("take", study_entry, take_text),
    PAIR("point", study_entry, at_text),
    YAML_OPTIONAL_NUMBER("time", study_entry, instant_text),
    YAML_OPTIONAL_TEXT("reference", study_entry, reference),
    YAML_OPTIONAL_TEXT("unit", study_entry, unit),
    PAIR("order", study_entry, order_text),
    YAML_END};

static const struct mpm_key study_keys[] = {
    YAML_INTEGER("format", study, format, 1, 1),
    YAML_OPTIONAL_TEXT("title", study, title),
    YAML_TEXT("scene", study, scene),
    YAML_KEY("refine", VALUES, true, study, refine, .value = &mpm_kind_integer,
             .count_offset = offsetof(struct study, refine_count), YAML_RANGE(1, STUDY_LEVELS_MAX)),
    YAML_LIST("vary", study, vary, study_vary, vary_keys, 0),
    YAML_TEXTS("settings", study, settings, 0),
    YAML_LIST("measures", study, measures, study_entry, measure_keys, 1),
    YAML_OPTIONAL_NUMBER("timeout", study, timeout_text),
    YAML_END};
static const struct mpm_key whole_file = YAML_FILE(study, study_keys);

enum mpm_status study_is_file(const char *path, bool *is_study, struct mpm_error *error)
{
    struct mpm_tree_node *root;
    TRY(mpm_tree_read(path, &root, error));
    *is_study = mpm_tree_find(root, "scene", NULL) != NULL;
    mpm_tree_free(root);
    return MPM_OK;
}

/* Paths in a study are relative to its file. */
static void resolve(const char *path, char **name)
{
    if (g_path_is_absolute(*name))
        return;
    char *folder = g_path_get_dirname(path), *whole = g_build_filename(folder, *name, NULL);
    free(*name);
    *name = strdup(whole);
    g_free(whole);
    g_free(folder);
}

enum mpm_status study_read(const char *path, struct study **study, struct mpm_error *error)
{
    void *data;
    *study = NULL;
    TRY(mpm_keys_read(path, &whole_file, &data, error));
    *study = data;
    resolve(path, &(*study)->scene);
    for (unsigned k = 0; k < (*study)->measures_count; k++) {
        char **const reference = &(*study)->measures[k].reference;
        if (*reference != NULL && g_str_has_suffix(*reference, ".csv"))
            resolve(path, reference);
    }
    return MPM_OK;
}

void study_free(struct study *study)
{
    if (study == NULL)
        return;
    free(study->length_unit);
    free(study->scene_text);
    mpm_keys_free(&whole_file, study);
}

/* ------------------------------------------------------------------------- text */

/* A number that was checked, as itself: a text in quotes is no number for the reader. */
static json_t *number(const char *text)
{
    return json_real(g_ascii_strtod(text, NULL));
}

static void put(json_t *object, const char *key, const char *text)
{
    if (text != NULL)
        json_object_set_new(object, key, json_string(text));
}

static void put_pair(json_t *object, const char *key, char *const pair[2])
{
    if (pair[0] != NULL)
        json_object_set_new(object, key, json_pack("[o,o]", number(pair[0]), number(pair[1])));
}

static json_t *texts(char *const *list, unsigned count)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < count; i++)
        json_array_append_new(array, json_string(list[i]));
    return array;
}

static json_t *entry_json(const struct study_entry *entry)
{
    json_t *object = json_object();
    char *reference = entry->reference != NULL && g_str_has_suffix(entry->reference, ".csv")
                          ? g_canonicalize_filename(entry->reference, NULL)
                          : g_strdup(entry->reference);
    put(object, "measure", entry->name);
    put(object, "quantity", entry->quantity);
    put(object, "take", entry->take_text);
    put_pair(object, "point", entry->at_text);
    if (entry->instant_text != NULL)
        json_object_set_new(object, "time", number(entry->instant_text));
    put(object, "reference", reference);
    put(object, "unit", entry->unit);
    put_pair(object, "order", entry->order_text);
    g_free(reference);
    return object;
}

char *study_text(const struct study *study)
{
    char *scene = g_canonicalize_filename(study->scene, NULL);
    json_t *object = json_object(), *refine = json_array(), *vary = json_array();
    json_t *measures = json_array();
    for (unsigned i = 0; i < study->refine_count; i++)
        json_array_append_new(refine, json_integer(study->refine[i]));
    for (unsigned i = 0; i < study->vary_count; i++)
        json_array_append_new(vary,
                              json_pack("{s:s,s:o}", "path", study->vary[i].path, "values",
                                        texts(study->vary[i].values, study->vary[i].values_count)));
    for (unsigned i = 0; i < study->measures_count; i++)
        json_array_append_new(measures, entry_json(&study->measures[i]));
    json_object_set_new(object, "format", json_integer(1));
    put(object, "title", study->title);
    put(object, "scene", scene);
    json_object_set_new(object, "refine", refine);
    json_object_set_new(object, "vary", vary);
    json_object_set_new(object, "settings", texts(study->settings, study->settings_count));
    json_object_set_new(object, "measures", measures);
    if (study->timeout_text != NULL)
        json_object_set_new(object, "timeout", number(study->timeout_text));
    char *dumped = json_dumps(object, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    char *text = g_strconcat(dumped, "\n", NULL);
    free(dumped);
    json_decref(object);
    g_free(scene);
    return text;
}
