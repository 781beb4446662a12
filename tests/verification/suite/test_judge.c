/* Verdicts, bands and margins; the judge of a job's rows and its proof that each check
 * can fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/common/rows.h"
#include "verification/measures/verdict.h"
#include "verification/suite/judge.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const struct verdict_band plain = {.expected = 1.1, .low = 0.05, .high = 2};
static const struct verdict_band negative = {.expected = -3, .low = -4, .high = -2};
static const struct verdict_band round_off = {.expected = 1e-15, .low = 1e-18, .high = 1e-12};
static const struct verdict_band weak = {
    .expected = 90, .low = 86, .high = 95, .weakness = true, .fails_low = 40, .fails_high = 50};
static const struct verdict_band started = {
    .expected = 90, .low = 86, .high = 95, .has_initial = true, .initial = 100};
static const struct verdict_band *const bands[] = {&plain, &negative, &round_off, &weak, &started};

START_TEST(a_value_gets_the_status_that_its_band_says)
{
    const struct {
        const struct verdict_band *band;
        double value;
        enum verdict_status status;
    } table[] = {
        {&plain, 1.1, VERDICT_PASS},
        {&plain, 0.05, VERDICT_PASS}, /* edges are inside */
        {&plain, 2, VERDICT_PASS},
        {&plain, nextafter(2, 3), VERDICT_FAIL},
        {&plain, nextafter(0.05, 0), VERDICT_FAIL},
        {&plain, -1.1, VERDICT_FAIL},
        {&plain, 0, VERDICT_FAIL},
        {&plain, (double)NAN, VERDICT_ERROR},
        {&plain, (double)INFINITY, VERDICT_ERROR},
        {&plain, -(double)INFINITY, VERDICT_ERROR},
        {&negative, -2, VERDICT_PASS},
        {&negative, 2, VERDICT_FAIL},
        {&round_off, 0, VERDICT_FAIL},
        {&weak, 45, VERDICT_EXPECTED_FAIL},
        {&weak, 40, VERDICT_EXPECTED_FAIL},
        {&weak, 50, VERDICT_EXPECTED_FAIL},
        {&weak, 90, VERDICT_UNEXPECTED_PASS},
        {&weak, 86, VERDICT_UNEXPECTED_PASS},
        {&weak, 60, VERDICT_FAIL},
        {&weak, 99, VERDICT_FAIL},
        {&weak, (double)NAN, VERDICT_ERROR},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct verdict verdict = verdict_judge(table[i].band, table[i].value);
        ck_assert_msg(verdict.status == table[i].status, "row %zu: %s", i,
                      verdict_status_name(verdict.status));
        ck_assert_int_eq(verdict.has_margin, isfinite(table[i].value) != 0);
        /* all but a pass states why */
        ck_assert_int_eq(verdict.status == VERDICT_PASS, verdict.reason[0] == '\0');
    }
}
END_TEST

START_TEST(a_margin_is_one_in_the_middle_zero_on_an_edge_and_negative_outside)
{
    const double round = 1e-14; /* a few units of round-off of numbers near one */
    for (size_t i = 0; i < G_N_ELEMENTS(bands); i++) {
        const double low = bands[i]->low, high = bands[i]->high;
        const double wide = fmax(fabs(low), fabs(high)) >= 10 * fmin(fabs(low), fabs(high));
        const double middle = wide > 0 ? copysign(sqrt(low * high), low) : 0.5 * (low + high);
        ck_assert_double_eq_tol(verdict_margin(low, high, middle), 1, round);
        ck_assert_double_eq_tol(verdict_margin(low, high, low), 0, round);
        ck_assert_double_eq_tol(verdict_margin(low, high, high), 0, round);
        ck_assert_double_lt(verdict_margin(low, high, high + (high - low)), 0);
        ck_assert_double_lt(verdict_margin(low, high, low - (high - low)), 0);
    }
    ck_assert_double_lt(verdict_margin(1e-18, 1e-12, 0), 0);
}
END_TEST

START_TEST(a_status_has_a_name_and_only_pass_skip_and_expected_fail_are_not_red)
{
    for (int i = 0; i < VERDICT_STATUS_COUNT; i++) {
        const enum verdict_status status = (enum verdict_status)i;
        const bool green =
            status == VERDICT_PASS || status == VERDICT_SKIP || status == VERDICT_EXPECTED_FAIL;
        ck_assert_int_eq(verdict_status_find(verdict_status_name(status)), i);
        ck_assert_int_eq(verdict_is_red(status), !green);
    }
    ck_assert_int_eq(verdict_status_find("passed"), VERDICT_STATUS_COUNT);
}
END_TEST

