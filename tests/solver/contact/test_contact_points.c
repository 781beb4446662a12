/* What a simulation reports of contact at nodes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdlib.h>

enum { AXES = 2 };

static const char BLOCKS[] = TEST_BLOCK_SCENE(
    "{end: 1000, step: 0.1}",
    "{name: rubber, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}",
    "  - {name: low, material: rubber, region: {rectangle: {from: [3, 3.2], to: [8, 5.6]}}}\n"
    "  - {name: high, material: rubber, region: {rectangle: {from: [3, 5.6], to: [8, 8]}}}\n"
    "contact: {fields: bodies, pairs: [{of: [high, low], law: frictionless}]}\n");

/* Sums of some ten particles at places of order 10. */
static const double ROUND_OFF = 1e-12;

/* A row of particles is 0.4 high, half a cell. */
START_TEST(points_of_contact_have_the_normal_gap_and_area_of_the_surfaces)
{
    const double gap = _i == 0 ? 0.0 : 0.4;
    const char *const settings[] = {_i == 0 ? "bodies.high.region.rectangle.from=[3, 5.6]"
                                            : "bodies.high.region.rectangle.from=[3, 6]",
                                    NULL};
    struct test_run run = test_run_open(BLOCKS, settings, 1);
    ck_assert_uint_eq(mpm_simulation_contact_point_count(run.simulation), 0);
    test_run_steps(&run, 1);
    const size_t count = mpm_simulation_contact_point_count(run.simulation);
    double area = 0.0;
    ck_assert_uint_gt(count, 0);
    for (size_t k = 0; k < count; k++) {
        const struct mpm_contact_point point = mpm_simulation_contact_point(run.simulation, k);
        ck_assert(point.of[0] == 0 && point.of[1] == 1 && point.has_normal && point.touches);
        ck_assert(point.position[0] >= 2.0 && point.position[0] <= 9.0);
        ck_assert_near(fmod(point.position[1] + 0.4, 0.8), 0.4, ROUND_OFF);
        area += point.area;
        if (point.position[0] < 3.5 || point.position[0] > 7.5)
            continue; /* beside corners */
        ck_assert_near(point.normal[0], 0.0, ROUND_OFF);
        ck_assert_near(point.normal[1], 1.0, ROUND_OFF);
        ck_assert_near(point.gap, gap, ROUND_OFF);
    }
    if (_i == 0)
        ck_assert_near(area, 5.0, ROUND_OFF);
    test_run_close(&run);
}
END_TEST

/* -------------------------------------------------- r = 0, planes of symmetry */

/* Two cylinders from r = 0 on, one on the other; or blocks. Without Poisson's effect they stay
 * straight. */
static const char CYLINDERS[] = TEST_BLOCK_SCENE(
    "{end: 1000, step: 0.1}",
    "{name: rubber, law: linear_elastic, density: 1, bulk: 0.5, shear: 0.75}",
    "  - {name: low, material: rubber, region: {rectangle: {from: [0, 3.2], to: [5, 5.6]}}}\n"
    "  - {name: high, material: rubber, region: {rectangle: {from: [0, 5.6], to: [5, 8]}}}\n"
    "contact: {fields: bodies, pairs: [{of: [low, high], law: frictionless, normal: given,\n"
    "  direction: [0, 1]}]}\n");

/* A node there sees half of a cell along r, and two bodies that meet fill what it sees. A gap of
 * half a cell leaves a quarter of that empty, or more. */
