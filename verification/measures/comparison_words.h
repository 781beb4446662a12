/* What a comparison says, in words computed from its numbers. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_COMPARISON_WORDS_H
#define VERIFICATION_MEASURES_COMPARISON_WORDS_H

#include "verification/measures/comparison.h"

/* A number with three digits and its unit; "" for the unit "1". g_free. */
char *comparison_number(double value, const char *unit);

/* "3.2 times the best", or where more is better "the best is 3.2 times it"; "" where a factor
 * says nothing. g_free. */
char *comparison_times(const struct comparison_table *table, size_t row, size_t column);

/* Where the row loses: the column with the worst rank (of equal ones the largest factor) with
 * its number, the best one and whose it is; the other columns where it is behind; what it is
 * best in; what it has no number for and why; and whether another row dominates it. g_free. */
char *comparison_sentence(const struct comparison_table *table, size_t row);

/* The best row of a column, and up to four equal to it: "ugimp_usavg (0.00055 %); equal:
 * cpdi_usavg".
 * "" if the column has no number. g_free. */
char *comparison_advice(const struct comparison_table *table, size_t column);

/* The rows that no other dominates. g_free. */
char *comparison_front_names(const struct comparison_table *table);

/* The row with the least largest rank, as a sentence; "" if none has all numbers. g_free. */
char *comparison_all_round_words(const struct comparison_table *table);

#endif
