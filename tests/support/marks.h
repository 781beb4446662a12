/* Check, with marks only where somebody reads them. An assertion that holds sends a message with
 * its place, for the report of a test that ends its process before the next one. The message costs
 * more than most assertions; tests that share a process are run again before anything is reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_MARKS_H
#define TESTS_SUPPORT_MARKS_H

#include <check.h>
#include <stdbool.h>

extern bool test_marks_wanted;

#define _mark_point(file, line) (test_marks_wanted ? _mark_point(file, line) : (void)0)

#endif
