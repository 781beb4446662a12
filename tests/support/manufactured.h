/* Manufactured problems for tests: every field, law and geometry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_MANUFACTURED_H
#define TESTS_SUPPORT_MANUFACTURED_H

#include "support/combinations.h"
#include "verification/exact/manufactured/manufactured.h"

enum {
    TEST_FIELDS = 5,
    TEST_LAWS = 2,
    TEST_PROBLEMS = TEST_FIELDS * TEST_LAWS * TEST_GEOMETRIES,
};
extern const char *const test_laws[TEST_LAWS];

/* E = 1e7, nu = 0.3, rho = 1000: sqrt(E / rho) = 100 */
#define TEST_DENSITY 1000.0
#define TEST_BULK    (1e7 / 1.2)
#define TEST_SHEAR   (1e7 / 2.6)
#define TEST_MODULUS 1e7

/* Number `index`, fields first, then laws, then geometries. False where the field does not exist
 * in the geometry. */
bool test_problem_at(int index, struct manufactured_problem *problem);

/* The test fails if it is refused. */
struct manufactured_problem test_problem(const char *field, const char *law,
                                         enum mpm_geometry geometry);

#endif
