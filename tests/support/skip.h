/* Skipping a test, with its reason: Check itself knows only passed and failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SKIP_H
#define TESTS_SUPPORT_SKIP_H

#include <stdbool.h>
#include <stdio.h>

/* Ends the test that it is in; counted as skipped, and the reason is printed.
 * Not after a failed assertion, and not inside a helper function. */
#define TEST_SKIP(reason)                                                                          \
    do {                                                                                           \
        test_skip_record(__func__, reason);                                                        \
        return;                                                                                    \
    } while (0)

/* Is this a build for the thread sanitizer? */
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TEST_UNDER_TSAN true
#endif
#endif
#if defined(__SANITIZE_THREAD__)
#define TEST_UNDER_TSAN true
#endif
#ifndef TEST_UNDER_TSAN
#define TEST_UNDER_TSAN false
#endif

void test_skip_record(const char *test, const char *reason);

/* For main: the number, below 1024, of the run that tests belong to from now on; what a run that is
 * done again has skipped does not count. */
void test_skip_run(int number);
void test_skip_ignore(int number);

/* For main: before the tests; after them, lists the skipped ones, returns how many. */
bool test_skip_open(void);
int test_skip_report(FILE *stream);

#endif
