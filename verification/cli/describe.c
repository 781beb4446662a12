/* mpm-verify list and explain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/methods.h"
#include "verification/cli/commands.h"
#include "verification/common/names.h"
#include "verification/common/resources.h"
#include "verification/common/text.h"
#include "verification/records/check_text.h"
#include "verification/suite/plan.h"

#include <glib.h>
#include <string.h>

/* ---------------------------------------------------------------------- list */

/* Declared checks at a size. */
static size_t count_checks(const struct case_file *file, enum tier tier)
{
    size_t count = 0;
    for (unsigned c = 0; c < file->checks_count; c++)
        for (unsigned v = 0; v < file->variants_count; v++)
            if (file->variants[v].tier <= tier &&
                globs_match(file->checks[c].variants, file->checks[c].variants_count,
                            file->variants[v].name))
                count++;
    return count;
}

static bool has_tag(const struct case_file *file, const char *tag)
{
    if (tag == NULL)
        return true;
    for (unsigned i = 0; i < file->tags_count; i++)
        if (strcmp(file->tags[i], tag) == 0)
            return true;
    return false;
}

static void print_case(FILE *out, const struct case_file *file)
{
    fprintf(out, "%-7s %-10s %5zu %5zu  %s\n", file->family, file->name,
            count_checks(file, TIER_CI), count_checks(file, TIER_FULL), file->title);
    fprintf(out, "%32svariants:", "");
    for (unsigned i = 0; i < file->variants_count; i++)
        fprintf(out, " %s%s", file->variants[i].name,
                file->variants[i].tier == TIER_FULL ? " (full)" : "");
    fputc('\n', out);
    if (file->tags_count > 0)
        fprintf(out, "%32stags:", "");
    for (unsigned i = 0; i < file->tags_count; i++)
        fprintf(out, " %s", file->tags[i]);
    if (file->tags_count > 0)
        fputc('\n', out);
}

enum mpm_status command_list(struct command *command, struct mpm_error *error)
{
    struct catalogue *catalogue;
    FILE *out = command->world->out;
    const char *tag = command->options.tag;
    size_t shown = 0;
    TRY(command_catalogue(command, &catalogue, error));
    for (size_t i = 0; i < catalogue->count; i++) {
        const struct case_file *file = catalogue->cases[i].file;
        if (!has_tag(file, tag))
            continue;
        if (shown++ == 0)
            fprintf(out, "%-7s %-10s %11s  %s\n%-7s %-10s %5s %5s\n", "", "", "checks", "",
                    "family", "case", "ci", "full");
        print_case(out, file);
    }
    catalogue_free(catalogue);
    return shown > 0 ? MPM_OK : failure_set(error, MPM_BAD_INPUT, "no case has the tag %s", tag);
}

/* ------------------------------------------------------------------- explain */

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

static const json_t *last_record(const struct records *records, const struct planned_job *job,
                                 const struct case_check *check)
{
    for (size_t i = 0; records != NULL && i < json_array_size(records->checks); i++) {
        const json_t *record = json_array_get(records->checks, i);
        if (strcmp(record_text(record, "case"), job->entry->file->name) == 0 &&
            strcmp(record_text(record, "check"), check->name) == 0 &&
            strcmp(record_text(record, "variant"), job->variant->name) == 0)
            return record;
    }
    return NULL;
}

static void print_last(const struct explanation *explanation, const struct planned_job *job,
                       const struct case_check *check)
{
    const json_t *last = last_record(explanation->records, job, check);
    if (last == NULL) {
        fprintf(explanation->out, "  last run   none in %s\n", explanation->output);
        return;
    }
    char *value = text_value(last);
    char *margin = text_number(record_number(last, "margin"));
    fprintf(explanation->out, "  last run   %s, %s, margin %s (%s)%s%s\n", value,
            record_text(last, "status"), margin, explanation->output,
            *record_text(last, "reason") == '\0' ? "" : ": ", record_text(last, "reason"));
    g_free(value);
    g_free(margin);
}

static void print_declaration(const struct explanation *explanation, const struct planned_job *job,
                              const struct case_check *check)
{
    FILE *out = explanation->out;
    const struct verdict_band *band = &check->band;
    const char *evidence = evidence_name(check_evidence(job->entry->file, check));
    char *expected = text_quantity(band->expected, check->unit);
    char *good = text_range(band->low, band->high, check->unit);
    char *weak = text_range(band->fails_low, band->fails_high, check->unit);
    char *command =
        text_command(job->entry->file->name, job->variant->name, job->variant->tier == TIER_FULL,
                     explanation->records == NULL ? NULL : explanation->records->run);
    fprintf(out, "%s/%s/%s: %s\n", job->entry->file->name, check->name, job->variant->name,
            check->title);
    if (job->variant->method != NULL)
        fprintf(out, "  method     %s\n", job->variant->method->title);
    fprintf(out, "  quantity   %s, norm: %s\n", check->quantity, check->norm);
    fprintf(out, "  expected   %s\n", expected);
    fprintf(out, "  band       %s%s, from %s\n", good, band->weakness ? " for a good method" : "",
            basis_name(check->basis));
    if (band->weakness)
        fprintf(out, "  weakness   known to fail: required to lie in %s\n", weak);
    fprintf(out, "  why        %s\n", check->why);
    if (check->basis == BASIS_INDEPENDENT)
        fprintf(out, "  computed   %s\n", job->entry->file->calculation);
    fprintf(out, "  evidence   %s\n", *evidence == '\0' ? "not stated" : evidence);
    if (check->headroom != NULL)
        fprintf(out, "  headroom   %s\n", check->headroom);
    fprintf(out, "  reproduce  %s\n", command);
    g_free(expected);
    g_free(good);
    g_free(weak);
    g_free(command);
}

static void explain_case(struct explanation *explanation, const struct catalogue_case *entry)
{
    bool headed = false;
    for (unsigned c = 0; c < entry->file->checks_count; c++)
        for (unsigned v = 0; v < entry->file->variants_count; v++) {
            const struct case_check *check = &entry->file->checks[c];
            const struct planned_job job = {.entry = entry, .variant = &entry->file->variants[v]};
            if (!globs_match(check->variants, check->variants_count, job.variant->name) ||
                !part_matches(explanation, 1, check->name) ||
                !part_matches(explanation, 2, job.variant->name))
                continue;
            if (!headed)
                fprintf(explanation->out, "%s%s\n", explanation->shown > 0 ? "\n" : "",
                        entry->readme);
            headed = true;
            print_declaration(explanation, &job, check);
            print_last(explanation, &job, check);
            explanation->shown++;
        }
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
        status = failure_set(error, MPM_BAD_INPUT,
                             "\"%s\" matches no check: allowed is CASE[/CHECK[/VARIANT]] with "
                             "globs; see mpm-verify list",
                             options->rest[0]);
    g_strfreev(globs);
    g_free(output);
    if (read)
        records_clear(&records);
    catalogue_free(catalogue);
    return status;
}
