/* What a comparison says, in words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison_words.h"

#include <glib.h>
#include <math.h>
#include <string.h>

char *comparison_number(double value, const char *unit)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    const bool count = value == floor(value) && fabs(value) < 1e6;
    g_ascii_formatd(text, sizeof text, count ? "%.0f" : "%.3g", value);
    const bool bare = strcmp(unit, "1") == 0 || *unit == '\0';
    return g_strconcat(text, bare ? "" : " ", bare ? "" : unit, NULL);
}

char *comparison_times(const struct comparison_table *table, size_t row, size_t column)
{
    const double factor = comparison_factor(table, row, column);
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    if (!isfinite(factor))
        return g_strdup("");
    g_ascii_formatd(text, sizeof text,
                    factor < 99.5  ? "%.3g"
                    : factor < 1e6 ? "%.0f"
                                   : "%.1e",
                    factor);
    const bool high = table->columns[column].better == COMPARISON_HIGH;
    return g_strconcat(high ? "the best is " : "", text, " times ", high ? "it" : "the best", NULL);
}

static const struct comparison_cell *best_cell(const struct comparison_table *table, size_t column)
{
    const size_t best = comparison_best(table, column);
    return best == COMPARISON_NONE ? NULL : comparison_cell(table, best, column);
}

/* Whether the row has a number in the column that is worse than the best. */
static bool is_behind(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *own = comparison_cell(table, row, column);
    const struct comparison_cell *best = best_cell(table, column);
    return own->state == COMPARISON_NUMBER && best != NULL &&
           comparison_order(&table->columns[column], best, own) < 0;
}

static bool is_level(const struct comparison_table *table, size_t row, size_t column)
{
    return comparison_cell(table, row, column)->state == COMPARISON_NUMBER &&
           !is_behind(table, row, column);
}

/* Rank as a part of those that were ranked. */
static double place(const struct comparison_table *table, size_t row, size_t column)
{
    return (double)comparison_rank(table, row, column) / (double)comparison_count(table, column);
}

static size_t worst_column(const struct comparison_table *table, size_t row)
{
    size_t worst = COMPARISON_NONE;
    for (size_t column = 0; column < table->column_count; column++) {
        if (!is_behind(table, row, column))
            continue;
        const double own = place(table, row, column);
        const double so_far = worst == COMPARISON_NONE ? 0.0 : place(table, row, worst);
        if (own > so_far || (own >= so_far && comparison_factor(table, row, column) >
                                                  comparison_factor(table, row, worst)))
            worst = column;
    }
    return worst;
}

static void add_rank(GString *text, const struct comparison_table *table, size_t row, size_t column)
{
    char *times = comparison_times(table, row, column);
    g_string_append_printf(text, "rank %zu of %zu%s%s", comparison_rank(table, row, column),
                           comparison_count(table, column), *times == '\0' ? "" : ", ", times);
    g_free(times);
}

static void add_worst(GString *text, const struct comparison_table *table, size_t row,
                      size_t column)
{
    const struct comparison_column *rule = &table->columns[column];
    const size_t best = comparison_best(table, column);
    char *own = comparison_number(comparison_cell(table, row, column)->value, rule->unit);
    char *least = comparison_number(comparison_cell(table, best, column)->value, rule->unit);
    g_string_append_printf(text, "Loses most in %s: %s against %s of %s (", rule->title, own, least,
                           table->names[best]);
    add_rank(text, table, row, column);
    g_string_append(text, ").");
    g_free(own);
    g_free(least);
}

static void add_others(GString *text, const struct comparison_table *table, size_t row,
                       size_t worst)
{
    bool first = true;
    for (size_t column = 0; column < table->column_count; column++) {
        if (column == worst || !is_behind(table, row, column))
            continue;
        g_string_append_printf(text, "%s%s (", first ? " Behind also in " : ", ",
                               table->columns[column].title);
        add_rank(text, table, row, column);
        g_string_append_c(text, ')');
        first = false;
    }
    g_string_append(text, first ? "" : ".");
}

