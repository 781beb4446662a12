/* Methods compared: ranks, front and sentences from tables made by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/measures/comparison.h"
#include "verification/measures/comparison_words.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { ROWS = 5, COLUMNS = 3 };

#define N(number)                                                                                  \
    {                                                                                              \
        COMPARISON_NUMBER, number, ""                                                              \
    }
#define FAILED                                                                                     \
    {                                                                                              \
        COMPARISON_FAILED, 0, "it blew up"                                                         \
    }
#define ABSENT                                                                                     \
    {                                                                                              \
        COMPARISON_ABSENT, 0, "not run"                                                            \
    }

static const char *const NAMES[ROWS] = {"alpha", "beta", "gamma", "delta", "omega"};
static const struct comparison_column RULES[COLUMNS] = {
    {"Error", "%", COMPARISON_LOW, 0.1, 0},
    {"Reach", "m", COMPARISON_HIGH, 0.01, 0},
    {"Drift", "1", COMPARISON_ZERO, 0, 1e-3},
};
/* alpha leads in error, beta in reach (and drifts by as little as alpha: the floor), gamma is
 * behind alpha everywhere, delta fails in one, omega was hardly measured */
static const struct comparison_cell CELLS[ROWS * COLUMNS] = {
    N(1.0),  N(50), N(-0.0004), /* */
    N(2.0),  N(90), N(0.0002),  /* */
    N(1.05), N(40), N(0.5),     /* */
    FAILED,  N(90), N(0.1),     /* */
    ABSENT,  N(10), ABSENT,
};
static const struct comparison_table TABLE = {ROWS, COLUMNS, NAMES, RULES, CELLS};

START_TEST(ranks_count_what_is_better_beyond_the_tolerance)
{
    static const size_t ranks[ROWS][COLUMNS] = {
        {1, 3, 1}, {3, 1, 1}, {1, 4, 4}, {4, 1, 3}, {0, 5, 0}};
    static const size_t counts[COLUMNS] = {4, 5, 4}, best[COLUMNS] = {0, 1, 1};
    for (size_t column = 0; column < COLUMNS; column++) {
        ck_assert_uint_eq(comparison_count(&TABLE, column), counts[column]);
        ck_assert_uint_eq(comparison_best(&TABLE, column), best[column]);
        for (size_t row = 0; row < ROWS; row++)
            ck_assert_msg(comparison_rank(&TABLE, row, column) == ranks[row][column],
                          "%s, %s: rank %zu", NAMES[row], RULES[column].title,
                          comparison_rank(&TABLE, row, column));
    }
}
END_TEST

START_TEST(factors_are_ratios_to_the_best_and_at_least_one)
{
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 0), 1);
    ck_assert_double_eq(comparison_factor(&TABLE, 1, 0), 2);
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 1), 1.8);
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 2), 2);
    ck_assert(isinf(comparison_factor(&TABLE, 3, 0)));
    ck_assert(isnan(comparison_factor(&TABLE, 4, 0)));
}
END_TEST

START_TEST(a_factor_to_zero_is_infinite_and_one_across_zero_is_none)
{
    static const struct comparison_column rules[] = {{"a", "1", COMPARISON_LOW, 0, 0},
                                                     {"b", "1", COMPARISON_HIGH, 0, 0}};
    static const struct comparison_cell cells[] = {N(0), N(3), N(2), N(-1), N(-4), N(0)};
    static const struct comparison_table zero = {2, 2, NAMES, rules, cells};
    static const struct comparison_table all = {3, 2, NAMES, rules, cells};
    ck_assert(isinf(comparison_factor(&zero, 1, 0)));
    ck_assert(isnan(comparison_factor(&zero, 1, 1)));
    ck_assert(isnan(comparison_factor(&all, 1, 0)));
    ck_assert_double_eq(comparison_factor(&all, 2, 0), 1);
    ck_assert(isinf(comparison_factor(&all, 2, 1)));
}
END_TEST

START_TEST(nothing_beats_the_front_and_the_rest_names_who_beats_it)
{
    static const bool front[ROWS] = {true, true, false, false, false};
    static const size_t dominator[ROWS] = {COMPARISON_NONE, COMPARISON_NONE, 0, 1, 0};
    size_t better;
    for (size_t row = 0; row < ROWS; row++) {
        ck_assert_msg(comparison_on_front(&TABLE, row) == front[row], "%s", NAMES[row]);
        ck_assert_msg(comparison_dominator(&TABLE, row) == dominator[row], "%s: %zu", NAMES[row],
                      comparison_dominator(&TABLE, row));
        ck_assert(!comparison_dominates(&TABLE, row, row, &better));
    }
    ck_assert(comparison_dominates(&TABLE, 0, 2, &better));
    ck_assert_uint_eq(better, 2);
}
END_TEST

