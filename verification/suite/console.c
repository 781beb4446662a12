/* What a run prints.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/console.h"

#include "mpm_words.h"
#include "verification/common/text.h"
#include "verification/records/check_text.h"
#include "verification/suite/records_make.h"

#include <stdarg.h>
#include <string.h>

enum { STATUS_WIDTH = 15 };

static int text_width(const char *text)
{
    return (int)g_utf8_strlen(text, -1);
}

/* Text padded to a width in characters (printf counts bytes). */
static void print_padded(FILE *out, const char *text, int width)
{
    fprintf(out, "%s%*s", text, MAX(1, width + 2 - text_width(text)), "");
}

static json_t *record_of(const struct plan *plan, const struct planned_check *planned,
                         const struct check_verdict *judged, double seconds)
{
    return record_check(&plan->jobs[planned->job], planned->check, judged, seconds);
}

void console_begin(struct console *console, const struct plan *plan)
{
    console->plan = plan;
    console->value_width = text_width("value") + 8;
    for (size_t i = 0; i < plan->check_count; i++) {
        const struct check_verdict unknown = {.has_value = false};
        json_t *record = record_of(plan, &plan->checks[i], &unknown, 0);
        char *name = text_check_name(record), *band = text_band(record);
        char *value = text_quantity(1.234e-10, record_text(record, "unit"));
        console->name_width = MAX(console->name_width, text_width(name));
        console->band_width = MAX(console->band_width, text_width(band));
        console->value_width = MAX(console->value_width, text_width(value));
        g_free(name);
        g_free(band);
        g_free(value);
        json_decref(record);
    }
    console->cases = console_cases_make(plan);
    if (!console->verbose)
        return;
    print_padded(console->out, "status", STATUS_WIDTH);
    print_padded(console->out, "check", console->name_width);
    print_padded(console->out, "value", console->value_width);
    print_padded(console->out, "band", console->band_width);
    fprintf(console->out, "time\n");
    fflush(console->out);
}

void console_expect(const struct console *console, const json_t *measurements)
{
    console_cases_expect(console->cases, console->plan, measurements);
}

void console_start(const struct console *console)
{
    console_cases_start(console->cases);
}

void console_clear(struct console *console)
{
    console_cases_free(console->cases);
    console->cases = NULL;
}

static void clear_progress(const struct console *console)
{
    if (console->terminal)
        mpm_progress_clear(console->out);
}

void console_progress(const struct console *console, size_t done, size_t total)
{
    if (!console->terminal || done == total)
        return;
    /* NULL while Slurm works */
    char *cases = console->cases != NULL ? console_cases_text(console->cases) : NULL;
    char *text = g_strdup_printf("%zu of %zu programs%s%s", done, total, cases != NULL ? ", " : "",
                                 cases != NULL ? cases : "");
    mpm_progress_draw(console->out, (double)done / (double)MAX(1, total), text);
    g_free(text);
    g_free(cases);
}

static const char *colour(const struct console *console, enum verdict_status status)
{
    if (!console->terminal || !mpm_terminal_has_colours())
        return "";
    if (verdict_is_red(status))
        return "\033[1;31m";
    return status == VERDICT_PASS ? "\033[32m" : "\033[33m";
}

static void print_check(const struct console *console, const json_t *record)
{
    const enum verdict_status status = record_status(record);
    const char *start = colour(console, status);
    char *name = text_check_name(record), *band = text_band(record);
    char *value = text_value(record);
    char *seconds = text_seconds(record_number(record, "seconds"));
    fputs(start, console->out);
    print_padded(console->out, verdict_status_name(status), STATUS_WIDTH);
    fputs(*start == '\0' ? "" : "\033[0m", console->out);
    print_padded(console->out, name, console->name_width);
    print_padded(console->out, value, console->value_width);
    print_padded(console->out, band, console->band_width);
    fprintf(console->out, "%s\n", seconds);
    g_free(name);
    g_free(band);
    g_free(value);
    g_free(seconds);
}

