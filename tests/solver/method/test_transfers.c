/* What each transfer and form promises: transfers x families x geometries, the orders of the
 * stress update in turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "support/transfer_block.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <stdlib.h>

static const char *const geometries[] = {"plane_strain", "axisymmetric"};
static const char *const transfers[] = {
    "{kind: flip}",
    "{kind: flip, fraction: 0.95}",
    "{kind: pic}",
    "{kind: xpic, order: 2}",
    "{kind: xpic, order: 5}",
    "{kind: fmpm, order: 2}",
    "{kind: fmpm, order: 3}",
    "{kind: apic}",
};
enum {
    GEOMETRIES = G_N_ELEMENTS(geometries),
    TRANSFERS = G_N_ELEMENTS(transfers),
    COMBINATIONS = TEST_SHAPES * GEOMETRIES * TRANSFERS,
    PIC = 2,
    APIC = TRANSFERS - 1,
};

struct combination {
    int shape, transfer;
    bool axisymmetric;
    struct settings settings;
};

static struct combination combination_of(int index)
{
    struct combination c = {
        .shape = index % TEST_SHAPES,
        .axisymmetric = index / TEST_SHAPES % GEOMETRIES == 1,
        .transfer = index / TEST_SHAPES / GEOMETRIES,
    };
    settings_add_formatted(&c.settings, "geometry=%s",
                           geometries[index / TEST_SHAPES % GEOMETRIES]);
    /* MUSL and USAVG, without it too; classic functions under USL amplify round-off */
    block_add_method(&c.settings, test_shapes[c.shape],
                     c.shape == MPM_CLASSIC
                         ? block_orders[1 + 2 * (index / TEST_SHAPES % 2)]
                         : block_orders[(index / TEST_SHAPES + index) % BLOCK_ORDERS],
                     transfers[c.transfer]);
    return c;
}

/* An affine part keeps the velocity of nodes that hardly have mass, of which classic functions
 * have many, and hands it to nodes of more: edges run away at once. */
static bool runs_away(const struct combination *c)
{
    return c->shape == MPM_CLASSIC && c->transfer == APIC;
}

/* All but FLIP and its fractions. */
static bool transfers_from_grid(int transfer)
{
    return transfer >= PIC;
}

/* ------------------------------------------------------------ every transfer */

START_TEST(a_rigid_translation_is_exact)
{
    enum { STEPS = 40 };
    static const double ROUND_OFF = STEPS * 256 * DBL_EPSILON;
    struct combination c = combination_of(_i);
    const double v[2] = {c.axisymmetric ? 0.0 : 0.7, -0.4};
    settings_add_formatted(&c.settings, "bodies.block.velocity=[%g, %g]", v[0], v[1]);
    struct test_run run = block_open(&c.settings, 1);
    size_t n;
    double *const start = test_run_field(&run, MPM_FIELD_POSITION, &n);
    test_run_steps(&run, runs_away(&c) ? 1 : STEPS);
    const double time = mpm_simulation_time(run.simulation);
    double *const x = test_run_field(&run, MPM_FIELD_POSITION, NULL);
    double *const velocity = test_run_field(&run, MPM_FIELD_VELOCITY, NULL);
    double *const f = test_run_field(&run, MPM_FIELD_DEFORMATION_GRADIENT, NULL);
    for (size_t k = 0; k < 2 * n; k++) {
        ck_assert_near(velocity[k], v[k % 2], 10.0 * ROUND_OFF);
        ck_assert_near(x[k], start[k] + v[k % 2] * time, 10.0 * ROUND_OFF);
    }
    for (size_t k = 0; k < 5 * n; k++)
        ck_assert_near(f[k], k % 5 == 1 || k % 5 == 2 ? 0.0 : 1.0, ROUND_OFF);
    free(start);
    free(x);
    free(velocity);
    free(f);
    test_run_close(&run);
}
END_TEST

