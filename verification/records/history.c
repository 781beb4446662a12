/* Values of earlier runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/history.h"

#include "mpm_file.h"
#include "verification/common/result_lines.h"

#include <math.h>
#include <string.h>

static const char checks_file[] = "checks.jsonl", bench_file[] = "bench.jsonl";

/* ----------------------------------------------------------------------- fields */

static const struct record_field run_fields[] = {
    {"revision", RECORD_TEXT, true, NULL},      {"version", RECORD_TEXT, false, NULL},
    {"compiler", RECORD_TEXT, false, NULL},     {"processor", RECORD_TEXT, false, NULL},
    {"tier", RECORD_TEXT, false, NULL},         {"started", RECORD_TEXT, false, NULL},
    {"values", RECORD_NUMBERS, true, NULL},     {"failed", RECORD_COUNT, false, NULL},
    {"benchmarks", RECORD_NUMBERS, true, NULL}, {NULL, RECORD_TEXT, false, NULL},
};
const struct record_field history_fields[] = {
    {"format", RECORD_COUNT, true, NULL},
    {"runs", RECORD_LIST, true, run_fields},
    {"benchmarks", RECORD_NUMBERS, true, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};
/* Of bench.jsonl, what is taken from it. */
static const struct record_field bench_run_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},       {"revision", RECORD_TEXT, true, NULL},
    {"version", RECORD_TEXT, false, NULL},   {"compiler", RECORD_TEXT, false, NULL},
    {"processor", RECORD_TEXT, false, NULL}, {NULL, RECORD_TEXT, false, NULL},
};
static const struct record_field bench_line_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},     {"group", RECORD_TEXT, true, NULL},
    {"point", RECORD_TEXT, true, NULL},    {"quantity", RECORD_TEXT, false, NULL},
    {"unit", RECORD_TEXT, false, NULL},    {"median", RECORD_NUMBER, false, NULL},
    {"value", RECORD_NUMBER, false, NULL}, {NULL, RECORD_TEXT, false, NULL},
};

static bool is_bench_run(const json_t *object, GString *fault)
{
    if (strcmp(record_text(object, "kind"), "run") != 0)
        g_string_assign(fault, "kind: allowed is run");
    return fault->len == 0;
}

static bool is_bench_line(const json_t *object, GString *fault)
{
    static const char *const kinds[] = {"result", "value", "comparison"};
    for (size_t i = 0; i < G_N_ELEMENTS(kinds); i++)
        if (strcmp(record_text(object, "kind"), kinds[i]) == 0)
            return true;
    g_string_assign(fault, "kind: allowed is result, value or comparison");
    return false;
}

static const struct result_format bench_format = {
    bench_file,   "mpm-bench run", "record of a benchmark", bench_run_fields, bench_line_fields,
    is_bench_run, is_bench_line};

/* ---------------------------------------------------------------------- reading */

/* One of which the system does not say whether it is there, is: opening it gives the reason. */
static bool has_file(const char *folder, const char *name)
{
    char *path = g_build_filename(folder, name, NULL);
    const bool there = mpm_path_kind(path) != MPM_PATH_NONE;
    g_free(path);
    return there;
}

/* The folder itself or that folder in it, whichever has the file; NULL if neither has. g_free. */
static char *folder_of(const char *folder, const char *inner, const char *file)
{
    char *below = g_build_filename(folder, inner, NULL);
    char *found = has_file(folder, file)  ? g_strdup(folder)
                  : has_file(below, file) ? g_strdup(below)
                                          : NULL;
    g_free(below);
    return found;
}

static void take_facts(json_t *entry, const json_t *run)
{
    static const char *const keys[] = {"revision",  "version", "compiler",
                                       "processor", "tier",    "started"};
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        if (json_object_get(entry, keys[i]) == NULL && json_object_get(run, keys[i]) != NULL)
            json_object_set(entry, keys[i], json_object_get(run, keys[i]));
}

