/* Fast kernels against the reference ones beside cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include "method/transfer/nearby.h"

#include <glib.h>

enum { AXES = 2 };

/* What particles with several fields meet in a step: contact, ends of cracks, edges. */
static const char *const BESIDE[] = {
    "cracks=[{points: [[2, 5.6], [10, 5.6]], contact: none}]",
    "cracks=[{points: [[2, 5.6], [6, 5.7], [10, 5.6]], contact: friction, friction: 0.3}]",
    "cracks=[{points: [[4, 4], [7.3, 7.1]], contact: stick}]",
    ("cracks=[{points: [[2, 5.6], [6, 5.7]], contact: none}] "
     "loads.tractions=[{body: block, edge: all, frame: edge, value: [-0.1, 0]}]"),
};

START_TEST(fast_and_reference_kernels_agree_beside_cracks)
{
    struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
    gchar **const words = g_strsplit(BESIDE[_i / CRACK_BLOCK_METHODS], "] ", 2);
    for (int k = 0; words[k] != NULL; k++)
        settings_add_formatted(&settings, "%s%s", words[k], k == 0 && words[1] != NULL ? "]" : "");
    settings_add(&settings, "bodies.block.velocity=['0.1*sin(y)', '0.1*cos(x)']");
    const struct kernel_side sides[2] = {
        {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
        {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
    };
    struct kernel_pair pair = kernel_pair_open_text(CRACK_BLOCK, sides);
    kernel_pair_assert_alike(&pair, 10);
    const size_t beside = mpm_simulation_field_particles(pair.simulation[1]);
    ck_assert_uint_eq(mpm_simulation_field_particles(pair.simulation[0]), beside);
    ck_assert(beside > 0 && beside < mpm_simulation_particle_count(pair.simulation[1]));
    kernel_pair_close(&pair);
    g_strfreev(words);
    settings_clear(&settings);
}
END_TEST

/* For a fraction below 1 the fast kernels change the nodes' velocities before particles read them:
 * cracks must not move with those. */
static void assert_same_cracks(const struct kernel_pair *pair)
{
    const size_t count = mpm_simulation_crack_point_count(pair->simulation[0]);
    ck_assert_uint_eq(mpm_simulation_crack_point_count(pair->simulation[1]), count);
    for (size_t k = 0; k < count; k++)
        for (int axis = 0; axis < AXES; axis++)
            ck_assert_near(mpm_simulation_crack_point(pair->simulation[1], k).position[axis],
                           mpm_simulation_crack_point(pair->simulation[0], k).position[axis],
                           10.0 * KERNEL_PAIR_BOUND);
}

START_TEST(fast_and_reference_kernels_agree_beside_cracks_for_every_transfer)
{
    for (int k = 0; k < CRACK_BLOCK_EXCHANGES; k++) {
        struct settings settings = crack_block_method(_i);
        /* classic functions and CPDI: with APIC the former amplify round-off, the latter have
         * reference kernels only, and so has the momentum form */
        const int exchange = crack_block_add_exchange(&settings, k);
        if (exchange == CRACK_BLOCK_FORM || (exchange == CRACK_BLOCK_APIC && _i % 2 == 0)) {
            settings_clear(&settings);
            continue;
        }
        settings_add(&settings, "cracks=[{points: [[4, 4.1], [7.3, 7]], contact: none}]");
        settings_add(&settings, "bodies.block.velocity=['0.2*(x-6)', '-0.3*(y-6)']");
        const struct kernel_side sides[2] = {
            {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
            {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
        };
        struct kernel_pair pair = kernel_pair_open_text(CRACK_BLOCK, sides);
        kernel_pair_assert_alike(&pair, 10);
        assert_same_cracks(&pair);
        ck_assert_uint_gt(mpm_simulation_field_particles(pair.simulation[1]), 0);
        kernel_pair_close(&pair);
        settings_clear(&settings);
    }
}
END_TEST

/* A second body flies along the part of a crack that is out of the first one. Particles far from
 * cracks are not looked at for some steps: with all of them looked at in each step nothing changes.
 */
START_TEST(particles_that_come_near_a_crack_between_two_sorts_are_found)
{
    enum { FLIGHT = 24 };
    struct settings settings = crack_block_method(_i);
    settings_add(&settings, "grid.cells=[44, 15]");
    settings_add(&settings, "time={end: 1000, step: 0.02}");
    settings_add(&settings,
                 "bodies=[{name: block, material: rubber, particles_per_cell: [2, 2], "
                 "region: {rectangle: {from: [3, 3.2], to: [9, 8]}}}, "
                 "{name: flyer, material: rubber, particles_per_cell: [2, 2], "
                 "region: {rectangle: {from: [21, 4], to: [37, 7.2]}}, velocity: [-24, 0]}]");
    settings_add(&settings, "cracks=[{points: [[5, 5.7], [18, 5.7]], contact: none}]");
    struct test_run one = test_run_open(CRACK_BLOCK, settings.texts, 1);
    struct test_run other = crack_block_open(&settings);
    test_run_steps(&one, 1);
    test_run_steps(&other, 1);
    const size_t before = mpm_simulation_field_particles(one.simulation);
    test_run_steps(&one, FLIGHT);
    for (int step = 0; step < FLIGHT; step++) {
        mpm_nearby_forget(&other.simulation->state);
        test_run_steps(&other, 1);
    }
    ck_assert_uint_gt(mpm_simulation_field_particles(one.simulation), before);
    ck_assert_uint_eq(mpm_simulation_field_particles(one.simulation),
                      mpm_simulation_field_particles(other.simulation));
    ck_assert(test_run_same_bits(&one, &other));
    test_run_close(&one);
    test_run_close(&other);
}
END_TEST

Suite *suite_crack_kernels(void)
{
    Suite *suite = suite_create("crack_kernels");
    TCase *kernels = tcase_create("kernels");
    tcase_add_loop_test(kernels, fast_and_reference_kernels_agree_beside_cracks, 0,
                        G_N_ELEMENTS(BESIDE) * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(kernels, fast_and_reference_kernels_agree_beside_cracks_for_every_transfer,
                        0, CRACK_BLOCK_METHODS);
    tcase_add_loop_test(kernels, particles_that_come_near_a_crack_between_two_sorts_are_found, 0,
                        CRACK_BLOCK_FAMILIES);
    suite_add_tcase(suite, kernels);
    return suite;
}
