/* mpm-verify list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"
#include "verification/common/names.h"
#include "verification/suite/plan.h"

#include "mpm_words.h"

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

/* Any of `tags`, joined by commas; NULL: whatever it has. */
static bool has_tag(const struct case_file *file, const char *tags)
{
    bool found = tags == NULL;
    char **const list = g_strsplit(tags == NULL ? "" : tags, ",", -1);
    for (unsigned i = 0; i < file->tags_count; i++)
        found = found || g_strv_contains((const char *const *)list, file->tags[i]);
    g_strfreev(list);
    return found;
}

static const char *tag_hint(const struct catalogue *catalogue, const char *tags,
                            char hint[MPM_HINT_SIZE])
{
    struct mpm_nearest nearest = {.word = tags};
    for (size_t c = 0; c < catalogue->count; c++)
        for (unsigned i = 0; i < catalogue->cases[c].file->tags_count; i++)
            mpm_nearest_offer(&nearest, catalogue->cases[c].file->tags[i]);
    return mpm_nearest_hint(&nearest, hint);
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
    const char *tags = command->options.tags;
    size_t shown = 0;
    TRY(command_catalogue(command, &catalogue, error));
    for (size_t i = 0; i < catalogue->count; i++) {
        const struct case_file *file = catalogue->cases[i].file;
        if (!has_tag(file, tags))
            continue;
        if (command->options.names)
            fprintf(out, "%s\n", file->name);
        if (shown++ == 0 && !command->options.names)
            fprintf(out, "%-7s %-10s %11s  %s\n%-7s %-10s %5s %5s\n", "", "", "checks", "",
                    "family", "case", "ci", "full");
        if (!command->options.names)
            print_case(out, file);
    }
    char hint[MPM_HINT_SIZE];
    const enum mpm_status status =
        shown > 0 ? MPM_OK
                  : failure_set(error, MPM_BAD_INPUT, "no case has the tag %s%s", tags,
                                tag_hint(catalogue, tags, hint));
    catalogue_free(catalogue);
    return status;
}
