/* Contact between bodies, one of which has cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/folder.h"
#include "support/kernel_pair.h"
#include "support/near.h"
#include "support/scene_files.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STEPS = 20 };

#define MATERIAL(name) "{name: " name ", law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}"
#define BODY(name, material, region)                                                               \
    "  - {name: " name ", material: " material ", region: {rectangle: " region "}}\n"
#define SCENE(bodies)                                                                              \
    TEST_BLOCK_SCENE("{end: 1000, step: 0.05}", MATERIAL("one") ", " MATERIAL("two"), bodies)

/* Some hundred operations a step on numbers of order 10. */
static const double ROUND_OFF = 1e-11, AMPLIFIED = 1e-5;

/* ----------------------------------------------------------------- identity */

#define LOW  "{from: [3, 2.4], to: [9, 6.4]}"
#define HIGH "{from: [3, 6.4], to: [9, 9.6]}"
static const char JOINED[] = SCENE(BODY("low", "one", LOW) BODY("high", "two", HIGH));
static const char ONE[] = SCENE(BODY("low", "one", LOW) BODY("high", "one", HIGH));

/* More than two cells from the joint: no particle of the other body sees a node past one. */
static const char *const cracks[] = {
    "[{points: [[4.5, 3.9], [7.5, 4.5]], contact: friction, friction: 0.3}]",
    "[{points: [[2, 4.2], [6.3, 4.4]], contact: none}]",
    "[{points: [[5.1, 8.3], [7.2, 8.7]], contact: stick}]", /* of the second field */
};
enum { CRACKS = sizeof cracks / sizeof *cracks };

START_TEST(bonded_materials_with_a_crack_in_one_are_one_cracked_material)
{
    const struct test_combination combination = test_combination(_i);
    const double bound = combination.amplifies_round_off ? AMPLIFIED : ROUND_OFF;
    for (size_t k = 0; k < CRACKS; k++) {
        struct settings settings = test_combination_settings(_i);
        settings_add_formatted(&settings, "cracks=%s", cracks[k]);
        for (int body = 0; body < 2; body++)
            settings_add_formatted(&settings, "bodies.%s.velocity=['0.1*sin(%s)', '-0.1*cos(%s)']",
                                   body == 0 ? "low" : "high", combination.axisymmetric ? "z" : "y",
                                   combination.axisymmetric ? "r" : "x");
        struct test_run one = test_run_open(ONE, settings.texts, 1);
        settings_add(&settings, "contact={law: bonded}");
        struct test_run joined = test_run_open(JOINED, settings.texts, 1);
        test_run_steps(&one, combination.amplifies_round_off ? 5 : STEPS);
        test_run_steps(&joined, combination.amplifies_round_off ? 5 : STEPS);
        ck_assert_uint_gt(mpm_simulation_field_particles(joined.simulation), 0);
        ck_assert_near(test_run_largest_difference(&one, &joined), 0.0, bound);
        settings_clear(&settings);
        test_run_close(&one);
        test_run_close(&joined);
    }
}
END_TEST

/* -------------------------------------------------------------------- a tool */

#define TOOL                                                                                       \
    "  - {name: tool, region: {rectangle: {from: [1, 8], to: [11, 9.2]}}, "                        \
    "rigid: {velocity: [0.1, -0.4]}}\n"
enum { TOOL_PARTICLES = 60 };
static const char UNDER_A_TOOL[] = SCENE(BODY("block", "one", "{from: [3, 3.2], to: [9, 8]}") TOOL);

static struct test_run open_half(int index, const char *law, const char *key, const char *value)
{
    struct settings settings = crack_block_method(index);
    settings_add_formatted(&settings,
                           "contact={pairs: [{of: [one, tool], %s, normal: given, "
                           "direction: [0, 1]}]}",
                           law);
    settings_add(&settings, "time={end: 1000, step: 0.02}");
    settings_add(&settings, "bodies.block.velocity=['0.3*sin(2*y)+0.1*x', '0.4*cos(x)+0.1*y']");
    settings_add_formatted(&settings, "%s%s", key, value);
    struct test_run run = test_run_open(UNDER_A_TOOL, settings.texts, 1);
    settings_clear(&settings);
    return run;
}

/* Of both halves, one after the other, in the whole: how far they are from it. */
static double largest_apart(const struct test_run *whole, const struct crack_block_start *start,
                            const struct test_run *half, const struct crack_block_start *other,
                            size_t *found)
{
    double *const a = test_run_field(whole, MPM_FIELD_VELOCITY, NULL);
    double *const b = test_run_field(half, MPM_FIELD_VELOCITY, NULL);
    double largest = 0.0;
    for (size_t k = 0; k < start->count; k++)
        for (size_t j = 0; j < other->count; j++) {
            const double *const one = start->place + AXES * k, *const two = other->place + AXES * j;
            if (fabs(one[0] - two[0]) + fabs(one[1] - two[1]) > 1e-6)
                continue;
            ++*found;
            for (size_t axis = 0; axis < AXES; axis++)
                largest = fmax(largest, fabs(a[AXES * k + axis] - b[AXES * j + axis]));
        }
    free(a);
    free(b);
    return largest;
}

