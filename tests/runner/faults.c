/* Tests that end in every way there is, each between two that hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/skip.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

static int runs; /* of a test in this process */

START_TEST(holds)
{
    ck_assert_int_ge(_i, 0);
}
END_TEST

START_TEST(hangs)
{
    while (_i >= 0)
        (void)pause();
}
END_TEST

START_TEST(crashes_the_third_time)
{
    ck_assert(_i < 3);
    if (_i == 2)
        (void)raise(SIGSEGV);
}
END_TEST

START_TEST(leaks)
{
    void *volatile memory = malloc(100);
    ck_assert_ptr_nonnull(memory);
    memory = NULL;
}
END_TEST

START_TEST(leaves)
{
    exit(EXIT_SUCCESS);
}
END_TEST

START_TEST(fails)
{
    ck_assert_int_eq(_i, 1);
}
END_TEST

START_TEST(is_the_first_here)
{
    ck_assert_int_eq(runs++, 0);
}
END_TEST

START_TEST(skips)
{
    TEST_SKIP("has a reason");
}
END_TEST

#define FAULT(name, test, times)                                                                   \
    Suite *suite_##name(void)                                                                      \
    {                                                                                              \
        Suite *suite = suite_create(#name);                                                        \
        TCase *tests = tcase_create(#name);                                                        \
        tcase_add_test(tests, holds);                                                              \
        tcase_add_loop_test(tests, test, 0, times);                                                \
        tcase_add_test(tests, skips);                                                              \
        tcase_add_test(tests, holds);                                                              \
        suite_add_tcase(suite, tests);                                                             \
        return suite;                                                                              \
    }

FAULT(hang, hangs, 1)
FAULT(crash, crashes_the_third_time, 3)
FAULT(leak, leaks, 1)
FAULT(leave, leaves, 1)
FAULT(fail, fails, 1)
FAULT(order, is_the_first_here, 2)
FAULT(fresh, is_the_first_here, 2)
FAULT(good, holds, 1)
