/* Contact between bodies, over families, orders, geometries and surroundings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 2, STEPS = 40 };

#define MATERIAL(name) "{name: " name ", law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}"
#define BODY(name, material, region)                                                               \
    "  - {name: " name ", material: " material ", region: " region "}\n"
#define SCENE(bodies)                                                                              \
    TEST_BLOCK_SCENE("{end: 1000, step: 0.1}",                                                     \
                     MATERIAL("one") ", " MATERIAL("two") ", " MATERIAL("three"), bodies)

/* Two blocks on top of each other, and one beside both. */
static const char BLOCKS[] =
    SCENE(BODY("low", "one", "{rectangle: {from: [3, 3.2], to: [8, 5.6]}}")
              BODY("high", "two", "{rectangle: {from: [3, 5.6], to: [8, 8]}}")
                  BODY("side", "three", "{rectangle: {from: [8, 4], to: [10, 7.2]}}"));
/* The same as one material. */
static const char ONE[] =
    SCENE(BODY("low", "one", "{rectangle: {from: [3, 3.2], to: [8, 5.6]}}")
              BODY("high", "one", "{rectangle: {from: [3, 5.6], to: [8, 8]}}")
                  BODY("side", "one", "{rectangle: {from: [8, 4], to: [10, 7.2]}}"));

static void add_velocities(struct settings *settings, bool axisymmetric, double speed)
{
    static const char *const names[] = {"low", "high", "side"};
    static const double across[] = {1.0, -1.0, 0.3};
    for (size_t k = 0; k < G_N_ELEMENTS(names); k++)
        settings_add_formatted(settings, "bodies.%s.velocity=['%g*sin(%s)-%g', '%g*cos(%s)+%g']",
                               names[k], 0.5 * speed, axisymmetric ? "z" : "y",
                               k == 2 ? speed : 0.0, 0.5 * speed, axisymmetric ? "r" : "x",
                               speed * across[k]);
}

/* Some hundred operations a step on numbers of order 10. */
static const double ROUND_OFF = 1e-11, AMPLIFIED = 1e-5;

/* ----------------------------------------------------------------- identity */

static const char *const surroundings[] = {
    "output.energy_balance=true",
    "boundary=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, velocity: [free, '0.02*t']}]",
    "boundary=[{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: true}]",
    "method.transfer={kind: flip, fraction: 0.9}",
    "method.transfer={kind: apic}",
    "method.transfer={kind: xpic, order: 3}",
    "method.transfer={kind: fmpm, order: 3}",
    "loads.body_force=[0.01, -0.02]",
    "damping={grid: 0.1, particle: 0.05}",
};
enum { SURROUNDINGS = sizeof surroundings / sizeof *surroundings };

START_TEST(equal_materials_that_are_bonded_are_one_material)
{
    const struct test_combination combination = test_combination(_i);
    for (size_t k = (size_t)_i % 3; k < SURROUNDINGS; k += 3) {
        struct settings settings = test_combination_settings(_i);
        settings_add(&settings, surroundings[k]);
        add_velocities(&settings, combination.axisymmetric, 0.1);
        struct test_run one = test_run_open(ONE, settings.texts, 1);
        settings_add(&settings, "contact={law: bonded}");
        struct test_run bonded = test_run_open(BLOCKS, settings.texts, 1);
        const int steps = combination.amplifies_round_off ? 5 : STEPS / 2;
        test_run_steps(&one, steps);
        test_run_steps(&bonded, steps);
        const double bound = combination.amplifies_round_off ? AMPLIFIED : ROUND_OFF;
        ck_assert_near(test_run_largest_difference(&one, &bonded), 0.0, bound);
        settings_clear(&settings);
        test_run_close(&one);
        test_run_close(&bonded);
    }
}
END_TEST

/* ----------------------------------------------------------------- balances */

static const char *const laws[] = {
    "law: frictionless", "law: friction, friction: 0.3, static_friction: 0.5",
    "law: stick",        "law: stick, adhesion: 0.05",
    "law: bonded",       "law: interface, tension: 2, compression: 5, shear: 1",
};
static const char *const normals[] = {"volume", "area", "average", "larger", "linear", "logistic"};
static const char *const detections[] = {"extent", "volume", "shared"};
enum {
    LAWS = sizeof laws / sizeof *laws,
    NORMALS = sizeof normals / sizeof *normals,
    DETECTIONS = sizeof detections / sizeof *detections,
    CONTACTS = LAWS * NORMALS * DETECTIONS,
};

static void add_contact(struct settings *settings, int index)
{
    settings_add_formatted(settings, "contact={%s, normal: %s, detection: %s}", laws[index % LAWS],
                           normals[index / LAWS % NORMALS], detections[index / LAWS / NORMALS]);
}