START_TEST(linear_momentum_is_conserved_to_round_off)
{
    enum { STEPS = 40 };
    struct combination c = combination_of(_i);
    test_add_wild_velocity(&c.settings, c.axisymmetric);
    struct test_run run = block_open(&c.settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, runs_away(&c) ? 4 : STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    /* every step rounds sums of the particles' momenta, each up to 0.4 m */
    const double round_off = STEPS * 64 * DBL_EPSILON * start.mass;
    if (!c.axisymmetric) /* the hoop stress pushes along r */
        ck_assert_near(end.momentum[0], start.momentum[0], round_off);
    ck_assert_near(end.momentum[1], start.momentum[1], round_off);
    test_run_close(&run);
}
END_TEST

/* All nodes are held, at velocities that vary from node to node and grow: then all transfers that
 * take their velocity from the grid take the same, and FLIP takes as much as that grows. */
START_TEST(held_nodes_keep_their_velocity_in_every_order)
{
    enum { STEPS = 12 };
    static const double ROUND_OFF = STEPS * 64 * DBL_EPSILON;
    struct combination c = combination_of(_i),
                       pic = combination_of(_i % (TEST_SHAPES * GEOMETRIES));
    struct combination *const both[2] = {&c, &pic};
    struct test_run runs[2];
    for (int k = 0; k < 2; k++) {
        struct settings *const settings = &both[k]->settings;
        block_add_method(settings, test_shapes[c.shape], block_orders[_i % BLOCK_ORDERS],
                         k == 0 ? transfers[c.transfer] : "{kind: pic}");
        settings_add(settings,
                     "bodies.block.velocity=[0.3, 0.2]"); /* so that there is energy at hand */
        settings_add_formatted(
            settings, "boundary=[{region: all, velocity: ['0.3*sin(2*%s)*(1+t)', '-0.2*(1+t)']}]",
            c.axisymmetric ? "r" : "x");
        runs[k] = block_open(settings, 1);
        test_run_steps(&runs[k], STEPS);
    }
    const double apart = test_run_difference(&runs[0], &runs[1], MPM_FIELD_VELOCITY);
    if (transfers_from_grid(c.transfer))
        ck_assert_near(apart, 0.0, ROUND_OFF);
    else
        ck_assert(apart > 0.01);
    test_run_close(&runs[0]);
    test_run_close(&runs[1]);
}
END_TEST

/* ----------------------------------------------------------------- PIC, XPIC, FMPM */

START_TEST(order_one_of_xpic_and_fmpm_is_pic)
{
    static const char *const same[] = {"{kind: pic}", "{kind: xpic, order: 1}",
                                       "{kind: fmpm, order: 1}"};
    static const double ALMOST = 1e-9;
    struct test_run runs[3];
    struct settings settings = {.count = 0};
    for (int k = 0; k < 3; k++) {
        block_add_method(&settings, test_shapes[_i % TEST_SHAPES], block_orders[_i / TEST_SHAPES],
                         same[k]);
        test_add_wild_velocity(&settings, false);
        runs[k] = block_open(&settings, 1);
        test_run_steps(&runs[k], 20);
    }
    ck_assert(test_run_same_bits(&runs[0], &runs[1]));
    ck_assert(test_run_same_bits(&runs[0], &runs[2]));
    /* and the end of the scale of FLIP fractions: 20 steps of a share of 1e-9 */
    block_add_method(&settings, test_shapes[_i % TEST_SHAPES], block_orders[_i / TEST_SHAPES],
                     "{fraction: 1e-9}");
    test_add_wild_velocity(&settings, false);
    struct test_run flip = block_open(&settings, 1);
    test_run_steps(&flip, 20);
    ck_assert(test_run_difference(&runs[0], &flip, MPM_FIELD_VELOCITY) < 20 * ALMOST);
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
    test_run_close(&flip);
}
END_TEST

/* S S+ is symmetric in the product of the masses, with eigenvalues from 0 to 1: in the first
 * step, which has no forces, 1 - (1 - S S+)^m takes less from each of its modes the higher m. */
START_TEST(xpic_of_higher_order_loses_less_and_tends_to_flip)
{
    static const int higher[] = {1, 2, 3, 5, 10, 30, 100};
    struct settings settings = {.count = 0};
    block_add_method(&settings, test_shapes[_i % TEST_SHAPES], block_orders[_i / TEST_SHAPES],
                     "{kind: flip}");
    test_add_wild_velocity(&settings, false);
    struct test_run flip = block_open(&settings, 1);
    const double start = test_run_ledger(&flip).kinetic_energy;
    test_run_steps(&flip, 1);
    double energy = 0.0, away = HUGE_VAL;
    for (size_t k = 0; k < G_N_ELEMENTS(higher); k++) {
        char *const transfer = g_strdup_printf("{kind: xpic, order: %d}", higher[k]);
        block_add_method(&settings, test_shapes[_i % TEST_SHAPES], block_orders[_i / TEST_SHAPES],
                         transfer);
        test_add_wild_velocity(&settings, false);
        struct test_run run = block_open(&settings, 1);
        test_run_steps(&run, 1);
        const double kinetic = test_run_ledger(&run).kinetic_energy;
        const double distance = test_run_difference(&run, &flip, MPM_FIELD_VELOCITY);
        ck_assert(kinetic > energy && kinetic < start);
        ck_assert(distance < away);
        energy = kinetic;
        away = distance;
        g_free(transfer);
        test_run_close(&run);
    }
    test_run_close(&flip);
}
END_TEST

/* PIC filters what FLIP keeps: whatever the motion, energy goes. */
START_TEST(pic_loses_energy_in_every_step)
{
    enum { STEPS = 30 };
    struct settings settings = {.count = 0};
    block_add_method(&settings, test_shapes[_i], "stress_update: usavg", "{kind: pic}");
    test_add_wild_velocity(&settings, false);
    struct test_run run = block_open(&settings, 1);
    double before = test_run_ledger(&run).total_energy;
    for (int k = 0; k < STEPS; k++) {
        test_run_steps(&run, 1);
        const double total = test_run_ledger(&run).total_energy;
        ck_assert(total < before);
        before = total;
    }
    test_run_close(&run);
}
END_TEST

/* -------------------------------------------------------------------- APIC */

/* Strains of some per cent, across cells: forces within keep it as the transfers do. */
START_TEST(apic_keeps_angular_momentum_to_round_off)
{
    enum { STEPS = 80 };
    struct settings settings = {.count = 0};
    block_add_method(&settings, test_shapes[1 + _i % (TEST_SHAPES - 1)],
                     block_orders[_i / (TEST_SHAPES - 1)], "{kind: apic}");
    settings_add(&settings, "bodies.block.velocity=['1-0.2*(y-5)+sin(y)', '0.2*x+cos(1.2*y)']");
    struct test_run run = block_open(&settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    test_run_steps(&run, STEPS);
    const struct mpm_ledger end = test_run_ledger(&run);
    /* sums of m (x v_y - y v_x), each up to 14 m, of which the nodes round each */
    const double round_off = STEPS * 14.0 * 64 * DBL_EPSILON * start.mass;
    ck_assert(fabs(start.angular_momentum) > 1e6 * round_off);
    ck_assert_near(end.angular_momentum, start.angular_momentum, round_off);
    ck_assert(end.strain_energy > 1e-4 * start.kinetic_energy);
    test_run_close(&run);
}
END_TEST

/* In place, a spin goes to the grid and back with all it has, in every family: particles get
 * the velocity and the spin of the nodes. */
START_TEST(apic_takes_back_the_spin_that_it_gave)
{
    static const double SPIN = 1e-9, PATH = 1e-9; /* cells travelled: what D_p changes by */
    struct settings settings = {.count = 0};
    block_add_method(&settings, test_shapes[_i], "stress_update: usl", "{kind: apic}");
    settings_add_formatted(&settings, "bodies.block.velocity=['-%g*(y-5.6)', '%g*(x-5.75)']", SPIN,
                           SPIN);
    struct test_run run = block_open(&settings, 1);
    const double start = test_run_ledger(&run).angular_momentum;
    test_run_steps(&run, 3);
    ck_assert_near(test_run_ledger(&run).angular_momentum, start, PATH * start);
    test_run_close(&run);
}
END_TEST

Suite *suite_transfers(void)
{
    Suite *const suite = suite_create("transfers");
    TCase *const all = tcase_create("every transfer");
    tcase_add_loop_test(all, a_rigid_translation_is_exact, 0, COMBINATIONS);
    tcase_add_loop_test(all, linear_momentum_is_conserved_to_round_off, 0, COMBINATIONS);
    tcase_add_loop_test(all, held_nodes_keep_their_velocity_in_every_order, 0, COMBINATIONS);
    suite_add_tcase(suite, all);
    TCase *const filters = tcase_create("filters");
    tcase_add_loop_test(filters, order_one_of_xpic_and_fmpm_is_pic, 0, TEST_SHAPES * BLOCK_ORDERS);
    tcase_add_loop_test(filters, xpic_of_higher_order_loses_less_and_tends_to_flip, 0,
                        TEST_SHAPES * 2); /* orders without a stress update at the start */
    tcase_add_loop_test(filters, pic_loses_energy_in_every_step, 0, TEST_SHAPES);
    suite_add_tcase(suite, filters);
    TCase *const affine = tcase_create("affine");
    tcase_add_loop_test(affine, apic_keeps_angular_momentum_to_round_off, 0,
                        (TEST_SHAPES - 1) * BLOCK_ORDERS);
    tcase_add_loop_test(affine, apic_takes_back_the_spin_that_it_gave, 0, TEST_SHAPES);
    suite_add_tcase(suite, affine);
    return suite;
}
