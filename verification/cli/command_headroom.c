/* mpm-verify headroom: judges the bands of a run whose values in other builds are stored beside it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"
#include "verification/common/text.h"
#include "verification/records/headroom_table.h"
#include "verification/records/records.h"
#include "verification/report/report_stored.h"

#include <math.h>

static void print_fault(FILE *out, const struct headroom_table *table,
                        const struct declared_headroom *declared)
{
    const json_t *check = declared->first;
    const bool missing = declared->missing != NULL;
    const json_t *record = missing ? declared->missing : declared->variant;
    const double least = declared_headroom_least(declared);
    char *number = missing ? g_strdup("no value") : text_number(least);
    fprintf(out, "%s/%s [%s], %s: %s: %s\n", record_text(check, "case"),
            record_text(check, "check"), record_text(record, "variant"),
            table->names[missing ? declared->missing_in : declared->nearest],
            missing || isfinite(least) ? number : "exact", headroom_fault_words(declared->fault));
    g_free(number);
}

static void print_builds(FILE *out, const struct headroom_table *table)
{
    fprintf(out, "%-12s %7s %7s %7s %7s\n", "build", "flaky", "slack", "values", "missing");
    for (unsigned i = 0; i < table->build_count; i++)
        fprintf(out, "%-12s %7zu %7zu %7zu %7zu\n", table->names[i],
                headroom_table_count(table, i, HEADROOM_FLAKY),
                headroom_table_count(table, i, HEADROOM_SLACK), table->values[i],
                table->without[i]);
}

/* Returns the number of faults. */
static size_t print(FILE *out, const struct headroom_table *table)
{
    for (unsigned i = 0; i < table->checks->len; i++) {
        const struct declared_headroom *declared =
            &g_array_index(table->checks, struct declared_headroom, i);
        if (declared->fault != HEADROOM_SOUND)
            print_fault(out, table, declared);
    }
    print_builds(out, table);
    const size_t sound = headroom_table_faults(table, HEADROOM_SOUND);
    const size_t outside = headroom_table_count(table, table->build_count, HEADROOM_FLAKY) +
                           headroom_table_count(table, table->build_count, HEADROOM_SLACK);
    fprintf(out, "%u checks, %zu outside 1.5 to 100 in any build\n", table->checks->len, outside);
    fprintf(out, "%zu passed, %zu failed, 0 skipped\n", sound, table->checks->len - sound);
    return table->checks->len - sound;
}

enum mpm_status command_headroom(struct command *command, struct mpm_error *error)
{
    const char *folder = command->options.rest[0];
    struct records records;
    struct report_stored stored;
    TRY(records_read(folder, &records, error));
    enum mpm_status status = report_stored_read(folder, &stored, error);
    if (status == MPM_OK && stored.headroom == NULL)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: no headroom.json; mpm-verify report %s --headroom NAME=DIR makes "
                             "it",
                             folder, folder);
    if (status == MPM_OK) {
        struct headroom_table table =
            headroom_table_make(records.checks, json_object_get(stored.headroom, "builds"));
        command->checks_failed = print(command->world->out, &table) > 0;
        headroom_table_clear(&table);
    }
    report_stored_clear(&stored);
    records_clear(&records);
    return status;
}
