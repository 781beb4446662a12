/* A comparison in words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/comparison_words.h"

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

char *comparison_factor_words(const struct comparison_table *table, size_t row, size_t column)
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
    return g_strdup(text);
}

char *comparison_times(const struct comparison_table *table, size_t row, size_t column)
{
    const bool high = table->columns[column].better == COMPARISON_HIGH;
    char *factor = comparison_factor_words(table, row, column);
    char *text = *factor == '\0' ? g_strdup("")
                                 : g_strconcat(high ? "the best is " : "", factor, " times ",
                                               high ? "it" : "the best", NULL);
    g_free(factor);
    return text;
}

char *comparison_rank_words(const struct comparison_table *table, size_t row, size_t column)
{
    const size_t rank = comparison_rank(table, row, column),
                 count = comparison_count(table, column);
    if (rank == 0)
        return g_strdup("");
    return comparison_is_last(table, row, column) ? g_strdup_printf("last of %zu", count)
                                                  : g_strdup_printf("rank %zu of %zu", rank, count);
}

/* "last of 9, 27 times the best" */
static char *standing(const struct comparison_table *table, size_t row, size_t column)
{
    char *rank = comparison_rank_words(table, row, column);
    char *times = comparison_times(table, row, column);
    char *text = g_strconcat(rank, *times == '\0' ? "" : ", ", times, NULL);
    g_free(times);
    g_free(rank);
    return text;
}

static char *own_number(const struct comparison_table *table, size_t row, size_t column)
{
    return comparison_number(comparison_cell(table, row, column)->value,
                             table->columns[column].unit);
}

/* --------------------------------------------------------------- how it went */

static bool has_words(const char *text)
{
    return text != NULL && *text != '\0';
}

/* "broke at 43.3 %", or what the column's missing number means; NULL without words. */
static char *end_words(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_column *rule = &table->columns[column];
    const bool failed = comparison_cell(table, row, column)->state == COMPARISON_FAILED;
    if (failed)
        return has_words(rule->missing) ? g_strdup(rule->missing) : NULL;
    if (!has_words(rule->beyond))
        return NULL;
    char *number = own_number(table, row, column);
    char *text = g_strconcat(rule->beyond, " ", number, NULL);
    g_free(number);
    return text;
}

char *comparison_run_words(const struct comparison_table *table, size_t row)
{
    GString *titles = g_string_new(NULL);
    char *words = NULL;
    for (size_t column = 0; words == NULL && column < table->column_count; column++) {
        if (!comparison_is_beyond(table, row, column))
            continue;
        words = end_words(table, row, column);
        g_string_append_printf(titles, "%s%s", titles->len == 0 ? "beyond the limit in " : ", ",
                               table->columns[column].title);
    }
    if (words == NULL)
        words = g_strdup(titles->len > 0                     ? titles->str
                         : comparison_takes_part(table, row) ? "valid"
                                                             : "no number");
    g_string_free(titles, TRUE);
    return words;
}

/* ----------------------------------------------------------------- sentences */

/* Whether the row takes part with a number that is worse than the best. */
static bool is_behind(const struct comparison_table *table, size_t row, size_t column)
{
    return comparison_rank(table, row, column) > 1;
}

static void add_worst(GString *text, const struct comparison_table *table, size_t row,
                      size_t column)
{
    const struct comparison_column *rule = &table->columns[column];
    char *own = own_number(table, row, column);
    char *least = own_number(table, comparison_best(table, column), column);
    char *rank = standing(table, row, column);
    g_string_append_printf(text, "Loses most in %s: %s against %s (%s).", rule->title, own, least,
                           rank);
    g_free(rank);
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
        char *rank = standing(table, row, column);
        g_string_append_printf(text, "%s%s (%s)", first ? " Behind also in " : ", ",
                               table->columns[column].title, rank);
        g_free(rank);
        first = false;
    }
    g_string_append(text, first ? "" : ".");
}

static void add_best(GString *text, const struct comparison_table *table, size_t row)
{
    bool first = true;
    for (size_t column = 0; column < table->column_count; column++) {
        if (!comparison_is_level(table, row, column))
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
    g_string_append_printf(text,
                           " Dominated by %s: nowhere worse where both are measured, better in %zu "
                           "of %zu columns.",
                           table->names[other], better, table->column_count);
}

/* How a run beyond a limit went, and the numbers it has. */
static void add_outside(GString *text, const struct comparison_table *table, size_t row)
{
    char *words = comparison_run_words(table, row);
    g_string_append_printf(text, "Takes no part: %s.", words);
    bool first = true;
    for (size_t column = 0; column < table->column_count; column++) {
        if (comparison_cell(table, row, column)->state != COMPARISON_NUMBER)
            continue;
        char *own = own_number(table, row, column);
        g_string_append_printf(text, "%s%s %s", first ? " " : ", ", table->columns[column].title,
                               own);
        g_free(own);
        first = false;
    }
    g_string_append(text, first ? "" : ".");
    g_free(words);
}

char *comparison_sentence(const struct comparison_table *table, size_t row)
{
    GString *text = g_string_new(NULL);
    const size_t worst = comparison_worst(table, row);
    if (!comparison_takes_part(table, row)) {
        add_outside(text, table, row);
    } else {
        if (worst != COMPARISON_NONE)
            add_worst(text, table, row, worst);
        else
            g_string_append(text, "Behind in no column that it has a number for.");
        add_others(text, table, row, worst);
        add_best(text, table, row);
    }
    add_missing(text, table, row);
    add_dominator(text, table, row);
    return g_string_free(text, FALSE);
}

/* -------------------------------------------------------------------- groups */

/* The words on each row (NULL: none; taken over), the names of those alike before it. */
static char *grouped(const struct comparison_table *table, char **clauses)
{
    GString *text = g_string_new(NULL);
    for (size_t row = 0; row < table->row_count; row++) {
        if (clauses[row] == NULL)
            continue;
        g_string_append_printf(text, "%s%s", text->len == 0 ? "" : "; ", table->names[row]);
        for (size_t other = row + 1; other < table->row_count; other++)
            if (g_strcmp0(clauses[other], clauses[row]) == 0) {
                g_string_append_printf(text, ", %s", table->names[other]);
                g_clear_pointer(&clauses[other], g_free);
            }
        g_string_append_printf(text, "%s%s", *clauses[row] == '\0' ? "" : ": ", clauses[row]);
        g_clear_pointer(&clauses[row], g_free);
    }
    g_free(clauses);
    return g_string_free(text, FALSE);
}

char *comparison_losses(const struct comparison_table *table, size_t column)
{
    char **clauses = g_new0(char *, table->row_count + 1);
    for (size_t row = 0; row < table->row_count; row++) {
        if (!comparison_takes_part(table, row) || comparison_worst(table, row) != column)
            continue;
        if (column == COMPARISON_NONE) {
            clauses[row] = g_strdup("");
            continue;
        }
        char *own = own_number(table, row, column), *rank = standing(table, row, column);
        clauses[row] = g_strdup_printf("%s (%s)", own, rank);
        g_free(rank);
        g_free(own);
    }
    return grouped(table, clauses);
}

char *comparison_outside(const struct comparison_table *table)
{
    char **clauses = g_new0(char *, table->row_count + 1);
    for (size_t row = 0; row < table->row_count; row++)
        if (!comparison_takes_part(table, row))
            clauses[row] = comparison_run_words(table, row);
    return grouped(table, clauses);
}