static enum mpm_status take_checks(const char *folder, json_t *entry, struct mpm_error *error)
{
    struct records records;
    TRY(records_read(folder, &records, error));
    json_t *values = json_object_get(entry, "values");
    take_facts(entry, records.run);
    for (size_t i = 0; i < json_array_size(records.checks); i++) {
        const json_t *check = json_array_get(records.checks, i);
        char *key = record_key(check, "check");
        if (json_is_number(json_object_get(check, "value")))
            json_object_set(values, key, json_object_get(check, "value"));
        g_free(key);
    }
    const struct record_counts counts = records_count(&records, NULL, NULL);
    json_object_set_new(entry, "failed", json_integer((json_int_t)counts.failed));
    records_clear(&records);
    return MPM_OK;
}

/* One number for each point and quantity: the median of a result, or the value. */
static void take_bench_lines(const json_t *lines, json_t *numbers)
{
    for (size_t i = 0; i < json_array_size(lines); i++) {
        const json_t *line = json_array_get(lines, i);
        json_t *number = json_object_get(
            line, strcmp(record_text(line, "kind"), "result") == 0 ? "median" : "value");
        char *key = g_strdup_printf("%s/%s: %s (%s)", record_text(line, "group"),
                                    record_text(line, "point"), record_text(line, "quantity"),
                                    record_text(line, "unit"));
        if (json_is_number(number))
            json_object_set(numbers, key, number);
        g_free(key);
    }
}

static enum mpm_status take_benchmarks(const char *folder, json_t *entry, json_t *numbers,
                                       struct mpm_error *error)
{
    json_t *run, *lines;
    TRY(result_lines_read(folder, &bench_format, &run, &lines, error));
    if (entry != NULL)
        take_facts(entry, run);
    take_bench_lines(lines, numbers);
    json_decref(run);
    json_decref(lines);
    return MPM_OK;
}

static enum mpm_status take_folder(const char *folder, json_t *entry, struct mpm_error *error)
{
    char *checks = folder_of(folder, "verify", checks_file);
    char *bench = folder_of(folder, "bench", bench_file);
    enum mpm_status status = MPM_OK;
    if (checks == NULL && bench == NULL)
        status = failure_set(error, MPM_BAD_INPUT,
                             "--history %s: has neither checks.jsonl nor bench.jsonl, itself or in "
                             "verify and bench",
                             folder);
    if (status == MPM_OK && checks != NULL)
        status = take_checks(checks, entry, error);
    if (status == MPM_OK && bench != NULL)
        status = take_benchmarks(bench, entry, json_object_get(entry, "benchmarks"), error);
    g_free(bench);
    g_free(checks);
    return status;
}

/* `failed` is of a run of checks alone. */
static json_t *empty_run(void)
{
    json_t *entry = json_object();
    json_object_set_new(entry, "values", json_object());
    json_object_set_new(entry, "benchmarks", json_object());
    return entry;
}

enum mpm_status history_gather(const char *own, const char *const *folders, json_t **history,
                               struct mpm_error *error)
{
    json_t *runs = json_array(), *benchmarks = json_object();
    char *beside = g_build_filename(own, "..", "bench", NULL);
    enum mpm_status status = MPM_OK;
    *history = json_object();
    json_object_set_new(*history, "format", json_integer(1));
    json_object_set_new(*history, "runs", runs);
    json_object_set_new(*history, "benchmarks", benchmarks);
    for (; status == MPM_OK && *folders != NULL; folders++) {
        json_t *entry = empty_run();
        json_array_append_new(runs, entry);
        status = take_folder(*folders, entry, error);
    }
    if (status == MPM_OK && has_file(beside, bench_file))
        status = take_benchmarks(beside, NULL, benchmarks, error);
    g_free(beside);
    if (status != MPM_OK) {
        json_decref(*history);
        *history = NULL;
    }
    return status;
}

/* ----------------------------------------------------------------------- series */

size_t history_length(const json_t *history)
{
    return json_array_size(json_object_get(history, "runs")) + 1;
}

void history_series(const json_t *history, const char *what, const char *key, double own,
                    double *numbers)
{
    const json_t *runs = json_object_get(history, "runs");
    const size_t count = json_array_size(runs);
    for (size_t i = 0; i < count; i++)
        numbers[i] = record_number(json_object_get(json_array_get(runs, i), what), key);
    numbers[count] = own;
}
