/* Rigid bodies in contact: what does not depend on how a scene is written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/settings.h"

#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STEPS = 8 };

#define RUBBER        "{name: rubber, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}"
#define SCENE(bodies) TEST_BLOCK_SCENE("{end: 1000, step: 0.1}", RUBBER, bodies)
#define BODY(name, region, velocity)                                                               \
    "  - {name: " name ", material: rubber, velocity: " velocity ", region: {rectangle: " region   \
    "}}\n"
#define RIGID(name, region, velocity)                                                              \
    "  - {name: " name ", rigid: {velocity: " velocity "}, region: {rectangle: " region "}}\n"

/* Sums at nodes are those of other particles first; contact passes on what they differ by. */
static const double ROUND_OFF = 1e-10;

/* Where the particles of two runs begin, and how far their velocities are apart at the end; the
 * second run is the first one's mirror image in y = height / 2, or the same for a height of 0. */
static void assert_same(struct test_run *one, struct test_run *other, double height)
{
    const double sign = height > 0.0 ? -1.0 : 1.0;
    size_t count, many, found = 0;
    double *const from = test_run_field(one, MPM_FIELD_POSITION, &count);
    double *const to = test_run_field(other, MPM_FIELD_POSITION, &many);
    test_run_steps(one, STEPS);
    test_run_steps(other, STEPS);
    double *const v = test_run_field(one, MPM_FIELD_VELOCITY, NULL);
    double *const w = test_run_field(other, MPM_FIELD_VELOCITY, NULL);
    ck_assert_uint_eq(count, many);
    for (size_t k = 0; k < AXES * count; k += AXES)
        for (size_t j = 0; j < AXES * count; j += AXES) {
            if (hypot(from[k] - to[j], height + sign * from[k + 1] - to[j + 1]) > 1e-6)
                continue;
            found++;
            ck_assert_near(w[j], v[k], ROUND_OFF);
            ck_assert_near(w[j + 1], sign * v[k + 1], ROUND_OFF);
        }
    ck_assert_uint_eq(found, count);
    free(from);
    free(to);
    free(v);
    free(w);
}

/* A floor that turns, and goes through a plane of symmetry; and its mirror image. */
#define PLANE(place)                                                                               \
    "boundary: [{region: {line: {from: [0, " place "], to: [14, " place "]}}, symmetry: true}]\n"
static const char ABOVE[] =
    SCENE(BODY("block", "{from: [3, 3.2], to: [9, 6.4]}", "['0.1*sin(x)', '-0.2+0.1*(y-5)']")
              RIGID("floor", "{from: [1, 2.4], to: [12, 3.2]}", "['-0.02*(y-4)', '-0.02*(x-4)']"))
        PLANE("2.4");
static const char BELOW[] =
    SCENE(BODY("block", "{from: [3, 5.6], to: [9, 8.8]}", "['0.1*sin(x)', '0.2+0.1*(y-7)']")
              RIGID("floor", "{from: [1, 8.8], to: [12, 9.6]}", "['-0.02*(8-y)', '0.02*(x-4)']"))
        PLANE("9.6");
static const double HEIGHT = 12.0; /* of the grid */

START_TEST(a_rigid_body_across_a_plane_of_symmetry_has_a_mirror_image)
{
    static const char *const shapes[] = {"ugimp", "cpdi", "bspline2", "bspline3"};
    static const char *const normals[] = {"average", "larger", "linear"};
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", shapes[_i % 4]);
    settings_add_formatted(
        &settings,
        "contact={pairs: [{of: [rubber, floor], law: friction, friction: 0.3, normal: %s}]}",
        normals[_i / 4]);
    struct test_run one = test_run_open(ABOVE, settings.texts, 1);
    struct test_run other = test_run_open(BELOW, settings.texts, 1);
    assert_same(&one, &other, HEIGHT);
    settings_clear(&settings);
    test_run_close(&one);
    test_run_close(&other);
}
END_TEST

