/* Numbers and expressions of scenes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"
#include "mpm_expression.h"
#include "suites.h"

#include <locale.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static const char *const PLANAR[2] = {"x", "y"};
static const char *const AXISYMMETRIC[2] = {"r", "z"};

/* A few operations in double precision, each off by 1e-16 of its result, on values up
 * to 512. */
static const double ROUND_OFF = 1e-12;

/* ----------------------------------------------------------------- numbers */

static const struct {
    const char *text;
    double value;
} numbers[] = {
    {"0", 0.0},
    {"1", 1.0},
    {"-1", -1.0},
    {"+1", 1.0},
    {"1.", 1.0},
    {".5", 0.5},
    {"-.5", -0.5},
    {"1e-2", 0.01},
    {"1.0e6", 1e6},
    {"1.e3", 1e3},
    {"2.5E+3", 2500.0},
    {"007", 7.0},
    {"-0", 0.0},
    {".5e1", 5.0},
    {"1e308", 1e308},
    {"1e-400", 0.0},
    {"4.9e-324", 4.9406564584124654e-324},
    {"123456789.125", 123456789.125},
};

START_TEST(a_number_is_read_in_every_spelling)
{
    double value = -42.0;
    ck_assert_msg(mpm_number_parse(numbers[_i].text, &value), "%s", numbers[_i].text);
    ck_assert_msg(value == numbers[_i].value, "%s gave %.17g", numbers[_i].text, value);
}
END_TEST

static const char *const no_numbers[] = {
    "",       " ",   "1 ",    " 1",   "abc",  "1a",   "1e",       "1e+",   "e5",
    ".",      "-",   "+",     "+-1",  "--1",  "1..2", "1.2.3",    "1,5",   "1_000",
    "nan",    "NaN", "inf",   "-inf", ".inf", ".nan", "0x10",     "0x1p3", "1e400",
    "-1e400", "1d5", "1e5.0", "½",    "1\n",  "1f",   "infinity",
};

START_TEST(a_text_that_is_no_number_is_refused)
{
    double value = 42.0;
    ck_assert_msg(!mpm_number_parse(no_numbers[_i], &value), "%s", no_numbers[_i]);
    ck_assert_double_eq(value, 42.0);
}
END_TEST

