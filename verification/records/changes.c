/* What changed between two runs of the suite.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/records/changes.h"

#include "verification/common/text.h"
#include "verification/records/check_text.h"

#include <math.h>
#include <string.h>

struct gathering {
    const struct records *before, *after;
    GHashTable *checks_before, *checks_after; /* by "case/check/variant" */
    GHashTable *values_before;                /* by "case/quantity/variant" */
    GHashTable *judged;                       /* of those quantities, that have a check */
    double change;
    struct changes *changes;
};

/* ----------------------------------------------------------------------- lines */

const char *changes_word(enum run_change change)
{
    static const char *const words[] = {"", "better", "worse", "changed"};
    return words[change];
}

static void add_line(struct gathering *runs, const char *section, enum run_change change,
                     const json_t *of, const char *name, const char *text)
{
    json_t *line = json_object();
    json_object_set_new(line, "section", json_string(section));
    json_object_set_new(line, "change", json_string(changes_word(change)));
    json_object_set_new(line, "case", json_string(record_text(of, "case")));
    json_object_set_new(line, "name", record_text_of(name));
    json_object_set_new(line, "text", record_text_of(text));
    json_array_append_new(runs->changes->lines, line);
    runs->changes->worse += change == RUN_WORSE;
    runs->changes->better += change == RUN_BETTER;
    runs->changes->other += change == RUN_OTHER;
}

/* Takes the text over. */
static void add_check(struct gathering *runs, const char *section, enum run_change change,
                      const json_t *check, char *text)
{
    char *name = text_check_name(check);
    add_line(runs, section, change, check, name, text);
    g_free(name);
    g_free(text);
}

/* -------------------------------------------------------------------- checks */

static void compare_statuses(struct gathering *runs)
{
    for (size_t i = 0; i < json_array_size(runs->after->checks); i++) {
        const json_t *after = json_array_get(runs->after->checks, i);
        const json_t *before = record_find(runs->checks_before, after, "check");
        if (before == NULL)
            continue;
        const enum run_change change =
            run_change_status(record_status(before), record_status(after));
        if (change == RUN_SAME)
            continue;
        const char *reason = record_text(after, "reason");
        add_check(runs, "Statuses", change, after,
                  g_strconcat(record_text(before, "status"), ", then ",
                              record_text(after, "status"), *reason == '\0' ? "" : ": ", reason,
                              NULL));
    }
}

/* A check that a run did not select has not vanished. */
static bool same_selection(const struct gathering *runs)
{
    static const char *const keys[] = {"tier", "case_glob", "variant_glob", "only"};
    bool same = true;
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        same = same && strcmp(record_text(runs->before->run, keys[i]),
                              record_text(runs->after->run, keys[i])) == 0;
    return same;
}

static void compare_presence(struct gathering *runs)
{
    static const char presence[] = "Checks that appeared or vanished";
    size_t unselected = 0;
    const bool same = same_selection(runs);
    for (size_t i = 0; i < json_array_size(runs->after->checks); i++) {
        const json_t *after = json_array_get(runs->after->checks, i);
        if (record_find(runs->checks_before, after, "check") != NULL)
            continue;
        const bool red = verdict_is_red(record_status(after));
        add_check(runs, presence, red ? RUN_WORSE : RUN_OTHER, after,
                  g_strconcat("new: ", record_text(after, "status"), NULL));
    }
    for (size_t i = 0; i < json_array_size(runs->before->checks); i++) {
        const json_t *before = json_array_get(runs->before->checks, i);
        if (record_find(runs->checks_after, before, "check") != NULL)
            continue;
        if (same) {
            add_check(runs, presence, RUN_WORSE, before,
                      g_strconcat("gone: was ", record_text(before, "status"), NULL));
        }
        unselected += !same;
    }
    runs->changes->unselected = unselected;
}

static char *values_text(const json_t *before, const json_t *after)
{
    const double one = record_number(before, "value"), other = record_number(after, "value");
    char *from = text_quantity(one, record_text(before, "unit"));
    char *to = text_quantity(other, record_text(after, "unit"));
    const double percent = 100.0 * (other / one - 1.0);
    char *part = isfinite(percent) ? g_strdup_printf(" (%+.3g %%)", percent) : g_strdup("");
    char *text = g_strconcat(from, ", then ", to, part, NULL);
    g_free(part);
    g_free(from);
    g_free(to);
    return text;
}

