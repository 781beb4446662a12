/* The bundles of all cases, exported once for the tests of a suite.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_BUNDLES_H
#define TESTS_SUPPORT_BUNDLES_H

#include "verification/score/bundle.h"

/* Their folder, between both of these; for an unchecked fixture. */
extern char *test_bundles;
void test_bundles_export(void);
void test_bundles_remove(void);

/* Reads one of them (bundle_close); the test fails if it cannot be read. */
void test_bundle_open(const char *name, struct bundle *bundle);

#endif