START_TEST(all_round_is_the_least_of_worst_ranks_among_those_with_every_number)
{
    size_t worst;
    /* alpha (1, 3, 1) before beta (3, 1, 1): equal worst and sum, so the first */
    ck_assert_uint_eq(comparison_all_round(&TABLE, &worst), 0);
    ck_assert_uint_eq(worst, 3);
    static const struct comparison_cell cells[] = {N(1), FAILED, FAILED, N(1)};
    const struct comparison_table failing = {2, 2, NAMES, RULES, cells};
    ck_assert_uint_eq(comparison_all_round(&failing, &worst), COMPARISON_NONE);
}
END_TEST

START_TEST(each_sentence_says_where_a_row_loses_by_the_numbers)
{
    static const char *const parts[ROWS][3] = {
        {"Loses most in Reach: 50 m against 90 m of beta (rank 3 of 5, the best is 1.8 times it).",
         "Best, or equal to the best, in Error, Drift.",
         "On the front: none is as good in every column."},
        {"Loses most in Error: 2 % against 1 % of alpha (rank 3 of 4, 2 times the best).",
         "Best, or equal to the best, in Reach, Drift.", "On the front"},
        {"Loses most in Drift: 0.5 against 0.0002 of beta (rank 4 of 4, 2500 times the best).",
         "Behind also in Reach (rank 4 of 5, the best is 2.25 times it).",
         "Dominated by alpha: nowhere worse, better in 2 of 3 columns."},
        {"Loses most in Drift", "No number for Error: it blew up.",
         "Dominated by beta: nowhere worse, better in 2 of 3 columns."},
        {"Loses most in Reach: 10 m against 90 m of beta (rank 5 of 5",
         "Dominated by alpha: nowhere worse, better in 1 of 3 columns.", ""},
    };
    for (size_t row = 0; row < ROWS; row++) {
        char *sentence = comparison_sentence(&TABLE, row);
        for (size_t i = 0; i < 3; i++)
            ck_assert_msg(strstr(sentence, parts[row][i]) != NULL, "%s: %s", NAMES[row], sentence);
        g_free(sentence);
    }
}
END_TEST

START_TEST(columns_that_fail_for_one_reason_are_named_together)
{
    static const struct comparison_cell cells[] = {FAILED, FAILED, FAILED};
    static const struct comparison_table table = {1, COLUMNS, NAMES, RULES, cells};
    char *sentence = comparison_sentence(&table, 0);
    ck_assert_str_eq(sentence, "It has no number. No number for Error, Reach, Drift: it blew up.");
    g_free(sentence);
}
END_TEST

START_TEST(the_summary_names_the_best_and_its_equals)
{
    char *error = comparison_advice(&TABLE, 0), *front = comparison_front_names(&TABLE),
         *all = comparison_all_round_words(&TABLE);
    ck_assert_str_eq(error, "alpha (1 %); equal: gamma");
    ck_assert_str_eq(front, "alpha, beta");
    ck_assert_str_eq(all, "alpha: its worst rank is 3 of 5, in Reach");
    g_free(error);
    g_free(front);
    g_free(all);
    static const struct comparison_cell none[] = {ABSENT, ABSENT, ABSENT};
    static const struct comparison_table empty = {1, COLUMNS, NAMES, RULES, none};
    char *nothing = comparison_advice(&empty, 0);
    ck_assert_str_eq(nothing, "");
    ck_assert(!comparison_on_front(&empty, 0));
    g_free(nothing);
}
END_TEST

Suite *suite_comparison(void)
{
    Suite *suite = suite_create("comparison");
    TCase *cases = tcase_create("comparison");
    tcase_add_test(cases, ranks_count_what_is_better_beyond_the_tolerance);
    tcase_add_test(cases, factors_are_ratios_to_the_best_and_at_least_one);
    tcase_add_test(cases, a_factor_to_zero_is_infinite_and_one_across_zero_is_none);
    tcase_add_test(cases, nothing_beats_the_front_and_the_rest_names_who_beats_it);
    tcase_add_test(cases, all_round_is_the_least_of_worst_ranks_among_those_with_every_number);
    tcase_add_test(cases, each_sentence_says_where_a_row_loses_by_the_numbers);
    tcase_add_test(cases, columns_that_fail_for_one_reason_are_named_together);
    tcase_add_test(cases, the_summary_names_the_best_and_its_equals);
    suite_add_tcase(suite, cases);
    return suite;
}