/* The rigid body touches `right` and drives `left`, which a crack cuts. */
#define LEFT  BODY("left", "{from: [2, 2.4], to: [4, 5.6]}", "[0, 0]")
#define RIGHT BODY("right", "{from: [4, 2.4], to: [6, 5.6]}", "[0, 0]")
#define FLOOR RIGID("floor", "{from: [2, 1.6], to: [6, 2.4]}", "[0.025, 0.01]")
#define CUT                                                                                        \
    "cracks: [{points: [[2.4, 4.4], [3.6, 4.5]], touching: 2}]\n"                                  \
    "contact: {fields: bodies, pairs: [{of: [left, right], law: stick}, "                          \
    "{of: [right, floor], law: bonded}]}\n"
static const char LEFT_FIRST[] = SCENE(LEFT RIGHT FLOOR) CUT;
static const char RIGHT_FIRST[] = SCENE(FLOOR RIGHT LEFT) CUT;

START_TEST(a_rigid_body_drives_the_same_bodies_whichever_a_crack_cuts)
{
    struct test_run one = test_run_open(LEFT_FIRST, NULL, 1);
    struct test_run other = test_run_open(RIGHT_FIRST, NULL, 1);
    assert_same(&one, &other, 0.0);
    test_run_close(&one);
    test_run_close(&other);
}
END_TEST

/* A tool that has contact with one body and drives the other: nodes that the first one alone has
 * reached are driven once the second one reaches them. Steps that are taken again from the start
 * see whether a step leaves anything behind. */
#define DRIVEN_BESIDE_CONTACT                                                                      \
    "format: 1\ngeometry: plane_strain\ngrid: {cell: [1, 1], cells: [13, 12]}\n"                   \
    "time: {end: 100, step: 0.1}\nmethod: {shape: ugimp}\n"                                        \
    "materials:\n"                                                                                 \
    "  - {name: driven, law: neo_hookean, density: 0.5, young: 1, poisson: -0.2}\n"                \
    "  - {name: sliding, law: neo_hookean, density: 0.5, bulk: 1, shear: 1}\n"                     \
    "bodies:\n"                                                                                    \
    "  - {name: a, material: driven, region: {rectangle: {from: [8, 3], to: [9.69, 9.69]}},\n"     \
    "     velocity: [\"-0.37+0.073*(x-9)+0.18*(y-6.5)\", \"-0.052*(y-6.5)\"]}\n"                   \
    "  - {name: b, material: sliding,\n"                                                           \
    "     region: {polygon: {points: [[5, 3], [8, 3], [6.863, 6], [5, 6]]}},\n"                    \
    "     velocity: [\"-0.37+0.05*(x-6.5)\", \"-0.37+0.05*(y-4.5)\"]}\n"                           \
    "  - {name: tool, rigid: {velocity: [0.18345, -0.18345]},\n"                                   \
    "     region: {rectangle: {from: [2, 2], to: [10, 3]}}}\n"                                     \
    "contact: {fields: materials, law: stick,\n"                                                   \
    "  pairs: [{of: [sliding, tool], law: frictionless}]}\n"

START_TEST(a_step_leaves_nothing_of_what_a_tool_drives)
{
    enum { TAKEN = 16, ROOM = 1000 };
    static double before[ROOM], after[ROOM];
    struct test_run run = test_run_open(DRIVEN_BESIDE_CONTACT, NULL, 1);
    const size_t count = 2 * mpm_simulation_particle_count(run.simulation);
    ck_assert_uint_le(count, ROOM);
    for (int k = 0; k < TAKEN; k++)
        ck_assert_int_eq(mpm_simulation_advance(run.simulation, 100.0, NULL), MPM_OK);
    mpm_simulation_field(run.simulation, MPM_FIELD_VELOCITY, before);
    mpm_backup_restore(run.simulation, TAKEN);
    mpm_simulation_field(run.simulation, MPM_FIELD_VELOCITY, after);
    for (size_t k = 0; k < count; k++)
        ck_assert_double_eq(after[k], before[k]);
    test_run_close(&run);
}
END_TEST

Suite *suite_rigid_contact(void)
{
    Suite *suite = suite_create("rigid_contact");
    TCase *same = tcase_create("same");
    tcase_add_loop_test(same, a_rigid_body_across_a_plane_of_symmetry_has_a_mirror_image, 0, 12);
    tcase_add_test(same, a_rigid_body_drives_the_same_bodies_whichever_a_crack_cuts);
    tcase_add_test(same, a_step_leaves_nothing_of_what_a_tool_drives);
    suite_add_tcase(suite, same);
    return suite;
}
