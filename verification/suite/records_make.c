/* The records of a run: building checks.jsonl.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/records_make.h"

#include "mpm_file.h"
#include "verification/cases/case_picture.h"
#include "verification/cases/methods.h"
#include "verification/common/machine.h"
#include "verification/common/record.h"
#include "verification/common/rows.h"
#include "verification/suite/schedule.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static json_t *texts_of(char *const *texts, unsigned count)
{
    json_t *array = json_array();
    for (unsigned i = 0; i < count; i++)
        json_array_append_new(array, record_text_of(texts[i]));
    return array;
}

static json_t *number_or_null(bool known, double value)
{
    return known && isfinite(value) ? json_real(value) : json_null();
}

/* -------------------------------------------------------------------- checks */

json_t *record_check(const struct planned_job *job, const struct case_check *check,
                     const struct check_verdict *judged, double seconds)
{
    const struct verdict_band *band = &check->band;
    const struct verdict *verdict = &judged->verdict;
    json_t *object = json_object();
    json_object_set_new(object, "kind", json_string("check"));
    json_object_set_new(object, "family", record_text_of(job->entry->file->family));
    json_object_set_new(object, "case", record_text_of(job->entry->file->name));
    json_object_set_new(object, "check", record_text_of(check->name));
    json_object_set_new(object, "variant", record_text_of(job->variant->name));
    json_object_set_new(object, "quantity", record_text_of(check->quantity));
    json_object_set_new(object, "unit", record_text_of(check->unit));
    json_object_set_new(object, "norm", record_text_of(check->norm));
    json_object_set_new(object, "value", number_or_null(judged->has_value, judged->value));
    json_object_set_new(object, "expected", json_real(band->expected));
    json_object_set_new(object, "low", json_real(band->low));
    json_object_set_new(object, "high", json_real(band->high));
    json_object_set_new(object, "fails_low", number_or_null(band->weakness, band->fails_low));
    json_object_set_new(object, "fails_high", number_or_null(band->weakness, band->fails_high));
    json_object_set_new(object, "margin", number_or_null(verdict->has_margin, verdict->margin));
    json_object_set_new(object, "status", json_string(verdict_status_name(verdict->status)));
    json_object_set_new(object, "reason", record_text_of(verdict->reason));
    json_object_set_new(object, "seconds", json_real(seconds));
    json_object_set_new(object, "particle_steps", json_integer((json_int_t)judged->particle_steps));
    json_object_set_new(object, "title", record_text_of(check->title));
    json_object_set_new(object, "basis", json_string(basis_name(check->basis)));
    json_object_set_new(object, "why", record_text_of(check->why));
    json_object_set_new(object, "evidence",
                        json_string(evidence_name(check_evidence(job->entry->file, check))));
    json_object_set_new(object, "headroom",
                        record_text_of(check->headroom == NULL ? "" : check->headroom));
    json_object_set_new(object, "mutations", json_integer((json_int_t)judged->mutations));
    json_object_set_new(object, "mutations_red", json_integer((json_int_t)judged->mutations_red));
    return object;
}

static void add_text(json_t *object, const char *key, const char *text)
{
    if (text != NULL)
        json_object_set_new(object, key, record_text_of(text));
}

/* -------------------------------------------------------------------- variants */

static const char *outcome_word(const struct job_result *result)
{
    static const char *const words[] = {
        [JOB_RETURNED] = "returned",
        [JOB_CRASHED] = "crashed",
        [JOB_TIMED_OUT] = "timed out",
        [JOB_NOT_RUN] = "not run",
    };
    return result->outcome == JOB_RETURNED && result->code != 0 ? "failed" : words[result->outcome];
}

enum { LOG_TAIL_LINES = 40, LOG_TAIL_BYTES = 8192 };

