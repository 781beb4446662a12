/* Records: bench.jsonl built, written, read and looked up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/records.h"

#include "mpm_file.h"
#include "verification/common/failure.h"
#include "verification/common/machine.h"
#include "verification/common/output.h"
#include "verification/common/record.h"
#include "verification/common/result_lines.h"

#include <glib.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

enum { FORMAT = 1 };

static json_t *number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

/* ----------------------------------------------------------------- building */

static double memory_bytes(void)
{
    return (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
}

/* Processes that ran or waited over the last minute; NaN where the system does not report it. */
static double load(void)
{
    char *text = mpm_file_load("/proc/loadavg", NULL);
    double processes = (double)NAN;
    if (text != NULL)
        processes = g_ascii_strtod(text, NULL);
    g_free(text);
    return processes;
}

struct bench_records bench_records_make(const char *tier, const char *command, size_t rounds)
{
    const struct mpm_build_info *info = mpm_build_info();
    char *libraries = machine_libraries(), *processor = machine_processor();
    json_t *run = json_object();
    json_object_set_new(run, "kind", json_string("run"));
    json_object_set_new(run, "format", json_integer(FORMAT));
    json_object_set_new(run, "tier", json_string(tier));
    json_object_set_new(run, "command", json_string(command));
    json_object_set_new(run, "version", json_string(info->version));
    json_object_set_new(run, "revision", json_string(info->revision));
    json_object_set_new(run, "compiler", json_string(info->compiler));
    json_object_set_new(run, "flags", json_string(info->flags));
    json_object_set_new(run, "libraries", json_string(libraries));
    json_object_set_new(run, "processor", json_string(processor));
    json_object_set_new(run, "cores", json_integer((json_int_t)machine_processor_count()));
    json_object_set_new(run, "memory_bytes", json_integer((json_int_t)memory_bytes()));
    json_object_set_new(run, "load", number(load()));
    json_object_set_new(run, "simd", json_string(info->simd));
    json_object_set_new(run, "rounds", json_integer((json_int_t)rounds));
    g_free(libraries);
    g_free(processor);
    return (struct bench_records){run, json_array()};
}

void bench_records_clear(struct bench_records *records)
{
    json_decref(records->run);
    json_decref(records->lines);
    *records = (struct bench_records){NULL, NULL};
}

static json_t *add(struct bench_records *records, const char *kind,
                   const struct bench_subject *subject)
{
    json_t *line = json_object();
    json_object_set_new(line, "kind", json_string(kind));
    json_object_set_new(line, "group", json_string(subject->group));
    json_object_set_new(line, "point", json_string(subject->point));
    json_array_append_new(records->lines, line);
    return line;
}

static void add_quantity(json_t *line, const struct bench_subject *subject, const char *quantity,
                         const char *unit)
{
    json_t *none = json_object();
    json_object_set(line, "settings", subject->settings == NULL ? none : subject->settings);
    json_decref(none);
    json_object_set_new(line, "quantity", json_string(quantity));
    json_object_set_new(line, "unit", json_string(unit));
}

const json_t *bench_records_result(struct bench_records *records,
                                   const struct bench_subject *subject, const char *quantity,
                                   const char *unit, const double *rounds, size_t count)
{
    const struct bench_interval interval = bench_interval_of(rounds, count);
    json_t *line = add(records, "result", subject), *values = json_array();
    add_quantity(line, subject, quantity, unit);
    json_object_set_new(line, "median", number(interval.median));
    json_object_set_new(line, "low", number(interval.low));
    json_object_set_new(line, "high", number(interval.high));
    for (size_t i = 0; i < count; i++)
        json_array_append_new(values, number(rounds[i]));
    json_object_set_new(line, "rounds", values);
    return line;
}

const json_t *bench_records_value(struct bench_records *records,
                                  const struct bench_subject *subject, const char *quantity,
                                  const char *unit, double value)
{
    json_t *line = add(records, "value", subject);
    add_quantity(line, subject, quantity, unit);
    json_object_set_new(line, "value", number(value));
    return line;
}

const json_t *bench_records_comparison(struct bench_records *records,
                                       const struct bench_subject *subject, const char *against,
                                       const char *quantity, struct bench_interval ratio,
                                       enum bench_verdict verdict)
{
    json_t *line = add(records, "comparison", subject);
    json_object_set_new(line, "against", json_string(against));
    json_object_set_new(line, "quantity", json_string(quantity));
    json_object_set_new(line, "ratio", number(ratio.median));
    json_object_set_new(line, "low", number(ratio.low));
    json_object_set_new(line, "high", number(ratio.high));
    json_object_set_new(line, "verdict", json_string(bench_verdict_name(verdict)));
    return line;
}

/* --------------------------------------------------------- writing, reading */

static void append_line(GString *text, const json_t *object)
{
    char *line = json_dumps(object, JSON_COMPACT | JSON_PRESERVE_ORDER);
    g_string_append(text, line);
    g_string_append_c(text, '\n');
    free(line);
}

enum mpm_status bench_records_write(const char *folder, const struct bench_records *records,
                                    struct mpm_error *error)
{
    GString *text = g_string_new(NULL);
    append_line(text, records->run);
    for (size_t i = 0; i < json_array_size(records->lines); i++)
        append_line(text, json_array_get(records->lines, i));
    const enum mpm_status status = output_write(folder, BENCH_RECORDS_FILE, text->str, error);
    g_string_free(text, TRUE);
    return status;
}

static const struct record_field run_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},       {"format", RECORD_COUNT, true, NULL},
    {"tier", RECORD_TEXT, false, NULL},      {"command", RECORD_TEXT, false, NULL},
    {"version", RECORD_TEXT, false, NULL},   {"revision", RECORD_TEXT, false, NULL},
    {"compiler", RECORD_TEXT, false, NULL},  {"flags", RECORD_TEXT, false, NULL},
    {"libraries", RECORD_TEXT, false, NULL}, {"processor", RECORD_TEXT, false, NULL},
    {"cores", RECORD_COUNT, false, NULL},    {"memory_bytes", RECORD_NUMBER, false, NULL},
    {"load", RECORD_NUMBER, false, NULL},    {"simd", RECORD_TEXT, false, NULL},
    {"rounds", RECORD_COUNT, false, NULL},   {NULL, RECORD_TEXT, false, NULL},
};