void console_say(const struct console *console, const char *format, ...)
{
    va_list arguments;
    clear_progress(console);
    va_start(arguments, format);
    (void)vfprintf(console->out, format, arguments);
    va_end(arguments);
    fputc('\n', console->out);
    fflush(console->out);
}

/* "pass  R1  36 checks  3.4 s  12 of 80 cases, 2:10 to go" */
static void print_case(const struct console *console, const struct console_case *row)
{
    const enum verdict_status status = row->red > 0 ? VERDICT_FAIL : VERDICT_PASS;
    const char *start = colour(console, status);
    char *seconds = text_seconds(row->seconds), *checks = text_count(row->checks, "check");
    char *cases = console_cases_text(console->cases);
    fprintf(console->out, "%s%-6s%s %-8s %-11s %-12s %s", start, verdict_status_name(status),
            *start == '\0' ? "" : "\033[0m", row->name, checks, seconds, cases);
    if (row->red > 0)
        fprintf(console->out, "; %zu failed", row->red);
    if (row->skipped > 0)
        fprintf(console->out, "; %zu skipped", row->skipped);
    fputc('\n', console->out);
    g_free(cases);
    g_free(checks);
    g_free(seconds);
}

void console_finished(const struct console *console, size_t job, const struct job_result *result)
{
    const struct plan *plan = console->plan;
    struct console_case *const row = &console->cases->rows[console->cases->row_of[job]];
    clear_progress(console);
    for (size_t i = 0; i < plan->check_count; i++) {
        if (plan->checks[i].job != job)
            continue;
        const struct check_verdict judged = judge_check(plan->checks[i].check, result);
        json_t *record = record_of(plan, &plan->checks[i], &judged, result->seconds);
        const bool red = verdict_is_red(record_status(record));
        if (console->verbose || red)
            print_check(console, record);
        row->checks++;
        row->red += red;
        row->skipped += record_status(record) == VERDICT_SKIP;
        json_decref(record);
    }
    if (console_cases_finish(console->cases, job, result->seconds) != NULL && !console->verbose)
        print_case(console, row);
    fflush(console->out);
}

static void print_failures(const struct console *console, const struct records *records)
{
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (!verdict_is_red(record_status(check)))
            continue;
        char *name = text_check_name(check), *band = text_band(check);
        char *value = text_value(check);
        fprintf(console->out, "%s: %s: value %s, band %s: %s\n", record_text(check, "status"), name,
                value, band, record_text(check, "reason"));
        g_free(name);
        g_free(band);
        g_free(value);
    }
}

void console_unchecked(const struct console *console, const GPtrArray *quantities)
{
    if (quantities->len == 0)
        return;
    clear_progress(console);
    fprintf(console->out, "\nmeasured, and checked or compared by no case (%u):", quantities->len);
    for (unsigned i = 0; i < quantities->len; i++)
        fprintf(console->out, "%s %s", i == 0 ? "" : ",",
                (const char *)g_ptr_array_index(quantities, i));
    fputc('\n', console->out);
}

void console_end(struct console *console, const struct records *records, const char *output)
{
    const struct record_counts counts = records_count(records, NULL, NULL);
    const size_t known = counts.of[VERDICT_EXPECTED_FAIL];
    char *incomplete = records_incomplete(records);
    fputc('\n', console->out);
    print_failures(console, records);
    if (incomplete != NULL)
        fprintf(console->out, "%s\n", incomplete);
    g_free(incomplete);
    if (output != NULL)
        fprintf(console->out, "report: %s/index.html\n", output);
    if (known > 0)
        fprintf(console->out, "%zu known weakness%s as declared, counted as passed\n", known,
                known == 1 ? " shows" : "es show");
    fprintf(console->out, "%zu passed, %zu failed, %zu skipped\n", counts.passed, counts.failed,
            counts.skipped);
    fflush(console->out);
}
