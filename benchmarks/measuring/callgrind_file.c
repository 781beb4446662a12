/* Reading what valgrind's callgrind writes: a header with the names of the events, blocks of
 * `ob=`, `fl=`, `fn=` and lines of costs, and the totals.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/callgrind_file.h"

#include "verification/common/failure.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

enum event { INSTRUCTIONS, BRANCHES, EVENTS };
static const char *const event_names[EVENTS] = {"Ir", "Bc"};

struct reader {
    int columns[EVENTS]; /* place of the event in a line of costs; -1: none */
    uint64_t totals[EVENTS], sums[EVENTS];
    bool has_totals;
    bool in_library;
    bool after_call;                     /* the next costs are those of a callee, in all */
    struct callgrind_function *function; /* the one that costs go to */
    GHashTable *functions;               /* by name */
    uint64_t own_branches;
};

static void read_events(struct reader *reader, const char *names)
{
    char **words = g_strsplit(names, " ", -1);
    for (int e = 0; e < EVENTS; e++)
        for (int i = 0; words[i] != NULL; i++)
            if (strcmp(words[i], event_names[e]) == 0)
                reader->columns[e] = i;
    g_strfreev(words);
}

/* Events that did not happen are left out at the end of a line. */
static void read_costs(const struct reader *reader, const char *numbers, uint64_t costs[EVENTS])
{
    char **words = g_strsplit(numbers, " ", -1);
    const int count = (int)g_strv_length(words);
    for (int e = 0; e < EVENTS; e++)
        costs[e] = reader->columns[e] >= 0 && reader->columns[e] < count
                       ? g_ascii_strtoull(words[reader->columns[e]], NULL, 10)
                       : 0;
    g_strfreev(words);
}

static void enter_function(struct reader *reader, const char *name)
{
    reader->function = g_hash_table_lookup(reader->functions, name);
    if (reader->function != NULL)
        return;
    reader->function = g_new0(struct callgrind_function, 1);
    g_strlcpy(reader->function->name, name, sizeof reader->function->name);
    g_hash_table_insert(reader->functions, g_strdup(name), reader->function);
}

static void add_costs(struct reader *reader, const char *line)
{
    const char *numbers = strchr(line, ' '); /* behind the position */
    uint64_t costs[EVENTS];
    if (reader->after_call || reader->function == NULL || numbers == NULL) {
        reader->after_call = false;
        return;
    }
    read_costs(reader, numbers + 1, costs);
    for (int e = 0; e < EVENTS; e++)
        reader->sums[e] += costs[e];
    reader->function->instructions += costs[INSTRUCTIONS];
    reader->function->branches += costs[BRANCHES];
    if (!reader->in_library)
        reader->own_branches += costs[BRANCHES];
}

static void read_line(struct reader *reader, const char *line)
{
    if (g_str_has_prefix(line, "events: ")) {
        read_events(reader, line + strlen("events: "));
    } else if (g_str_has_prefix(line, "totals: ")) {
        read_costs(reader, line + strlen("totals: "), reader->totals);
        reader->has_totals = true;
    } else if (g_str_has_prefix(line, "ob=")) {
        reader->in_library = strstr(line, ".so") != NULL;
    } else if (g_str_has_prefix(line, "fn=")) {
        enter_function(reader, line + strlen("fn="));
    } else if (g_str_has_prefix(line, "calls=")) {
        reader->after_call = true;
    } else if (g_ascii_isdigit(*line)) {
        add_costs(reader, line);
    }
}

/* By instructions, then by name: the order of a hash table is nobody's. */
static int by_cost(const void *one, const void *other)
{
    const struct callgrind_function *a = one, *b = other;
    if (a->instructions != b->instructions)
        return a->instructions < b->instructions ? 1 : -1;
    return strcmp(a->name, b->name);
}

static void take_top(const struct reader *reader, struct callgrind_counts *counts)
{
    guint count;
    gpointer *names = g_hash_table_get_keys_as_array(reader->functions, &count);
    struct callgrind_function *sorted = g_new(struct callgrind_function, count);
    for (guint i = 0; i < count; i++)
        sorted[i] = *(struct callgrind_function *)g_hash_table_lookup(reader->functions, names[i]);
    qsort(sorted, count, sizeof *sorted, by_cost);
    for (guint i = 0; i < count && i < CALLGRIND_TOP; i++)
        counts->top[i] = sorted[i];
    g_free(sorted);
    g_free(names);
}

static enum mpm_status judge(const struct reader *reader, struct mpm_error *error)
{
    if (!reader->has_totals || reader->columns[INSTRUCTIONS] < 0 || reader->columns[BRANCHES] < 0)
        return failure_set(error, MPM_ENVIRONMENT_FAILED,
                           "callgrind's file has no totals of the events Ir and Bc");
    if (reader->totals[INSTRUCTIONS] == 0)
        return failure_set(error, MPM_ENVIRONMENT_FAILED,
                           "callgrind counted nothing: the program has none of the functions to "
                           "be counted, or took no step");
    for (int e = 0; e < EVENTS; e++)
        if (reader->sums[e] != reader->totals[e])
            return failure_set(error, MPM_ENVIRONMENT_FAILED,
                               "callgrind's file: functions have %" G_GUINT64_FORMAT
                               " of event %s, the total is %" G_GUINT64_FORMAT,
                               reader->sums[e], event_names[e], reader->totals[e]);
    return MPM_OK;
}

enum mpm_status callgrind_file_parse(const char *text, struct callgrind_counts *counts,
                                     struct mpm_error *error)
{
    struct reader reader = {
        .columns = {-1, -1},
        .functions = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
    };
    char **lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL; line++)
        read_line(&reader, *line);
    const enum mpm_status status = judge(&reader, error);
    *counts = (struct callgrind_counts){0};
    if (status == MPM_OK) {
        counts->instructions = reader.totals[INSTRUCTIONS];
        counts->branches = reader.own_branches;
        take_top(&reader, counts);
    }
    g_strfreev(lines);
    g_hash_table_unref(reader.functions);
    return status;
}