START_TEST(a_band_by_which_a_check_could_not_fail_is_refused)
{
    const struct {
        struct verdict_band band;
        const char *fault;
    } table[] = {
        {{.expected = 0.1, .low = 0, .high = 1}, "holds zero"},
        {{.expected = 0.1, .low = -1, .high = 1}, "holds zero"},
        {{.expected = -0.1, .low = -1, .high = 0}, "holds zero"},
        {{.expected = 1, .low = 2, .high = 1}, "low must be less"},
        {{.expected = 1, .low = 1, .high = 1}, "low must be less"},
        {{.expected = 3, .low = 1, .high = 2}, "expected must lie"},
        {{.expected = 1, .low = 1, .high = (double)INFINITY}, "finite"},
        {{.expected = (double)NAN, .low = 1, .high = 2}, "finite"},
        {{.expected = 1, .low = 1, .high = 2, .has_initial = true, .initial = 2}, "initial value"},
        {{1, 1, 2, true, -1, 0.5, false, 0}, "weakness holds zero"},
        {{1, 1, 2, true, 2, 3, false, 0}, "must not overlap"},
        {{1, 1, 2, true, 0.1, 10, false, 0}, "must not overlap"},
        {{1, 1, 2, true, 5, 4, false, 0}, "fails_low must be less"},
        {{1, 1, 2, true, 4, 6, true, 5}, "initial value"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const char *fault = verdict_band_fault(&table[i].band);
        ck_assert_msg(fault != NULL && strstr(fault, table[i].fault) != NULL, "row %zu: %s", i,
                      fault == NULL ? "accepted" : fault);
    }
    for (size_t i = 0; i < G_N_ELEMENTS(bands); i++)
        ck_assert_ptr_null(verdict_band_fault(bands[i]));
}
END_TEST

START_TEST(every_mutation_turns_every_band_red)
{
    for (size_t i = 0; i < G_N_ELEMENTS(bands); i++)
        for (int m = 0; m < VERDICT_MUTATION_COUNT; m++) {
            double value;
            const char *name;
            if (verdict_mutation_value(bands[i], (enum verdict_mutation)m, &value, &name))
                ck_assert_msg(verdict_is_red(verdict_judge(bands[i], value).status), "%s", name);
        }
}
END_TEST

/* ------------------------------------------------------------ rows of a job */

static char quantity[] = "spread";

static struct case_check check_with(const struct verdict_band *band)
{
    return (struct case_check){.quantity = quantity, .band = *band};
}

static const char end_row[] = "{\"kind\":\"end\",\"name\":\"\",\"text\":\"\"}\n";

/* The verdict on rows of a program that returned 0. */
static struct check_verdict judge_text(const char *rows, bool with_end)
{
    const struct case_check check = check_with(&plain);
    char *text = g_strconcat(rows, with_end ? end_row : "", NULL);
    const struct job_result result = {JOB_RETURNED, 0, 0.1, 10, text};
    const struct check_verdict judged = judge_check_with_proof(&check, &result);
    g_free(text);
    return judged;
}

START_TEST(rows_are_judged_by_what_they_say)
{
    const struct {
        const char *rows;
        bool end;
        enum verdict_status status;
        const char *reason;
    } table[] = {
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5\"}\n", true, VERDICT_PASS, ""},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"3\"}\n", true, VERDICT_FAIL, "above"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"nan\"}\n", true, VERDICT_ERROR,
         "not a number"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"-inf\"}\n", true, VERDICT_ERROR,
         "infinite"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5 %\"}\n", true, VERDICT_ERROR,
         "is not a number"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"\"}\n", true, VERDICT_ERROR,
         "is not a number"},
        {"{\"kind\":\"value\",\"name\":\"other\",\"text\":\"1.5\"}\n", true, VERDICT_ERROR,
         "not reported"},
        {"", true, VERDICT_ERROR, "not reported"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5\"}\n", false, VERDICT_ERROR,
         "cut short"},
        {"{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5\"}\n"
         "{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5\"}\n",
         true, VERDICT_ERROR, "reported 2 times"},
        {"{\"kind\":\"value\",\"name\":\"spr", false, VERDICT_ERROR, "line 1"},
        {"{\"kind\":\"verdict\",\"name\":\"spread\",\"text\":\"pass\"}\n", true, VERDICT_ERROR,
         "line 1"},
        {"{\"kind\":\"skip\",\"name\":\"\",\"text\":\"no tool\"}\n", true, VERDICT_SKIP, "no tool"},
        {"{\"kind\":\"inconclusive\",\"name\":\"spread\",\"text\":\"run too short\"}\n", true,
         VERDICT_INCONCLUSIVE, "run too short"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct check_verdict judged = judge_text(table[i].rows, table[i].end);
        ck_assert_msg(judged.verdict.status == table[i].status, "row %zu: %s", i,
                      verdict_status_name(judged.verdict.status));
        ck_assert_msg(strstr(judged.verdict.reason, table[i].reason) != NULL, "row %zu: %s", i,
                      judged.verdict.reason);
        ck_assert_uint_eq(judged.mutations, judged.mutations_red);
        ck_assert_uint_ge(judged.mutations, 10);
    }
}
END_TEST

