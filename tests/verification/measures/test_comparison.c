/* Methods compared: ranks, limits, front, sentences and labels, from tables made by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/measures/comparison/comparison.h"
#include "verification/measures/comparison/comparison_guide.h"
#include "verification/measures/comparison/comparison_words.h"
#include "verification/measures/comparison/label_places.h"

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
    {.title = "Error", .unit = "%", .better = COMPARISON_LOW, .tolerance = 0.1},
    {.title = "Reach", .unit = "m", .better = COMPARISON_HIGH, .tolerance = 0.01},
    {.title = "Drift", .unit = "1", .better = COMPARISON_ZERO, .floor = 1e-3},
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

/* The same with limits: beta's error and gamma's drift are beyond them, delta has no error. */
static const struct comparison_column LIMITED[COLUMNS] = {
    {.title = "Error",
     .unit = "%",
     .better = COMPARISON_LOW,
     .tolerance = 0.1,
     .limited = true,
     .limit = 1.5,
     .beyond = "wrong by",
     .missing = "lost"},
    {.title = "Reach", .unit = "m", .better = COMPARISON_HIGH, .tolerance = 0.01},
    {.title = "Drift",
     .unit = "1",
     .better = COMPARISON_ZERO,
     .floor = 1e-3,
     .limited = true,
     .limit = 0.2},
};
static const struct comparison_table BOUNDED = {ROWS, COLUMNS, NAMES, LIMITED, CELLS};

START_TEST(ranks_count_what_is_better_beyond_the_tolerance)
{
    static const size_t ranks[ROWS][COLUMNS] = {
        {1, 3, 1}, {3, 1, 1}, {1, 4, 4}, {0, 1, 3}, {0, 5, 0}};
    static const size_t counts[COLUMNS] = {3, 5, 4}, best[COLUMNS] = {0, 1, 1},
                        level[COLUMNS] = {2, 2, 2}, last[COLUMNS] = {1, 4, 2};
    for (size_t column = 0; column < COLUMNS; column++) {
        ck_assert_uint_eq(comparison_count(&TABLE, column), counts[column]);
        ck_assert_uint_eq(comparison_best(&TABLE, column), best[column]);
        ck_assert_uint_eq(comparison_level_count(&TABLE, column), level[column]);
        for (size_t row = 0; row < ROWS; row++) {
            ck_assert_msg(comparison_rank(&TABLE, row, column) == ranks[row][column],
                          "%s, %s: rank %zu", NAMES[row], RULES[column].title,
                          comparison_rank(&TABLE, row, column));
            ck_assert_int_eq(comparison_is_last(&TABLE, row, column), row == last[column]);
        }
    }
}
END_TEST

START_TEST(a_row_beyond_a_limit_takes_no_part)
{
    static const bool part[ROWS] = {true, false, false, false, true};
    static const size_t ranks[ROWS] = {1, 0, 0, 0, 2};
    static const char *const words[ROWS] = {"valid", "wrong by 2 %", "beyond the limit in Drift",
                                            "lost", "valid"};
    size_t better;
    for (size_t row = 0; row < ROWS; row++) {
        char *said = comparison_run_words(&BOUNDED, row);
        ck_assert_int_eq(comparison_takes_part(&BOUNDED, row), part[row]);
        ck_assert_uint_eq(comparison_rank(&BOUNDED, row, 1), ranks[row]);
        ck_assert_str_eq(said, words[row]);
        ck_assert(part[row] || (!comparison_on_front(&BOUNDED, row) &&
                                !comparison_dominates(&BOUNDED, row, 4, &better) &&
                                comparison_dominator(&BOUNDED, row) == COMPARISON_NONE));
        g_free(said);
    }
    ck_assert_uint_eq(comparison_best(&BOUNDED, 1), 0);
    char *limits = comparison_limits(&BOUNDED), *outside = comparison_outside(&BOUNDED);
    ck_assert_str_eq(limits, "Error at most 1.5 %; Drift at most ±0.2");
    ck_assert_str_eq(outside, "beta: wrong by 2 %; gamma: beyond the limit in Drift; delta: lost");
    g_free(outside);
    g_free(limits);
}
END_TEST

