/* Variants against each other: ranks, factors, front.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/comparison.h"

#include <math.h>

const char *better_name(enum comparison_better better)
{
    static const char *const names[] = {"low", "high", "zero"};
    return names[better];
}

const struct comparison_cell *comparison_cell(const struct comparison_table *table, size_t row,
                                              size_t column)
{
    return &table->cells[row * table->column_count + column];
}

double comparison_badness(const struct comparison_column *column, double value)
{
    switch (column->better) {
    case COMPARISON_LOW:
        return value;
    case COMPARISON_HIGH:
        return -value;
    case COMPARISON_ZERO:
        break;
    }
    return fabs(value);
}

int comparison_order(const struct comparison_column *column, const struct comparison_cell *a,
                     const struct comparison_cell *b)
{
    if (a->state == COMPARISON_ABSENT || b->state == COMPARISON_ABSENT)
        return 0;
    if (a->state != b->state)
        return a->state == COMPARISON_NUMBER ? -1 : 1;
    if (a->state == COMPARISON_FAILED)
        return 0;
    const double one = comparison_badness(column, a->value);
    const double other = comparison_badness(column, b->value);
    /* relative to the smaller of the two, so that within 10 % means up to 1.1 times the best */
    const double scale = fmin(fabs(one), fabs(other));
    if (fabs(one - other) <= fmax(column->floor, column->tolerance * scale))
        return 0;
    return one < other ? -1 : 1;
}

bool comparison_is_beyond(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_column *rule = &table->columns[column];
    const struct comparison_cell *cell = comparison_cell(table, row, column);
    if (!rule->limited || cell->state == COMPARISON_ABSENT)
        return false;
    return cell->state == COMPARISON_FAILED ||
           comparison_badness(rule, cell->value) > comparison_badness(rule, rule->limit);
}

bool comparison_takes_part(const struct comparison_table *table, size_t row)
{
    bool number = false;
    for (size_t column = 0; column < table->column_count; column++) {
        if (comparison_is_beyond(table, row, column))
            return false;
        number = number || comparison_cell(table, row, column)->state == COMPARISON_NUMBER;
    }
    return number;
}

/* The row's cell if it takes part with a number, else NULL. */
static const struct comparison_cell *ranked(const struct comparison_table *table, size_t row,
                                            size_t column)
{
    const struct comparison_cell *cell = comparison_cell(table, row, column);
    return cell->state == COMPARISON_NUMBER && comparison_takes_part(table, row) ? cell : NULL;
}

size_t comparison_best(const struct comparison_table *table, size_t column)
{
    const struct comparison_column *rule = &table->columns[column];
    size_t best = COMPARISON_NONE;
    for (size_t row = 0; row < table->row_count; row++) {
        const struct comparison_cell *cell = ranked(table, row, column);
        if (cell != NULL &&
            (best == COMPARISON_NONE ||
             comparison_badness(rule, cell->value) <
                 comparison_badness(rule, comparison_cell(table, best, column)->value)))
            best = row;
    }
    return best;
}

bool comparison_is_level(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *own = ranked(table, row, column);
    return own != NULL &&
           comparison_order(&table->columns[column],
                            comparison_cell(table, comparison_best(table, column), column),
                            own) == 0;
}

size_t comparison_level_count(const struct comparison_table *table, size_t column)
{
    size_t count = 0;
    for (size_t row = 0; row < table->row_count; row++)
        count += comparison_is_level(table, row, column);
    return count;
}

/* How many rows with a number are better than this one (sign -1), or worse (1). */
static size_t count_beside(const struct comparison_table *table, size_t row, size_t column,
                           int sign)
{
    const struct comparison_cell *own = comparison_cell(table, row, column);
    size_t count = 0;
    for (size_t other = 0; other < table->row_count; other++) {
        const struct comparison_cell *cell = ranked(table, other, column);
        count += cell != NULL && comparison_order(&table->columns[column], cell, own) == sign;
    }
    return count;
}

size_t comparison_rank(const struct comparison_table *table, size_t row, size_t column)
{
    return ranked(table, row, column) == NULL ? 0 : 1 + count_beside(table, row, column, -1);
}

