/* A comparison in words computed from its numbers. Pure functions; all texts are
 * freed with g_free.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_COMPARISON_WORDS_H
#define VERIFICATION_MEASURES_COMPARISON_WORDS_H

#include "verification/measures/comparison/comparison.h"

/* A number with three digits and its unit; "" for the unit "1". */
char *comparison_number(double value, const char *unit);

/* "3.2", "540", "1.2e+06"; "" where a factor is meaningless. */
char *comparison_factor_words(const struct comparison_table *table, size_t row, size_t column);

/* "3.2 times the best", or where more is better "the best is 3.2 times it"; "" where a factor
 * says nothing. */
char *comparison_times(const struct comparison_table *table, size_t row, size_t column);

/* "rank 3 of 14", "last of 14"; "" for a row without a rank. */
char *comparison_rank_words(const struct comparison_table *table, size_t row, size_t column);

/* How the run went: "valid", or what the first column with words of its own has for a number beyond
 * its limit ("broke at 43.3 %"), or "beyond the limit in X, Y"; "no number" if it has none. */
char *comparison_run_words(const struct comparison_table *table, size_t row);

/* Every column: where the row loses most, with its number, the best one, rank and factor; the other
 * columns where it is behind; what it is best in; what it has no number for and why; and whether
 * another row dominates it. Of a row that takes no part how its run went, and its numbers. */
char *comparison_sentence(const struct comparison_table *table, size_t row);

/* The rows that lose most in this column, a clause each, those of which the same is to be said
 * together: "a, b: 4.09 % (last of 9, 27 times the best); c: ...". Without a column
 * (COMPARISON_NONE) the names of those that are behind in none. "" if there is none. */
char *comparison_losses(const struct comparison_table *table, size_t column);

/* The rows that take no part, with how their runs went, those alike together; "" if there is
 * none. */
char *comparison_outside(const struct comparison_table *table);

#endif