/* Angular momentum is not what FLIP promises. */
START_TEST(contact_keeps_linear_momentum_and_apic_angular_momentum)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "method={shape: ugimp, transfer: {kind: apic}}");
    add_contact(&settings, _i);
    add_velocities(&settings, false, 0.2);
    struct test_run run = test_run_open(BLOCKS, settings.texts, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(end.momentum[axis], start.momentum[axis], ROUND_OFF);
    ck_assert_near(end.angular_momentum, start.angular_momentum, 10.0 * ROUND_OFF);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

/* contact_loss is what contact took from the nodes, less what pairs have stored or dissipated. */
START_TEST(what_contact_takes_from_the_nodes_is_stored_or_dissipated_by_pairs)
{
    struct settings settings = {.count = 0};
    add_contact(&settings, _i);
    settings_add(&settings, "output.energy_balance=true");
    settings_add(&settings, "boundary=[{region: {line: {from: [3, 0], to: [3, 12]}}, symmetry: "
                            "true}, {region: {line: {from: [0, 8], to: [14, 8]}}, velocity: "
                            "[free, '-0.05-0.01*t']}]");
    add_velocities(&settings, false, 0.2);
    struct test_run run = test_run_open(BLOCKS, settings.texts, 1);
    test_run_steps(&run, STEPS / 2);
    const struct mpm_ledger ledger = test_run_ledger(&run);
    ck_assert_near(ledger.contact_loss, 0.0, ROUND_OFF);
    ck_assert_double_gt(fabs(test_run_contact_quantity(&run, "contact_0_1_force_y")) +
                            fabs(test_run_contact_quantity(&run, "contact_0_2_force_x")) +
                            test_run_contact_quantity(&run, "contact_1_2_area"),
                        0.0);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

/* ------------------------------------------------------------------ symmetry */

/* The half of what is symmetric to x = 7: two blocks that press and slide on each other. */
static const char WHOLE[] =
    SCENE(BODY("low", "one", "{rectangle: {from: [3, 3.2], to: [11, 5.6]}}")
              BODY("high", "two", "{rectangle: {from: [4, 5.6], to: [10, 8]}}"));
static const char HALF[] =
    SCENE(BODY("low", "one", "{rectangle: {from: [7, 3.2], to: [11, 5.6]}}") BODY(
        "high", "two",
        "{rectangle: {from: [7, 5.6], to: [10, 8]}}")) "boundary: [{region: {line: {from: [7, "
                                                       "0], to: [7, 12]}}, symmetry: true}]\n";

/* Particles of the half in the whole: those at x > 7. */
static void assert_half(const struct test_run *whole, const struct test_run *half, double bound)
{
    size_t many, few, matched = 0;
    double *const a = test_run_field(whole, MPM_FIELD_POSITION, &many);
    double *const va = test_run_field(whole, MPM_FIELD_VELOCITY, NULL);
    double *const b = test_run_field(half, MPM_FIELD_POSITION, &few);
    double *const vb = test_run_field(half, MPM_FIELD_VELOCITY, NULL);
    for (size_t k = 0; k < few; k++)
        for (size_t j = 0; j < many; j++) {
            if (hypot(a[AXES * j] - b[AXES * k], a[AXES * j + 1] - b[AXES * k + 1]) > 0.01)
                continue;
            matched++;
            for (size_t axis = 0; axis < AXES; axis++) {
                ck_assert_near(b[AXES * k + axis], a[AXES * j + axis], bound);
                ck_assert_near(vb[AXES * k + axis], va[AXES * j + axis], bound);
            }
        }
    ck_assert_uint_eq(matched, few);
    free(a);
    free(va);
    free(b);
    free(vb);
}

/* Logistic regression magnifies round-off by up to 1 over its penalty, 1e-7. */
static const double MIRRORED = 1e-9, PENALIZED = 1e-7;
/* Where both bodies have the same area at a node, round-off decides which one is larger. */
static const double TIED = 1e-6;

START_TEST(a_half_with_a_plane_of_symmetry_is_half_of_the_whole)
{
    static const char *const shapes[] = {"ugimp", "cpdi", "bspline2", "classic"};
    const char *const normal = normals[_i / LAWS % NORMALS];
    const double bound = strcmp(normal, "logistic") == 0 ? PENALIZED
                         : strcmp(normal, "larger") == 0 ? TIED
                                                         : MIRRORED;
    for (size_t k = (size_t)_i % 2; k < G_N_ELEMENTS(shapes); k += 2) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "method.shape=%s", shapes[k]);
        add_contact(&settings, _i);
        settings_add(&settings, "bodies.high.velocity=['0.1*sin(0.5*(x-7))', '-0.15']");
        settings_add(&settings, "bodies.low.velocity=['-0.05*sin(0.7*(x-7))', '0.1']");
        struct test_run whole = test_run_open(WHOLE, settings.texts, 1);
        struct test_run half = test_run_open(HALF, settings.texts, 1);
        test_run_steps(&whole, STEPS / 2);
        test_run_steps(&half, STEPS / 2);
        assert_half(&whole, &half, bound);
        settings_clear(&settings);
        test_run_close(&whole);
        test_run_close(&half);
    }
}
END_TEST

