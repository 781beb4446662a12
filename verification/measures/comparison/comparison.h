/* Variants against each other: a table of numbers, one row per variant and one column per
 * quantity, becomes ranks, factors, a front and who dominates whom. A row with a number beyond
 * the limit of a column takes no part in any of it. Pure functions.
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

/* The word of case.yaml and of records. */
const char *better_name(enum comparison_better better);

/* A number that there is not is worse than any (FAILED: the variant should have had one), or
 * is meaningless (ABSENT: it was not measured). */
enum comparison_state { COMPARISON_ABSENT, COMPARISON_FAILED, COMPARISON_NUMBER };

struct comparison_cell {
    enum comparison_state state;
    double value;       /* finite where it is a NUMBER */
    const char *reason; /* why there is none; NULL or "" where it is a NUMBER */
};

struct comparison_column {
    const char *title, *unit;
    enum comparison_better better;
    double tolerance;    /* relative: numbers within it are equal */
    double floor;        /* absolute: so are numbers that differ by no more (round-off) */
    bool limited;        /* whether there is a limit */
    double limit;        /* a row with a worse number, or with none, takes no part */
    const char *beyond;  /* what a number beyond it means ("blew up at"); NULL or "" */
    const char *missing; /* what a number that FAILED means ("not reached"); NULL or "" */
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

/* Whether the row's number in a limited column is worse than the limit, or FAILED. */
bool comparison_is_beyond(const struct comparison_table *table, size_t row, size_t column);

/* Whether the row has a number and is beyond no limit. All that follows is among such rows. */
bool comparison_takes_part(const struct comparison_table *table, size_t row);

/* The row with the best number of a column, the first of those; COMPARISON_NONE without any. */
size_t comparison_best(const struct comparison_table *table, size_t column);

/* Whether the row's number equals the best; how many rows' do. */
bool comparison_is_level(const struct comparison_table *table, size_t row, size_t column);
size_t comparison_level_count(const struct comparison_table *table, size_t column);

/* 1 + how many rows are better; 0 for a row that takes no part or has no number. The numbers
 * in a column. Whether the row is behind the best, and no row behind it. */
size_t comparison_rank(const struct comparison_table *table, size_t row, size_t column);
size_t comparison_count(const struct comparison_table *table, size_t column);
bool comparison_is_last(const struct comparison_table *table, size_t row, size_t column);

/* Whether the column has no information: all numbers, two at least, are the same, to the last
 * digit, and no row has another or none, but for those that the column's own limit takes out. */
bool comparison_is_constant(const struct comparison_table *table, size_t column);

/* How many times worse than the best number, or than the column's floor if that is larger:
 * >= 1; infinite for FAILED and where both are zero; NaN for ABSENT and where a ratio says
 * nothing (a sign differs). Rows that take no part have one, too. */
double comparison_factor(const struct comparison_table *table, size_t row, size_t column);

/* Whether `one` is nowhere worse than `other`, has been measured wherever `other` was, and is
 * better in *better > 0 of the columns. */
bool comparison_dominates(const struct comparison_table *table, size_t one, size_t other,
                          size_t *better);

/* Whether the row takes part and no other one dominates it. */
bool comparison_on_front(const struct comparison_table *table, size_t row);

/* Of the rows that dominate this one, that which is better in most columns, those on the front
 * first; COMPARISON_NONE if there is none. */
size_t comparison_dominator(const struct comparison_table *table, size_t row);

/* The column in which the row, among those that take part, is behind by the largest factor;
 * COMPARISON_NONE if it is behind in none. */
size_t comparison_worst(const struct comparison_table *table, size_t row);

#endif
