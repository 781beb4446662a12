/* Records: checks.jsonl written, read, and looked up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/records.h"

#include "verification/common/names.h"
#include "verification/common/output.h"
#include "verification/common/result_lines.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void append_line(GString *text, const json_t *object)
{
    char *line = json_dumps(object, JSON_COMPACT | JSON_PRESERVE_ORDER);
    g_string_append(text, line);
    g_string_append_c(text, '\n');
    free(line);
}

static enum mpm_status write_lines(const char *folder, const char *name, const json_t *run,
                                   const json_t *lines, struct mpm_error *error)
{
    GString *text = g_string_new(NULL);
    append_line(text, run);
    for (size_t i = 0; i < json_array_size(lines); i++)
        append_line(text, json_array_get(lines, i));
    const enum mpm_status status = output_write(folder, name, text->str, error);
    g_string_free(text, TRUE);
    return status;
}

static const char checks_name[] = "checks.jsonl", measurements_name[] = "measurements.jsonl";

enum mpm_status records_write(const char *folder, const struct records *records,
                              struct mpm_error *error)
{
    static const char *const keys[] = {"kind", "format", "version", "revision", "tier", "started"};
    json_t *run = json_object();
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        json_object_set(run, keys[i], json_object_get(records->run, keys[i]));
    enum mpm_status status =
        write_lines(folder, measurements_name, run, records->measurements, error);
    json_decref(run);
    if (status == MPM_OK)
        status = write_lines(folder, checks_name, records->run, records->checks, error);
    return status;
}

static bool has_texts(const json_t *object, const char *const *keys, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!json_is_string(json_object_get(object, keys[i])))
            return false;
    return true;
}

/* Names become paths: one that could lead out of the folder is refused. */
static bool has_safe_names(const json_t *cases)
{
    bool safe = true;
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        const json_t *figures = json_object_get(entry, "figures");
        safe = safe && name_is_plain(record_text(entry, "case"));
        for (size_t f = 0; f < json_array_size(figures); f++) {
            const json_t *figure = json_array_get(figures, f);
            safe = safe && name_is_plain(record_text(figure, "figure")) &&
                   strchr(record_text(figure, "script"), '/') == NULL;
        }
    }
    return safe;
}

static bool is_run(const json_t *object)
{
    static const char *const keys[] = {"kind", "version", "revision", "tier"};
    return has_texts(object, keys, G_N_ELEMENTS(keys)) &&
           strcmp(record_text(object, "kind"), "run") == 0 &&
           json_is_array(json_object_get(object, "cases")) &&
           has_safe_names(json_object_get(object, "cases"));
}

static bool is_check(const json_t *object)
{
    static const char *const keys[] = {"family", "case", "check", "variant", "quantity", "status"};
    return has_texts(object, keys, G_N_ELEMENTS(keys)) &&
           record_status(object) != VERDICT_STATUS_COUNT;
}

static bool is_measured_run(const json_t *object)
{
    return strcmp(record_text(object, "kind"), "run") == 0;
}

static bool is_measurement(const json_t *object)
{
    static const char *const keys[] = {"family", "case", "variant", "quantity", "unit", "reason"};
    const json_t *value = json_object_get(object, "value");
    return has_texts(object, keys, G_N_ELEMENTS(keys)) &&
           (json_is_number(value) || json_is_null(value));
}

/* A folder may hold the checks alone. */
static enum mpm_status read_measurements(const char *folder, struct records *records,
                                         struct mpm_error *error)
{
    static const struct result_format format = {measurements_name, "mpm-verify run",
                                                "record of a measurement", is_measured_run,
                                                is_measurement};
    char *path = g_build_filename(folder, measurements_name, NULL);
    const bool there = g_file_test(path, G_FILE_TEST_EXISTS);
    json_t *run = NULL;
    g_free(path);
    const enum mpm_status status =
        there ? result_lines_read(folder, &format, &run, &records->measurements, error) : MPM_OK;
    json_decref(run);
    return status;
}