static char *log_tail(const char *output, const struct planned_job *job)
{
    char *path = schedule_path(output, job, "log", ".txt"), *text = NULL;
    size_t length = 0;
    if ((text = mpm_file_load(path, &length)) == NULL)
        text = g_strdup("");
    g_free(path);
    const char *tail = text + (length > LOG_TAIL_BYTES ? length - LOG_TAIL_BYTES : 0);
    unsigned lines = 0;
    for (const char *c = text + length; c > tail; c--)
        if (c[-1] == '\n' && c != text + length && ++lines == LOG_TAIL_LINES)
            tail = c;
    char *copy = g_strdup(tail);
    g_free(text);
    return copy;
}

static void add_rows(json_t *object, const char *text)
{
    json_t *notes = json_array(), *values = json_object();
    unsigned bad_line;
    guint64 work = 0;
    GArray *rows = rows_parse(text, &bad_line);
    for (unsigned i = 0; rows != NULL && i < rows->len; i++) {
        const struct row *row = &g_array_index(rows, struct row, i);
        if (row->kind == ROW_NOTE)
            json_array_append_new(notes, record_text_of(row->text));
        else if (row->kind == ROW_VALUE)
            json_object_set_new(values, row->name, record_text_of(row->text));
        else if (row->kind == ROW_WORK)
            work = g_ascii_strtoull(row->text, NULL, 10);
    }
    if (rows != NULL)
        g_array_unref(rows);
    json_object_set_new(object, "notes", notes);
    json_object_set_new(object, "values", values);
    json_object_set_new(object, "particle_steps", json_integer((json_int_t)work));
}

/* Title and group; a variant that has none but the name of a method has the method's. */
static void add_description(json_t *object, const struct planned_job *job)
{
    const struct case_variant *variant = job->variant;
    const struct method_table *table = job->entry->methods;
    const struct method *method = variant->method;
    for (unsigned i = 0; method == NULL && table != NULL && i < table->methods_count; i++)
        if (strcmp(table->methods[i].name, variant->name) == 0)
            method = &table->methods[i];
    add_text(object, "group", method == NULL ? NULL : method->group);
    add_text(object, "title",
             variant->title != NULL ? variant->title
             : method != NULL       ? method->title
                                    : NULL);
}

static json_t *variant_record(const struct planned_job *job, const struct job_result *result,
                              const char *output)
{
    const struct case_variant *variant = job->variant;
    json_t *object = json_object();
    char *tail = log_tail(output, job);
    json_object_set_new(object, "variant", record_text_of(variant->name));
    json_object_set_new(object, "tier", json_string(tier_name(variant->tier)));
    add_description(object, job);
    json_object_set_new(object, "settings", texts_of(variant->settings, variant->settings_count));
    json_object_set_new(object, "outcome", json_string(outcome_word(result)));
    json_object_set_new(object, "seconds", json_real(result->seconds));
    json_object_set_new(object, "log_tail", record_text_of(tail));
    add_rows(object, result->rows);
    g_free(tail);
    return object;
}

/* ---------------------------------------------------------------------- cases */

/* Of the script as it is now; "" if it cannot be read, which drawing the figure reports. */
static json_t *script_hash(const char *folder, const char *script)
{
    char *path = g_build_filename(folder, script, NULL);
    size_t length = 0;
    char *text = mpm_file_load(path, &length);
    char *hash = text == NULL
                     ? g_strdup("")
                     : g_compute_checksum_for_data(G_CHECKSUM_SHA256, (const guchar *)text, length);
    json_t *record = json_string(hash);
    g_free(hash);
    g_free(text);
    g_free(path);
    return record;
}

static json_t *figure_record(const char *folder, const struct case_figure *figure)
{
    json_t *object = json_object();
    json_object_set_new(object, "figure", record_text_of(figure->name));
    json_object_set_new(object, "script", record_text_of(figure->script));
    json_object_set_new(object, "script_sha256", script_hash(folder, figure->script));
    json_object_set_new(object, "title", record_text_of(figure->title));
    json_object_set_new(object, "caption", record_text_of(figure->caption));
    json_object_set_new(object, "reference", record_text_of(figure->reference));
    json_object_set_new(object, "needs", texts_of(figure->needs, figure->needs_count));
    return object;
}

