/* Names near to misspelt ones, and lines of a width.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_words.h"
#include "suites.h"

#include <glib.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

START_TEST(a_distance_counts_letters_added_left_out_replaced_and_swapped)
{
    static const struct {
        const char *one, *other;
        size_t distance;
    } rows[] = {
        {"", "", 0},
        {"", "abc", 3},
        {"shape", "shape", 0},
        {"shape", "Shape", 0},
        {"shape", "shpae", 1},
        {"shape", "shap", 1},
        {"shape", "shapes", 1},
        {"shape", "shame", 1},
        {"kitten", "sitting", 3},
        {"abc", "xyz", 3},
        {"materials", "metarials", 2},
        {"ab", "ba", 1},
        {"flaw", "lawn", 2},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        ck_assert_uint_eq(mpm_words_distance(rows[i].one, rows[i].other), rows[i].distance);
        ck_assert_uint_eq(mpm_words_distance(rows[i].other, rows[i].one), rows[i].distance);
    }
}
END_TEST

START_TEST(words_of_any_length_have_a_distance)
{
    char longest[66];
    memset(longest, 'a', sizeof longest);
    longest[64] = '\0';
    ck_assert_uint_eq(mpm_words_distance(longest, ""), 64);
    ck_assert_uint_eq(mpm_words_distance(longest, longest), 0);
    longest[64] = 'a';
    longest[65] = '\0';
    ck_assert_uint_eq(mpm_words_distance(longest, "a"), SIZE_MAX);
    ck_assert_uint_eq(mpm_words_distance("a", longest), SIZE_MAX);
}
END_TEST

START_TEST(only_what_is_near_enough_is_meant)
{
    static const char *const names[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3", "end"};
    static const struct {
        const char *word, *hint;
    } rows[] = {
        {"clasic", "; did you mean classic?"},
        {"UGIMP", "; did you mean ugimp?"},
        {"gimp", "; did you mean ugimp?"},
        {"bspline", "; did you mean bspline2?"},
        {"bsplin3", "; did you mean bspline3?"},
        {"cdpi", "; did you mean cpdi?"},
        {"emd", "; did you mean end?"},
        {"x", ""},
        {"", ""},
        {"polygon", ""},
        {"en", "; did you mean end?"},
        {"no", ""},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        struct mpm_nearest nearest = {.word = rows[i].word};
        char hint[MPM_HINT_SIZE];
        for (size_t k = 0; k < G_N_ELEMENTS(names); k++)
            mpm_nearest_offer(&nearest, names[k]);
        ck_assert_str_eq(mpm_nearest_hint(&nearest, hint), rows[i].hint);
    }
}
END_TEST

static char *wrapped(const char *text, size_t column, size_t indent, size_t width)
{
    char *lines = NULL;
    size_t size;
    FILE *out = open_memstream(&lines, &size);
    mpm_words_wrap(out, text, column, indent, width);
    ck_assert_int_eq(fclose(out), 0);
    return lines;
}

START_TEST(words_go_to_lines_of_a_width)
{
    static const struct {
        const char *text;
        size_t column, indent, width;
        const char *lines;
    } rows[] = {
        {"", 0, 0, 10, "\n"},
        {"one two three", 0, 0, 80, "one two three\n"},
        {"one two three", 0, 2, 7, "one two\n  three\n"},
        {"one two three", 4, 2, 7, "one\n  two\n  three\n"},
        {"one two\nthree", 0, 2, 80, "one two\n  three\n"},
        {"one\n\ntwo", 0, 2, 80, "one\n\n  two\n"},
        {"a-word-that-is-too-long b", 0, 1, 5, "a-word-that-is-too-long\n b\n"},
        {"σσσ σσσ", 0, 0, 7, "σσσ σσσ\n"},
        {"σσσ σσσ", 0, 0, 6, "σσσ\nσσσ\n"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        char *lines = wrapped(rows[i].text, rows[i].column, rows[i].indent, rows[i].width);
        ck_assert_str_eq(lines, rows[i].lines);
        free(lines);
    }
}
END_TEST

Suite *suite_words(void)
{
    Suite *suite = suite_create("words");
    TCase *words = tcase_create("words");
    tcase_add_test(words, a_distance_counts_letters_added_left_out_replaced_and_swapped);
    tcase_add_test(words, words_of_any_length_have_a_distance);
    tcase_add_test(words, only_what_is_near_enough_is_meant);
    tcase_add_test(words, words_go_to_lines_of_a_width);
    suite_add_tcase(suite, words);
    return suite;
}
