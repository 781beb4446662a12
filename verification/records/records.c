/* Records: checks.jsonl written, read, and looked up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/records.h"

#include "verification/common/input.h"
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

/* ------------------------------------------------------------------- reading */

static const struct record_field figure_fields[] = {
    {"figure", RECORD_NAME, true, NULL},         {"script", RECORD_TEXT, true, NULL},
    {"title", RECORD_TEXT, false, NULL},         {"caption", RECORD_TEXT, false, NULL},
    {"reference", RECORD_TEXT, false, NULL},     {"needs", RECORD_TEXTS, false, NULL},
    {"script_sha256", RECORD_TEXT, false, NULL}, {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field column_fields[] = {
    {"quantity", RECORD_TEXT, true, NULL},     {"title", RECORD_TEXT, true, NULL},
    {"unit", RECORD_TEXT, true, NULL},         {"better", RECORD_TEXT, true, NULL},
    {"tolerance", RECORD_NUMBER, false, NULL}, {"floor", RECORD_NUMBER, false, NULL},
    {"limit", RECORD_NUMBER, false, NULL},     {"beyond", RECORD_TEXT, false, NULL},
    {"missing", RECORD_TEXT, false, NULL},     {"about", RECORD_TEXT, false, NULL},
    {"where", RECORD_TEXT, false, NULL},       {"case", RECORD_NAME, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field part_fields[] = {
    {"part", RECORD_TEXT, true, NULL},
    {"kind", RECORD_TEXT, true, NULL},
    {"title", RECORD_TEXT, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field comparison_fields[] = {
    {"title", RECORD_TEXT, true, NULL},      {"summary", RECORD_TEXT, false, NULL},
    {"variants", RECORD_TEXTS, false, NULL}, {"columns", RECORD_LIST, true, column_fields},
    {"pareto_x", RECORD_TEXT, false, NULL},  {"pareto_y", RECORD_TEXT, false, NULL},
    {"main", RECORD_TEXT, false, NULL},      {"cost", RECORD_TEXT, false, NULL},
    {"setup", RECORD_TEXT, false, NULL},     {"figure", RECORD_NAME, false, NULL},
    {"notes", RECORD_TEXTS, false, NULL},    {"parts", RECORD_LIST, false, part_fields},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field variant_fields[] = {
    {"variant", RECORD_NAME, true, NULL},          {"tier", RECORD_TEXT, false, NULL},
    {"group", RECORD_TEXT, false, NULL},           {"title", RECORD_TEXT, false, NULL},
    {"settings", RECORD_TEXTS, false, NULL},       {"outcome", RECORD_TEXT, false, NULL},
    {"seconds", RECORD_NUMBER, false, NULL},       {"log_tail", RECORD_TEXT, false, NULL},
    {"notes", RECORD_TEXTS, false, NULL},          {"values", RECORD_OBJECT, false, NULL},
    {"particle_steps", RECORD_COUNT, false, NULL}, {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field picture_fields[] = {
    {"variant", RECORD_NAME, true, NULL},
    {"caption", RECORD_TEXT, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field case_fields[] = {
    {"family", RECORD_NAME, true, NULL},
    {"case", RECORD_NAME, true, NULL},
    {"title", RECORD_TEXT, false, NULL},
    {"summary", RECORD_TEXT, false, NULL},
    {"calculation", RECORD_TEXT, false, NULL},
    {"tags", RECORD_TEXTS, false, NULL},
    {"program", RECORD_TEXT, false, NULL},
    {"readme", RECORD_TEXT, false, NULL},
    {"figures", RECORD_LIST, false, figure_fields},
    {"picture", RECORD_OBJECT, false, picture_fields},
    {"no_picture", RECORD_TEXT, false, NULL},
    {"comparison", RECORD_OBJECT, false, comparison_fields},
    {"variants", RECORD_LIST, false, variant_fields},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field run_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},         {"version", RECORD_TEXT, true, NULL},
    {"revision", RECORD_TEXT, true, NULL},     {"compiler", RECORD_TEXT, false, NULL},
    {"flags", RECORD_TEXT, false, NULL},       {"libraries", RECORD_TEXT, false, NULL},
    {"simd", RECORD_TEXT, false, NULL},        {"processor", RECORD_TEXT, false, NULL},
    {"processors", RECORD_COUNT, false, NULL}, {"gnuplot", RECORD_TEXT, false, NULL},
    {"tier", RECORD_TEXT, true, NULL},         {"only", RECORD_TEXT, false, NULL},
    {"case_glob", RECORD_TEXT, false, NULL},   {"variant_glob", RECORD_TEXT, false, NULL},
    {"kernels", RECORD_TEXT, false, NULL},     {"jobs", RECORD_COUNT, false, NULL},
    {"command", RECORD_TEXT, false, NULL},     {"started", RECORD_TEXT, false, NULL},
    {"seconds", RECORD_NUMBER, false, NULL},   {"cases", RECORD_LIST, true, case_fields},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field check_fields[] = {
    {"family", RECORD_NAME, true, NULL},
    {"case", RECORD_NAME, true, NULL},
    {"check", RECORD_NAME, true, NULL},
    {"variant", RECORD_NAME, true, NULL},
    {"quantity", RECORD_TEXT, true, NULL},
    {"status", RECORD_TEXT, true, NULL},
    {"unit", RECORD_TEXT, false, NULL},
    {"norm", RECORD_TEXT, false, NULL},
    {"value", RECORD_NUMBER, false, NULL},
    {"expected", RECORD_NUMBER, false, NULL},
    {"low", RECORD_NUMBER, false, NULL},
    {"high", RECORD_NUMBER, false, NULL},
    {"fails_low", RECORD_NUMBER, false, NULL},
    {"fails_high", RECORD_NUMBER, false, NULL},
    {"margin", RECORD_NUMBER, false, NULL},
    {"reason", RECORD_TEXT, false, NULL},
    {"seconds", RECORD_NUMBER, false, NULL},
    {"particle_steps", RECORD_COUNT, false, NULL},
    {"title", RECORD_TEXT, false, NULL},
    {"basis", RECORD_TEXT, false, NULL},
    {"why", RECORD_TEXT, false, NULL},
    {"evidence", RECORD_TEXT, false, NULL},
    {"headroom", RECORD_TEXT, false, NULL},
    {"mutations", RECORD_COUNT, false, NULL},
    {"mutations_red", RECORD_COUNT, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field measured_run_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field measurement_fields[] = {
    {"family", RECORD_NAME, true, NULL},   {"case", RECORD_NAME, true, NULL},
    {"variant", RECORD_NAME, true, NULL},  {"quantity", RECORD_TEXT, true, NULL},
    {"unit", RECORD_TEXT, true, NULL},     {"reason", RECORD_TEXT, true, NULL},
    {"value", RECORD_NUMBER, false, NULL}, {NULL, RECORD_TEXT, false, NULL},
};

/* A script is looked up in the folder of its case. */
static bool are_scripts(const json_t *figures)
{
    for (size_t i = 0; i < json_array_size(figures); i++)
        if (!name_is_script(record_text(json_array_get(figures, i), "script")))
            return false;
    return true;
}

/* Pages are written by the names of cases. */
static bool is_run(const json_t *object, GString *fault)
{
    const json_t *cases = json_object_get(object, "cases");
    GHashTable *names = g_hash_table_new(g_str_hash, g_str_equal);
    if (strcmp(record_text(object, "kind"), "run") != 0)
        g_string_assign(fault, "kind: allowed is run");
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        if (!g_hash_table_add(names, (char *)(uintptr_t)record_text(entry, "case")))
            g_string_printf(fault, "cases.%zu.case: allowed is each name once", i);
        if (!are_scripts(json_object_get(entry, "figures")))
            g_string_printf(fault, "cases.%zu.figures: script: allowed is NAME.gp", i);
    }
    g_hash_table_unref(names);
    return fault->len == 0;
}

static bool is_check(const json_t *object, GString *fault)
{
    if (record_status(object) == VERDICT_STATUS_COUNT)
        g_string_assign(fault, "status: allowed is one of a verdict");
    return fault->len == 0;
}

static bool is_measured_run(const json_t *object, GString *fault)
{
    if (strcmp(record_text(object, "kind"), "run") != 0)
        g_string_assign(fault, "kind: allowed is run");
    return fault->len == 0;
}

static bool is_measurement(const json_t *object, GString *fault)
{
    if (json_object_get(object, "value") == NULL)
        g_string_assign(fault, "value: allowed is a number or null");
    return fault->len == 0;
}

/* A folder may hold the checks alone. */
static enum mpm_status read_measurements(const char *folder, struct records *records,
                                         struct mpm_error *error)
{
    static const struct result_format format = {
        measurements_name,   "mpm-verify run",   "record of a measurement",
        measured_run_fields, measurement_fields, is_measured_run,
        is_measurement};
    char *path = g_build_filename(folder, measurements_name, NULL);
    enum mpm_path kind;
    enum mpm_status status = input_kind(path, &kind, error);
    json_t *run = NULL;
    g_free(path);
    if (status == MPM_OK && kind != MPM_PATH_NONE)
        status = result_lines_read(folder, &format, &run, &records->measurements, error);
    json_decref(run);
    return status;
}

enum mpm_status records_read(const char *folder, struct records *records, struct mpm_error *error)
{
    static const struct result_format format = {checks_name, "mpm-verify run", "record of a check",
                                                run_fields,  check_fields,     is_run,
                                                is_check};
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