static json_t *column_record(const struct case_column *column)
{
    json_t *object = json_object();
    json_object_set_new(object, "quantity", record_text_of(column->quantity));
    json_object_set_new(object, "title", record_text_of(column->title));
    json_object_set_new(object, "unit", record_text_of(column->unit));
    json_object_set_new(object, "better", json_string(better_name(column->better)));
    json_object_set_new(object, "tolerance", json_real(column->tolerance));
    json_object_set_new(object, "floor", json_real(column->floor));
    if (column->limit_text != NULL)
        json_object_set_new(object, "limit", json_real(column->limit));
    add_text(object, "beyond", column->beyond);
    add_text(object, "missing", column->missing);
    add_text(object, "about", column->about);
    add_text(object, "where", column->where);
    add_text(object, "case", column->case_name);
    return object;
}

static json_t *comparison_record(const struct case_comparison *comparison)
{
    json_t *object = json_object(), *columns = json_array();
    json_object_set_new(object, "title", record_text_of(comparison->title));
    json_object_set_new(object, "summary",
                        record_text_of(comparison->summary == NULL ? "" : comparison->summary));
    json_object_set_new(object, "variants",
                        texts_of(comparison->variants, comparison->variants_count));
    for (unsigned i = 0; i < comparison->columns_count; i++)
        json_array_append_new(columns, column_record(&comparison->columns[i]));
    json_object_set_new(object, "columns", columns);
    if (comparison->pareto != NULL) {
        json_object_set_new(object, "pareto_x", record_text_of(comparison->pareto->x));
        json_object_set_new(object, "pareto_y", record_text_of(comparison->pareto->y));
    }
    add_text(object, "main", comparison->main);
    add_text(object, "cost", comparison->cost);
    add_text(object, "setup", comparison->setup);
    add_text(object, "figure", comparison->figure);
    json_object_set_new(object, "notes", texts_of(comparison->notes, comparison->notes_count));
    return object;
}

/* What the parts of methods' names mean. */
static json_t *parts_record(const struct method_table *table)
{
    json_t *parts = json_array();
    for (unsigned i = 0; table != NULL && i < table->parts_count; i++) {
        json_t *part = json_object();
        json_object_set_new(part, "part", record_text_of(table->parts[i].name));
        json_object_set_new(part, "kind", record_text_of(table->parts[i].kind));
        json_object_set_new(part, "title", record_text_of(table->parts[i].title));
        json_array_append_new(parts, part);
    }
    return parts;
}

static json_t *case_record(const struct catalogue_case *entry)
{
    const struct case_file *file = entry->file;
    json_t *object = json_object(), *figures = json_array();
    json_object_set_new(object, "family", record_text_of(file->family));
    json_object_set_new(object, "case", record_text_of(file->name));
    json_object_set_new(object, "title", record_text_of(file->title));
    json_object_set_new(object, "summary", record_text_of(file->summary));
    if (file->calculation != NULL)
        json_object_set_new(object, "calculation", record_text_of(file->calculation));
    json_object_set_new(object, "tags", texts_of(file->tags, file->tags_count));
    json_object_set_new(object, "program", record_text_of(file->program_name));
    json_object_set_new(object, "readme", record_text_of(entry->readme));
    for (unsigned i = 0; i < file->figures_count; i++)
        json_array_append_new(figures, figure_record(entry->folder, &file->figures[i]));
    json_object_set_new(object, "figures", figures);
    if (file->comparison != NULL) {
        json_t *comparison = comparison_record(file->comparison);
        json_object_set_new(comparison, "parts", parts_record(entry->methods));
        json_object_set_new(object, "comparison", comparison);
    }
    json_object_set_new(object, "variants", json_array());
    return object;
}

static json_t *optional_text(const char *text)
{
    return text == NULL ? json_null() : record_text_of(text);
}

/* Which run the pictures of the case show; null where there are none, for the reason stated. */
static void set_picture(json_t *object, const struct case_file *file)
{
    const struct case_variant *const variant = case_picture_variant(file);
    const struct case_picture picture = case_picture_of(file);
    json_t *record = variant == NULL ? json_null() : json_object();
    if (variant != NULL) {
        json_object_set_new(record, "variant", record_text_of(variant->name));
        json_object_set_new(record, "caption", optional_text(picture.caption));
        json_object_set_new(record, "strip", json_boolean(picture.strip));
    }
    json_object_set_new(object, "picture", record);
    json_object_set_new(object, "no_picture", optional_text(file->no_picture));
}