static void compare_values(struct gathering *runs)
{
    for (size_t i = 0; i < json_array_size(runs->after->checks); i++) {
        const json_t *after = json_array_get(runs->after->checks, i);
        const json_t *before = record_find(runs->checks_before, after, "check");
        if (before == NULL || !(run_change_relative(record_number(before, "value"),
                                                    record_number(after, "value")) > runs->change))
            continue;
        const double one = record_number(before, "margin"), other = record_number(after, "margin");
        const enum run_change margin = run_change_margin(one, other);
        char *values = values_text(before, after), *from = text_number(one),
             *to = text_number(other);
        add_check(runs, "Values of checks, and their margins",
                  margin == RUN_SAME ? RUN_OTHER : margin, after,
                  g_strdup_printf("%s; margin %s, then %s", values, from, to));
        g_free(values);
        g_free(from);
        g_free(to);
    }
}

/* ----------------------------------------------------------- other quantities */

/* Times have noise, and a comparison of their own. */
static bool is_time(const json_t *line)
{
    return g_str_has_suffix(record_text(line, "quantity"), "seconds");
}

static void compare_measurements(struct gathering *runs)
{
    for (size_t i = 0; i < json_array_size(runs->after->measurements); i++) {
        const json_t *after = json_array_get(runs->after->measurements, i);
        const json_t *before = record_find(runs->values_before, after, "quantity");
        if (before == NULL || is_time(after) ||
            record_find(runs->judged, after, "quantity") != NULL ||
            !(run_change_relative(record_number(before, "value"), record_number(after, "value")) >
              runs->change))
            continue;
        char *name = g_strdup_printf("%s/%s [%s]", record_text(after, "case"),
                                     record_text(after, "quantity"), record_text(after, "variant"));
        char *text = values_text(before, after);
        add_line(runs, "Quantities without a check", RUN_OTHER, after, name, text);
        g_free(text);
        g_free(name);
    }
}

/* ------------------------------------------------------------------------ all */

struct changes changes_gather(const struct records *before, const struct records *after,
                              double change)
{
    struct changes changes = {.lines = json_array()};
    struct gathering runs = {
        .before = before,
        .after = after,
        .checks_before = record_index(before->checks, "check"),
        .checks_after = record_index(after->checks, "check"),
        .values_before = record_index(before->measurements, "quantity"),
        .judged = record_index(after->checks, "quantity"),
        .change = change,
        .changes = &changes,
    };
    compare_statuses(&runs);
    compare_presence(&runs);
    compare_values(&runs);
    compare_measurements(&runs);
    g_hash_table_unref(runs.checks_before);
    g_hash_table_unref(runs.checks_after);
    g_hash_table_unref(runs.values_before);
    g_hash_table_unref(runs.judged);
    return changes;
}

void changes_clear(struct changes *changes)
{
    json_decref(changes->lines);
    *changes = (struct changes){.lines = NULL};
}

static json_t *run_facts(const json_t *run)
{
    static const char *const keys[] = {"version", "revision", "compiler", "simd",
                                       "kernels", "tier",     "started"};
    json_t *facts = json_object();
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        json_object_set_new(facts, keys[i], json_string(record_text(run, keys[i])));
    return facts;
}

json_t *changes_record(const struct changes *changes, const json_t *before, const json_t *after,
                       double change)
{
    json_t *record = json_object();
    json_object_set_new(record, "format", json_integer(1));
    json_object_set_new(record, "before", run_facts(before));
    json_object_set_new(record, "after", run_facts(after));
    json_object_set_new(record, "change", json_real(change));
    json_object_set_new(record, "worse", json_integer((json_int_t)changes->worse));
    json_object_set_new(record, "better", json_integer((json_int_t)changes->better));
    json_object_set_new(record, "other", json_integer((json_int_t)changes->other));
    json_object_set_new(record, "unselected", json_integer((json_int_t)changes->unselected));
    json_object_set(record, "lines", changes->lines);
    return record;
}