START_TEST(a_locale_with_a_decimal_comma_changes_no_number)
{
    static const char *const locales[] = {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"};
    for (size_t i = 0; i < sizeof locales / sizeof *locales; i++)
        if (setlocale(LC_ALL, locales[i]) != NULL)
            break; /* where none is installed, the test holds for the C locale */
    const double origin[2] = {0.0, 0.0};
    double value = 0.0;
    ck_assert(mpm_number_parse("1.5", &value));
    ck_assert_double_eq(value, 1.5);
    struct mpm_expression *expression = NULL;
    ck_assert_int_eq(mpm_expression_create("1.5+x", PLANAR, false, 1, &expression, NULL), MPM_OK);
    ck_assert_double_eq(mpm_expression_value(expression, 0, origin, 0.0), 1.5);
    mpm_expression_free(expression);
    (void)setlocale(LC_ALL, "C");
}
END_TEST

/* ------------------------------------------------------------------ values */

static const struct {
    const char *text;
    bool constant;
    double value; /* at (2, 3), time 0.5 */
} values[] = {
    {"1e-2", true, 0.01},
    {"-8.31", true, -8.31},
    {"2*pi", true, 6.283185307179586},
    {"e", true, 2.718281828459045},
    {"ln(e)", true, 1.0},
    {"log(e^2)", true, 2.0},
    {"log10(1000)", true, 3.0},
    {"x", false, 2.0},
    {"y", false, 3.0},
    {"t", false, 0.5},
    {"-8.31*x/50", false, -0.3324},
    {"2^3^2", true, 512.0},
    {"-x^2", false, -4.0},
    {"min(x, y)", false, 2.0},
    {"max(min(x,1), t)", false, 1.0},
    {"sum(x,y,t)", false, 5.5},
    {"x > 1 ? y : t", false, 3.0},
    {"(x == 2) + (y != 3) + (t <= 1) + (t >= 1)", false, 2.0},
    {" sqrt( x*x + y*y )\n", false, 3.605551275463989},
    {"sin(pi/2)+cos(0)", true, 2.0},
    {"1e-2*x", false, 0.02},
};

START_TEST(an_expression_has_its_value)
{
    const double place[2] = {2.0, 3.0}, elsewhere[2] = {4.0, 7.0};
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    (void)mpm_expression_create(values[_i].text, PLANAR, true, 1, &expression, &error);
    ck_assert_msg(expression != NULL, "%s: %s", values[_i].text, error.message);
    const double value = mpm_expression_value(expression, 0, place, 0.5);
    ck_assert_msg(fabs(value - values[_i].value) <= ROUND_OFF, "%s gave %.17g", values[_i].text,
                  value);
    if (values[_i].constant)
        ck_assert_double_eq(mpm_expression_value(expression, 0, elsewhere, 0.25), value);
    ck_assert_str_eq(mpm_expression_text(expression), values[_i].text);
    mpm_expression_free(expression);
}
END_TEST

START_TEST(an_expression_may_be_not_finite)
{
    const double origin[2] = {0.0, 0.0};
    struct mpm_expression *expression = NULL;
    ck_assert_int_eq(mpm_expression_create("1/r", AXISYMMETRIC, true, 1, &expression, NULL),
                     MPM_OK);
    ck_assert(isinf(mpm_expression_value(expression, 0, origin, 0.0)));
    mpm_expression_free(expression);
}
END_TEST

struct own_places {
    struct mpm_expression *expression;
    atomic_int wrong;
};

static void evaluate_row(void *context, int64_t row, int worker)
{
    struct own_places *const places = context;
    const double place[2] = {worker, (double)row}; /* whole numbers: exact */
    const double value = mpm_expression_value(places->expression, worker, place, 2.0);
    places->wrong += value != worker + 10.0 * (double)row + 200.0;
}

START_TEST(each_worker_evaluates_at_its_own_place)
{
    enum { WORKERS = 4, ROWS = 4000 };
    struct own_places places = {0};
    ck_assert_int_eq(mpm_expression_create("r+10*z+100*t", AXISYMMETRIC, true, WORKERS,
                                           &places.expression, NULL),
                     MPM_OK);
    mpm_rows_run(0, ROWS - 1, WORKERS, evaluate_row, &places);
    ck_assert_int_eq(places.wrong, 0);
    mpm_expression_free(places.expression);
}
END_TEST

/* ------------------------------------------------------------------ errors */

static const struct {
    const char *text, *message;
} mistakes[] = {
    {"", "column 1: Expression is empty"},
    {"   ", "Expression is empty"},
    {"a+1", "column 1: Unexpected token \"a\""},
    {"1+velocity", "column 3: Unexpected token \"velocity\""},
    {"z", "column 1: Unexpected token \"z\""},
    {"x y", "column 3: Unexpected variable \"y\""},
    {"2x", "column 2: Unexpected variable \"x\""},
    {"1 2", "column 3: Unexpected value \"2\""},
    {"1+", "column 3: Unexpected end of expression"},
    {"(1", "column 3: Missing parenthesis"},
    {"1)", "column 2: Unexpected parenthesis"},
    {"sin()", "Too few parameters for function \"sin\""},
    {"sin(1,2)", "Too many parameters for function \"sin\""},
    {"nothing(1)", "column 1: Unexpected token \"nothing\""},
    {"x=1", "column 2: '=' makes an assignment"},
    {"(x=1)", "column 3: '=' makes an assignment"},
    {"x = = 1", "column 3: '=' makes an assignment"},
    {"1,2", "column 2: ',' makes a list of values"},
    {"min(1,2),3", "column 9: ',' makes a list of values"},
    {"(1,2)", "Function arguments used without a function"},
    {"\"x\"", "column 1: '\"' makes a text"},
    {"--x", "column 2: Unexpected operator \"-\""},
    {"x**2", "column 3: Unexpected operator \"*\""},
    {"x ? 1", "missing an else clause"},
    {"nan", "column 1: Unexpected token \"nan\""},
    {"inf", "column 1: Unexpected token \"inf\""},
    {"1e400", "column 1: Unexpected token \"1e400\""},
    {"0x10", "column 2: Unexpected token \"x10\""},
    {"_pi", "column 1: Unexpected token \"_pi\""},
    {"é+q", "column 1: Unexpected token"},
    {"free", "column 1: Unexpected token \"free\""},
};

START_TEST(a_mistake_is_reported_with_its_column)
{
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_expression_create(mistakes[_i].text, PLANAR, true, 2, &expression, &error),
                     MPM_BAD_INPUT);
    ck_assert_ptr_null(expression);
    ck_assert_int_eq(error.status, MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, mistakes[_i].message) != NULL, "%s: got %s",
                  mistakes[_i].text, error.message);
    ck_assert_msg(strstr(error.message, "column ") != NULL, "%s", error.message);
}
END_TEST

START_TEST(time_is_unknown_where_it_has_no_meaning)
{
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_expression_create("x*t", PLANAR, false, 1, &expression, &error),
                     MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "column 3: Unexpected token \"t\""));
}
END_TEST