START_TEST(a_number_at_the_limit_is_within_it)
{
    static const struct {
        double limit, value;
        enum comparison_better better;
        bool beyond;
    } table[] = {{2, 2, COMPARISON_LOW, false},    {2, 2.01, COMPARISON_LOW, true},
                 {2, -9, COMPARISON_LOW, false},   {2, 2, COMPARISON_HIGH, false},
                 {2, 1.99, COMPARISON_HIGH, true}, {2, -2, COMPARISON_ZERO, false},
                 {2, -2.01, COMPARISON_ZERO, true}};
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct comparison_column rule = {
            .better = table[i].better, .limited = true, .limit = table[i].limit};
        const struct comparison_cell cell = N(table[i].value), absent = ABSENT;
        const struct comparison_table one = {1, 1, NAMES, &rule, &cell},
                                      none = {1, 1, NAMES, &rule, &absent};
        ck_assert_msg(comparison_is_beyond(&one, 0, 0) == table[i].beyond, "row %zu", i);
        ck_assert(!comparison_is_beyond(&none, 0, 0));
    }
}
END_TEST

START_TEST(factors_are_ratios_to_the_best_and_at_least_one)
{
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 0), 1);
    ck_assert_double_eq(comparison_factor(&TABLE, 1, 0), 2);
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 1), 1.8);
    /* within the floor: as good as the best; beyond it: as many times the floor */
    ck_assert_double_eq(comparison_factor(&TABLE, 0, 2), 1);
    ck_assert_double_eq_tol(comparison_factor(&TABLE, 2, 2), 500, 1e-9);
    ck_assert(isinf(comparison_factor(&TABLE, 3, 0)));
    ck_assert(isnan(comparison_factor(&TABLE, 4, 0)));
}
END_TEST