START_TEST(sides_of_a_crack_under_a_tool_move_as_each_does_alone)
{
    static const char *const laws[] = {"law: frictionless", "law: friction, friction: 0.3",
                                       "law: stick", "law: stick, adhesion: 0.1"};
    static const char *const halves[] = {"{from: [3, 3.2], to: [6, 8]}",
                                         "{from: [6, 3.2], to: [9, 8]}"};
    const double bound = crack_block_amplifies(_i) ? AMPLIFIED : ROUND_OFF;
    for (size_t law = 0; law < G_N_ELEMENTS(laws); law++) {
        struct test_run whole =
            open_half(_i, laws[law], "cracks=", "[{points: [[6, 1], [6, 10]], contact: none}]");
        struct crack_block_start start = crack_block_start(&whole);
        size_t found = 0;
        test_run_steps(&whole, STEPS);
        ck_assert_double_gt(test_run_contact_quantity(&whole, "contact_0_1_area"), 5.0); /* of 6 */
        for (int k = 0; k < 2; k++) {
            struct test_run half =
                open_half(_i, laws[law], "bodies.block.region.rectangle=", halves[k]);
            struct crack_block_start begin = crack_block_start(&half);
            test_run_steps(&half, STEPS);
            ck_assert_near(largest_apart(&whole, &start, &half, &begin, &found), 0.0, bound);
            crack_block_start_free(&begin);
            test_run_close(&half);
        }
        ck_assert_uint_eq(found, start.count + TOOL_PARTICLES); /* in both halves */
        crack_block_start_free(&start);
        test_run_close(&whole);
    }
}
END_TEST

/* ------------------------------------------------------- both at the same nodes */

/* The crack runs into the joint, where its sides and the other body meet at nodes. */
static const char *const meeting[] = {
    "[{points: [[6, 3], [6, 6.4]], contact: friction, friction: 0.3}]",
    "[{points: [[5, 4], [6.6, 6.4]], contact: stick}]",
    "[{points: [[4.4, 5.9], [7.4, 6.1]], contact: frictionless}]",
};
static const char *const laws[] = {"law: friction, friction: 0.2", "law: frictionless",
                                   "law: bonded", "law: stick",
                                   "law: interface, tension: 2, compression: 5, shear: 1"};
static const char *const normals[] = {"larger", "area", "average", "linear", "logistic"};
enum {
    MEETING = sizeof meeting / sizeof *meeting,
    LAWS = sizeof laws / sizeof *laws,
    NORMALS = sizeof normals / sizeof *normals,
    MEETINGS = MEETING * LAWS * NORMALS,
};

static struct settings describe_meeting(int index)
{
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", test_shapes[index % 3]);
    settings_add_formatted(&settings, "cracks=%s", meeting[index % MEETING]);
    settings_add_formatted(&settings, "contact={%s, normal: %s}", laws[index / MEETING % LAWS],
                           normals[index / MEETING / LAWS]);
    settings_add(&settings, "bodies.low.velocity=['0.1*sin(y)-0.05*x', '0.3+0.1*cos(x)']");
    settings_add(&settings, "bodies.high.velocity=['0.1*cos(y)', '-0.2+0.1*sin(x)']");
    return settings;
}