START_TEST(an_expression_of_4096_characters_is_the_longest)
{
    enum { LONGEST = 4096 };
    char text[LONGEST + 2];
    memset(text, ' ', sizeof text);
    text[0] = 'x';
    text[LONGEST + 1] = '\0';
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_expression_create(text, PLANAR, true, 1, &expression, &error),
                     MPM_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(error.message, "4097 characters; allowed: up to 4096"));
    text[LONGEST] = '\0';
    ck_assert_int_eq(mpm_expression_create(text, PLANAR, true, 1, &expression, &error), MPM_OK);
    mpm_expression_free(expression);
}
END_TEST

/* muParser copies the mistaken part of a text to a buffer of 2048 bytes, whatever its length. */
START_TEST(a_mistake_in_a_long_expression_has_its_column)
{
    enum { LENGTH = 4001, AT = 20 };
    char text[LENGTH + 1];
    for (size_t k = 0; k < LENGTH; k++)
        text[k] = k % 2 == 0 ? '1' : '+';
    text[AT] = '#';
    text[LENGTH] = '\0';
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_expression_create(text, PLANAR, true, 1, &expression, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "column 21: a mistake in a long expression; allowed: ") !=
                      NULL,
                  "%s", error.message);
}
END_TEST

/* Nothing in it recurses or explodes: 2000 parentheses are an expression like others. */
START_TEST(a_deeply_nested_expression_has_its_value)
{
    enum { DEPTH = 2000 };
    char text[2 * DEPTH + 2];
    memset(text, '(', DEPTH);
    text[DEPTH] = 'x';
    memset(text + DEPTH + 1, ')', DEPTH);
    text[2 * DEPTH + 1] = '\0';
    const double place[2] = {7.0, 0.0};
    struct mpm_expression *expression = NULL;
    ck_assert_int_eq(mpm_expression_create(text, PLANAR, true, 1, &expression, NULL), MPM_OK);
    ck_assert_double_eq(mpm_expression_value(expression, 0, place, 0.0), 7.0);
    mpm_expression_free(expression);
}
END_TEST

/* `0*x` too is evaluated at a place. */
START_TEST(an_expression_without_coordinates_is_uniform)
{
    static const struct {
        const char *text;
        bool uniform;
    } rows[] = {{"-9.81", true}, {"2*pi", true},      {"sin(t)+t^2", true},
                {"x", false},    {"0*x-9.81", false}, {"t*y", false}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        const double place[2] = {2.0, 3.0};
        struct mpm_expression *one = NULL;
        ck_assert_int_eq(mpm_expression_create(rows[k].text, PLANAR, true, 2, &one, NULL), MPM_OK);
        ck_assert_msg(mpm_expression_is_uniform(one) == rows[k].uniform, "%s", rows[k].text);
        ck_assert(mpm_expression_value(one, 0, place, 1.5) ==
                  mpm_expression_value(one, 1, place, 1.5));
        mpm_expression_free(one);
    }
}
END_TEST

START_TEST(freeing_no_expression_is_fine)
{
    mpm_expression_free(NULL);
}
END_TEST

#define COUNT(table) ((int)(sizeof(table) / sizeof *(table)))

Suite *suite_expression(void)
{
    Suite *suite = suite_create("expression");
    TCase *number = tcase_create("numbers");
    tcase_add_loop_test(number, a_number_is_read_in_every_spelling, 0, COUNT(numbers));
    tcase_add_loop_test(number, a_text_that_is_no_number_is_refused, 0, COUNT(no_numbers));
    tcase_add_test(number, a_locale_with_a_decimal_comma_changes_no_number);
    suite_add_tcase(suite, number);
    TCase *value = tcase_create("values");
    tcase_add_loop_test(value, an_expression_has_its_value, 0, COUNT(values));
    tcase_add_test(value, an_expression_may_be_not_finite);
    tcase_add_test(value, an_expression_without_coordinates_is_uniform);
    tcase_add_test(value, each_worker_evaluates_at_its_own_place);
    suite_add_tcase(suite, value);
    TCase *error = tcase_create("errors");
    tcase_add_loop_test(error, a_mistake_is_reported_with_its_column, 0, COUNT(mistakes));
    tcase_add_test(error, time_is_unknown_where_it_has_no_meaning);
    tcase_add_test(error, an_expression_of_4096_characters_is_the_longest);
    tcase_add_test(error, a_mistake_in_a_long_expression_has_its_column);
    tcase_add_test(error, a_deeply_nested_expression_has_its_value);
    tcase_add_test(error, freeing_no_expression_is_fine);
    suite_add_tcase(suite, error);
    return suite;
}
