/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/kept_result.h"

#include "mpm_file.h"
#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/rows.h"
#include "verification/suite/schedule.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

enum { KEPT_FORMAT = 1 };

static const char *const outcome_names[] = {
    [JOB_RETURNED] = "returned",
    [JOB_CRASHED] = "crashed",
    [JOB_TIMED_OUT] = "timed out",
};

bool kept_is_result(const struct job_result *result)
{
    static const int from_outside[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGXCPU};
    if (result->outcome == JOB_NOT_RUN)
        return false;
    if (result->outcome == JOB_RETURNED)
        return result->code != MPM_ENVIRONMENT_FAILED;
    for (size_t i = 0; i < G_N_ELEMENTS(from_outside); i++)
        if (result->outcome == JOB_CRASHED && result->code == from_outside[i])
            return false;
    return true;
}

char *kept_path(const char *results, const char *key)
{
    char *name = g_strconcat(key, ".json", NULL);
    char *path = g_build_filename(results, name, NULL);
    g_free(name);
    return path;
}

/* --------------------------------------------------------------------- write */

/* A text as it is, other bytes in base 64. */
static json_t *content_of(const char *name, const char *bytes, size_t length)
{
    json_t *file = json_object();
    json_object_set_new(file, "name", json_string(name));
    if (g_utf8_validate_len(bytes, length, NULL)) {
        json_object_set_new(file, "text", json_stringn(bytes, length));
    } else {
        char *code = g_base64_encode((const unsigned char *)bytes, length);
        json_object_set_new(file, "base64", json_string(code));
        g_free(code);
    }
    return file;
}

/* A program may have ended before it wrote the file. */
static enum mpm_status add_file(json_t *files, const char *folder, const char *name,
                                struct mpm_error *error)
{
    char *path = g_build_filename(folder, name, NULL), *bytes = NULL;
    size_t length = 0;
    enum mpm_path kind;
    enum mpm_status status = input_kind(path, &kind, error);
    if (status == MPM_OK && kind != MPM_PATH_NONE)
        status = input_text(path, NULL, &bytes, &length, error);
    if (bytes != NULL)
        json_array_append_new(files, content_of(name, bytes, length));
    g_free(bytes);
    g_free(path);
    return status;
}

static bool is_name(const char *name)
{
    return *name != '\0' && *name != '.' && strchr(name, '/') == NULL;
}

/* The log, and the data files that the rows name. */
static enum mpm_status add_files(json_t *files, const struct kept_place *place,
                                 const struct planned_job *job, const char *text,
                                 struct mpm_error *error)
{
    char *log = schedule_path(place->work, job, "log", ".txt");
    char *folder = g_path_get_dirname(log), *name = g_path_get_basename(log);
    unsigned bad_line;
    GArray *rows = rows_parse(text, &bad_line);
    enum mpm_status status = add_file(files, folder, name, error);
    for (unsigned i = 0; status == MPM_OK && rows != NULL && i < rows->len; i++) {
        const struct row *row = &g_array_index(rows, struct row, i);
        if (row->kind == ROW_SERIES && is_name(row->name))
            status = add_file(files, folder, row->name, error);
    }
    if (rows != NULL)
        g_array_unref(rows);
    g_free(name);
    g_free(folder);
    g_free(log);
    return status;
}

/* Takes `files`. */
static json_t *object_of(const char *key, const struct planned_job *job,
                         const struct job_result *result, json_t *files)
{
    json_t *object = json_object();
    json_object_set_new(object, "format", json_integer(KEPT_FORMAT));
    json_object_set_new(object, "key", json_string(key));
    json_object_set_new(object, "case", record_text_of(job->entry->file->name));
    json_object_set_new(object, "variant", record_text_of(job->variant->name));
    json_object_set_new(object, "outcome", json_string(outcome_names[result->outcome]));
    json_object_set_new(object, "code", json_integer(result->code));
    json_object_set_new(object, "seconds", json_real(result->seconds));
    json_object_set_new(object, "timeout", json_real(result->timeout));
    json_object_set_new(object, "rows", content_of("rows", result->rows, strlen(result->rows)));
    json_object_set_new(object, "files", files);
    return object;
}

enum mpm_status kept_write(const struct kept_place *place, const char *key,
                           const struct planned_job *job, const struct job_result *result,
                           struct mpm_error *error)
{
    json_t *files = json_array();
    enum mpm_status status = add_files(files, place, job, result->rows, error);
    json_t *object = object_of(key, job, result, files);
    char *line = json_dumps(object, JSON_COMPACT | JSON_PRESERVE_ORDER);
    char *sum = g_compute_checksum_for_string(G_CHECKSUM_SHA256, line, -1);
    char *text = g_strconcat(line, "\n", sum, "\n", NULL);
    char *name = g_strconcat(key, ".json", NULL);
    if (status == MPM_OK)
        status = output_write(place->results, name, text, error);
    g_free(name);
    g_free(text);
    g_free(sum);
    free(line);
    json_decref(object);
    return status;
}