enum mpm_status records_read(const char *folder, struct records *records, struct mpm_error *error)
{
    static const struct result_format format = {checks_name, "mpm-verify run", "record of a check",
                                                is_run, is_check};
    *records = (struct records){.run = NULL};
    TRY(result_lines_read(folder, &format, &records->run, &records->checks, error));
    const enum mpm_status status = read_measurements(folder, records, error);
    if (status != MPM_OK)
        records_clear(records);
    return status;
}

void records_clear(struct records *records)
{
    json_decref(records->run);
    json_decref(records->checks);
    json_decref(records->measurements);
    *records = (struct records){.run = NULL};
}

/* ------------------------------------------------------------------- access */

enum verdict_status record_status(const json_t *check)
{
    return verdict_status_find(record_text(check, "status"));
}

char *record_key(const json_t *line, const char *what)
{
    return g_strjoin("/", record_text(line, "case"), record_text(line, what),
                     record_text(line, "variant"), NULL);
}

GHashTable *record_index(const json_t *lines, const char *what)
{
    GHashTable *table = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (size_t i = 0; i < json_array_size(lines); i++) {
        json_t *line = json_array_get(lines, i);
        g_hash_table_insert(table, record_key(line, what), line);
    }
    return table;
}

const json_t *record_find(GHashTable *table, const json_t *line, const char *what)
{
    char *key = record_key(line, what);
    const json_t *found = g_hash_table_lookup(table, key);
    g_free(key);
    return found;
}

const json_t *records_case(const struct records *records, const char *name)
{
    const json_t *cases = json_object_get(records->run, "cases");
    for (size_t i = 0; i < json_array_size(cases); i++)
        if (strcmp(record_text(json_array_get(cases, i), "case"), name) == 0)
            return json_array_get(cases, i);
    return NULL;
}

bool record_has_tag(const json_t *entry, const char *tag)
{
    const json_t *tags = json_object_get(entry, "tags");
    for (size_t i = 0; i < json_array_size(tags); i++)
        if (g_strcmp0(json_string_value(json_array_get(tags, i)), tag) == 0)
            return true;
    return false;
}

char *records_incomplete(const struct records *records)
{
    const json_t *incomplete = json_object_get(records->run, "incomplete");
    if (!json_is_object(incomplete))
        return NULL;
    return g_strdup_printf("Incomplete: %s. Checks of the others are errors.",
                           record_text(incomplete, "reason"));
}

bool record_same_declaration(const json_t *one, const json_t *other)
{
    static const char *const keys[] = {"check", "title", "expected",  "low",       "high",
                                       "basis", "why",   "fails_low", "fails_high"};
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        if (!json_equal(json_object_get(one, keys[i]), json_object_get(other, keys[i])))
            return false;
    return true;
}

static bool belongs(const json_t *check, const char *family, const char *name)
{
    return (family == NULL || strcmp(record_text(check, "family"), family) == 0) &&
           (name == NULL || strcmp(record_text(check, "case"), name) == 0);
}

struct record_counts records_count(const struct records *records, const char *family,
                                   const char *name)
{
    struct record_counts counts = {.total = 0};
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (!belongs(check, family, name))
            continue;
        const enum verdict_status status = record_status(check);
        counts.of[status]++;
        counts.total++;
        counts.mutations += (size_t)json_integer_value(json_object_get(check, "mutations"));
        counts.mutations_red += (size_t)json_integer_value(json_object_get(check, "mutations_red"));
        if (verdict_is_red(status))
            counts.failed++;
        else if (status == VERDICT_SKIP)
            counts.skipped++;
        else
            counts.passed++;
    }
    return counts;
}

const json_t *records_worst(const struct records *records, const char *name)
{
    const json_t *worst = NULL;
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        const double margin = record_number(check, "margin");
        if (belongs(check, NULL, name) && isfinite(margin) &&
            (worst == NULL || margin < record_number(worst, "margin")))
            worst = check;
    }
    return worst;
}
