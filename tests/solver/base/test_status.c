/* The status and error idiom.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "suites.h"

#include <string.h>

START_TEST(an_error_carries_status_and_message)
{
    struct mpm_error error = {0};
    ck_assert_int_eq(mpm_error_set(&error, MPM_BAD_INPUT, "grid.cell: %g", -1.0), MPM_BAD_INPUT);
    ck_assert_int_eq(error.status, MPM_BAD_INPUT);
    ck_assert_str_eq(error.message, "grid.cell: -1");
}
END_TEST

START_TEST(a_message_is_one_line_whatever_it_quotes)
{
    struct mpm_error error = {0};
    (void)mpm_error_set(&error, MPM_BAD_INPUT, "%s", "a\nb\tc\x1b[2Jd\x7f");
    ck_assert_str_eq(error.message, "a?b?c?[2Jd?");
}
END_TEST

START_TEST(a_message_that_is_too_long_is_cut_and_ended)
{
    struct mpm_error error = {0};
    char text[2 * MPM_MESSAGE_SIZE];
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    (void)mpm_error_set(&error, MPM_RUN_FAILED, "%s", text);
    ck_assert_uint_eq(strlen(error.message), MPM_MESSAGE_SIZE - 1);
}
END_TEST

START_TEST(a_caller_may_leave_the_error_out)
{
    ck_assert_int_eq(mpm_error_set(NULL, MPM_RUN_FAILED, "step %d", 3), MPM_RUN_FAILED);
    ck_assert_int_eq(mpm_error_memory(NULL, 8, "nodes"), MPM_ENVIRONMENT_FAILED);
}
END_TEST

START_TEST(out_of_memory_names_the_bytes_and_their_use)
{
    struct mpm_error error = {0};
    ck_assert_int_eq(mpm_error_memory(&error, 4096, "nodes"), MPM_ENVIRONMENT_FAILED);
    ck_assert_ptr_nonnull(strstr(error.message, "4096"));
    ck_assert_ptr_nonnull(strstr(error.message, "nodes"));
}
END_TEST

static int steps_taken;

static enum mpm_status take_step(enum mpm_status status)
{
    steps_taken++;
    return status;
}

static enum mpm_status three_steps(enum mpm_status second)
{
    MPM_TRY(take_step(MPM_OK));
    MPM_TRY(take_step(second));
    MPM_TRY(take_step(MPM_OK));
    return MPM_OK;
}

START_TEST(the_first_failure_is_passed_up_and_ends_the_caller)
{
    steps_taken = 0;
    ck_assert_int_eq(three_steps(MPM_RUN_FAILED), MPM_RUN_FAILED);
    ck_assert_int_eq(steps_taken, 2);
    ck_assert_int_eq(three_steps(MPM_OK), MPM_OK);
    ck_assert_int_eq(steps_taken, 5);
}
END_TEST

Suite *suite_status(void)
{
    Suite *suite = suite_create("status");
    TCase *tests = tcase_create("status");
    tcase_add_test(tests, an_error_carries_status_and_message);
    tcase_add_test(tests, a_message_is_one_line_whatever_it_quotes);
    tcase_add_test(tests, a_message_that_is_too_long_is_cut_and_ended);
    tcase_add_test(tests, a_caller_may_leave_the_error_out);
    tcase_add_test(tests, out_of_memory_names_the_bytes_and_their_use);
    tcase_add_test(tests, the_first_failure_is_passed_up_and_ends_the_caller);
    suite_add_tcase(suite, tests);
    return suite;
}
