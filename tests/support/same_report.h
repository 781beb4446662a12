/* Reports that differ in times alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SAME_REPORT_H
#define TESTS_SUPPORT_SAME_REPORT_H

/* Fails the test if the results of two output folders differ in more than times, peak memory and
 * the command. */
void test_assert_same_report(const char *one, const char *other);

#endif
