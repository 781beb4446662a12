/* Every transfer, and the momentum form, beside cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STEPS = 10, SCENES = 3, SHAPES = 4, CONTACTS = 4 };

#define PLANAR_VELOCITY "['0.3*sin(2*y)+0.1*x', '0.4*cos(x)-0.2*y']"

/* A crack cuts the block in two along a line of nodes, or between two; in axisymmetry too. */
static const struct {
    const char *geometry, *velocity, *crack, *above, *below;
} scenes[SCENES] = {
    {"plane_strain", PLANAR_VELOCITY, "[[1, 5.6], [11, 5.6]]", "{from: [3, 5.6], to: [9, 8]}",
     "{from: [3, 3.2], to: [9, 5.6]}"},
    {"plane_strain", PLANAR_VELOCITY, "[[6, 1], [6, 10]]", "{from: [3, 3.2], to: [6, 8]}",
     "{from: [6, 3.2], to: [9, 8]}"},
    {"axisymmetric", "['0.3*sin(2*z)+0.1*r', '0.4*cos(r)-0.2*z']", "[[1, 5.2], [11, 5.2]]",
     "{from: [3, 5.2], to: [9, 8]}", "{from: [3, 3.2], to: [9, 5.2]}"},
};

static struct settings describe(int index, int exchange)
{
    struct settings settings = crack_block_method(index % CRACK_BLOCK_METHODS);
    crack_block_add_exchange(&settings, exchange);
    const int scene = index / CRACK_BLOCK_METHODS;
    settings_add_formatted(&settings, "geometry=%s", scenes[scene].geometry);
    settings_add_formatted(&settings, "bodies.block.velocity=%s", scenes[scene].velocity);
    settings_add(&settings, "time={end: 1000, step: 0.01}");
    return settings;
}

struct half {
    struct test_run run;
    struct crack_block_start start;
    double *place, *velocity;
    size_t count;
};

static struct half run_half(int index, int exchange, const char *key, const char *value)
{
    struct settings settings = describe(index, exchange);
    struct half half;
    settings_add_formatted(&settings, "%s%s", key, value);
    half.run = crack_block_open(&settings);
    half.start = crack_block_start(&half.run);
    test_run_steps(&half.run, STEPS);
    half.place = test_run_field(&half.run, MPM_FIELD_POSITION, &half.count);
    half.velocity = test_run_field(&half.run, MPM_FIELD_VELOCITY, NULL);
    return half;
}

static void close_half(struct half *half)
{
    crack_block_start_free(&half->start);
    free(half->place);
    free(half->velocity);
    test_run_close(&half->run);
}

/* Places are 10 and velocities 3: some thousand operations away from the start, each rounded at
 * 1e-16 of them. Nodes of little mass at the edges of classic functions amplify that. */
static const double ALONE_ROUND_OFF = 1e-12, AMPLIFIED = 1e-8;

/* Particles of the whole block that began where those of the half did, and how many. */
static size_t assert_alike(const struct half *whole, const struct half *half, double bound)
{
    size_t found = 0;
    for (size_t k = 0; k < whole->count; k++)
        for (size_t j = 0; j < half->count; j++) {
            const double *const one = whole->start.place + AXES * k;
            const double *const other = half->start.place + AXES * j;
            if (fabs(one[0] - other[0]) + fabs(one[1] - other[1]) > 1e-6)
                continue;
            found++;
            for (size_t axis = 0; axis < AXES; axis++) {
                ck_assert_near(whole->place[AXES * k + axis], half->place[AXES * j + axis], bound);
                ck_assert_near(whole->velocity[AXES * k + axis], half->velocity[AXES * j + axis],
                               bound);
            }
        }
    return found;
}

static void assert_sides_alone(int index, int exchange)
{
    const int scene = index / CRACK_BLOCK_METHODS;
    const double bound = crack_block_amplifies(index) ? AMPLIFIED : ALONE_ROUND_OFF;
    gchar *const crack = g_strdup_printf("[{points: %s, contact: none}]", scenes[scene].crack);
    static const char rectangle[] = "bodies.block.region.rectangle=";
    struct half whole = run_half(index, exchange, "cracks=", crack);
    struct half above = run_half(index, exchange, rectangle, scenes[scene].above);
    struct half below = run_half(index, exchange, rectangle, scenes[scene].below);
    ck_assert_uint_eq(assert_alike(&whole, &above, bound), above.count);
    ck_assert_uint_eq(assert_alike(&whole, &below, bound), below.count);
    ck_assert_uint_eq(above.count + below.count, whole.count);
    close_half(&whole);
    close_half(&above);
    close_half(&below);
    g_free(crack);
}

START_TEST(sides_of_a_crack_through_a_block_move_as_each_does_alone)
{
    for (int exchange = 0; exchange < CRACK_BLOCK_EXCHANGES; exchange++)
        assert_sides_alone(_i, exchange);
}
END_TEST

/* What two fields of a node exchange acts at one place. */
START_TEST(apic_keeps_momenta_beside_cracks_whatever_their_contact)
{
    static const char *const contacts[CONTACTS] = {"none", "frictionless",
                                                   "friction, friction: 0.3", "stick"};
    static const char *const shapes[SHAPES] = {"ugimp", "cpdi", "bspline2", "bspline3"};
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method={shape: %s, transfer: {kind: apic}}",
                           shapes[_i % SHAPES]);
    settings_add_formatted(&settings, "cracks=[{points: [[4, 4], [7.3, 7.1]], contact: %s}]",
                           contacts[_i / SHAPES]);
    settings_add(&settings, "bodies.block.velocity=['1-0.2*(y-5)+sin(y)', '0.2*x+cos(1.2*y)']");
    struct test_run run = crack_block_open(&settings);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, 40);
    const struct mpm_ledger end = test_run_ledger(&run);
    /* sums of m (x v_y - y v_x), each up to 14 m, of which the nodes round each */
    const double round_off = 40 * 14.0 * 64 * DBL_EPSILON * start.mass;
    ck_assert(fabs(start.angular_momentum) > 1e6 * round_off);
    ck_assert_near(end.angular_momentum, start.angular_momentum, round_off);
    for (int axis = 0; axis < AXES; axis++)
        ck_assert_near(end.momentum[axis], start.momentum[axis], round_off);
    test_run_close(&run);
}
END_TEST

Suite *suite_crack_transfers(void)
{
    Suite *suite = suite_create("crack_transfers");
    TCase *alone = tcase_create("alone");
    tcase_add_loop_test(alone, sides_of_a_crack_through_a_block_move_as_each_does_alone, 0,
                        SCENES * CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, alone);
    TCase *momenta = tcase_create("momenta");
    tcase_add_loop_test(momenta, apic_keeps_momenta_beside_cracks_whatever_their_contact, 0,
                        SHAPES * CONTACTS);
    suite_add_tcase(suite, momenta);
    return suite;
}
