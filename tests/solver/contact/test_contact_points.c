/* What a simulation reports of contact at nodes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>

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

Suite *suite_contact_points(void)
{
    Suite *suite = suite_create("contact_points");
    TCase *points = tcase_create("points");
    tcase_add_loop_test(points, points_of_contact_have_the_normal_gap_and_area_of_the_surfaces, 0,
                        2);
    suite_add_tcase(suite, points);
    return suite;
}