static void add_best(GString *text, const struct comparison_table *table, size_t row)
{
    bool first = true;
    for (size_t column = 0; column < table->column_count; column++) {
        if (!is_level(table, row, column))
            continue;
        g_string_append_printf(text, "%s%s", first ? " Best, or equal to the best, in " : ", ",
                               table->columns[column].title);
        first = false;
    }
    g_string_append(text, first ? "" : ".");
}

static const char *reason_of(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *cell = comparison_cell(table, row, column);
    if (cell->state != COMPARISON_FAILED)
        return NULL;
    return cell->reason == NULL ? "it failed" : cell->reason;
}

/* Columns that fail for one reason are named together. */
static void add_missing(GString *text, const struct comparison_table *table, size_t row)
{
    for (size_t column = 0; column < table->column_count; column++) {
        const char *reason = reason_of(table, row, column);
        bool said = reason == NULL;
        for (size_t before = 0; before < column && !said; before++)
            said = g_strcmp0(reason_of(table, row, before), reason) == 0;
        if (said)
            continue;
        g_string_append_printf(text, " No number for %s", table->columns[column].title);
        for (size_t after = column + 1; after < table->column_count; after++)
            if (g_strcmp0(reason_of(table, row, after), reason) == 0)
                g_string_append_printf(text, ", %s", table->columns[after].title);
        g_string_append_printf(text, ": %s.", reason);
    }
}

static void add_dominator(GString *text, const struct comparison_table *table, size_t row)
{
    const size_t other = comparison_dominator(table, row);
    size_t better = 0;
    if (other == COMPARISON_NONE) {
        if (comparison_on_front(table, row))
            g_string_append(text, " On the front: none is as good in every column.");
        return;
    }
    comparison_dominates(table, other, row, &better);
    g_string_append_printf(text, " Dominated by %s: nowhere worse, better in %zu of %zu columns.",
                           table->names[other], better, table->column_count);
}

char *comparison_sentence(const struct comparison_table *table, size_t row)
{
    GString *text = g_string_new(NULL);
    const size_t worst = worst_column(table, row);
    bool level = false;
    for (size_t column = 0; column < table->column_count; column++)
        level = level || is_level(table, row, column);
    if (worst != COMPARISON_NONE)
        add_worst(text, table, row, worst);
    else
        g_string_append(text, level ? "Behind in no column that it has a number for."
                                    : "It has no number.");
    add_others(text, table, row, worst);
    add_best(text, table, row);
    add_missing(text, table, row);
    add_dominator(text, table, row);
    return g_string_free(text, FALSE);
}

/* ----------------------------------------------------------------- summary */

enum { EQUALS_NAMED = 4 };

char *comparison_advice(const struct comparison_table *table, size_t column)
{
    const size_t best = comparison_best(table, column);
    if (best == COMPARISON_NONE)
        return g_strdup("");
    GString *text = g_string_new(table->names[best]);
    char *number =
        comparison_number(comparison_cell(table, best, column)->value, table->columns[column].unit);
    g_string_append_printf(text, " (%s)", number);
    g_free(number);
    size_t equal = 0;
    for (size_t row = 0; row < table->row_count; row++)
        if (row != best && is_level(table, row, column) && equal++ < EQUALS_NAMED)
            g_string_append_printf(text, "%s%s", equal == 1 ? "; equal: " : ", ",
                                   table->names[row]);
    if (equal > EQUALS_NAMED)
        g_string_append_printf(text, " and %zu more", equal - EQUALS_NAMED);
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

char *comparison_all_round_words(const struct comparison_table *table)
{
    size_t largest;
    const size_t row = comparison_all_round(table, &largest);
    if (row == COMPARISON_NONE || table->row_count < 2)
        return g_strdup("");
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "%s: its worst rank is %zu of %zu", table->names[row], largest,
                           table->row_count);
    bool first = true;
    for (size_t column = 0; largest > 1 && column < table->column_count; column++)
        if (comparison_rank(table, row, column) == largest) {
            g_string_append_printf(text, "%s%s", first ? ", in " : " and ",
                                   table->columns[column].title);
            first = false;
        }
    return g_string_free(text, FALSE);
}
