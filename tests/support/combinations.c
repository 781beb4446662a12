/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/combinations.h"

#include <string.h>

#define NAME(name, shape) [shape] = (name),
const char *const test_shapes[TEST_SHAPES] = {MPM_SHAPES(NAME)};
#undef NAME
const char *const test_geometry_names[TEST_GEOMETRIES] = {"plane_strain", "plane_stress",
                                                          "axisymmetric"};
const char *const test_orders[TEST_ORDERS] = {"usl", "musl", "usf", "usavg"};
const char *const test_exchanges[TEST_EXCHANGES] = {
    "method.transfer={kind: flip, fraction: 0.95}",
    "method.transfer={kind: xpic, order: 3}",
    "method.transfer={kind: fmpm, order: 2}",
    "method.transfer={kind: apic}",
    "method.form=momentum",
    "damping={particle: '0.2+0*x', grid: 0.1}",
};

struct test_combination test_combination(int index)
{
    struct test_combination c = {
        .shape = test_shapes[index % TEST_SHAPES],
        .geometry = test_geometry_names[index / TEST_SHAPES % TEST_GEOMETRIES],
        .order = test_orders[index / TEST_SHAPES / TEST_GEOMETRIES % TEST_ORDERS],
    };
    c.axisymmetric = strcmp(c.geometry, "axisymmetric") == 0;
    c.amplifies_round_off = strcmp(c.shape, "classic") == 0 && strcmp(c.order, "usl") == 0;
    return c;
}

struct settings test_combination_settings(int index)
{
    const struct test_combination c = test_combination(index);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", c.shape);
    settings_add_formatted(&settings, "geometry=%s", c.geometry);
    settings_add_formatted(&settings, "method.stress_update=%s", c.order);
    return settings;
}

void test_add_wild_velocity(struct settings *settings, bool axisymmetric)
{
    settings_add(settings, axisymmetric
                               ? "bodies.block.velocity=['0.3*sin(2*r)*cos(z)', '0.4*cos(r+2*z)']"
                               : "bodies.block.velocity=['0.3*sin(2*x)*cos(y)', '0.4*cos(x+2*y)']");
}
