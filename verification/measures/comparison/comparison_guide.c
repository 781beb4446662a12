/* Which row of a comparison to use: the best in one column, what it costs, what is cheaper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/comparison_guide.h"

#include "verification/measures/comparison/comparison_words.h"

#include <glib.h>
#include <math.h>

enum { EQUALS_NAMED = 4 };

/* The number of a row that takes part, or NULL. */
static const struct comparison_cell *number_in(const struct comparison_table *table, size_t row,
                                               size_t column)
{
    const bool ranked = column != COMPARISON_NONE && comparison_rank(table, row, column) > 0;
    return ranked ? comparison_cell(table, row, column) : NULL;
}

/* Of the rows that equal the best of `first` the best number in `second`; NULL if none has one. */
static const struct comparison_cell *best_in(const struct comparison_table *table, size_t first,
                                             size_t second)
{
    const struct comparison_cell *best = NULL;
    for (size_t row = 0; row < table->row_count; row++) {
        const struct comparison_cell *own = number_in(table, row, second);
        if (own != NULL && comparison_is_level(table, row, first) &&
            (best == NULL || comparison_badness(&table->columns[second], own->value) <
                                 comparison_badness(&table->columns[second], best->value)))
            best = own;
    }
    return best;
}

/* How many times worse than the best the row is where it is that most. */
static double most_behind(const struct comparison_table *table, size_t row)
{
    const size_t worst = comparison_worst(table, row);
    const double factor = worst == COMPARISON_NONE ? 1.0 : comparison_factor(table, row, worst);
    return isnan(factor) ? HUGE_VAL : factor;
}

/* Noise within the tolerances decides nothing. */
size_t comparison_choice(const struct comparison_table *table, size_t leading, size_t cost)
{
    const struct comparison_cell *best = best_in(table, leading, cost);
    size_t found = COMPARISON_NONE;
    for (size_t row = 0; row < table->row_count; row++) {
        const struct comparison_cell *own = number_in(table, row, cost);
        const bool equal = best == NULL ||
                           (own != NULL && comparison_order(&table->columns[cost], best, own) == 0);
        if (equal && comparison_is_level(table, row, leading) &&
            (found == COMPARISON_NONE || most_behind(table, row) < most_behind(table, found)))
            found = row;
    }
    return found;
}

static char *number_of(const struct comparison_table *table, size_t row, size_t column)
{
    return comparison_number(comparison_cell(table, row, column)->value,
                             table->columns[column].unit);
}

/* Up to four rows that equal the best, but for one; nothing but their number where there are
 * more. */
static void add_equals(GString *text, const struct comparison_table *table, size_t but,
                       size_t column, const char *before)
{
    const size_t count = comparison_level_count(table, column);
    if (count < 2)
        return;
    g_string_append(text, before);
    if (count - 1 > EQUALS_NAMED) {
        g_string_append_printf(text, "%zu others", count - 1);
        return;
    }
    bool first = true;
    for (size_t row = 0; row < table->row_count; row++)
        if (row != but && comparison_is_level(table, row, column)) {
            g_string_append_printf(text, "%s%s", first ? "" : ", ", table->names[row]);
            first = false;
        }
}

/* -------------------------------------------------------------------- guide */

static void add_choice(GString *text, const struct comparison_table *table, size_t choice,
                       size_t leading, size_t cost)
{
    const size_t ranked = comparison_count(table, leading);
    char *number = number_of(table, choice, leading);
    char *count = ranked == 1 ? g_strdup("1 run that counts")
                              : g_strdup_printf("%zu runs that count", ranked);
    g_string_append_printf(text, "Use %s. %s: %s, the best of the %s", table->names[choice],
                           table->columns[leading].title, number, count);
    const bool priced = number_in(table, choice, cost) != NULL;
    add_equals(text, table, choice, leading, "; equal: ");
    if (comparison_level_count(table, leading) > 1)
        g_string_append_printf(text, ". Of these, %s %sloses least in the other columns",
                               table->names[choice], priced ? "is among the cheapest and " : "");
    g_string_append_c(text, '.');
    g_free(count);
    g_free(number);
}