/* Numbers may be null: what was not finite. */
static const struct record_field line_fields[] = {
    {"kind", RECORD_TEXT, true, NULL},       {"group", RECORD_TEXT, true, NULL},
    {"point", RECORD_TEXT, true, NULL},      {"quantity", RECORD_TEXT, true, NULL},
    {"unit", RECORD_TEXT, false, NULL},      {"against", RECORD_TEXT, false, NULL},
    {"verdict", RECORD_TEXT, false, NULL},   {"settings", RECORD_OBJECT, false, NULL},
    {"rounds", RECORD_NUMBERS, false, NULL}, {"median", RECORD_NUMBER, false, NULL},
    {"low", RECORD_NUMBER, false, NULL},     {"high", RECORD_NUMBER, false, NULL},
    {"value", RECORD_NUMBER, false, NULL},   {"ratio", RECORD_NUMBER, false, NULL},
    {NULL, RECORD_TEXT, false, NULL},
};

static bool is_kind(const json_t *object, const char *kind)
{
    return strcmp(record_text(object, "kind"), kind) == 0;
}

static bool is_run(const json_t *object, GString *fault)
{
    if (!is_kind(object, "run"))
        g_string_assign(fault, "kind: allowed is run");
    else if (json_integer_value(json_object_get(object, "format")) != FORMAT)
        g_string_printf(fault, "format: allowed is %d", FORMAT);
    return fault->len == 0;
}

static bool has_keys(const json_t *object, const char *const *keys, GString *fault)
{
    for (; *keys != NULL; keys++)
        if (json_object_get(object, *keys) == NULL || *record_text(object, *keys) == '\0') {
            g_string_printf(fault, "%s: a text is missing", *keys);
            return false;
        }
    return true;
}

static bool is_line(const json_t *object, GString *fault)
{
    static const char *const texts[] = {"group", "point", "quantity", NULL};
    static const char *const of_comparison[] = {"against", "verdict", NULL};
    if (!has_keys(object, texts, fault))
        return false;
    if (is_kind(object, "comparison"))
        return has_keys(object, of_comparison, fault);
    const bool settings = json_is_object(json_object_get(object, "settings"));
    const bool result =
        is_kind(object, "result") && json_is_array(json_object_get(object, "rounds"));
    if (!settings || !(result || is_kind(object, "value")))
        g_string_assign(fault, "allowed are a comparison, and a result with rounds or a value, "
                               "both with settings");
    return fault->len == 0;
}

enum mpm_status bench_records_read(const char *folder, struct bench_records *records,
                                   struct mpm_error *error)
{
    static const struct result_format format = {BENCH_RECORDS_FILE,
                                                "mpm-bench run",
                                                "line of a benchmark",
                                                run_fields,
                                                line_fields,
                                                is_run,
                                                is_line};
    return result_lines_read(folder, &format, &records->run, &records->lines, error);
}

/* ------------------------------------------------------------------- access */

static bool has_text(const json_t *line, const char *key, const char *text)
{
    return text == NULL || strcmp(record_text(line, key), text) == 0;
}

const json_t *bench_records_find(const struct bench_records *records, const char *kind,
                                 const char *group, const char *point, const char *quantity)
{
    for (size_t i = 0; i < json_array_size(records->lines); i++) {
        const json_t *line = json_array_get(records->lines, i);
        if (has_text(line, "kind", kind) && has_text(line, "group", group) &&
            has_text(line, "point", point) && has_text(line, "quantity", quantity))
            return line;
    }
    return NULL;
}

double *bench_record_rounds(const json_t *line, size_t *count)
{
    const json_t *rounds = json_object_get(line, "rounds");
    *count = json_array_size(rounds);
    double *values = g_new(double, *count);
    for (size_t i = 0; i < *count; i++)
        values[i] = json_is_number(json_array_get(rounds, i))
                        ? json_number_value(json_array_get(rounds, i))
                        : (double)NAN;
    return values;
}
