/* Variants against each other: a table of numbers, one row per variant and one column per
 * quantity, becomes ranks, factors, a front and who dominates whom. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_COMPARISON_H
#define VERIFICATION_MEASURES_COMPARISON_H

#include <stdbool.h>
#include <stddef.h>

enum comparison_better {
    COMPARISON_LOW,  /* the smallest number is best */
    COMPARISON_HIGH, /* the largest */
    COMPARISON_ZERO, /* the smallest magnitude */
};

/* A number that there is not is worse than any (FAILED: the variant should have had one), or
 * says nothing (ABSENT: it was not measured). */
enum comparison_state { COMPARISON_ABSENT, COMPARISON_FAILED, COMPARISON_NUMBER };

struct comparison_cell {
    enum comparison_state state;
    double value;       /* finite where it is a NUMBER */
    const char *reason; /* why there is none; NULL or "" where it is a NUMBER */
};

struct comparison_column {
    const char *title, *unit;
    enum comparison_better better;
    double tolerance; /* relative: numbers within it are equal */
    double floor;     /* absolute: so are numbers that differ by no more (round-off) */
};

struct comparison_table {
    size_t row_count, column_count;
    const char *const *names; /* of rows */
    const struct comparison_column *columns;
    const struct comparison_cell *cells; /* [row * column_count + column] */
};

/* No row. */
#define COMPARISON_NONE ((size_t)-1)

const struct comparison_cell *comparison_cell(const struct comparison_table *table, size_t row,
                                              size_t column);

/* The number by which a column is sorted: less is better. */
double comparison_badness(const struct comparison_column *column, double value);

/* -1 if `a` is better than `b` by more than tolerance and floor, 1 if worse, 0 if equal or one
 * of the two is ABSENT. */
int comparison_order(const struct comparison_column *column, const struct comparison_cell *a,
                     const struct comparison_cell *b);

/* The row with the best number of a column, the first of those; COMPARISON_NONE without any. */
size_t comparison_best(const struct comparison_table *table, size_t column);

/* 1 + how many rows are better; 0 for ABSENT. The numbers and failures in a column. */
size_t comparison_rank(const struct comparison_table *table, size_t row, size_t column);
size_t comparison_count(const struct comparison_table *table, size_t column);

/* How many times worse than the best number: >= 1; infinite for FAILED and where the best is
 * zero; NaN for ABSENT and where a ratio says nothing (a sign differs). */
double comparison_factor(const struct comparison_table *table, size_t row, size_t column);

/* Whether `one` is nowhere worse than `other`, and better in *better > 0 of the columns where
 * both are more than ABSENT. */
bool comparison_dominates(const struct comparison_table *table, size_t one, size_t other,
                          size_t *better);

/* Whether the row has a number and no other row dominates it. */
bool comparison_on_front(const struct comparison_table *table, size_t row);

/* Of the rows that dominate this one, that which is better in most columns, those on the front
 * first; COMPARISON_NONE if there is none. */
size_t comparison_dominator(const struct comparison_table *table, size_t row);

/* The row whose largest rank is the least, of equal ones that with the smaller sum of ranks;
 * only rows that have a number in every column in which any row has one count.
 * COMPARISON_NONE if there is none. */
size_t comparison_all_round(const struct comparison_table *table, size_t *largest_rank);

#endif
