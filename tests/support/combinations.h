/* What most tests of the step loop over: every family of shape functions in every geometry with
 * every order of the stress update, by the names that scenes give them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_COMBINATIONS_H
#define TESTS_SUPPORT_COMBINATIONS_H

#include "mpm.h"
#include "support/settings.h"

#include <stdbool.h>

enum {
    TEST_SHAPES = MPM_SHAPE_COUNT,
    TEST_GEOMETRIES = 3,
    TEST_ORDERS = 4,
    TEST_COMBINATIONS = TEST_SHAPES * TEST_GEOMETRIES * TEST_ORDERS,
};
/* In the order of enum mpm_shape, mpm_geometry and mpm_stress_update. */
extern const char *const test_shapes[TEST_SHAPES];
extern const char *const test_geometry_names[TEST_GEOMETRIES];
extern const char *const test_orders[TEST_ORDERS];

/* How particles and grid exchange, and what damps: settings of one key each. */
enum { TEST_EXCHANGES = 6 };
extern const char *const test_exchanges[TEST_EXCHANGES];

struct test_combination {
    const char *shape, *geometry, *order;
    bool axisymmetric;
    /* Classic functions under USL make any round-off grow without bound (nodes of little mass at
     * the edge): theirs is shown by the catalogue, case E1. */
    bool amplifies_round_off;
};

/* Number `index`: shapes first, then geometries, then orders, then all over again. */
struct test_combination test_combination(int index);

/* What makes a scene one of that combination, to be cleared. */
struct settings test_combination_settings(int index);

/* Velocities of bodies.block that vary within a cell, up to 0.4. */
void test_add_wild_velocity(struct settings *settings, bool axisymmetric);

#endif