static void add_cost(GString *text, const struct comparison_table *table, size_t choice,
                     size_t leading, size_t cost)
{
    const char *title = table->columns[cost].title;
    if (comparison_rank(table, choice, cost) == 0) {
        g_string_append_printf(text, " It has no number for %s.", title);
    } else {
        char *number = number_of(table, choice, cost);
        char *times = comparison_times(table, choice, cost);
        g_string_append_printf(text, " %s: %s, %s.", title, number,
                               comparison_is_level(table, choice, cost) ? "equal to the least"
                                                                        : times);
        g_free(times);
        g_free(number);
    }
    const size_t cheap = comparison_choice(table, cost, leading);
    if (cheap == COMPARISON_NONE || comparison_is_level(table, choice, cost))
        return;
    char *price = number_of(table, cheap, cost);
    const bool known = comparison_rank(table, cheap, leading) > 0;
    char *number = known ? number_of(table, cheap, leading) : g_strdup("no number");
    g_string_append_printf(text, " Cheaper: %s, %s (%s: %s).", table->names[cheap], price,
                           table->columns[leading].title, number);
    g_free(number);
    g_free(price);
}

/* Where no cost decides: the best of those that do not equal the best. */
static void add_next(GString *text, const struct comparison_table *table, size_t leading)
{
    const size_t rank = comparison_level_count(table, leading) + 1;
    for (size_t row = 0; row < table->row_count; row++) {
        if (comparison_rank(table, row, leading) != rank)
            continue;
        char *number = number_of(table, row, leading);
        g_string_append_printf(text, " Next: %s (%s).", table->names[row], number);
        g_free(number);
        return;
    }
}

static void add_outside(GString *text, const struct comparison_table *table)
{
    size_t outside = 0;
    for (size_t row = 0; row < table->row_count; row++)
        outside += !comparison_takes_part(table, row);
    if (outside > 0)
        g_string_append_printf(text, " %zu of %zu runs %s not count: broken, or beyond a limit.",
                               outside, table->row_count, outside == 1 ? "does" : "do");
}

char *comparison_guide(const struct comparison_table *table, size_t leading, size_t cost)
{
    const size_t choice = comparison_choice(table, leading, cost);
    if (choice == COMPARISON_NONE)
        return g_strdup("");
    GString *text = g_string_new(NULL);
    add_choice(text, table, choice, leading, cost);
    if (cost != COMPARISON_NONE && comparison_count(table, cost) > 0)
        add_cost(text, table, choice, leading, cost);
    else
        add_next(text, table, leading);
    add_outside(text, table);
    return g_string_free(text, FALSE);
}

/* ------------------------------------------------------------------ columns */

char *comparison_advice(const struct comparison_table *table, size_t column)
{
    const size_t best = comparison_best(table, column);
    if (best == COMPARISON_NONE)
        return g_strdup("");
    char *number = number_of(table, best, column);
    const size_t level = comparison_level_count(table, column);
    GString *text = g_string_new(NULL);
    const size_t count = comparison_count(table, column);
    if (level == count && count > 1) {
        g_string_append_printf(text, "all %zu are equal (%s)", count, number);
    } else if (level > EQUALS_NAMED + 1) {
        g_string_append_printf(text, "%zu of %zu are equal (%s)", level, count, number);
    } else {
        g_string_append_printf(text, "%s (%s)", table->names[best], number);
        add_equals(text, table, best, column, "; equal: ");
    }
    g_free(number);
    return g_string_free(text, FALSE);
}

char *comparison_front_names(const struct comparison_table *table)
{
    GString *text = g_string_new(NULL);
    for (size_t row = 0; row < table->row_count; row++)
        if (comparison_on_front(table, row))
            g_string_append_printf(text, "%s%s", text->len == 0 ? "" : ", ", table->names[row]);
    return g_string_free(text, FALSE);
}

char *comparison_limits(const struct comparison_table *table)
{
    static const char *const words[] = {"at most", "at least", "at most"};
    GString *text = g_string_new(NULL);
    for (size_t column = 0; column < table->column_count; column++) {
        const struct comparison_column *rule = &table->columns[column];
        if (!rule->limited)
            continue;
        char *limit = comparison_number(rule->limit, rule->unit);
        const bool zero = rule->better == COMPARISON_ZERO;
        g_string_append_printf(text, "%s%s %s %s%s", text->len == 0 ? "" : "; ", rule->title,
                               words[rule->better], zero ? "±" : "", limit);
        g_free(limit);
    }
    return g_string_free(text, FALSE);
}
