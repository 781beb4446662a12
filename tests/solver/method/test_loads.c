/* Body forces that are the same everywhere, and the FLIP fraction: what is done for them at the
 * nodes against what the particles would do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/kernel_pair.h"
#include "support/scenes.h"
#include "support/soft_block.h"

enum { KERNEL_SETS = 2 };

static const char BLOCK[] = TEST_SOFT_BLOCK("") TEST_SWINGING_FLOOR;

/* One force twice: the second time so that it counts as one that varies, and acts at the
 * particles. */
static struct kernel_pair open_pair(int index)
{
    struct settings settings[2] = {test_combination_settings(index),
                                   test_combination_settings(index)};
    settings_add(&settings[0], "loads={body_force: ['0.03*cos(3*t)', -0.08]}");
    settings_add(&settings[1], test_combination(index).axisymmetric
                                   ? "loads={body_force: ['0*r+0.03*cos(3*t)', -0.08]}"
                                   : "loads={body_force: ['0*x+0.03*cos(3*t)', -0.08]}");
    const struct mpm_simulation_options options = {
        .threads = 1,
        .kernels = index < TEST_COMBINATIONS ? MPM_KERNELS_REFERENCE : MPM_KERNELS_FAST,
    };
    const struct kernel_side sides[2] = {{settings[0].texts, options},
                                         {settings[1].texts, options}};
    const struct kernel_pair pair = kernel_pair_open_text(BLOCK, sides);
    for (int k = 0; k < 2; k++)
        settings_clear(&settings[k]);
    return pair;
}

START_TEST(a_uniform_force_moves_and_works_alike_at_nodes_and_at_particles)
{
    struct kernel_pair pair = open_pair(_i);
    test_soft_block_assert_alike(&pair,
                                 test_combination(_i).amplifies_round_off ? 10 : KERNEL_PAIR_STEPS);
}
END_TEST

/* Enough particles for three workers. */
START_TEST(any_number_of_threads_gives_the_same_bits_under_a_uniform_force)
{
    const char *const settings[] = {
        TEST_BLOCK_FOR_THREADS,
        "bodies.block.velocity=['0.1*sin(y/5)', '0.1*cos(x/4)']",
        "method.transfer={kind: flip, fraction: 0.95}",
        "loads={body_force: ['0.03*cos(3*t)', -0.08]}",
        _i == 0 ? "method.stress_update=usl" : "method.stress_update=usavg",
        _i == 0 ? "method.shape=ugimp" : "method.shape=cpdi",
        NULL,
    };
    test_same_bits_over_threads(BLOCK, settings, 20, NULL);
}
END_TEST

Suite *suite_loads(void)
{
    Suite *suite = suite_create("loads");
    TCase *uniform = tcase_create("uniform");
    tcase_add_loop_test(uniform, a_uniform_force_moves_and_works_alike_at_nodes_and_at_particles, 0,
                        TEST_COMBINATIONS * KERNEL_SETS);
    tcase_add_loop_test(uniform, any_number_of_threads_gives_the_same_bits_under_a_uniform_force, 0,
                        2);
    suite_add_tcase(suite, uniform);
    return suite;
}
