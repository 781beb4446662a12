/* Headroom of every declared check, over variants and builds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/headroom_table.h"
#include "verification/records/records.h"

#include <math.h>
#include <string.h>

const char *headroom_fault_words(enum headroom_fault fault)
{
    static const char *const words[HEADROOM_FAULTS] = {
        [HEADROOM_SOUND] = "",
        [HEADROOM_UNREASONED] = "no reason written",
        [HEADROOM_STALE] = "a reason is written, and none is needed",
        [HEADROOM_MISSING] = "no value in a build that ran it",
        [HEADROOM_OUTSIDE] = "outside its band",
    };
    return words[fault];
}

double declared_headroom_least(const struct declared_headroom *declared)
{
    return declared->least[declared->nearest];
}

static struct verdict_band band_of(const json_t *check)
{
    return (struct verdict_band){
        .expected = record_number(check, "expected"),
        .low = record_number(check, "low"),
        .high = record_number(check, "high"),
        .fails_low = record_number(check, "fails_low"),
        .fails_high = record_number(check, "fails_high"),
        .weakness = json_is_number(json_object_get(check, "fails_low")),
    };
}

/* --------------------------------------------------------------------- gathering */

/* Takes the value of a record in a build in. */
static void take(struct headroom_table *table, struct declared_headroom *declared,
                 const json_t *check, unsigned build, double value)
{
    const double room = headroom_of(&declared->band, value);
    if (isnan(room)) {
        table->without[build]++;
        if (declared->missing == NULL) {
            declared->missing = check;
            declared->missing_in = build;
        }
        return;
    }
    table->values[build]++;
    if (declared->variant == NULL || room < declared_headroom_least(declared)) {
        declared->nearest = build;
        declared->variant = check;
    }
    declared->least[build] = fmin(declared->least[build], room); /* of NaN and a number, that */
}

static void take_check(struct headroom_table *table, struct declared_headroom *declared,
                       const json_t *check, const json_t *builds)
{
    double least = record_number(check, "value"), largest = least;
    char *key = record_key(check, "check");
    take(table, declared, check, 0, least);
    for (unsigned i = 1; i < table->build_count; i++) {
        const json_t *values = json_object_get(json_array_get(builds, i - 1), "values");
        if (json_object_get(values, key) == NULL)
            continue; /* not run there */
        const double value = record_number(values, key);
        take(table, declared, check, i, value);
        least = fmin(least, value);
        largest = fmax(largest, value);
    }
    declared->spread = fmax(declared->spread, headroom_spread(&declared->band, least, largest));
    g_free(key);
}

static struct declared_headroom *find(const GArray *checks, const json_t *check)
{
    for (unsigned k = checks->len; k > 0; k--) {
        struct declared_headroom *other = &g_array_index(checks, struct declared_headroom, k - 1);
        if (strcmp(record_text(other->first, "case"), record_text(check, "case")) != 0)
            break;
        if (record_same_declaration(other->first, check))
            return other;
    }
    return NULL;
}

static struct declared_headroom *add(struct headroom_table *table, const json_t *check)
{
    const struct declared_headroom fresh = {
        .first = check, .band = band_of(check), .least = g_new(double, table->build_count)};
    for (unsigned i = 0; i < table->build_count; i++)
        fresh.least[i] = (double)NAN;
    g_array_append_val(table->checks, fresh);
    return &g_array_index(table->checks, struct declared_headroom, table->checks->len - 1);
}

/* ----------------------------------------------------------------------- judging */

static enum headroom_fault fault_of(const struct declared_headroom *declared)
{
    const double least = declared_headroom_least(declared);
    const enum headroom judged = headroom_judge(least);
    const bool outside = judged == HEADROOM_FLAKY || judged == HEADROOM_SLACK;
    const bool reasoned = *record_text(declared->first, "headroom") != '\0';
    return declared->missing != NULL ? HEADROOM_MISSING
           : least < 1               ? HEADROOM_OUTSIDE
           : outside && !reasoned    ? HEADROOM_UNREASONED
           : !outside && reasoned    ? HEADROOM_STALE
                                     : HEADROOM_SOUND;
}

static void clear_declared(void *element)
{
    struct declared_headroom *declared = element;
    g_free(declared->least);
}

struct headroom_table headroom_table_make(const json_t *checks, const json_t *builds)
{
    struct headroom_table table = {
        .checks = g_array_new(FALSE, TRUE, sizeof(struct declared_headroom)),
        .build_count = (unsigned)json_array_size(builds) + 1,
    };
    g_array_set_clear_func(table.checks, clear_declared);
    table.names = g_new(const char *, table.build_count);
    table.without = g_new0(size_t, table.build_count);
    table.values = g_new0(size_t, table.build_count);
    for (unsigned i = 0; i < table.build_count; i++)
        table.names[i] = i == 0 ? "this run" : record_text(json_array_get(builds, i - 1), "name");
    for (size_t i = 0; i < json_array_size(checks); i++) {
        const json_t *check = json_array_get(checks, i);
        if (record_status(check) == VERDICT_SKIP)
            continue;
        struct declared_headroom *declared = find(table.checks, check);
        take_check(&table, declared == NULL ? add(&table, check) : declared, check, builds);
    }
    for (unsigned i = 0; i < table.checks->len; i++) {
        struct declared_headroom *declared =
            &g_array_index(table.checks, struct declared_headroom, i);
        declared->fault = fault_of(declared);
    }
    return table;
}

void headroom_table_clear(struct headroom_table *table)
{
    g_array_unref(table->checks);
    g_free(table->names);
    g_free(table->without);
    g_free(table->values);
    *table = (struct headroom_table){.checks = NULL};
}

size_t headroom_table_faults(const struct headroom_table *table, enum headroom_fault fault)
{
    size_t count = 0;
    for (unsigned i = 0; i < table->checks->len; i++)
        count += g_array_index(table->checks, struct declared_headroom, i).fault == fault;
    return count;
}

size_t headroom_table_count(const struct headroom_table *table, unsigned build,
                            enum headroom judged)
{
    size_t count = 0;
    for (unsigned i = 0; i < table->checks->len; i++) {
        const struct declared_headroom *declared =
            &g_array_index(table->checks, struct declared_headroom, i);
        const double room = build == table->build_count ? declared_headroom_least(declared)
                                                        : declared->least[build];
        count += headroom_judge(room) == judged;
    }
    return count;
}

size_t headroom_table_reasoned(const struct headroom_table *table, enum headroom judged)
{
    size_t count = 0;
    for (unsigned i = 0; i < table->checks->len; i++) {
        const struct declared_headroom *declared =
            &g_array_index(table->checks, struct declared_headroom, i);
        count += headroom_judge(declared_headroom_least(declared)) == judged &&
                 *record_text(declared->first, "headroom") != '\0';
    }
    return count;
}