/* Jobs of one case follow each other. */
static json_t *case_records(const struct plan *plan, const struct job_result *results,
                            const char *output)
{
    json_t *cases = json_array(), *last = NULL;
    for (size_t i = 0; i < plan->job_count; i++) {
        const struct planned_job *job = &plan->jobs[i];
        if (i == 0 || plan->jobs[i - 1].entry != job->entry) {
            last = case_record(job->entry);
            set_picture(last, job->entry->file);
            json_array_append_new(cases, last);
        }
        json_array_append_new(json_object_get(last, "variants"),
                              variant_record(job, &results[i], output));
    }
    return cases;
}

static json_t *incomplete_record(const struct plan *plan, const struct job_result *results,
                                 const char *reason)
{
    size_t done = 0;
    for (size_t i = 0; i < plan->job_count; i++)
        done += results[i].outcome != JOB_NOT_RUN;
    json_t *object = json_object();
    json_object_set_new(object, "reason", record_text_of(reason));
    json_object_set_new(object, "done", json_integer((json_int_t)done));
    json_object_set_new(object, "programs", json_integer((json_int_t)plan->job_count));
    return object;
}

static json_t *run_record(const struct record_context *context)
{
    const struct mpm_build_info *build = mpm_build_info();
    char *processor = machine_processor(), *gnuplot = machine_gnuplot(),
         *libraries = machine_libraries();
    json_t *run = json_object();
    json_object_set_new(run, "kind", json_string("run"));
    json_object_set_new(run, "format", json_integer(1));
    json_object_set_new(run, "version", record_text_of(build->version));
    json_object_set_new(run, "revision", record_text_of(build->revision));
    json_object_set_new(run, "compiler", record_text_of(build->compiler));
    json_object_set_new(run, "flags", record_text_of(build->flags));
    json_object_set_new(run, "libraries", record_text_of(libraries));
    json_object_set_new(run, "simd", record_text_of(build->simd));
    json_object_set_new(run, "processor", record_text_of(processor));
    json_object_set_new(run, "processors", json_integer((json_int_t)machine_processor_count()));
    json_object_set_new(run, "gnuplot", record_text_of(gnuplot));
    json_object_set_new(run, "tier", json_string(tier_name(context->selection->tier)));
    json_object_set_new(run, "only", optional_text(context->selection->only_file));
    json_object_set_new(run, "case_glob", optional_text(context->selection->case_globs));
    json_object_set_new(run, "variant_glob", optional_text(context->selection->variant_globs));
    json_object_set_new(run, "kernels", json_string(mpm_kernels_name(context->kernels)));
    json_object_set_new(run, "jobs", json_integer((json_int_t)context->jobs));
    json_object_set_new(run, "command", record_text_of(context->command));
    json_object_set_new(run, "started", record_text_of(context->started));
    json_object_set_new(run, "seconds", json_real(context->seconds));
    g_free(processor);
    g_free(gnuplot);
    g_free(libraries);
    return run;
}

struct records records_make(const struct plan *plan, const struct job_result *results,
                            const struct record_context *context)
{
    struct records records = {run_record(context), json_array(),
                              measurement_records(plan, results)};
    if (context->incomplete != NULL)
        json_object_set_new(records.run, "incomplete",
                            incomplete_record(plan, results, context->incomplete));
    json_object_set_new(records.run, "cases", case_records(plan, results, context->output));
    for (size_t i = 0; i < plan->check_count; i++) {
        const struct planned_check *planned = &plan->checks[i];
        const struct job_result *result = &results[planned->job];
        const struct check_verdict judged = judge_check_with_proof(planned->check, result);
        json_array_append_new(
            records.checks,
            record_check(&plan->jobs[planned->job], planned->check, &judged, result->seconds));
    }
    return records;
}
