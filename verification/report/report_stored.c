/* What a report shows beside its own run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/report_stored.h"

#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/record_shape.h"
#include "verification/common/result_path.h"
#include "verification/records/changes.h"
#include "verification/records/history.h"
#include "verification/report/api_pages.h"

#include <stdlib.h>
#include <string.h>

static const char changes_name[] = "changes.json", headroom_name[] = "headroom.json",
                  mutants_name[] = "mutants.json", history_name[] = "history.json";

/* Relative; the default of mpm-verify compare. */
static const double change_shown = 1e-3;

static enum mpm_status write_json(const char *folder, const char *name, json_t *object,
                                  struct mpm_error *error)
{
    char *text = json_dumps(object, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    const enum mpm_status status = output_write(folder, name, text, error);
    free(text);
    json_decref(object);
    return status;
}

static enum mpm_status keep_changes(const char *folder, const char *baseline,
                                    struct mpm_error *error)
{
    struct records before, after;
    TRY(records_read(baseline, &before, error));
    enum mpm_status status = records_read(folder, &after, error);
    if (status == MPM_OK) {
        struct changes changes = changes_gather(&before, &after, change_shown);
        status = write_json(folder, changes_name,
                            changes_record(&changes, before.run, after.run, change_shown), error);
        changes_clear(&changes);
        records_clear(&after);
    }
    records_clear(&before);
    return status;
}

/* ------------------------------------------------------------------- headroom */

static json_t *build_record(const char *name, const struct records *records)
{
    static const char *const keys[] = {"revision", "compiler", "flags", "simd", "kernels"};
    json_t *build = json_object(), *values = json_object();
    json_object_set_new(build, "name", record_text_of(name));
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        json_object_set_new(build, keys[i], json_string(record_text(records->run, keys[i])));
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (record_status(check) == VERDICT_SKIP)
            continue; /* not run, which is no value that is missing */
        char *key = record_key(check, "check");
        json_object_set(values, key, json_object_get(check, "value"));
        g_free(key);
    }
    json_object_set_new(build, "values", values);
    return build;
}

static bool is_named(const json_t *builds, const char *name)
{
    for (size_t i = 0; i < json_array_size(builds); i++)
        if (strcmp(record_text(json_array_get(builds, i), "name"), name) == 0)
            return true;
    return false;
}

/* The run of NAME=DIR as one more build. */
static enum mpm_status add_build(json_t *builds, const char *entry, struct mpm_error *error)
{
    const char *is = strchr(entry, '=');
    struct records records = {0};
    if (is == NULL || is == entry || is[1] == '\0')
        return failure_set(error, MPM_BAD_INPUT, "--headroom \"%s\": allowed is NAME=DIR", entry);
    char *name = g_strndup(entry, (gsize)(is - entry));
    enum mpm_status status =
        is_named(builds, name)
            ? failure_set(error, MPM_BAD_INPUT,
                          "--headroom \"%s\": \"%s\" is given twice: allowed is a name of its own "
                          "for each build",
                          entry, name)
            : records_read(is + 1, &records, error);
    if (status == MPM_OK) {
        json_array_append_new(builds, build_record(name, &records));
        records_clear(&records);
    }
    g_free(name);
    return status;
}

static enum mpm_status keep_headroom(const char *folder, const char *const *entries,
                                     struct mpm_error *error)
{
    json_t *object = json_object(), *builds = json_array();
    enum mpm_status status = MPM_OK;
    json_object_set_new(object, "format", json_integer(1));
    json_object_set_new(object, "builds", builds);
    for (; status == MPM_OK && *entries != NULL; entries++)
        status = add_build(builds, *entries, error);
    if (status == MPM_OK)
        return write_json(folder, headroom_name, object, error);
    json_decref(object);
    return status;
}

/* ----------------------------------------------------------------------- files */

