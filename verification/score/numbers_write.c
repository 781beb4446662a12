/* A bundle of numbers, written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/resources.h"
#include "verification/common/scene_json.h"
#include "verification/score/bundle_convert.h"
#include "verification/score/bundle_folder.h"
#include "verification/score/numbers.h"

#include <string.h>

/* -------------------------------------------------------------------------- JSON */

static json_t *number_json(const struct case_check *number)
{
    json_t *object = json_object();
    json_object_set_new(object, "criterion", record_text_of(number->name));
    json_object_set_new(object, "title", record_text_of(number->title));
    json_object_set_new(object, "quantity", record_text_of(number->quantity));
    json_object_set_new(object, "unit", record_text_of(number->unit));
    json_object_set_new(object, "expected", json_real(number->band.expected));
    json_object_set_new(object, "low", json_real(number->band.low));
    json_object_set_new(object, "high", json_real(number->band.high));
    json_object_set_new(object, "basis", json_string(basis_name(number->basis)));
    json_object_set_new(object, "why", record_text_of(number->why));
    return object;
}

static json_t *bundle_json(const struct catalogue_case *entry, const json_t *scene)
{
    const struct case_numbers *numbers = entry->file->numbers;
    json_t *object = bundle_facts(entry, scene, numbers->about, "numbers");
    json_t *files = json_array(), *criteria = json_array();
    for (unsigned i = 0; i < numbers->files_count; i++) {
        char *name = g_path_get_basename(numbers->files[i]);
        json_array_append_new(files, record_text_of(name));
        g_free(name);
    }
    for (unsigned i = 0; i < numbers->list_count; i++)
        json_array_append_new(criteria, number_json(&numbers->list[i]));
    json_object_set(json_object_get(object, "problem"), "time_of_the_case",
                    json_object_get(scene, "time"));
    json_object_set_new(object, "files", files);
    json_object_set_new(object, "criteria", criteria);
    return object;
}

/* ------------------------------------------------------------------------- words */

static char *words_text(const struct catalogue_case *entry, const json_t *json)
{
    const struct case_numbers *numbers = entry->file->numbers;
    GString *text = bundle_words_begin(entry, numbers->about);
    g_string_append(
        text, "`problem.json` states geometry, units, materials, bodies, conditions and loads, as "
              "the scene of the case has them; texts such as \"sin(pi*x/16)\" are formulas in the "
              "place and the time `t`.\n\n");
    bundle_words_of_laws(text, json);
    g_string_append(text, "## What to write\n\nThese numbers, each found in your own way, as CSV. "
                          "0 counts as no result: write a difference that is exactly 0 as "
                          "1e-17.\n\n    number,value,unit\n");
    for (unsigned i = 0; i < numbers->list_count; i++)
        g_string_append_printf(text, "    %s,...,%s\n", numbers->list[i].name,
                               numbers->list[i].unit);
    g_string_append(text, "\nThen\n\n    mpm-verify score BUNDLE RESULTS.csv\n\n## Criteria\n\n");
    for (unsigned i = 0; i < numbers->list_count; i++) {
        const struct case_check *number = &numbers->list[i];
        const char *const unit = strcmp(number->unit, "1") == 0 ? "" : number->unit;
        g_string_append_printf(text, "- **%s** (`%s`): %s. Expected %s, allowed %s to %s%s%s. %s\n",
                               number->title, number->name, number->quantity, number->expected_text,
                               number->low_text, number->high_text, *unit == '\0' ? "" : " ", unit,
                               number->why);
    }
    bundle_words_of_conversion(text, json, 0.0);
    return bundle_words_end(entry, text);
}

/* ------------------------------------------------------------------------- files */

/* Adds the texts of the files. MPM_BAD_INPUT: one is not there. */
static enum mpm_status read_files(const struct catalogue_case *entry, GPtrArray *texts,
                                  struct mpm_error *error)
{
    const struct case_numbers *numbers = entry->file->numbers;
    char *folder = resources_reference_data("mpm-verify");
    enum mpm_status status = MPM_OK;
    for (unsigned i = 0; status == MPM_OK && i < numbers->files_count; i++) {
        char *path =
            g_build_filename(folder == NULL ? "reference_data" : folder, numbers->files[i], NULL);
        char *text = NULL;
        status = input_text(path, "a file of reference_data", &text, NULL, error);
        if (text != NULL)
            g_ptr_array_add(texts, text);
        g_free(path);
    }
    g_free(folder);
    return status;
}

static enum mpm_status write_files(const struct catalogue_case *entry, const json_t *scene,
                                   const GPtrArray *texts, const char *home,
                                   struct mpm_error *error)
{
    json_t *json = bundle_json(entry, scene);
    char *words = words_text(entry, json);
    enum mpm_status status = MPM_OK;
    for (guint i = 0; status == MPM_OK && i < texts->len; i++) {
        char *name = g_path_get_basename(entry->file->numbers->files[i]);
        status = output_write(home, name, texts->pdata[i], error);
        g_free(name);
    }
    if (status == MPM_OK)
        status = bundle_describe(home, words, json, error);
    g_free(words);
    json_decref(json);
    return status;
}

enum mpm_status numbers_write(const struct catalogue_case *entry, const char *folder,
                              struct mpm_error *error)
{
    json_t *scene = NULL;
    char *home = NULL;
    GPtrArray *texts = g_ptr_array_new_with_free_func(g_free);
    enum mpm_status status = scene_json_read(entry->scene_path, &scene, error);
    if (status == MPM_OK)
        status = read_files(entry, texts, error);
    if (status == MPM_OK)
        status = bundle_home(entry, folder, &home, error);
    if (status == MPM_OK)
        status = write_files(entry, scene, texts, home, error);
    json_decref(scene);
    g_ptr_array_unref(texts);
    g_free(home);
    return status;
}