/* ---------------------------------------------------------------------- read */

/* The bytes of a content, with a zero at their end; NULL if it has none. */
static char *bytes_of(const json_t *content, size_t *length)
{
    const json_t *text = json_object_get(content, "text");
    const char *code = json_string_value(json_object_get(content, "base64"));
    if (text != NULL) {
        *length = json_string_length(text);
        char *bytes = g_malloc(*length + 1);
        memcpy(bytes, json_string_value(text), *length + 1);
        return bytes;
    }
    if (code == NULL)
        return NULL;
    unsigned char *bytes = g_base64_decode(code, length);
    bytes = g_realloc(bytes, *length + 1);
    bytes[*length] = '\0';
    return (char *)bytes;
}

static enum mpm_status write_file(const char *folder, const char *name, const char *bytes,
                                  size_t length, struct mpm_error *error)
{
    char *path = g_build_filename(folder, name, NULL);
    const int failed = mpm_file_save(path, bytes, length);
    const enum mpm_status status = failed == 0 ? MPM_OK : mpm_file_failed(path, errno, error);
    g_free(path);
    return status;
}

static enum mpm_status put_files(const struct kept_place *place, const json_t *object,
                                 const struct planned_job *job, const char *rows,
                                 struct mpm_error *error)
{
    const json_t *files = json_object_get(object, "files");
    char *path = schedule_path(place->work, job, "rows", ".jsonl");
    char *folder = g_path_get_dirname(path), *name = g_path_get_basename(path);
    enum mpm_status status = write_file(folder, name, rows, strlen(rows), error);
    for (size_t i = 0; status == MPM_OK && i < json_array_size(files); i++) {
        const json_t *file = json_array_get(files, i);
        size_t length = 0;
        char *bytes = bytes_of(file, &length);
        if (bytes != NULL && is_name(record_text(file, "name")))
            status = write_file(folder, record_text(file, "name"), bytes, length, error);
        g_free(bytes);
    }
    g_free(name);
    g_free(folder);
    g_free(path);
    return status;
}

/* The object of a file whose second line is the sum of the first; NULL of any other. */
static json_t *read_object(const char *path)
{
    char *text = mpm_file_load(path, NULL);
    json_t *object = NULL;
    if (text == NULL)
        return NULL;
    char **lines = g_strsplit(text, "\n", 3);
    if (g_strv_length(lines) == 3 && *lines[2] == '\0') {
        char *sum = g_compute_checksum_for_string(G_CHECKSUM_SHA256, lines[0], -1);
        if (strcmp(sum, lines[1]) == 0)
            object = json_loads(lines[0], JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL, NULL);
        g_free(sum);
    }
    g_strfreev(lines);
    g_free(text);
    return object;
}

static bool take_result(const json_t *object, const char *key, const struct planned_job *job,
                        struct job_result *result)
{
    const json_t *code = json_object_get(object, "code");
    size_t length, outcome = 0;
    while (outcome < G_N_ELEMENTS(outcome_names) &&
           strcmp(outcome_names[outcome], record_text(object, "outcome")) != 0)
        outcome++;
    if (outcome == G_N_ELEMENTS(outcome_names) || !json_is_integer(code) ||
        json_integer_value(json_object_get(object, "format")) != KEPT_FORMAT ||
        strcmp(record_text(object, "key"), key) != 0 ||
        strcmp(record_text(object, "case"), job->entry->file->name) != 0 ||
        strcmp(record_text(object, "variant"), job->variant->name) != 0)
        return false;
    *result = (struct job_result){
        .outcome = (enum job_outcome)outcome,
        .code = (int)json_integer_value(code),
        .seconds = record_number(object, "seconds"),
        .timeout = record_number(object, "timeout"),
        .rows = bytes_of(json_object_get(object, "rows"), &length),
    };
    return result->rows != NULL;
}

enum mpm_status kept_read(const struct kept_place *place, const char *key,
                          const struct planned_job *job, struct job_result *result,
                          enum kept_state *state, struct mpm_error *error)
{
    char *path = kept_path(place->results, key);
    json_t *object = read_object(path);
    enum mpm_status status = MPM_OK;
    *state = mpm_path_exists(path) ? KEPT_DAMAGED : KEPT_NOT;
    if (object != NULL && take_result(object, key, job, result)) {
        *state = KEPT_SOUND;
        if (place->work != NULL)
            status = put_files(place, object, job, result->rows, error);
    }
    json_decref(object);
    g_free(path);
    return status;
}