/* mutants_check() knows the mutants. */
static const struct record_field mutants_fields[] = {
    {"format", RECORD_COUNT, true, NULL},
    {"revision", RECORD_TEXT, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field facts_fields[] = {
    {"version", RECORD_TEXT, false, NULL},  {"revision", RECORD_TEXT, false, NULL},
    {"compiler", RECORD_TEXT, false, NULL}, {"simd", RECORD_TEXT, false, NULL},
    {"kernels", RECORD_TEXT, false, NULL},  {"tier", RECORD_TEXT, false, NULL},
    {"started", RECORD_TEXT, false, NULL},  {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field line_fields[] = {
    {"section", RECORD_TEXT, true, NULL}, {"change", RECORD_TEXT, true, NULL},
    {"case", RECORD_NAME, true, NULL},    {"name", RECORD_TEXT, true, NULL},
    {"text", RECORD_TEXT, true, NULL},    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field changes_fields[] = {
    {"format", RECORD_COUNT, true, NULL},         {"before", RECORD_OBJECT, true, facts_fields},
    {"after", RECORD_OBJECT, true, facts_fields}, {"change", RECORD_NUMBER, true, NULL},
    {"worse", RECORD_COUNT, true, NULL},          {"better", RECORD_COUNT, true, NULL},
    {"other", RECORD_COUNT, true, NULL},          {"unselected", RECORD_COUNT, true, NULL},
    {"lines", RECORD_LIST, true, line_fields},    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field build_fields[] = {
    {"name", RECORD_TEXT, true, NULL},      {"revision", RECORD_TEXT, false, NULL},
    {"compiler", RECORD_TEXT, false, NULL}, {"flags", RECORD_TEXT, false, NULL},
    {"simd", RECORD_TEXT, false, NULL},     {"kernels", RECORD_TEXT, false, NULL},
    {"values", RECORD_NUMBERS, true, NULL}, {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field headroom_fields[] = {
    {"format", RECORD_COUNT, true, NULL},
    {"builds", RECORD_LIST, true, build_fields},
    {NULL, RECORD_TEXT, false, NULL},
};

static enum mpm_status read_object(const char *path, const struct record_field *fields,
                                   json_t **object, struct mpm_error *error)
{
    TRY(input_json(path, JSON_REJECT_DUPLICATES, object, error));
    GString *fault = g_string_new(NULL);
    if (!record_fits(*object, fields, fault) ||
        json_integer_value(json_object_get(*object, "format")) != 1) {
        failure_set(error, MPM_BAD_INPUT, "%s: %s", path,
                    fault->len > 0 ? fault->str : "format: allowed is 1");
        json_decref(*object);
        *object = NULL;
    }
    g_string_free(fault, TRUE);
    return *object == NULL ? MPM_BAD_INPUT : MPM_OK;
}

static enum mpm_status keep_mutants(const char *folder, const char *path, struct mpm_error *error)
{
    json_t *object;
    TRY(read_object(path, mutants_fields, &object, error));
    const enum mpm_status status = mutants_check(object, path, error);
    if (status == MPM_OK)
        return write_json(folder, mutants_name, object, error);
    json_decref(object);
    return status;
}

enum mpm_status report_store(const char *folder, const struct report_additions *additions,
                             struct mpm_error *error)
{
    bool there;
    if (additions->api != NULL)
        TRY(api_pages_check(additions->api, error));
    TRY(api_pages_find(folder, additions->api != NULL, &there, error)); /* before any is written */
    if (additions->baseline != NULL)
        TRY(keep_changes(folder, additions->baseline, error));
    if (additions->headroom != NULL)
        TRY(keep_headroom(folder, additions->headroom, error));
    if (additions->mutants != NULL)
        TRY(keep_mutants(folder, additions->mutants, error));
    if (additions->history != NULL) {
        json_t *history;
        TRY(history_gather(folder, additions->history, &history, error));
        TRY(write_json(folder, history_name, history, error));
    }
    return additions->api != NULL ? api_pages_copy(additions->api, folder, error) : MPM_OK;
}

static enum mpm_status read_stored(const char *folder, const char *name,
                                   const struct record_field *fields, json_t **object,
                                   struct mpm_error *error)
{
    char *path = g_build_filename(folder, name, NULL);
    enum mpm_path kind = MPM_PATH_NONE;
    *object = NULL;
    enum mpm_status status = result_file_check(path, error);
    if (status == MPM_OK)
        status = input_kind(path, &kind, error);
    if (status == MPM_OK && kind != MPM_PATH_NONE)
        status = read_object(path, fields, object, error);
    if (status == MPM_OK && *object != NULL && name == mutants_name)
        status = mutants_check(*object, path, error);
    g_free(path);
    return status;
}

enum mpm_status report_stored_read(const char *folder, struct report_stored *stored,
                                   struct mpm_error *error)
{
    *stored = (struct report_stored){.changes = NULL};
    const struct {
        const char *name;
        const struct record_field *fields;
        json_t **object;
    } files[] = {{changes_name, changes_fields, &stored->changes},
                 {headroom_name, headroom_fields, &stored->headroom},
                 {mutants_name, mutants_fields, &stored->mutants},
                 {history_name, history_fields, &stored->history}};
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; status == MPM_OK && i < G_N_ELEMENTS(files); i++)
        status = read_stored(folder, files[i].name, files[i].fields, files[i].object, error);
    if (status != MPM_OK)
        report_stored_clear(stored);
    return status;
}

void report_stored_clear(struct report_stored *stored)
{
    json_decref(stored->changes);
    json_decref(stored->headroom);
    json_decref(stored->mutants);
    json_decref(stored->history);
    *stored = (struct report_stored){.changes = NULL};
}