START_TEST(at_the_edge_of_the_model_bodies_touch_that_fill_what_a_node_sees)
{
    static const char *const edges[] = {
        "geometry=axisymmetric",
        "boundary=[{region: {line: {from: [0, 0], to: [0, 12]}}, symmetry: true}]"};
    const bool apart = _i >= 2 * TEST_SHAPES;
    struct settings settings = {.count = 0};
    size_t at_edge = 0;
    settings_add(&settings, edges[_i / TEST_SHAPES % 2]);
    settings_add_formatted(&settings, "method.shape=%s", test_shapes[_i % TEST_SHAPES]);
    settings_add(&settings, "contact.detection=volume");
    if (apart)
        settings_add(&settings, "bodies.high.region.rectangle.from=[0, 6]");
    struct test_run run = test_run_open(CYLINDERS, settings.texts, 1);
    test_run_steps(&run, 1);
    for (size_t k = 0; k < mpm_simulation_contact_point_count(run.simulation); k++) {
        const struct mpm_contact_point point = mpm_simulation_contact_point(run.simulation, k);
        if (point.position[0] < -ROUND_OFF || point.position[0] > 3.5 ||
            fabs(point.position[1] - 5.6) > ROUND_OFF)
            continue; /* beyond the plane; beside the rim; where splines see little of the gap */
        ck_assert_msg(point.touches == !apart, "x = %g, y = %g", point.position[0],
                      point.position[1]);
        at_edge += fabs(point.position[0]) < ROUND_OFF;
    }
    ck_assert(at_edge > 0);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

/* Of velocities of 1e-5 of which the interface takes some 1e-6. The fit of displacements takes a
 * part of a gradient from strains, more at edges: 1e-12, 2e-8 with splines. (Where strains are of
 * another time than places, MUSL and USAVG, it is a hundredth of the force.) */
static const double EVEN = 1e-7;

/* Whatever the functions, a node's area is to its mass as those of its neighbours are, so that a
 * jump that is everywhere the same accelerates a row of particles alike, from r = 0 to the rim.
 * Strains are 1e-5, and their squares, by which a linear law widens, are nothing. */
START_TEST(an_interface_pulls_evenly_from_the_axis_to_the_rim)
{
    static const char *const orders[] = {"usl", "usf"};
    struct settings settings = {.count = 0};
    size_t count;
    settings_add(&settings, "geometry=axisymmetric");
    settings_add_formatted(&settings, "method={shape: %s, stress_update: %s}",
                           test_shapes[_i % TEST_SHAPES], orders[_i / TEST_SHAPES]);
    settings_add(&settings, "contact.pairs.0={of: [low, high], law: interface, tension: 2, "
                            "shear: 1, normal: given, direction: [0, 1]}");
    settings_add(&settings, "bodies.low.velocity=[0, -2e-5]");
    settings_add(&settings, "bodies.high.velocity=[0, 3e-5]");
    struct test_run run = test_run_open(CYLINDERS, settings.texts, 1);
    test_run_steps(&run, 6);
    double *const place = test_run_field(&run, MPM_FIELD_POSITION, &count);
    double *const velocity = test_run_field(&run, MPM_FIELD_VELOCITY, &count);
    double slowest = HUGE_VAL;
    for (size_t p = 0; p < count; p++) {
        slowest = fmin(slowest, fabs(velocity[AXES * p + 1]));
        ck_assert_near(velocity[AXES * p], 0.0, EVEN);
        for (size_t q = 0; q < count; q++)
            if (fabs(place[AXES * q + 1] - place[AXES * p + 1]) < 0.01)
                ck_assert_near(velocity[AXES * q + 1], velocity[AXES * p + 1], EVEN);
    }
    ck_assert(slowest < 1.8e-5); /* the interface has begun to hold the faces */
    free(place);
    free(velocity);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

Suite *suite_contact_points(void)
{
    Suite *suite = suite_create("contact_points");
    TCase *points = tcase_create("points");
    tcase_add_loop_test(points, points_of_contact_have_the_normal_gap_and_area_of_the_surfaces, 0,
                        2);
    tcase_add_loop_test(points, at_the_edge_of_the_model_bodies_touch_that_fill_what_a_node_sees, 0,
                        4 * TEST_SHAPES);
    tcase_add_loop_test(points, an_interface_pulls_evenly_from_the_axis_to_the_rim, 0,
                        2 * TEST_SHAPES);
    suite_add_tcase(suite, points);
    return suite;
}
