/* mpm-verify explain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/methods.h"
#include "verification/cli/commands.h"
#include "verification/common/names.h"
#include "verification/common/resources.h"
#include "verification/common/text.h"
#include "verification/records/check_text.h"
#include "verification/suite/plan.h"

#include "mpm_words.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* With the longest reasons of the catalogue that many rows fit into 24 lines. */
enum { LABEL_COLUMN = 13, LINE_WIDTH = 80, ROWS_SHOWN = 2 };

struct explanation {
    FILE *out;
    char **globs;                  /* case, check, variant; ends early where not given */
    const struct records *records; /* NULL if there are none */
    const char *output;
    size_t shown;
};

static bool part_matches(const struct explanation *explanation, size_t part, const char *name)
{
    const size_t given = g_strv_length(explanation->globs);
    return part >= given || glob_matches(explanation->globs[part], name);
}

static const json_t *last_record(const struct records *records, const char *case_name,
                                 const char *check, const char *variant)
{
    for (size_t i = 0; records != NULL && i < json_array_size(records->checks); i++) {
        const json_t *record = json_array_get(records->checks, i);
        if (strcmp(record_text(record, "case"), case_name) == 0 &&
            strcmp(record_text(record, "check"), check) == 0 &&
            strcmp(record_text(record, "variant"), variant) == 0)
            return record;
    }
    return NULL;
}

/* A label and its text, which goes on beside it; frees the text. */
static void print_label(FILE *out, const char *label, char *text)
{
    fprintf(out, "  %-*s", LABEL_COLUMN - 2, label);
    mpm_words_wrap(out, text, LABEL_COLUMN, LABEL_COLUMN, LINE_WIDTH);
    g_free(text);
}

/* ------------------------------------------------------------------ last run */

/* A variant that a check is of, with what it had in the last run. */
struct last_value {
    const struct case_variant *variant;
    const json_t *record; /* NULL: none */
    double margin;
};

/* The least margin first, those without a value last. */
static gint by_margin(gconstpointer a, gconstpointer b)
{
    const struct last_value *const one = a, *const other = b;
    const double left = isfinite(one->margin) ? one->margin : HUGE_VAL;
    const double right = isfinite(other->margin) ? other->margin : HUGE_VAL;
    return (left > right) - (left < right);
}

/* The reason of a known weakness repeats its value and band. */
static char *value_text(const json_t *record)
{
    const char *status = record_text(record, "status");
    const char *reason = strcmp(status, "expected-fail") == 0 ? "" : record_text(record, "reason");
    char *value = text_value(record), *margin = text_number(record_number(record, "margin"));
    char *text = g_strdup_printf("%s, %s, margin %s%s%s", value, status, margin,
                                 *reason == '\0' ? "" : ": ", reason);
    g_free(value);
    g_free(margin);
    return text;
}

/* Rows of the variants that have a value; how many are printed. */
static unsigned print_rows(FILE *out, const GArray *values)
{
    unsigned count = 0;
    for (; count < MIN(values->len, (unsigned)ROWS_SHOWN); count++) {
        const struct last_value *value = &g_array_index(values, struct last_value, count);
        if (value->record == NULL)
            break;
        char *text = value_text(value->record);
        print_label(out, count == 0 ? "last run" : "",
                    g_strdup_printf("%s: %s", value->variant->name, text));
        g_free(text);
    }
    return count;
}

static void print_values(const struct explanation *explanation, const GArray *values)
{
    FILE *out = explanation->out;
    const struct last_value *first = &g_array_index(values, struct last_value, 0);
    if (first->record == NULL) {
        print_label(out, "last run", g_strdup_printf("none in %s", explanation->output));
        return;
    }
    if (values->len == 1) {
        char *text = value_text(first->record);
        print_label(out, "last run", g_strdup_printf("%s (%s)", text, explanation->output));
        g_free(text);
        return;
    }
    const unsigned left = values->len - print_rows(out, values);
    char *more = left == 0 ? g_strdup("") : g_strdup_printf("; %u more", left);
    print_label(out, "", g_strdup_printf("(%s; least margins first%s)", explanation->output, more));
    g_free(more);
}

/* --------------------------------------------------------------- declaration */

static void print_variants(FILE *out, const GArray *values)
{
    const struct case_variant *first = g_array_index(values, struct last_value, 0).variant;
    if (values->len > 1) {
        print_label(out, "variants", g_strdup_printf("%u", values->len));
        return;
    }
    if (first->method != NULL)
        print_label(out, "method", g_strdup(first->method->title));
}

static void print_band(FILE *out, const struct case_check *check)
{
    const struct verdict_band *band = &check->band;
    char *good = text_range(band->low, band->high, check->unit);
    char *weak = text_range(band->fails_low, band->fails_high, check->unit);
    print_label(out, "expected", text_quantity(band->expected, check->unit));
    print_label(out, "band",
                g_strdup_printf("%s%s, from %s", good, band->weakness ? " for a good method" : "",
                                basis_name(check->basis)));
    if (band->weakness)
        print_label(out, "weakness", g_strdup_printf("known to fail: required to lie in %s", weak));
    g_free(good);
    g_free(weak);
}

