/* What mpm-bench shows while it runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/console.h"

#include "mpm_words.h"

#include "benchmarks/common/records.h"
#include "verification/common/record.h"
#include "verification/common/text.h"

#include <glib.h>
#include <string.h>

enum { POINT_WIDTH = 48, QUANTITY_WIDTH = 30 };

static void clear_progress(const struct bench_console *console)
{
    if (console->terminal)
        mpm_progress_clear(console->out);
}

void bench_console_load(struct bench_console *console, const struct bench_records *records)
{
    static const double busy = 0.3;
    const double load = record_number(records->run, "load");
    if (load > busy)
        fprintf(console->out,
                "Other programs use this machine (load %.1f on %.0f processors): intervals will be "
                "wide,\nand two or more threads slower than they are.\n",
                load, record_number(records->run, "cores"));
}

void bench_console_group(struct bench_console *console, const char *title, const char *description)
{
    clear_progress(console);
    fprintf(console->out, "\n%s: %s\n", title, description);
    fflush(console->out);
}

static char *interval_text(const json_t *line)
{
    char *middle = text_quantity(record_number(line, "median"), record_text(line, "unit"));
    char *range = text_range(record_number(line, "low"), record_number(line, "high"), "");
    char *text = g_strdup_printf("%s  (%s)", middle, range);
    g_free(middle);
    g_free(range);
    return text;
}

static char *comparison_text(const json_t *line)
{
    char *ratio = text_number(record_number(line, "ratio"));
    char *range = text_range(record_number(line, "low"), record_number(line, "high"), "");
    char *text = g_strdup_printf("%s x %s  (%s)  %s", ratio, record_text(line, "against"), range,
                                 record_text(line, "verdict"));
    g_free(ratio);
    g_free(range);
    return text;
}

static char *line_text(const json_t *line)
{
    const char *kind = record_text(line, "kind");
    if (strcmp(kind, "result") == 0)
        return interval_text(line);
    if (strcmp(kind, "comparison") == 0)
        return comparison_text(line);
    return text_quantity(record_number(line, "value"), record_text(line, "unit"));
}

void bench_console_line(struct bench_console *console, const json_t *line)
{
    char *text = line_text(line);
    clear_progress(console);
    fprintf(console->out, "  %-*s %-*s %s\n", POINT_WIDTH, record_text(line, "point"),
            QUANTITY_WIDTH, record_text(line, "quantity"), text);
    fflush(console->out);
    g_free(text);
}

void bench_console_progress(struct bench_console *console, size_t done, size_t total,
                            const char *what)
{
    if (!console->terminal)
        return;
    char *text = g_strdup_printf("  %zu of %zu: %s", done, total, what);
    mpm_progress_draw(console->out, -1, text);
    g_free(text);
}

void bench_console_end(struct bench_console *console, const char *folder)
{
    clear_progress(console);
    fprintf(console->out, "\nresults: %s/bench.jsonl\n", folder);
    fflush(console->out);
}