/* ------------------------------------------------------------------ kernels */

START_TEST(fast_and_reference_kernels_agree_beside_contact)
{
    const struct test_combination combination = test_combination(_i);
    struct settings settings = test_combination_settings(_i);
    if (combination.amplifies_round_off) {
        settings_clear(&settings);
        return;
    }
    settings_add(&settings, "contact={law: friction, friction: 0.3, normal: logistic}");
    add_velocities(&settings, combination.axisymmetric, 0.1);
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct mpm_error error = {.message = ""};
        runs[k] = test_run_open(BLOCKS, settings.texts, 1);
        mpm_simulation_free(runs[k].simulation);
        ck_assert_msg(
            mpm_simulation_create(
                runs[k].scene,
                &(struct mpm_simulation_options){
                    .threads = 1, .kernels = k == 0 ? MPM_KERNELS_FAST : MPM_KERNELS_REFERENCE},
                &runs[k].simulation, &error) == MPM_OK,
            "%s", error.message);
        test_run_steps(&runs[k], STEPS / 2);
    }
    ck_assert_near(test_run_largest_difference(&runs[0], &runs[1]), 0.0, ROUND_OFF);
    settings_clear(&settings);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
}
END_TEST

static const char FOR_THREADS[] =
    SCENE(BODY("low", "one", "{rectangle: {from: [3, 3.2], to: [63, 27.2]}}")
              BODY("high", "two", "{rectangle: {from: [3, 27.2], to: [63, 51.2]}}"));

START_TEST(results_do_not_depend_on_threads_beside_contact)
{
    const char *const settings[] = {
        "grid.cells=[70, 70]",
        "contact={law: friction, friction: 0.2, normal: logistic}",
        "bodies.low.velocity=['0.1*sin(y)', '0.1*cos(x)']",
        "bodies.high.velocity=['0.2*cos(y)', '-0.2*sin(x)']",
        NULL,
    };
    test_same_bits_over_threads(FOR_THREADS, settings, 12, NULL);
}
END_TEST

/* ---------------------------------------------------------------------- gaps */

/* Two blocks half a cell apart, with one closing in: the first step with a force is that in which
 * the gap closes. */
START_TEST(blocks_that_are_half_a_cell_apart_do_not_feel_each_other)
{
    static const char apart[] =
        SCENE(BODY("low", "one", "{rectangle: {from: [3, 3.2], to: [8, 5.6]}}")
                  BODY("high", "two", "{rectangle: {from: [3, 6], to: [8, 8]}}"));
    static const char *const shapes[] = {"ugimp", "cpdi", "bspline2", "bspline3"};
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", shapes[_i]);
    settings_add(&settings, "contact={law: frictionless, normal: logistic}");
    settings_add(&settings, "bodies.high.velocity=[0, -0.1]");
    struct test_run run = test_run_open(apart, settings.texts, 1);
    /* 0.4 at 0.01 a step: the 41st is the first one that overlaps, but for round-off */
    test_run_steps(&run, 39);
    ck_assert_double_eq(test_run_contact_quantity(&run, "contact_0_1_force_y"), 0.0);
    test_run_steps(&run, 3);
    ck_assert_double_lt(test_run_contact_quantity(&run, "contact_0_1_force_y"), 0.0);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

/* ---------------------------------------------------------------- interfaces */

/* At the corners of three bodies interfaces gain energy, slowly: 1.3 times it in 350 steps. */
START_TEST(an_interface_of_any_stiffness_stays_bounded)
{
    static const double stiffness[] = {0.01, 1.0, 1e2, 1e5, 1e9, 1e12};
    double energy = 0.0;
    for (size_t k = 0; k < G_N_ELEMENTS(stiffness); k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "contact={law: interface, tension: %g, shear: %g}",
                               stiffness[k], stiffness[k]);
        add_velocities(&settings, false, 0.05);
        struct test_run run = test_run_open(BLOCKS, settings.texts, 1);
        const struct mpm_ledger start = test_run_ledger(&run);
        test_run_steps(&run, 8 * STEPS);
        const struct mpm_ledger end = test_run_ledger(&run);
        energy = fmax(energy, (end.kinetic_energy + end.strain_energy) / start.total_energy);
        ck_assert_double_ge(end.contact_stored, 0.0);
        if (stiffness[k] < 0.1 || stiffness[k] > 50.0)
            ck_assert_int_eq(test_run_contact_quantity(&run, "contact_0_1_stiff_nodes") > 0.0,
                             stiffness[k] > 50.0);
        settings_clear(&settings);
        test_run_close(&run);
    }
    ck_assert_double_le(energy, 2.0);
}
END_TEST