static void print_check(const struct explanation *explanation, const struct case_file *file,
                        const struct case_check *check, const GArray *values)
{
    FILE *out = explanation->out;
    const struct case_variant *first = g_array_index(values, struct last_value, 0).variant;
    const char *evidence = evidence_name(check_evidence(file, check));
    const bool alone = values->len == 1;
    char *heading = g_strdup_printf("%s/%s%s%s: %s", file->name, check->name, alone ? "/" : "",
                                    alone ? first->name : "", check->title);
    mpm_words_wrap(out, heading, 0, 2, LINE_WIDTH);
    g_free(heading);
    print_label(out, "case", g_strdup(file->title));
    print_variants(out, values);
    print_label(out, "quantity", g_strdup_printf("%s, norm: %s", check->quantity, check->norm));
    print_band(out, check);
    print_label(out, "why", g_strdup(check->why));
    if (check->basis == BASIS_INDEPENDENT)
        print_label(out, "computed", g_strdup(file->calculation));
    print_label(out, "evidence", g_strdup(*evidence == '\0' ? "not stated" : evidence));
    if (check->headroom != NULL)
        print_label(out, "headroom", g_strdup(check->headroom));
    /* to be pasted: whatever its length, a line */
    char *command = text_command(file->name, first->name, first->tier == TIER_FULL,
                                 explanation->records == NULL ? NULL : explanation->records->run);
    fprintf(out, "  %-*s%s\n", LABEL_COLUMN - 2, "reproduce", command);
    g_free(command);
    print_values(explanation, values);
}

/* The variants of a check that are asked for. */
static GArray *values_of(const struct explanation *explanation, const struct case_file *file,
                         const struct case_check *check)
{
    GArray *values = g_array_new(FALSE, FALSE, sizeof(struct last_value));
    for (unsigned v = 0; v < file->variants_count; v++) {
        const struct case_variant *variant = &file->variants[v];
        if (!globs_match(check->variants, check->variants_count, variant->name) ||
            !part_matches(explanation, 2, variant->name))
            continue;
        const json_t *record =
            last_record(explanation->records, file->name, check->name, variant->name);
        const struct last_value value = {
            variant, record, record == NULL ? (double)NAN : record_number(record, "margin")};
        g_array_append_val(values, value);
    }
    g_array_sort(values, by_margin);
    return values;
}

/* The case whole where no check of it is named, else the checks alone: a screen for one. */
static void explain_case(struct explanation *explanation, const struct catalogue_case *entry)
{
    const struct case_file *file = entry->file;
    bool headed = g_strv_length(explanation->globs) > 1;
    for (unsigned c = 0; c < file->checks_count; c++) {
        const struct case_check *check = &file->checks[c];
        GArray *values = values_of(explanation, file, check);
        if (values->len > 0 && part_matches(explanation, 1, check->name)) {
            if (explanation->shown++ > 0)
                fputc('\n', explanation->out);
            if (!headed)
                fprintf(explanation->out, "%s\n", entry->readme);
            headed = true;
            print_check(explanation, file, check, values);
        }
        g_array_unref(values);
    }
}

/* What the first part that matches nothing may mean: a case, a check or a variant. */
static enum mpm_status refuse_check(const struct catalogue *catalogue,
                                    const struct explanation *explanation, const char *given,
                                    struct mpm_error *error)
{
    struct mpm_nearest parts[3];
    char hint[MPM_HINT_SIZE];
    for (size_t p = 0; p < G_N_ELEMENTS(parts); p++)
        parts[p] = (struct mpm_nearest){
            .word = p < g_strv_length(explanation->globs) ? explanation->globs[p] : ""};
    bool known[3] = {false};
    for (size_t c = 0; c < catalogue->count; c++) {
        const struct case_file *const file = catalogue->cases[c].file;
        mpm_nearest_offer(&parts[0], file->name);
        if (!part_matches(explanation, 0, file->name))
            continue;
        known[0] = true;
        for (unsigned i = 0; i < file->checks_count; i++) {
            mpm_nearest_offer(&parts[1], file->checks[i].name);
            known[1] = known[1] || part_matches(explanation, 1, file->checks[i].name);
        }
        for (unsigned i = 0; i < file->variants_count; i++)
            mpm_nearest_offer(&parts[2], file->variants[i].name);
    }
    return failure_set(error, MPM_BAD_INPUT,
                       "\"%s\" matches no check: allowed is CASE[/CHECK[/VARIANT]] with globs%s; "
                       "see mpm-verify list",
                       given,
                       mpm_nearest_hint(&parts[!known[0]   ? 0
                                               : !known[1] ? 1
                                                           : 2],
                                        hint));
}

enum mpm_status command_explain(struct command *command, struct mpm_error *error)
{
    struct catalogue *catalogue;
    const struct command_options *options = &command->options;
    TRY(command_catalogue(command, &catalogue, error));
    char *output = options->output != NULL ? g_strdup(options->output) : resources_output();
    struct records records = {.run = NULL};
    /* a folder that was named must be readable; the default one may not exist yet */
    enum mpm_status status = records_read(output, &records, error);
    const bool read = status == MPM_OK;
    if (options->output == NULL)
        status = MPM_OK;
    char **globs = g_strsplit(options->rest[0], "/", -1);
    struct explanation explanation = {command->world->out, globs, read ? &records : NULL, output,
                                      0};
    for (size_t i = 0; status == MPM_OK && i < catalogue->count; i++)
        if (g_strv_length(globs) <= 3 &&
            part_matches(&explanation, 0, catalogue->cases[i].file->name))
            explain_case(&explanation, &catalogue->cases[i]);
    if (status == MPM_OK && explanation.shown == 0)
        status = refuse_check(catalogue, &explanation, options->rest[0], error);
    g_strfreev(globs);
    g_free(output);
    if (read)
        records_clear(&records);
    catalogue_free(catalogue);
    return status;
}
