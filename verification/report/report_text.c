/* The reports that machines and terminals read: Markdown, JUnit XML, TAP.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/text.h"
#include "verification/records/check_text.h"
#include "verification/report/report.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------- Markdown */

static void add_cell(GString *markdown, const char *text)
{
    g_string_append(markdown, "| ");
    text_markdown(markdown, text);
    g_string_append_c(markdown, ' ');
}

static void add_owned_cell(GString *markdown, char *text)
{
    add_cell(markdown, text);
    g_free(text);
}

static void markdown_failures(GString *markdown, const struct records *records)
{
    g_string_append(markdown, "\n## What does not hold\n\n| Check | Status | Value | Band | Reason "
                              "|\n|---|---|--:|---|---|\n");
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (!verdict_is_red(record_status(check)))
            continue;
        add_owned_cell(markdown, text_check_name(check));
        add_cell(markdown, record_text(check, "status"));
        add_owned_cell(markdown, text_value(check));
        add_owned_cell(markdown, text_band(check));
        add_cell(markdown, record_text(check, "reason"));
        g_string_append(markdown, "|\n");
    }
}

static void markdown_cases(GString *markdown, const struct records *records)
{
    const json_t *cases = json_object_get(records->run, "cases");
    g_string_append(markdown, "\n## Cases\n\n| Case | Problem | Passed | Failed | Skipped | Worst "
                              "margin |\n|---|---|--:|--:|--:|--:|\n");
    for (size_t i = 0; i < json_array_size(cases); i++) {
        const json_t *entry = json_array_get(cases, i);
        const char *name = record_text(entry, "case");
        const struct record_counts counts = records_count(records, NULL, name);
        const json_t *worst = records_worst(records, name);
        add_cell(markdown, name);
        add_cell(markdown, record_text(entry, "title"));
        g_string_append_printf(markdown, "| %zu | %zu | %zu ", counts.passed, counts.failed,
                               counts.skipped);
        add_owned_cell(markdown, worst == NULL ? g_strdup("none")
                                               : text_number(record_number(worst, "margin")));
        g_string_append(markdown, "|\n");
    }
}

char *report_markdown(const struct records *records)
{
    const struct record_counts counts = records_count(records, NULL, NULL);
    char *verdict = text_verdict(&counts), *incomplete = records_incomplete(records);
    GString *markdown = g_string_new("# Touchstone: ");
    text_markdown(markdown, verdict);
    g_string_append(markdown, "\n\n");
    if (incomplete != NULL) {
        text_markdown(markdown, incomplete);
        g_string_append(markdown, "\n\n");
    }
    g_free(incomplete);
    for (int status = 0; status < VERDICT_STATUS_COUNT; status++)
        if (counts.of[status] > 0)
            g_string_append_printf(markdown, "- %s: %zu\n",
                                   verdict_status_name((enum verdict_status)status),
                                   counts.of[status]);
    g_string_append_printf(markdown, "- spoiled results that turned their check red: %zu of %zu\n",
                           counts.mutations_red, counts.mutations);
    if (counts.failed > 0)
        markdown_failures(markdown, records);
    markdown_cases(markdown, records);
    g_string_append(markdown, "\nTouchstone ");
    text_markdown(markdown, record_text(records->run, "version"));
    g_string_append(markdown, ", revision ");
    text_markdown(markdown, record_text(records->run, "revision"));
    g_string_append(markdown, ", ");
    text_markdown(markdown, record_text(records->run, "compiler"));
    g_string_append(markdown, ", kernels ");
    text_markdown(markdown, record_text(records->run, "kernels"));
    g_string_append(markdown, ", size ");
    text_markdown(markdown, record_text(records->run, "tier"));
    g_string_append(markdown, ".\n");
    g_free(verdict);
    return g_string_free(markdown, FALSE);
}

/* ---------------------------------------------------------------------- JUnit */

/* What a reader of a failed check needs: value, band, reason. */
static char *details(const json_t *check)
{
    char *value = text_value(check);
    char *band = text_band(check);
    char *text =
        g_strdup_printf("value %s, band %s: %s", value, band, record_text(check, "reason"));
    g_free(value);
    g_free(band);
    return text;
}

static void junit_outcome(GString *xml, const json_t *check)
{
    const enum verdict_status status = record_status(check);
    const char *name = verdict_status_name(status);
    char *text = details(check);
    if (status == VERDICT_SKIP)
        text_markup(xml, "      <skipped message=\"%s\"/>\n", record_text(check, "reason"));
    else if (status == VERDICT_ERROR || status == VERDICT_TIMEOUT)
        text_markup(xml, "      <error type=\"%s\" message=\"%s\"/>\n", name, text);
    else if (verdict_is_red(status))
        text_markup(xml, "      <failure type=\"%s\" message=\"%s\"/>\n", name, text);
    else
        text_markup(xml, "      <system-out>%s: %s</system-out>\n", name, text);
    g_free(text);
}