START_TEST(momentum_is_kept_where_a_crack_and_a_body_meet)
{
    struct settings settings = describe_meeting(_i);
    struct test_run run = test_run_open(JOINED, settings.texts, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(end.momentum[axis], start.momentum[axis],
                       STEPS * 64 * DBL_EPSILON * start.mass);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

START_TEST(fast_kernels_agree_where_a_crack_and_a_body_meet)
{
    struct settings settings = describe_meeting(_i);
    const struct kernel_side sides[2] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = KERNEL_PAIR_OTHER, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(JOINED, sides);
    kernel_pair_assert_alike(&pair, STEPS);
    kernel_pair_close(&pair);
    settings_clear(&settings);
}
END_TEST

static const char TURNED_ROUND[] = SCENE(BODY("high", "two", HIGH) BODY("low", "one", LOW));

/* Fields are numbered by the order of bodies, and so are pairs. */
START_TEST(the_order_of_bodies_changes_nothing_where_a_crack_and_a_body_meet)
{
    struct settings settings = describe_meeting(_i);
    settings_add(&settings, "contact.fields=bodies");
    struct test_run one = test_run_open(JOINED, settings.texts, 1);
    struct test_run other = test_run_open(TURNED_ROUND, settings.texts, 1);
    struct crack_block_start first = crack_block_start(&one), second = crack_block_start(&other);
    size_t found = 0;
    test_run_steps(&one, STEPS);
    test_run_steps(&other, STEPS);
    ck_assert_near(largest_apart(&one, &first, &other, &second, &found), 0.0, 1e-9);
    ck_assert_uint_eq(found, first.count);
    crack_block_start_free(&first);
    crack_block_start_free(&second);
    test_run_close(&one);
    test_run_close(&other);
    settings_clear(&settings);
}
END_TEST

/* The joint is flat: what a side of the crack lacks behind it is no surface of the body. */
START_TEST(a_crack_does_not_turn_the_normal_of_contact)
{
    const char *const settings[] = {_i == 0   ? "contact={law: frictionless, normal: area}"
                                    : _i == 1 ? "contact={law: frictionless, normal: linear}"
                                              : "contact={law: frictionless, normal: logistic}",
                                    "cracks=[{points: [[6, 3.5], [6, 6.4]], contact: none}]", NULL};
    struct test_run run = test_run_open(JOINED, settings, 1);
    size_t inside = 0;
    test_run_steps(&run, 1);
    for (size_t k = 0; k < mpm_simulation_contact_point_count(run.simulation); k++) {
        const struct mpm_contact_point point = mpm_simulation_contact_point(run.simulation, k);
        if (!(point.position[0] > 4.5 && point.position[0] < 7.5))
            continue; /* beside corners */
        inside++;
        ck_assert_near(point.normal[0], 0.0, ROUND_OFF);
        ck_assert_near(fabs(point.normal[1]), 1.0, ROUND_OFF);
    }
    ck_assert_uint_gt(inside, 3); /* three nodes, one with both sides of the crack */
    test_run_close(&run);
}
END_TEST

/* ----------------------------------------------------------------- bad input */

/* Settings of the joined blocks with bonded contact, and part of the message. */
static const char *const refused[][2] = {
    {"cracks=[{points: [[5, 5], [5, 7.5]]}]", "cracks.0.points: beside contact, cracks in bodies "
                                              "of two velocity fields, the second one at (5, 6."},
    {"cracks=[{points: [[5, 3], [6, 4]]}, {points: [[5, 8], [6, 8.4]]}]",
     "cracks.1.points: beside contact, cracks in bodies of two velocity fields"},
    {"cracks=[{points: [[5, 6.4], [7, 6.4]]}]",
     "cracks: beside contact, cracks along the surfaces of bodies alone"},
};
enum { REFUSED = sizeof refused / sizeof *refused };

static void assert_refused(const char *const *settings, const char *part)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.message = ""};
    char *const folder = test_folder_create();
    char *const path = test_folder_write(folder, "scene.yaml", JOINED);
    size_t count = 0;
    while (settings[count] != NULL)
        count++;
    enum mpm_status status = mpm_scene_read(path, settings, count, &scene, &error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, &(struct mpm_simulation_options){.threads = 1},
                                       &simulation, &error);
    ck_assert_int_eq(status, MPM_BAD_INPUT);
    test_contains(error.message, part);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    g_free(path);
    test_folder_remove(folder);
}

START_TEST(cracks_of_two_bodies_in_contact_are_refused)
{
    const char *const settings[] = {"contact={law: bonded}", refused[_i][0], NULL};
    assert_refused(settings, refused[_i][1]);
}
END_TEST

START_TEST(cracks_near_a_plane_of_symmetry_are_refused_beside_contact)
{
    const char *const settings[] = {
        "contact={law: bonded}", "cracks=[{points: [[5, 4], [7, 4.2]]}]",
        "boundary=[{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]", NULL};
    assert_refused(settings,
                   "cracks.points: beside contact between bodies, a crack on the plane of "
                   "symmetry at 3 or near it");
}
END_TEST

Suite *suite_cracked_bodies(void)
{
    Suite *suite = suite_create("cracked_bodies");
    TCase *identity = tcase_create("identity");
    tcase_add_loop_test(identity, bonded_materials_with_a_crack_in_one_are_one_cracked_material, 0,
                        TEST_COMBINATIONS);
    tcase_add_loop_test(identity, sides_of_a_crack_under_a_tool_move_as_each_does_alone, 0,
                        CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, identity);
    TCase *meetings = tcase_create("meetings");
    tcase_add_loop_test(meetings, momentum_is_kept_where_a_crack_and_a_body_meet, 0, MEETINGS);
    tcase_add_loop_test(meetings, fast_kernels_agree_where_a_crack_and_a_body_meet, 0, MEETINGS);
    tcase_add_loop_test(meetings, the_order_of_bodies_changes_nothing_where_a_crack_and_a_body_meet,
                        0, MEETINGS);
    tcase_add_loop_test(meetings, a_crack_does_not_turn_the_normal_of_contact, 0, 3);
    suite_add_tcase(suite, meetings);
    TCase *bad = tcase_create("bad input");
    tcase_add_loop_test(bad, cracks_of_two_bodies_in_contact_are_refused, 0, REFUSED);
    tcase_add_test(bad, cracks_near_a_plane_of_symmetry_are_refused_beside_contact);
    suite_add_tcase(suite, bad);
    return suite;
}