/* -------------------------------------------------------------- rigid bodies */

static const char ON_A_FLOOR[] = SCENE(
    BODY("block", "one",
         "{rectangle: {from: [3, 4], to: [8, 8]}}") "  - {name: floor, rigid: {velocity: ['0.05', "
                                                    "0]}, region: {rectangle: {from: [0, 2.4], "
                                                    "to: [14, 4]}}}\n") "loads: {body_force: [0, "
                                                                        "-0.01]}\n";

START_TEST(a_rigid_body_bears_the_force_that_it_gives)
{
    static const char *const pairs[] = {
        "law: frictionless",
        "law: friction, friction: 0.2",
        "law: stick",
        "law: bonded",
    };
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "contact={pairs: [{of: [block, floor], %s}]}", pairs[_i]);
    settings_add(&settings, "materials.0.name=block");
    settings_add(&settings, "bodies.block.material=block");
    settings_add(&settings, "output.energy_balance=true");
    struct test_run run = test_run_open(ON_A_FLOOR, settings.texts, 1);
    double impulse[AXES] = {0.0, 0.0}, before[AXES];
    for (int step = 0; step < STEPS; step++) {
        for (int axis = 0; axis < AXES; axis++)
            before[axis] = test_run_ledger(&run).momentum[axis];
        test_run_steps(&run, 1);
        const double force[AXES] = {test_run_contact_quantity(&run, "contact_0_1_force_x"),
                                    test_run_contact_quantity(&run, "contact_0_1_force_y")};
        const struct mpm_ledger ledger = test_run_ledger(&run);
        for (int axis = 0; axis < AXES; axis++) {
            const double weight = axis == 1 ? -0.01 * ledger.mass : 0.0;
            ck_assert_near(ledger.momentum[axis] - before[axis], 0.1 * (force[axis] + weight),
                           ROUND_OFF);
            impulse[axis] += 0.1 * force[axis];
        }
        ck_assert_near(ledger.contact_loss, 0.0, ROUND_OFF);
    }
    ck_assert_double_gt(impulse[1], 0.0);
    /* normals beside the corners of the block are not quite those of the floor */
    ck_assert(_i == 0 ? fabs(impulse[0]) < 1e-6 : fabs(impulse[0]) > 0.1);
    settings_clear(&settings);
    test_run_close(&run);
}
END_TEST

Suite *suite_body_contact(void)
{
    Suite *suite = suite_create("body_contact");
    TCase *identity = tcase_create("identity");
    tcase_set_timeout(identity, 60);
    tcase_add_loop_test(identity, equal_materials_that_are_bonded_are_one_material, 0,
                        TEST_COMBINATIONS);
    suite_add_tcase(suite, identity);
    TCase *balances = tcase_create("balances");
    tcase_add_loop_test(balances, contact_keeps_linear_momentum_and_apic_angular_momentum, 0,
                        CONTACTS);
    tcase_add_loop_test(
        balances, what_contact_takes_from_the_nodes_is_stored_or_dissipated_by_pairs, 0, CONTACTS);
    suite_add_tcase(suite, balances);
    TCase *symmetry = tcase_create("symmetry");
    tcase_add_loop_test(symmetry, a_half_with_a_plane_of_symmetry_is_half_of_the_whole, 0,
                        CONTACTS);
    suite_add_tcase(suite, symmetry);
    TCase *kernels = tcase_create("kernels");
    tcase_add_loop_test(kernels, fast_and_reference_kernels_agree_beside_contact, 0,
                        TEST_COMBINATIONS);
    tcase_add_test(kernels, results_do_not_depend_on_threads_beside_contact);
    suite_add_tcase(suite, kernels);
    TCase *contact = tcase_create("contact");
    tcase_add_loop_test(contact, blocks_that_are_half_a_cell_apart_do_not_feel_each_other, 0, 4);
    tcase_add_test(contact, an_interface_of_any_stiffness_stays_bounded);
    tcase_add_loop_test(contact, a_rigid_body_bears_the_force_that_it_gives, 0, 4);
    suite_add_tcase(suite, contact);
    return suite;
}