static void junit_attributes(GString *xml, const struct record_counts *counts)
{
    const size_t errors = counts->of[VERDICT_ERROR] + counts->of[VERDICT_TIMEOUT];
    g_string_append_printf(xml, " tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\"",
                           counts->total, counts->failed - errors, errors, counts->skipped);
}

static void junit_case(GString *xml, const struct records *records, const json_t *entry)
{
    const char *name = record_text(entry, "case");
    const struct record_counts counts = records_count(records, NULL, name);
    text_markup(xml, "  <testsuite name=\"%s.%s\"", record_text(entry, "family"), name);
    junit_attributes(xml, &counts);
    g_string_append(xml, ">\n");
    for (size_t i = 0; i < json_array_size(records->checks); i++) {
        const json_t *check = json_array_get(records->checks, i);
        if (strcmp(record_text(check, "case"), name) != 0)
            continue;
        char seconds[G_ASCII_DTOSTR_BUF_SIZE];
        g_ascii_formatd(seconds, sizeof seconds, "%.3f", record_number(check, "seconds"));
        text_markup(xml, "    <testcase classname=\"%s.%s\" name=\"%s [%s]\" time=\"%s\">\n",
                    record_text(entry, "family"), name, record_text(check, "check"),
                    record_text(check, "variant"), seconds);
        junit_outcome(xml, check);
        g_string_append(xml, "    </testcase>\n");
    }
    g_string_append(xml, "  </testsuite>\n");
}

char *report_junit(const struct records *records)
{
    const struct record_counts counts = records_count(records, NULL, NULL);
    const json_t *cases = json_object_get(records->run, "cases");
    GString *xml = g_string_new("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    char *incomplete = records_incomplete(records);
    text_markup(xml, "<testsuites name=\"mpm-verify%s%s\"", incomplete == NULL ? "" : ". ",
                incomplete == NULL ? "" : incomplete);
    g_free(incomplete);
    junit_attributes(xml, &counts);
    g_string_append(xml, ">\n");
    for (size_t i = 0; i < json_array_size(cases); i++)
        junit_case(xml, records, json_array_get(cases, i));
    g_string_append(xml, "</testsuites>\n");
    return g_string_free(xml, FALSE);
}

/* ------------------------------------------------------------------------ TAP */

/* One line without the characters that start a directive. */
static void add_tap_text(GString *tap, const char *text)
{
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '#' || *c == '\\')
            g_string_append_printf(tap, "\\%c", *c);
        else
            g_string_append_c(tap, (unsigned char)*c < ' ' ? ' ' : *c);
}

/* A text in double quotes, as YAML and JSON read it. */
static void add_quoted(GString *tap, const char *key, const char *text)
{
    json_t *string = json_string(text);
    char *quoted = json_dumps(string, JSON_ENCODE_ANY);
    g_string_append_printf(tap, "  %s: %s\n", key, quoted);
    free(quoted);
    json_decref(string);
}

static void tap_check(GString *tap, size_t number, const json_t *check)
{
    const enum verdict_status status = record_status(check);
    char *name = text_check_name(check), *text = details(check);
    g_string_append_printf(tap, "%sok %zu - ", verdict_is_red(status) ? "not " : "", number);
    add_tap_text(tap, name);
    if (status == VERDICT_SKIP) {
        g_string_append(tap, " # SKIP ");
        add_tap_text(tap, record_text(check, "reason"));
    }
    g_string_append_c(tap, '\n');
    if (verdict_is_red(status) || status == VERDICT_EXPECTED_FAIL) {
        g_string_append(tap, "  ---\n");
        add_quoted(tap, "status", verdict_status_name(status));
        add_quoted(tap, "message", text);
        g_string_append(tap, "  ...\n");
    }
    g_free(name);
    g_free(text);
}

char *report_tap(const struct records *records)
{
    GString *tap = g_string_new("TAP version 13\n");
    g_string_append_printf(tap, "1..%zu\n", json_array_size(records->checks));
    char *incomplete = records_incomplete(records);
    if (incomplete != NULL)
        g_string_append_printf(tap, "# %s\n", incomplete);
    g_free(incomplete);
    for (size_t i = 0; i < json_array_size(records->checks); i++)
        tap_check(tap, i + 1, json_array_get(records->checks, i));
    return g_string_free(tap, FALSE);
}