START_TEST(a_job_that_did_not_end_well_has_no_value_however_good_its_rows_are)
{
    const struct {
        enum job_outcome outcome;
        int code;
        enum verdict_status status;
        const char *reason;
    } table[] = {
        {JOB_CRASHED, 11, VERDICT_ERROR, "signal 11"},
        {JOB_TIMED_OUT, 0, VERDICT_TIMEOUT, "time-out of 10 s"},
        {JOB_RETURNED, 3, VERDICT_ERROR, "status 3: went wrong"},
        {JOB_NOT_RUN, 0, VERDICT_ERROR, "not run"},
    };
    char *rows = g_strconcat("{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"1.5\"}\n",
                             "{\"kind\":\"failure\",\"name\":\"\",\"text\":\"went wrong\"}\n",
                             end_row, NULL);
    const struct case_check check = check_with(&plain);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        const struct job_result result = {table[i].outcome, table[i].code, 0.1, 10, rows};
        const struct check_verdict judged = judge_check(&check, &result);
        ck_assert_int_eq(judged.verdict.status, table[i].status);
        ck_assert_ptr_nonnull(strstr(judged.verdict.reason, table[i].reason));
        ck_assert(!judged.has_value);
    }
    g_free(rows);
}
END_TEST

START_TEST(a_check_that_accepts_zero_is_found_out_by_the_proof)
{
    const struct verdict_band blind = {.expected = 0.5, .low = -1, .high = 1};
    const struct case_check check = check_with(&blind);
    char *rows =
        g_strconcat("{\"kind\":\"value\",\"name\":\"spread\",\"text\":\"0.5\"}\n", end_row, NULL);
    const struct job_result result = {JOB_RETURNED, 0, 0.1, 10, rows};
    ck_assert_int_eq(judge_check(&check, &result).verdict.status, VERDICT_PASS);
    const struct check_verdict judged = judge_check_with_proof(&check, &result);
    ck_assert_int_eq(judged.verdict.status, VERDICT_ERROR);
    ck_assert_str_eq(judged.verdict.reason, "cannot fail: zero in place of the result gave pass");
    ck_assert_uint_eq(judged.mutations_red, judged.mutations - 1);
    g_free(rows);
}
END_TEST

START_TEST(values_survive_the_way_through_a_row)
{
    const double values[] = {1.1, -1e-300, 5e-324, 1.7976931348623157e308, 0.1 + 0.2};
    for (size_t i = 0; i < G_N_ELEMENTS(values); i++) {
        char *line = row_line_value("q \"\\ \n é", values[i]);
        unsigned bad_line;
        GArray *rows = rows_parse(line, &bad_line);
        double value;
        ck_assert_ptr_nonnull(rows);
        ck_assert_uint_eq(rows->len, 1);
        ck_assert_str_eq(g_array_index(rows, struct row, 0).name, "q \"\\ \n é");
        ck_assert(row_number(g_array_index(rows, struct row, 0).text, &value));
        ck_assert_double_eq(value, values[i]);
        g_array_unref(rows);
        g_free(line);
    }
}
END_TEST

Suite *suite_judge(void)
{
    Suite *suite = suite_create("judge");
    TCase *verdicts = tcase_create("verdicts");
    tcase_add_test(verdicts, a_value_gets_the_status_that_its_band_says);
    tcase_add_test(verdicts, a_margin_is_one_in_the_middle_zero_on_an_edge_and_negative_outside);
    tcase_add_test(verdicts, a_status_has_a_name_and_only_pass_skip_and_expected_fail_are_not_red);
    tcase_add_test(verdicts, a_band_by_which_a_check_could_not_fail_is_refused);
    tcase_add_test(verdicts, every_mutation_turns_every_band_red);
    suite_add_tcase(suite, verdicts);
    TCase *rows = tcase_create("rows");
    tcase_add_test(rows, rows_are_judged_by_what_they_say);
    tcase_add_test(rows, a_job_that_did_not_end_well_has_no_value_however_good_its_rows_are);
    tcase_add_test(rows, a_check_that_accepts_zero_is_found_out_by_the_proof);
    tcase_add_test(rows, values_survive_the_way_through_a_row);
    suite_add_tcase(suite, rows);
    return suite;
}
