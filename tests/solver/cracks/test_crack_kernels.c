/* Fast kernels against the reference ones beside cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include <glib.h>

enum { AXES = 2 };

/* What particles with several fields meet in a step: contact, nodes that they do not see, edges. */
static const char *const BESIDE[] = {
    "cracks=[{points: [[2, 5.6], [10, 5.6]], contact: none}]",
    "cracks=[{points: [[2, 5.6], [6, 5.7], [10, 5.6]], contact: friction, friction: 0.3}]",
    "cracks=[{points: [[4, 4], [7.3, 7.1]], contact: stick}]",
    "cracks=[{points: [[4, 4], [7.3, 7.1]], contact: none}] method.cracks=visibility",
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
    const size_t general = mpm_simulation_general_particles(pair.simulation[1]);
    ck_assert_uint_eq(mpm_simulation_general_particles(pair.simulation[0]), 0);
    ck_assert(general > 0 && general < mpm_simulation_particle_count(pair.simulation[1]));
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
    const bool hidden = _i / CRACK_BLOCK_METHODS == 1;
    for (int k = 0; k < CRACK_BLOCK_EXCHANGES; k++) {
        struct settings settings = crack_block_method(_i % CRACK_BLOCK_METHODS);
        if (crack_block_add_exchange(&settings, k) >= CRACK_BLOCK_APIC) {
            settings_clear(&settings); /* APIC and the momentum form have reference kernels only */
            continue;
        }
        settings_add_formatted(&settings, "method.cracks=%s", hidden ? "visibility" : "fields");
        settings_add(&settings, "cracks=[{points: [[4, 4.1], [7.3, 7]], contact: none}]");
        settings_add(&settings, "bodies.block.velocity=['0.2*(x-6)', '-0.3*(y-6)']");
        const struct kernel_side sides[2] = {
            {settings.texts, {.kernels = MPM_KERNELS_REFERENCE, .threads = 1}},
            {settings.texts, {.kernels = MPM_KERNELS_FAST, .threads = 1}},
        };
        struct kernel_pair pair = kernel_pair_open_text(CRACK_BLOCK, sides);
        kernel_pair_assert_alike(&pair, 10);
        assert_same_cracks(&pair);
        ck_assert_uint_gt(mpm_simulation_general_particles(pair.simulation[1]), 0);
        kernel_pair_close(&pair);
        settings_clear(&settings);
    }
}
END_TEST

Suite *suite_crack_kernels(void)
{
    Suite *suite = suite_create("crack_kernels");
    TCase *kernels = tcase_create("kernels");
    tcase_add_loop_test(kernels, fast_and_reference_kernels_agree_beside_cracks, 0,
                        G_N_ELEMENTS(BESIDE) * CRACK_BLOCK_METHODS);
    tcase_add_loop_test(kernels, fast_and_reference_kernels_agree_beside_cracks_for_every_transfer,
                        0, 2 * CRACK_BLOCK_METHODS);
    suite_add_tcase(suite, kernels);
    return suite;
}
