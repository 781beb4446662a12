/* Suites that fail in every way there is: what .ci/check-runner gives to tests/main.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_RUNNER_SUITES_H
#define TESTS_RUNNER_SUITES_H

#include "support/marks.h"

#define SUITES(SUITE, APART)                                                                       \
    SUITE(hang)                                                                                    \
    SUITE(crash)                                                                                   \
    SUITE(leak)                                                                                    \
    SUITE(leave)                                                                                   \
    SUITE(fail)                                                                                    \
    SUITE(order)                                                                                   \
    APART(fresh)                                                                                   \
    SUITE(good)

#define SUITE_DECLARE(name) Suite *suite_##name(void);
SUITES(SUITE_DECLARE, SUITE_DECLARE)
#undef SUITE_DECLARE

#endif
