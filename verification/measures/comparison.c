/* Variants against each other: ranks, factors, front.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison.h"

#include <math.h>

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

size_t comparison_best(const struct comparison_table *table, size_t column)
{
    size_t best = COMPARISON_NONE;
    for (size_t row = 0; row < table->row_count; row++) {
        const struct comparison_cell *cell = comparison_cell(table, row, column);
        if (cell->state != COMPARISON_NUMBER)
            continue;
        const double bad = comparison_badness(&table->columns[column], cell->value);
        if (best == COMPARISON_NONE ||
            bad < comparison_badness(&table->columns[column],
                                     comparison_cell(table, best, column)->value))
            best = row;
    }
    return best;
}

size_t comparison_rank(const struct comparison_table *table, size_t row, size_t column)
{
    const struct comparison_cell *own = comparison_cell(table, row, column);
    size_t rank = 1;
    if (own->state == COMPARISON_ABSENT)
        return 0;
    for (size_t other = 0; other < table->row_count; other++)
        rank += comparison_order(&table->columns[column], comparison_cell(table, other, column),
                                 own) < 0;
    return rank;
}

size_t comparison_count(const struct comparison_table *table, size_t column)
{
    size_t count = 0;
    for (size_t row = 0; row < table->row_count; row++)
        count += comparison_cell(table, row, column)->state != COMPARISON_ABSENT;
    return count;
}

/* Over the best where less is better, the best over it where more is. */
static double factor_of(const struct comparison_column *column, double best, double value)
{
    const bool high = column->better == COMPARISON_HIGH;
    const bool zero = column->better == COMPARISON_ZERO;
    const double larger = high ? best : zero ? fabs(value) : value;
    const double smaller = high ? value : zero ? fabs(best) : best;
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
    for (size_t column = 0; column < table->column_count; column++) {
        const int order =
            comparison_order(&table->columns[column], comparison_cell(table, one, column),
                             comparison_cell(table, other, column));
        if (order > 0)
            return false;
        *better += order < 0;
    }
    return *better > 0;
}

static bool has_number(const struct comparison_table *table, size_t row)
{
    for (size_t column = 0; column < table->column_count; column++)
        if (comparison_cell(table, row, column)->state == COMPARISON_NUMBER)
            return true;
    return false;
}

bool comparison_on_front(const struct comparison_table *table, size_t row)
{
    size_t better;
    for (size_t other = 0; other < table->row_count; other++)
        if (comparison_dominates(table, other, row, &better))
            return false;
    return has_number(table, row);
}

size_t comparison_dominator(const struct comparison_table *table, size_t row)
{
    size_t found = COMPARISON_NONE, most = 0;
    bool found_front = false;
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

/* Largest rank and sum of ranks; false if a number is missing that others have. */
static bool add_ranks(const struct comparison_table *table, size_t row, size_t *largest,
                      size_t *sum)
{
    *largest = *sum = 0;
    for (size_t column = 0; column < table->column_count; column++) {
        if (comparison_best(table, column) == COMPARISON_NONE)
            continue;
        if (comparison_cell(table, row, column)->state != COMPARISON_NUMBER)
            return false;
        const size_t rank = comparison_rank(table, row, column);
        *largest = rank > *largest ? rank : *largest;
        *sum += rank;
    }
    return *largest > 0;
}

size_t comparison_all_round(const struct comparison_table *table, size_t *largest_rank)
{
    size_t found = COMPARISON_NONE, least_sum = 0;
    *largest_rank = 0;
    for (size_t row = 0; row < table->row_count; row++) {
        size_t largest, sum;
        if (!add_ranks(table, row, &largest, &sum))
            continue;
        if (found == COMPARISON_NONE || largest < *largest_rank ||
            (largest == *largest_rank && sum < least_sum)) {
            found = row;
            *largest_rank = largest;
            least_sum = sum;
        }
    }
    return found;
}