START_TEST(a_factor_to_zero_is_infinite_and_one_across_zero_is_none)
{
    static const struct comparison_column rules[] = {
        {.title = "a", .unit = "1", .better = COMPARISON_LOW},
        {.title = "b", .unit = "1", .better = COMPARISON_HIGH}};
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

START_TEST(who_was_not_measured_where_another_was_dominates_it_not)
{
    static const struct comparison_cell cells[] = {N(1), N(50), ABSENT, N(2), N(40), N(0.5)};
    const struct comparison_table table = {2, COLUMNS, NAMES, RULES, cells};
    size_t better;
    ck_assert(!comparison_dominates(&table, 0, 1, &better));
    ck_assert(comparison_on_front(&table, 1));
    const struct comparison_table both = {
        2, 2, NAMES, RULES, (const struct comparison_cell[]){N(1), N(50), N(2), N(40)}};
    ck_assert(comparison_dominates(&both, 0, 1, &better));
}
END_TEST

START_TEST(a_column_is_constant_where_all_that_count_have_one_number)
{
    static const struct comparison_column rules[] = {
        {.title = "a", .unit = "1", .better = COMPARISON_HIGH, .limited = true, .limit = 6},
        {.title = "b", .unit = "1", .better = COMPARISON_LOW}};
    static const struct {
        struct comparison_cell cells[6];
        bool first, second;
    } table[] = {
        {{N(6), N(1), N(6), N(1), N(6), N(1)}, true, true},
        {{N(6), N(1), N(6), N(1), N(2), N(7)}, true, false},
        {{N(6), N(1), N(6), N(1.5), N(6), N(1)}, true, false},
        {{N(6), N(1), N(2), N(1), N(3), N(1)}, false, false},
        {{N(6), N(1), N(7), FAILED, N(6), N(1)}, false, false},
        {{N(6), N(1), ABSENT, ABSENT, N(6), N(1)}, false, false},
        {{N(2), ABSENT, N(2), ABSENT, N(2), ABSENT}, false, false},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct comparison_table three = {3, 2, NAMES, rules, table[i].cells};
        ck_assert_msg(comparison_is_constant(&three, 0) == table[i].first, "row %zu", i);
        ck_assert_msg(comparison_is_constant(&three, 1) == table[i].second, "row %zu", i);
    }
}
END_TEST

START_TEST(each_sentence_says_where_a_row_loses_by_the_numbers)
{
    static const char *const parts[ROWS][3] = {
        {"Loses most in Reach: 50 m against 90 m (rank 3 of 5, the best is 1.8 times it).",
         "Best, or equal to the best, in Error, Drift.",
         "On the front: none is as good in every column."},
        {"Loses most in Error: 2 % against 1 % (last of 3, 2 times the best).",
         "Best, or equal to the best, in Reach, Drift.", "On the front"},
        {"Loses most in Drift: 0.5 against 0.0002 (last of 4, 500 times the best).",
         "Behind also in Reach (rank 4 of 5, the best is 2.25 times it).",
         "Dominated by alpha: nowhere worse where both are measured, better in 2 of 3 columns."},
        {"Loses most in Drift", "No number for Error: it blew up.",
         "Dominated by beta: nowhere worse where both are measured, better in 2 of 3 columns."},
        {"Loses most in Reach: 10 m against 90 m (last of 5",
         "Dominated by alpha: nowhere worse where both are measured, better in 1 of 3 columns.",
         ""},
    };
    for (size_t row = 0; row < ROWS; row++) {
        char *sentence = comparison_sentence(&TABLE, row);
        for (size_t i = 0; i < 3; i++)
            ck_assert_msg(strstr(sentence, parts[row][i]) != NULL, "%s: %s", NAMES[row], sentence);
        g_free(sentence);
    }
    char *outside = comparison_sentence(&BOUNDED, 1);
    ck_assert_str_eq(outside, "Takes no part: wrong by 2 %. Error 2 %, Reach 90 m, Drift 0.0002.");
    g_free(outside);
}
END_TEST

START_TEST(columns_that_fail_for_one_reason_are_named_together)
{
    static const struct comparison_cell cells[] = {FAILED, FAILED, FAILED};
    static const struct comparison_table table = {1, COLUMNS, NAMES, RULES, cells};
    char *sentence = comparison_sentence(&table, 0);
    ck_assert_str_eq(sentence, "Takes no part: no number. No number for Error, Reach, Drift: it "
                               "blew up.");
    g_free(sentence);
}
END_TEST

START_TEST(losses_name_each_row_once_and_those_alike_together)
{
    static const struct comparison_cell cells[] = {N(1),  N(90), N(0),  N(2),  N(90),
                                                   N(0),  N(4),  N(80), N(0),  N(2),
                                                   N(90), N(0),  N(1),  N(90), N(0)};
    static const struct comparison_table table = {ROWS, COLUMNS, NAMES, RULES, cells};
    char *error = comparison_losses(&table, 0), *reach = comparison_losses(&table, 1),
         *none = comparison_losses(&table, COMPARISON_NONE);
    ck_assert_str_eq(error, "beta, delta: 2 % (rank 3 of 5, 2 times the best); gamma: 4 % (last of "
                            "5, 4 times the best)");
    ck_assert_str_eq(reach, "");
    ck_assert_str_eq(none, "alpha, omega");
    g_free(none);
    g_free(reach);
    g_free(error);
}
END_TEST

START_TEST(the_summary_names_the_best_and_its_equals)
{
    char *error = comparison_advice(&TABLE, 0), *front = comparison_front_names(&TABLE);
    ck_assert_str_eq(error, "alpha (1 %); equal: gamma");
    ck_assert_str_eq(front, "alpha, beta");
    g_free(error);
    g_free(front);
    static const struct comparison_cell none[] = {ABSENT, ABSENT, ABSENT};
    static const struct comparison_table empty = {1, COLUMNS, NAMES, RULES, none};
    char *nothing = comparison_advice(&empty, 0), *guide = comparison_guide(&empty, 0, 1);
    ck_assert_str_eq(nothing, "");
    ck_assert_str_eq(guide, "");
    ck_assert(!comparison_on_front(&empty, 0));
    g_free(guide);
    g_free(nothing);
}
END_TEST

START_TEST(where_many_are_equal_no_winner_is_named)
{
    enum { MANY = 7 };
    static const char *const names[MANY] = {"a", "b", "c", "d", "e", "f", "g"};
    static const struct comparison_cell cells[] = {N(1), N(1), N(1), N(1), N(1), N(1), N(9)};
    const struct comparison_table table = {MANY, 1, names, RULES, cells};
    char *advice = comparison_advice(&table, 0);
    ck_assert_str_eq(advice, "6 of 7 are equal (1 %)");
    g_free(advice);
    const struct comparison_table tied = {2, 1, names, RULES, cells};
    advice = comparison_advice(&tied, 0);
    ck_assert_str_eq(advice, "all 2 are equal (1 %)");
    g_free(advice);
}
END_TEST

START_TEST(the_guide_takes_the_cheapest_of_the_best_and_names_who_is_cheaper)
{
    static const struct comparison_column rules[] = {
        {.title = "Error",
         .unit = "%",
         .better = COMPARISON_LOW,
         .tolerance = 0.1,
         .limited = true,
         .limit = 5},
        {.title = "Time", .unit = "s", .better = COMPARISON_LOW, .tolerance = 0.3}};
    static const struct comparison_cell cells[] = {N(1), N(9), N(1.05), N(6),  N(4),
                                                   N(2), N(3), N(2.2),  N(90), N(0.1)};
    static const struct comparison_table table = {ROWS, 2, NAMES, rules, cells};
    char *guide = comparison_guide(&table, 0, 1),
         *alone = comparison_guide(&table, 0, COMPARISON_NONE);
    ck_assert_uint_eq(comparison_choice(&table, 0, 1), 1);
    ck_assert_str_eq(
        guide,
        "Use beta. Error: 1.05 %, the best of the 4 runs that count; equal: alpha. Of these, beta "
        "is among the cheapest and loses least in the other columns. Time: 6 s, 3 times the best. "
        "Cheaper: delta, 2.2 s (Error: 3 %). 1 of 5 runs does not count: broken, or beyond a "
        "limit.");
    ck_assert_str_eq(alone,
                     "Use beta. Error: 1.05 %, the best of the 4 runs that count; equal: alpha. Of "
                     "these, beta loses least in the other columns. Next: delta (3 %). 1 of 5 runs "
                     "does not count: broken, or beyond a limit.");
    g_free(alone);
    g_free(guide);
}
END_TEST

START_TEST(a_difference_within_the_tolerance_of_cost_decides_nothing)
{
    static const struct comparison_column rules[] = {
        {.title = "Error", .unit = "%", .better = COMPARISON_LOW, .tolerance = 0.1},
        {.title = "Time", .unit = "s", .better = COMPARISON_LOW, .tolerance = 0.3},
        {.title = "Swing", .unit = "%", .better = COMPARISON_LOW}};
    static const struct comparison_cell cells[] = {N(1), N(1), N(10), N(1), N(1.2),
                                                   N(1), N(1), N(2),  N(1)};
    static const struct comparison_table table = {3, 3, NAMES, rules, cells};
    ck_assert_uint_eq(comparison_choice(&table, 0, 1), 1);
    static const struct comparison_table two = {2, 3, NAMES, rules, cells};
    ck_assert_uint_eq(comparison_choice(&two, 0, 1), 1);
    static const struct comparison_cell dear[] = {N(1), N(1), N(10), N(1), N(1.4), N(1)};
    static const struct comparison_table apart = {2, 3, NAMES, rules, dear};
    ck_assert_uint_eq(comparison_choice(&apart, 0, 1), 0);
}
END_TEST

START_TEST(labels_cover_neither_points_nor_each_other)
{
    enum { POINTS = 40, LETTERS = 60 };
    static const struct label_frame frame = {600, 400, 6};
    struct label_place labels[POINTS];
    unsigned state = 1;
    for (int i = 0; i < POINTS; i++) {
        const unsigned across = state = state * 1103515245u + 12345u;
        const unsigned up = state = state * 1103515245u + 12345u;
        labels[i] = (struct label_place){.x = 100 + (double)(across >> 16 & 255),
                                         .y = 100 + (double)(up >> 16 & 127),
                                         .width = i % 4 == 3 ? 0 : LETTERS,
                                         .height = 12};
    }
    const size_t placed = label_places_find(labels, POINTS, &frame);
    ck_assert_msg(placed > 10 && placed < POINTS, "%zu", placed);
    for (int i = 0; i < POINTS; i++) {
        const struct label_place *one = &labels[i];
        if (!one->placed)
            continue;
        ck_assert(one->left >= 0 && one->left + one->width <= frame.width && one->low >= 0 &&
                  one->low + one->height <= frame.height);
        for (int j = 0; j < POINTS; j++) {
            const struct label_place *other = &labels[j];
            const bool on_point = other->x > one->left && other->x < one->left + one->width &&
                                  other->y > one->low && other->y < one->low + one->height;
            const bool on_label = i != j && other->placed && other->left < one->left + one->width &&
                                  one->left < other->left + other->width &&
                                  other->low < one->low + one->height &&
                                  one->low < other->low + other->height;
            ck_assert_msg(!on_point && !on_label, "label %d on %d", i, j);
        }
    }
}
END_TEST

START_TEST(where_there_is_no_room_a_label_is_left_out)
{
    static const struct label_frame frame = {50, 20, 6};
    struct label_place one = {.x = 25, .y = 10, .width = 60, .height = 12};
    ck_assert_uint_eq(label_places_find(&one, 1, &frame), 0);
    ck_assert(!one.placed);
}
END_TEST

Suite *suite_comparison(void)
{
    Suite *suite = suite_create("comparison");
    TCase *cases = tcase_create("comparison");
    TCase *words = tcase_create("words"), *labels = tcase_create("labels");
    tcase_add_test(cases, ranks_count_what_is_better_beyond_the_tolerance);
    tcase_add_test(cases, a_row_beyond_a_limit_takes_no_part);
    tcase_add_test(cases, a_number_at_the_limit_is_within_it);
    tcase_add_test(cases, factors_are_ratios_to_the_best_and_at_least_one);
    tcase_add_test(cases, a_factor_to_zero_is_infinite_and_one_across_zero_is_none);
    tcase_add_test(cases, nothing_beats_the_front_and_the_rest_names_who_beats_it);
    tcase_add_test(cases, who_was_not_measured_where_another_was_dominates_it_not);
    tcase_add_test(cases, a_column_is_constant_where_all_that_count_have_one_number);
    tcase_add_test(words, each_sentence_says_where_a_row_loses_by_the_numbers);
    tcase_add_test(words, columns_that_fail_for_one_reason_are_named_together);
    tcase_add_test(words, losses_name_each_row_once_and_those_alike_together);
    tcase_add_test(words, the_summary_names_the_best_and_its_equals);
    tcase_add_test(words, where_many_are_equal_no_winner_is_named);
    tcase_add_test(words, the_guide_takes_the_cheapest_of_the_best_and_names_who_is_cheaper);
    tcase_add_test(words, a_difference_within_the_tolerance_of_cost_decides_nothing);
    tcase_add_test(labels, labels_cover_neither_points_nor_each_other);
    tcase_add_test(labels, where_there_is_no_room_a_label_is_left_out);
    suite_add_tcase(suite, cases);
    suite_add_tcase(suite, words);
    suite_add_tcase(suite, labels);
    return suite;
}