size_t comparison_count(const struct comparison_table *table, size_t column)
{
    size_t count = 0;
    for (size_t row = 0; row < table->row_count; row++)
        count += ranked(table, row, column) != NULL;
    return count;
}

bool comparison_is_last(const struct comparison_table *table, size_t row, size_t column)
{
    return comparison_rank(table, row, column) > 1 && count_beside(table, row, column, 1) == 0;
}

bool comparison_is_constant(const struct comparison_table *table, size_t column)
{
    const size_t best = comparison_best(table, column);
    if (comparison_count(table, column) < 2)
        return false;
    const double value = comparison_cell(table, best, column)->value;
    for (size_t row = 0; row < table->row_count; row++) {
        const struct comparison_cell *cell = comparison_cell(table, row, column);
        const bool same =
            cell->state == COMPARISON_NUMBER && !(cell->value < value) && !(cell->value > value);
        if (!same && !comparison_is_beyond(table, row, column))
            return false;
    }
    return true;
}

/* Over the best where less is better, the best over it where more is. */
static double factor_of(const struct comparison_column *column, double best, double value)
{
    const bool high = column->better == COMPARISON_HIGH;
    const bool zero = column->better == COMPARISON_ZERO;
    const double larger = high ? best : zero ? fabs(value) : value;
    const double least = high ? value : zero ? fabs(best) : best;
    const double smaller = column->floor > 0.0 ? fmax(least, column->floor) : least;
    if (larger <= smaller)
        return 1.0;
    if (smaller < 0.0)
        return (double)NAN;
    return smaller > 0.0 ? larger / smaller : HUGE_VAL;
}

double comparison_factor(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *own = comparison_cell(table, row, column);
    const size_t best = comparison_best(table, column);
    if (own->state == COMPARISON_ABSENT || best == COMPARISON_NONE)
        return (double)NAN;
    if (own->state == COMPARISON_FAILED)
        return HUGE_VAL;
    return factor_of(&table->columns[column], comparison_cell(table, best, column)->value,
                     own->value);
}

bool comparison_dominates(const struct comparison_table *table, size_t one, size_t other,
                          size_t *better)
{
    *better = 0;
    if (!comparison_takes_part(table, one))
        return false;
    for (size_t column = 0; column < table->column_count; column++) {
        const struct comparison_cell *own = comparison_cell(table, one, column);
        const struct comparison_cell *theirs = comparison_cell(table, other, column);
        const bool unknown = own->state == COMPARISON_ABSENT && theirs->state != COMPARISON_ABSENT;
        const int order = comparison_order(&table->columns[column], own, theirs);
        if (unknown || order > 0)
            return false;
        *better += order < 0;
    }
    return *better > 0;
}

bool comparison_on_front(const struct comparison_table *table, size_t row)
{
    size_t better;
    if (!comparison_takes_part(table, row))
        return false;
    for (size_t other = 0; other < table->row_count; other++)
        if (comparison_dominates(table, other, row, &better))
            return false;
    return true;
}

size_t comparison_dominator(const struct comparison_table *table, size_t row)
{
    size_t found = COMPARISON_NONE, most = 0;
    bool found_front = false;
    if (!comparison_takes_part(table, row))
        return found;
    for (size_t other = 0; other < table->row_count; other++) {
        size_t better;
        if (!comparison_dominates(table, other, row, &better))
            continue;
        const bool front = comparison_on_front(table, other);
        if (found == COMPARISON_NONE || (front && !found_front) ||
            (front == found_front && better > most)) {
            found = other;
            most = better;
            found_front = front;
        }
    }
    return found;
}

size_t comparison_worst(const struct comparison_table *table, size_t row)
{
    size_t worst = COMPARISON_NONE;
    double most = 0.0;
    for (size_t column = 0; column < table->column_count; column++) {
        if (comparison_rank(table, row, column) < 2)
            continue;
        const double factor = comparison_factor(table, row, column);
        if (worst == COMPARISON_NONE || factor > most) {
            worst = column;
            most = isnan(factor) ? 0.0 : factor;
        }
    }
    return worst;
}
