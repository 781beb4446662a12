/* Which row of a comparison to use, from its numbers: the best in one column, what it costs, and
 * what is cheaper. Pure functions; all texts are freed with g_free.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_COMPARISON_GUIDE_H
#define VERIFICATION_MEASURES_COMPARISON_GUIDE_H

#include "verification/measures/comparison/comparison.h"

/* Of the rows that equal the best in the column `leading`, and of these the best in `cost` (may be
 * COMPARISON_NONE), the one that is behind the best of any column by the least factor;
 * COMPARISON_NONE without any. */
size_t comparison_choice(const struct comparison_table *table, size_t leading, size_t cost);

/* Two to four sentences: the choice, its number and its equals; what it costs over the least; the
 * cheapest and its number in `leading`; how many rows are beyond a limit. `cost` may be
 * COMPARISON_NONE. "" without any number. */
char *comparison_guide(const struct comparison_table *table, size_t leading, size_t cost);

/* The best row of a column, and up to four equal to it: "ugimp_usavg (0.00055 %); equal:
 * cpdi_usavg". Where more are equal no winner is named: "12 of 14 are equal (0.001 %)". "" if the
 * column has no number. */
char *comparison_advice(const struct comparison_table *table, size_t column);

/* The rows that no other dominates. */
char *comparison_front_names(const struct comparison_table *table);

/* "Largest energy drift at most 5 %; Time reached at least 6 ms"; "" without limits. */
char *comparison_limits(const struct comparison_table *table);

#endif
